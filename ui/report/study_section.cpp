#include "report/study_section.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QPicture>
#include <memory>

#include "case-file/case_file.h"
#include "model/background_job.h"
#include "model/scene_model.h"
#include "report/patience.h"
#include "report/report.h"
#include "scenes/responses.h"
#include "studies/model/result_words.h"
#include "studies/model/robust_model.h"
#include "studies/model/study_model.h"
#include "studies/tolerance_switch.h"
#include "studies/tornado_view.h"
#include "text/message_text.h"
#include "text/number_text.h"

namespace ravnoves {

using namespace report;

namespace {

constexpr int studyPatienceMs = 60'000;

void waitFor(const StudyModel& study, const Patience& patience) {
    QElapsedTimer waited;
    waited.start();
    while (study.isBusy() && waited.elapsed() < studyPatienceMs) {
        patience.wait(50);
    }
}

QString numberOrDash(const std::optional<double>& value, double factor) {
    return value ? shownFormNumber(factor * *value, QLocale(), 6) : QStringLiteral("–");
}

QString shareText(const StudyAnswer& value, const studies::Watched& watched, double factor) {
    if (!watched.min && !watched.max) {
        return QStringLiteral("–");
    }
    const auto percent = [](const std::optional<double>& share) {
        return fixedDecimals(100.0 * share.value_or(0.0), 2, QLocale());
    };
    const QString min = numberOrDash(watched.min, factor);
    const QString max = numberOrDash(watched.max, factor);
    QString limits = watched.min && watched.max ? min + QStringLiteral(" … ") + max
                     : watched.min              ? QStringLiteral("≥ ") + min
                                                : QStringLiteral("≤ ") + max;
    if (!value.within) {
        return limits;
    }
    return limits +
           QStringLiteral(": %1 % (%2 … %3)")
               .arg(percent(value.within), percent(value.withinLow), percent(value.withinHigh));
}

Table givenTolerances(const StudyModel& study) {
    Table table;
    table.caption = ReportWords::tr("Inputs and their tolerances");
    table.headings = {ReportWords::tr("Input"), ReportWords::tr("Value"), QStringLiteral("±"),
                      ReportWords::tr("Unit")};
    table.numbers = {false, true, true, false};
    for (const StudyModel::Input& input : study.inputs()) {
        if (input.varied) {
            QStringList cells;
            const double value = input.shown.factor * input.nominal;
            for (const QString& text : {input.name, trueMinus(writtenOut(value, QLocale(), 8)),
                                        StudyModel::scatterText(input), input.shown.name}) {
                cells << text.toHtmlEscaped();
            }
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

Table foundValues(const StudyAnswers& answers, const studies::Study& study) {
    Table table;
    table.caption = ReportWords::tr("What the tolerances do");
    table.headings = {ReportWords::tr("Result"),  ReportWords::tr("Unit"),
                      ReportWords::tr("Nominal"), ReportWords::tr("Mean"),
                      QStringLiteral("σ"),        QStringLiteral("5 %"),
                      QStringLiteral("95 %"),     ReportWords::tr("Within the limits")};
    table.numbers = {false, false, true, true, true, true, true, true};
    table.isSmall = true;
    for (const StudyAnswer& value : answers.values) {
        const auto watched = std::find_if(
            study.watch.begin(), study.watch.end(),
            [&](const studies::Watched& each) { return each.pointer == value.pointer; });
        const ResultName name = resultName(value.pointer);
        const ShownUnit unit = name.shown();
        const auto shown = [&](const std::optional<double>& each) {
            return numberOrDash(each, unit.factor);
        };
        QStringList cells;
        for (const QString& text :
             {name.text, unit.name, shown(value.nominal), shown(value.mean),
              shown(value.deviation ? value.deviation : value.linearDeviation), shown(value.low),
              shown(value.high),
              watched != study.watch.end() ? shareText(value, *watched, unit.factor) : QString()}) {
            cells << text.toHtmlEscaped();
        }
        table.rows << cells;
    }
    return table;
}

Figure tornadoOf(const StudyModel& study, const StudyAnswer& value) {
    auto view = std::make_shared<TornadoView>();
    std::vector<TornadoView::Bar> bars;
    for (const StudyAnswer::Share& share : value.shares) {
        const double alone = share.first.value_or(share.linear.value_or(0.0));
        bars.push_back(
            {study.inputName(share.pointer), alone, std::max(alone, share.total.value_or(alone))});
    }
    view->setBars(
        ReportWords::tr("Shares of the variance of %1").arg(resultName(value.pointer).withUnit()),
        std::move(bars));
    const auto rows = static_cast<int>(std::min<std::size_t>(value.shares.size(), 12));
    const QSize size(640, 60 + 26 * rows);
    view->resize(size);
    return {{}, view->accessibleName(), size, [view](QPainter& painter) {
                QPicture lines;
                view->render(&lines, QPoint(), QRegion(), QWidget::RenderFlags());
                painter.drawPicture(0, 0, lines);
            }};
}

/// The angle that holds best, where what it is chosen for is watched.
void addRobustBest(Report& report, StudyModel& study, const Patience& patience) {
    const auto choice = best_choice(study.scene()->caseFile());
    if (!choice ||
        std::none_of(study.study().watch.begin(), study.study().watch.end(),
                     [&](const studies::Watched& each) { return each.pointer == choice->value; })) {
        return;
    }
    RobustModel model(&study);
    model.setWatched(true);
    QElapsedTimer waited;
    waited.start();
    while (model.job()->isRunning() && waited.elapsed() < studyPatienceMs) {
        patience.wait(50);
    }
    const studies::RobustBest* best = model.best();
    const auto say = [&](const QString& text, Paragraph::Kind kind = Paragraph::Kind::Text) {
        report.items.push_back(Paragraph{text.toHtmlEscaped(), kind});
    };
    if (best == nullptr || !best->robust) {
        if (!model.trouble().isEmpty()) {
            say(model.trouble(), Paragraph::Kind::Warning);
        }
        return;
    }
    constexpr int decimals = 2;
    const auto shown = [](double value) { return fixedDecimals(value, decimals, QLocale()); };
    const ShownUnit unit = resultName(best->value).shown();
    const double factor = unit.factor;
    const auto sayBuildable = [&](const studies::RobustBest::Place& at) {
        return at.buildable ? QLatin1Char(' ') +
                                  ReportWords::tr("Of the samples %1 can be built at this angle.")
                                      .arg(percentText(*at.buildable))
                            : QString();
    };
    say(ReportWords::tr("Robust best α: %1° ± %2°; 95 % of the samples have at most %3: %4 ± %5.")
            .arg(shown(best->robust->angle), shown(best->robust->angle_error),
                 resultName(best->value).withUnit(), shown(factor * best->robust->percentile),
                 shown(factor * best->robust->percentile_error)) +
        sayBuildable(*best->robust));
    if (best->nominal) {
        say(ReportWords::tr("At the α that is best of the inputs as they are, %1°, it is %2.")
                .arg(shown(best->nominal->angle),
                     withUnit(shown(factor * best->nominal->percentile), unit.name)) +
            sayBuildable(*best->nominal));
    }
}

}  // namespace

void addTolerances(Report& report, SceneModel& model, const Patience& patience) {
    if (model.study().empty()) {
        return;
    }
    StudyModel study(&model);
    if (study.trouble().isEmpty() && study.study().vary.empty()) {
        return;
    }
    report.items.push_back(Heading{ReportWords::tr("Tolerances")});
    if (!study.trouble().isEmpty()) {
        report.items.push_back(
            Paragraph{study.trouble().toHtmlEscaped(), Paragraph::Kind::Warning});
        return;
    }
    report.items.push_back(givenTolerances(study));
    if (ToleranceSwitch::instance().isOn()) {
        report.items.push_back(
            Paragraph{ReportWords::tr(
                          "The bands about the curves and the ± beside the numbers of the results "
                          "go from 5 % to 95 % of what these make of them.")
                          .toHtmlEscaped(),
                      Paragraph::Kind::Muted});
    }
    if (study.study().watch.empty()) {
        return;
    }
    study.setWatched(true);
    waitFor(study, patience);
    const StudyAnswers* answers = study.answers();
    if (answers == nullptr) {
        report.items.push_back(
            Paragraph{(study.trouble().isEmpty() ? ReportWords::tr("Nothing could be computed.")
                                                 : study.trouble())
                          .toHtmlEscaped(),
                      Paragraph::Kind::Warning});
        return;
    }
    report.items.push_back(Paragraph{methodText(study.study()).toHtmlEscaped()});
    report.items.push_back(foundValues(*answers, study.study()));
    if (studies::is_sampled(study.study().method)) {
        report.items.push_back(Paragraph{ReportWords::tr("Samples solved: %1")
                                             .arg(QLocale().toString(qulonglong(answers->solved)))
                                             .toHtmlEscaped(),
                                         Paragraph::Kind::Muted});
    }
    for (const auto& [reason, count] : study.refused()) {
        report.items.push_back(Paragraph{ReportWords::tr("Refused: %1 × %2")
                                             .arg(QLocale().toString(qulonglong(count)), reason)
                                             .toHtmlEscaped(),
                                         Paragraph::Kind::Muted});
    }
    for (const QString& note : study.notes()) {
        report.items.push_back(Paragraph{note.toHtmlEscaped(), Paragraph::Kind::Warning});
    }
    addRobustBest(report, study, patience);
    constexpr std::size_t most = 4;
    for (std::size_t i = 0; i < std::min(most, answers->values.size()); ++i) {
        report.items.push_back(tornadoOf(study, answers->values[i]));
    }
}

}  // namespace ravnoves
