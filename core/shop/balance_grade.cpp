#include "shop/balance_grade.h"

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

Formula permissible_unbalance_formula() {
    return {CORE_TEXT("workshop", "Permissible residual unbalance"), "U = 1000 m G / ω",
            "iso-21940-11", "",
            CORE_TEXT("workshop",
                      "g·mm with the mass m in kg, the grade G in mm/s and the service speed ω in "
                      "rad/s")};
}

}  // namespace ravnoves::shop
