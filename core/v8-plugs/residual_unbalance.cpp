#include "v8-plugs/residual_unbalance.h"

namespace ravnoves::v8_plugs {

BalancingVerdict judge(const BalancingCheck& check) {
    const double permissible = check.rotor_mass * check.grade / check.service_speed;
    const auto plane = [](double limit, const std::optional<double>& reading) {
        PlaneVerdict verdict{limit, reading, std::nullopt};
        if (reading) {
            verdict.passes = *reading <= limit;
        }
        return verdict;
    };
    return {permissible, plane(permissible * check.front_share, check.front_reading),
            plane(permissible * (1.0 - check.front_share), check.rear_reading)};
}

}  // namespace ravnoves::v8_plugs
