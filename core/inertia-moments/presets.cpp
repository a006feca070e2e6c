#include "inertia-moments/presets.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "inertia-moments/fields.h"
#include "inertia-moments/layouts.h"
#include "numerics/demand.h"

namespace ravnoves::inertia_moments {

namespace {

struct RadialSize {
    int cylinders;
    double crank_radius;                       ///< mm
    double knuckle_radius;                     ///< mm
    double speed;                              ///< min⁻¹
    double reciprocating_mass, rotating_mass;  ///< kg
};
constexpr std::array<RadialSize, radial_counts.size()> radial_sizes{
    {{radial_counts[0], 45.0, 34.0, 3000.0, 0.6, 0.4},
     {radial_counts[1], 55.0, 42.0, 2600.0, 1.0, 0.6},
     {radial_counts[2], 70.0, 54.0, 2400.0, 1.8, 1.0},
     {radial_counts[3], 87.3, 67.0, 2200.0, 2.8, 1.6}}};

const RadialSize& radial_size(int cylinders) {
    const auto size = std::ranges::find(radial_sizes, cylinders, &RadialSize::cylinders);
    RAVNOVES_DEMAND(size != radial_sizes.end(), "a radial of the list");
    return *size;
}

/// As a person would enter it.
double tidy(double length) {
    return rounded(length, field::front_position, 5);
}

/// One shaft each way for an order, switched off.
std::vector<Shaft> shafts_off(Balances balances, int order, double crank_radius) {
    std::vector<Shaft> shafts(2);
    for (Shaft& shaft : shafts) {
        shaft.order = order;
        shaft.balances = balances;
        shaft.weight_radius = tidy(crank_radius / 2.0);
        shaft.enabled = false;
    }
    shafts.back().direction = Direction::backward;
    return shafts;
}

}  // namespace

std::pair<double, double> extent(const std::vector<Cylinder>& cylinders) {
    const auto [low, high] = std::ranges::minmax_element(cylinders, {}, &Cylinder::axial_position);
    return {low->axial_position, high->axial_position};
}

EndWebs usual_end_webs(const std::vector<Cylinder>& cylinders, double crank_radius) {
    const auto [low, high] = extent(cylinders);
    EndWebs webs;
    webs.front_position = tidy(high + 0.6 * crank_radius);
    webs.rear_position = tidy(low - 0.6 * crank_radius);
    webs.front_radius = webs.rear_radius = tidy(crank_radius);
    return webs;
}

std::vector<Shaft> usual_shafts(const std::vector<Cylinder>& cylinders, double crank_radius) {
    const auto [low, high] = extent(cylinders);
    std::vector<Shaft> shafts = shafts_off(Balances::moment, 1, crank_radius);
    const auto second = shafts_off(Balances::moment, 2, crank_radius);
    shafts.insert(shafts.end(), second.begin(), second.end());
    for (Shaft& shaft : shafts) {
        shaft.weight_distance = tidy(std::max(high - low, 2.0 * crank_radius));
    }
    return shafts;
}

void follow_sizes(Input& input, const Input& before) {
    if (!input.layout || !before.layout) {
        return;
    }
    const auto follow = [](double& now, double then, double usual_then, double usual_now) {
        constexpr double same = 1e-9;  // m
        if (now == then && std::abs(then - usual_then) < same) {
            now = usual_now;
        }
    };
    const std::vector<Cylinder> then = make_cylinders(before);
    const std::vector<Cylinder> now = make_cylinders(input);
    if (input.end_webs && before.end_webs) {
        const EndWebs usual_then = usual_end_webs(then, before.crank_radius);
        const EndWebs usual_now = usual_end_webs(now, input.crank_radius);
        for (const auto place : {&EndWebs::front_position, &EndWebs::rear_position}) {
            follow((*input.end_webs).*place, (*before.end_webs).*place, usual_then.*place,
                   usual_now.*place);
        }
    }
    const double far_then = usual_shafts(then, before.crank_radius).front().weight_distance;
    const double far_now = usual_shafts(now, input.crank_radius).front().weight_distance;
    for (std::size_t i = 0; i < std::min(input.shafts.size(), before.shafts.size()); ++i) {
        follow(input.shafts[i].weight_distance, before.shafts[i].weight_distance, far_then,
               far_now);
    }
}

Input preset_vw_vr5() {
    Input input;
    input.crank_radius = 45.0 * units::mm;
    input.lambda = 0.265;
    input.angular_speed = 6200.0 * units::rpm;
    input.reciprocating_mass = 0.622;
    input.rotating_mass = 0.8;
    Layout layout;
    layout.name = "vr";
    layout.cylinders = 5;
    layout.bank_angle = 15.0 * units::degree;
    layout.offset = 12.51 * units::mm;
    layout.spacing = 63.0 * units::mm;
    layout.first_position = 204.8 * units::mm;
    layout.firing_order = {1, 2, 4, 5, 3};
    input.layout = layout;
    const std::vector<Cylinder> cylinders = make_cylinders(input);
    input.end_webs = usual_end_webs(cylinders, input.crank_radius);
    input.shafts = usual_shafts(cylinders, input.crank_radius);
    return input;
}

Input preset_radial(int cylinders) {
    const RadialSize& size = radial_size(cylinders);
    Input input;
    input.crank_radius = size.crank_radius * units::mm;
    input.lambda = 0.25;
    input.angular_speed = size.speed * units::rpm;
    input.reciprocating_mass = size.reciprocating_mass;
    input.rotating_mass = size.rotating_mass;
    make_radial(input, cylinders);
    return input;
}

void make_radial(Input& input, int cylinders) {
    const RadialSize& size = radial_size(cylinders);
    const double knuckle_radius =
        tidy(size.knuckle_radius / size.crank_radius * input.crank_radius);
    input.layout.reset();
    input.cylinders.clear();
    input.firing_order.clear();
    input.reference_position = 0.0;
    for (int i = 0; i < cylinders; ++i) {
        // Numbered with the rotation of the crank: cylinder i + 1 comes to the top after i.
        Cylinder& cylinder = input.cylinders.emplace_back();
        cylinder.bank_angle = (360.0 / cylinders) * i * units::degree;
        if (i > 0) {
            ArticulatedRod& rod = cylinder.articulated.emplace();
            rod.knuckle_radius = knuckle_radius;
            rod.master = 1;
            rod.knuckle_mass = input.rotating_mass / 2.0;
        }
        input.firing_order.push_back(2 * i % cylinders + 1);  // every other one: the count is odd
    }
    input.end_webs = usual_end_webs(input.cylinders, input.crank_radius);
    input.end_webs->first_order_share = 1.0;
    input.shafts = shafts_off(Balances::force, 2, input.crank_radius);
}

std::vector<Preset<Input>> presets() {
    std::vector<Preset<Input>> list{{"Volkswagen VR5", preset_vw_vr5()}};
    for (const int count : radial_counts) {
        list.push_back({{Text::tr("Radial engine, %1 cylinders"), count}, preset_radial(count)});
    }
    return list;
}

}  // namespace ravnoves::inertia_moments
