#include "plot/model/pixel.h"

#include <QImage>
#include <QPaintEngine>
#include <QPainter>

namespace ravnoves {

bool paintsPixels(const QPainter& painter) {
    const QTransform& transform = painter.deviceTransform();
    return painter.paintEngine()->type() == QPaintEngine::Raster &&
           transform.type() <= QTransform::TxScale && transform.m11() > 0.0 &&
           transform.m11() == transform.m22();
}

bool hasWritablePixels(const QImage& picture) {
    return picture.format() == QImage::Format_RGB32 ||
           picture.format() == QImage::Format_ARGB32_Premultiplied;
}

QImage* pictureOf(const QPainter& painter) {
    QPaintDevice* const device = painter.device();
    if (device == nullptr || device->devType() != QInternal::Image || !paintsPixels(painter) ||
        painter.hasClipping() || painter.opacity() != 1.0 ||
        painter.compositionMode() != QPainter::CompositionMode_SourceOver) {
        return nullptr;
    }
    auto* const picture = static_cast<QImage*>(device);
    return hasWritablePixels(*picture) ? picture : nullptr;
}

}  // namespace ravnoves
