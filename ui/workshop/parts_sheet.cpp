#include <QLabel>
#include <QPushButton>

#include "bob-weights/fields.h"
#include "text/message_text.h"
#include "theme/theme.h"
#include "v8-plugs/fields.h"
#include "workshop/doubts.h"
#include "workshop/sheets.h"

namespace ravnoves {

PartsSheet::PartsSheet(WorkshopModel* model, QWidget* parent) : WorkshopSheet(model, parent) {
    plugsSection(false, tr("Parts of one cylinder"));
    for (const bob_weights::PartField& part : bob_weights::part_fields()) {
        const std::string pointer = "/parts_g/" + std::string(part.field.key);
        NumberField* field = number(pointer.c_str());
        follow([this, field, part] {
            // What the weigh-in sheet says goes before what is typed here; where both are doubted,
            // what is typed can be put right.
            const auto mass = bob_weights::mass_of(model_->input(), part);
            field->setEnabled(!bob_weights::is_weighed(model_->input(), part) ||
                              workshop::contradicts_scale(model_->input(), part));
            if (!field->isEnabled() && mass) {
                field->setValue(from_si(part.field, *mass));
            }
        });
    }
    plugsSection(false, tr("Balance factor"));
    doubt(number("/factor/reciprocating_percent"), "share-of-one");
    number("/factor/overbalance_percent");
    line(Theme::smallSize, [this] {
        const bob_weights::Engine& engine = model_->input().engine;
        return engine.type == bob_weights::EngineType::v && !engine.bank_angle
                   ? QString()
                   : messageText(factor_reason(engine));
    });
    plugsSection(true, tr("Parts of one cylinder, heavier than nominal by (negative: lighter)"));
    for (const v8_plugs::MassChangeField& each : v8_plugs::mass_change_fields()) {
        NumberField* made = number(
            each.field,
            [this, each]() -> std::optional<double> {
                // Empty until one of them is given: then the others are 0.
                const v8_plugs::Input* plugs = model_->plugsInput();
                return plugs != nullptr && (plugs->changes_known() || plugs->has_typed_changes())
                           ? std::optional(plugs->changes().*each.member)
                           : std::nullopt;
            },
            [this, each](std::optional<double> value) {
                model_->editPlugs(fieldName(each.field), [&](v8_plugs::Input& plugs) {
                    plugs.typed_changes.*each.member = value.value_or(0.0);
                    plugs.changes_given = true;
                });
            });
        enableWhile(made, [this, each] {
            const v8_plugs::Input* plugs = model_->plugsInput();
            return plugs != nullptr && plugs->takes_typed(each.member) &&
                   (!each.repair_only || plugs->process == v8_plugs::Process::repair);
        });
    }
    plugsSection(true, tr("Nominal masses, for the bob weight"));
    engineValues(v8_plugs::EngineGroup::bob_weight);
    QPushButton* fill = button(
        "fill_masses", tr("&Fill from the nominal parts"),
        tr("Reciprocating: piston, pin, rings, small end; rotating: big end and shells, by the "
           "nominal masses of the weigh-in sheet."),
        [this] { model_->fillNominalMasses(); });
    enableWhile(fill, [this] { return model_->canFillNominalMasses(); });
    plugsSection(true, tr("Limit of the plugs"));
    number("/plugs/tolerance_g_mm");
    // Below the field: it must not move while one types.
    QLabel* owner = line(Theme::smallSize, [this] { return model_->toleranceText(); });
    owner->setObjectName(QStringLiteral("tolerance_owner"));
    QPushButton* keep =
        button("keep_tolerance", tr("&Save as shop default"), tr("New jobs begin with this limit."),
               [this] { model_->keepTolerance(); });
    QSizePolicy place = keep->sizePolicy();
    place.setRetainSizeWhenHidden(true);
    keep->setSizePolicy(place);
    showWhile(keep, [this] { return model_->hasPlugs() && !model_->isShopsTolerance(); });
    section({});
    line(Theme::smallSize, [this] {
        return model_->replacedInputs().empty()
                   ? QString()
                   : tr("Grey values are means of the weigh-in sheet.");
    });
    finish();
}

}  // namespace ravnoves
