#pragma once

#include <QColor>
#include <QImage>
#include <QPolygonF>
#include <vector>

#include "balance-shaft/model/change_contours.h"

class QPainter;

namespace ravnoves {

class PlotView;

// How a field of changes is drawn: blue where the shaft helps, orange where it harms, the more the
// stronger; the eye that sees no red tells them apart, and so does grey from either.

QColor faint(QColor colour, double alpha);
/// The field as bands of colour, each step of the grid drawn several pixels wide.
QImage changeImage(const ChangeContours& field);
/// A line in the units of the axes, in pixels.
QPolygonF inPixels(const PlotView& plot, const QPolygonF& line);
void drawContours(QPainter& painter, const ChangeContours& field, const PlotView& plot);
/// The bar of the colours with its numbers, pixels.
double changeKeyHeight();
/// In smaller type where two numbers would meet; what meets another even so has its line alone.
/// @param room  across, in pixels
void paintChangeKey(QPainter& painter, const std::vector<double>& levels, const QPointF& corner,
                    double room);

}  // namespace ravnoves
