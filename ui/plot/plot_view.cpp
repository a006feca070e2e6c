#include "plot/plot_view.h"

#include <QAction>
#include <QApplication>
#include <QChart>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QKeyEvent>
#include <QLogValueAxis>
#include <QMenu>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSvgGenerator>
#include <QValueAxis>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "plot/legend_item.h"
#include "plot/thin_polyline.h"
#include "plot/ticks.h"
#include "theme/theme.h"
#include "widgets/csv_format.h"

namespace ravnoves {

struct PlotView::AxisState {
    Axis spec;
    QAbstractAxis* chartAxis = nullptr;  // owned by the chart
    double low = 0.0;                    ///< shown interval
    double high = 1.0;
    std::optional<std::pair<double, double>> fixed;
    double step = 1.0;

    /// Position of a value on the axis, 0 at low and 1 at high.
    double fraction(double value) const {
        if (spec.logarithmic) {
            return (std::log10(std::max(value, 1e-300)) - std::log10(low)) /
                   (std::log10(high) - std::log10(low));
        }
        return (value - low) / (high - low);
    }
    double value(double fraction) const {
        if (spec.logarithmic) {
            return std::pow(10.0,
                            std::log10(low) + fraction * (std::log10(high) - std::log10(low)));
        }
        return low + fraction * (high - low);
    }
};

struct PlotView::Curve {
    CurveStyle style;
    QPolygonF pixels;  ///< the line as drawn, thinned
    LegendItem* button = nullptr;
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> low;
    std::vector<double> high;
    bool ascending = true;  ///< x never decreases, so the cursor may interpolate
    bool shown = true;
    bool stale = true;
};

namespace {

constexpr int labelGap = 6;
constexpr double zoomPerStep = 1.2;
constexpr double columnPerTick = 56.0;  ///< pixels along x that a tick label needs
constexpr double rowPerTick = 36.0;     ///< and along y

double chooseStep(double span, double pixels, double pixelsPerTick, bool degrees) {
    const int wanted = std::clamp(static_cast<int>(pixels / pixelsPerTick), 2, 16);
    return degrees ? niceAngleStep(span, wanted) : niceStep(span, wanted);
}

}  // namespace

PlotView::PlotView(const QString& title, QWidget* parent)
    : QWidget(parent),
      scene_(std::make_unique<QGraphicsScene>()),
      x_(std::make_unique<AxisState>()),
      left_(std::make_unique<AxisState>()),
      right_(std::make_unique<AxisState>()) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);

    chart_ = new QChart;
    scene_->addItem(chart_);
    chart_->setBackgroundVisible(false);
    chart_->legend()->hide();
    chart_->setLocalizeNumbers(true);
    chart_->setAnimationOptions(QChart::NoAnimation);
    chart_->layout()->setContentsMargins(0, 0, 0, 0);
    chart_->setMargins(QMargins());
    setTitle(title);
    setXAxis({});
    setYAxis(Side::Left, {});
    applyTheme();
    connect(&Theme::instance(), &Theme::changed, this, &PlotView::applyTheme);
}

PlotView::~PlotView() = default;

void PlotView::setTitle(const QString& title) {
    title_ = title;
    setAccessibleName(title);
    chartChanged();
}

PlotView::AxisState& PlotView::axis(Side side) {
    return side == Side::Left ? *left_ : *right_;
}
const PlotView::AxisState& PlotView::axis(Side side) const {
    return side == Side::Left ? *left_ : *right_;
}

bool PlotView::sideUsed(Side side) const {
    return side == Side::Left ||
           std::any_of(curves_.begin(), curves_.end(),
                       [&](const auto& curve) { return curve->style.side == side; });
}

void PlotView::setXAxis(const Axis& spec) {
    x_->spec = spec;
    x_->low = spec.min;
    x_->high = spec.max;
    zoomed_ = false;
    if (x_->chartAxis == nullptr ||
        (qobject_cast<QLogValueAxis*>(x_->chartAxis) != nullptr) != spec.logarithmic) {
        delete x_->chartAxis;
        x_->chartAxis = spec.logarithmic ? static_cast<QAbstractAxis*>(new QLogValueAxis)
                                         : static_cast<QAbstractAxis*>(new QValueAxis);
        chart_->addAxis(x_->chartAxis, Qt::AlignBottom);
        applyTheme();
    }
    seriesStale_ = true;
    chartChanged();
}

void PlotView::setYAxis(Side side, const Axis& spec) {
    AxisState& state = axis(side);
    state.spec = spec;
    if (state.chartAxis == nullptr ||
        (qobject_cast<QLogValueAxis*>(state.chartAxis) != nullptr) != spec.logarithmic) {
        delete state.chartAxis;
        state.chartAxis = spec.logarithmic ? static_cast<QAbstractAxis*>(new QLogValueAxis)
                                           : static_cast<QAbstractAxis*>(new QValueAxis);
        chart_->addAxis(state.chartAxis, side == Side::Left ? Qt::AlignLeft : Qt::AlignRight);
        applyTheme();
    }
    if (spec.logarithmic && !(state.low > 0.0)) {
        state.low = 0.1;
        state.high = 1.0;
    }
    chartChanged();
}

