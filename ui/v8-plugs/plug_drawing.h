#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>

#include "v8-plugs/model/words.h"
#include "v8-plugs/plug_geometry.h"

class QPainter;

namespace ravnoves {

/// Colours and type of a drawing: the theme's on the screen, black on paper.
struct DrawingStyle {
    QColor line;  ///< outlines
    QColor thin;  ///< dimension lines, hatching
    QColor text;
    QColor cut;        ///< what is to be bored
    QFont font;        ///< its pixel size sets the size of arrows and gaps
    double lineWidth;  ///< outlines; thin lines are half of it
};

/// What the drawing shows of the plug.
struct PlugDrawing {
    v8_plugs::PlugGeometry plug;
    std::optional<double> cutterDiameter;  ///< m, where something is to be bored
    double cutDepth = 0.0;                 ///< from the outer face, m; 0: nothing to bore
    bool impossible = false;               ///< the walls forbid the bore: drawn dashed
};

/// Draws the plug in section with its dimensions, as large as the rectangle allows. Heights,
/// depths and diameters are to scale.
void drawPlug(QPainter& painter, const QRectF& target, const PlugDrawing& drawing,
              const DrawingStyle& style, const Words& words);

/// The same plug without known dimensions: letters in place of numbers.
void drawPlugSketch(QPainter& painter, const QRectF& target, const DrawingStyle& style,
                    const Words& words);

}  // namespace ravnoves
