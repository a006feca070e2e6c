#include "report/study_section.h"

#include <memory>

#include "model/background_job.h"
#include "model/scene_model.h"
#include "pictures/figure.h"
#include "plot/plot_view.h"
#include "report/figure_drawings.h"
#include "report/patience.h"
#include "report/report_words.h"
#include "studies/model/study_figures.h"
#include "studies/model/study_model.h"
#include "studies/model/study_tables.h"
#include "studies/model/sweep_model.h"
#include "studies/tolerance_bands.h"
#include "studies/tornado_view.h"
#include "text/message_text.h"
#include "text/number_text.h"

namespace ravnoves {

using namespace paper;

namespace {

void waitFor(const auto& model, const Patience& patience) {
    while (model.isBusy()) {
        patience.wait(50);
    }
}

QString shareText(const StudyAnswer& value, const studies::Watched& watched, double factor) {
    QString limits = QStringLiteral("–");
    const auto shown = [&](double limit) { return shownFormNumber(factor * limit, QLocale(), 6); };
    if (watched.min && watched.max) {
        limits = shown(*watched.min) + QStringLiteral(" … ") + shown(*watched.max);
    } else if (watched.min) {
        limits = QStringLiteral("≥ ") + shown(*watched.min);
    } else if (watched.max) {
        limits = QStringLiteral("≤ ") + shown(*watched.max);
    }
    return value.within ? limits + QStringLiteral(": ") + value.withinText() : limits;
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

Table foundValues(const StudyAnswers& answers, const StudyModel& model) {
    const studies::Study& study = model.study();
    Table table;
    table.caption = ReportWords::tr("Results with tolerances");
    table.headings = {ReportWords::tr("Result"),
                      ReportWords::tr("Nominal"),
                      ReportWords::tr("Mean"),
                      QStringLiteral("σ"),
                      QStringLiteral("5 %"),
                      QStringLiteral("95 %"),
                      ReportWords::tr("Within the limits")};
    table.numbers = {false, true, true, true, true, true, true};
    table.isSmall = true;
    for (const StudyAnswer& value : answers.values) {
        const auto watched =
            std::ranges::find(study.watch, value.pointer, &studies::Watched::pointer);
        const ResultName name = model.resultName(value.pointer);
        const double factor = name.shown().factor;
        const auto shown = [&](const std::optional<double>& each) {
            return value.text(each, factor);
        };
        QStringList cells;
        for (const QString& text :
             {name.withUnit(), shown(value.nominal), shown(value.mean),
              shown(value.deviation ? value.deviation : value.linearDeviation), shown(value.low),
              shown(value.high),
              watched != study.watch.end() ? shareText(value, *watched, factor) : QString()}) {
            cells << text.toHtmlEscaped();
        }
        table.rows << cells;
    }
    return table;
}

Drawing tornadoOf(const StudyModel& study, const StudyAnswer& value) {
    auto view = std::make_shared<TornadoView>();
    view->setShares(&value, study);
    constexpr int width = 640;
    const QSize size(width, view->heightForWidth(width));
    view->resize(size);
    return {{}, view->accessibleName(), size, [view, size](QPainter& painter) {
                drawFigure(view.get(), painter, QRectF(QPointF(), size));
            }};
}

/// What the user sweeps in the window of the tolerances.
void addSweep(Paper& report, StudyModel& study, const Patience& patience) {
    if (study.scene()->sweepChoice().input.empty() || study.study().watch.empty()) {
        return;
    }
    SweepModel model(&study);
    model.setWatched(true);
    waitFor(model, patience);
    model.setWatched(false);
    if (model.sweep() == nullptr || model.isStale()) {
        if (!model.trouble().isEmpty()) {
            report.say(model.trouble(), Tone::Warning);
        }
        return;
    }
    const auto sheet = std::make_shared<QWidget>();
    QList<PlotView*> plots;
    for (const Figure& figure : sweepFigures(study, *model.sweep())) {
        auto* plot = new PlotView(sheet.get());
        plot->showFigure(figure);
        plot->resize(660, plots.empty() ? 300 : 180);
        plots << plot;
        report.body += report.figure(drawingOf(std::shared_ptr<PlotView>(sheet, plot)));
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
    }
    if (study.study().watch.empty()) {
        return;
    }
    study.setWatched(true);
    waitFor(study, patience);
    const StudyAnswers* answers = study.answers();
    if (answers == nullptr) {
        report.say(study.trouble().isEmpty() ? ReportWords::tr("No results.") : study.trouble(),
                   Tone::Warning);
        return;
    }
    report.say(methodText(study.study()));
    report.body += table(foundValues(*answers, study));
    if (studies::is_sampled(study.study().method)) {
        report.say(ReportWords::tr("Samples solved: %1")
                       .arg(QLocale().toString(qulonglong(answers->solved))),
                   Tone::Muted);
    }
    if (const QString feasible = answers->feasibleText(); !feasible.isEmpty()) {
        report.say(feasible, answers->isRarelyFeasible() ? Tone::Warning : Tone::Muted);
    }
    for (const auto& [reason, count] : study.rejected()) {
        report.say(
            ReportWords::tr("Rejected: %1 × %2").arg(QLocale().toString(qulonglong(count)), reason),
            Tone::Muted);
    }
    for (const QString& note : study.notes()) {
        report.say(note, Tone::Warning);
    }
    constexpr std::size_t maximum = 4;
    for (std::size_t i = 0; i < std::min(maximum, answers->values.size()); ++i) {
        report.body += report.figure(tornadoOf(study, answers->values[i]));
    }
    addSweep(report, study, patience);
}

}  // namespace ravnoves
