#include "methods/model/validation_model.h"

#include <QLocale>
#include <algorithm>

#include "methods/model/method_words.h"
#include "plot/model/ticks.h"
#include "text/message_text.h"
#include "text/number_text.h"

namespace ravnoves {

using methods::ValidationReport;
using methods::ValidationRow;

namespace {

/// A number of the report with the locale's decimal sign and a true minus.
QString shownNumber(const std::string& text) {
    QString number = QString::fromStdString(text);
    if (number.contains(QLatin1Char('e'))) {
        return powerText(number.section(QLatin1Char(' '), 0, 0).toDouble(), QLocale(), 2) +
               QStringLiteral("\u00A0%");  // only differences are so small
    }
    number = trueMinus(number);
    return number.replace(QLatin1Char('.'), QLocale().decimalPoint());
}

/// In per cent, or in the row's own unit.
QString shownDifference(const ValidationRow& row) {
    std::string text = row.difference_text();
    if (row.unit.empty() || !text.ends_with(row.unit) || row.unit == "%") {
        return shownNumber(text);
    }
    text.resize(text.size() - row.unit.size() - 1);
    return withUnit(shownNumber(text), unitText(row.unit));
}

}  // namespace

QString verdictTitle(methods::Verdict verdict) {
    return shownText(methods::verdict_title(verdict));
}

ValidationModel::ValidationModel(QObject* parent) : QObject(parent), job_(new BackgroundJob(this)) {
    connect(job_, &BackgroundJob::failed, this, &ValidationModel::failed);
}

void ValidationModel::load() {
    if (report_ || job_->isRunning()) {
        return;
    }
    job_->start([this](const BackgroundJob::Progress&) -> std::function<void()> {
        auto report = std::make_shared<const ValidationReport>(methods::validate());
        return [this, report] {
            report_ = report;
            filter();
        };
    });
}

Verdict ValidationModel::verdict() const {
    if (!report_) {
        return {Severity::note, Text::tr("Computing the printed numbers.")};
    }
    const std::size_t all = report_->rows.size();
    const std::size_t differing = report_->count(methods::Verdict::differs);
    return differing == 0
               ? Verdict{Severity::good,
                         {Text::tr("All %1 printed numbers are given, reproduced or explained."),
                          all}}
               : Verdict{Severity::warning,
                         {Text::tr("%1 of %2 printed numbers differ without a reason."), differing,
                          all}};
}

void ValidationModel::setPaper(std::optional<std::size_t> paper) {
    paper_ = paper;
    filter();
}

void ValidationModel::setVerdict(std::optional<methods::Verdict> verdict) {
    verdict_ = verdict;
    filter();
}

void ValidationModel::filter() {
    rows_.clear();
    if (report_) {
        for (const ValidationRow& row : report_->rows) {
            const bool paperFits = !paper_ || row.scene == methods::papers()[*paper_].scene;
            if (paperFits && (!verdict_ || row.verdict == *verdict_)) {
                rows_.push_back(&row);
            }
        }
    }
    Q_EMIT changed();
}

Results ValidationModel::results() const {
    Results results{{{tr("Place"), tr("Where the paper prints the number")},
                     {tr("Quantity")},
                     {tr("Unit")},
                     {tr("Printed")},
                     {tr("Ours")},
                     {tr("Difference")},
                     {tr("Verdict"), tr("Choose a row to read why")}}};
    const auto papers = methods::papers();
    for (const ValidationRow* row : rows_) {
        const auto paper = std::find_if(papers.begin(), papers.end(),
                                        [&](const auto& p) { return p.scene == row->scene; });
        const QString place = methodText(row->place);
        results.rows << ResultRow(
            {paper_ ? place : shownText(paper->authors) + QStringLiteral(", ") + place,
             methodText(row->quantity), unitText(row->unit), shownNumber(row->printed_text),
             shownNumber(row->ours_text()), shownDifference(*row), verdictTitle(row->verdict)},
            methodText(row->reason));
    }
    return results;
}

QString ValidationModel::countsText() const {
    if (!report_) {
        return tr("computing…");
    }
    const auto count = [this](methods::Verdict verdict) {
        return paper_ ? report_->count(verdict, methods::papers()[*paper_].scene)
                      : report_->count(verdict);
    };
    std::size_t all = 0;
    QStringList parts;
    for (const methods::Verdict verdict : methods::all_verdicts) {
        const std::size_t n = count(verdict);
        all += n;
        parts << QStringLiteral("%1: %2").arg(verdictTitle(verdict)).arg(n);
    }
    return tr("Printed numbers: %1 – %2").arg(all).arg(parts.join(QStringLiteral(", ")));
}

QStringList ValidationModel::paperTitles() const {
    QStringList titles;
    for (const methods::Paper& paper : methods::papers()) {
        titles << shownText(paper.authors);
    }
    return titles;
}

QString ValidationModel::asCsv() const {
    ValidationReport filtered;
    for (const ValidationRow* row : rows_) {
        filtered.rows.push_back(*row);
    }
    return QString::fromStdString(methods::write_csv(filtered));
}

}  // namespace ravnoves
