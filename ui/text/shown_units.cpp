#include "text/shown_units.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

#include "text/number_text.h"
#include "text/preferences.h"

namespace ravnoves {

namespace {

using System = Preferences::Units;

/// A unit that gives way to another where the user wants that.
struct Change {
    Preferences::Quantity quantity;
    System system;  ///< what the user wants
    Unit own;
    Unit shown;
    int decimals;  ///< that numbers in it need more
};

const std::array changes{
    // Before that of the masses.
    Change{Preferences::Unbalance, System::GramMillimetre, units::gram_mm, units::gram_mm, 0},
    Change{Preferences::Unbalance, System::GramInch, units::gram_mm, units::gram_inch, 1},
    Change{Preferences::Unbalance, System::OunceInch, units::gram_mm, units::ounce_inch, 3},
    Change{Preferences::Length, System::Imperial, units::mm, units::inch, 2},
    Change{Preferences::Length, System::Imperial, units::micrometre, units::mil, 2},
    Change{Preferences::Length, System::Imperial, units::metre, units::foot, 0},
    Change{Preferences::Length, System::Imperial, units::cm2, units::inch2, 1},
    Change{Preferences::Length, System::Imperial, units::cm3, units::inch3, 1},
    Change{Preferences::Mass, System::Gram, units::kg, units::gram, -3},
    Change{Preferences::Mass, System::Imperial, units::kg, units::pound, 0},
    Change{Preferences::Mass, System::Imperial, units::gram, units::ounce, 2},
    Change{Preferences::Mass, System::Imperial, units::gram_mm, units::ounce_inch, 3},
    Change{Preferences::Mass, System::Imperial, units::kg_m3, units::lb_per_ft3, 1},
    Change{Preferences::Mass, System::Imperial, units::kg_m2, units::lb_ft2, -1},
    Change{Preferences::Torque, System::Imperial, units::N_m, units::lb_ft, 0},
    Change{Preferences::Force, System::Imperial, units::newton, units::pound_force, 1},
    Change{Preferences::Force, System::Imperial, units::kN, units::pound_force, -2},
    Change{Preferences::Force, System::Own, units::N_per_m, units::kN_per_m, 3},
    Change{Preferences::Force, System::Imperial, units::N_per_m, units::lbf_per_inch, 2},
    Change{Preferences::Force, System::Imperial, units::kN_per_m, units::lbf_per_inch, 0},
    Change{Preferences::Speed, System::RadPerSecond, units::rpm, units::rad_per_s, 1},
    Change{Preferences::Speed, System::Rpm, units::rad_per_s, units::rpm, -1},
};

const Change* changeOf(const auto& isOwn) {
    const auto found = std::find_if(changes.begin(), changes.end(), [&](const Change& change) {
        return Preferences::instance().units(change.quantity) == change.system && isOwn(change.own);
    });
    return found == changes.end() ? nullptr : &*found;
}

/// Kilograms that are wanted as they are.
bool staysInKilograms(const Field& field) {
    constexpr double minOfRotors = 0.1;  // kg; parts may weigh next to nothing
    return field.unit.name == units::kg.name && field.range.min >= minOfRotors &&
           Preferences::instance().units(Preferences::Mass) == System::Gram;
}

ShownUnit shown(const Change& change) {
    return {unitText(change.shown.name), change.own.to_si / change.shown.to_si, change.decimals};
}

}  // namespace

ShownUnit shownUnit(const Unit& unit) {
    const Change* change = changeOf([&](const Unit& own) { return own.name == unit.name; });
    return change != nullptr ? shown(*change) : ShownUnit{unitText(unit.name)};
}

ShownUnit shownUnit(const Field& field) {
    return staysInKilograms(field) ? ShownUnit{unitText(field.unit.name)} : shownUnit(field.unit);
}

ShownUnit shownUnit(const QString& name) {
    const Change* change = changeOf([&](const Unit& own) { return unitText(own.name) == name; });
    return change != nullptr ? shown(*change) : ShownUnit{name};
}

Unit shownAs(const Unit& unit) {
    const Change* change = changeOf([&](const Unit& own) { return own.name == unit.name; });
    // Newtons may stand for the mass that weighs so much.
    return change != nullptr
               ? Unit{change->shown.name, unit.to_si * (change->shown.to_si / change->own.to_si)}
               : unit;
}

Unit shownAs(const Field& field) {
    return staysInKilograms(field) ? field.unit : shownAs(field.unit);
}

QString titleWithUnit(const QString& name, const QString& unit) {
    return unit.isEmpty() ? name : name + QStringLiteral(", ") + unit;
}

QString unitOfTitle(const QString& title) {
    const qsizetype comma = title.lastIndexOf(QStringLiteral(", "));
    if (comma >= 0) {
        return title.mid(comma + 2);
    }
    return std::any_of(changes.begin(), changes.end(),
                       [&](const Change& change) {
                           return unitText(change.own.name) == title ||
                                  unitText(change.shown.name) == title;
                       })
               ? title
               : QString();
}

ShownTitle shownTitle(const QString& title) {
    const QString own = unitOfTitle(title);
    if (own.isEmpty()) {
        return {title};
    }
    const ShownUnit unit = shownUnit(own);
    return {title.chopped(own.size()) + unit.name, unit.factor, unit.decimals};
}

double shownValue(double si, const Unit& unit) {
    return si / unit * shownUnit(unit).factor;
}

QString shownDigits(double si, const Unit& unit, int decimals) {
    const ShownUnit shown = shownUnit(unit);
    return fixedNumber(si / unit * shown.factor, std::max(0, decimals + shown.decimals), QLocale());
}

QString shownFigures(double si, const Unit& unit, int digits) {
    const double value = shownValue(si, unit);
    // Written out where a power of ten would be no shorter; grams of what weighs kilograms longer.
    const double longest = shownUnit(unit).factor != 1.0 ? 1e8 : 1e6;
    const bool isLong = std::abs(value) < longest && std::abs(value) >= std::pow(10.0, digits);
    return isLong ? fixedDecimals(value, 0, QLocale()) : formNumber(value, QLocale(), digits);
}

QString shownShort(double si, const Unit& unit, int digits) {
    return withUnit(shownFigures(si, unit, digits), shownUnit(unit).name);
}

QString shownNumber(double si, const Unit& unit, int decimals) {
    return withUnit(shownDigits(si, unit, decimals), shownUnit(unit).name);
}

}  // namespace ravnoves
