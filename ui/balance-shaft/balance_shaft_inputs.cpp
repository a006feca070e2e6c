#include "balance-shaft/balance_shaft_page.h"

#include <QComboBox>
#include <QTabWidget>
#include <QVBoxLayout>
#include <array>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/torque_source_editor.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"
#include "text/number_text.h"

namespace ravnoves {

using balance_shaft::Input;
namespace field = balance_shaft::field;

namespace {

/// The masses of Table 1 that move with the piston, in the paper's order.
struct MassRow {
    const char* name;   ///< in the case file
    const char* label;  ///< with mnemonic
    const char* hint;
};

constexpr std::array<MassRow, 4> massRows{{
    {"piston", QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage", "&Piston"),
     QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage",
                       "Mass of the piston. TMZ-650D: 0.645 kg (0.640). Source: Gots and Klevtsov, "
                       "Table 1.")},
    {"pin", QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage", "Piston p&in"),
     QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage",
                       "Mass of the piston pin. TMZ-650D: 0.241 kg. Source: Table 1.")},
    {"rings", QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage", "Rin&gs"),
     QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage",
                       "Mass of the piston rings. TMZ-650D: 0.1 kg. Source: Table 1.")},
    {"rod_small_end", QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage", "Rod, small-&end share"),
     QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage",
                       "Part of the rod's mass that moves with the piston. TMZ-650D: 0.33 kg of "
                       "0.950 kg. Source: Table 1.")},
}};

void setMass(Input& input, const std::string& name, double mass) {
    for (balance_shaft::NamedMass& part : input.reciprocating_masses) {
        if (part.name == name) {
            part.mass = mass;
            return;
        }
    }
    // A case that gave only the sum: the sum stays as one part beside the named ones.
    for (balance_shaft::NamedMass& part : input.reciprocating_masses) {
        if (part.name.empty()) {
            part.name = "other";
        }
    }
    input.reciprocating_masses.push_back({name, mass});
}

double otherMasses(const Input& input) {
    double sum = 0.0;
    for (const balance_shaft::NamedMass& part : input.reciprocating_masses) {
        bool listed = false;
        for (const MassRow& row : massRows) {
            listed = listed || part.name == row.name;
        }
        sum += listed ? 0.0 : part.mass;
    }
    return sum;
}

}  // namespace

void BalanceShaftPage::bind(NumberField* numberField, const QString& name,
                            std::function<std::optional<double>()> read,
                            std::function<void(std::optional<double>)> write) {
    Q_UNUSED(name)
    connect(numberField, &NumberField::valueEdited, this, std::move(write));
    bindings_.push_back({numberField, std::move(read)});
}

