#include "balance-shaft/shaft_map_signs.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "balance-shaft/change_colours.h"
#include "numerics/constants.h"
#include "pictures/model/pixel.h"
#include "plot/plot_painter.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

constexpr int imageScale = 3;  ///< pixels of the picture to one step of the field

}  // namespace

QString levelText(double fraction) {
    const double percent = 100.0 * fraction;
    QString text = QLocale().toString(std::abs(percent), 'g', 4);
    if (percent < 0.0) {
        text.prepend(QChar(0x2212));
    } else if (percent > 0.0) {
        text.prepend(QLatin1Char('+'));
    }
    return text;
}

double glyphRadius() {
    return 5.5 * strokeScale();
}

QColor faint(QColor colour, double alpha) {
    colour.setAlphaF(static_cast<float>(alpha));
    return colour;
}

std::vector<QRgb> bandColours(const std::vector<double>& levels) {
    const auto below = std::count_if(levels.begin(), levels.end(), [](double l) { return l < 0; });
    const auto above = std::ssize(levels) - below;
    std::vector<QRgb> colours;
    for (std::ptrdiff_t i = below + 1; i >= 1; --i) {
        colours.push_back(
            changeColour(-static_cast<double>(i) / static_cast<double>(below + 1)).rgb());
    }
    for (std::ptrdiff_t i = 1; i <= above; ++i) {
        colours.push_back(changeColour(static_cast<double>(i) / static_cast<double>(above)).rgb());
    }
    return colours;
}

QImage fieldImage(const balance_shaft::PositionMap& field, const std::vector<double>& values,
                  const std::vector<double>& levels) {
    const std::vector<QRgb> colours = bandColours(levels);
    const int width = static_cast<int>(field.columns - 1) * imageScale + 1;
    const int height = static_cast<int>(field.rows - 1) * imageScale + 1;
    QImage image(width, height, QImage::Format_RGB32);
    std::vector<double> row(field.columns);
    for (int y = 0; y < height; ++y) {
        const int up = height - 1 - y;
        const auto lower = std::min(static_cast<std::size_t>(up / imageScale), field.rows - 2);
        const double t = static_cast<double>(up) / imageScale - static_cast<double>(lower);
        const double* at = values.data() + lower * field.columns;
        for (std::size_t i = 0; i < field.columns; ++i) {
            row[i] = at[i] + t * (at[i + field.columns] - at[i]);
        }
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        std::size_t band = 0;
        for (int x = 0; x < width; ++x) {
            const auto left = std::min(static_cast<std::size_t>(x / imageScale), field.columns - 2);
            const double s = static_cast<double>(x) / imageScale - static_cast<double>(left);
            const double value = row[left] + s * (row[left + 1] - row[left]);
            while (band > 0 && value < levels[band - 1]) {
                --band;
            }
            while (band < levels.size() && value >= levels[band]) {
                ++band;
            }
            line[x] = colours[band];
        }
    }
    return image;
}

QPainterPath glyph(const QPointF& at, const ShaftMapModel::Marker& marker, double r) {
    QPainterPath shape;
    if (marker.criterion == ShaftMapModel::Criterion::Range) {
        shape.addPolygon(QPolygonF{at + QPointF(0, -1.25 * r), at + QPointF(1.25 * r, 0),
                                   at + QPointF(0, 1.25 * r), at + QPointF(-1.25 * r, 0),
                                   at + QPointF(0, -1.25 * r)});
    } else if (marker.criterion == ShaftMapModel::Criterion::Rms) {
        shape.addEllipse(at, r, r);
    } else {
        shape.addPolygon(QPolygonF{at + QPointF(0, -1.2 * r), at + QPointF(1.15 * r, 0.9 * r),
                                   at + QPointF(-1.15 * r, 0.9 * r), at + QPointF(0, -1.2 * r)});
    }
    return shape;
}

void drawGlyph(QPainter& painter, const QPointF& at, const ShaftMapModel::Marker& marker) {
    const Theme& theme = Theme::instance();
    const QPainterPath shape = glyph(at, marker);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.panel(), 4.5));
    painter.drawPath(shape);
    painter.setPen(QPen(theme.text(), 1.8));
    painter.setBrush(marker.isBuildable ? theme.text() : theme.panel());
    painter.drawPath(shape);
}

/// Each dash a line of its own: a dashed ellipse takes ten times as long, at every step of a drag.
void drawDashedCircle(QPainter& painter, const QPointF& middle, double radius, double dash,
                      double period) {
    const double turn = two_pi * radius;
    if (!(turn > period)) {
        return;
    }
    const auto count = static_cast<int>(turn / period);
    constexpr int most = 2000;  // the rest is far outside
    const int drawn = std::min(count, most);
    const double step = two_pi / drawn;
    const double half = 0.5 * step * dash / period;
    QList<QLineF> dashes;
    dashes.reserve(drawn);
    for (int i = 0; i < drawn; ++i) {
        const double at = i * step;
        const auto point = [&](double angle) {
            return middle + radius * QPointF(std::cos(angle), std::sin(angle));
        };
        dashes.append(QLineF(point(at - half), point(at + half)));
    }
    painter.drawLines(dashes);
}

namespace {

constexpr double apart = 7.0;  // lines of a hatch, pixels

/// One period of a hatch in each direction on this ground; none where a pixel of the device does
/// not divide it.
QBrush hatchTile(double ratio, const QColor& ground) {
    const double pixels = apart * ratio;
    if (pixels != std::floor(pixels)) {
        return {};
    }
    // Its middle has whole lines of all that reach into it.
    QImage around(QSize(3, 3) * static_cast<int>(pixels), QImage::Format_ARGB32_Premultiplied);
    around.setDevicePixelRatio(ratio);
    around.fill(ground);
    QPainter painter(&around);
    painter.setRenderHint(QPainter::Antialiasing);
    drawHatch(painter, {0.0, 0.0, 3.0 * apart, 3.0 * apart});
    painter.end();
    const int side = static_cast<int>(pixels);
    QImage tile = around.copy(side, side, side, side);
    tile.setDevicePixelRatio(1.0);
    QBrush brush(tile);
    brush.setTransform(QTransform::fromScale(1.0 / ratio, 1.0 / ratio));
    return brush;
}

}  // namespace

void fillHatched(QPainter& painter, const QPainterPath& path, const QRectF& box,
                 const QColor& ground) {
    const QBrush tile =
        paintsPixels(painter) ? hatchTile(painter.deviceTransform().m11(), ground) : QBrush();
    if (tile.style() != Qt::NoBrush) {
        painter.fillPath(path, tile);
        return;
    }
    painter.save();
    painter.fillPath(path, ground);
    painter.setClipPath(path, Qt::IntersectClip);
    drawHatch(painter, box);
    painter.restore();
}

void drawHatch(QPainter& painter, const QRectF& box) {
    painter.setPen(QPen(faint(Theme::instance().text(), 0.42), 1.0));
    const auto first = static_cast<int>(std::floor((box.left() - box.bottom()) / apart));
    for (int i = first; i * apart < box.right() - box.top(); ++i) {
        const double c = i * apart;
        painter.drawLine(QPointF(box.top() + c, box.top()),
                         QPointF(box.bottom() + c, box.bottom()));
    }
}

}  // namespace ravnoves
