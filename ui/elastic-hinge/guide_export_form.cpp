#include "elastic-hinge/guide_export_form.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"

namespace ravnoves {

using elastic_hinge::Branch;
using elastic_hinge::BranchSummary;
using elastic_hinge::Guide;
using elastic_hinge::GuideDrawing;
using elastic_hinge::Hinge;
namespace field = elastic_hinge::field;

namespace {

constexpr FieldSpec stepField{"step_deg", "°", Range::between(0.01, 90)};

}  // namespace

GuideExportForm::GuideExportForm(ElasticHingeModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column->setSpacing(Theme::space);
    auto* section = new FormSection(tr("Guide for the machine shop"), this);
    hinge_ = new QComboBox(this);
    hinge_->setObjectName(QStringLiteral("export_hinge"));
    hinge_->addItems({tr("crank, for M"), tr("crank, for M₁"), tr("rod, for M₁₂")});
    section->addWidget(tr("&Hinge"), hinge_, {}, tr("Which hinge's guide is written"));
    branch_ = new QComboBox(this);
    branch_->setObjectName(QStringLiteral("export_branch"));
    branch_->addItems({tr("compressed"), tr("stretched")});
    section->addWidget(tr("S&pring"), branch_, {},
                       tr("The side of its free length on which the spring works"));
    turns_ = new QComboBox(this);
    turns_->setObjectName(QStringLiteral("export_turns"));
    turns_->addItems({tr("guide turns"), tr("spring turns")});
    section->addWidget(tr("&What turns"), turns_, {},
                       tr("In the paper the guide turns with the crank and the spring stands "
                          "still: the roller then runs backwards in the guide's own axes, and the "
                          "drawing is the mirror image of the plot"));
    tolerance_ = section->addNumber(tr("Chord to&lerance"), field::chord_tolerance,
                                    tr("DXF: the polyline leaves the curve by no more than that"));
    step_ =
        section->addNumber(tr("S&tep of the table"), stepField, tr("CSV: step of the crank angle"));
    column->addWidget(section);
    dxf_ = new QPushButton(themedIcon(QStringLiteral("export")), tr("Write D&XF…"), this);
    dxf_->setObjectName(QStringLiteral("export_dxf"));
    dxf_->setToolTip(tr("Closed polylines in mm, 1:1: layers PROFILE, ROLLER_PATH, AXIS, NOTE"));
    csv_ = new QPushButton(themedIcon(QStringLiteral("export")), tr("Write &CSV…"), this);
    csv_->setObjectName(QStringLiteral("export_csv"));
    csv_->setToolTip(tr("Crank angle, polar angle, radius, x and y of path and profile; °, mm"));
    column->addWidget(dxf_);
    column->addWidget(csv_);
    note_ = captionLabel({}, this);
    column->addWidget(note_);
    column->addStretch();

    connect(hinge_, &QComboBox::activated, this, [this] {
        branchChosen_ = false;
        show();
    });
    connect(branch_, &QComboBox::activated, this, [this] {
        branchChosen_ = true;
        show();
    });
    connect(tolerance_, &NumberField::valueEdited, this,
            [this](std::optional<double> value) { toleranceMm_ = *value; });
    connect(step_, &NumberField::valueEdited, this,
            [this](std::optional<double> value) { stepDeg_ = *value; });
    connect(dxf_, &QPushButton::clicked, this,
            [this] { ask(tr("DXF drawing (*.dxf)"), QStringLiteral(".dxf")); });
    connect(csv_, &QPushButton::clicked, this,
            [this] { ask(tr("CSV table (*.csv)"), QStringLiteral(".csv")); });
    connect(model_, &SceneModel::changed, this, &GuideExportForm::show);
    show();
}

Hinge GuideExportForm::hinge() const {
    return static_cast<Hinge>(hinge_->currentIndex());
}

void GuideExportForm::show() {
    const Guide& guide = model_->guideOf(hinge());
    if (!branchChosen_) {
        branch_->setCurrentIndex(guide.branch == Branch::compressed ? 0 : 1);
    }
    tolerance_->setValue(toleranceMm_);
    step_->setValue(stepDeg_);
    const BranchSummary& branch = branch_->currentIndex() == 0 ? guide.compressed : guide.stretched;
    const bool possible = branch.exists && !branch.undercut;
    dxf_->setEnabled(possible);
    csv_->setEnabled(possible);
    if (!branch.exists) {
        note_->setText(tr("This guide does not exist; see the answer on the right."));
    } else if (branch.undercut) {
        note_->setText(tr("The roller undercuts this guide."));
    } else {
        note_->setText(
            tr("The profile is offset from the path of the roller's centre by the "
               "roller's radius."));
    }
}

QString GuideExportForm::exportTo(const QString& path) {
    GuideDrawing drawing;
    drawing.branch = branch_->currentIndex() == 0 ? Branch::compressed : Branch::stretched;
    drawing.guide_turns = turns_->currentIndex() == 0;
    drawing.chord_tolerance = toleranceMm_ * field::chord_tolerance.to_si;
    return model_->exportGuide(path, hinge(), drawing, stepDeg_);
}

void GuideExportForm::ask(const QString& filter, const QString& ending) {
    QString path = QFileDialog::getSaveFileName(this, tr("Export guide"), QString(), filter);
    if (path.isEmpty()) {
        return;
    }
    if (!path.endsWith(ending, Qt::CaseInsensitive)) {
        path += ending;
    }
    const QString trouble = exportTo(path);
    if (trouble.isEmpty()) {
        Q_EMIT status(tr("%1 written").arg(path));
    } else {
        QMessageBox::warning(this, tr("Export guide"), trouble);
    }
}

}  // namespace ravnoves
