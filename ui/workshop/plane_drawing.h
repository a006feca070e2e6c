#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>
#include <optional>

#include "bob-weights/result.h"
#include "workshop/input.h"

class QPainter;
class QWidget;

namespace ravnoves {

class WorkshopModel;

/// The visible parts of a correction plane: the rim, reading and limit, holes there and planned.
struct PlaneShown {
    const workshop::Input& input;
    const bob_weights::Result& solution;
    std::size_t plane;
};

/// Colours and type: the theme's on the screen, black on paper.
struct PlaneStyle {
    QColor line;
    QColor thin;
    QColor text;
    QColor hole;
    QColor slug;
    QColor reading;
    QColor limit;
    QColor fits;  ///< what remains, within the limit
    QColor exceeds;
    QFont font;
    double lineWidth;
};

/// Draws the plane as a clock: seen from the front, 0° above, angles as the machine counts them.
/// The reading is an arrow to the heavy spot, the limit a circle; holes are in the rim, slugs
/// opposite, present ones dimmed, the residual is a dot.
void drawPlane(QPainter& painter, const QRectF& target, const PlaneShown& shown,
               const PlaneStyle& style);

/// The picture of a plane.
QWidget* planeView(WorkshopModel* model, std::size_t plane, QWidget* parent);

}  // namespace ravnoves
