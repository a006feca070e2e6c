#pragma once

#include <QStringList>
#include <optional>

#include "shop/kilograms.h"
#include "workshop/model/words.h"

namespace ravnoves {

/// "Piston: 0.584 g looks like kilograms; masses are in g."
QString kilogramText(const Words& words, const QString& name, double mass);
/// "Piston: cylinder 3 weighs 5840 g, the others about 584 g; look at the decimal sign."
QString oddMassText(const Words& words, shop::Part part, const shop::OddMass& odd);

/// "Rod of cylinder 3: the big end weighs less than the small end; are the two swapped?"
QStringList swappedEndsTexts(const Words& words, std::span<const shop::Weighed> big_ends,
                             std::span<const shop::Weighed> small_ends);

/// What of a crankshaft's mass, kg, and its speed in service, rad/s, was mistyped, as it seems;
/// then more may remain than is meant.
QStringList rotorTexts(const Words& words, const std::optional<double>& rotor_mass,
                       const std::optional<double>& service_speed);

/// Weights of a sheet that are unlike the others of their column, or in the other end's; one that
/// looks like kilograms is said as such.
template <typename Sheet>
QStringList oddMassTexts(const Words& words, const Sheet& sheet) {
    QStringList list;
    for (const shop::Part part : shop::all_parts) {
        const auto& column = sheet[part];
        const auto odd = shop::odd_mass(column.nominal, column.mass);
        if (odd && !shop::mass_in_kilograms(part, column.nominal, column.mass)) {
            list << oddMassText(words, part, *odd);
        }
    }
    return list + swappedEndsTexts(words, sheet[shop::Part::rod_big_end].mass,
                                   sheet[shop::Part::rod_small_end].mass);
}

}  // namespace ravnoves
