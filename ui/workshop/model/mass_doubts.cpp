#include "workshop/model/mass_doubts.h"

#include "numerics/units.h"
#include "shop/balance_grade.h"

namespace ravnoves {

QString kilogramText(const Words& words, const QString& name, double mass) {
    return words.translate("Workshop", "%1: %2 looks like kilograms; masses are in %3.")
        .arg(name, words.number(mass, units::gram, 3), words.unit(units::gram));
}

QStringList rotorTexts(const Words& words, const std::optional<double>& rotor_mass,
                       const std::optional<double>& service_speed) {
    QStringList list;
    if (shop::is_mass_in_grams(rotor_mass)) {
        list << words.translate("Workshop", "%1: %2 looks like grams; it is in kilograms.")
                    .arg(words.name(shop::field::rotor_mass),
                         words.plainWithUnit(*rotor_mass, units::kg, 0));
    }
    if (shop::is_odd_speed(service_speed)) {
        list << words
                    .translate("Workshop",
                               "%1: no engine runs at %2 in service; look at the decimal sign.")
                    .arg(words.name(shop::field::service_speed),
                         words.plainWithUnit(*service_speed, units::rpm, 1));
    }
    return list;
}

QString oddMassText(const Words& words, shop::Part part, const shop::OddMass& odd) {
    const QString name = words.text(shop::part_word(part).label);
    const auto grams = [&](double mass) { return words.plainWithUnit(mass, units::gram, 3); };
    if (!odd.also.empty()) {
        QStringList cylinders;
        for (const std::size_t cylinder : odd.cylinders()) {
            cylinders << QString::number(cylinder + 1);
        }
        return words
            .translate("Workshop",
                       "%1: cylinders %2 are unlike the others (%3 against %4); are they mistyped?")
            .arg(name, cylinders.join(QStringLiteral(", ")), grams(odd.mass), grams(odd.usual));
    }
    const double ratio = odd.mass / odd.usual;
    const QString said =
        ratio > 3.0 || ratio < 1.0 / 3.0
            ? words.translate(
                  "Workshop",
                  "%1: cylinder %2 weighs %3, the others about %4; look at the decimal sign.")
            : words.translate("Workshop",
                              "%1: cylinder %2 weighs %3, the others about %4; is it mistyped?");
    const QString text =
        said.arg(name).arg(odd.cylinder + 1).arg(grams(odd.mass), grams(odd.usual));
    return odd.score
               ? text + QLatin1Char(' ') +
                     words.translate("Workshop", "Deviation: %1 times the scatter of the others.")
                         .arg(words.plain(*odd.score, 0))
               : text;
}

QStringList swappedEndsTexts(const Words& words, std::span<const shop::Weighed> big_ends,
                             std::span<const shop::Weighed> small_ends) {
    QStringList cylinders;
    for (const std::size_t cylinder : shop::swapped_rod_ends(big_ends, small_ends)) {
        cylinders << QString::number(cylinder + 1);
    }
    if (cylinders.isEmpty()) {
        return {};
    }
    return {words
                .translate("Workshop",
                           "Rod of cylinder %1: the big end weighs less than the small end; are "
                           "the two swapped?")
                .arg(cylinders.join(QStringLiteral(", ")))};
}

}  // namespace ravnoves
