#include "elastic-hinge/hinge_inputs.h"

#include <QCheckBox>
#include <QComboBox>
#include <QVBoxLayout>
#include <cmath>

#include "elastic-hinge/number_list_field.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"
#include "elastic-hinge/presets.h"

namespace ravnoves {

using elastic_hinge::CounterweightInertia;
using elastic_hinge::GuideSign;
using elastic_hinge::Input;
using elastic_hinge::Kinematics;
using elastic_hinge::MotionWish;
using elastic_hinge::RodCounterweight;
using elastic_hinge::Spring;
namespace field = elastic_hinge::field;

namespace {

/// A field's range under another key or label.
constexpr FieldSpec withKey(const FieldSpec& spec, std::string_view key) {
    return {key, spec.unit, spec.range, spec.to_si};
}

/// The weight as it was typed: without what the division by g has left in the last digits.
double roundedWeight(double mass, double gravity) {
    return readFormNumber(formNumber(mass * gravity, QLocale::c(), 12)).value_or(mass * gravity);
}

Spring rodSpring(const Input& input) {
    if (input.rod_hinge_spring) {
        return *input.rod_hinge_spring;
    }
    return input.spring.value_or(*elastic_hinge::preset_zotov().spring);
}

}  // namespace

HingeInputs::HingeInputs(ElasticHingeModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column->setSpacing(Theme::gap);

    auto* mechanism = new FormSection(tr("Mechanism"), this);
    preset_ = new QComboBox(this);
    preset_->addItems({tr("Own values"), tr("Zotov and Sviridov")});
    mechanism->addWidget(tr("&Preset"), preset_, {},
                         tr("The mechanism of the paper, with ρ₀ = 90 mm"));
    connect(preset_, &QComboBox::activated, this, [this](int index) {
        if (index == 1) {
            model_->loadDefault();
        }
        show();
    });
    given_ = new QComboBox(this);
    given_->setObjectName(QStringLiteral("masses_given_as"));
    given_->addItems({tr("weights, N"), tr("masses, kg")});
    mechanism->addWidget(tr("Given &as"), given_, {},
                         tr("The paper gives weights. With masses gravity may be 0: a mechanism "
                            "that lies flat."));
    connect(given_, &QComboBox::activated, this, [this](int index) {
        model_->edit(tr("Weights or masses"),
                     [index](Input& input) { input.masses_as_weights = index == 0; });
        show();
    });
    column->addWidget(mechanism);
    weights_ = massSection(true);
    masses_ = massSection(false);
    column->addWidget(weights_);
    column->addWidget(masses_);

    auto* sizes = new FormSection({}, this);
    bind(sizes->addNumber(tr("&Crank radius r"), field::crank_radius,
                          tr("From the crank's axis to the crankpin; the rod is r/λ long. Paper: "
                             "50 mm.")),
         tr("Crank radius"), field::millimetre, [](Input& input) { return &input.crank_radius; });
    kinematics_ = new QComboBox(this);
    kinematics_->setObjectName(QStringLiteral("kinematics"));
    kinematics_->addItems({tr("exact"), tr("paper's series")});
    sizes->addWidget(tr("&Kinematics of M₁₂"), kinematics_, {},
                     tr("The paper's series for cos ψ is good for small λ only; the exact one "
                        "needs λ < 1. M and the crank's guide are always exact."));
    connect(kinematics_, &QComboBox::activated, this, [this](int index) {
        model_->edit(tr("Kinematics"), [index](Input& input) {
            input.kinematics = index == 0 ? Kinematics::exact : Kinematics::series;
        });
        show();
    });
    column->addWidget(sizes);
    column->addWidget(hingeSection());
    rodSpring_ = rodSpringSection();
    column->addWidget(rodSpring_);
    column->addWidget(counterweightSection());
    counterweightAsWeight_ = counterweightFields(true);
    counterweightAsMass_ = counterweightFields(false);
    column->addWidget(counterweightAsWeight_);
    column->addWidget(counterweightAsMass_);
    column->addWidget(makingSection());
    column->addWidget(motionSection());
    column->addWidget(familySection());
    column->addStretch();

    connect(model_, &SceneModel::changed, this, &HingeInputs::show);
    show();
}

void HingeInputs::bind(NumberField* target, const QString& name, double unit, Access access) {
    connect(target, &NumberField::valueEdited, this,
            [this, name, unit, access](std::optional<double> value) {
                model_->edit(name, [&](Input& input) {
                    if (double* number = access(input)) {
                        *number = *value * unit;
                    }
                });
            });
    bindings_.push_back({target, [this, unit, access]() -> std::optional<double> {
                             Input input = model_->input();
                             const double* number = access(input);
                             return number != nullptr ? std::optional(*number / unit)
                                                      : std::nullopt;
                         }});
}

void HingeInputs::bindOptional(NumberField* target, const QString& name,
                               std::function<std::optional<double>()> read,
                               std::function<void(Input&, std::optional<double>)> write) {
    target->setOptional(true);
    connect(target, &NumberField::valueEdited, this,
            [this, name, write = std::move(write)](std::optional<double> value) {
                model_->edit(name, [&](Input& input) { write(input, value); });
            });
    bindings_.push_back({target, std::move(read)});
}

FormSection* HingeInputs::massSection(bool weights) {
    auto* section = new FormSection({}, this);
    struct Row {
        std::string_view key;
        QString label;
        QString hint;
        double Input::*member;
    };
    const Row rows[] = {
        {"crank", weights ? tr("C&rank P₁") : tr("C&rank m₁"),
         tr("The crank is a uniform bar of length r. Paper: 5 N."), &Input::crank_mass},
        {"rod", weights ? tr("Ro&d P₂") : tr("Ro&d m₂"),
         tr("The rod is a uniform bar of length r/λ. Paper: 6.5 N."), &Input::rod_mass},
        {"slider", weights ? tr("S&lider P₃") : tr("S&lider m₃"), tr("Paper: 6 N."),
         &Input::slider_mass}};
    for (const Row& row : rows) {
        auto* number = section->addNumber(
            row.label, withKey(weights ? field::weight : field::mass, row.key), row.hint);
        number->setObjectName(
            QString::fromUtf8(row.key.data(), static_cast<qsizetype>(row.key.size())) +
            (weights ? QStringLiteral("_weight") : QStringLiteral("_mass")));
        QString name = row.label;
        name.remove(QLatin1Char('&'));
        connect(number, &NumberField::valueEdited, this,
                [this, name, weights, member = row.member](std::optional<double> value) {
                    model_->edit(name, [&](Input& input) {
                        input.*member = weights ? *value / input.gravity : *value;
                    });
                });
        bindings_.push_back({number, [this, weights, member = row.member] {
                                 const Input& input = model_->input();
                                 return std::optional(weights ? input.*member * input.gravity
                                                              : input.*member);
                             }});
    }
    auto* gravity =
        section->addNumber(tr("&Gravity g"), weights ? field::gravity : field::gravity_with_masses,
                           tr("The paper takes 9.82 m/s²; the standard value is 9.80665 m/s²."));
    if (!weights) {
        gravity->setObjectName(QStringLiteral("gravity_with_masses"));
    }
    connect(gravity, &NumberField::valueEdited, this, [this, weights](std::optional<double> value) {
        model_->edit(tr("Gravity"), [&](Input& input) {
            if (weights) {
                // The weights stay, the masses follow.
                const auto follow = [&](double& mass) {
                    mass = roundedWeight(mass, input.gravity) / *value;
                };
                follow(input.crank_mass);
                follow(input.rod_mass);
                follow(input.slider_mass);
                if (input.rod_counterweight && input.rod_counterweight->mass) {
                    follow(*input.rod_counterweight->mass);
                }
            }
            input.gravity = *value;
        });
    });
    bindings_.push_back({gravity, [this] { return std::optional(model_->input().gravity); }});
    return section;
}

FormSection* HingeInputs::hingeSection() {
    auto* section = new FormSection(tr("Springs and guides"), this);
    const auto spring = [](Input& input) {
        if (!input.spring) {
            input.spring = elastic_hinge::preset_zotov().spring;
        }
        return &*input.spring;
    };
    bind(section->addNumber(tr("&Free length ℓ₀"), field::free_length,
                            tr("Length of the unloaded spring of the crank's hinge. Paper: "
                               "200 mm.")),
         tr("Free length"), field::millimetre,
         [spring](Input& input) { return &spring(input)->free_length; });
    sign_ = new QComboBox(this);
    sign_->setObjectName(QStringLiteral("guide_sign"));
    sign_->addItems({tr("keeps the energy"), tr("as printed (1)")});
    section->addWidget(tr("Sign of the g&uide"), sign_, {},
                       tr("A spring that keeps the crank's speed gives out what the mechanism "
                          "takes up: Π = const − (T + V). Equation (1) as printed has a plus."));
    connect(sign_, &QComboBox::activated, this, [this](int index) {
        model_->edit(tr("Sign of the guide"), [index](Input& input) {
            input.guide_sign = index == 0 ? GuideSign::energy : GuideSign::as_printed;
        });
        show();
    });
    ownRodSpring_ = new QCheckBox(tr("Own spring for the rod's &hinge"), this);
    ownRodSpring_->setObjectName(QStringLiteral("own_rod_spring"));
    ownRodSpring_->setToolTip(tr("Else the rod's hinge has the same spring as the crank's"));
    connect(ownRodSpring_, &QCheckBox::clicked, this, [this](bool on) {
        model_->edit(tr("Spring of the rod's hinge"), [on](Input& input) {
            input.rod_hinge_spring = on ? std::optional(rodSpring(input)) : std::nullopt;
        });
    });
    section->addWide(ownRodSpring_);
    return section;
}

FormSection* HingeInputs::rodSpringSection() {
    auto* section = new FormSection({}, this);
    struct Row {
        QString label;
        const FieldSpec* spec;
        double unit;
        double Spring::*member;
        QString hint;
    };
    const Row rows[] = {
        {tr("Its &stiffness c"), &field::stiffness, 1.0, &Spring::stiffness,
         tr("Of the rod hinge's own spring")},
        {tr("Its free length &ℓ₀"), &field::free_length, field::millimetre, &Spring::free_length,
         tr("Of the rod hinge's own spring")},
        {tr("Its radius ρ&₀"), &field::guide_radius, field::millimetre,
         &Spring::guide_radius_at_zero, tr("Of the rod hinge's own guide at θ = 0")}};
    for (const Row& row : rows) {
        auto* number = section->addNumber(row.label, *row.spec, row.hint);
        number->setObjectName(QStringLiteral("rod_hinge_") + number->objectName());
        QString name = row.label;
        name.remove(QLatin1Char('&'));
        connect(number, &NumberField::valueEdited, this,
                [this, name, unit = row.unit, member = row.member](std::optional<double> value) {
                    model_->edit(name, [&](Input& input) {
                        Spring own = rodSpring(input);
                        own.*member = *value * unit;
                        input.rod_hinge_spring = own;
                    });
                });
        bindings_.push_back({number, [this, unit = row.unit, member = row.member] {
                                 return std::optional(rodSpring(model_->input()).*member / unit);
                             }});
    }
    return section;
}

FormSection* HingeInputs::counterweightSection() {
    auto* section = new FormSection(tr("Counterweight on the rod"), this);
    counterweight_ = new QCheckBox(tr("Counter&weight beyond the crankpin"), this);
    counterweight_->setObjectName(QStringLiteral("rod_counterweight"));
    counterweight_->setToolTip(
        tr("At the distance ℓ₂ beyond the crankpin (slider above). With the weight of (10) the "
           "rod's hinge makes the side force zero."));
    connect(counterweight_, &QCheckBox::clicked, this, [this](bool on) {
        model_->edit(tr("Counterweight"), [on](Input& input) {
            input.rod_counterweight =
                on ? std::optional(
                         RodCounterweight{0.1, std::nullopt, CounterweightInertia::newton_euler})
                   : std::nullopt;
        });
    });
    section->addWide(counterweight_);
    return section;
}

FormSection* HingeInputs::counterweightFields(bool weights) {
    auto* section = new FormSection({}, this);
    auto* number = section->addNumber(
        weights ? tr("Weight P&₄") : tr("Mass m&₄"),
        weights ? field::counterweight_weight : field::counterweight_mass,
        tr("Empty: solved from (10), P₄ ℓ₂ = (P₃ + P₂/2) ℓ, so that M₁₂ has no mean."));
    number->setObjectName(weights ? QStringLiteral("counterweight_weight")
                                  : QStringLiteral("counterweight_mass"));
    number->setPlaceholderText(tr("by (10)"));
    bindOptional(
        number, tr("Counterweight P₄"),
        [this, weights]() -> std::optional<double> {
            const Input& input = model_->input();
            if (!input.rod_counterweight || !input.rod_counterweight->mass) {
                return std::nullopt;
            }
            return *input.rod_counterweight->mass * (weights ? input.gravity : 1.0);
        },
        [weights](Input& input, std::optional<double> value) {
            if (!input.rod_counterweight) {
                return;
            }
            if (value && weights) {
                *value /= input.gravity;
            }
            input.rod_counterweight->mass = value;
        });
    auto* inertia = new QComboBox(section);
    inertia->setObjectName(weights ? QStringLiteral("counterweight_inertia")
                                   : QStringLiteral("counterweight_inertia_masses"));
    inertia->addItems({tr("as printed (9)"), tr("Newton–Euler")});
    section->addWidget(tr("&Inertia in M₁₂"), inertia, {},
                       tr("Equation (9) as printed has the wrong sign at the counterweight's "
                          "inertia forces; with moments about A the side force vanishes."));
    connect(inertia, &QComboBox::activated, this, [this](int index) {
        model_->edit(tr("Counterweight's inertia"), [index](Input& input) {
            if (input.rod_counterweight) {
                input.rod_counterweight->inertia = static_cast<CounterweightInertia>(index);
            }
        });
    });
    inertias_.push_back(inertia);
    return section;
}

FormSection* HingeInputs::makingSection() {
    auto* section = new FormSection(tr("Making the guide"), this);
    bind(section->addNumber(tr("Roller radi&us"), field::roller_radius,
                            tr("ρ is the path of the roller's centre; the profile is offset from "
                               "it by the roller's radius. The paper takes 0.")),
         tr("Roller radius"), field::millimetre, [](Input& input) { return &input.roller_radius; });
    auto* waves = section->addNumber(
        tr("Error &waves"),
        {"profile_error_waves", "", Range::between(field::smallest_waves, field::largest_waves)},
        tr("The profile's error is taken as so many waves in one turn: 1 is a guide out of "
           "centre, 2 an oval one. A whole number."));
    connect(waves, &NumberField::valueEdited, this, [this](std::optional<double> value) {
        model_->edit(tr("Error waves"), [&](Input& input) {
            input.profile_error_waves = static_cast<int>(std::lround(*value));
        });
    });
    bindings_.push_back(
        {waves, [this] { return std::optional<double>(model_->input().profile_error_waves); }});
    return section;
}

FormSection* HingeInputs::motionSection() {
    auto* section = new FormSection(tr("Motion"), this);
    const auto wish = [](Input& input) {
        if (!input.motion) {
            input.motion = MotionWish{};
        }
        return &*input.motion;
    };
    bind(section->addNumber(tr("Tur&ns"), field::turns, tr("Turns of the crank to compute")),
         tr("Turns"), 1.0, [wish](Input& input) { return &wish(input)->turns; });
    auto* off = section->addNumber(
        tr("Off-design sp&eed"), field::start_speed,
        tr("A start away from the design speed ω, for comparison: the hinge is exact at one speed "
           "only. Empty: 1.2 ω."));
    off->setPlaceholderText(tr("1.2 ω"));
    bindOptional(
        off, tr("Off-design speed"),
        [this]() -> std::optional<double> {
            return model_->input().motion ? model_->input().motion->start_speed : std::nullopt;
        },
        [wish](Input& input, std::optional<double> value) { wish(input)->start_speed = value; });
    bind(section->addNumber(tr("S&tart angle"), field::start_angle,
                            tr("Crank angle at which the motion starts")),
         tr("Start angle"), degree, [wish](Input& input) { return &wish(input)->start_angle; });
    bind(section->addNumber(tr("&Moment on the crank"), field::crank_torque,
                            tr("A constant moment that drives the crank; negative brakes it")),
         tr("Moment on the crank"), 1.0,
         [wish](Input& input) { return &wish(input)->crank_torque; });
    withError_ = new QCheckBox(tr("With the profile &error"), this);
    withError_->setObjectName(QStringLiteral("with_profile_error"));
    withError_->setToolTip(
        tr("The crank's guide as it was made, with the waves of the profile "
           "error: the crank's speed then follows them"));
    connect(withError_, &QCheckBox::clicked, this, [this, wish](bool on) {
        model_->edit(tr("Profile error in the motion"),
                     [&](Input& input) { wish(input)->with_profile_error = on; });
    });
    section->addWide(withError_);
    return section;
}

FormSection* HingeInputs::familySection() {
    auto* section = new FormSection(tr("Families of curves"), this);
    speeds_ = new NumberListField(field::angular_speed.range, 6, this);
    speeds_->setObjectName(QStringLiteral("compare_speeds"));
    speeds_->setHint(tr("Crank speeds that the plots compare, rad/s. Paper: 100, 300, 500."));
    section->addWidget(tr("Speeds ω, rad/s&;"), speeds_);
    lambdas_ = new NumberListField(field::lambda.range, 6, this);
    lambdas_->setObjectName(QStringLiteral("compare_lambdas"));
    lambdas_->setHint(
        tr("λ that the side force is compared for. Paper: 0.3, 0.4, 0.6, 0.8, 1 "
           "(1 with the series only)."));
    section->addWidget(tr("Ratios &λ"), lambdas_);
    connect(speeds_, &NumberListField::valuesEdited, model_, &ElasticHingeModel::setCompareSpeeds);
    connect(lambdas_, &NumberListField::valuesEdited, model_,
            &ElasticHingeModel::setCompareLambdas);
    return section;
}

void HingeInputs::show() {
    const Input& input = model_->input();
    for (const Binding& binding : bindings_) {
        binding.field->setValue(binding.read());
    }
    Input preset = elastic_hinge::preset_zotov();
    preset_->setCurrentIndex(preset == input ? 1 : 0);
    given_->setCurrentIndex(input.masses_as_weights ? 0 : 1);
    weights_->setVisible(input.masses_as_weights);
    masses_->setVisible(!input.masses_as_weights);
    kinematics_->setCurrentIndex(input.kinematics == Kinematics::exact ? 0 : 1);
    sign_->setCurrentIndex(input.guide_sign == GuideSign::energy ? 0 : 1);
    ownRodSpring_->setChecked(input.rod_hinge_spring.has_value());
    rodSpring_->setVisible(input.rod_hinge_spring.has_value());
    const bool counterweight = input.rod_counterweight.has_value();
    counterweight_->setChecked(counterweight);
    counterweightAsWeight_->setVisible(counterweight && input.masses_as_weights);
    counterweightAsMass_->setVisible(counterweight && !input.masses_as_weights);
    for (QComboBox* inertia : inertias_) {
        if (counterweight) {
            inertia->setCurrentIndex(static_cast<int>(input.rod_counterweight->inertia));
        }
    }
    withError_->setChecked(input.motion && input.motion->with_profile_error);
    speeds_->setValue(model_->compareSpeeds());
    lambdas_->setValue(model_->compareLambdas());
}

}  // namespace ravnoves
