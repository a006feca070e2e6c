#pragma once

#include <QColor>
#include <QFont>
#include <QRectF>

#include "shop/model/words.h"
#include "v8-plugs/solver.h"

class QPainter;
class QWidget;

namespace ravnoves {

class WorkshopModel;

/// Colours and type of a drawing: the theme's on the screen, black on paper.
struct DrawingStyle {
    QColor line;  ///< outlines
    QColor thin;  ///< dimension lines, hatching
    QColor text;
    QColor cut;        ///< metal to bore out
    QFont font;        ///< its pixel size sets the size of arrows and gaps
    double lineWidth;  ///< outlines; thin lines are half as wide
};

/// What the drawing shows of the plug.
struct PlugDrawing {
    v8_plugs::PlugGeometry plug;
    std::optional<double> cutterDiameter;  ///< m, where something is to be bored
    double cutDepth = 0.0;                 ///< from the outer face, m; 0: nothing to bore
    bool impossible = false;               ///< the walls forbid the bore: drawn dashed
};

/// The plug on the sheet, with the bore of the option that the answer is about; nothing while its
/// sizes are not known or do not go together.
std::optional<PlugDrawing> plannedPlug(const WorkshopModel& model);

/// Draws the plug in section with its dimensions, as large as the rectangle allows, to scale.
void drawPlug(QPainter& painter, const QRectF& target, const PlugDrawing& drawing,
              const DrawingStyle& style, const Words& words);

/// The picture of the planned plug; hidden without one.
QWidget* plugView(WorkshopModel* model, QWidget* parent);

}  // namespace ravnoves