void PlotView::setYRange(Side side, double min, double max) {
    if (!std::isfinite(min) || !std::isfinite(max)) {
        return;
    }
    AxisState& state = axis(side);
    const double pad = state.spec.logarithmic ? 0.0 : 0.03 * (max - min);
    const std::pair wanted(min - pad, max + pad);
    if (!(wanted.first < wanted.second)) {
        return;
    }
    if (state.fixed == wanted) {
        return;
    }
    state.fixed = wanted;
    chartChanged();
}

void PlotView::followData(Side side) {
    if (!axis(side).fixed) {
        return;
    }
    axis(side).fixed.reset();
    chartChanged();
}

void PlotView::setEqualScale(bool equal) {
    equalScale_ = equal;
    seriesStale_ = true;
    chartChanged();
}

int PlotView::addCurve(const CurveStyle& style) {
    auto curve = std::make_unique<Curve>();
    curve->style = style;
    curve->shown = style.shown;
    if (style.side == Side::Right && right_->chartAxis == nullptr) {
        setYAxis(Side::Right, {});
    }
    const int number = static_cast<int>(curves_.size());
    if (style.inLegend) {
        curve->button = new LegendItem(this);
        curve->button->setChecked(style.shown);
        curve->button->show();
        connect(curve->button, &LegendItem::toggled, this,
                [this, number](bool on) { setCurveShown(number, on); });
    }
    curves_.push_back(std::move(curve));
    setCurveStyle(number, style);
    return number;
}

void PlotView::setCurveStyle(int number, const CurveStyle& style) {
    Curve& curve = *curves_.at(static_cast<std::size_t>(number));
    curve.style = style;
    const QColor colour = Theme::instance().curve(style.colour);
    curve.stale = true;
    if (curve.button != nullptr) {
        curve.button->setText(style.name);
        curve.button->setVisible(!style.name.isEmpty());
        curve.button->setAccessibleName(tr("Show %1").arg(style.name));
        curve.button->setToolTip(style.toolTip.isEmpty() ? tr("Show or hide %1").arg(style.name)
                                                         : style.toolTip);
        curve.button->setSwatch(colour, style.pen);
    }
    chartChanged();
}

void PlotView::setCurve(int number, std::vector<double> x, std::vector<double> y) {
    Curve& curve = *curves_.at(static_cast<std::size_t>(number));
    const std::size_t count = std::min(x.size(), y.size());
    x.resize(count);
    y.resize(count);
    std::size_t finite = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const bool drawable = std::isfinite(x[i]) && std::isfinite(y[i]) &&
                              (!x_->spec.logarithmic || x[i] > 0.0) &&
                              (!axis(curve.style.side).spec.logarithmic || y[i] > 0.0);
        if (drawable) {
            x[finite] = x[i];
            y[finite] = y[i];
            ++finite;
        }
    }
    x.resize(finite);
    y.resize(finite);
    if (x == curve.x && y == curve.y) {
        return;
    }
    curve.ascending = std::is_sorted(x.begin(), x.end());
    curve.x = std::move(x);
    curve.y = std::move(y);
    curve.stale = true;
    curvesChanged();
}

void PlotView::setErrorBars(int number, std::vector<double> low, std::vector<double> high) {
    Curve& curve = *curves_.at(static_cast<std::size_t>(number));
    curve.low = std::move(low);
    curve.high = std::move(high);
    curvesChanged();
}

void PlotView::setCurveShown(int number, bool shown) {
    Curve& curve = *curves_.at(static_cast<std::size_t>(number));
    if (curve.shown == shown) {
        return;
    }
    curve.shown = shown;
    if (curve.button != nullptr) {
        curve.button->setChecked(shown);
    }
    curve.stale = true;
    curvesChanged();
    Q_EMIT curveToggled(number, shown);
}

bool PlotView::isCurveShown(int number) const {
    return curves_.at(static_cast<std::size_t>(number))->shown;
}

QString PlotView::curveName(int number) const {
    return curves_.at(static_cast<std::size_t>(number))->style.name;
}

int PlotView::curveCount() const {
    return static_cast<int>(curves_.size());
}

void PlotView::setImage(const QImage& image, const QRectF& values) {
    image_ = image;
    imageValues_ = values;
    chartChanged();
}

void PlotView::setMarks(std::vector<Mark> marks) {
    marks_ = std::move(marks);
    update();
}

void PlotView::setBands(std::vector<Band> bands) {
    bands_ = std::move(bands);
    chartChanged();
}

void PlotView::setLines(std::vector<Line> lines) {
    lines_ = std::move(lines);
    update();
}

void PlotView::setPresentX(std::optional<double> x) {
    if (presentX_ != x) {
        presentX_ = x;
        update();
    }
}

void PlotView::setCursorX(std::optional<double> x) {
    if (cursorX_ != x) {
        cursorX_ = x;
        update();
    }
}

