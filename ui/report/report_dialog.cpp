#include "report/report_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "text/usual_paper.h"

namespace ravnoves {

namespace {

const QString inputsKey = QStringLiteral("report/inputs");
const QString plotsKey = QStringLiteral("report/plots");
const QString formulasKey = QStringLiteral("report/formulas");
const QString letterKey = QStringLiteral("report/letter");

}  // namespace

ReportChoice::ReportChoice() {
    const QSettings kept;
    inputs = kept.value(inputsKey, true).toBool();
    plots = kept.value(plotsKey, true).toBool();
    formulas = kept.value(formulasKey, true).toBool();
    const bool usesLetter = usualPaper() == QPageSize::Letter;
    paper = kept.value(letterKey, usesLetter).toBool() ? QPageSize::Letter : QPageSize::A4;
}

ReportDialog::ReportDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Report"));
    auto* column = new QVBoxLayout(this);
    auto* answer = new QLabel(
        tr("The first page has the answer: verdict, picture, leading results, variants."), this);
    answer->setWordWrap(true);
    column->addWidget(answer);
    const ReportChoice last;
    const auto add = [&](const QString& key, const QString& text, const QString& hint, bool isOn) {
        auto* box = new QCheckBox(text, this);
        box->setObjectName(QString(key).replace(u'/', u'_'));
        box->setToolTip(hint);
        box->setChecked(isOn);
        column->addWidget(box);
        connect(this, &QDialog::accepted, box,
                [box, key] { QSettings().setValue(key, box->isChecked()); });
    };
    add(inputsKey, tr("&Inputs"), tr("All inputs with their units."), last.inputs);
    add(plotsKey, tr("&Plots and tables"), tr("The plots and tables of each tab of the page."),
        last.plots);
    add(formulasKey, tr("&Formulas and what the model leaves out"),
        tr("Each formula with its source."), last.formulas);
    auto* row = new QFormLayout;
    auto* paper = new QComboBox(this);
    paper->setObjectName(QStringLiteral("report_paper"));
    paper->addItems({tr("A4"), tr("Letter")});
    paper->setCurrentIndex(last.paper == QPageSize::Letter ? 1 : 0);
    paper->setToolTip(tr("Paper of a PDF file."));
    connect(this, &QDialog::accepted, paper,
            [paper] { QSettings().setValue(letterKey, paper->currentIndex() == 1); });
    row->addRow(tr("P&aper"), paper);
    column->addLayout(row);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("&Save as…"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
}

}  // namespace ravnoves
