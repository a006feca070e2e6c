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

PlotPainter::PlotPainter(PlotData& data) : data_(data) {}

void PlotPainter::layout(const QSizeF& size, const Margins& minimum, bool& axesStale) {
    layoutArea(size, minimum);
    const std::array placed{data_.area.x(),     data_.area.y(),      size.width(), size.height(),
                            data_.area.width(), data_.area.height(), data_.x.low,  data_.x.high,
                            data_.left.low,     data_.left.high};
    if (placed != placed_) {
        placed_ = placed;
        axesStale = true;
        data_.makeStale();
    }
    if (axesStale) {
        chooseColumns(data_.x, data_.area.width());
        data_.left.chooseStep(data_.area.height(), chartRowPerTick());
    }
    data_.thinCurves();
}

PlotPainter::Margins PlotPainter::margins(const QSizeF& size) {
    size_ = size;
    data_.fitScales();
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    const double height = heightOfArea();
    // Of copies: the steps of the plot are those of its area, which these margins only lead to.
    PlotScale y = data_.left;
    PlotScale x = data_.x;
    // The ticks that the axis will get decide how many decimals the labels have.
    y.chooseStep(height, chartRowPerTick());
    double widest = 0.0;
    for (const double tick : y.ticks(height, rowPerTick())) {
        widest = std::max(widest, textWidth(font, y.tickText(tick, data_.locale)));
    }
    const double title = y.spec.title.isEmpty() ? 0.0 : metrics.height() + labelGap();
    const double left = std::ceil(widest + title + 2 * labelGap());
    chooseColumns(x, std::max(20.0, size_.width() - left));
    const double last = textWidth(font, x.tickText(x.high, data_.locale));  // half beyond the axis
    return {left, std::max(Theme::margin + 4.0, last / 2.0 + labelGap())};
}

double PlotPainter::heightOfArea() const {
    const QFontMetricsF metrics(Theme::font(Theme::smallSize));
    const double bottom =
        std::ceil(metrics.height() * (data_.x.spec.title.isEmpty() ? 1.0 : 2.0) + 2.5 * labelGap());
    return std::max(20.0, size_.height() - data_.headerHeight - topGap() - bottom);
}

void PlotPainter::chooseColumns(PlotScale& x, double pixels) const {
    const QFont font = Theme::font(Theme::smallSize);
    x.chooseStep(
        pixels, columnPerTick(), [&](const QString& label) { return textWidth(font, label); },
        data_.locale);
}

void PlotPainter::layoutArea(const QSizeF& size, const Margins& minimum) {
    const Margins own = margins(size);
    const double left = std::max(own.left, minimum.left);
    const double right = std::max(own.right, minimum.right);
    data_.area = QRectF(left, data_.headerHeight + topGap(),
                        std::max(20.0, size_.width() - left - right), heightOfArea());
    data_.flatRoom = size_.width() - 2.0 * titleGap;
    // Not down into the row of the other title.
    const double below = data_.x.spec.title.isEmpty()
                             ? 0.0
                             : QFontMetricsF(Theme::font(Theme::smallSize)).height() + labelGap();
    data_.uprightRoom = size_.height() - data_.headerHeight - below - titleGap;
    if (data_.equalScale) {
        data_.endWithData();
        data_.equalise();
    }
}

void PlotPainter::paintAxes(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    const double room = size_.width() - 2.0 * Theme::margin;
    const PlotTitle title(data_.title, room);
    painter.setFont(title.font);
    painter.setPen(Theme::instance().text());
    painter.drawText(QRectF(Theme::margin, Theme::gap, room, title.height + Theme::gap),
                     title.flags, data_.title);
    if (!data_.image.isNull()) {
        const QRectF& values = data_.imageValues;
        painter.save();
        painter.setClipRect(data_.area);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(QRectF(data_.toPixel(values.left(), values.bottom()),
                                 data_.toPixel(values.right(), values.top()))
                              .normalized(),
                          data_.image);
        painter.restore();
    }
    for (const plot::Band& band : data_.bands) {
        painter.fillRect(shadeOf(band), mixed(Theme::instance().panel(),
                                              Theme::instance().colour(band.role), band.strength));
    }
    paintGrid(painter);
    paintAxis(painter, data_.x, true);
    paintAxis(painter, data_.left, false);
    paintGhosts(painter);
}

