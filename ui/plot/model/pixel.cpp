#include "plot/model/pixel.h"

#include <QPaintEngine>
#include <QPainter>

namespace ravnoves {

bool paintsPixels(const QPainter& painter) {
    const QTransform& transform = painter.deviceTransform();
    return painter.paintEngine()->type() == QPaintEngine::Raster &&
           transform.type() <= QTransform::TxScale && transform.m11() > 0.0 &&
           transform.m11() == transform.m22();
}

}  // namespace ravnoves
