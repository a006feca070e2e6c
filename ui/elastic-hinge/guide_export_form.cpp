#include "elastic-hinge/guide_export_form.h"

#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "elastic-hinge/fields.h"
#include "page/rejected_entries.h"
#include "pictures/file_dialogs.h"
#include "theme/icons.h"
#include "theme/theme.h"

namespace ravnoves {

using elastic_hinge::Branch;
using elastic_hinge::BranchSummary;
using elastic_hinge::Guide;
using elastic_hinge::Hinge;
namespace field = elastic_hinge::field;

GuideExportForm::GuideExportForm(ElasticHingeModel* model, QWidget* parent)
    : Form(model, parent), model_(model) {
    ElasticHingeModel::GuideExport& chosen = model->guideExport();
    column()->setSpacing(Theme::space);
    section(tr("Guide for the machine shop"));
    choice(
        QStringLiteral("export_hinge"), tr("&Hinge"),
        {tr("crank, for M"), tr("crank, for M₁"), tr("rod, for M₁₂")},
        tr("Hinge whose guide is written"), [&chosen] { return static_cast<int>(chosen.hinge); },
        [this, &chosen](int index) {
            chosen.hinge = static_cast<Hinge>(index);
            chosen.branch.reset();
            showAll();
        });
    choice(
        QStringLiteral("export_branch"), tr("S&pring"), {tr("compressed"), tr("stretched")},
        tr("Spring compressed or stretched"),
        [this] { return model_->exportedBranch() == Branch::compressed ? 0 : 1; },
        [this, &chosen](int index) {
            chosen.branch = index == 0 ? Branch::compressed : Branch::stretched;
            showGuide();
        });
    choice(
        QStringLiteral("export_turns"), tr("&What turns"), {tr("guide turns"), tr("spring turns")},
        tr("In the paper the guide turns with the crank and the spring is fixed: "
           "the drawing is the mirror image of the plot"),
        [&chosen] { return chosen.drawing.guide_turns ? 0 : 1; },
        [&chosen](int index) { chosen.drawing.guide_turns = index == 0; });
    number(
        field::chord_tolerance, [&chosen] { return chosen.drawing.chord_tolerance; },
        [&chosen](std::optional<double> value) { chosen.drawing.chord_tolerance = *value; });
    number(
        field::table_step, [&chosen] { return chosen.stepDeg * degree; },
        [&chosen](std::optional<double> value) {
            chosen.stepDeg = from_si(field::table_step, *value);
        });
    const auto button = [&](const char* name, const QString& label, const QString& hint,
                            const QString& suffix) {
        auto* write = new QPushButton(themedIcon(QStringLiteral("export")), label, this);
        write->setObjectName(QLatin1String(name));
        write->setToolTip(hint);
        column()->addWidget(write);
        connect(write, &QPushButton::clicked, this, [=, this] { ask(suffix); });
        return write;
    };
    dxf_ = button("export_dxf", tr("Write D&XF…"),
                  tr("Closed polylines in mm, 1:1: layers PROFILE, ROLLER_PATH, AXIS, NOTE"),
                  QStringLiteral("dxf"));
    csv_ = button("export_csv", tr("Write &CSV…"),
                  tr("Crank angle, polar angle, radius, x and y of path and profile; °, mm"),
                  QStringLiteral("csv"));
    note_ = captionLabel({}, this);
    column()->addWidget(note_);
    column()->addStretch();

    follow([this] { showGuide(); });
}

void GuideExportForm::showGuide() {
    const Guide& guide = model_->guideOf(model_->guideExport().hinge);
    const BranchSummary& branch =
        model_->exportedBranch() == Branch::compressed ? guide.compressed : guide.stretched;
    const bool possible = branch.exists && !branch.undercut;
    dxf_->setEnabled(possible);
    csv_->setEnabled(possible);
    note_->setText(!branch.exists    ? tr("This guide is not feasible; see the verdict.")
                   : branch.undercut ? tr("The roller undercuts this guide.")
                                     : tr("The profile is offset from the path of the roller's "
                                          "centre by the roller's radius."));
}

void GuideExportForm::ask(const QString& suffix) {
    if (!continueWithoutRejected(this, tr("Export guide"))) {
        return;
    }
    QList<FileFormat> formats{dxfFormat(), csvFormat()};
    if (formats.back().suffix == suffix) {
        std::swap(formats.front(), formats.back());
    }
    const QString path =
        saveFile(this, tr("Export guide"), QStringLiteral("guide.") + suffix, formats,
                 std::bind_front(&ElasticHingeModel::exportGuide, model_));
    if (!path.isEmpty()) {
        Q_EMIT status(tr("%1 written").arg(path));
    }
}

}  // namespace ravnoves
