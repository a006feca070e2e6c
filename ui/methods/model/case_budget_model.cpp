#include "methods/model/case_budget_model.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "case-file/input_error.h"
#include "plot/model/ticks.h"
#include "scenes/scenes.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

using methods::CaseDoubt;
using methods::Contribution;

namespace {

/// A change in the unit shown of its result: two digits, however small; of rounding its power of
/// ten.
ResultCell changeCell(const Contribution& contribution, const Unit& unit) {
    if (!contribution.change) {
        return CaseBudgetModel::tr("cannot be solved");
    }
    const double value = *contribution.change / unit * shownUnit(unit).factor;
    // The last digits of a rounding are those of a machine.
    const bool isBound = contribution.kind == Contribution::Kind::rounding;
    return {value, isBound ? QStringLiteral("< ") +
                                 powerOfTen(static_cast<int>(std::ceil(std::log10(value))))
                           : powerText(value, QLocale(), 2)};
}

ResultCell valueCell(const ResultEntry& result) {
    return shownCell(*result.si, result.unit, result.decimals);
}

/// Within a sentence; words have none.
std::string said(const ResultCell& cell, const Unit& unit) {
    return (cell.number() != nullptr ? withUnit(cell.text, shownUnit(unit).name) : cell.text)
        .toStdString();
}

}  // namespace

CaseBudgetModel::CaseBudgetModel(QObject* parent) : QObject(parent), job_(new BackgroundJob(this)) {
    connect(job_, &BackgroundJob::failed, this, [this](const QString& why) {
        trouble_ = why;
        Q_EMIT changed();
    });
}

void CaseBudgetModel::load(const std::optional<OpenCase>& open) {
    open_ = open;
    budget_.clear();
    trouble_.clear();
    isIncomplete_ = false;
    if (open) {
        job_->start([this, open = *open](const BackgroundJob::Progress&) -> std::function<void()> {
            std::vector<CaseDoubt> budget;
            try {
                budget = methods::case_budget(open.file, open.context);
            } catch (const InputError& error) {
                if (!error.found_message().empty()) {
                    throw;
                }
                return [this] {
                    isIncomplete_ = true;
                    Q_EMIT changed();
                };
            }
            return [this, budget = std::move(budget)] {
                budget_ = budget;
                names_ = FieldNames({scene_solver(open_->file.scene).fields(open_->file.input)});
                Q_EMIT changed();
            };
        });
    } else {
        job_->cancel();
    }
    Q_EMIT changed();
}

Verdict CaseBudgetModel::verdict() const {
    if (!open_) {
        return {Severity::note, Text::tr("Open a case to see how certain its results are.")};
    }
    if (!trouble_.isEmpty()) {
        return {Severity::error, Message(trouble_.toStdString())};
    }
    if (isIncomplete_) {
        return {Severity::note, Text::tr("The open case is incomplete: no results.")};
    }
    if (budget_.empty()) {
        return {Severity::note, Text::tr("Solving the case for each change.")};
    }
    // The first result that more than rounding changes.
    const auto doubted = std::ranges::find_if(budget_, [](const CaseDoubt& doubt) {
        return doubt.contributions.front().kind != Contribution::Kind::rounding;
    });
    const CaseDoubt& first = doubted != budget_.end() ? *doubted : budget_.front();
    return {Severity::note,
            {Text::tr("%1: %2. Maximum contribution: %3, %4."), first.result.name,
             said(valueCell(first.result), first.result.unit),
             nameOf(first.contributions.front()).toStdString(),
             said(changeCell(first.contributions.front(), first.result.unit), first.result.unit)}};
}

Results CaseBudgetModel::results() const {
    Results results{
        {{tr("Result and change"),
          tr("Leading results of the open case; below each, the effect of a single change")},
         {tr("Value"), tr("Present result")},
         {tr("Changes by"), tr("Difference from the value, the larger of two")},
         tr("Unit")}};
    const QString indent(3, QChar(0x2002));
    for (const CaseDoubt& doubt : budget_) {
        const QString unit = shownUnit(doubt.result.unit).name;
        results.rows << ResultRow{messageText(doubt.result.name), valueCell(doubt.result),
                                  QString(), unit};
        for (const Contribution& each : doubt.contributions) {
            const ResultCell change = changeCell(each, doubt.result.unit);
            results.rows << ResultRow{indent + nameOf(each), QString(), change,
                                      change.number() != nullptr ? unit : QString()};
        }
    }
    return results;
}

QStringList CaseBudgetModel::leftOut() const {
    QStringList sentences;
    if (open_) {
        for (const Text& text : scene_solver(open_->file.scene).left_out()) {
            sentences << shownText(text);
        }
    }
    return sentences;
}

QString CaseBudgetModel::nameOf(const Contribution& contribution) const {
    using Kind = Contribution::Kind;
    const QString input = names_.name(contribution.pointer);
    switch (contribution.kind) {
        case Kind::rounding:
            return tr("Rounding");
        case Kind::choice: {
            const auto words = names_.described(contribution.pointer)->field.words;
            const auto word = std::find_if(words.begin(), words.end(), [&](const Word& each) {
                return each.word == contribution.word;
            });
            return tr("%1: %2").arg(input, shownText(word->label));
        }
        case Kind::approximate:
            return tr("Kinematics: two-term form");
        case Kind::tolerance:
            break;
    }
    return tr("Tolerance: %1").arg(input);
}

}  // namespace ravnoves