QWidget* BalanceShaftPage::buildInputs() {
    auto* form = new QWidget;
    auto* column = new QVBoxLayout(form);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column->setSpacing(Theme::gap);

    // Binds a field to a number of the input: shown = SI value / unit.
    const auto number = [this](NumberField* target, const QString& name, double unit,
                               double Input::*member) {
        bind(
            target, name, [this, unit, member] { return model_->input().*member / unit; },
            [this, name, unit, member](std::optional<double> value) {
                model_->edit(name, [&](Input& input) { input.*member = *value * unit; });
            });
    };
    const auto optional = [this](NumberField* target, const QString& name, double unit,
                                 auto access) {
        target->setOptional(true);
        bind(
            target, name,
            [this, unit, access]() -> std::optional<double> {
                Input input = model_->input();
                const std::optional<double>& value = access(input);
                return value ? std::optional(*value / unit) : std::nullopt;
            },
            [this, name, unit, access](std::optional<double> value) {
                model_->edit(name, [&](Input& input) {
                    access(input) = value ? std::optional(*value * unit) : std::nullopt;
                });
            });
    };

    auto* engine = new FormSection(tr("Engine"), form);
    preset_ = new QComboBox(form);
    preset_->addItem(tr("Own values"));
    preset_->addItem(tr("TMZ-650D"));
    engine->addWidget(
        tr("P&reset"), preset_, {},
        tr("TMZ-650D: the single-cylinder diesel of Gots and Klevtsov, Tables 1 and 2"));
    connect(preset_, &QComboBox::activated, this, [this](int index) {
        if (index == 1) {
            model_->edit(tr("Preset TMZ-650D"),
                         [](Input& input) { input = balance_shaft::preset_tmz_650d(); });
            model_->setTitle(QStringLiteral("TMZ-650D"));
        }
        showInput();
    });
    auto* speed = engine->addNumber(
        tr("&Speed n"), field::speed,
        tr("Crankshaft speed. TMZ-650D: 3600 min⁻¹ (the paper prints ω = 376.8 rad/s, with "
           "π ≈ 3.14)."));
    speed->setDigits(8);
    bind(
        speed, tr("Speed"), [this] { return model_->input().angular_speed / rpm; },
        [this](std::optional<double> value) {
            model_->edit(tr("Speed"), [&](Input& input) {
                input.angular_speed = *value * rpm;
                input.speed_in_rpm = true;
            });
        });
    angularSpeed_ = engine->addResult(tr("ω"), tr("Angular speed, n π / 30"));
    number(engine->addNumber(tr("&Crank radius r"), field::crank_radius,
                             tr("Half the stroke. TMZ-650D: 46 mm (stroke 92 mm).")),
           tr("Crank radius"), field::millimetre, &Input::crank_radius);
    auto* rod = engine->addNumber(tr("Rod lengt&h L"), field::rod_length,
                                  tr("Between the centres of the rod's eyes; only the picture uses "
                                     "it. Empty: r / 0.3."));
    rod->setPlaceholderText(tr("auto"));
    optional(rod, tr("Rod length"), field::millimetre,
             [](Input& input) -> std::optional<double>& { return input.rod_length; });
    column->addWidget(engine);

    auto* masses = new FormSection(tr("Reciprocating masses"), form);
    for (const MassRow& row : massRows) {
        const std::string name = row.name;
        const QString label = tr(row.label);
        auto* massField = masses->addNumber(label, field::reciprocating_mass_part, tr(row.hint));
        massField->setObjectName(QString::fromStdString("mass_" + name));
        QString step = label;
        step.remove(QLatin1Char('&'));
        bind(
            massField, step, [this, name] { return model_->mass(name); },
            [this, name, step](std::optional<double> value) {
                model_->edit(step, [&](Input& input) { setMass(input, name, *value); });
            });
    }
    auto* rodMass = masses->addNumber(
        tr("Whole rod with she&lls"), field::rod_mass,
        tr("Its small-end share above is a part of it; the rest turns with the crankpin and is "
           "balanced by the crank's own counterweights. TMZ-650D: 0.950 ± 0.015 kg. Source: "
           "Table 1."));
    rodMass->setPlaceholderText(tr("any"));
    optional(rodMass, tr("Rod mass"), 1.0,
             [](Input& input) -> std::optional<double>& { return input.rod_mass; });
    massSum_ = masses->addResult(
        tr("Sum mⱼ"), tr("Reciprocating mass: the sum of the parts. TMZ-650D: 1.316 kg."));
    massNote_ = captionLabel({}, masses);
    masses->addWide(massNote_);
    column->addWidget(masses);

    auto* shaft = new FormSection(tr("Counterweights and shaft"), form);
    number(shaft->addNumber(tr("Coun&terweight radius ρ₁"), field::counterweight_radius,
                            tr("From the axis to the centre of mass of each of the two equal "
                               "counterweights. TMZ-650D: 46 mm.")),
           tr("Counterweight radius"), field::millimetre, &Input::counterweight_radius);
    auto* weight = shaft->addNumber(
        tr("Counterweight &mass m₁"), field::counterweight_mass,
        tr("Empty: by equation (1), m₁ = mⱼ r / (2 ρ₁). A number overrides it. TMZ-650D: "
           "0.658 kg."));
    weight->setPlaceholderText(tr("by (1)"));
    optional(weight, tr("Counterweight mass"), 1.0,
             [](Input& input) -> std::optional<double>& { return input.counterweight_mass; });
    number(shaft->addNumber(tr("Centre &distance l"), field::centre_distance,
                            tr("From the crank axis to the shaft axis. The paper does not print "
                               "it; 100.15 mm follows from the printed amplitude 430.39 N·m.")),
           tr("Centre distance"), field::millimetre, &Input::centre_distance);
    column->addWidget(shaft);

    auto* sizes = new FormSection(tr("Sizes for picture and envelope"), form);
    const QString automatic = tr("auto");
    const auto envelope = [&](const QString& label, const FieldSpec& spec, const QString& hint,
                              std::optional<double> balance_shaft::EnvelopeSizes::*member) {
        auto* target = sizes->addNumber(label, spec, hint);
        target->setPlaceholderText(automatic);
        QString step = label;
        step.remove(QLatin1Char('&'));
        optional(target, step, field::millimetre, [member](Input& input) -> std::optional<double>& {
            return input.envelope.*member;
        });
    };
    envelope(tr("Cylinder &bore"), field::cylinder_bore, tr("Empty: the stroke, 2 r."),
             &balance_shaft::EnvelopeSizes::cylinder_bore);
    envelope(tr("Crank swing radi&us"), field::crank_swing_radius,
             tr("Circle swept by crank and counterweight. Empty: 1.3 times the larger of r and "
                "ρ₁."),
             &balance_shaft::EnvelopeSizes::crank_swing_radius);
    envelope(tr("Shaft swin&g radius"), field::shaft_swing_radius,
             tr("Circle swept by the balance shaft. Empty: 1.3 ρ₁."),
             &balance_shaft::EnvelopeSizes::shaft_swing_radius);
    envelope(tr("Gear tip r&adius"), field::gear_tip_radius,
             tr("Tip circle of each of the two gears. Empty: l/2, the pitch circle."),
             &balance_shaft::EnvelopeSizes::gear_tip_radius);
    auto* wall = sizes->addNumber(tr("Housing &wall and gap"), field::wall,
                                  tr("Added around every circle."));
    bind(
        wall, tr("Wall"), [this] { return model_->input().envelope.wall / field::millimetre; },
        [this](std::optional<double> value) {
            model_->edit(tr("Wall"),
                         [&](Input& input) { input.envelope.wall = *value * field::millimetre; });
        });
    column->addWidget(sizes);
    interpolation_ = new QComboBox(form);
    interpolation_->addItems({tr("straight lines"), tr("periodic cubic spline")});
    auto* reading = new FormSection(tr("Torque between the rows of its table"), form);
    reading->addWidget(tr("I&nterpolation"), interpolation_, {},
                       tr("The paper's table has a row every 15°; criteria are those of the curve "
                          "between the rows, not of the rows alone."));
    connect(interpolation_, &QComboBox::activated, this, [this](int index) {
        model_->edit(tr("Interpolation"), [&](Input& input) {
            input.interpolation = index == 0 ? balance_shaft::Interpolation::linear
                                             : balance_shaft::Interpolation::periodic_cubic;
        });
    });
    column->addWidget(reading);
    column->addStretch();

    auto* tabs = new QTabWidget(this);
    tabs->setDocumentMode(true);
    tabs->setFixedWidth(300);
    auto* scroll = scrolled(form, tabs);
    tabs->addTab(scroll, tr("Inputs"));
    source_ = new TorqueSourceEditor(model_, tabs);
    source_->setObjectName(QStringLiteral("torque"));
    tabs->addTab(source_, tr("Torque"));
    return tabs;
}

void BalanceShaftPage::showInput() {
    for (const Binding& binding : bindings_) {
        binding.field->setValue(binding.read());
    }
    const QLocale locale;
    massSum_->setText(fixedNumber(model_->input().reciprocating_mass(), 3, locale) + tr(" kg"));
    const double other = otherMasses(model_->input());
    massNote_->setText(tr("%1 kg of it are not listed above.").arg(formNumber(other, locale, 6)));
    massNote_->setVisible(other > 0.0);
    angularSpeed_->setText(fixedNumber(model_->input().angular_speed, 2, locale) + tr(" rad/s"));
    Input preset = balance_shaft::preset_tmz_650d();
    preset.shaft_angle = model_->input().shaft_angle;
    preset_->setCurrentIndex(preset == model_->input() ? 1 : 0);
    interpolation_->setCurrentIndex(
        model_->input().interpolation == balance_shaft::Interpolation::linear ? 0 : 1);
}

}  // namespace ravnoves
