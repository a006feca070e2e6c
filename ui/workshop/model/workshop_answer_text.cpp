// What the page shows of the solution: what is missing, sentences and tables.

#include <algorithm>

#include "bob-weights/fields.h"
#include "case-file/input_error.h"
#include "shop/model/weigh_again.h"
#include "text/capital.h"
#include "text/message_text.h"
#include "workshop/model/bob_text.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plugs/model/v8_names.h"
#include "workshop/plugs/model/v8_text.h"

namespace ravnoves {

using namespace bob_weights;

QString WorkshopModel::planeName(std::size_t plane) const {
    return bob_text::planeName(Words(), input().machine, plane);
}

QString WorkshopModel::headline(const Words& words) const {
    if (withheld().bob_weight) {
        return words.translate("BobWeights", "STOP: no bob weight yet");
    }
    if (const auto& weight = solution().bob_weight) {
        const bool isNearest = plugs() != nullptr && plugs()->advice && !v8_text::works(*plugs());
        return (isNearest ? words.translate("BobWeights", "Bob weight with the nearest option: %1")
                : bob_text::isMean(words, solution())
                    ? words.translate("BobWeights", "Mean bob weight %1")
                    : words.translate("BobWeights", "Bob weight %1"))
            .arg(words.number(*weight, units::gram, 1));
    }
    if (bob_weights::balances_itself(input().engine)) {
        return words.translate("BobWeights", "No bob weights are needed");
    }
    QStringList missing;
    if (hasPlugs()) {
        missing = v8_names::missing(words, *plugsInput(), true);
    } else if (QString why = bob_text::contradiction(words, input()); !why.isEmpty()) {
        return why;
    } else {
        for (const Field* field : missing_for_bob_weight(input())) {
            missing << inSentence(words.name(*field));
        }
    }
    return words.translate("BobWeights", "Missing for the bob weight: %1")
        .arg(missing.join(QStringLiteral(", ")));
}

QString WorkshopModel::doubtfulText() const {
    const auto& weight = solved().found.shaft.bob_weight;
    return withheld().bob_weight && weight
               ? tr("Not to be used: bob weight %1.").arg(Words().number(*weight, units::gram, 1))
               : QString();
}

QString WorkshopModel::hangText(const Words& words) const {
    const bool isNeeded = !bob_weights::balances_itself(input().engine);
    if (!solution().bob_weight) {
        return isNeeded || withheld().bob_weight
                   ? QString()
                   : words.translate("BobWeights", "The crankpins balance one another.");
    }
    QStringList said;
    if (!isNeeded) {
        said << words.translate(
            "BobWeights",
            "No bob weights are needed: the crankpins balance one another. If you use them:");
    }
    const int crankpins = input().engine.crankpins();
    said << (crankpins == 1
                 ? words.translate("BobWeights", "On the crankpin.")
                 : words.translate("BobWeights", "On each of the %1 crankpins.").arg(crankpins));
    if (bob_text::isMean(words, solution())) {
        said << bob_text::weighIn(words, input(), solution());
    }
    if (plugs() != nullptr) {
        said << v8_text::plugsWhileHung(words, *plugs());
    }
    said.removeAll(QString());
    return said.join(QLatin1Char(' '));
}

QString WorkshopModel::factorText(const Words& words) const {
    return bob_text::factor(words, input(), solution());
}

QString WorkshopModel::reasonText() const {
    return input().engine.type == EngineType::v && !input().engine.bank_angle
               ? QString()
               : messageText(factor_reason(input().engine));
}

QString WorkshopModel::limitText() const {
    return bob_text::limits(Words(), input(), solution());
}

QString WorkshopModel::holeNote() const {
    if (withheld().holes && input().correction) {
        return tr("STOP: correct the top line before drilling.");
    }
    return bob_text::holeNote(Words(), solution());
}

QStringList WorkshopModel::notCounted(const Words& words) const {
    QStringList list;
    for (const Message& message :
         hasPlugs() ? v8_plugs::not_counted(*plugsInput()) : bob_weights::not_counted(input())) {
        list << words.message(message);
    }
    return list;
}

QStringList WorkshopModel::troubles(const Words& words, bool withDoubts) const {
    QStringList list{bob_text::brokenRule(words, input(), solution())};
    // The first of those that block is in the verdict, and so do the warnings where it is one.
    const bool hasWarnings =
        withheld().any() || (!withDoubts && solved().verdict.severity != Severity::note);
    bool isSaid = withDoubts;
    for (const workshop::Doubt& doubt : doubts()) {
        if (doubt.rule->blocks.any() ? std::exchange(isSaid, true)
                                     : !hasWarnings && doubt.rule->severity == Severity::warning) {
            list << words.message(doubt.text);
        }
    }
    list << notCounted(words) << bob_text::notGiven(words, solution())
         << bob_text::missingAngles(words, input(), solution())
         << bob_text::shortfalls(words, input().machine, solution())
         << bob_text::correctedRuns(words, input(), solution());
    if (plugs() != nullptr) {
        list << v8_text::troubles(words, *plugsInput());
    }
    list.removeAll(QString());
    list.removeDuplicates();
    return list;
}

QStringList WorkshopModel::remarks() const {
    QStringList list;
    for (const workshop::Doubt& doubt : doubts()) {
        if (doubt.rule->severity == Severity::note) {
            list << Words().message(doubt.text);
        }
    }
    return list;
}

// ----------------------------------------------------------------------------------- the parts

WeighedColumn WorkshopModel::columnNote(shop::Part part) const {
    const auto sheet = bob_weights::fitted(input()).weigh_in;
    const auto statistics = sheet ? shop::statistics((*sheet)[part]) : std::nullopt;
    WeighedColumn column;
    if (!statistics) {
        return column;
    }
    const Words words;
    const shop::PartColumn& weighed = (*sheet)[part];
    const auto grams = [&](double mass) { return words.digits(mass, units::gram, 2); };
    column.mean = grams(statistics->mean);
    if (weighed.nominal) {
        const double deviation = statistics->mean - *weighed.nominal;
        column.deviation =
            (deviation >= 0.005 * units::gram ? QStringLiteral("+") : QString()) + grams(deviation);
    }
    column.spread = grams(statistics->spread);
    column.tooWide = !statistics->within_permitted;
    column.counts = hasPlugs() ? input().plugs->changes_from_weigh_in && weighed.is_complete()
                               : weighed.is_weighed();
    column.toolTip = tr("%1: %2 weighed; heaviest in cylinder %3, lightest in cylinder %4.")
                         .arg(shownText(shop::part_word(part).label))
                         .arg(statistics->count)
                         .arg(statistics->heaviest + 1)
                         .arg(statistics->lightest + 1);
    if (!weighed.is_weighed()) {
        column.toolTip += QLatin1Char('\n') + tr("Used when every cylinder is weighed.");
    }
    return column;
}

QString WorkshopModel::weighInText() const {
    return bob_text::weighIn(Words(), input(), solution());
}

QString WorkshopModel::weighAgain() const {
    const auto sheet = fitted(input()).weigh_in;
    return sheet ? weighAgainText(Words(), *sheet) : QString();
}

std::optional<matching_text::Shown> WorkshopModel::matchingShown() const {
    return plugs() != nullptr ? v8_text::matchingShown(*plugsInput(), *plugs())
                              : bob_text::matchingShown(input(), solution());
}

QString WorkshopModel::assignmentText() const {
    const QString again = weighAgain();
    return again.isEmpty() ? ofMatching(matching_text::summary) : again;
}

QStringList WorkshopModel::assignmentRemarks() const {
    return ofMatching(matching_text::remarks);
}

Results WorkshopModel::assignmentResults() const {
    return ofMatching(matching_text::assignment);
}

Results WorkshopModel::effectResults() const {
    return ofMatching(matching_text::effects);
}

Results WorkshopModel::takeOffResults() const {
    const auto sheet = fitted(input()).weigh_in;
    return sheet ? matching_text::takeOff(Words(), *sheet) : Results();
}

bool WorkshopModel::canMoveBack() const {
    // By the numbers of a sheet of another number of cylinders they cannot.
    const auto sheet = fitted(input()).weigh_in;
    return sheet && sheet->is_moved();
}

void WorkshopModel::moveBack() {
    if (canMoveBack()) {
        editWeights(tr("Parts as weighed"), [](WeighIn& sheet) { move_back(sheet); });
    }
}

void WorkshopModel::moveParts() {
    if (const auto placing = solution().placing) {
        editWeights(tr("Move parts"),
                    [&](WeighIn& sheet) { move_sets(sheet, placing->pistons, placing->rods); });
    }
}

// ---------------------------------------------------------------------------------- the tables

namespace {

/// @param tips  of the headings behind the first
ResultColumns columnsOf(const QStringList& heads, const QStringList& tips) {
    ResultColumns columns(heads.begin(), heads.end());
    for (qsizetype i = 1; i < columns.size(); ++i) {
        columns[i].tip = tips.value(i - 1);
    }
    return columns;
}

}  // namespace

Results WorkshopModel::lineResults() const {
    ResultRows rows = bob_text::lines(Words(), solution());
    if (solution().bob_weight) {
        rows.last().tip = tr("Mass of the bob weight");
    }
    return {columnsOf(bob_text::lineHead(Words()),
                      {QString(),
                       tr("Multiplier of the mass in the bob weight: number of rods, times the "
                          "balance factor for reciprocating parts"),
                       tr("Mass × multiplier")}),
            rows};
}

Results WorkshopModel::runResults() const {
    return {columnsOf(bob_text::runHead(Words(), input().machine),
                      {tr("Readings of the run, transferred to the front plane"),
                       tr("Readings of the run, transferred to the rear plane"),
                       tr("By the limits of both planes")}),
            newestRun() > 0 ? bob_text::runs(Words(), solution()) : ResultRows()};
}

Results WorkshopModel::planeResults() const {
    const Words words;
    const ResultRows planes = bob_text::planes(words, input().machine, solution());
    const QStringList names = bob_text::planeHead(words);
    const QStringList tips{
        tr("Both readings, transferred to the correction planes (same force, same moment)"),
        tr("Angle of the heavy spot from the machine's zero mark"),
        tr("Mass at the drilling radius for this unbalance"),
        tr("Residual after the holes below, with rounded depths"),
        tr("By the limit of the plane: as measured → after the correction")};
    Results results{{names.first(), planeName(0), planeName(1)}};
    ResultRows& rows = results.rows;
    for (qsizetype i = 1; i < names.size() && planes.size() == 2; ++i) {
        const auto isKnown = [i](const ResultRow& row) { return row[i].text != QChar(0x2013); };
        if (!std::any_of(planes.begin(), planes.end(), isKnown)) {
            continue;  // of readings alone
        }
        rows << ResultRow({names[i], planes[0][i], planes[1][i]}, tips.value(i - 1));
    }
    return results;
}

namespace {

/// Of depth, angle and mass of a hole.
QStringList holeTips() {
    return {shownText(field::maximum_depth.hint), WorkshopModel::tr("From the machine's zero mark"),
            WorkshopModel::tr("Mass taken off, including the drill point; negative for a slug: its "
                              "own mass minus its hole")};
}

}  // namespace

Results WorkshopModel::holeResults() const {
    return {columnsOf(bob_text::holeHead(Words()), holeTips()),
            bob_text::holes(Words(), input(), solution())};
}

}  // namespace ravnoves