void PlotView::setPickable(bool pickable) {
    pickable_ = pickable;
    setCursor(pickable ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void PlotView::resetZoom() {
    zoomed_ = false;
    chartChanged();
}

void PlotView::curvesChanged() {
    pictureStale_ = true;
    update();
}

void PlotView::chartChanged() {
    axesStale_ = true;
    pictureStale_ = true;
    update();
}

void PlotView::applyTheme() {
    const Theme& theme = Theme::instance();
    for (AxisState* state : {x_.get(), left_.get(), right_.get()}) {
        if (state->chartAxis == nullptr) {
            continue;
        }
        QAbstractAxis* chartAxis = state->chartAxis;
        chartAxis->setLabelsFont(Theme::font(Theme::smallSize));
        chartAxis->setTitleFont(Theme::font(Theme::smallSize));
        chartAxis->setLabelsBrush(theme.mutedText());
        chartAxis->setTitleBrush(theme.mutedText());
        chartAxis->setLinePen(QPen(theme.border(), 1));
        chartAxis->setGridLinePen(QPen(theme.grid(), 1));
        chartAxis->setMinorGridLineVisible(false);
        chartAxis->setGridLineVisible(state != right_.get());
    }
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        setCurveStyle(static_cast<int>(i), curves_[i]->style);
    }
    chartChanged();
}

QString PlotView::axisNumber(double value, const AxisState& state) const {
    if (state.spec.logarithmic) {
        return QStringLiteral("1e%1").arg(std::lround(std::log10(value)));
    }
    return locale().toString(value, 'f', tickDecimals(state.step));
}

QString PlotView::readoutNumber(double value, const AxisState& state) const {
    const double span = state.high - state.low;
    if (state.spec.logarithmic || !(span > 0.0)) {
        return locale().toString(value, 'g', 3);
    }
    if (readoutDecimals_ >= 0 && &state != x_.get()) {
        return locale().toString(value, 'f', readoutDecimals_);
    }
    const int decimals = std::clamp(static_cast<int>(std::ceil(3.0 - std::log10(span))), 0, 9);
    return locale().toString(value, 'f', decimals);
}

QRectF PlotView::plotArea() const {
    return chart_->plotArea();
}

QPointF PlotView::toPixel(double x, double y, Side side) const {
    const QRectF area = plotArea();
    return {area.left() + x_->fraction(x) * area.width(),
            area.bottom() - axis(side).fraction(y) * area.height()};
}

double PlotView::xAt(double pixelX) const {
    const QRectF area = plotArea();
    return x_->value((pixelX - area.left()) / std::max(1.0, area.width()));
}

double PlotView::yAt(double pixelY, Side side) const {
    const QRectF area = plotArea();
    return axis(side).value((area.bottom() - pixelY) / std::max(1.0, area.height()));
}

std::pair<double, double> PlotView::xInterval() const {
    return {x_->low, x_->high};
}
std::pair<double, double> PlotView::yInterval(Side side) const {
    return {axis(side).low, axis(side).high};
}

void PlotView::updateRanges() {
    if (zoomed_) {
        return;
    }
    if (x_->low != x_->spec.min || x_->high != x_->spec.max) {
        x_->low = x_->spec.min;
        x_->high = x_->spec.max;
        seriesStale_ = true;
    }
    for (const Side side : {Side::Left, Side::Right}) {
        AxisState& state = axis(side);
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        if (state.fixed) {
            std::tie(low, high) = *state.fixed;
        } else {
            for (const auto& curve : curves_) {
                if (curve->shown && curve->style.side == side && !curve->y.empty()) {
                    const auto [least, most] =
                        std::minmax_element(curve->y.begin(), curve->y.end());
                    low = std::min(low, *least);
                    high = std::max(high, *most);
                    if (curve->style.shape == Shape::Bars && !state.spec.logarithmic) {
                        low = std::min(low, 0.0);
                        high = std::max(high, 0.0);
                    }
                }
            }
            if (!(low <= high)) {
                continue;  // nothing to show: the axis stays as it is
            }
            if (state.spec.logarithmic) {
                low = std::pow(10.0, std::floor(std::log10(low)));
                high = std::pow(10.0, std::ceil(std::log10(high)));
                if (low == high) {
                    high *= 10.0;
                }
            } else {
                // Hysteresis: rescaling costs a frame, so the axis stays while the data fit and
                // fill more than half of it.
                const bool fits = low >= state.low && high <= state.high;
                if (fits && high - low > 0.5 * (state.high - state.low)) {
                    continue;
                }
                const double pad = 0.04 * (high - low);
                std::tie(low, high) =
                    niceInterval(low < 0.0 || low > pad ? low - pad : low,
                                 high > 0.0 || high < -pad ? high + pad : high, 6);
            }
        }
        if (low != state.low || high != state.high) {
            state.low = low;
            state.high = high;
            seriesStale_ = true;
        }
    }
}

void PlotView::updateTicks() {
    const QRectF area = plotArea();
    const auto apply = [&](AxisState& state, double pixels, double pixelsPerTick) {
        state.step = chooseStep(state.high - state.low, pixels, pixelsPerTick, state.spec.degrees);
        if (auto* value = qobject_cast<QValueAxis*>(state.chartAxis)) {
            value->setTickType(QValueAxis::TicksDynamic);
            value->setTickAnchor(0.0);
            value->setTickInterval(state.step);
            value->setLabelFormat(QStringLiteral("%.%1f").arg(tickDecimals(state.step)));
            value->setRange(state.low, state.high);
        } else if (auto* log = qobject_cast<QLogValueAxis*>(state.chartAxis)) {
            log->setBase(10.0);
            log->setLabelFormat(QStringLiteral("%.0e"));
            log->setRange(state.low, state.high);
        }
        if (state.chartAxis != nullptr) {
            state.chartAxis->setTitleText(state.spec.title);
        }
    };
    apply(*x_, area.width(), 56.0);
    apply(*left_, area.height(), 28.0);
    if (right_->chartAxis != nullptr) {
        apply(*right_, area.height(), 28.0);
    }
}

void PlotView::layoutHeader() {
    // Title and legend in one row where they fit, else the legend flows in rows below the title.
    const QFontMetricsF metrics(Theme::font(Theme::baseSize, true));
    const double row = std::ceil(metrics.height()) + Theme::gap;
    const double titleWidth = metrics.horizontalAdvance(title_) + 2 * Theme::margin;
    double legendWidth = 0.0;
    for (const auto& curve : curves_) {
        if (curve->button != nullptr && !curve->button->isHidden()) {
            legendWidth += curve->button->sizeHint().width();
        }
    }
    const double right = width() - Theme::space;
    const bool oneRow = titleWidth + legendWidth <= right;
    double x = oneRow ? right - legendWidth : Theme::margin - Theme::gap;
    double y = Theme::gap + (oneRow ? 0.0 : row);
    headerHeight_ = y + row;
    for (const auto& curve : curves_) {
        if (curve->button == nullptr || curve->button->isHidden()) {
            continue;
        }
        const int itemWidth = curve->button->sizeHint().width();
        if (!oneRow && x + itemWidth > right && x > Theme::margin) {
            x = Theme::margin - Theme::gap;
            y += row;
            headerHeight_ = y + row;
        }
        curve->button->setGeometry(QRectF(x, y, itemWidth, row).toAlignedRect());
        x += itemWidth;
    }
    if (legendWidth == 0.0 && title_.isEmpty()) {
        headerHeight_ = Theme::gap;
    }
}

void PlotView::paintTitle(QPainter& painter) {
    painter.setFont(Theme::font(Theme::baseSize, true));
    painter.setPen(Theme::instance().text());
    const double row = std::ceil(painter.fontMetrics().height()) + Theme::gap;
    const double room = width() - 2.0 * Theme::margin;
    painter.drawText(
        QRectF(Theme::margin, Theme::gap, room, row), Qt::AlignLeft | Qt::AlignVCenter,
        painter.fontMetrics().elidedText(title_, Qt::ElideRight, static_cast<int>(room)));
}

void PlotView::layoutChart() {
    layoutHeader();
    const double top = headerHeight_;
    const auto intervals = [this] {
        return std::array{x_->low, x_->high, left_->low, left_->high, right_->low, right_->high};
    };
    const auto shown = intervals();
    bool moved = seriesStale_;
    updateRanges();

    const QFontMetricsF metrics(Theme::font(Theme::smallSize));
    const double bottom =
        std::ceil(metrics.height() * (x_->spec.title.isEmpty() ? 1.0 : 2.0) + 2.5 * labelGap);
    const double areaHeight = std::max(20.0, height() - top - labelGap - bottom);
    const auto labelWidth = [&](AxisState& state) {
        if (state.spec.logarithmic) {
            return metrics.horizontalAdvance(QStringLiteral("1e-00"));
        }
        // The ticks that updateTicks() will choose decide how many decimals the labels have.
        state.step = chooseStep(state.high - state.low, areaHeight, rowPerTick, state.spec.degrees);
        return std::max(metrics.horizontalAdvance(axisNumber(state.low, state)),
                        metrics.horizontalAdvance(axisNumber(state.high, state)));
    };
    const auto sideMargin = [&](Side side) {
        AxisState& state = axis(side);
        const double title = state.spec.title.isEmpty() ? 0.0 : metrics.height() + labelGap;
        return std::ceil(labelWidth(state) + title + 2 * labelGap);
    };
    const double left = sideMargin(Side::Left);
    const double right = sideUsed(Side::Right) ? sideMargin(Side::Right) : Theme::margin + 4.0;
    const QRectF whole(0, 0, width(), height());
    QRectF area(left, top + labelGap, std::max(20.0, width() - left - right),
                std::max(20.0, height() - top - labelGap - bottom));
    chart_->resize(whole.size());
    scene_->setSceneRect(whole);
    if (chart_->plotArea() != area) {
        chart_->setPlotArea(area);
        moved = true;
    }
    if (equalScale_) {
        // Widen the axis with room to spare until one unit is as long on both.
        const double perX = (x_->high - x_->low) / area.width();
        const double perY = (left_->high - left_->low) / area.height();
        const auto widen = [](AxisState& state, double span) {
            const double middle = 0.5 * (state.low + state.high);
            state.low = middle - 0.5 * span;
            state.high = middle + 0.5 * span;
        };
        if (perX > perY * (1 + 1e-9)) {
            widen(*left_, perX * area.height());
        } else if (perY > perX * (1 + 1e-9)) {
            widen(*x_, perY * area.width());
        }
    }
    // What was widened above starts afresh each time: only where it ends counts.
    seriesStale_ = moved || intervals() != shown;
    axesStale_ = axesStale_ || seriesStale_;
    if (axesStale_) {
        updateTicks();
        chart_->layout()->activate();
    }
    updateSeries();
}

void PlotView::updateSeries() {
    for (const auto& curve : curves_) {
        if (!curve->stale && !seriesStale_) {
            continue;
        }
        curve->stale = false;
        const bool drawn = curve->shown && (curve->style.shape == Shape::Line ||
                                            curve->style.shape == Shape::LineAndPoints);
        curve->pixels.clear();
        if (!drawn) {
            continue;
        }
        std::vector<QPointF> pixels(curve->x.size());
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            pixels[i] = toPixel(curve->x[i], curve->y[i], curve->style.side);
        }
        for (const std::size_t i : thinPolylineIndices(pixels, 0.25)) {
            curve->pixels.append(pixels[i]);
        }
    }
    seriesStale_ = false;
}

