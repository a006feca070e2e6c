#include "plot/screen_pixels.h"

#include <QPaintEngine>
#include <QPainter>
#include <QRegion>
#include <QWidget>
#include <cmath>

#include "plot/model/pixel.h"
#include "theme/theme.h"

namespace ravnoves {

QImage* ScreenPixels::of(const QPainter& painter, const QWidget& widget, const QRect& part,
                         const QRegion& seen) {
    if (!paintsPixels(painter) || painter.hasClipping() || seen.rectCount() != 1 ||
        !seen.boundingRect().contains(part)) {
        return nullptr;
    }
    // Of a widget the painter names the widget, and its engine what it is painted on.
    QPaintDevice* const device = painter.paintEngine()->paintDevice();
    if (device == nullptr || device->devType() != QInternal::Image) {
        return nullptr;
    }
    const auto* const screen = static_cast<const QImage*>(device);
    const QTransform& transform = painter.deviceTransform();
    if (transform.m11() != widget.devicePixelRatioF()) {
        return nullptr;
    }
    const QRectF place = transform.mapRect(QRectF(widget.rect()));
    const QRectF placeSeen = transform.mapRect(QRectF(seen.boundingRect()));
    const QRect pixels = place.toRect();
    if (!hasWritablePixels(*screen) || QRectF(pixels) != place ||
        QRectF(placeSeen.toRect()) != placeSeen || pixels.isEmpty() ||
        !screen->rect().contains(pixels)) {
        return nullptr;
    }
    constexpr qsizetype pixel = 4;  // bytes
    const uchar* const first = screen->constScanLine(pixels.top()) + pixel * pixels.left();
    if (view_.constBits() != first || view_.size() != pixels.size() ||
        view_.bytesPerLine() != screen->bytesPerLine() || view_.format() != screen->format()) {
        // Painting on the widget writes there too.
        view_ = QImage(const_cast<uchar*>(first), pixels.width(), pixels.height(),
                       screen->bytesPerLine(), screen->format());
    }
    view_.setDevicePixelRatio(transform.m11());
    return &view_;
}

bool fitPicture(QImage& picture, const QWidget& widget) {
    const double ratio = widget.devicePixelRatioF();
    const QSize pixels = (QSizeF(widget.size()) * ratio).toSize();
    if (picture.size() == pixels && picture.devicePixelRatio() == ratio) {
        return false;
    }
    picture = QImage(pixels, QImage::Format_RGB32);
    picture.setDevicePixelRatio(ratio);
    return true;
}

void drawPicture(QPainter& painter, const QImage& picture, const QRect& widget) {
    const double ratio = picture.devicePixelRatio();
    if (ratio != std::floor(ratio)) {
        painter.fillRect(widget.adjusted(-1, -1, 1, 1), Theme::instance().panel());
    }
    painter.drawImage(widget.topLeft(), picture);
}

}  // namespace ravnoves
