#include "plot/plot_painter.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>

#include "pictures/model/stroke.h"
#include "plot/model/label_places.h"
#include "plot/model/ticks.h"
#include "text/text_width.h"
#include "theme/theme.h"

namespace ravnoves {

using namespace painter_parts;
using plot::Shape;

namespace {

constexpr double titleGap = 2.0;  // from a title to the edge, pixels
/// Above the chart: the highest number stands half over it, below the legend.
double topGap() {
    constexpr int line = 8;
    return 6.0 + std::max(0, Theme::withText(line) - line);
}
// Pixels that a tick label needs, for text of the designed size.
double columnPerTick() {
    return Theme::withText(56);
}
double chartRowPerTick() {
    return Theme::withText(28);
}

double heightOfArea(const PlotData& data) {
    const QFontMetricsF metrics(Theme::font(Theme::smallSize));
    const double bottom =
        std::ceil(metrics.height() * (data.x.spec.title.isEmpty() ? 1.0 : 2.0) + 2.5 * labelGap());
    return std::max(20.0, data.size.height() - data.headerHeight - topGap() - bottom);
}

void chooseColumns(const PlotData& data, PlotScale& x, double pixels) {
    const QFont font = Theme::font(Theme::smallSize);
    x.chooseStep(
        pixels, columnPerTick(), [&](const QString& label) { return textWidth(font, label); },
        data.locale);
}

void paintGrid(QPainter& painter, const PlotData& data) {
    constexpr double stroke = 5.0;  // of a tick, beyond the line; a scale of its own has none
    const Theme& theme = Theme::instance();
    const QRectF& area = data.area;
    QList<QLineF> grid;
    QList<QLineF> strokes{{area.topLeft(), area.bottomLeft()},
                          {area.bottomLeft(), area.bottomRight()}};
    for (const double tick : data.x.ticks(area.width(), columnPerTick())) {
        const double x = area.left() + data.x.fraction(tick) * area.width();
        grid.append({x, area.top(), x, area.bottom()});
        if (!data.x.spec.logarithmic) {
            strokes.append({x, area.bottom(), x, area.bottom() + stroke});
        }
    }
    for (const double tick : data.left.ticks(area.height(), rowPerTick())) {
        const double y = area.bottom() - data.left.fraction(tick) * area.height();
        grid.append({area.left(), y, area.right(), y});
        if (!data.left.spec.logarithmic) {
            strokes.append({area.left() - stroke, y, area.left(), y});
        }
    }
    const auto draw = [&](const QColor& colour, const QList<QLineF>& lines) {
        for (const QLineF& line : lines) {
            const QPointF half = line.dx() == 0.0 ? QPointF(0.5, 0.0) : QPointF(0.0, 0.5);
            painter.fillRect(QRectF(line.p1() - half, line.p2() + half), colour);
        }
    };
    // Over a picture the grid gives way.
    draw(data.image.isNull() ? theme.grid() : veil(theme.text(), 0.09F), grid);
    draw(theme.border(), strokes);
}

void paintGhosts(QPainter& painter, const PlotData& data) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(data.area);
    for (const PlotCurve& curve : data.curves) {
        const PlotCurve* ghost = data.ghostOf(curve);
        if (ghost == nullptr) {
            continue;
        }
        // Wide and pale: dashes and dots are styles of curves.
        const QColor ink = Theme::instance().colour(curve.style.role);
        const QColor colour = veil(ink, 0.55F);
        painter.setPen(QPen(veil(ink, 0.32F),
                            strokeScale() * std::max(4.0, 2.5 * curve.style.width), Qt::SolidLine,
                            Qt::FlatCap, Qt::BevelJoin));
        for (const QPolygonF& stretch : data.stretchesOf(*ghost)) {
            // The outline of a point has no edge: a PDF closed a path that never began.
            if (!stretch.boundingRect().size().isNull()) {
                painter.drawPolyline(stretch);
            }
        }
        // Those of bars stand over them: a lower one would be out of sight below.
        if (ghost->style.shape != Shape::Line && ghost->style.shape != Shape::Bars) {
            for (std::size_t i = 0; i < ghost->x.size(); ++i) {
                paintMarker(painter, lookOf(curve.style.role).marker, data.pixelOf(*ghost, i),
                            pointRadius(ghost->style.shape), QPen(colour, 1.2), Qt::NoBrush);
            }
        }
    }
    painter.restore();
}

void paintAxis(QPainter& painter, const PlotData& data, const PlotScale& scale, bool flat) {
    const Theme& theme = Theme::instance();
    const QRectF& area = data.area;
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    painter.setFont(font);
    const std::vector<double> ticks =
        scale.ticks(flat ? area.width() : area.height(), flat ? columnPerTick() : rowPerTick());
    std::vector<QRectF> taken;
    for (const double tick : ticks) {
        const QString text = scale.tickText(tick, data.locale);
        const double wide = textWidth(font, text) + 2.0;
        QRectF box(0, 0, wide, metrics.height());
        if (flat) {
            const double x = area.left() + scale.fraction(tick) * area.width();
            box.moveTop(area.bottom() + labelGap());
            box.moveLeft(std::min(x - wide / 2.0, data.size.width() - wide));
        } else {
            const double y = area.bottom() - scale.fraction(tick) * area.height();
            box.moveTop(y - metrics.height() / 2.0);
            box.moveLeft(area.left() - labelGap() - wide);
        }
        // Of labels that would touch the first counts; a scale of its own has the weightiest first.
        const QRectF room = box.adjusted(-3.0, 0.0, 3.0, 0.0);
        if (std::any_of(taken.begin(), taken.end(),
                        [&](const QRectF& other) { return other.intersects(room); })) {
            continue;
        }
        taken.push_back(room);
        painter.setPen(theme.mutedText());
        painter.drawText(box, Qt::AlignCenter, text);
    }
    if (scale.spec.title.isEmpty()) {
        return;
    }
    painter.setPen(theme.mutedText());
    // In the middle of the chart, but beyond its ends rather than cut; its unit is at its end.
    const double from = flat ? titleGap : data.headerHeight;
    // Not down into the row of the other title.
    const double below = flat || data.x.spec.title.isEmpty() ? 0.0 : metrics.height() + labelGap();
    const double room = (flat ? data.size.width() : data.size.height()) - from - below - titleGap;
    const QString title = metrics.elidedText(scale.spec.title, Qt::ElideMiddle, room);
    const double half = 0.5 * textWidth(font, title) + 1.0;
    const double middle = std::max(
        from + half, std::min(flat ? area.center().x() : area.center().y(), from + room - half));
    const QRectF box(-half, 0.0, 2.0 * half, metrics.height());
    if (flat) {
        painter.drawText(
            box.translated(middle, area.bottom() + 1.5 * labelGap() + metrics.height()),
            Qt::AlignCenter | Qt::TextDontClip, title);
        return;
    }
    painter.save();
    painter.translate(labelGap(), middle);
    painter.rotate(-90.0);
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, title);
    painter.restore();
}

}  // namespace

