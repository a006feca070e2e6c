#include "plot/plot_view.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QValueAxis>
#include <algorithm>
#include <array>
#include <cmath>

#include "plot/plot_view_parts.h"
#include "plot/thin_polyline.h"
#include "plot/ticks.h"
#include "text/csv_format.h"
#include "theme/theme.h"

namespace ravnoves {

using plot::chartRowPerTick;
using plot::columnPerTick;
using plot::labelGap;
using plot::rowPerTick;

namespace {

int ticksThatFit(double pixels, double pixelsPerTick) {
    return std::clamp(static_cast<int>(pixels / pixelsPerTick), 2, 16);
}

}  // namespace

std::vector<double> PlotView::AxisState::ownTicks(double pixels, double pixelsPerTick) const {
    const int wanted = ticksThatFit(pixels, pixelsPerTick);
    if (spec.logarithmic) {
        return logarithmicTicks(low, high, wanted);
    }
    // Of the labels offered those that keep clear of weightier ones.
    const double apart = 0.8 * pixelsPerTick / std::max(pixels, 1.0);
    std::vector<double> ticks;
    for (const double tick : spec.scale.ticks) {
        const double at = fraction(tick);
        const bool clear = std::none_of(ticks.begin(), ticks.end(), [&](double other) {
            return std::abs(fraction(other) - at) < apart;
        });
        if (clear && at > -1e-9 && at < 1.0 + 1e-9) {
            ticks.push_back(tick);
        }
    }
    return ticks;
}

QString PlotView::AxisState::ownLabel(double value, const QLocale& locale) const {
    return spec.label ? spec.label(value) : powerText(value, locale);
}

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
    if (x_->chartAxis == nullptr) {
        x_->chartAxis = new QValueAxis;
        chart_->addAxis(x_->chartAxis, Qt::AlignBottom);
        applyTheme();
    }
    x_->chartAxis->setVisible(!x_->isOwn());
    seriesStale_ = true;
    chartChanged();
}

void PlotView::setYAxis(Side side, const Axis& spec) {
    AxisState& state = axis(side);
    state.spec = spec;
    if (state.chartAxis == nullptr) {
        state.chartAxis = new QValueAxis;
        chart_->addAxis(state.chartAxis, side == Side::Left ? Qt::AlignLeft : Qt::AlignRight);
        applyTheme();
    }
    state.chartAxis->setVisible(!state.isOwn());
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
    std::vector<std::size_t> starts;
    bool left = false;  // a point before this one was left out
    for (std::size_t i = 0; i < count; ++i) {
        const bool drawable = std::isfinite(x[i]) && std::isfinite(y[i]) &&
                              (!x_->spec.logarithmic || x[i] > 0.0) &&
                              (!axis(curve.style.side).spec.logarithmic || y[i] > 0.0);
        if (drawable) {
            if (left && curve.style.gaps && finite > 0) {
                starts.push_back(finite);
            }
            x[finite] = x[i];
            y[finite] = y[i];
            ++finite;
        }
        left = !drawable;
    }
    x.resize(finite);
    y.resize(finite);
    if (x == curve.x && y == curve.y && starts == curve.starts) {
        return;
    }
    pointRead_.reset();
    curve.starts = std::move(starts);
    curve.ascending = std::is_sorted(x.begin(), x.end());
    curve.x = std::move(x);
    curve.y = std::move(y);
    curve.stale = true;
    curvesChanged();
}

void PlotView::setErrorBars(int number, std::vector<double> low, std::vector<double> high,
                            Qt::Orientation orientation) {
    Curve& curve = *curves_.at(static_cast<std::size_t>(number));
    curve.bars = orientation;
    curve.low = std::move(low);
    curve.high = std::move(high);
    curvesChanged();
}

void PlotView::setPointTexts(int number, QStringList texts) {
    curves_.at(static_cast<std::size_t>(number))->texts = std::move(texts);
    pointRead_.reset();
    update();
}

