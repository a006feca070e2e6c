#include "methods/method_plots.h"

#include <QLocale>
#include <QPainter>
#include <QResizeEvent>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "methods/model/method_words.h"
#include "methods/sweep_value_field.h"
#include "pictures/picture_file.h"
#include "plot/model/ticks.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"

namespace ravnoves {

using methods::Kernel;
using methods::MethodInfo;
using methods::Result;
using methods::StabilityCurve;
using methods::StabilityMap;
using methods::SweepInfo;
using methods::WorkPoint;

namespace {

constexpr double shadeAlpha = 0.10;
constexpr int pairWidth = 640;     ///< designed pixels of two charts side by side
constexpr int foldedHeight = 310;  ///< designed pixels of one above the other, with its legend

/// Labels for a scale that crowds towards a limit: round values, then ever smaller distances from
/// the limit.
std::vector<double> crowdedTicks(const SweepInfo& sweep) {
    const double span = sweep.to - sweep.from;
    std::vector<double> ticks{sweep.at(0.0)};
    // Powers of ten of the value itself, so that 1 − λ is one.
    const int decades = static_cast<int>(std::ceil(-std::log10(0.5 * sweep.end_gap * span)));
    for (int decade = 0; decade < decades; ++decade) {
        const double distance = std::pow(10.0, -decade);
        if (distance < 0.2 * span) {
            ticks.push_back(sweep.to - distance);
        }
    }
    const double step = niceStep(span, 5);
    const int first = static_cast<int>(std::ceil(sweep.from / step));
    const int last = static_cast<int>(std::floor(sweep.to / step));
    for (int k = first; k <= last && k * step < sweep.to; ++k) {
        ticks.push_back(k * step);
    }
    return ticks;
}

PlotView::Axis sweepAxis(const SweepInfo& sweep) {
    PlotView::Axis axis;
    axis.title = sweepTitle(sweep);
    axis.min = sweep.at(0.0);
    axis.max = sweep.at(1.0);
    axis.degrees = sweep.unit == units::degree && sweep.spacing == methods::Spacing::linear;
    axis.logarithmic = sweep.logarithmic();
    if (axis.logarithmic && sweep.from >= 1e-3 && sweep.to < 1e4) {
        axis.label = [](double value) { return shownFormNumber(value, QLocale(), 3); };
    }
    if (sweep.crowded()) {
        axis.scale = {[sweep](double value) { return sweep.place(value); },
                      [sweep](double place) { return sweep.at(place); }, crowdedTicks(sweep)};
        axis.label = [sweep](double shown) {
            return sweepNumber(sweep, shown / shownUnit(sweep.unit).factor);
        };
    }
    return axis;
}

/// A half step of the sweep's scale around a run of values, so that a single one has a width.
std::pair<double, double> around(const SweepInfo& sweep, const std::vector<double>& values,
                                 const StabilityCurve::Span& span) {
    const auto middle = [&](std::size_t a, std::size_t b) {
        return sweep.at(0.5 * (sweep.place(values[a]) + sweep.place(values[b])));
    };
    return {span.first == 0 ? values.front() : middle(span.first - 1, span.first),
            span.last + 1 == values.size() ? values.back() : middle(span.last, span.last + 1)};
}

}  // namespace

MethodPlots::MethodPlots(MethodsModel* model, QWidget* parent) : QWidget(parent), model_(model) {
    auto* row = new FoldingRow(pairWidth, this);
    columnIn(this)->addWidget(row);
    work_ = new PlotView(tr("Time and error"), this);
    work_->setObjectName(QStringLiteral("work_plot"));
    stability_ = new PlotView(tr("Error along the hard parameter"), this);
    stability_->setObjectName(QStringLiteral("stability_plot"));
    stability_->setPickable(true);
    row->add(work_);
    row->add(stability_);
    connect(stability_, &PlotView::picked, this, [this](double x) {
        if (model_->shown() != nullptr && &model_->shown()->sweep() == &model_->sweep()) {
            model_->setValue(roundedForHand(model_->sweep(), x));
        }
    });
    connect(model, &SceneModel::changed, this, &MethodPlots::showMeasurement);
    connect(model, &MethodsModel::sweepChanged, this, &MethodPlots::showValue);
    connect(model, &MethodsModel::valueChanged, this, &MethodPlots::showValue);
    connect(model, &MethodsModel::shownMethodChanged, this, &MethodPlots::showFailing);
    connect(model, &MethodsModel::measurementChanged, this, &MethodPlots::showStale);
    connect(&Theme::instance(), &Theme::changed, this, &MethodPlots::showFailing);
    showMeasurement();
}

void MethodPlots::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (const bool folded = event->size().width() < Theme::withText(pairWidth);
        folded != isFolded_) {
        isFolded_ = folded;
        for (PlotView* plot : {work_, stability_}) {
            plot->setMinimumHeight(folded ? Theme::withText(foldedHeight) : 0);
        }
        Q_EMIT foldChanged();
    }
}

