#include "v8-plugs/weigh_in_sheet.h"

#include <QCheckBox>

#include "text/message_text.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

constexpr int choiceHeight = 30;

}  // namespace

WeighInSheet::WeighInSheet(V8PlugsModel* model, QWidget* parent) : MatchingSheet(model, parent) {
    column()->setSpacing(Theme::space);
    section({});
    ordered(box(
        QStringLiteral("changes_from_weigh_in"), tr("Take the mass changes &from this sheet"),
        fieldHint(field::changes_source), [model] { return model->input().changes_from_weigh_in; },
        [model](bool on) {
            model->edit(fieldName(field::changes_source), [&](Input& input) {
                input.changes_from_weigh_in = on;
                if (!input.weigh_in) {
                    input.weigh_in.emplace();
                }
            });
        }));
    QComboBox* numbering = choice("/weigh_in/cylinder_numbering");
    numbering->setMinimumHeight(Theme::withText(choiceHeight));
    numbering->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    addWeights(new WeighInTable(WeighInTable::sourceOf(model, field::part_mass, true,
                                                       [] { return int{cylinder_count}; }),
                                this),
               cylinder_count, [model](Part part) { return model->columnNote(part); });
    addGoal(false);
    addFindings([model] { return model->notCounted(); });
    addTable("crankpins", tr("Excess on each crankpin, as weighed and after moving"));
    finish();
}

}  // namespace ravnoves
