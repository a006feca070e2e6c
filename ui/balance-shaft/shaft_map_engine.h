#pragma once

class QPainter;

/// The engine from the front over the map of places.
namespace ravnoves {

class BalanceShaftModel;
class PlaceScale;
class ShaftMapModel;

/// Of the shaft's axis, by which it is dragged; pixels.
inline constexpr double shaftHandleRadius = 6.5;

/// Cylinder, piston, rod and crank at the angle of the crank.
void drawEngine(QPainter& painter, const BalanceShaftModel& model, const PlaceScale& scale);
/// The shaft with the circle of its l, red where it cannot be built.
/// @param other  where it is in the reference; null: none
void drawShaft(QPainter& painter, const BalanceShaftModel& model, const ShaftMapModel& map,
               const ShaftMapModel* other, const PlaceScale& scale);

}  // namespace ravnoves
