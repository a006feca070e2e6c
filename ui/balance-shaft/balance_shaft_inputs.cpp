#include <QTabWidget>
#include <QVBoxLayout>

#include "balance-shaft/balance_shaft_page.h"
#include "balance-shaft/fields.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/torque_source_editor.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/form.h"
#include "widgets/page_columns.h"

namespace ravnoves {

using balance_shaft::Input;
namespace field = balance_shaft::field;

void BalanceShaftPage::addEngine(Form* form) {
    FormSection* engine = form->section(tr("Engine"));
    form->choice(
        {}, tr("P&reset"), {tr("Own values"), tr("TMZ-650D")},
        tr("TMZ-650D: the single-cylinder diesel of Gots and Klevtsov, Tables 1 and 2"),
        [this] {
            Input wanted = balance_shaft::preset_tmz_650d();
            wanted.shaft_angle = model_->input().shaft_angle;
            return wanted == model_->input() ? 1 : 0;
        },
        [this](int index) {
            if (index == 1) {
                model_->edit(
                    tr("Preset TMZ-650D"),
                    [](Input& input) { input = balance_shaft::preset_tmz_650d(); },
                    BalanceShaftScene::defaultTitle());
                Q_EMIT model_->broughtIn();
            }
        });
    NumberField* speed = form->number(
        field::speed, [this] { return model_->input().angular_speed; },
        [this](std::optional<double> value) { model_->setSpeed(*value); });
    speed->setDigits(8);
    QLabel* angularSpeed = engine->addResult(tr("ω"), tr("Angular speed, n π / 30"));
    form->follow([this, angularSpeed] {
        angularSpeed->setText(shownNumber(model_->input().angular_speed, units::rad_per_s, 2));
    });
    form->choice("/strokes", [this](int strokes) { return model_->setStrokes(strokes); });
    form->number("/crank_radius_mm");
    for (const char* place :
         {"/cylinder/bore_mm", "/cylinder/rod_length_mm", "/cylinder/offset_mm"}) {
        form->number(place);
    }
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
    QLabel* sum = masses->addResult(
        tr("Sum mⱼ"), tr("Reciprocating mass: the sum of the parts. TMZ-650D: 1.316 kg."));
    QLabel* note = captionLabel({}, masses);
    masses->addWide(note);
    form->follow([this, sum, note] {
        sum->setText(shownNumber(model_->input().reciprocating_mass(), units::kg, 3));
        const double other = model_->otherMasses();
        note->setText(tr("%1 of it are not listed above.").arg(shownShort(other, units::kg, 6)));
        note->setVisible(other > 0.0);
    });
}

QTabWidget* BalanceShaftPage::buildInputs() {
    auto* form = new Form(model_);
    addEngine(form);
    addMasses(form);
    form->section(tr("Counterweights and shaft"));
    for (const char* place :
         {"/counterweight_radius_mm", "/counterweight_mass_kg", "/centre_distance_mm"}) {
        form->number(place);
    }
    FormSection* sizes = form->section(tr("Sizes: what can be built"));
    for (const char* place :
         {"/envelope/cylinder_wall_mm", "/envelope/cylinder_bottom_mm", "/envelope/cylinder_top_mm",
          "/envelope/rod_width_mm", "/envelope/crank_swing_radius_mm",
          "/envelope/shaft_swing_radius_mm", "/envelope/gear_tip_radius_mm",
          "/envelope/clearance_mm", "/envelope/wall_mm"}) {
        form->number(place);
    }
    QLabel* assumed = captionLabel({}, sizes);
    sizes->addWide(assumed);
    form->follow([this, assumed] {
        const Message& text = model_->result().assumed_sizes;
        assumed->setText(messageText(text));
        assumed->setVisible(!text.empty());
    });
    form->section(tr("Torque between the rows of its table"));
    form->choice("/interpolation");
    form->column()->addStretch();

    auto* tabs = new QTabWidget(this);
    tabs->setDocumentMode(true);
    tabs->setFixedWidth(PageColumns::inputsWidth());
    auto* scroll = scrolled(form, tabs);
    tabs->addTab(scroll, tr("Inputs"));
    source_ = new TorqueSourceEditor(model_, tabs);
    source_->setObjectName(QStringLiteral("torque"));
    tabs->addTab(source_, tr("Torque"));
    return tabs;
}

}  // namespace ravnoves
