#include "elastic-hinge/presets.h"

namespace ravnoves::elastic_hinge {

Input preset_zotov() {
    Input input;
    input.gravity = 9.82;
    input.crank_mass = 5.0 / 9.82;
    input.rod_mass = 6.5 / 9.82;
    input.slider_mass = 6.0 / 9.82;
    input.crank_radius = 0.05;
    input.lambda = 0.3;
    input.angular_speed = 100.0;
    input.spring = Spring{2e7, 0.2, 0.09};
    return input;
}

}  // namespace ravnoves::elastic_hinge