void PlotView::renderAxes(QPainter& painter) {
    const QRectF area = plotArea();
    painter.setRenderHint(QPainter::Antialiasing);
    paintTitle(painter);
    if (!image_.isNull()) {
        painter.save();
        painter.setClipRect(area);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(QRectF(toPixel(imageValues_.left(), imageValues_.bottom()),
                                 toPixel(imageValues_.right(), imageValues_.top()))
                              .normalized(),
                          image_);
        painter.restore();
    }
    for (const Band& band : bands_) {
        const double from = toPixel(band.from, left_->low).x();
        const double to = toPixel(band.to, left_->low).x();
        const QRectF shade = QRectF(QPointF(from, area.top()), QPointF(to, area.bottom()))
                                 .normalized()
                                 .intersected(area);
        painter.fillRect(shade, band.colour);
        if (!band.text.isEmpty() && shade.width() > 30) {
            painter.setPen(Theme::instance().mutedText());
            painter.setFont(Theme::font(Theme::smallSize));
            painter.drawText(shade.adjusted(4, 2, -4, -2),
                             Qt::AlignTop | Qt::AlignHCenter | Qt::TextWordWrap, band.text);
        }
    }
    const QRectF whole(0, 0, width(), height());
    scene_->render(&painter, whole, whole);
}

