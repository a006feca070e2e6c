#include "methods/method_plots.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <limits>

#include "case-file/decimal.h"
#include "methods/model/method_words.h"
#include "plot/model/figure.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "theme/theme.h"

namespace ravnoves {

using methods::Kernel;
using methods::MethodInfo;
using methods::MethodRow;
using methods::Result;
using methods::StabilityCurve;
using methods::SweepInfo;

namespace {

constexpr int pairWidth = 640;     ///< designed pixels of two charts side by side
constexpr int foldedHeight = 310;  ///< designed pixels of one above the other, with its legend

plot::Axis sweepAxis(const SweepInfo& sweep) {
    plot::Axis axis{
        .title = sweepTitle(sweep),
        .min = sweep.from,
        .max = sweep.to,
        .degrees = sweep.unit == units::degree && sweep.spacing == methods::Spacing::linear,
        .logarithmic = sweep.logarithmic()};
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

/// Whole decades with all errors; before any are measured the frame of what is to come.
std::pair<double, double> decadesOf(const MethodMeasurement* shown) {
    if (shown == nullptr) {
        return {minimum, 1.0};
    }
    double low = shown->kernel().choice.tolerance;
    double high = low;
    const auto take = [&](const Result& result) {
        if (!result.rejected()) {
            low = std::min(low, drawn(result));
            high = std::max(high, drawn(result));
        }
    };
    for (const MethodRow& point : shown->report.rows) {
        take(point.result);
    }
    for (const StabilityCurve& curve : shown->map->curves) {
        std::for_each(curve.results.begin(), curve.results.end(), take);
    }
    return {std::pow(10.0, std::floor(std::log10(low))),
            std::pow(10.0, std::ceil(std::log10(high)))};
}

/// What both charts have: the axis of the errors, the tolerance, and a curve of each method, still
/// without its points.
Figure overErrors(const MethodMeasurement* shown, const Kernel& kernel, plot::Shape shape) {
    const auto [from, to] = decadesOf(shown);
    Figure figure;
    figure.left = {.title = MethodPlots::tr("error"), .min = from, .max = to, .logarithmic = true};
    figure.leftRange = std::pair(from / 1.6, to * 1.6);
    figure.lines = {
        {.at = kernel.choice.tolerance,
         .role = Role::Present,
         .text = MethodPlots::tr("tolerance, %1").arg(errorNumber(kernel.choice.tolerance))}};
    if (shown != nullptr) {  // a curve in here fails
        figure.bands = {{.from = kernel.choice.tolerance,
                         .to = to * 2.0,
                         .role = Role::Forbidden,
                         .strength = 0.05,
                         .orientation = Qt::Vertical}};
    }
    for (std::size_t method = 0; method < kernel.methods.size(); ++method) {
        const MethodInfo& info = kernel.methods[method];
        figure.add(kernel.id + '/' + info.id,
                   {.name = shownText(info.title),
                    .role = series(static_cast<int>(method)),
                    .width = method == kernel.chosen_method() ? 2.2 : 1.4,
                    .shape = shape,
                    .toolTip = shownText(info.limits),
                    .gaps = true},
                   {}, {});
    }
    return figure;
}

QString pointText(const Kernel& kernel, const MethodRow& point) {
    const MethodInfo& method = kernel.methods[point.method];
    return QStringList{shownText(method.title) + QStringLiteral(", ") +
                           methodText(method.settings[point.setting].label),
                       MethodPlots::tr("%1, half of the runs from %2 to %3")
                           .arg(timeText(point.timing.median), timeText(point.timing.low),
                                timeText(point.timing.high)),
                       MethodPlots::tr("error %1").arg(resultText(point.result)),
                       point.holds ? MethodPlots::tr("within the tolerance")
                                   : MethodPlots::tr("beyond the tolerance")}
        .join(QLatin1Char('\n'));
}

Figure workFigure(const MethodMeasurement* shown, const Kernel& kernel) {
    Figure figure = overErrors(shown, kernel, plot::Shape::LineAndPoints);
    figure.x = {.title = MethodPlots::tr("time of one evaluation"),
                .min = 1.0,
                .max = 1e6,
                .logarithmic = true,
                .label = timeText};
    if (shown == nullptr) {
        figure.title = MethodPlots::tr("Time and error");
        return figure;
    }
    figure.title = MethodPlots::tr("%1: time and error").arg(shownText(kernel.title));
    const auto [fastest, slowest] = std::ranges::minmax(
        shown->report.rows, {}, [](const MethodRow& point) { return point.timing.median; });
    constexpr double room = 1.7;
    figure.x.title = MethodPlots::tr("time: %1").arg(shownText(kernel.evaluation));
    figure.x.min = fastest.timing.median / room;
    figure.x.max = slowest.timing.median * room;
    figure.marks.emplace();
    for (std::size_t method = 0; method < kernel.methods.size(); ++method) {
        Figure::Curve& curve = figure.curves[method];
        QStringList texts;
        for (const MethodRow& point : shown->report.rows) {
            if (point.method != method || point.result.rejected()) {
                continue;
            }
            curve.x.push_back(point.timing.median);
            curve.y.push_back(drawn(point.result));
            texts << pointText(kernel, point);
            if (point.in_use) {
                figure.marks->push_back({.x = curve.x.back(),
                                         .y = curve.y.back(),
                                         .text = MethodPlots::tr("in use"),
                                         .role = curve.style.role,
                                         .ring = true});
            }
        }
        curve.text = [texts](std::size_t point) {
            return texts.value(static_cast<qsizetype>(point));
        };
    }
    return figure;
}

/// Shades where values are no input of the scene, and where a method fails.
void addFailing(Figure& figure, const MethodMeasurement& shown, std::size_t method) {
    const SweepInfo& sweep = shown.sweep();
    const std::vector<double>& values = shown.map->values;
    const QString noInput = MethodPlots::tr("not an input");
    if (sweep.scene_from > values.front()) {
        figure.bands.push_back(
            {.from = values.front(), .to = sweep.scene_from, .strength = 0.16, .text = noInput});
    }
    if (sweep.scene_to < values.back()) {
        figure.bands.push_back(
            {.from = sweep.scene_to, .to = values.back(), .strength = 0.16, .text = noInput});
    }
    for (const StabilityCurve& curve : shown.map->curves) {
        if (curve.method != method) {
            continue;
        }
        for (const auto& span : curve.failing(shown.kernel().choice.tolerance)) {
            const auto [from, to] = around(sweep, values, span);
            for (plot::Band& other : figure.bands) {
                if (other.orientation == Qt::Horizontal && other.to > from && other.from < to) {
                    other.text.clear();  // one text over the other cannot be read
                }
            }
            figure.bands.push_back(
                {.from = from,
                 .to = to,
                 .role = series(static_cast<int>(method)),
                 .strength = 0.18,
                 .text = MethodPlots::tr("%1 fails")
                             .arg(shownText(shown.kernel().methods[method].title))});
        }
    }
}

/// @param method  whose failing regions are shaded
Figure stabilityFigure(const MethodMeasurement* shown, const Kernel& kernel, const SweepInfo& sweep,
                       std::size_t method) {
    Figure figure = overErrors(shown, kernel, plot::Shape::Line);
    figure.x = sweepAxis(sweep);
    if (shown == nullptr) {
        figure.title = MethodPlots::tr("Error along the hard parameter");
        return figure;
    }
    figure.title = MethodPlots::tr("%1: stability").arg(shownText(kernel.title));
    figure.left.title.clear();
    for (const StabilityCurve& curve : shown->map->curves) {
        Figure::Curve& errors = figure.curves[curve.method];
        errors.x = shown->map->values;
        for (const Result& result : curve.results) {
            errors.y.push_back(result.rejected() ? std::numeric_limits<double>::quiet_NaN()
                                                 : drawn(result));
        }
    }
    addFailing(figure, *shown, method);
    return figure;
}

}  // namespace

MethodPlots::MethodPlots(MethodsModel* model, QWidget* parent)
    : FoldingRow(pairWidth, parent), model_(model) {
    work_ = new PlotView(this);
    work_->setObjectName(QStringLiteral("work_plot"));
    stability_ = new PlotView(this);
    stability_->setObjectName(QStringLiteral("stability_plot"));
    stability_->setPickable(true);
    add(work_);
    add(stability_);
    connect(this, &FoldingRow::foldChanged, this, [this](bool folded) {
        for (PlotView* plot : {work_, stability_}) {
            plot->setMinimumHeight(folded ? Theme::withText(foldedHeight) : 0);
        }
    });
    connect(stability_, &PlotView::picked, this, [this](double x) {
        if (model_->shown() != nullptr && &model_->shown()->sweep() == &model_->sweep()) {
            model_->setValue(rounded_to_digits(x, 3));
        }
    });
    connect(model, &SceneModel::changed, this, &MethodPlots::follow);
    connect(model, &MethodsModel::shownMethodChanged, this, &MethodPlots::follow);
    connect(model, &MethodsModel::measurementChanged, this, &MethodPlots::follow);
    follow();
}

void MethodPlots::follow() {
    const MethodMeasurement* shown = model_->shown();
    const Kernel& kernel = shown != nullptr ? shown->kernel() : model_->kernel();
    const SweepInfo& sweep = shown != nullptr ? shown->sweep() : model_->sweep();
    work_->showFigure(workFigure(shown, kernel));
    Figure figure = stabilityFigure(
        shown, kernel, sweep,
        &kernel == &model_->kernel() ? model_->shownMethod() : kernel.chosen_method());
    // The chart may still be that of the parameter looked at before.
    const bool isSame = &sweep == &model_->sweep();
    if (isSame) {
        figure.lines.push_back({.at = sweep.present,
                                .orientation = Qt::Vertical,
                                .role = Role::Limit,
                                .text = tr("preset")});
    }
    stability_->showFigure(figure);
    stability_->setPresentX(isSame ? std::optional(model_->value()) : std::nullopt);
    const QString text = model_->measuring()->isRunning() ? tr("measuring…") : QString();
    work_->setFaded(shown == nullptr || model_->isStale(), text);
    // Errors along the parameter do not depend on its value, so a drag leaves them as they are.
    const bool isOther = shown == nullptr || !isSame;
    stability_->setFaded(isOther, isOther ? text : QString());
}

}  // namespace ravnoves
