#pragma once

#include <QStringList>

#include "balance-shaft/model/shaft_map_model.h"

namespace ravnoves {
struct CsvFormat;
}

/// What the map of places says as text, and its field as a table.
namespace ravnoves::shaft_map_text {

/// What is best, and what a place that cannot be built would gain.
QString best(const ShaftMapModel& map);
/// What is best in another map by the criterion of this one, and this one's best against it.
QString bestAgainst(const ShaftMapModel& map, const ShaftMapModel& other, const QString& name);
/// One place: l, α, range, RMS, change, size, and why it cannot be built.
/// @param decimals  of l and α; 2 name a place of ShaftMapModel::shortened()
QString place(const ShaftMapModel& map, const ShaftMapModel::Position& position, int decimals = 2);
/// The same but for the reason, a line each.
QStringList placeLines(const ShaftMapModel& map, const ShaftMapModel::Position& position,
                       int decimals = 2);
/// What the place gives here against what it gives in another map, the difference of each.
QString placeAgainst(const ShaftMapModel& map, const ShaftMapModel& other, const QString& name,
                     const ShaftMapModel::Position& position);
/// Why the shaft cannot be built there; empty where it can.
QString reason(const ShaftMapModel& map, const ShaftMapModel::Position& position);

/// Range, RMS and whether it can be built over a grid of places.
QString fieldCsv(const ShaftMapModel& map, const CsvFormat& format);

}  // namespace ravnoves::shaft_map_text
