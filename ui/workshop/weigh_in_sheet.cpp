#include <QCheckBox>

#include "bob-weights/fields.h"
#include "text/message_text.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"
#include "workshop/sheets.h"

namespace ravnoves {

WeighInSheet::WeighInSheet(WorkshopModel* model, QWidget* parent) : MatchingSheet(model, parent) {
    column()->setSpacing(Theme::space);
    section({});
    QCheckBox* source = ordered(box(
        QStringLiteral("changes_from_weigh_in"), tr("Take the mass changes &from this sheet"),
        fieldHint(v8_plugs::field::changes_source),
        [model] { return model->hasPlugs() && model->input().plugs->changes_from_weigh_in; },
        [model](bool on) {
            model->editPlugs(fieldName(v8_plugs::field::changes_source),
                             [on](v8_plugs::Input& plugs) { plugs.changes_from_weigh_in = on; });
        }));
    follow([model, source] { source->setVisible(model->hasPlugs()); });
    QComboBox* pairs = wide(choice("/weigh_in/cylinder_numbering"), 250);
    const auto noPairs = [model] {
        return model->input().engine.type == bob_weights::EngineType::in_line
                   ? tr("In line each cylinder has a crankpin of its own.")
                   : QString();
    };
    follow([pairs, noPairs, hint = pairs->toolTip()] {
        const QString why = noPairs();
        pairs->setEnabled(why.isEmpty());
        pairs->setToolTip(why.isEmpty() ? hint : why);
    });
    line(Theme::smallSize, noPairs);
    line(Theme::smallSize, [model] {
        const int cylinders = model->input().engine.cylinders;
        return cylinders > mostRows
                   ? tr("The sheet shows %1 of %2 cylinders. Paste a column of a spreadsheet for "
                        "all, or type the means on sheet 2.")
                         .arg(mostRows)
                         .arg(cylinders)
                   : QString();
    });
    addWeights(new WeighInTable(
                   WeighInTable::sourceOf(model, bob_weights::field::part_mass, true,
                                          [model] { return model->input().engine.cylinders; }),
                   this),
               mostRows, [model](shop::Part part) { return model->columnNote(part); });
    section({});
    line(Theme::baseSize, [model] { return model->weighInText(); });
    addGoal(true);
    addFindings([model] { return model->hasPlugs() ? model->notCounted() : QStringList(); });
    addTable("crankpins", tr("Excess on each crankpin, as weighed and after moving"));
    finish();
}

}  // namespace ravnoves