double MethodPlots::ErrorScale::place(const Result& result) const {
    if (result.refused()) {
        return ceiling;
    }
    return result.error > least ? result.error : floor;
}

MethodPlots::ErrorScale MethodPlots::scaleOf(const MethodMeasurement& shown) {
    double least = shown.kernel().choice.tolerance;
    double most = least;
    ErrorScale scale;
    const auto take = [&](const Result& result) {
        if (result.refused()) {
            scale.hasRefusal = true;
        } else if (scale.isPlain(result)) {
            least = std::min(least, result.error);
            most = std::max(most, result.error);
        } else {
            scale.hasZero = true;
        }
    };
    for (const WorkPoint& point : shown.work.points) {
        take(point.result);
    }
    for (const StabilityCurve& curve : shown.map->curves) {
        std::for_each(curve.results.begin(), curve.results.end(), take);
    }
    // Whole decades, and one more for each of the rows without a number.
    const auto decade = [](double exponent) { return std::pow(10.0, exponent); };
    scale.floor = decade(std::floor(std::log10(least)) - (scale.hasZero ? 1.0 : 0.0));
    scale.ceiling = decade(std::ceil(std::log10(most)) + (scale.hasRefusal ? 1.0 : 0.0));
    return scale;
}

void MethodPlots::setUpCurves(const Kernel& kernel) {
    if (curvesOf_ == &kernel) {
        return;
    }
    curvesOf_ = &kernel;
    // Two curves a method: its numbers, and what has none (0, rejections), which follows the former
    // when it is switched off.
    for (PlotView* plot : {work_, stability_}) {
        const std::size_t needed = 2 * kernel.methods.size();
        while (static_cast<std::size_t>(plot->curveCount()) < needed) {
            const int number = plot->addCurve({});
            PlotView::CurveStyle rings;
            rings.inLegend = false;
            plot->addCurve(rings);
            connect(plot, &PlotView::curveToggled, this, [plot, number](int curve, bool shown) {
                if (curve == number) {
                    plot->setCurveShown(number + 1, shown);
                }
            });
        }
        for (int curve = 0; curve < plot->curveCount(); ++curve) {
            const auto method = static_cast<std::size_t>(curve / 2);
            const bool numbers = curve % 2 == 0;
            plot->setCurve(curve, {}, {});
            plot->setErrorBars(curve, {}, {});
            plot->setPointTexts(curve, {});
            plot->setCurveShown(curve, true);
            PlotView::CurveStyle style;
            if (method < kernel.methods.size() && numbers) {
                const MethodInfo& info = kernel.methods[method];
                style.name = shownText(info.title);
                style.toolTip = shownText(info.limits);
            }
            style.role = series(static_cast<int>(method));
            style.width = method == kernel.chosen_method() ? 2.2 : 1.4;
            style.inLegend = numbers;
            style.gaps = true;
            style.shape = !numbers        ? PlotView::Shape::Rings
                          : plot == work_ ? PlotView::Shape::LineAndPoints
                                          : PlotView::Shape::Line;
            plot->setCurveStyle(curve, style);
        }
    }
}

std::vector<PlotView::Line> MethodPlots::errorLines(const Kernel& kernel,
                                                    const ErrorScale& scale) const {
    std::vector<PlotView::Line> lines;
    PlotView::Line tolerance;
    tolerance.at = kernel.choice.tolerance;
    tolerance.role = Role::Present;
    tolerance.text = tr("tolerance, %1").arg(errorNumber(kernel.choice.tolerance));
    lines.push_back(tolerance);
    const auto row = [&](double at, const QString& text) {
        PlotView::Line line;
        line.at = at;
        line.role = Role::Limit;
        line.text = text;
        lines.push_back(line);
    };
    if (scale.hasZero) {
        row(scale.floor, tr("%1 or less").arg(errorNumber(ErrorScale::least)));
    }
    if (scale.hasRefusal) {
        row(scale.ceiling, tr("rejected"));
    }
    return lines;
}

