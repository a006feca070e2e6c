#include <QTabWidget>
#include <QVBoxLayout>

#include "balance-shaft/balance_shaft_page.h"
#include "balance-shaft/fields.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/torque_source_editor.h"
#include "text/message_text.h"
#include "text/shown_units.h"
#include "widgets/form.h"
#include "widgets/page_columns.h"

namespace ravnoves {

using balance_shaft::FrontView;
namespace field = balance_shaft::field;

void BalanceShaftPage::addEngine(Form* form) {
    FormSection* engine = form->section(tr("Engine"));
    NumberField* speed = form->number(
        field::speed, [this] { return model_->input().angular_speed; },
        [this](std::optional<double> value) { model_->setSpeed(*value); });
    speed->setDigits(8);
    QLabel* angularSpeed = engine->addResult(tr("ω"), tr("Angular speed, n π / 30"));
    form->follow([this, angularSpeed] {
        angularSpeed->setText(shownNumber(model_->input().angular_speed, units::rad_per_s, 2));
    });
    form->choice("/strokes");
    form->number("/crank_radius_mm");
    form->number(
        field::stroke, [this] { return std::optional(2.0 * model_->input().crank_radius); },
        [this](std::optional<double> value) {
            model_->editField("/crank_radius_mm", from_si(field::crank_radius, *value / 2.0),
                              fieldName(field::stroke));
        });
    addAssumed(form, "/cylinder/bore_mm", &FrontView::cylinder_bore);
    addAssumed(form, "/cylinder/rod_length_mm", &FrontView::rod_length);
    form->number("/cylinder/offset_mm");
}

void BalanceShaftPage::addAssumed(Form* form, const char* place, double FrontView::*size) {
    showAssumed(form, form->number(place), [this, size] {
        return std::optional(model_->solver().front_view().*size / units::mm);
    });
}

void BalanceShaftPage::addMasses(Form* form) {
    FormSection* masses = form->section(tr("Reciprocating masses"));
    for (const Field& part : field::mass_parts) {
        const std::string name(part.key);
        NumberField* mass = form->number(
            part, [this, name] { return model_->mass(name); },
            [this, name, &part](std::optional<double> value) {
                model_->editField("/reciprocating_masses_kg/" + name, *value, fieldName(part));
            });
        mass->setObjectName(QString::fromStdString("mass_" + name));
    }
    form->number("/rod_mass_kg");
    QLabel* sum = masses->addResult(tr("Sum mⱼ"), tr("Reciprocating mass: the sum of the parts."));
    QLabel* note = captionLabel({}, masses);
    masses->addWide(note);
    form->follow([this, sum, note] {
        sum->setText(shownNumber(model_->input().reciprocating_mass(), units::kg, 3));
        const double other = model_->otherMasses();
        note->setText(tr("Not listed above: %1.").arg(shownShort(other, units::kg, 6)));
        note->setVisible(other > 0.0);
    });
}

QTabWidget* BalanceShaftPage::buildInputs() {
    auto* form = new Form(model_);
    addEngine(form);
    addMasses(form);
    form->section(tr("Counterweights and shaft"));
    form->number("/counterweight_radius_mm");
    showAssumed(form, form->number("/counterweight_mass_kg"),
                [this] { return std::optional(model_->input().counterweight()); });
    form->number("/centre_distance_mm");
    form->section(tr("Sizes for clearance"));
    for (const auto& [place, size] :
         {std::pair("/envelope/cylinder_wall_mm", &FrontView::cylinder_wall),
          std::pair("/envelope/cylinder_bottom_mm", &FrontView::cylinder_bottom),
          std::pair("/envelope/cylinder_top_mm", &FrontView::cylinder_top),
          std::pair("/envelope/rod_width_mm", &FrontView::rod_width),
          std::pair("/envelope/crank_swing_radius_mm", &FrontView::crank_swing_radius),
          std::pair("/envelope/shaft_swing_radius_mm", &FrontView::shaft_swing_radius),
          std::pair("/envelope/gear_tip_radius_mm", &FrontView::gear_tip_radius)}) {
        addAssumed(form, place, size);
    }
    form->number("/envelope/clearance_mm");
    form->number("/envelope/wall_mm");
    FormSection* rows = form->section(tr("Torque between the rows of its table"));
    form->choice("/interpolation");
    form->follow([this, rows] { rows->setVisible(model_->replacedInputs().empty()); });
    form->column()->addStretch();

    auto* tabs = new QTabWidget(this);
    tabs->setDocumentMode(true);
    tabs->setFixedWidth(PageColumns::inputsWidth());
    auto* scroll = scrolled(form, tabs);
    tabs->addTab(scroll, tr("Inputs"));
    auto* source = new TorqueSourceEditor(model_, tabs);
    source->setObjectName(QStringLiteral("torque"));
    tabs->addTab(source, tr("Torque"));
    return tabs;
}

}  // namespace ravnoves
