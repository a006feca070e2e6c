#include "pictures/model/pixel.h"

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

PaintedPixels pixelsOf(const QPainter& painter, const QRectF& box) {
    QPaintDevice* const device = painter.device();
    if (device == nullptr || device->devType() != QInternal::Image || !paintsPixels(painter) ||
        painter.opacity() != 1.0 ||
        painter.compositionMode() != QPainter::CompositionMode_SourceOver) {
        return {};
    }
    auto* const picture = static_cast<QImage*>(device);
    if (!hasWritablePixels(*picture)) {
        return {};
    }
    QRectF seen = box & QRectF(picture->rect());
    if (painter.hasClipping()) {
        constexpr double small = 64.0 * 64.0;
        if (box.width() * box.height() < small || painter.clipRegion().rectCount() != 1) {
            return {};
        }
        // Qt rounds a clip to pixels, too.
        const QRectF clip = painter.deviceTransform().mapRect(painter.clipBoundingRect());
        seen &= QRectF(clip.toRect());
    }
    return {picture, seen.toAlignedRect()};
}

}  // namespace ravnoves
