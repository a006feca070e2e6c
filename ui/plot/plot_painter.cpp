#include "plot/plot_painter.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QImage>
#include <QPainter>
#include <QValueAxis>
#include <algorithm>
#include <utility>

#include "plot/model/disc.h"
#include "plot/model/line_brush.h"
#include "plot/model/ticks.h"
#include "theme/text_width.h"
#include "theme/theme.h"

namespace ravnoves {

using plot::Shape;
using plot::Side;

namespace {

constexpr int labelGap = 6;
// Pixels that a tick label needs, for text of the designed size.
double columnPerTick() {
    return Theme::withText(56);
}
double chartRowPerTick() {
    return Theme::withText(28);
}
/// With labels of our own: powers stand higher.
double rowPerTick() {
    return Theme::withText(36);
}

void dot(QPainter& painter, const QPointF& at, double radius, const QPen& pen, const QBrush& fill) {
    painter.setPen(pen);
    painter.setBrush(fill);
    paintDisc(painter, at, radius);
}

QColor veil(QColor colour, float opacity) {
    colour.setAlphaF(opacity);
    return colour;
}

/// The axis makes its ticks anew at each word of ours, one by one from its anchor on: none of them
/// may leave it with a fine step on a long range, or far from the anchor.
void moveAxis(QValueAxis& axis, double low, double high, double step) {
    constexpr double many = 1e3;
    const double extent =
        std::max({std::abs(low), std::abs(high), std::abs(axis.min()), std::abs(axis.max())});
    if (extent > many * std::min(step, axis.tickInterval())) {
        axis.setTickInterval(2.0 * extent);
    }
    axis.setTickAnchor(std::abs(low) > many * step ? std::ceil(low / step - 1e-9) * step : 0.0);
    axis.setRange(low, high);
    axis.setTickInterval(step);
}

/// A text from its base point on, over whatever is drawn there.
void drawOnVeil(QPainter& painter, const QPointF& base, const QString& text) {
    const QFontMetricsF metrics(painter.font());
    const QRectF box(base.x(), base.y() - metrics.ascent(), metrics.horizontalAdvance(text),
                     metrics.height());
    painter.fillRect(box.adjusted(-2, 0, 2, 0), veil(Theme::instance().panel(), 0.7F));
    painter.drawText(base, text);
}

}  // namespace

PlotPainter::PlotPainter(PlotData& data)
    : data_(data), scene_(std::make_unique<QGraphicsScene>()), chart_(new QChart) {
    scene_->addItem(chart_);
    chart_->setBackgroundVisible(false);
    chart_->legend()->hide();
    chart_->setLocalizeNumbers(true);
    chart_->setAnimationOptions(QChart::NoAnimation);
    chart_->layout()->setContentsMargins(0, 0, 0, 0);
    chart_->setMargins(QMargins());
}

PlotPainter::~PlotPainter() = default;

void PlotPainter::layout(const QSizeF& size, bool& axesStale) {
    const bool resized = size_ != size;
    size_ = size;
    layoutArea();
    const std::array placed{
        data_.area.x(), data_.area.y(), data_.area.width(), data_.area.height(), data_.x.low,
        data_.x.high,   data_.left.low, data_.left.high,    data_.right.low,     data_.right.high};
    if (placed != placed_ || resized) {
        placed_ = placed;
        axesStale = true;
        data_.makeStale();
    }
    if (axesStale) {
        layoutAxes();
    }
    data_.thinCurves();
}

void PlotPainter::layoutArea() {
    data_.fitScales();
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    const double top = data_.headerHeight + labelGap;
    const double bottom =
        std::ceil(metrics.height() * (data_.x.spec.title.isEmpty() ? 1.0 : 2.0) + 2.5 * labelGap);
    const double height = std::max(20.0, size_.height() - top - bottom);
    const auto margin = [&](PlotScale& scale) {
        std::vector<double> ticks{scale.low, scale.high};
        if (scale.isOwn()) {
            ticks = scale.ownTicks(height, rowPerTick());
        }
        // The ticks that the axis will get decide how many decimals the labels have.
        scale.chooseStep(height, chartRowPerTick());
        double widest = 0.0;
        for (const double tick : ticks) {
            widest = std::max(widest, textWidth(font, scale.tickText(tick, data_.locale)));
        }
        const double title = scale.spec.title.isEmpty() ? 0.0 : metrics.height() + labelGap;
        return std::ceil(widest + title + 2 * labelGap);
    };
    const double left = margin(data_.left);
    const auto lastLabel = [&] {  // stands half beyond the axis
        data_.x.chooseStep(std::max(20.0, size_.width() - left), columnPerTick());
        return textWidth(font, data_.x.tickText(data_.x.high, data_.locale));
    };
    const double right = data_.sideUsed(Side::Right)
                             ? margin(data_.right)
                             : std::max(Theme::margin + 4.0, lastLabel() / 2.0 + 2.0);
    data_.area = QRectF(left, top, std::max(20.0, size_.width() - left - right), height);
    if (data_.equalScale) {
        data_.equalise();
    }
}

void PlotPainter::layoutAxes() {
    const Theme& theme = Theme::instance();
    chart_->resize(size_);
    scene_->setSceneRect(QRectF(QPointF(), size_));
    chart_->setPlotArea(data_.area);
    const auto apply = [&](std::size_t number, PlotScale& scale, Qt::Alignment edge, double pixels,
                           double pixelsPerTick) {
        QValueAxis*& axis = axes_[number];
        if (axis == nullptr) {
            axis = new QValueAxis;
            chart_->addAxis(axis, edge);
            axis->setTickType(QValueAxis::TicksDynamic);
            axis->setTickAnchor(0.0);
            axis->setMinorGridLineVisible(false);
            axis->setGridLineVisible(edge != Qt::AlignRight);
        }
        axis->setVisible(!scale.isOwn());
        axis->setLabelsFont(Theme::font(Theme::smallSize));
        axis->setTitleFont(Theme::font(Theme::smallSize));
        axis->setLabelsBrush(theme.mutedText());
        axis->setTitleBrush(theme.mutedText());
        axis->setLinePen(QPen(theme.border(), 1));
        // Over a picture the grid gives way.
        axis->setGridLinePen(
            QPen(data_.image.isNull() ? theme.grid() : veil(theme.text(), 0.09F), 1));
        axis->setTitleText(scale.spec.title);
        scale.chooseStep(pixels, pixelsPerTick);
        if (!scale.isOwn()) {
            const double low = scale.number(scale.low);
            const double high = scale.number(scale.high);
            const TickFormat format = tickFormat(low, high, scale.step);
            axis->setLabelFormat(
                QStringLiteral("%.%1%2").arg(format.digits).arg(QLatin1Char(format.letter)));
            moveAxis(*axis, low, high, scale.step);
        }
    };
    apply(0, data_.x, Qt::AlignBottom, data_.area.width(), columnPerTick());
    apply(1, data_.left, Qt::AlignLeft, data_.area.height(), chartRowPerTick());
    if (data_.sideUsed(Side::Right)) {
        apply(2, data_.right, Qt::AlignRight, data_.area.height(), chartRowPerTick());
    }
    chart_->layout()->activate();
}

void PlotPainter::paintAxes(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(Theme::font(Theme::baseSize, true));
    painter.setPen(Theme::instance().text());
    const double row = std::ceil(painter.fontMetrics().height()) + Theme::gap;
    const double room = size_.width() - 2.0 * Theme::margin;
    painter.drawText(
        QRectF(Theme::margin, Theme::gap, room, row), Qt::AlignLeft | Qt::AlignVCenter,
        painter.fontMetrics().elidedText(data_.title, Qt::ElideRight, static_cast<int>(room)));
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
        paintBand(painter, band);
    }
    paintOwnAxis(painter, data_.x, Qt::BottomEdge);
    paintOwnAxis(painter, data_.left, Qt::LeftEdge);
    if (data_.sideUsed(Side::Right)) {
        paintOwnAxis(painter, data_.right, Qt::RightEdge);
    }
    const QRectF whole(QPointF(), size_);
    scene_->render(&painter, whole, whole);
    paintGhosts(painter);
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
        const QColor ink = Theme::instance().curve(curve.style.colour);
        const QColor colour = veil(ink, 0.55F);
        const QPen pen(colour, 1.2, Qt::DashLine, Qt::FlatCap, Qt::BevelJoin);
        painter.setPen(QPen(veil(ink, 0.32F), std::max(4.0, 2.5 * curve.style.width), Qt::SolidLine,
                            Qt::FlatCap, Qt::BevelJoin));
        for (const QPolygonF& stretch : data_.stretchesOf(*ghost)) {
            painter.drawPolyline(stretch);
        }
        if (ghost->style.shape == Shape::Bars) {
            paintBars(painter, *ghost, pen, Qt::NoBrush);
        } else if (ghost->style.shape != Shape::Line) {
            for (std::size_t i = 0; i < ghost->x.size(); ++i) {
                dot(painter, pixel(*ghost, i), 3.6, QPen(colour, 1.2), Qt::NoBrush);
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

void PlotPainter::paintBand(QPainter& painter, const plot::Band& band) const {
    painter.fillRect(shadeOf(band), band.colour);
}

QRectF PlotPainter::paintBandWords(QPainter& painter, const plot::Band& band) const {
    const QRectF shade = shadeOf(band);
    painter.setFont(Theme::font(Theme::smallSize));
    double widest = 0.0;
    for (const QString& word : band.text.split(QLatin1Char(' '))) {
        widest = std::max<double>(widest, painter.fontMetrics().horizontalAdvance(word));
    }
    if (widest == 0.0 || shade.width() <= widest + 8.0) {
        return {};
    }
    const int flags = Qt::AlignTop | Qt::AlignHCenter | Qt::TextWordWrap;
    const QRectF room = shade.adjusted(4, 2, -4, -2);
    const QRectF used = painter.boundingRect(room, flags, band.text).adjusted(-2, 0, 2, 0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(veil(Theme::instance().panel(), 0.7F));
    painter.drawRoundedRect(used, 3, 3);
    painter.setPen(Theme::instance().mutedText());
    painter.drawText(room, flags, band.text);
    return used;
}

void PlotPainter::paintOwnAxis(QPainter& painter, const PlotScale& scale, Qt::Edge edge) const {
    if (!scale.isOwn()) {
        return;
    }
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    const bool flat = edge == Qt::BottomEdge;
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    const double side = edge == Qt::RightEdge ? area.right() : area.left();
    painter.setFont(font);
    const std::vector<double> ticks =
        scale.ownTicks(flat ? area.width() : area.height(), flat ? columnPerTick() : rowPerTick());
    std::vector<QRectF> taken;
    for (const double tick : ticks) {
        const QString text = scale.tickText(tick, data_.locale);
        const double wide = metrics.horizontalAdvance(text) + 2.0;
        QRectF box(0, 0, wide, metrics.height());
        painter.setPen(QPen(theme.grid(), 1));
        if (flat) {
            const double x = area.left() + scale.fraction(tick) * area.width();
            painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
            box.moveTop(area.bottom() + labelGap);
            box.moveLeft(std::min(x - wide / 2.0, size_.width() - wide));
        } else {
            const double y = area.bottom() - scale.fraction(tick) * area.height();
            if (edge == Qt::LeftEdge) {
                painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
            }
            box.moveTop(y - metrics.height() / 2.0);
            box.moveLeft(edge == Qt::LeftEdge ? side - labelGap - wide : side + labelGap);
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
    painter.setPen(QPen(theme.border(), 1));
    if (flat) {
        painter.drawLine(area.bottomLeft(), area.bottomRight());
    } else {
        painter.drawLine(QPointF(side, area.top()), QPointF(side, area.bottom()));
    }
    if (scale.spec.title.isEmpty()) {
        return;
    }
    painter.setPen(theme.mutedText());
    if (flat) {
        painter.drawText(QRectF(area.left(), area.bottom() + 1.5 * labelGap + metrics.height(),
                                area.width(), metrics.height()),
                         Qt::AlignCenter | Qt::TextDontClip,
                         metrics.elidedText(scale.spec.title, Qt::ElideRight, area.width()));
        return;
    }
    painter.save();
    painter.translate(edge == Qt::LeftEdge ? labelGap : size_.width() - labelGap - metrics.height(),
                      area.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-area.height() / 2.0, 0.0, area.height(), metrics.height()),
                     Qt::AlignCenter,
                     metrics.elidedText(scale.spec.title, Qt::ElideRight, area.height()));
    painter.restore();
}

void PlotPainter::paintCurves(QPainter& painter) const {
    paintShades(painter);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(data_.area);
    painter.setBrush(Qt::NoBrush);
    for (const PlotCurve& curve : data_.curves) {
        if (curve.shown) {
            // Round caps and joins are arcs to the stroker: three times the cost, and no pixel of
            // a smooth curve.
            painter.setPen(QPen(Theme::instance().curve(curve.style.colour), curve.style.width,
                                curve.style.pen, Qt::FlatCap, Qt::BevelJoin));
            for (const QPolygonF& stretch : curve.stretches) {
                painter.drawPolyline(stretch);
            }
        }
    }
    painter.restore();
    paintPoints(painter);
}

void PlotPainter::paintCurves(QImage& picture) const {
    const auto any = [this](auto&& is) {
        return std::any_of(data_.curves.begin(), data_.curves.end(), is);
    };
    if (any([this](const PlotCurve& curve) { return data_.showsSpread(curve); })) {
        QPainter painter(&picture);
        paintShades(painter);
    }
    const double ratio = picture.devicePixelRatio();
    LineBrush brush(picture,
                    QRectF(data_.area.topLeft() * ratio, data_.area.size() * ratio).toRect());
    for (const PlotCurve& curve : data_.curves) {
        if (curve.shown && !curve.stretches.empty()) {
            brush.draw(curve.stretches, ratio, Theme::instance().curve(curve.style.colour),
                       curve.style.width * ratio, curve.style.pen);
        }
    }
    if (any([](const PlotCurve& curve) {
            return curve.shown && (curve.style.shape != Shape::Line || !curve.low.empty());
        })) {
        QPainter painter(&picture);
        paintPoints(painter);
    }
}

void PlotPainter::paintShades(QPainter& painter) const {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(data_.area);
    painter.setPen(Qt::NoPen);
    for (const PlotCurve& curve : data_.curves) {
        if (data_.showsSpread(curve)) {
            painter.setBrush(veil(Theme::instance().curve(curve.style.colour),
                                  data_.spreadStale ? 0.12F : 0.26F));
            for (const QPolygonF& shade : curve.shades) {
                painter.drawPolygon(shade);
            }
        }
    }
    painter.restore();
}

void PlotPainter::paintPoints(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(data_.area.adjusted(-4, -4, 4, 4));
    for (const PlotCurve& curve : data_.curves) {
        if (!curve.shown) {
            continue;
        }
        const QColor colour = theme.curve(curve.style.colour);
        paintErrorBars(painter, curve);
        if (curve.style.shape == Shape::Bars) {
            paintBars(painter, curve, Qt::NoPen, colour);
            paintSpreads(painter, curve);
        } else if (curve.style.shape != Shape::Line) {
            const bool hollow = curve.style.shape == Shape::Rings;
            const QPen pen(hollow ? colour : theme.panel(), hollow ? 1.6 : 1.0);
            paintSpreads(painter, curve);
            for (std::size_t i = 0; i < curve.x.size(); ++i) {
                dot(painter, pixel(curve, i), 3.6, pen, hollow ? theme.panel() : colour);
            }
        }
    }
    painter.restore();
}

void PlotPainter::paintBars(QPainter& painter, const PlotCurve& curve, const QPen& pen,
                            const QBrush& brush) const {
    const QRectF& area = data_.area;
    const Side side = curve.style.side;
    painter.setPen(pen);
    painter.setBrush(brush);
    const auto corner = [&](double x, double y) {
        return QPointF(x, std::clamp(y, area.top(), area.bottom()));
    };
    const double foot =
        data_.scale(side).spec.logarithmic ? area.bottom() : data_.toPixel(0.0, 0.0, side).y();
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const double middle = curve.x[i] + curve.style.barShift;
        const double half = 0.5 * curve.style.barWidth;
        const QPointF left = data_.toPixel(middle - half, curve.y[i], side);
        const QPointF right = data_.toPixel(middle + half, curve.y[i], side);
        painter.drawRect(QRectF(corner(left.x(), left.y()), corner(right.x(), foot)).normalized());
    }
}

void PlotPainter::paintSpreads(QPainter& painter, const PlotCurve& curve) const {
    if (!data_.showsSpread(curve) || curve.isLine()) {
        return;
    }
    const Theme& theme = Theme::instance();
    const bool onBar = curve.style.shape == Shape::Bars;
    painter.setPen(QPen(veil(onBar ? theme.text() : theme.curve(curve.style.colour),
                             data_.spreadStale ? 0.45F : 1.0F),
                        1.2));
    const QPointF cap(3, 0);
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const auto [low, high] = data_.spreadAt(curve, i);
        const double middle = curve.x[i] + (onBar ? curve.style.barShift : 0.0);
        const QPointF foot = data_.toPixel(middle, low, curve.style.side);
        const QPointF tip = data_.toPixel(middle, high, curve.style.side);
        if (foot.y() - tip.y() < 1.0) {
            continue;  // nothing to be seen
        }
        painter.drawLine(foot, tip);
        painter.drawLine(foot - cap, foot + cap);
        painter.drawLine(tip - cap, tip + cap);
    }
}

void PlotPainter::paintErrorBars(QPainter& painter, const PlotCurve& curve) const {
    if (curve.low.size() != curve.x.size() || curve.high.size() != curve.x.size()) {
        return;
    }
    painter.setPen(QPen(Theme::instance().curve(curve.style.colour), 1.0));
    const bool upright = curve.bars == Qt::Vertical;
    const QPointF cap = upright ? QPointF(3, 0) : QPointF(0, 3);
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const auto end = [&](double value) {
            return upright ? data_.toPixel(curve.x[i], value, curve.style.side)
                           : data_.toPixel(value, curve.y[i], curve.style.side);
        };
        const QPointF low = end(curve.low[i]);
        const QPointF high = end(curve.high[i]);
        painter.drawLine(low, high);
        for (const QPointF& tip : {low, high}) {
            painter.drawLine(tip - cap, tip + cap);
        }
    }
}

void PlotPainter::paintOverlay(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    painter.setRenderHint(QPainter::Antialiasing);
    if (data_.faded) {
        painter.fillRect(
            QRectF(QPointF(0.0, data_.headerHeight), QPointF(size_.width(), size_.height())),
            veil(theme.panel(), 0.62F));
    }
    painter.save();
    painter.setClipRect(area);
    std::vector<QRectF> taken;
    for (const plot::Band& band : data_.bands) {
        taken.push_back(paintBandWords(painter, band));
    }
    paintLines(painter);
    if (data_.presentX) {
        const double x = across(*data_.presentX);
        painter.setPen(QPen(theme.accent(), 1.4));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        for (const PlotCurve& curve : data_.curves) {
            const auto y = curve.shown ? data_.valueAt(curve, *data_.presentX) : std::nullopt;
            if (y) {
                dot(painter, data_.toPixel(*data_.presentX, *y, curve.style.side), 4.5,
                    QPen(theme.panel(), 1.5), theme.curve(curve.style.colour));
            }
        }
    }
    painter.restore();
    paintMarks(painter, std::move(taken));
    if (data_.faded && !data_.fadedText.isEmpty()) {
        painter.setFont(Theme::font(Theme::baseSize));
        painter.setPen(theme.mutedText());
        painter.drawText(area, Qt::AlignCenter, data_.fadedText);
    }
    if (data_.pointRead) {
        paintPointReadout(painter);
    } else if (data_.cursorX) {
        paintReadout(painter);
    }
}

void PlotPainter::paintLines(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    painter.setFont(Theme::font(Theme::smallSize));
    const auto fitted = [&](const QString& text) {
        return painter.fontMetrics().elidedText(text, Qt::ElideRight,
                                                static_cast<int>(area.width() - 2 * labelGap));
    };
    for (const plot::Line& line : data_.lines) {
        const bool muted = line.colour == plot::Line::muted;
        painter.setPen(QPen(muted ? theme.mutedText() : theme.curve(line.colour), 1.2,
                            muted ? Qt::DotLine : Qt::DashLine));
        if (line.orientation == Qt::Horizontal) {
            const double y = data_.toPixel(data_.x.low, line.at, line.side).y();
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
            drawOnVeil(painter, QPointF(area.left() + labelGap, y - 4), fitted(line.text));
            continue;
        }
        const double x = across(line.at);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        const double wide = painter.fontMetrics().horizontalAdvance(line.text);
        const bool fits = x + 4.0 + wide <= area.right();
        drawOnVeil(
            painter,
            QPointF(fits ? x + 4.0 : x - 4.0 - wide, area.top() + painter.fontMetrics().height()),
            line.text);
    }
}

void PlotPainter::paintMarks(QPainter& painter, std::vector<QRectF> taken) const {
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    painter.setFont(font);
    for (const plot::Mark& mark : data_.marks) {
        const QPointF at = data_.toPixel(mark.x, mark.y, mark.side);
        if (!area.adjusted(-1, -1, 1, 1).contains(at)) {
            continue;
        }
        const QColor colour = theme.curve(mark.colour);
        const double radius = mark.ring ? 7.0 : 3.6;
        dot(painter, at, radius, QPen(mark.ring ? colour : theme.panel(), mark.ring ? 2.0 : 1.2),
            mark.ring ? QBrush() : QBrush(colour));
        if (mark.text.isEmpty()) {
            continue;
        }
        // The label goes where it fits: right, left, above, below, and clear of earlier labels.
        const QSizeF size(metrics.horizontalAdvance(mark.text) + 6, metrics.height() + 1);
        const double away = radius + 3.0;
        const std::array<QPointF, 6> corners{at + QPointF(away, -size.height() / 2),
                                             at + QPointF(-away - size.width(), -size.height() / 2),
                                             at + QPointF(-size.width() / 2, -away - size.height()),
                                             at + QPointF(-size.width() / 2, away),
                                             at + QPointF(away, -away - size.height()),
                                             at + QPointF(away, away)};
        QRectF box(corners[0], size);
        for (const QPointF& corner : corners) {
            const QRectF candidate(corner, size);
            const bool free = std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) {
                return other.intersects(candidate);
            });
            if (area.contains(candidate) && free) {
                box = candidate;
                break;
            }
        }
        box.moveLeft(
            std::clamp(box.left(), area.left(), std::max(area.left(), area.right() - box.width())));
        box.moveTop(
            std::clamp(box.top(), area.top(), std::max(area.top(), area.bottom() - box.height())));
        taken.push_back(box);
        painter.setPen(Qt::NoPen);
        painter.setBrush(veil(theme.panel(), 0.82F));
        painter.drawRoundedRect(box, 3, 3);
        painter.setPen(colour);
        painter.drawText(box, Qt::AlignCenter, mark.text);
    }
}