void PlotPainter::paintGrid(QPainter& painter) const {
    constexpr double stroke = 5.0;  // of a tick, beyond the line; a scale of its own has none
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    QList<QLineF> grid;
    QList<QLineF> strokes{{area.topLeft(), area.bottomLeft()},
                          {area.bottomLeft(), area.bottomRight()}};
    for (const double tick : data_.x.ticks(area.width(), columnPerTick())) {
        const double x = area.left() + data_.x.fraction(tick) * area.width();
        grid.append({x, area.top(), x, area.bottom()});
        if (!data_.x.spec.logarithmic) {
            strokes.append({x, area.bottom(), x, area.bottom() + stroke});
        }
    }
    for (const double tick : data_.left.ticks(area.height(), rowPerTick())) {
        const double y = area.bottom() - data_.left.fraction(tick) * area.height();
        grid.append({area.left(), y, area.right(), y});
        if (!data_.left.spec.logarithmic) {
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
    draw(data_.image.isNull() ? theme.grid() : veil(theme.text(), 0.09F), grid);
    draw(theme.border(), strokes);
}

void PlotPainter::paintGhosts(QPainter& painter) const {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(data_.area);
    for (const PlotCurve& curve : data_.curves) {
        const PlotCurve* ghost = data_.ghostOf(curve);
        if (ghost == nullptr) {
            continue;
        }
        // Wide and pale: dashes and dots are styles of curves.
        const QColor ink = Theme::instance().colour(curve.style.role);
        const QColor colour = veil(ink, 0.55F);
        painter.setPen(QPen(veil(ink, 0.32F),
                            strokeScale() * std::max(4.0, 2.5 * curve.style.width), Qt::SolidLine,
                            Qt::FlatCap, Qt::BevelJoin));
        for (const QPolygonF& stretch : data_.stretchesOf(*ghost)) {
            // The outline of a point has no edge: a PDF closed a path that never began.
            if (!stretch.boundingRect().size().isNull()) {
                painter.drawPolyline(stretch);
            }
        }
        // Those of bars stand over them: a lower one would be out of sight below.
        if (ghost->style.shape != Shape::Line && ghost->style.shape != Shape::Bars) {
            for (std::size_t i = 0; i < ghost->x.size(); ++i) {
                paintMarker(painter, lookOf(curve.style.role).marker, pixel(*ghost, i),
                            pointRadius(ghost->style.shape), QPen(colour, 1.2), Qt::NoBrush);
            }
        }
    }
    painter.restore();
}

QRectF PlotPainter::shadeOf(const plot::Band& band) const {
    const QRectF& area = data_.area;
    const bool alongX = band.orientation == Qt::Horizontal;
    const auto edge = [&](double value, const QPointF& corner) {
        return alongX ? QPointF(across(value), corner.y())
                      : QPointF(corner.x(), data_.toPixel(data_.x.low, value).y());
    };
    return QRectF(edge(band.from, area.topLeft()), edge(band.to, area.bottomRight()))
        .normalized()
        .intersected(area);
}

void PlotPainter::paintBandWords(QPainter& painter, const plot::Band& band,
                                 LabelPlaces& places) const {
    const QRectF shade = shadeOf(band);
    const QFont font = Theme::font(Theme::smallSize);
    painter.setFont(font);
    double widest = 0.0;
    for (const QString& word : band.text.split(QLatin1Char(' '))) {
        widest = std::max(widest, textWidth(font, word));
    }
    if (widest == 0.0 || shade.width() <= widest + 8.0) {
        return;
    }
    constexpr int flags = Qt::AlignTop | Qt::AlignHCenter | Qt::TextWordWrap;
    const QRectF room = shade.adjusted(4, 2, -4, -2);
    QRectF used(room.topLeft(), labelSize(font, band.text));
    used.moveLeft(room.center().x() - used.width() / 2.0);
    if (used.width() > room.width()) {
        used =
            painter.boundingRect(room, flags, band.text).adjusted(-besideLabel, 0, besideLabel, 0);
    }
    // At the top, or where nothing passes; the curves and values of a full one say more.
    constexpr int heights = 16;
    const double down = std::max(0.0, room.height() - used.height());
    const double aside = std::max(0.0, room.width() - used.width()) / 2.0;
    for (int i = 0; i <= heights; ++i) {
        for (const double across : {0.0, -aside, aside}) {
            const QRectF box = used.translated(across, down * i / heights);
            if (places.covered(box) == 0) {
                places.addLabel(box);
                drawLabel(painter, box, Theme::instance().mutedText(), band.text, flags);
                return;
            }
        }
    }
}

void PlotPainter::paintAxis(QPainter& painter, const PlotScale& scale, bool flat) const {
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    painter.setFont(font);
    const std::vector<double> ticks =
        scale.ticks(flat ? area.width() : area.height(), flat ? columnPerTick() : rowPerTick());
    std::vector<QRectF> taken;
    for (const double tick : ticks) {
        const QString text = scale.tickText(tick, data_.locale);
        const double wide = textWidth(font, text) + 2.0;
        QRectF box(0, 0, wide, metrics.height());
        if (flat) {
            const double x = area.left() + scale.fraction(tick) * area.width();
            box.moveTop(area.bottom() + labelGap());
            box.moveLeft(std::min(x - wide / 2.0, size_.width() - wide));
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
    const double room = flat ? data_.flatRoom : data_.uprightRoom;
    const double from = flat ? titleGap : data_.headerHeight;
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

}  // namespace ravnoves