double strokeScale() {
    constexpr int whole = 1000;
    return std::max(1.0, 0.5 + 0.5 * Theme::withText(whole) / whole);
}

PlotTitle::PlotTitle(const QString& title, double width) {
    for (const int size : {Theme::baseSize, Theme::smallSize + 1, Theme::smallSize}) {
        font = Theme::font(size, true);
        if (textWidth(font, title) <= width) {
            break;
        }
    }
    for (const QString& word : title.split(QLatin1Char(' '))) {
        if (textWidth(font, word) > width) {
            flags |= Qt::TextWrapAnywhere;  // no place to break it else
        }
    }
    this->width = textWidth(font, title);
    height = std::ceil(QFontMetricsF(Theme::font(Theme::baseSize, true)).height());
    if (this->width > width) {
        const QRectF room(0.0, 0.0, std::max(1.0, width), 1e4);
        height = std::max(height,
                          std::ceil(QFontMetricsF(font).boundingRect(room, flags, title).height()));
    }
}

QRectF painter_parts::shadeOf(const PlotData& data, const plot::Band& band) {
    const QRectF& area = data.area;
    const bool alongX = band.orientation == Qt::Horizontal;
    const auto edge = [&](double value, const QPointF& corner) {
        return alongX ? QPointF(data.across(value), corner.y())
                      : QPointF(corner.x(), data.toPixel(data.x.low, value).y());
    };
    return QRectF(edge(band.from, area.topLeft()), edge(band.to, area.bottomRight()))
        .normalized()
        .intersected(area);
}