void PlotView::renderCurves(QPainter& painter) {
    const QRectF area = plotArea();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(area);
    painter.setBrush(Qt::NoBrush);
    for (const auto& curve : curves_) {
        if (curve->shown && !curve->pixels.isEmpty()) {
            // Round caps and joins are arcs to the stroker: three times the cost, and no pixel of
            // a smooth curve.
            painter.setPen(QPen(Theme::instance().curve(curve->style.colour), curve->style.width,
                                curve->style.pen, Qt::FlatCap, Qt::BevelJoin));
            painter.drawPolyline(curve->pixels);
        }
    }
    painter.restore();
    painter.save();
    painter.setClipRect(area.adjusted(-4, -4, 4, 4));
    for (const auto& curve : curves_) {
        if (!curve->shown) {
            continue;
        }
        const QColor colour = Theme::instance().curve(curve->style.colour);
        if (curve->low.size() == curve->x.size() && curve->high.size() == curve->x.size()) {
            painter.setPen(QPen(colour, 1.0));
            for (std::size_t i = 0; i < curve->x.size(); ++i) {
                const QPointF low = toPixel(curve->x[i], curve->low[i], curve->style.side);
                const QPointF high = toPixel(curve->x[i], curve->high[i], curve->style.side);
                painter.drawLine(low, high);
                for (const QPointF& end : {low, high}) {
                    painter.drawLine(end - QPointF(3, 0), end + QPointF(3, 0));
                }
            }
        }
        if (curve->style.shape == Shape::Bars) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(colour);
            const double foot = axis(curve->style.side).spec.logarithmic
                                    ? area.bottom()
                                    : toPixel(0.0, 0.0, curve->style.side).y();
            for (std::size_t i = 0; i < curve->x.size(); ++i) {
                const double middle = curve->x[i] + curve->style.barShift;
                const double half = 0.5 * curve->style.barWidth;
                const QPointF left = toPixel(middle - half, curve->y[i], curve->style.side);
                const QPointF right = toPixel(middle + half, curve->y[i], curve->style.side);
                painter.drawRect(
                    QRectF(QPointF(left.x(), std::clamp(left.y(), area.top(), area.bottom())),
                           QPointF(right.x(), std::clamp(foot, area.top(), area.bottom())))
                        .normalized());
            }
        } else if (curve->style.shape != Shape::Line) {
            painter.setPen(QPen(Theme::instance().panel(), 1.0));
            painter.setBrush(colour);
            for (std::size_t i = 0; i < curve->x.size(); ++i) {
                painter.drawEllipse(toPixel(curve->x[i], curve->y[i], curve->style.side), 3.6, 3.6);
            }
        }
    }
    painter.restore();
}

