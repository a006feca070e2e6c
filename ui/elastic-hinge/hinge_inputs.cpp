#include "elastic-hinge/hinge_inputs.h"

#include <QVBoxLayout>

#include "elastic-hinge/fields.h"
#include "text/message_text.h"
#include "widgets/assumed.h"

namespace ravnoves {

using elastic_hinge::RodCounterweight;
using elastic_hinge::Spring;
namespace field = elastic_hinge::field;

namespace {

constexpr int massDigits = 6;  // of a mass that was a weight, or the other way round

}  // namespace

HingeInputs::HingeInputs(ElasticHingeModel* model, QWidget* parent)
    : Form(model, parent), model_(model) {
    addMechanism();
    addSprings();
    addCounterweight();
    section(tr("Making the guide"));
    addFilled("/roller_radius_mm");
    number("/profile_error_waves");
    addMotion();
    column()->addStretch();
}

void HingeInputs::addObjectBox(const Field& field, const QString& name,
                               std::function<bool(const Input&)> has,
                               std::function<void(Input&, bool)> set) {
    box(
        name, shownText(field.label), fieldHint(field),
        [this, has = std::move(has)] { return has(model_->input()); },
        [this, step = fieldName(field), set = std::move(set)](bool on) {
            model_->edit(step, [&](Input& input) { set(input, on); });
        });
}

void HingeInputs::showSectionWhile(std::function<bool(const Input&)> wanted) {
    follow([this, part = current(), wanted = std::move(wanted)] {
        part->setVisible(wanted(model_->input()));
    });
}

void HingeInputs::addMechanism() {
    section(tr("Mechanism"));
    choice(
        QStringLiteral("masses_given_as"), shownText(field::given_as.label),
        {shownTitle(tr("weights, N")).text, shownTitle(tr("masses, kg")).text},
        fieldHint(field::given_as), [this] { return model_->input().masses_as_weights ? 0 : 1; },
        [this](int index) {
            model_->edit(tr("Weights or masses"),
                         [index](Input& input) { input.masses_as_weights = index == 0; });
        });
    addMasses(true);
    addMasses(false);
    section({});
    number("/crank_radius_mm");
    choice("/kinematics");
}

void HingeInputs::addMasses(bool weights) {
    section({});
    showSectionWhile([weights](const Input& input) { return input.masses_as_weights == weights; });
    for (const char* part : {"crank", "rod", "slider"}) {
        const std::string pointer = (weights ? "/weights_N/" : "/masses_kg/") + std::string(part);
        NumberField* mass = number(pointer.c_str());
        mass->setDigits(massDigits);
        mass->setObjectName(QString::fromLatin1(part) +
                            (weights ? QLatin1String("_weight") : QLatin1String("_mass")));
    }
    auto* gravity = number(
        weights ? field::gravity : field::gravity_with_masses,
        [this] { return std::optional(model_->input().gravity); },
        [this](std::optional<double> value) { model_->setGravity(*value); });
    if (!weights) {
        gravity->setObjectName(QStringLiteral("gravity_with_masses"));
    }
}

void HingeInputs::addSprings() {
    section(tr("Springs and guides"));
    number(
        field::free_length,
        [this] {
            const auto& spring = model_->input().spring;
            return spring ? std::optional(spring->free_length) : std::nullopt;
        },
        [this](std::optional<double> value) {
            model_->editField("/spring/free_length_mm", from_si(field::free_length, *value),
                              fieldName(field::free_length));
        });
    choice("/guide_sign");
    addObjectBox(
        field::rod_hinge_spring, QStringLiteral("own_rod_spring"),
        [](const Input& input) { return input.rod_hinge_spring.has_value(); },
        [](Input& input, bool on) {
            input.rod_hinge_spring =
                on ? std::optional(input.spring.value_or(Spring{})) : std::nullopt;
        });
    section({});
    showSectionWhile([](const Input& input) { return input.rod_hinge_spring.has_value(); });
    for (const char* pointer :
         {"/rod_hinge_spring/stiffness_N_m", "/rod_hinge_spring/free_length_mm",
          "/rod_hinge_spring/guide_radius_at_zero_mm"}) {
        NumberField* field = number(pointer);
        field->setObjectName(QStringLiteral("rod_hinge_") + field->objectName());
    }
}

void HingeInputs::addCounterweight() {
    section(tr("Counterweight on the rod"));
    addObjectBox(
        field::rod_counterweight, QStringLiteral("rod_counterweight"),
        [](const Input& input) { return input.rod_counterweight.has_value(); },
        [](Input& input, bool on) {
            input.rod_counterweight = on ? std::optional(RodCounterweight{}) : std::nullopt;
        });
    for (const bool weights : {true, false}) {
        section({});
        showSectionWhile([weights](const Input& input) {
            return input.rod_counterweight && input.masses_as_weights == weights;
        });
        NumberField* mass =
            number(weights ? "/rod_counterweight/weight_N" : "/rod_counterweight/mass_kg");
        showAssumed(this, mass, [this, weights] {
            return std::optional(model_->result().counterweight_mass *
                                 (weights ? model_->input().gravity : 1.0));
        });
        mass->setDigits(massDigits);
        mass->setObjectName(weights ? QStringLiteral("counterweight_weight")
                                    : QStringLiteral("counterweight_mass"));
    }
    section({});
    showSectionWhile([](const Input& input) { return input.rod_counterweight.has_value(); });
    choice("/rod_counterweight/inertia")->setObjectName(QStringLiteral("counterweight_inertia"));
}

void HingeInputs::addMotion() {
    section(tr("Motion"));
    addFilled("/motion/turns");
    showAssumed(this, number("/motion/start_speed_rad_s"),
                [this] { return std::optional(offSpeed(model_->input())); });
    addFilled("/motion/start_angle_deg");
    addFilled("/motion/crank_torque_Nm");
    flag("/motion/with_profile_error");
}

}  // namespace ravnoves
