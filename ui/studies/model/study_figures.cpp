#include "studies/model/study_figures.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <functional>

#include "studies/model/study_model.h"
#include "studies/model/study_tables.h"
#include "studies/model/sweep_model.h"
#include "text/number_text.h"

namespace ravnoves {

namespace {

struct SweepWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::SweepView)
};

struct TornadoWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::TornadoView)
};

struct HistogramWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ToleranceWindow)
};

plot::Line lineAt(double at, Qt::Orientation orientation, const QString& text) {
    return {.at = at,
            .orientation = orientation,
            .role = Role::Limit,
            .text = text,
            .keptAtEdge = true};
}

/// The limits of a watched result.
void addLimits(Figure& figure, const StudyModel& study, const std::string& result,
               Qt::Orientation orientation) {
    const auto& watch = study.study().watch;
    const auto watched = std::ranges::find(watch, result, &studies::Watched::pointer);
    if (watched != watch.end() && watched->min) {
        figure.lines.push_back(lineAt(*watched->min, orientation, SweepWords::tr("at least")));
    }
    if (watched != watch.end() && watched->max) {
        figure.lines.push_back(lineAt(*watched->max, orientation, SweepWords::tr("at most")));
    }
}

QString bestText(const StudyModel& study, const SweepModel& model) {
    const Sweep& sweep = *model.sweep();
    const QString few = SweepWords::tr("No value makes 95 % of the samples feasible.");
    if (!sweep.best) {
        return few;
    }
    const ShownTitle input = study.inputTitle(model.input());
    const ShownUnit unit = study.resultName(model.result()).shown();
    QString best =
        SweepWords::tr(
            "Minimum 95th percentile of the absolute value: %1 at %2; %3 of the samples are "
            "feasible.")
            .arg(withUnit(shownFormNumber(unit.factor * sweep.best->size, QLocale(), 5), unit.name),
                 shownFormNumber(input.factor * sweep.best->x, QLocale(), 5),
                 percentText(sweep.best->built));
    if (sweep.best->x == sweep.places.front().x || sweep.best->x == sweep.places.back().x) {
        best += QLatin1Char(' ') + SweepWords::tr("This is an end of the range.");
    }
    if (sweep.best->rejected > 0.0) {
        best += QLatin1Char(' ') +
                SweepWords::tr("Rejected samples: %1.").arg(percentText(sweep.best->rejected));
    }
    return sweep.best->built < Sweep::minBuilt ? few + QLatin1Char(' ') + best : best;
}

}  // namespace

QString sweepWords(const StudyModel& study, const SweepModel& model) {
    return !model.trouble().isEmpty() ? model.trouble()
           : model.result().empty()   ? SweepWords::tr("Choose a result to watch.")
           : model.sweep() == nullptr || model.isStale() ? SweepWords::tr("Computing…")
                                                         : bestText(study, model);
}

std::vector<Figure> sweepFigures(const StudyModel& study, const SweepModel& model) {
    const Sweep& sweep = *model.sweep();
    const ResultName name = study.resultName(model.result());
    const ShownTitle input = study.inputTitle(model.input());
    Figure result{.title = name.text, .left = {name.unit}};
    Figure::Curve& mean = result.add(
        "mean", {.name = SweepWords::tr("mean"), .role = Role::Value, .width = 2.0}, {}, {});
    plot::Spread spread;
    const bool areRejected = std::ranges::any_of(
        sweep.places, [](const Sweep::Place& place) { return place.rejected > 0.0; });
    Figure share{.left = {areRejected ? SweepWords::tr("share of the samples, %")
                                      : SweepWords::tr("feasible, %")},
                 .leftRange = std::pair(0.0, 100.0)};
    Figure::Curve built{.id = "feasible",
                        .style = {.name = SweepWords::tr("feasible"),
                                  .role = Role::OtherQuantity,
                                  .inLegend = areRejected}};
    Figure::Curve rejected{.id = "rejected",
                           .style = {.name = SweepWords::tr("rejected"), .role = Role::Forbidden}};
    for (const Sweep::Place& place : sweep.places) {
        built.x.push_back(input.factor * place.x);
        built.y.push_back(100.0 * place.built);
        rejected.y.push_back(100.0 * place.rejected);
        if (std::isfinite(place.mean)) {
            mean.x.push_back(built.x.back());
            mean.y.push_back(place.mean);
            spread.below.push_back(place.mean - place.low);
            spread.above.push_back(place.high - place.mean);
        }
    }
    result.spreads.emplace();
    if (std::ranges::any_of(spread.above, [](double above) { return above > 0.0; })) {
        result.spreads->emplace(mean.id, std::move(spread));
    }
    share.x = {input.text, built.x.front(), built.x.back()};
    result.x = share.x;
    const StudyModel::Input* swept = study.input(model.input());
    const double nominal = input.factor * (swept != nullptr ? swept->value : 0.0);
    const double half = input.factor * (swept != nullptr ? swept->half() : 0.0);
    if (half > 0.0) {
        result.bands = {{nominal - half, nominal + half, Role::Present, 0.12, QStringLiteral("±")}};
    }
    const auto shown = [&](double value) {
        return shownFormNumber(name.shown().factor * value, QLocale(), 5);
    };
    result.marks.emplace();
    if (sweep.nominalResult) {
        result.marks->push_back({nominal, *sweep.nominalResult, shown(*sweep.nominalResult)});
    }
    if (sweep.best) {
        const double worst = std::copysign(sweep.best->size, sweep.best->low + sweep.best->high);
        result.marks->push_back({input.factor * sweep.best->x, worst,
                                 QStringLiteral("95 %: ") + shown(worst), Role::Best, true});
    }
    addLimits(result, study, model.result(), Qt::Horizontal);
    if (std::ranges::all_of(built.y, [](double percent) { return percent > 99.9; })) {
        return {result};
    }
    share.curves.push_back(built);
    if (areRejected) {
        rejected.x = built.x;
        share.curves.push_back(rejected);
    }
    result.x.title.clear();  // it is below the other
    return {result, share};
}