void PlotView::paintEvent(QPaintEvent* /*event*/) {
    if (pictureStale_) {
        layoutChart();
        const qreal ratio = devicePixelRatioF();
        const QSize pixels = (QSizeF(size()) * ratio).toSize();
        if (picture_.size() != pixels || picture_.devicePixelRatio() != ratio) {
            for (QPixmap* layer : {&axesPicture_, &picture_}) {
                *layer = QPixmap(pixels);
                layer->setDevicePixelRatio(ratio);
            }
            axesStale_ = true;
        }
        if (axesStale_) {
            axesPicture_.fill(Theme::instance().panel());
            QPainter painter(&axesPicture_);
            renderAxes(painter);
            axesStale_ = false;
        }
        QPainter painter(&picture_);
        painter.drawPixmap(0, 0, axesPicture_);
        renderCurves(painter);
        pictureStale_ = false;
    }
    QPainter painter(this);
    painter.drawPixmap(0, 0, picture_);
    paintOverlay(painter);
    if (hasFocus()) {
        painter.setPen(QPen(Theme::instance().accent(), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void PlotView::paintOverlay(QPainter& painter) {
    const Theme& theme = Theme::instance();
    const QRectF area = plotArea();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(area);
    for (const Line& line : lines_) {
        painter.setPen(QPen(theme.curve(line.colour), 1.2, Qt::DashLine));
        const bool across = line.orientation == Qt::Horizontal;
        const QPointF at =
            across ? toPixel(x_->low, line.at, line.side) : toPixel(line.at, left_->low);
        if (across) {
            painter.drawLine(QPointF(area.left(), at.y()), QPointF(area.right(), at.y()));
        } else {
            painter.drawLine(QPointF(at.x(), area.top()), QPointF(at.x(), area.bottom()));
        }
        painter.setFont(Theme::font(Theme::smallSize));
        painter.drawText(across ? QPointF(area.left() + labelGap, at.y() - 4)
                                : QPointF(at.x() + 4, area.top() + 14),
                         line.text);
    }
    if (presentX_) {
        const double px = toPixel(*presentX_, left_->low).x();
        painter.setPen(QPen(theme.accent(), 1.4));
        painter.drawLine(QPointF(px, area.top()), QPointF(px, area.bottom()));
        for (std::size_t i = 0; i < curves_.size(); ++i) {
            const Curve& curve = *curves_[i];
            const auto y = curve.shown ? valueAt(static_cast<int>(i), *presentX_) : std::nullopt;
            if (y) {
                painter.setPen(QPen(theme.panel(), 1.5));
                painter.setBrush(theme.curve(curve.style.colour));
                painter.drawEllipse(toPixel(*presentX_, *y, curve.style.side), 4.5, 4.5);
            }
        }
    }
    painter.restore();
    paintMarks(painter, area);
    if (cursorX_) {
        paintReadout(painter, area);
    }
}

void PlotView::paintMarks(QPainter& painter, const QRectF& area) {
    const Theme& theme = Theme::instance();
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    painter.setFont(font);
    std::vector<QRectF> taken;
    for (const Mark& mark : marks_) {
        const QPointF at = toPixel(mark.x, mark.y, mark.side);
        if (!area.adjusted(-1, -1, 1, 1).contains(at)) {
            continue;
        }
        const QColor colour = theme.curve(mark.colour);
        painter.setPen(QPen(mark.ring ? colour : theme.panel(), mark.ring ? 2.0 : 1.2));
        painter.setBrush(mark.ring ? QBrush(Qt::NoBrush) : QBrush(colour));
        const double radius = mark.ring ? 7.0 : 3.6;
        painter.drawEllipse(at, radius, radius);
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
        QColor back = theme.panel();
        back.setAlphaF(0.82F);
        painter.setPen(Qt::NoPen);
        painter.setBrush(back);
        painter.drawRoundedRect(box, 3, 3);
        painter.setPen(colour);
        painter.drawText(box, Qt::AlignCenter, mark.text);
    }
}

void PlotView::paintReadout(QPainter& painter, const QRectF& area) {
    const Theme& theme = Theme::instance();
    const double x = *cursorX_;
    const double px = toPixel(x, left_->low).x();
    if (px < area.left() - 0.5 || px > area.right() + 0.5) {
        return;
    }
    painter.setPen(QPen(theme.mutedText(), 1.0, Qt::DotLine));
    painter.drawLine(QPointF(px, area.top()), QPointF(px, area.bottom()));

    struct Row {
        QString text;
        QColor colour;
    };
    const QString xName = x_->spec.title.section(QLatin1Char(','), 0, 0);
    std::vector<Row> rows{{(xName.isEmpty() ? QStringLiteral("x") : xName) + QStringLiteral(" = ") +
                               readoutNumber(x, *x_),
                           theme.text()}};
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        const Curve& curve = *curves_[i];
        if (!curve.shown) {
            continue;
        }
        const auto y = valueAt(static_cast<int>(i), x);
        if (!y) {
            continue;
        }
        const AxisState& state = axis(curve.style.side);
        const QColor colour = theme.curve(curve.style.colour);
        rows.push_back(
            {curve.style.name + QStringLiteral(" = ") + readoutNumber(*y, state), colour});
        const QPointF at = toPixel(x, *y, curve.style.side);
        if (area.contains(at)) {
            painter.setPen(QPen(theme.panel(), 1.2));
            painter.setBrush(colour);
            painter.drawEllipse(at, 3.4, 3.4);
        }
    }
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    double width = 0.0;
    for (const Row& row : rows) {
        width = std::max(width, metrics.horizontalAdvance(row.text));
    }
    const double rowHeight = metrics.height() + 2;
    QRectF box(px + 10, area.top() + 6, width + 14,
               rowHeight * static_cast<double>(rows.size()) + 8);
    if (box.right() > area.right()) {
        box.moveRight(px - 10);
    }
    box.moveLeft(std::max(box.left(), area.left()));
    painter.setPen(QPen(theme.border(), 1.0));
    QColor back = theme.panel();
    back.setAlphaF(0.93F);
    painter.setBrush(back);
    painter.drawRoundedRect(box, 4, 4);
    painter.setFont(font);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        painter.setPen(rows[i].colour);
        painter.drawText(QRectF(box.left() + 7, box.top() + 4 + rowHeight * static_cast<double>(i),
                                width + 2, rowHeight),
                         Qt::AlignVCenter | Qt::AlignLeft, rows[i].text);
    }
}

std::optional<double> PlotView::valueAt(int number, double x) const {
    const Curve& curve = *curves_.at(static_cast<std::size_t>(number));
    if (curve.x.empty() || !curve.ascending || x < curve.x.front() || x > curve.x.back()) {
        return std::nullopt;
    }
    if (curve.style.shape == Shape::Points) {
        return std::nullopt;
    }
    if (curve.style.shape == Shape::Bars) {
        const auto bar = std::find_if(curve.x.begin(), curve.x.end(),
                                      [&](double at) { return std::abs(at - x) < 0.5; });
        return bar == curve.x.end()
                   ? std::nullopt
                   : std::optional(curve.y[static_cast<std::size_t>(bar - curve.x.begin())]);
    }
    const auto upper = std::upper_bound(curve.x.begin(), curve.x.end(), x);
    const auto i = static_cast<std::size_t>(upper - curve.x.begin());
    if (i == 0 || i == curve.x.size()) {
        return i == 0 ? curve.y.front() : curve.y.back();
    }
    const double fraction = (x - curve.x[i - 1]) / (curve.x[i] - curve.x[i - 1]);
    return curve.y[i - 1] + fraction * (curve.y[i] - curve.y[i - 1]);
}

QString PlotView::dataAsCsv() const {
    const CsvFormat csv;
    const auto quoted = [](QString text) {
        return QLatin1Char('"') + text.replace(QLatin1Char('"'), QLatin1String("\"\"")) +
               QLatin1Char('"');
    };
    QString text;
    for (const auto& curve : curves_) {
        if (!curve->shown || curve->x.empty()) {
            continue;
        }
        text +=
            quoted(x_->spec.title) + csv.separator + quoted(curve->style.name) + QLatin1Char('\n');
        for (std::size_t i = 0; i < curve->x.size(); ++i) {
            text += csv.number(curve->x[i]) + csv.separator + csv.number(curve->y[i]) +
                    QLatin1Char('\n');
        }
        text += QLatin1Char('\n');
    }
    return text;
}

void PlotView::renderTo(QPainter& painter, const QRectF& target) {
    layoutChart();
    painter.save();
    painter.translate(target.topLeft());
    painter.scale(target.width() / width(), target.height() / height());
    painter.fillRect(QRectF(rect()), Theme::instance().panel());
    renderAxes(painter);
    renderCurves(painter);
    paintOverlay(painter);
    for (const auto& curve : curves_) {
        if (curve->button != nullptr && curve->shown && !curve->button->isHidden()) {
            curve->button->draw(painter, QRectF(curve->button->geometry()));
        }
    }
    painter.restore();
    pictureStale_ = true;
}

QString PlotView::exportPicture(const QString& path) {
    if (path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)) {
        QSvgGenerator generator;
        generator.setFileName(path);
        generator.setResolution(96);  // or text comes out at three quarters of its size
        generator.setSize(size());
        generator.setViewBox(rect());
        generator.setTitle(title_);
        QPainter painter;
        if (!painter.begin(&generator)) {
            return tr("%1 cannot be written.").arg(path);
        }
        renderTo(painter, rect());
        return {};
    }
    constexpr int scale = 2;
    QImage image(size() * scale, QImage::Format_RGB32);
    QPainter painter(&image);
    renderTo(painter, QRectF(QPointF(), QSizeF(image.size())));
    painter.end();
    return image.save(path, "PNG") ? QString() : tr("%1 cannot be written.").arg(path);
}

void PlotView::resizeEvent(QResizeEvent* /*event*/) {
    seriesStale_ = true;
    pictureStale_ = true;
    layoutHeader();
}

void PlotView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange || event->type() == QEvent::LocaleChange) {
        chartChanged();
    }
    QWidget::changeEvent(event);
}

