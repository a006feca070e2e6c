#pragma once

#include <QStringList>

#include "shop/kilograms.h"
#include "shop/model/words.h"

namespace ravnoves {

/// "piston of cylinder 3"
QString partOfCylinder(const Words& words, shop::Part part, std::size_t cylinder);
QString rodOfCylinder(const Words& words, std::size_t cylinder);
/// "Weigh again first: piston of cylinder 3; rod of cylinder 5."; empty without parts.
QString weighAgainText(const Words& words, const QStringList& parts);

/// What is to be weighed again before anything is done by the weights of a sheet: what is unlike
/// the others of its column, and rods whose ends are swapped. Empty where the weights are believed.
template <typename Sheet>
QString weighAgainText(const Words& words, const Sheet& sheet) {
    using shop::Part;
    QStringList parts;
    const auto swapped =
        shop::swapped_rod_ends(sheet[Part::rod_big_end].mass, sheet[Part::rod_small_end].mass);
    for (const Part part : shop::all_parts) {
        if (!swapped.empty() && (part == Part::rod_big_end || part == Part::rod_small_end)) {
            continue;  // whole rods are named below
        }
        if (const auto odd = shop::odd_mass(sheet[part].nominal, sheet[part].mass)) {
            for (const std::size_t cylinder : odd->cylinders()) {
                parts << partOfCylinder(words, part, cylinder);
            }
        }
    }
    for (const std::size_t cylinder : swapped) {
        parts << rodOfCylinder(words, cylinder);
    }
    return weighAgainText(words, parts);
}

}  // namespace ravnoves
