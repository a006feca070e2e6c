#include "text/preferences.h"

#include <QSettings>
#include <algorithm>

#include "text/language.h"

namespace ravnoves {

namespace {
const QString digitsKey = QStringLiteral("view/digits");

QString unitsKey(std::size_t quantity) {
    static const std::array names{"length", "mass", "torque", "force", "speed", "unbalance"};
    return QStringLiteral("units/") + QLatin1String(names.at(quantity));
}

}  // namespace

Preferences& Preferences::instance() {
    static Preferences preferences;
    return preferences;
}

void Preferences::load() {
    const int digits = QSettings().value(digitsKey, 0).toInt();
    digits_ = digits < fewestDigits ? 0 : std::min(digits, maxDigits);
    for (std::size_t i = 0; i < units_.size(); ++i) {
        const int chosen = QSettings().value(unitsKey(i), 0).toInt();
        units_[i] = chosen >= 0 && chosen <= static_cast<int>(Units::OunceInch)
                        ? static_cast<Units>(chosen)
                        : Units::Own;
    }
}

void Preferences::setUnits(Quantity quantity, Units units) {
    Q_EMIT aboutToChange();
    units_[static_cast<std::size_t>(quantity)] = units;
    QSettings().setValue(unitsKey(static_cast<std::size_t>(quantity)), static_cast<int>(units));
    Q_EMIT changed();
}

void Preferences::setDigits(int digits) {
    Q_EMIT aboutToChange();
    digits_ = digits;
    QSettings().setValue(digitsKey, digits);
    Q_EMIT changed();
}

void Preferences::setLanguage(const QString& code) {
    Q_EMIT aboutToChange();
    setChosenLanguage(code);
    installLanguage();
    Q_EMIT changed();
}

}  // namespace ravnoves