void PlotView::mousePressEvent(QMouseEvent* event) {
    const bool inside = plotArea().contains(event->position());
    if (inside && pickable_ && event->button() == Qt::LeftButton &&
        !event->modifiers().testFlag(Qt::ShiftModifier)) {
        picking_ = true;
        pick(event->position());
    } else if (inside &&
               (event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton)) {
        panFrom_ = event->position();
    }
    event->accept();
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    if (picking_) {
        pick(event->position());
        return;
    }
    if (panFrom_) {
        const QPointF moved = event->position() - *panFrom_;
        if (zoomed_ || moved.manhattanLength() > QApplication::startDragDistance()) {
            pan(moved);
            panFrom_ = event->position();
        }
        return;
    }
    moveCursor(event->position());
}

void PlotView::mouseReleaseEvent(QMouseEvent* /*event*/) {
    picking_ = false;
    panFrom_.reset();
}

void PlotView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (pickable_) {
        mousePressEvent(event);
    } else {
        resetZoom();
    }
}

void PlotView::pick(const QPointF& position) {
    const double x = std::clamp(xAt(position.x()), x_->low, x_->high);
    Q_EMIT picked(x);
    Q_EMIT pickedAt(x, std::clamp(yAt(position.y()), left_->low, left_->high));
}

