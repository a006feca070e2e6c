#include "balance-shaft/envelope.h"

#include <algorithm>
#include <cmath>

namespace ravnoves::balance_shaft {

FrontView front_view(const Input& input) {
    FrontView view{};
    view.crank_radius = input.crank_radius;
    view.rod_length = input.effective_rod_length();
    view.counterweight_radius = input.counterweight_radius;
    view.centre_distance = input.centre_distance;
    const double known_bore =
        input.torque.is_computed() ? input.torque.cylinder.bore : 2.0 * view.crank_radius;
    view.cylinder_bore = input.envelope.cylinder_bore.value_or(known_bore);
    view.cylinder_top = input.envelope.cylinder_top.value_or(view.crank_radius + view.rod_length +
                                                             view.cylinder_bore / 2.0);
    constexpr double swing = 1.3;  // circle swept against the radius of the centre of mass
    view.crank_swing_radius = input.envelope.crank_swing_radius.value_or(
        swing * std::max(view.crank_radius, view.counterweight_radius));
    view.shaft_swing_radius =
        input.envelope.shaft_swing_radius.value_or(swing * view.counterweight_radius);
    view.gear_pitch_radius = view.centre_distance / 2.0;
    view.gear_tip_radius = input.envelope.gear_tip_radius.value_or(view.gear_pitch_radius);
    view.wall = input.envelope.wall;
    return view;
}

Envelope envelope(const FrontView& view, double shaft_angle) {
    const double crank = std::max(view.crank_swing_radius, view.gear_tip_radius) + view.wall;
    const double shaft = std::max(view.shaft_swing_radius, view.gear_tip_radius) + view.wall;
    const double x = view.centre_distance * std::sin(shaft_angle);
    const double y = view.centre_distance * std::cos(shaft_angle);
    const double cylinder = view.cylinder_bore / 2.0 + view.wall;
    return {std::min({-crank, x - shaft, -cylinder}), std::max({crank, x + shaft, cylinder}),
            std::min(-crank, y - shaft),
            std::max({crank, y + shaft, view.cylinder_top + view.wall})};
}

}  // namespace ravnoves::balance_shaft
