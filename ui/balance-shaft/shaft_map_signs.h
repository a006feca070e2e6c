#pragma once

#include <QColor>
#include <QImage>
#include <QPainterPath>
#include <vector>

#include "balance-shaft/model/shaft_map_model.h"

class QPainter;

/// What the map of places is drawn with; sizes in pixels.
namespace ravnoves {

/// A level of change in percent, without its unit: as many digits as that round number has.
QString levelText(double fraction);
/// Radius of a marker's sign.
double glyphRadius();
QColor faint(QColor colour, double alpha);
/// Colours of the stretches between the levels.
std::vector<QRgb> bandColours(const std::vector<double>& levels);
/// The field as bands of colour, each step of the grid drawn several pixels wide.
QImage fieldImage(const balance_shaft::PositionMap& field, const std::vector<double>& values,
                  const std::vector<double>& levels);
/// A marker's sign: what is best in the range is a diamond, in the RMS a disc, in the sum a
/// triangle; hollow where it cannot be built.
QPainterPath glyph(const QPointF& at, const ShaftMapModel::Marker& marker,
                   double radius = glyphRadius());
void drawGlyph(QPainter& painter, const QPointF& at, const ShaftMapModel::Marker& marker);
/// @param dash, period  pixels, the second with the gap: nearly, for a whole number of them fits
void drawDashedCircle(QPainter& painter, const QPointF& middle, double radius, double dash = 5.6,
                      double period = 8.4);
void drawHatch(QPainter& painter, const QRectF& box);
/// What of a box lies in a path, hatched on this ground.
void fillHatched(QPainter& painter, const QPainterPath& path, const QRectF& box,
                 const QColor& ground);

}  // namespace ravnoves
