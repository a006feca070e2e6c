#include "shop/model/scale_settings.h"

#include <QSettings>
#include <array>
#include <cmath>

namespace ravnoves {

const Unit& ScaleSettings::unit() const {
    static constexpr std::array<Unit, 4> list{units::gram, units::kg, units::ounce, units::pound};
    return list.at(usualUnit);
}

ScaleSettings ScaleSettings::load() {
    QSettings settings;
    settings.beginGroup(QStringLiteral("scale"));
    // What makes no sense is the usual.
    const auto choice = [&](const QString& key, int last) {
        const int value = settings.value(key, 0).toInt();
        return value >= 0 && value <= last ? value : 0;
    };
    ScaleSettings kept;
    kept.port = settings.value(QStringLiteral("port")).toString();
    if (const int baud = settings.value(QStringLiteral("baud")).toInt(); baud > 0) {
        kept.baud = baud;
    }
    kept.parity = static_cast<Parity>(choice(QStringLiteral("parity"), Odd8));
    kept.usualUnit = static_cast<UsualUnit>(choice(QStringLiteral("unit"), Pound));
    kept.taking = static_cast<Taking>(choice(QStringLiteral("taking"), EachPart));
    const double resolution = settings.value(QStringLiteral("resolution_kg")).toDouble();
    kept.resolution = std::isfinite(resolution) && resolution > 0.0 ? resolution : 0.0;
    return kept;
}

void ScaleSettings::save() const {
    QSettings settings;
    settings.beginGroup(QStringLiteral("scale"));
    settings.setValue(QStringLiteral("port"), port);
    settings.setValue(QStringLiteral("baud"), baud);
    settings.setValue(QStringLiteral("parity"), static_cast<int>(parity));
    settings.setValue(QStringLiteral("unit"), static_cast<int>(usualUnit));
    settings.setValue(QStringLiteral("taking"), static_cast<int>(taking));
    settings.setValue(QStringLiteral("resolution_kg"), resolution);
}

}  // namespace ravnoves
