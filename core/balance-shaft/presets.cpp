#include "balance-shaft/presets.h"

namespace ravnoves::balance_shaft {

Input preset_tmz_650d() {
    Input input;
    input.angular_speed = 376.8;  // as printed: 3600 min⁻¹ with π ≈ 3.14
    input.speed_in_rpm = false;
    input.crank_radius = 0.046;
    input.reciprocating_masses = {
        {"piston", 0.645}, {"pin", 0.241}, {"rings", 0.1}, {"rod_small_end", 0.33}};
    input.rod_mass = 0.950;
    input.counterweight_radius = 0.046;
    input.centre_distance = 0.10015;
    input.shaft_angle = 45.0 * degree;
    input.cylinder.bore = 0.0955;
    // Table 2, every 15°.
    input.torque.table.torque = {0,    -90,  -140, -130,  -72,    5,    67,   97,   96,  76,
                                 49,   24,   0,    -0.73, -0.154, -79,  -106, -122, -96, -80,
                                 -28,  -44,  -155, -315,  0,      893,  798,  503,  360, 290,
                                 261,  227,  188,  135,   82,     37,   0,    30,   -57, -97,
                                 -111, -129, -88,  -29,   -56,    -122, -126, -88,  0};
    for (int i = 0; i <= 48; ++i) {
        input.torque.table.crank_angle_deg.push_back(15.0 * i);
    }
    return input;
}

std::vector<Preset<Input>> presets() {
    return {{"TMZ-650D", preset_tmz_650d()}};
}

}  // namespace ravnoves::balance_shaft
