#include "report/report_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace ravnoves {

ReportDialog::ReportDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Report"));
    auto* column = new QVBoxLayout(this);
    auto* answer = new QLabel(
        tr("The first page has the answer: verdict, picture, leading results, variants."), this);
    answer->setWordWrap(true);
    column->addWidget(answer);
    const ReportChoice kept = ReportChoice::kept();
    inputs_ = add("report_inputs", tr("&Inputs"), tr("All inputs with their units."), kept.inputs);
    plots_ = add("report_plots", tr("&Plots and tables"),
                 tr("The plots and tables of each tab of the page."), kept.plots);
    formulas_ = add("report_formulas", tr("&Formulas and what the model leaves out"),
                    tr("Each formula with its source."), kept.formulas);
    validation_ =
        add("report_validation", tr("&Validation of the paper"),
            tr("Every printed number of the paper, compared with this program."), kept.validation);
    auto* row = new QFormLayout;
    paper_ = new QComboBox(this);
    paper_->setObjectName(QStringLiteral("report_paper"));
    paper_->addItems({tr("A4"), tr("Letter")});
    paper_->setCurrentIndex(kept.paper == QPageSize::Letter ? 1 : 0);
    paper_->setToolTip(tr("Paper of a PDF file."));
    row->addRow(tr("P&aper"), paper_);
    column->addLayout(row);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("&Save as…"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
}

QCheckBox* ReportDialog::add(const char* name, const QString& text, const QString& hint,
                             bool isOn) {
    auto* box = new QCheckBox(text, this);
    box->setObjectName(QLatin1String(name));
    box->setToolTip(hint);
    box->setChecked(isOn);
    layout()->addWidget(box);
    return box;
}

ReportChoice ReportDialog::choice() const {
    return {inputs_->isChecked(), plots_->isChecked(), formulas_->isChecked(),
            validation_->isChecked(),
            paper_->currentIndex() == 1 ? QPageSize::Letter : QPageSize::A4};
}

}  // namespace ravnoves