void PlotView::setCurveShown(int number, bool shown) {
    Curve& curve = *curves_.at(static_cast<std::size_t>(number));
    if (curve.shown == shown) {
        return;
    }
    curve.shown = shown;
    pointRead_.reset();
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

void PlotView::setFaded(bool faded, const QString& text) {
    if (faded_ != faded || fadedText_ != text) {
        faded_ = faded;
        fadedText_ = text;
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
    return locale().toString(value, 'f', tickDecimals(state.step));
}

QString PlotView::readoutNumber(double value, const AxisState& state) const {
    const double span = state.high - state.low;
    if (state.isOwn()) {
        return state.ownLabel(value, locale());
    }
    if (!(span > 0.0)) {
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
        state.step = readableStep(state.low, state.high, ticksThatFit(pixels, pixelsPerTick),
                                  state.spec.degrees);
        auto* value = qobject_cast<QValueAxis*>(state.chartAxis);
        if (value != nullptr && !state.isOwn()) {
            value->setTickType(QValueAxis::TicksDynamic);
            value->setTickAnchor(0.0);
            value->setTickInterval(state.step);
            value->setLabelFormat(QStringLiteral("%.%1f").arg(tickDecimals(state.step)));
            value->setRange(state.low, state.high);
        }
        if (state.chartAxis != nullptr) {
            state.chartAxis->setTitleText(state.spec.title);
        }
    };
    apply(*x_, area.width(), columnPerTick);
    apply(*left_, area.height(), chartRowPerTick);
    if (right_->chartAxis != nullptr) {
        apply(*right_, area.height(), chartRowPerTick);
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
        if (state.isOwn()) {
            double widest = 0.0;
            for (const double tick : state.ownTicks(areaHeight, rowPerTick)) {
                widest =
                    std::max(widest, metrics.horizontalAdvance(state.ownLabel(tick, locale())));
            }
            return widest;
        }
        // The ticks that updateTicks() will choose decide how many decimals the labels have.
        state.step = readableStep(state.low, state.high, ticksThatFit(areaHeight, chartRowPerTick),
                                  state.spec.degrees);
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
        curve->stretches.clear();
        if (!drawn) {
            continue;
        }
        std::size_t from = 0;
        for (std::size_t next = 0; next <= curve->starts.size(); ++next) {
            const std::size_t to =
                next < curve->starts.size() ? curve->starts[next] : curve->x.size();
            std::vector<QPointF> pixels;
            pixels.reserve(to - from);
            for (std::size_t i = from; i < to; ++i) {
                pixels.push_back(toPixel(curve->x[i], curve->y[i], curve->style.side));
            }
            QPolygonF line;
            for (const std::size_t i : thinPolylineIndices(pixels, 0.25)) {
                line.append(pixels[i]);
            }
            curve->stretches.push_back(std::move(line));
            from = to;
        }
    }
    seriesStale_ = false;
}

std::optional<double> PlotView::valueAt(int number, double x) const {
    const Curve& curve = *curves_.at(static_cast<std::size_t>(number));
    if (curve.x.empty() || !curve.ascending || x < curve.x.front() || x > curve.x.back()) {
        return std::nullopt;
    }
    if (curve.style.shape == Shape::Points || curve.style.shape == Shape::Rings) {
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
    if (std::find(curve.starts.begin(), curve.starts.end(), i) != curve.starts.end()) {
        return std::nullopt;  // in a gap
    }
    // Along the straight line that is drawn between the points, on whatever scale.
    const double from = x_->scaled(curve.x[i - 1]);
    const double span = x_->scaled(curve.x[i]) - from;
    const double fraction = span > 0.0 ? (x_->scaled(x) - from) / span : 0.0;
    const AxisState& state = axis(curve.style.side);
    return state.unscaled(
        std::lerp(state.scaled(curve.y[i - 1]), state.scaled(curve.y[i]), fraction));
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

}  // namespace ravnoves
