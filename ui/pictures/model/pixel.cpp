#include "pictures/model/pixel.h"

#include <QPaintEngine>
#include <QPainter>

namespace ravnoves {

bool paintsPixels(const QPainter& painter) {
    const QTransform& transform = painter.deviceTransform();
    return painter.paintEngine()->type() == QPaintEngine::Raster &&
           transform.type() <= QTransform::TxScale && transform.m11() > 0.0 &&
           transform.m11() == transform.m22();
}

PaintedPixels::PaintedPixels(QPainter& painter, const QRectF& box) : painter_(painter) {
    // Of a widget the picture of its window, where only its own place may change.
    QPaintDevice* const device = painter.paintEngine()->paintDevice();
    const QRegion place = painter.paintEngine()->systemClip();
    QRectF clip(0.0, 0.0, device->width(), device->height());
    bool isSimple = place.rectCount() <= 1;
    if (!place.isEmpty()) {
        clip &= place.boundingRect();
    }
    if (painter.hasClipping()) {
        constexpr double small = 64.0 * 64.0;
        isSimple = isSimple && box.width() * box.height() >= small &&
                   painter.clipRegion().rectCount() == 1;
        clip &= painter.deviceTransform().mapRect(painter.clipBoundingRect());
    }
    auto* const image =
        device->devType() == QInternal::Image ? static_cast<QImage*>(device) : nullptr;
    if (image != nullptr && isSimple && painter.opacity() == 1.0 &&
        painter.compositionMode() == QPainter::CompositionMode_SourceOver &&
        (image->format() == QImage::Format_RGB32 ||
         image->format() == QImage::Format_ARGB32_Premultiplied)) {
        picture_ = image;
        clip = clip.toRect();  // as Qt does
    }
    seen_ = (box & clip).toAlignedRect();
    if (picture_ == nullptr) {
        layer_ = QImage(seen_.size(), QImage::Format_ARGB32_Premultiplied);
        layer_.fill(Qt::transparent);
    }
}

PaintedPixels::~PaintedPixels() {
    if (!layer_.isNull()) {
        const QTransform& transform = painter_.deviceTransform();
        layer_.setDevicePixelRatio(transform.m11());
        painter_.drawImage(transform.inverted().map(QPointF(seen_.topLeft())), layer_);
    }
}

}  // namespace ravnoves
