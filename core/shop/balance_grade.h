#pragma once

#include <optional>
#include <span>

#include "bibliography/formula.h"
#include "case-file/field.h"

namespace ravnoves::shop {

/// What a balance quality grade G = e ω of [iso-21940-11] is for, as far as it concerns engines.
struct BalanceGrade {
    double mm_per_s;
    Text use;
};
/// The grades from the coarsest to the finest.
std::span<const BalanceGrade> balance_grades();

/// U_per = m G / ω of the whole rotor, kg·m.
constexpr double permissible_unbalance(double rotor_mass, double grade, double service_speed) {
    return rotor_mass * grade / service_speed;
}

/// Whether an unbalance is within its limit, but for rounding.
constexpr bool is_within(double unbalance, double permissible) {
    constexpr double rounding = 1e-9;
    return unbalance <= permissible * (1.0 + rounding);
}

/// The same; nothing where there is no limit.
inline std::optional<bool> is_within(double unbalance, const std::optional<double>& permissible) {
    return permissible ? std::optional(is_within(unbalance, *permissible)) : std::nullopt;
}

/// Whether a crankshaft may be balanced to the grade, mm/s as m/s: any up to 16, above it the
/// grades of the standard, above 100 only for shafts of large engines.
bool is_plausible_grade(double grade, const std::optional<double>& rotor_mass);

/// permissible_unbalance() as a report prints it.
Formula permissible_unbalance_formula();

namespace field {

inline constexpr Field grade{
    .key = "grade_mm_s",
    .range = Range::between(0.1, 10'000),
    .label = Text::tr("&Grade G"),
    .hint = Text::tr("Balance quality grade of ISO 21940-11, 0.4 to 4000 mm/s. Engines of cars, "
                     "trucks and locomotives: G 100; inherently balanced crankshafts: better.")};
inline constexpr Field rotor_mass{
    .key = "rotor_mass_kg",
    .range = Range::between(0.1, 100'000),
    .label = Text::tr("&Mass with bob weights"),
    .hint = Text::tr("Mass of crankshaft and bob weights on the machine.")};
inline constexpr Field service_speed{
    .key = "service_speed_rpm",
    .range = Range::between(1, 100'000),
    .label = Text::tr("Service s&peed"),
    .hint = Text::tr("Maximum speed in service, not the speed of the machine.")};

}  // namespace field
}  // namespace ravnoves::shop
