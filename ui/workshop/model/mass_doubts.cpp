#include "workshop/model/mass_doubts.h"

#include "numerics/units.h"

namespace ravnoves {

QString kilogramText(const Words& words, const QString& name, double mass) {
    return words.translate("Workshop", "%1: %2 looks like kilograms; masses are in grams.")
        .arg(name, words.number(mass, units::gram, 3));
}

QString oddMassText(const Words& words, workshop::Part part, const workshop::OddMass& odd) {
    return words
        .translate("Workshop",
                   "%1: cylinder %2 weighs %3, the others about %4; look at the decimal sign.")
        .arg(words.text(workshop::part_word(part).label))
        .arg(odd.cylinder + 1)
        .arg(words.plainWithUnit(odd.mass, units::gram, 3),
             words.plainWithUnit(odd.usual, units::gram, 3));
}

}  // namespace ravnoves
