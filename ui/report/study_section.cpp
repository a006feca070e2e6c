#include "report/sections.h"

#include <memory>

#include "model/background_job.h"
#include "model/scene_model.h"
#include "plot/plot_view.h"
#include "report/figure_drawings.h"
#include "report/patience.h"
#include "studies/model/study_figures.h"
#include "studies/model/study_model.h"
#include "studies/model/study_tables.h"
#include "studies/model/sweep_model.h"
#include "studies/tolerance_bands.h"
#include "text/message_text.h"
#include "text/number_text.h"

namespace ravnoves {

using namespace paper;

namespace {

/// The limits of a watched result; empty without any.
QString limitsText(const studies::Watched& watched, double factor) {
    const auto shown = [&](double limit) { return shownFormNumber(factor * limit, QLocale(), 6); };
    if (watched.min && watched.max) {
        return shown(*watched.min) + QStringLiteral(" … ") + shown(*watched.max);
    }
    return watched.min   ? QStringLiteral("≥ ") + shown(*watched.min)
           : watched.max ? QStringLiteral("≤ ") + shown(*watched.max)
                         : QString();
}

Table givenTolerances(StudyModel& study) {
    Table table;
    table.caption = ReportWords::tr("Inputs and their tolerances");
    table.headings = {ReportWords::tr("Input"), ReportWords::tr("Value"), QStringLiteral("±")};
    table.numbers = {false, true, true};
    const ScatterTable inputs(&study);
    for (int row = 0; row < inputs.rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < inputs.columnCount(); ++column) {
            cells << inputs.index(row, column).data().toString().toHtmlEscaped();
        }
        if (!cells.last().isEmpty()) {
            table.rows << cells;
        }
    }
    return table;
}

QString methodText(const studies::Study& study) {
    const auto& word = studies::method_words()[static_cast<std::size_t>(study.method)];
    QString text = ReportWords::tr("Method: %1").arg(shownText(word.label));
    if (studies::is_sampled(study.method)) {
        text += QStringLiteral("; ") + ReportWords::tr("samples: %1, seed %2")
                                           .arg(QLocale().toString(qulonglong(study.samples)))
                                           .arg(study.seed);
    }
    return text;
}

/// With the limits beside the share of the samples within them.
Table foundValues(const StudyModel& study) {
    Results results = foundResults(study);
    const auto& watch = study.study().watch;
    for (qsizetype i = 0; i < results.rows.size(); ++i) {
        const std::string& pointer = study.answers()->values[static_cast<std::size_t>(i)].pointer;
        const auto watched = std::ranges::find(watch, pointer, &studies::Watched::pointer);
        const QString limits = watched != watch.end()
                                   ? limitsText(*watched, study.resultName(pointer).shown().factor)
                                   : QString();
        if (!limits.isEmpty()) {
            QString& share = results.rows[i].last().text;
            share = limits + QStringLiteral(": ") + share;
        }
    }
    Table table = tableOf(results);
    table.caption = ReportWords::tr("Results with tolerances");
    table.isSmall = true;
    return table;
}

/// What the user sweeps in the window of the tolerances.
void addSweep(Paper& report, StudyModel& study, const Patience& patience) {
    if (study.scene()->sweepChoice().input.empty() || study.study().watch.empty()) {
        return;
    }
    SweepModel model(&study);
    model.setWatched(true);
    patience.waitWhile([&model] { return model.isBusy(); });
    model.setWatched(false);
    if (model.sweep() == nullptr || model.isStale()) {
        if (!model.trouble().isEmpty()) {
            report.say(model.trouble(), Tone::Warning);
        }
        return;
    }
    const auto sheet = std::make_shared<QWidget>();
    QList<PlotView*> plots;
    for (const Figure& figure : sweepFigures(study, model)) {
        auto* plot = new PlotView(sheet.get());
        plot->showFigure(figure);
        plot->resize(660, plots.empty() ? 300 : 180);
        plots << plot;
        report.body += report.figure(drawingOf(std::shared_ptr<QWidget>(sheet, plot)));
    }
    PlotView::stack(plots);
    const ShownTitle input = study.inputTitle(model.input());
    const auto shown = [&](double x) { return shownFormNumber(input.factor * x, QLocale(), 5); };
    const auto& places = model.sweep()->places;
    report.say(ReportWords::tr("Sweep, %1 from %2 to %3. %4")
                   .arg(input.text, shown(places.front().x), shown(places.back().x),
                        sweepWords(study, model)));
}

}  // namespace

void addTolerances(Paper& report, SceneModel& model, const Patience& patience) {
    if (model.study().empty()) {
        return;
    }
    StudyModel study(&model);
    if (study.trouble().isEmpty() && study.study().vary.empty()) {
        return;
    }
    report.body += heading(ReportWords::tr("Tolerances"));
    if (!study.trouble().isEmpty()) {
        report.say(study.trouble(), Tone::Warning);
        return;
    }
    report.body += table(givenTolerances(study));
    if (ToleranceBands::areShown()) {
        report.say(ReportWords::tr(
                       "Bands about curves and ± beside numbers are the range from 5 % to 95 % "
                       "of 128 samples."),
                   Tone::Muted);
        if (studies::open_input(model.caseFile(), model.context(), study.study().vary)) {
            report.say(ReportWords::tr("Both include the uncertain dead centre of the trace, the "
                                       "results below do not."),
                       Tone::Warning);
        }
    }
    if (study.study().watch.empty()) {
        return;
    }
    study.setWatched(true);
    patience.waitWhile([&study] { return study.isBusy(); });
    const StudyAnswers* answers = study.answers();
    if (answers == nullptr) {
        report.say(study.trouble().isEmpty() ? ReportWords::tr("No results.") : study.trouble(),
                   Tone::Warning);
        return;
    }
    report.say(methodText(study.study()));
    report.body += table(foundValues(study));
    for (const auto& [severity, line] : notesOf(study).lines) {
        report.say(line, severity == Severity::warning ? Tone::Warning : Tone::Muted);
    }
    constexpr std::size_t maximum = 4;
    for (std::size_t i = 0; i < std::min(maximum, answers->values.size()); ++i) {
        report.body += table(tableOf(tornado(study, &answers->values[i])));
    }
    addSweep(report, study, patience);
}

}  // namespace ravnoves