PlotMargins plotMargins(PlotData& data, const QSizeF& size) {
    data.size = size;
    data.fitScales();
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    const double height = heightOfArea(data);
    // Of copies: the steps of the plot are those of its area, which these margins only lead to.
    PlotScale y = data.left;
    PlotScale x = data.x;
    // The ticks that the axis will get decide how many decimals the labels have.
    y.chooseStep(height, chartRowPerTick());
    double widest = 0.0;
    for (const double tick : y.ticks(height, rowPerTick())) {
        widest = std::max(widest, textWidth(font, y.tickText(tick, data.locale)));
    }
    const double title = y.spec.title.isEmpty() ? 0.0 : metrics.height() + labelGap();
    const double left = std::ceil(widest + title + 2 * labelGap());
    chooseColumns(data, x, std::max(20.0, data.size.width() - left));
    const double last = textWidth(font, x.tickText(x.high, data.locale));  // half beyond the axis
    return {left, std::max(Theme::margin + 4.0, last / 2.0 + labelGap())};
}

void layOutPlot(PlotData& data, const QSizeF& size, const PlotMargins& minimum, bool& axesStale) {
    const PlotMargins own = plotMargins(data, size);
    const double left = std::max(own.left, minimum.left);
    const double right = std::max(own.right, minimum.right);
    data.area = QRectF(left, data.headerHeight + topGap(),
                       std::max(20.0, data.size.width() - left - right), heightOfArea(data));
    if (data.equalScale) {
        data.endWithData();
        data.equalise();
    }
    const std::array placed{data.area.x(),     data.area.y(),      size.width(), size.height(),
                            data.area.width(), data.area.height(), data.x.low,   data.x.high,
                            data.left.low,     data.left.high};
    if (placed != data.placed) {
        data.placed = placed;
        axesStale = true;
        data.makeStale();
    }
    if (axesStale) {
        chooseColumns(data, data.x, data.area.width());
        data.left.chooseStep(data.area.height(), chartRowPerTick());
    }
    data.thinCurves();
}

void paintPlotAxes(QPainter& painter, const PlotData& data) {
    painter.setRenderHint(QPainter::Antialiasing);
    const double room = data.size.width() - 2.0 * Theme::margin;
    const PlotTitle title(data.title, room);
    painter.setFont(title.font);
    painter.setPen(Theme::instance().text());
    painter.drawText(QRectF(Theme::margin, Theme::gap, room, title.height + Theme::gap),
                     title.flags, data.title);
    if (!data.image.isNull()) {
        const QRectF& values = data.imageValues;
        painter.save();
        painter.setClipRect(data.area);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(QRectF(data.toPixel(values.left(), values.bottom()),
                                 data.toPixel(values.right(), values.top()))
                              .normalized(),
                          data.image);
        painter.restore();
    }
    for (const plot::Band& band : data.bands) {
        painter.fillRect(
            shadeOf(data, band),
            mixed(Theme::instance().panel(), Theme::instance().colour(band.role), band.strength));
    }
    paintGrid(painter, data);
    paintAxis(painter, data, data.x, true);
    paintAxis(painter, data, data.left, false);
    paintGhosts(painter, data);
}

}  // namespace ravnoves