void MethodPlots::showMeasurement() {
    const MethodMeasurement* shown = model_->shown();
    if (shown != nullptr) {
        scale_ = scaleOf(*shown);
        setUpCurves(shown->kernel());
        showWork(*shown, scale_);
        showStability(*shown, scale_);
        showFailing();
    } else {
        // Nothing yet: the frame of what is to come.
        setUpCurves(model_->kernel());
        work_->setXAxis({tr("time of one evaluation"), 1.0, 1e6, false, true, {}, timeText});
        work_->setYAxis(PlotView::Side::Left, {tr("error"), 1e-17, 1.0, false, true});
        stability_->setXAxis(sweepAxis(model_->sweep()));
        stability_->setYAxis(PlotView::Side::Left, {tr("error"), 1e-17, 1.0, false, true});
        for (PlotView* plot : {work_, stability_}) {
            plot->setYRange(PlotView::Side::Left, 1e-17, 10.0);
            plot->setLines(errorLines(model_->kernel(), {}));
        }
    }
    showValue();
}

QString MethodPlots::pointText(const MethodMeasurement& shown, const WorkPoint& point) const {
    const Kernel& kernel = shown.kernel();
    const MethodInfo& method = kernel.methods[point.method];
    QStringList lines{shownText(method.title) + QStringLiteral(", ") +
                          methodText(method.settings[point.setting].label),
                      tr("%1, half of the runs from %2 to %3")
                          .arg(timeText(point.timing.median), timeText(point.timing.low),
                               timeText(point.timing.high))};
    if (point.result.refused()) {
        lines << tr("rejected: %1").arg(methodText(point.result.refusal));
    } else {
        lines << tr("error %1").arg(resultText(point.result));
        lines << (point.result.error <= kernel.choice.tolerance ? tr("within the tolerance")
                                                                : tr("beyond the tolerance"));
    }
    return lines.join(QLatin1Char('\n'));
}

void MethodPlots::showWork(const MethodMeasurement& shown, const ErrorScale& scale) {
    const Kernel& kernel = shown.kernel();
    work_->setTitle(tr("%1: time and error").arg(shownText(kernel.title)));
    double fastest = std::numeric_limits<double>::infinity();
    double slowest = 0.0;
    for (const WorkPoint& point : shown.work.points) {
        fastest = std::min(fastest, point.timing.low);
        slowest = std::max(slowest, point.timing.high);
    }
    constexpr double room = 1.7;
    work_->setXAxis({tr("time: %1").arg(shownText(kernel.evaluation)),
                     fastest / room,
                     slowest * room,
                     false,
                     true,
                     {},
                     timeText});
    work_->setYAxis(PlotView::Side::Left, {tr("error, %1").arg(shownText(kernel.error_measure)),
                                           scale.floor, scale.ceiling, false, true});
    work_->setYRange(PlotView::Side::Left, scale.floor / 1.6, scale.ceiling * 1.6);
    work_->setLines(errorLines(kernel, scale));
    std::vector<PlotView::Mark> marks;
    for (std::size_t method = 0; method < kernel.methods.size(); ++method) {
        for (const bool numbers : {true, false}) {
            std::vector<double> x, y, low, high;
            QStringList texts;
            for (const WorkPoint& point : shown.work.points) {
                if (point.method != method || scale.isPlain(point.result) != numbers) {
                    continue;
                }
                x.push_back(point.timing.median);
                low.push_back(point.timing.low);
                high.push_back(point.timing.high);
                y.push_back(scale.place(point.result));
                texts << pointText(shown, point);
                if (method == kernel.chosen_method() && point.setting == kernel.chosen_setting()) {
                    PlotView::Mark ring;
                    ring.x = x.back();
                    ring.y = y.back();
                    ring.role = series(static_cast<int>(method));
                    ring.text = tr("in use");
                    ring.ring = true;
                    marks.push_back(ring);
                }
            }
            const int curve = static_cast<int>(2 * method) + (numbers ? 0 : 1);
            work_->setCurve(curve, std::move(x), std::move(y));
            work_->setErrorBars(curve, std::move(low), std::move(high), Qt::Horizontal);
            work_->setPointTexts(curve, std::move(texts));
        }
    }
    work_->setMarks(std::move(marks));
}

