#include "plot/model/disc.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "plot/model/pixel.h"

namespace ravnoves {

namespace {

struct Ink {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
    double alpha = 0.0;

    explicit Ink(const QColor& colour)
        : red(colour.redF()),
          green(colour.greenF()),
          blue(colour.blueF()),
          alpha(colour.alphaF()) {}
};

/// Line over ground, each covering part of a pixel; premultiplied.
QRgb over(const Ink& line, double lineCover, const Ink& ground, double groundCover) {
    const double top = line.alpha * lineCover;
    const double under = ground.alpha * groundCover * (1.0 - top);
    const auto part = [&](double a, double b) {
        return pixelStep(a * top + b * under);
    };
    return qRgba(part(line.red, ground.red), part(line.green, ground.green),
                 part(line.blue, ground.blue), pixelStep(top + under));
}

bool canMeasure(const QPainter& painter, double radius) {
    constexpr double largest = 2000.0;
    const QTransform& transform = painter.deviceTransform();
    const Qt::PenStyle pen = painter.pen().style();
    const Qt::BrushStyle brush = painter.brush().style();
    return paintsPixels(painter) && painter.testRenderHint(QPainter::Antialiasing) &&
           (pen == Qt::SolidLine || pen == Qt::NoPen) &&
           (brush == Qt::SolidPattern || brush == Qt::NoBrush) &&
           radius * transform.m11() < largest;
}

}  // namespace

void paintDisc(QPainter& painter, const QPointF& middle, double radius) {
    if (!canMeasure(painter, radius)) {
        painter.drawEllipse(middle, radius, radius);
        return;
    }
    const QTransform& transform = painter.deviceTransform();
    const double scale = transform.m11();
    const bool hasLine = painter.pen().style() != Qt::NoPen;
    const bool isFilled = painter.brush().style() != Qt::NoBrush;
    const Ink line(painter.pen().color());
    const Ink ground(painter.brush().color());
    const double half = hasLine ? 0.5 * std::max(1.0, painter.pen().widthF() * scale) : 0.0;
    const double edge = radius * scale;
    const QPointF centre = transform.map(middle);
    const double reach = edge + half + 1.0;
    const QPoint corner(static_cast<int>(std::floor(centre.x() - reach)),
                        static_cast<int>(std::floor(centre.y() - reach)));
    const int side = static_cast<int>(std::ceil(2.0 * reach)) + 2;
    QImage picture(side, side, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    const QRgb inside = over(line, 0.0, ground, isFilled ? 1.0 : 0.0);
    const double within = std::max(0.0, edge - half - 1.0);  // nothing of the edge is nearer
    for (int row = 0; row < side; ++row) {
        const double y = corner.y() + row + 0.5 - centre.y();
        if (std::abs(y) >= reach) {
            continue;
        }
        auto* pixels = reinterpret_cast<QRgb*>(picture.scanLine(row));
        const double wide = std::sqrt(reach * reach - y * y);
        const double clear = std::abs(y) < within ? std::sqrt(within * within - y * y) : 0.0;
        const double from = centre.x() - corner.x() - 0.5;  // of the middle, in pixels
        const auto column = [side](double x) {
            return std::clamp(static_cast<int>(std::ceil(x)), 0, side);
        };
        const int first = column(from - wide);
        const int last = column(from + wide);
        const int clearFirst = clear > 0.0 ? column(from - clear) : last;
        const int clearLast = clear > 0.0 ? column(from + clear) : last;
        const auto draw = [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                const double x = i - from;
                const double away = std::sqrt(x * x + y * y);
                const double onLine =
                    hasLine ? std::clamp(half + 0.5 - std::abs(away - edge), 0.0, 1.0) : 0.0;
                const double onGround = isFilled ? std::clamp(edge + 0.5 - away, 0.0, 1.0) : 0.0;
                pixels[i] = over(line, onLine, ground, onGround);
            }
        };
        draw(first, clearFirst);
        std::fill(pixels + clearFirst, pixels + clearLast, inside);
        draw(clearLast, last);
    }
    picture.setDevicePixelRatio(scale);
    painter.drawImage(transform.inverted().map(QPointF(corner)), picture);
}

}  // namespace ravnoves
