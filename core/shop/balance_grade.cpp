#include "shop/balance_grade.h"

#include <algorithm>
#include <cmath>

namespace ravnoves::shop {

std::span<const BalanceGrade> balance_grades() {
    static constexpr BalanceGrade grades[] = {
        {4000, Text::tr("Large slow marine diesels whose crank drive is inherently unbalanced")},
        {1600, Text::tr("Large slow marine diesels whose crank drive is inherently balanced")},
        {630, Text::tr("Crank drives inherently unbalanced, on elastic mounts")},
        {250, Text::tr("Crank drives inherently unbalanced, rigidly mounted")},
        {100, Text::tr("Complete engines of cars, trucks and locomotives")},
        {40, Text::tr("Crank drives inherently balanced, on elastic mounts; wheels and drive "
                      "shafts of cars")},
        {16, Text::tr("Crank drives inherently balanced, rigidly mounted; cardan shafts")},
        {6.3, Text::tr("Machinery in general: flywheels, pumps, fans, turbochargers")},
        {2.5, Text::tr("Gas and steam turbines, machine-tool drives")},
        {1, Text::tr("Grinding machine drives")},
        {0.4, Text::tr("Spindles of high-precision machines, gyroscopes")}};
    return grades;
}

bool is_plausible_grade(double grade, const std::optional<double>& rotor_mass) {
    constexpr double any_up_to = 16.0;  // mm/s
    constexpr double of_cars = 100.0;   // mm/s
    constexpr double large = 500.0;     // kg
    const double mm_per_s = grade / units::mm_per_s;
    const bool is_large = rotor_mass.value_or(0.0) > large;
    return mm_per_s <= any_up_to ||
           std::ranges::any_of(balance_grades(), [&](const BalanceGrade& each) {
               return std::abs(each.mm_per_s / mm_per_s - 1.0) < 1e-6 &&
                      (each.mm_per_s <= of_cars || is_large);
           });
}

Formula permissible_unbalance_formula() {
    return {Text::tr("Permissible residual unbalance"), "U = 1000 m G / ω", "iso-21940-11", "",
            Text::tr("g·mm with the mass m in kg, the grade G in mm/s and the service speed ω in "
                     "rad/s")};
}

}  // namespace ravnoves::shop
