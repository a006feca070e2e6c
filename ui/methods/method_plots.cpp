#include "methods/method_plots.h"

#include <QLocale>
#include <QPainter>
#include <QResizeEvent>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "case-file/decimal.h"
#include "methods/model/method_words.h"
#include "pictures/picture_file.h"
#include "text/message_text.h"
#include "text/number_text.h"
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

PlotView::Axis sweepAxis(const SweepInfo& sweep) {
    PlotView::Axis axis;
    axis.title = sweepTitle(sweep);
    axis.min = sweep.from;
    axis.max = sweep.to;
    axis.degrees = sweep.unit == units::degree && sweep.spacing == methods::Spacing::linear;
    axis.logarithmic = sweep.logarithmic();
    if (axis.logarithmic && sweep.from >= 1e-3 && sweep.to < 1e4) {
        axis.label = [](double value) { return shownFormNumber(value, QLocale(), 3); };
    }
    return axis;
}

constexpr double minimum = 1e-18;  ///< a smaller error is drawn here

double drawn(const Result& result) {
    return std::max(result.error, minimum);
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
            model_->setValue(rounded_to_digits(x, 3));
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

std::pair<double, double> MethodPlots::decadesOf(const MethodMeasurement& shown) {
    double minimum = shown.kernel().choice.tolerance;
    double maximum = minimum;
    const auto take = [&](const Result& result) {
        if (!result.rejected()) {
            minimum = std::min(minimum, drawn(result));
            maximum = std::max(maximum, drawn(result));
        }
    };
    for (const WorkPoint& point : shown.work.points) {
        take(point.result);
    }
    for (const StabilityCurve& curve : shown.map->curves) {
        std::for_each(curve.results.begin(), curve.results.end(), take);
    }
    return {std::pow(10.0, std::floor(std::log10(minimum))),
            std::pow(10.0, std::ceil(std::log10(maximum)))};
}

void MethodPlots::setUpCurves(const Kernel& kernel) {
    if (curvesOf_ == &kernel) {
        return;
    }
    curvesOf_ = &kernel;
    for (PlotView* plot : {work_, stability_}) {
        while (static_cast<std::size_t>(plot->curveCount()) < kernel.methods.size()) {
            plot->addCurve({});
        }
        for (int curve = 0; curve < plot->curveCount(); ++curve) {
            const auto method = static_cast<std::size_t>(curve);
            plot->setCurve(curve, {}, {});
            plot->setPointText(curve, {});
            plot->setCurveShown(curve, true);
            PlotView::CurveStyle style;
            if (method < kernel.methods.size()) {
                const MethodInfo& info = kernel.methods[method];
                style.name = shownText(info.title);
                style.toolTip = shownText(info.limits);
            }
            style.role = series(curve);
            style.width = method == kernel.chosen_method() ? 2.2 : 1.4;
            style.gaps = true;
            style.shape = plot == work_ ? PlotView::Shape::LineAndPoints : PlotView::Shape::Line;
            plot->setCurveStyle(curve, style);
        }
    }
}

PlotView::Line MethodPlots::toleranceLine(const Kernel& kernel) const {
    PlotView::Line tolerance;
    tolerance.at = kernel.choice.tolerance;
    tolerance.role = Role::Present;
    tolerance.text = tr("tolerance, %1").arg(errorNumber(kernel.choice.tolerance));
    return tolerance;
}

void MethodPlots::showErrors(PlotView* plot, const QString& title) const {
    const auto [from, to] = errors_;
    plot->setYAxis(PlotView::Side::Left, {title, from, to, false, true});
    plot->setYRange(PlotView::Side::Left, from / 1.6, to * 1.6);
}

void MethodPlots::showMeasurement() {
    const MethodMeasurement* shown = model_->shown();
    if (shown != nullptr) {
        errors_ = decadesOf(*shown);
        setUpCurves(shown->kernel());
        showWork(*shown);
        showStability(*shown);
        showFailing();
    } else {
        // Nothing yet: the frame of what is to come.
        errors_ = {minimum, 1.0};
        setUpCurves(model_->kernel());
        work_->setXAxis({tr("time of one evaluation"), 1.0, 1e6, false, true, timeText});
        showErrors(work_, tr("error"));
        work_->setLines({toleranceLine(model_->kernel())});
        stability_->setXAxis(sweepAxis(model_->sweep()));
        showErrors(stability_, tr("error"));
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
    lines << tr("error %1").arg(resultText(point.result));
    lines << (point.result.error <= kernel.choice.tolerance ? tr("within the tolerance")
                                                            : tr("beyond the tolerance"));
    return lines.join(QLatin1Char('\n'));
}

void MethodPlots::showWork(const MethodMeasurement& shown) {
    const Kernel& kernel = shown.kernel();
    work_->setTitle(tr("%1: time and error").arg(shownText(kernel.title)));
    double fastest = std::numeric_limits<double>::infinity();
    double slowest = 0.0;
    for (const WorkPoint& point : shown.work.points) {
        fastest = std::min(fastest, point.timing.median);
        slowest = std::max(slowest, point.timing.median);
    }
    constexpr double room = 1.7;
    work_->setXAxis({tr("time: %1").arg(shownText(kernel.evaluation)), fastest / room,
                     slowest * room, false, true, timeText});
    showErrors(work_, tr("error"));
    work_->setLines({toleranceLine(kernel)});
    std::vector<PlotView::Mark> marks;
    for (std::size_t method = 0; method < kernel.methods.size(); ++method) {
        std::vector<double> x, y;
        QStringList texts;
        for (const WorkPoint& point : shown.work.points) {
            if (point.method != method || point.result.rejected()) {
                continue;
            }
            x.push_back(point.timing.median);
            y.push_back(drawn(point.result));
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
        work_->setCurve(static_cast<int>(method), std::move(x), std::move(y));
        work_->setPointText(static_cast<int>(method),
                            [texts = std::move(texts)](std::size_t point) {
                                return texts.value(static_cast<qsizetype>(point));
                            });
    }
    work_->setMarks(std::move(marks));
}

void MethodPlots::showStability(const MethodMeasurement& shown) {
    const StabilityMap& map = *shown.map;
    const Kernel& kernel = shown.kernel();
    stability_->setTitle(tr("%1: stability").arg(shownText(kernel.title)));
    stability_->setXAxis(sweepAxis(shown.sweep()));
    showErrors(stability_, {});
    for (const StabilityCurve& curve : map.curves) {
        std::vector<double> errors;
        for (const Result& result : curve.results) {
            errors.push_back(result.rejected() ? std::numeric_limits<double>::quiet_NaN()
                                               : drawn(result));
        }
        stability_->setCurve(static_cast<int>(curve.method), map.values, std::move(errors));
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
    beyond.to = errors_.second * 2.0;
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
    std::vector lines{toleranceLine(shown != nullptr ? shown->kernel() : model_->kernel())};
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
