#include "elastic-hinge/presets.h"

#include "elastic-hinge/fields.h"

namespace ravnoves::elastic_hinge {

Input preset_zotov() {
    Input input;
    input.gravity = 9.82;
    const Unit newton = field::as_weight({}, input.gravity).unit;
    input.crank_mass = 5.0 * newton;
    input.rod_mass = 6.5 * newton;
    input.slider_mass = 6.0 * newton;
    input.crank_radius = 0.05;
    input.lambda = 0.3;
    input.angular_speed = 100.0;
    input.spring = Spring{};
    return input;
}

std::vector<Preset<Input>> presets() {
    return {{Text::tr("Zotov and Sviridov 2021"), preset_zotov()}};
}

}  // namespace ravnoves::elastic_hinge
