#include "shop/balance_grade.h"

#include <algorithm>
#include <cmath>

namespace ravnoves::shop {

std::span<const BalanceGrade> balance_grades() {
    static constexpr BalanceGrade grades[] = {
        {4000, CORE_TEXT("workshop",
                         "Large slow marine diesels whose crank drive is inherently unbalanced")},
        {1600, CORE_TEXT("workshop",
                         "Large slow marine diesels whose crank drive is inherently balanced")},
        {630, CORE_TEXT("workshop", "Crank drives inherently unbalanced, on elastic mounts")},
        {250, CORE_TEXT("workshop", "Crank drives inherently unbalanced, rigidly mounted")},
        {100, CORE_TEXT("workshop", "Complete engines of cars, trucks and locomotives")},
        {40, CORE_TEXT("workshop",
                       "Crank drives inherently balanced, on elastic mounts; wheels and drive "
                       "shafts of cars")},
        {16,
         CORE_TEXT("workshop", "Crank drives inherently balanced, rigidly mounted; cardan shafts")},
        {6.3, CORE_TEXT("workshop", "Machinery in general: flywheels, pumps, fans, turbochargers")},
        {2.5, CORE_TEXT("workshop", "Gas and steam turbines, machine-tool drives")},
        {1, CORE_TEXT("workshop", "Grinding machine drives")},
        {0.4, CORE_TEXT("workshop", "Spindles of high-precision machines, gyroscopes")}};
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
    return {CORE_TEXT("workshop", "Permissible residual unbalance"), "U = 1000 m G / ω",
            "iso-21940-11", "",
            CORE_TEXT("workshop",
                      "g·mm with the mass m in kg, the grade G in mm/s and the service speed ω in "
                      "rad/s")};
}

}  // namespace ravnoves::shop
