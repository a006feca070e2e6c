#include "balance-shaft/envelope.h"

#include <algorithm>
#include <limits>

#include "balance-shaft/fields.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

namespace {

/// Of steel, as long as the bore.
double half_disc_radius(double unbalance, double bore) {
    return std::cbrt(1.5 * unbalance / (steel_density * bore));
}

/// The nearest size that the field may have.
double within(const Field& field, double metres) {
    return std::clamp(from_si(field, metres), field.range.min, field.range.max) * field.unit;
}

}  // namespace

FrontView front_view(const Input& input) {
    const EnvelopeSizes& sizes = input.envelope;
    FrontView view{};
    view.crank_radius = input.crank_radius;
    view.rod_length = input.effective_rod_length();
    view.offset = input.cylinder.offset;
    view.counterweight_radius = input.counterweight_radius;
    view.cylinder_bore = input.effective_bore();
    view.cylinder_wall = sizes.cylinder_wall.value_or(0.06 * view.cylinder_bore);
    const SliderCrank<double> crank = view.crank();
    view.cylinder_top =
        sizes.cylinder_top.value_or(crank.at(crank.top_dead_centre()).s + view.cylinder_bore / 2.0);
    view.cylinder_bottom = sizes.cylinder_bottom.value_or(crank.at(crank.bottom_dead_centre()).s -
                                                          0.3 * view.cylinder_bore);
    view.rod_width = sizes.rod_width.value_or(view.crank_radius / 2.0);
    const double unbalance = input.unbalance();
    const double half_disc = half_disc_radius(unbalance, view.cylinder_bore);
    view.crank_swing_radius = sizes.crank_swing_radius.value_or(
        std::max(view.crank_radius + view.rod_width / 2.0, half_disc));
    double shaft_radius = half_disc;
    if (input.relieved_shaft) {
        const double bar = design_relieved_shaft(*input.relieved_shaft, unbalance).diameter / 2.0;
        shaft_radius = bar > 0.0 ? bar : half_disc;
    }
    view.shaft_swing_radius = sizes.shaft_swing_radius.value_or(shaft_radius);
    view.centre_distance = input.centre_distance;
    view.gear_pitch_radius = view.centre_distance / 2.0;
    view.gear_tip_radius = sizes.gear_tip_radius.value_or(view.gear_pitch_radius);
    view.tip_follows_distance = !sizes.gear_tip_radius;
    view.gear_teeth = input.gears.teeth;
    view.clearance = sizes.clearance;
    view.wall = sizes.wall;
    return view;
}

RelievedShaftSizes relieved_shaft_sizes(const Input& input) {
    if (input.relieved_shaft) {
        return *input.relieved_shaft;
    }
    const double bore = input.effective_bore();
    const double unbalance = input.unbalance();
    const double half_disc = half_disc_radius(unbalance, bore);
    const double radius =
        input.envelope.shaft_swing_radius.value_or(half_disc > 0.0 ? half_disc : bore / 2.0);
    return {.diameter = within(field::bar_diameter, 2.0 * radius),
            .length =
                within(field::relief_length, std::max(bore, half_disc_length(radius, unbalance)))};
}

Message assumed_sizes(const Input& input) {
    const FrontView view = front_view(input);
    Message sizes;
    const auto add = [&](const std::optional<double>& given, const Text& name, double value) {
        if (!given) {
            const Message one(Text{"%1 %2"}, name, Number{value / units::mm, units::mm, 3});
            sizes = sizes.empty() ? one : joined(sizes, one);
        }
    };
    const EnvelopeSizes& given = input.envelope;
    if (!input.relieved_shaft) {
        add(given.shaft_swing_radius, Text::tr("swing radius of the shaft"),
            view.shaft_swing_radius);
    }
    add(given.crank_swing_radius, Text::tr("swing radius of the crank"), view.crank_swing_radius);
    add(given.rod_width, Text::tr("width of the rod"), view.rod_width);
    add(input.cylinder.bore, Text::tr("bore"), view.cylinder_bore);
    add(given.cylinder_wall, Text::tr("wall of the cylinder"), view.cylinder_wall);
    add(given.cylinder_bottom, Text::tr("lower end of the cylinder"), view.cylinder_bottom);
    return sizes.empty() ? sizes : Message(Text::tr("Sizes not given are assumed: %1."), sizes);
}

Envelope envelope(const FrontView& view, const Eigen::Vector2d& shaft) {
    const Eigen::Vector2d none(0.0, 0.0);
    const double l = shaft.norm();
    const bool follows = view.tip_follows_distance;
    const double tip = follows ? l / 2.0 : view.gear_tip_radius;
    struct Reach {
        double value;
        Eigen::Vector2d gradient;
    };
    const auto circle = [&](double swing) -> Reach {
        return {std::max(swing, tip) + view.wall,
                tip > swing && follows ? Eigen::Vector2d(shaft / (2.0 * l)) : none};
    };
    const Reach of_crank = circle(view.crank_swing_radius);
    const Reach of_shaft = circle(view.shaft_swing_radius);
    // How far everything reaches in a direction; the cylinder not downwards.
    const auto reach = [&](const Eigen::Vector2d& along, double cylinder) -> Reach {
        Reach maximum{along.dot(shaft) + of_shaft.value, along + of_shaft.gradient};
        maximum = of_crank.value > maximum.value ? of_crank : maximum;
        return cylinder > maximum.value ? Reach{cylinder, none} : maximum;
    };
    const double wide = view.cylinder_half_width() + view.wall;
    const Reach right = reach({1.0, 0.0}, view.offset + wide);
    const Reach left = reach({-1.0, 0.0}, wide - view.offset);
    const Reach top = reach({0.0, 1.0}, view.cylinder_top + view.wall);
    const Reach bottom = reach({0.0, -1.0}, -std::numeric_limits<double>::infinity());
    return {-left.value,
            right.value,
            -bottom.value,
            top.value,
            right.gradient + left.gradient,
            top.gradient + bottom.gradient};
}

}  // namespace ravnoves::balance_shaft
