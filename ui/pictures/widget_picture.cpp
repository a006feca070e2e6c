#include "pictures/widget_picture.h"

#include <QPainter>
#include <QWidget>
#include <cmath>

#include "theme/theme.h"

namespace ravnoves {

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