void PlotPainter::paintReadout(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    const double at = *data_.cursorX;
    const double x = across(at);
    if (x < area.left() - 0.5 || x > area.right() + 0.5) {
        return;
    }
    painter.setPen(QPen(theme.mutedText(), 1.0, Qt::DotLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    const QString equals = QStringLiteral(" = ");
    const QString name = data_.x.spec.title.section(QLatin1Char(','), 0, 0);
    std::vector<Row> rows{
        {(name.isEmpty() ? QStringLiteral("x") : name) + equals + data_.x.readout(at, data_.locale),
         theme.text()}};
    for (const PlotCurve& curve : data_.curves) {
        const auto y = curve.shown ? data_.valueAt(curve, at) : std::nullopt;
        if (!y) {
            continue;
        }
        const QColor colour = theme.curve(curve.style.colour);
        const auto shown = [&](double value) {
            return data_.scale(curve.style.side)
                .readout(value, data_.locale, data_.readoutDecimals);
        };
        const PlotCurve* ghost = data_.ghostOf(curve);
        const auto was = ghost != nullptr ? data_.valueAt(*ghost, at) : std::nullopt;
        const auto spread = data_.spreadAt(curve, at);
        rows.push_back(
            {curve.style.name + equals + shown(*y) +
                 (spread ? QStringLiteral("  [%1 … %2]")
                               .arg(shown(spread->first), shown(spread->second))
                         : QString()) +
                 (was ? QStringLiteral("  (%1: %2)").arg(data_.referenceName, shown(*was))
                      : QString()),
             colour});
        const QPointF point = data_.toPixel(at, *y, curve.style.side);
        if (area.contains(point)) {
            dot(painter, point, 3.4, QPen(theme.panel(), 1.2), colour);
        }
    }
    paintRows(painter, rows, QPointF(x, area.top()), QPointF(10, 6), 0.93F);
}

void PlotPainter::paintPointReadout(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const PlotCurve& curve = data_.curves[data_.pointRead->first];
    const QPointF at = pixel(curve, data_.pointRead->second);
    if (!data_.area.adjusted(-1, -1, 1, 1).contains(at)) {
        return;
    }
    dot(painter, at, 5.0, QPen(theme.text(), 1.6), theme.curve(curve.style.colour));
    std::vector<Row> rows;
    for (const QString& text :
         curve.texts[static_cast<qsizetype>(data_.pointRead->second)].split(QLatin1Char('\n'))) {
        rows.push_back({text, theme.text()});
    }
    paintRows(painter, rows, at, QPointF(12, 8), 0.95F);
}

void PlotPainter::paintRows(QPainter& painter, const std::vector<Row>& rows, const QPointF& at,
                            const QPointF& away, float opacity) const {
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    double wide = 0.0;
    for (const Row& row : rows) {
        wide = std::max(wide, metrics.horizontalAdvance(row.text));
    }
    const double rowHeight = metrics.height() + 2.0;
    QRectF box(at + away, QSizeF(wide + 14.0, rowHeight * static_cast<double>(rows.size()) + 8.0));
    if (box.right() > area.right()) {
        box.moveRight(at.x() - away.x());
    }
    box.moveLeft(std::max(box.left(), area.left()));
    if (box.bottom() > area.bottom() && at.y() > area.top()) {
        box.moveBottom(at.y() - away.y());
    }
    painter.setPen(QPen(theme.border(), 1.0));
    painter.setBrush(veil(theme.panel(), opacity));
    painter.drawRoundedRect(box, 4, 4);
    painter.setFont(font);
    QRectF line(box.left() + 7.0, box.top() + 4.0, wide + 2.0, rowHeight);
    for (const Row& row : rows) {
        painter.setPen(row.colour);
        painter.drawText(line, Qt::AlignVCenter | Qt::AlignLeft, row.text);
        line.translate(0.0, rowHeight);
    }
}

}  // namespace ravnoves