void PlotView::moveCursor(const QPointF& position) {
    if (!plotArea().contains(position)) {
        if (cursorX_) {
            setCursorX(std::nullopt);
            Q_EMIT cursorLeft();
        }
        return;
    }
    const double x = xAt(position.x());
    setCursorX(x);
    Q_EMIT cursorMoved(x);
}

void PlotView::leaveEvent(QEvent* /*event*/) {
    if (cursorX_) {
        setCursorX(std::nullopt);
        Q_EMIT cursorLeft();
    }
}

void PlotView::wheelEvent(QWheelEvent* event) {
    // Alt and some desktops turn the wheel sideways: either axis counts.
    const double turned =
        event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
    const double factor = std::pow(zoomPerStep, -turned / 120.0);
    const bool onlyY = event->modifiers().testFlag(Qt::ShiftModifier);
    const bool onlyX = event->modifiers().testFlag(Qt::ControlModifier);
    zoom(onlyY ? 1.0 : factor, onlyX ? 1.0 : factor, event->position());
    event->accept();
}

void PlotView::zoom(double factorX, double factorY, const QPointF& about) {
    const QRectF area = plotArea();
    if (area.isEmpty()) {
        return;
    }
    if (equalScale_) {
        factorY = factorX = factorX == 1.0 ? factorY : factorX;
    }
    const auto scale = [](AxisState& state, double factor, double fraction) {
        constexpr double narrowest = 1e-9;
        const double low = state.value(fraction * (1.0 - factor));
        const double high = state.value(fraction + (1.0 - fraction) * factor);
        const double size = std::max({std::abs(low), std::abs(high), 1e-12});
        if (std::isfinite(low) && std::isfinite(high) && high - low > narrowest * size &&
            std::abs(high) < 1e15 && std::abs(low) < 1e15) {
            state.low = low;
            state.high = high;
        }
    };
    const double fx = std::clamp((about.x() - area.left()) / area.width(), 0.0, 1.0);
    const double fy = std::clamp((area.bottom() - about.y()) / area.height(), 0.0, 1.0);
    zoomed_ = true;
    scale(*x_, factorX, fx);
    scale(*left_, factorY, fy);
    scale(*right_, factorY, fy);
    seriesStale_ = true;
    chartChanged();
}

void PlotView::pan(const QPointF& pixels) {
    const QRectF area = plotArea();
    const auto shift = [](AxisState& state, double fraction) {
        const double low = state.value(fraction);
        const double high = state.value(1.0 + fraction);
        state.low = low;
        state.high = high;
    };
    zoomed_ = true;
    shift(*x_, -pixels.x() / area.width());
    shift(*left_, pixels.y() / area.height());
    shift(*right_, pixels.y() / area.height());
    seriesStale_ = true;
    chartChanged();
}

void PlotView::keyPressEvent(QKeyEvent* event) {
    const QPointF middle = plotArea().center();
    const double step = (x_->high - x_->low) / 100.0;
    switch (event->key()) {
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            zoom(1 / zoomPerStep, 1 / zoomPerStep, middle);
            return;
        case Qt::Key_Minus:
            zoom(zoomPerStep, zoomPerStep, middle);
            return;
        case Qt::Key_0:
        case Qt::Key_Home:
        case Qt::Key_Escape:
            resetZoom();
            return;
        case Qt::Key_Left:
        case Qt::Key_Right: {
            const double from = cursorX_.value_or(presentX_.value_or(0.5 * (x_->low + x_->high)));
            const double to =
                std::clamp(from + (event->key() == Qt::Key_Left ? -step : step), x_->low, x_->high);
            setCursorX(to);
            Q_EMIT cursorMoved(to);
            return;
        }
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (pickable_ && cursorX_) {
                Q_EMIT picked(*cursorX_);
                return;
            }
            break;
        default:
            break;
    }
    QWidget::keyPressEvent(event);
}

void PlotView::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    menu.addAction(tr("Reset zoom"), this, &PlotView::resetZoom);
    menu.addSeparator();
    menu.addAction(tr("Copy data as CSV"), this,
                   [this] { QApplication::clipboard()->setText(dataAsCsv()); });
    menu.addAction(tr("Copy picture"), this, [this] {
        QImage image(size() * 2, QImage::Format_RGB32);
        QPainter painter(&image);
        renderTo(painter, QRectF(QPointF(), QSizeF(image.size())));
        painter.end();
        QApplication::clipboard()->setImage(image);
    });
    menu.addAction(tr("Save picture…"), this, [this] {
        const QString path = QFileDialog::getSaveFileName(
            this, tr("Save picture"), QString(), tr("PNG picture (*.png);;SVG drawing (*.svg)"));
        if (path.isEmpty()) {
            return;
        }
        const QString trouble = exportPicture(path);
        if (!trouble.isEmpty()) {
            QMessageBox::warning(this, tr("Save picture"), trouble);
        }
    });
    menu.exec(event->globalPos());
}

}  // namespace ravnoves