Figure histogramFigure(const StudyModel& study, const StudyAnswer* value) {
    Figure figure{.left = {HistogramWords::tr("share of the samples, %")}};
    if (value == nullptr) {
        return figure;
    }
    const ResultName name = study.resultName(value->pointer);
    figure.title = name.withUnit();
    Figure::Curve& bars = figure.add(
        "share",
        {.name = HistogramWords::tr("share"), .shape = plot::Shape::Bars, .inLegend = false},
        value->middles, value->heights);
    for (double& height : bars.y) {
        height *= 100.0;
    }
    if (bars.x.size() > 1) {
        const double step = bars.x[1] - bars.x[0];
        figure.x = {name.unit, bars.x.front() - step, bars.x.back() + step};
        bars.style.barWidth = step;
    }
    if (value->nominal) {
        figure.lines.push_back(
            lineAt(*value->nominal, Qt::Vertical, HistogramWords::tr("nominal")));
    }
    addLimits(figure, study, value->pointer, Qt::Vertical);
    return figure;
}

Results foundResults(const StudyModel& study) {
    Results results{
        {HistogramWords::tr("Result"),
         {HistogramWords::tr("Nominal"), HistogramWords::tr("Without tolerances.")},
         {HistogramWords::tr("Mean"), HistogramWords::tr("Mean of all solved samples.")},
         {QStringLiteral("σ"), HistogramWords::tr("Standard deviation of the samples.")},
         {HistogramWords::tr("σ, linear"),
          HistogramWords::tr("Standard deviation by the slopes at the nominal values.")},
         {QStringLiteral("5 %"), HistogramWords::tr("5 % of the samples are smaller.")},
         {QStringLiteral("95 %"), HistogramWords::tr("5 % of the samples are larger.")},
         {HistogramWords::tr("Within"),
          HistogramWords::tr("Share of the samples within the limits, with its 95 % interval.")}}};
    for (const StudyAnswer& value :
         study.answers() != nullptr ? study.answers()->values : std::vector<StudyAnswer>()) {
        const ResultName name = study.resultName(value.pointer);
        const auto shown = [&](const std::optional<double>& each) {
            return value.text(each, name.shown().factor);
        };
        results.rows.push_back(
            {name.withUnit(), shown(value.nominal), shown(value.mean), shown(value.deviation),
             shown(value.linearDeviation) + (value.fails ? QStringLiteral(" ⚠") : QString()),
             shown(value.low), shown(value.high), value.withinText()});
    }
    return results;
}

Results tornado(const StudyModel& study, const StudyAnswer* value) {
    Results results{{{ScatterTable::tr("Input")},
                     {TornadoWords::tr("alone, %")},
                     {TornadoWords::tr("with others, %")},
                     {QString()}}};
    if (value == nullptr) {
        return results;
    }
    results.columns.back() = {
        TornadoWords::tr("Shares of the variance of %1")
            .arg(study.resultName(value->pointer).withUnit()),
        TornadoWords::tr("Dark: share of the variance of an input alone (Sobol's first-order "
                         "index). Light: further share with other inputs (total index).")};
    std::vector<StudyAnswer::Share> shares = value->shares;
    std::ranges::stable_sort(shares, std::greater<>(), &StudyAnswer::Share::whole);
    for (const StudyAnswer::Share& share : shares) {
        const auto percent = [](double part) { return fixedDecimals(100.0 * part, 1, QLocale()); };
        const auto bar = [](double part, QChar sign) {
            constexpr double whole = 24.0;  // signs
            return QString(qRound(whole * part), sign);
        };
        const double alone = std::min(share.alone, 1.0);
        results.rows.push_back({study.inputName(share.pointer), percent(share.alone),
                                percent(share.whole),
                                bar(alone, u'█') + bar(std::min(share.whole, 1.0) - alone, u'░')});
    }
    return results;
}

Notes notesOf(const StudyModel& study) {
    Notes notes;
    const StudyAnswers& answers = *study.answers();
    for (const Message& note : answers.notes) {
        notes.say(Severity::warning, study.named(note));
    }
    if (studies::is_sampled(study.study().method)) {
        notes.say(Severity::note, HistogramWords::tr("Samples solved: %1")
                                      .arg(QLocale().toString(qulonglong(answers.solved))));
        if (answers.feasible) {
            constexpr double few = 0.95;
            notes.say(*answers.feasible < few ? Severity::warning : Severity::note,
                      StudyModel::tr("Feasible samples: %1").arg(percentText(*answers.feasible)));
        }
    }
    for (const studies::Rejection& rejection : answers.rejected) {
        notes.say(Severity::note, HistogramWords::tr("Rejected: %1 × %2")
                                      .arg(QLocale().toString(qulonglong(rejection.count)),
                                           study.named(rejection.reason)));
    }
    return notes;
}

}  // namespace ravnoves
