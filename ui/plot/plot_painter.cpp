#include "plot/plot_painter.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QImage>
#include <QPainter>
#include <QSignalBlocker>
#include <QValueAxis>
#include <algorithm>
#include <utility>

#include "plot/model/axis_title.h"
#include "plot/model/disc.h"
#include "plot/model/label_places.h"
#include "plot/model/line_brush.h"
#include "plot/model/ticks.h"
#include "text/number_text.h"
#include "text/text_width.h"
#include "theme/theme.h"

namespace ravnoves {

using plot::Shape;
using plot::Side;

namespace {

constexpr double titleGap = 2.0;  // from a title to the edge, pixels
/// From a label to what it names, for text of the designed size.
double labelGap() {
    return Theme::withText(6);
}
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
/// With labels of our own: powers stand higher.
double rowPerTick() {
    return Theme::withText(36);
}

void dot(QPainter& painter, const QPointF& at, double radius, const QPen& pen, const QBrush& fill) {
    painter.setPen(pen);
    painter.setBrush(fill);
    paintDisc(painter, at, radius);
}

/// Of the dots of points; rings leave room for a dot in them.
double pointRadius(Shape shape) {
    return strokeScale() * (shape == Shape::Rings ? 5.4 : 3.6);
}

QColor veil(QColor colour, float opacity) {
    colour.setAlphaF(opacity);
    return colour;
}

/// The axis makes all its ticks anew, each as an item of a scene, whenever it hears of a change: it
/// hears of one.
void moveAxis(QValueAxis& axis, double low, double high, double step) {
    constexpr double many = 1e3;  // the ticks are counted from the anchor on, one by one
    const double anchor = std::abs(low) > many * step ? std::ceil(low / step - 1e-9) * step : 0.0;
    const bool hasOtherTicks = axis.tickInterval() != step || axis.tickAnchor() != anchor;
    {
        const QSignalBlocker quiet(axis);
        axis.setTickAnchor(anchor);
        axis.setTickInterval(step);
    }
    const std::pair before(axis.min(), axis.max());
    axis.setRange(low, high);
    if (hasOtherTicks && before == std::pair(axis.min(), axis.max())) {
        {
            const QSignalBlocker quiet(axis);
            axis.setTickInterval(2.0 * step);
        }
        axis.setTickInterval(step);
    }
}

/// The ground of a label, over whatever is drawn there.
void drawVeil(QPainter& painter, const QRectF& box, float opacity = 0.92F) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(veil(Theme::instance().panel(), opacity));
    painter.drawRoundedRect(box, 3, 3);
}

/// A dashed curve on a wider one: its dashes, as long as the gaps that show the other, clear the
/// ground on both sides. So both are told apart whatever their colours. In widths of the curve.
constexpr double cleared = 2.3;
constexpr double dashOnAnother = 5.0;

constexpr double besideLabel = 3.0;  // pixels of a label's ground left and right of it

QSizeF labelSize(const QFont& font, const QString& text) {
    return {std::ceil(textWidth(font, text)) + 2.0 * besideLabel,
            QFontMetricsF(font).height() + 1.0};
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
    const double line = std::ceil(QFontMetricsF(Theme::font(Theme::baseSize, true)).height());
    const QRectF room(0.0, 0.0, std::max(1.0, width), 1e4);
    height = std::max(
        line, std::ceil(QFontMetricsF(font).boundingRect(room, PlotTitle::flags, title).height()));
    this->width = textWidth(font, title);
}

PlotPainter::PlotPainter(PlotData& data)
    : data_(data), scene_(std::make_unique<QGraphicsScene>()), chart_(new QChart) {
    scene_->addItem(chart_);
    chart_->setBackgroundVisible(false);
    chart_->legend()->hide();
    chart_->setAnimationOptions(QChart::NoAnimation);
    chart_->layout()->setContentsMargins(0, 0, 0, 0);
    chart_->setMargins(QMargins());
}

PlotPainter::~PlotPainter() = default;

void PlotPainter::layout(const QSizeF& size, const Margins& least, bool& axesStale) {
    const bool resized = laidOut_ != size;
    laidOut_ = size;
    layoutArea(size, least);
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

PlotPainter::Margins PlotPainter::margins(const QSizeF& size) {
    size_ = size;
    data_.fitScales();
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    const double height = heightOfArea();
    // Of copies: the steps of the plot are those of its area, which these margins only lead to.
    const auto margin = [&](PlotScale scale) {
        // The ticks that the axis will get decide how many decimals the labels have.
        scale.chooseStep(height, chartRowPerTick());
        double widest = 0.0;
        for (const double tick : scale.ticks(height, rowPerTick())) {
            widest = std::max(widest, textWidth(font, scale.tickText(tick, data_.locale)));
        }
        const double title = scale.spec.title.isEmpty() ? 0.0 : metrics.height() + labelGap();
        return std::ceil(widest + title + 2 * labelGap());
    };
    const double left = margin(data_.left);
    const auto lastLabel = [&] {  // stands half beyond the axis
        PlotScale x = data_.x;
        chooseColumns(x, std::max(20.0, size_.width() - left));
        return textWidth(font, x.tickText(x.high, data_.locale));
    };
    return {left, data_.sideUsed(Side::Right)
                      ? margin(data_.right)
                      : std::max(Theme::margin + 4.0, lastLabel() / 2.0 + labelGap())};
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

void PlotPainter::layoutArea(const QSizeF& size, const Margins& least) {
    const Margins own = margins(size);
    const double left = std::max(own.left, least.left);
    const double right = std::max(own.right, least.right);
    data_.area = QRectF(left, data_.headerHeight + topGap(),
                        std::max(20.0, size_.width() - left - right), heightOfArea());
    data_.flatRoom = size_.width() - 2.0 * titleGap;
    // Not down into the row of the other title.
    const double below = data_.x.spec.title.isEmpty()
                             ? 0.0
                             : QFontMetricsF(Theme::font(Theme::smallSize)).height() + labelGap();
    data_.uprightRoom = size_.height() - data_.headerHeight - below - titleGap;
    if (data_.equalScale) {
        data_.equalise();
    }
}

void PlotPainter::layoutAxes() {
    const Theme& theme = Theme::instance();
    const auto apply = [&](std::size_t number, const PlotScale& scale, Qt::Alignment edge) {
        QValueAxis*& axis = axes_[number];
        if (axis == nullptr) {
            axis = new QValueAxis;
            chart_->addAxis(axis, edge);
            axis->setTickType(QValueAxis::TicksDynamic);
            axis->setTickAnchor(0.0);
            axis->setMinorGridLineVisible(false);
            axis->setGridLineVisible(edge != Qt::AlignRight);
            // Numbers and title are painted by hand: a true minus, a unit that stays. The chart
            // would lay out, as rich text, even numbers that it does not show: without a place
            // for the number in their format they are empty.
            axis->setLabelFormat(QStringLiteral(" "));
            axis->setLabelsVisible(false);
            axis->setTitleVisible(false);
        }
        axis->setVisible(!scale.isOwn());
        axis->setLinePen(QPen(theme.border(), 1));
        // Over a picture the grid gives way.
        axis->setGridLinePen(
            QPen(data_.image.isNull() ? theme.grid() : veil(theme.text(), 0.09F), 1));
        if (!scale.isOwn()) {
            moveAxis(*axis, scale.number(scale.low), scale.number(scale.high), scale.step);
        }
    };
    chooseColumns(data_.x, data_.area.width());
    data_.left.chooseStep(data_.area.height(), chartRowPerTick());
    data_.right.chooseStep(data_.area.height(), chartRowPerTick());
    apply(0, data_.x, Qt::AlignBottom);
    apply(1, data_.left, Qt::AlignLeft);
    if (data_.sideUsed(Side::Right)) {
        apply(2, data_.right, Qt::AlignRight);
    }
    // A new plot area alone does not lay out anything; in this order it is done once.
    scene_->setSceneRect(QRectF(QPointF(), size_));
    chart_->layout()->invalidate();
    chart_->setPlotArea(data_.area);
    chart_->resize(size_);
    chart_->layout()->activate();
}

void PlotPainter::paintAxes(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    const double room = size_.width() - 2.0 * Theme::margin;
    const PlotTitle title(data_.title, room);
    painter.setFont(title.font);
    painter.setPen(Theme::instance().text());
    painter.drawText(QRectF(Theme::margin, Theme::gap, room, title.height + Theme::gap),
                     PlotTitle::flags, data_.title);
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
    const QRectF whole(QPointF(), size_);
    scene_->render(&painter, whole, whole);
    paintAxis(painter, data_.x, Qt::BottomEdge);
    paintAxis(painter, data_.left, Qt::LeftEdge);
    if (data_.sideUsed(Side::Right)) {
        paintAxis(painter, data_.right, Qt::RightEdge);
    }
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
                dot(painter, pixel(*ghost, i), pointRadius(ghost->style.shape), QPen(colour, 1.2),
                    Qt::NoBrush);
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
    const QRectF used =
        painter.boundingRect(room, flags, band.text).adjusted(-besideLabel, 0, besideLabel, 0);
    // At the top, or where fewer curves pass.
    constexpr int heights = 16;
    std::vector<QRectF> candidates;
    for (int i = 0; i <= heights; ++i) {
        const double free = std::max(0.0, room.height() - used.height());
        const QRectF candidate = used.translated(0.0, free * i / heights);
        if (!places.meetsLabel(candidate)) {
            candidates.push_back(candidate);
        }
    }
    if (candidates.empty()) {
        return;  // the values in it say more
    }
    const QRectF box = places.place(candidates);
    // The line of the present value may pass wherever it is.
    drawVeil(painter, box, 0.96F);
    painter.setPen(Theme::instance().mutedText());
    painter.drawText(box.adjusted(1, 0, -1, 0), flags, band.text);
}

void PlotPainter::paintAxis(QPainter& painter, const PlotScale& scale, Qt::Edge edge) const {
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    const bool own = scale.isOwn();  // of others grid and line are the chart's
    const bool flat = edge == Qt::BottomEdge;
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    const double side = edge == Qt::RightEdge ? area.right() : area.left();
    painter.setFont(font);
    const std::vector<double> ticks =
        scale.ticks(flat ? area.width() : area.height(), flat ? columnPerTick() : rowPerTick());
    std::vector<QRectF> taken;
    for (const double tick : ticks) {
        const QString text = scale.tickText(tick, data_.locale);
        const double wide = textWidth(font, text) + 2.0;
        QRectF box(0, 0, wide, metrics.height());
        painter.setPen(QPen(theme.grid(), 1));
        if (flat) {
            const double x = area.left() + scale.fraction(tick) * area.width();
            if (own) {
                painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
            }
            box.moveTop(area.bottom() + labelGap());
            box.moveLeft(std::min(x - wide / 2.0, size_.width() - wide));
        } else {
            const double y = area.bottom() - scale.fraction(tick) * area.height();
            if (own && edge == Qt::LeftEdge) {
                painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
            }
            box.moveTop(y - metrics.height() / 2.0);
            box.moveLeft(edge == Qt::LeftEdge ? side - labelGap() - wide : side + labelGap());
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
    if (own && flat) {
        painter.drawLine(area.bottomLeft(), area.bottomRight());
    } else if (own) {
        painter.drawLine(QPointF(side, area.top()), QPointF(side, area.bottom()));
    }
    if (scale.spec.title.isEmpty()) {
        return;
    }
    painter.setPen(theme.mutedText());
    // In the middle of the chart, but beyond its ends rather than cut.
    const double room = flat ? data_.flatRoom : data_.uprightRoom;
    const double from = flat ? titleGap : data_.headerHeight;
    const QString title = fittedAxisTitle(scale.spec.title, font, room);
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
    painter.translate(
        edge == Qt::LeftEdge ? labelGap() : size_.width() - labelGap() - metrics.height(), middle);
    painter.rotate(-90.0);
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, title);
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
            QPen pen(Theme::instance().curve(curve.style.colour), strokeScale() * curve.style.width,
                     curve.style.pen, Qt::FlatCap, Qt::BevelJoin);
            if (data_.liesOnAnother(curve)) {
                QPen ground(Theme::instance().panel(), cleared * pen.widthF(), Qt::SolidLine,
                            Qt::FlatCap, Qt::BevelJoin);
                ground.setDashPattern({dashOnAnother / cleared, dashOnAnother / cleared});
                pen.setDashPattern({dashOnAnother, dashOnAnother});
                painter.setPen(ground);
                for (const QPolygonF& stretch : curve.stretches) {
                    painter.drawPolyline(stretch);
                }
            }
            painter.setPen(pen);
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
            const double width = strokeScale() * curve.style.width * ratio;
            const QColor colour = Theme::instance().curve(curve.style.colour);
            if (data_.liesOnAnother(curve)) {
                const QList<qreal> dashes{dashOnAnother * width, dashOnAnother * width};
                brush.draw(curve.stretches, ratio, Theme::instance().panel(), cleared * width,
                           dashes);
                brush.draw(curve.stretches, ratio, colour, width, dashes);
            } else {
                brush.draw(curve.stretches, ratio, colour, width, curve.style.pen);
            }
        }
    }
    if (any([this](const PlotCurve& curve) {
            return curve.shown && (curve.style.shape != Shape::Line || !curve.low.empty() ||
                                   shrunkTo(curve).has_value());
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
    const double reach = strokeScale() * 4.0;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(data_.area.adjusted(-reach, -reach, reach, reach));
    for (const PlotCurve& curve : data_.curves) {
        if (!curve.shown) {
            continue;
        }
        const QColor colour = theme.curve(curve.style.colour);
        paintErrorBars(painter, curve);
        if (curve.style.shape == Shape::Bars) {
            paintBars(painter, curve, Qt::NoPen, colour);
            if (const PlotCurve* ghost = data_.ghostOf(curve)) {
                const double width = strokeScale() * 1.2;
                paintBars(painter, *ghost, QPen(theme.panel(), 2.0 * width), Qt::NoBrush);
                paintBars(painter, *ghost, QPen(theme.text(), width, Qt::DashLine), Qt::NoBrush);
            }
            paintSpreads(painter, curve);
        } else if (curve.style.shape != Shape::Line) {
            const bool hollow = curve.style.shape == Shape::Rings;
            const QPen pen(hollow ? colour : theme.panel(), strokeScale() * (hollow ? 1.6 : 1.0));
            paintSpreads(painter, curve);
            for (std::size_t i = 0; i < curve.x.size(); ++i) {
                dot(painter, pixel(curve, i), pointRadius(curve.style.shape), pen,
                    hollow ? theme.panel() : colour);
            }
        } else if (const auto at = shrunkTo(curve)) {
            dot(painter, *at, strokeScale() * 3.0, Qt::NoPen, colour);
        }
    }
    painter.restore();
}

std::optional<QPointF> PlotPainter::shrunkTo(const PlotCurve& curve) {
    constexpr double smallest = 2.0;  // pixels
    QRectF whole;
    for (const QPolygonF& stretch : curve.stretches) {
        // What has neither width nor height is nothing to a union.
        whole = whole.united(stretch.boundingRect().adjusted(-0.1, -0.1, 0.1, 0.1));
        if (whole.width() > smallest || whole.height() > smallest) {
            return std::nullopt;
        }
    }
    return whole.isEmpty() ? std::nullopt : std::optional(whole.center());
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
    paintLines(painter);
    if (data_.presentX) {
        const double x = across(*data_.presentX);
        painter.setPen(QPen(theme.accent(), strokeScale() * 1.4));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        for (const PlotCurve& curve : data_.curves) {
            const auto y = curve.shown ? data_.valueAt(curve, *data_.presentX) : std::nullopt;
            if (y) {
                dot(painter, data_.toPixel(*data_.presentX, *y, curve.style.side),
                    strokeScale() * 4.5, QPen(theme.panel(), strokeScale() * 1.5),
                    theme.curve(curve.style.colour));
            }
        }
    }
    const bool readsCurves = data_.cursorX && !data_.pointRead;
    if (readsCurves) {
        painter.setPen(QPen(theme.mutedText(), 1.0, Qt::DotLine));
        const double x = across(*data_.readX());
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
    painter.restore();
    paintLabels(painter);
    if (data_.faded && !data_.fadedText.isEmpty()) {
        painter.setFont(Theme::font(Theme::baseSize));
        painter.setPen(theme.mutedText());
        painter.drawText(area, Qt::AlignCenter, data_.fadedText);
    }
    if (data_.pointRead) {
        paintPointReadout(painter);
    } else if (readsCurves) {
        paintReadout(painter);
    }
}

void PlotPainter::paintLines(QPainter& painter) const {
    for (const plot::Line& line : data_.lines) {
        const bool muted = line.colour == plot::Line::muted;
        painter.setPen(
            QPen(colourOf(line), strokeScale() * 1.2, muted ? Qt::DotLine : Qt::DashLine));
        painter.drawLine(strokeOf(line));
    }
}

QColor PlotPainter::colourOf(const plot::Line& line) {
    const Theme& theme = Theme::instance();
    return line.colour == plot::Line::muted ? theme.mutedText() : theme.curve(line.colour);
}

QLineF PlotPainter::strokeOf(const plot::Line& line) const {
    const QRectF& area = data_.area;
    if (line.orientation == Qt::Horizontal) {
        const double y = data_.toPixel(data_.x.low, line.at, line.side).y();
        return {area.left(), y, area.right(), y};
    }
    const double x = across(line.at);
    return {x, area.top(), x, area.bottom()};
}

LabelPlaces PlotPainter::drawnPlaces() const {
    LabelPlaces places(data_.area);
    for (const PlotCurve& curve : data_.curves) {
        if (!curve.shown) {
            continue;
        }
        for (const QPolygonF& stretch : curve.stretches) {
            places.addLine(stretch);
        }
        const auto add = [&](double lowX, double lowY, double highX, double highY, double room) {
            places.addShape(QRectF(data_.toPixel(lowX, lowY, curve.style.side),
                                   data_.toPixel(highX, highY, curve.style.side))
                                .normalized()
                                .adjusted(-room, -room, room, room));
        };
        const double radius = pointRadius(curve.style.shape) + 0.4;
        for (std::size_t i = 0; curve.style.shape != Shape::Line && i < curve.x.size(); ++i) {
            if (curve.style.shape == Shape::Bars) {
                const double middle = curve.x[i] + curve.style.barShift;
                const double half = 0.5 * curve.style.barWidth;
                const double foot = data_.scale(curve.style.side).low;
                add(middle - half, std::max(0.0, foot), middle + half, curve.y[i], 0.0);
            } else {
                add(curve.x[i], curve.y[i], curve.x[i], curve.y[i], radius);
            }
        }
        for (std::size_t i = 0; i < std::min(curve.low.size(), curve.x.size()); ++i) {
            const bool upright = curve.bars == Qt::Vertical;
            add(upright ? curve.x[i] : curve.low[i], upright ? curve.low[i] : curve.y[i],
                upright ? curve.x[i] : curve.high[i], upright ? curve.high[i] : curve.y[i], 1.0);
        }
    }
    for (const plot::Line& line : data_.lines) {
        places.addLine(strokeOf(line).p1(), strokeOf(line).p2());
    }
    for (const plot::Mark& mark : data_.marks) {
        const QPointF at = data_.toPixel(mark.x, mark.y, mark.side);
        const QPointF corner(radiusOf(mark), radiusOf(mark));
        places.addShape(QRectF(at - corner, at + corner));
    }
    return places;
}

void PlotPainter::paintLabels(QPainter& painter) const {
    const auto hasText = [](const auto& each) { return !each.text.isEmpty(); };
    paintMarks(painter);
    if (std::none_of(data_.marks.begin(), data_.marks.end(), hasText) &&
        std::none_of(data_.lines.begin(), data_.lines.end(), hasText) &&
        std::none_of(data_.bands.begin(), data_.bands.end(), hasText)) {
        return;
    }
    // What belongs to a point chooses first.
    LabelPlaces places = drawnPlaces();
    for (const plot::Mark& mark : data_.marks) {
        labelMark(painter, mark, places);
    }
    for (const plot::Line& line : data_.lines) {
        labelLine(painter, line, places);
    }
    for (const plot::Band& band : data_.bands) {
        paintBandWords(painter, band, places);
    }
}

void PlotPainter::labelLine(QPainter& painter, const plot::Line& line, LabelPlaces& places) const {
    const QRectF& area = data_.area;
    const QLineF stroke = strokeOf(line);
    const QFont font = Theme::font(Theme::smallSize);
    const bool flat = line.orientation == Qt::Horizontal;
    if (line.text.isEmpty()) {
        return;
    }
    if (sideBeyond(line) != 0) {
        if (line.keptAtEdge) {
            labelBeyond(painter, line, places);
        }
        return;
    }
    const QString text =
        QFontMetricsF(font).elidedText(line.text, Qt::ElideRight, area.width() - 2.0 * labelGap());
    const QSizeF size = labelSize(font, text);
    constexpr int steps = 16;
    constexpr double away = 2.0;
    std::vector<QRectF> candidates;
    for (int i = 0; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        if (flat) {
            const double x =
                area.left() + away + part * std::max(0.0, area.width() - size.width() - 2.0 * away);
            candidates.emplace_back(QPointF(x, stroke.y1() - away - size.height()), size);
            candidates.emplace_back(QPointF(x, stroke.y1() + away), size);
        } else {
            const double y = area.top() + away +
                             part * std::max(0.0, area.height() - size.height() - 2.0 * away);
            candidates.emplace_back(QPointF(stroke.x1() + away, y), size);
            candidates.emplace_back(QPointF(stroke.x1() - away - size.width(), y), size);
        }
    }
    const QRectF box = places.place(candidates);
    painter.setFont(font);
    drawVeil(painter, box);
    painter.setPen(Theme::instance().readable(colourOf(line)));
    painter.drawText(box, Qt::AlignCenter, text);
}

int PlotPainter::sideBeyond(const plot::Line& line) const {
    const PlotScale& scale = line.orientation == Qt::Horizontal ? data_.scale(line.side) : data_.x;
    const double at = scale.fraction(line.at);
    constexpr double rounding = 1e-3;
    return at < -rounding ? -1 : at > 1.0 + rounding ? 1 : 0;
}

void PlotPainter::labelBeyond(QPainter& painter, const plot::Line& line,
                              LabelPlaces& places) const {
    const bool flat = line.orientation == Qt::Horizontal;
    const PlotScale& scale = flat ? data_.scale(line.side) : data_.x;
    const QRectF& area = data_.area;
    const QFont font = Theme::font(Theme::smallSize);
    constexpr double arrow = 8.0;  // pixels
    const QString text = QFontMetricsF(font).elidedText(
        line.text + QLatin1Char(' ') + scale.readout(line.at, data_.locale), Qt::ElideRight,
        area.width() - arrow - 2.0 * labelGap());
    const QSizeF size = labelSize(font, text);
    // At the edge that it lies beyond, the arrow's point on that.
    const double sign = sideBeyond(line);
    constexpr int steps = 6;
    std::vector<QRectF> candidates;
    for (int i = 0; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        const double along = flat ? area.left() + labelGap() +
                                        part * (area.width() - size.width() - 2.0 * labelGap())
                                  : area.top() + labelGap() +
                                        part * (area.height() - size.height() - 2.0 * labelGap());
        const double away = arrow + 2.0;
        candidates.emplace_back(
            flat ? QPointF(along,
                           sign > 0.0 ? area.top() + away : area.bottom() - away - size.height())
                 : QPointF(sign > 0.0 ? area.right() - away - size.width() : area.left() + away,
                           along),
            size);
    }
    const QRectF box = places.place(candidates);
    painter.setFont(font);
    drawVeil(painter, box);
    painter.setBrush(colourOf(line));
    const QPointF ahead = flat ? QPointF(0.0, -sign) : QPointF(sign, 0.0);
    const QPointF across(ahead.y(), ahead.x());
    const QPointF tip = flat ? QPointF(box.center().x(), sign > 0.0 ? area.top() : area.bottom())
                             : QPointF(sign > 0.0 ? area.right() : area.left(), box.center().y());
    painter.drawPolygon(QPolygonF{tip, tip - arrow * ahead + 0.5 * arrow * across,
                                  tip - arrow * ahead - 0.5 * arrow * across});
    painter.setPen(Theme::instance().readable(colourOf(line)));
    painter.drawText(box, Qt::AlignCenter, text);
}

double PlotPainter::radiusOf(const plot::Mark& mark) {
    return strokeScale() * (mark.ring ? 7.0 : 3.6);
}

bool PlotPainter::isSeen(const plot::Mark& mark) const {
    return data_.area.adjusted(-1, -1, 1, 1).contains(data_.toPixel(mark.x, mark.y, mark.side));
}

void PlotPainter::paintMarks(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    for (const plot::Mark& mark : data_.marks) {
        if (isSeen(mark)) {
            const QColor colour = theme.curve(mark.colour);
            dot(painter, data_.toPixel(mark.x, mark.y, mark.side), radiusOf(mark),
                QPen(mark.ring ? colour : theme.panel(), strokeScale() * (mark.ring ? 2.0 : 1.2)),
                mark.ring ? QBrush() : QBrush(colour));
        }
    }
}

void PlotPainter::labelMark(QPainter& painter, const plot::Mark& mark, LabelPlaces& places) const {
    if (mark.text.isEmpty() || !isSeen(mark)) {
        return;
    }
    const QPointF at = data_.toPixel(mark.x, mark.y, mark.side);
    const QFont font = Theme::font(Theme::smallSize);
    const QSizeF size = labelSize(font, mark.text);
    // Right, left, above, below and between, and farther off where something is near.
    std::vector<QRectF> candidates;
    for (const double farther : {0.0, 0.8, 1.8, 3.0}) {
        const double away = radiusOf(mark) + 3.0 + farther * size.height();
        const double left = -away - size.width();
        const double above = -away - size.height();
        const double slant = 0.7 * away;
        for (const QPointF& corner :
             {QPointF(away, -size.height() / 2), QPointF(left, -size.height() / 2),
              QPointF(-size.width() / 2, above), QPointF(-size.width() / 2, away),
              QPointF(slant, -slant - size.height()), QPointF(slant, slant),
              QPointF(-slant - size.width(), -slant - size.height()),
              QPointF(-slant - size.width(), slant)}) {
            candidates.emplace_back(at + corner, size);
        }
    }
    const QRectF box = places.place(candidates);
    const QColor colour = Theme::instance().curve(mark.colour);
    // A line to the point that it is far from.
    const QPointF edge(std::clamp(at.x(), box.left(), box.right()),
                       std::clamp(at.y(), box.top(), box.bottom()));
    const QLineF leader(at, edge);
    constexpr double close = 8.0;
    if (leader.length() > radiusOf(mark) + close) {
        painter.setPen(QPen(veil(colour, 0.6F), 1.0));
        painter.drawLine(leader.pointAt(radiusOf(mark) / leader.length()), edge);
    }
    painter.setFont(font);
    drawVeil(painter, box);
    painter.setPen(Theme::instance().readable(colour));
    painter.drawText(box, Qt::AlignCenter, mark.text);
}

void PlotPainter::paintReadout(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    const double at = *data_.readX();
    const double x = across(at);
    if (x < area.left() - 0.5 || x > area.right() + 0.5) {
        return;
    }
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
             theme.readable(colour)});
        const bool isBar = curve.style.shape == Shape::Bars;
        const QPointF point =
            data_.toPixel(at + (isBar ? curve.style.barShift : 0.0), *y, curve.style.side);
        if (area.contains(point)) {
            dot(painter, point, strokeScale() * 3.4, QPen(theme.panel(), 1.2), colour);
        }
    }
    paintRows(painter, rows, QPointF(x, area.top()), QPointF(10, 6), 0.93F);
}

std::vector<PlotPainter::Row> PlotPainter::rowsOfPath(const PlotCurve& curve,
                                                      std::size_t point) const {
    const Theme& theme = Theme::instance();
    const PlotCurve* ghost = data_.ghostOf(curve);
    const bool both = ghost != nullptr && ghost->x.size() == curve.x.size();
    const auto line = [&](const PlotScale& scale, double value, double was) {
        const QString old = both ? QStringLiteral("  (%1: %2)")
                                       .arg(data_.referenceName, scale.readout(was, data_.locale))
                                 : QString();
        return Row{scale.spec.title.section(QLatin1Char(','), 0, 0) + QStringLiteral(" = ") +
                       scale.readout(value, data_.locale) + old,
                   theme.text()};
    };
    const PlotCurve& other = both ? *ghost : curve;
    return {{curve.style.name, theme.readable(theme.curve(curve.style.colour))},
            {QStringLiteral("φ = %1°").arg(fixedNumber(curve.angleOf(point), 1, data_.locale)),
             theme.text()},
            line(data_.x, curve.x[point], other.x[point]),
            line(data_.scale(curve.style.side), curve.y[point], other.y[point])};
}

void PlotPainter::paintPointReadout(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const PlotCurve& curve = data_.curves[data_.pointRead->first];
    const QPointF at = pixel(curve, data_.pointRead->second);
    if (!data_.area.adjusted(-1, -1, 1, 1).contains(at)) {
        return;
    }
    dot(painter, at, strokeScale() * 5.0, QPen(theme.text(), 1.6), theme.curve(curve.style.colour));
    std::vector<Row> rows;
    if (curve.style.turn > 0.0) {
        rows = rowsOfPath(curve, data_.pointRead->second);
    } else {
        for (const QString& text :
             curve.texts[static_cast<qsizetype>(data_.pointRead->second)].split(
                 QLatin1Char('\n'))) {
            rows.push_back({text, theme.text()});
        }
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
