#pragma once

#include <QStringList>

#include "balance-shaft/model/shaft_map_model.h"

namespace ravnoves {
struct CsvFormat;
}

/// What the map of places says as text, and its field as a table.
namespace ravnoves::shaft_map_text {

/// The best place, and the gain of an infeasible one.
QString best(const ShaftMapModel& map);
/// One place: l, α, range, RMS, change, size, and its obstacle if it is infeasible.
/// @param decimals  of l and α; 2 name a place of ShaftMapModel::shortened()
QString place(const ShaftMapModel& map, const ShaftMapModel::Position& position, int decimals = 2);
/// The same but for the reason, a line each.
QStringList placeLines(const ShaftMapModel& map, const ShaftMapModel::Position& position,
                       int decimals = 2);
/// Why the shaft is infeasible there; empty where it fits.
QString reason(const ShaftMapModel& map, const ShaftMapModel::Position& position);

/// Range, RMS and feasibility over a grid of places.
QString fieldCsv(const ShaftMapModel& map, const CsvFormat& format);

}  // namespace ravnoves::shaft_map_text
