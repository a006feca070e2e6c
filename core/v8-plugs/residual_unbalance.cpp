#include "v8-plugs/residual_unbalance.h"

#include "shop/balance_grade.h"

namespace ravnoves::v8_plugs {

PlaneVerdict judge(double limit, const std::optional<double>& reading) {
    return {limit, reading,
            reading ? std::optional(shop::is_within(*reading, limit)) : std::nullopt};
}

BalancingVerdict judge(const BalancingCheck& check) {
    const double permissible =
        shop::permissible_unbalance(check.rotor_mass, check.grade, check.service_speed);
    return {permissible, judge(permissible * check.front_share, check.front_reading),
            judge(permissible * (1.0 - check.front_share), check.rear_reading)};
}

}  // namespace ravnoves::v8_plugs