void MethodPlots::showStability(const MethodMeasurement& shown, const ErrorScale& scale) {
    const StabilityMap& map = *shown.map;
    const Kernel& kernel = shown.kernel();
    stability_->setTitle(tr("%1: stability").arg(shownText(kernel.title)));
    stability_->setXAxis(sweepAxis(shown.sweep()));
    stability_->setYAxis(PlotView::Side::Left,
                         {QString(), scale.floor, scale.ceiling, false, true});
    stability_->setYRange(PlotView::Side::Left, scale.floor / 1.6, scale.ceiling * 1.6);
    for (const StabilityCurve& curve : map.curves) {
        std::vector<double> numbers;
        std::vector<double> otherX;
        std::vector<double> otherY;
        for (std::size_t i = 0; i < curve.results.size(); ++i) {
            const Result& result = curve.results[i];
            if (scale.isPlain(result)) {
                numbers.push_back(result.error);
            } else {
                numbers.push_back(std::numeric_limits<double>::quiet_NaN());
                otherX.push_back(map.values[i]);
                otherY.push_back(scale.place(result));
            }
        }
        const int number = static_cast<int>(2 * curve.method);
        stability_->setCurve(number, map.values, std::move(numbers));
        stability_->setCurve(number + 1, std::move(otherX), std::move(otherY));
    }
}

void MethodPlots::showFailing() {
    const MethodMeasurement* shown = model_->shown();
    if (shown == nullptr) {
        return;
    }
    const SweepInfo& sweep = shown->sweep();
    const double tolerance = shown->kernel().choice.tolerance;
    std::vector<PlotView::Band> bands;
    PlotView::Band beyond;  // a curve in here fails
    beyond.from = tolerance;
    beyond.to = scale_.ceiling * 2.0;
    beyond.role = Role::Forbidden;
    beyond.strength = 0.5 * shadeAlpha;
    beyond.orientation = Qt::Vertical;
    bands.push_back(beyond);
    work_->setBands(bands);
    const double first = shown->map->values.front();
    const double last = shown->map->values.back();
    const auto outside = [&](double from, double to) {
        PlotView::Band band;
        band.from = from;
        band.to = to;
        band.strength = 1.6 * shadeAlpha;
        band.text = tr("not an input");
        bands.push_back(band);
    };
    if (sweep.scene_from > first) {
        outside(first, sweep.scene_from);
    }
    if (sweep.scene_to < last) {
        outside(sweep.scene_to, last);
    }
    const bool sameKernel = &shown->kernel() == &model_->kernel();
    const std::size_t method = sameKernel ? model_->shownMethod() : shown->kernel().chosen_method();
    for (const StabilityCurve& curve : shown->map->curves) {
        if (curve.method != method) {
            continue;
        }
        for (const auto& span : curve.failing(tolerance)) {
            PlotView::Band band;
            std::tie(band.from, band.to) = around(sweep, shown->map->values, span);
            band.role = series(static_cast<int>(method));
            band.strength = 1.8 * shadeAlpha;
            band.text = tr("%1 fails").arg(shownText(shown->kernel().methods[method].title));
            for (PlotView::Band& other : bands) {
                const bool apart = other.to <= band.from || other.from >= band.to;
                if (other.orientation == Qt::Horizontal && !apart) {
                    other.text.clear();  // one text over the other cannot be read
                }
            }
            bands.push_back(band);
        }
    }
    stability_->setBands(std::move(bands));
}

void MethodPlots::showValue() {
    const MethodMeasurement* shown = model_->shown();
    const SweepInfo& sweep = shown != nullptr ? shown->sweep() : model_->sweep();
    std::vector<PlotView::Line> lines =
        errorLines(shown != nullptr ? shown->kernel() : model_->kernel(), scale_);
    // The chart may still be that of the parameter looked at before.
    const bool same = &sweep == &model_->sweep();
    stability_->setPresentX(same ? std::optional(model_->value()) : std::nullopt);
    if (same) {
        PlotView::Line line;
        line.at = sweep.present;
        line.orientation = Qt::Vertical;
        line.role = Role::Limit;
        line.text = tr("preset");
        lines.push_back(line);
    }
    stability_->setLines(std::move(lines));
    showStale();
}

void MethodPlots::showStale() {
    const MethodMeasurement* shown = model_->shown();
    const bool running = model_->measurements()->isRunning();
    const QString text = running ? tr("measuring…") : QString();
    const bool stale = model_->isStale() || shown == nullptr;
    work_->setFaded(stale, text);
    // Errors along the parameter do not depend on its value, so a drag leaves them as they are.
    const bool other = shown == nullptr || &shown->sweep() != &model_->sweep();
    stability_->setFaded(other, other ? text : QString());
}

QString MethodPlots::exportPicture(const QString& path) {
    return writePicture(path, size(), work_->title(), [this](QPainter& painter, double scale) {
        for (PlotView* plot : {work_, stability_}) {
            const QRectF target(plot->geometry());
            plot->renderTo(painter, QRectF(target.topLeft() * scale, target.size() * scale));
        }
    });
}

}  // namespace ravnoves
