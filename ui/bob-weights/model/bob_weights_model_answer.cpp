// What the page shows of the solution: what is missing, sentences and tables.

#include <algorithm>

#include "bob-weights/fields.h"
#include "bob-weights/model/bob_text.h"
#include "bob-weights/model/bob_weights_model.h"
#include "case-file/input_error.h"
#include "text/message_text.h"

namespace ravnoves {

using namespace bob_weights;

QString BobWeightsModel::shownError(const InputError& error) const {
    const QString placed = bob_text::sheetError(Words(), input(), error);
    return placed.isEmpty() ? explain(error) : placed;
}

QString BobWeightsModel::headline() const {
    return bob_text::headline(Words(), input(), solution());
}

QString BobWeightsModel::hangText() const {
    if (!solution().bob_weight) {
        return {};
    }
    const QString hang = bob_text::hang(Words(), input().engine);
    return bob_text::isMean(Words(), solution()) ? hang + QLatin1Char(' ') + weighInText() : hang;
}

QString BobWeightsModel::factorText() const {
    return bob_text::factor(Words(), input(), solution());
}

QString BobWeightsModel::reasonText() const {
    return input().engine.type == EngineType::v && !input().engine.bank_angle
               ? QString()
               : messageText(factor_reason(input().engine));
}

QString BobWeightsModel::limitText() const {
    return bob_text::limits(Words(), input(), solution());
}

QString BobWeightsModel::verdictText() const {
    return bob_text::verdict(Words(), solution());
}

QString BobWeightsModel::holeNote() const {
    return bob_text::holeNote(Words(), solution());
}

QStringList BobWeightsModel::doubts() const {
    return bob_text::doubts(Words(), input(), solution());
}

QStringList BobWeightsModel::troubles() const {
    QStringList list;
    if (solution().bob_weight) {
        try {
            check_input(input());
        } catch (const InputError& error) {
            list << shownError(error);
        }
    }
    list << otherReadingsText();
    for (const Message& message : bob_weights::not_counted(input())) {
        list << Words().message(message);
    }
    list << doubts() << bob_text::notGiven(Words(), solution())
         << bob_text::runWarnings(Words(), input(), solution())
         << bob_text::shortfalls(Words(), solution());
    list.removeAll(QString());
    return list;
}

bool BobWeightsModel::isDone() const {
    return solution().correction && solution().holds() &&
           std::all_of(solution().correction->begin(), solution().correction->end(),
                       [](const PlaneResult& plane) { return plane.reason.empty(); });
}

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

Results BobWeightsModel::lineResults() const {
    ResultRows rows = bob_text::lines(Words(), solution());
    if (solution().bob_weight) {
        rows.last().tip = tr("The bob weight: weigh it out so");
    }
    return {
        columnsOf(bob_text::lineHead(Words()), {QString(),
                                                tr("How many times the mass is in the bob weight: "
                                                   "rods on it, times the factor for what "
                                                   "moves with the piston"),
                                                tr("Mass × how often it counts")}),
        rows};
}

Results BobWeightsModel::runResults() const {
    return {columnsOf(bob_text::runHead(Words()),
                      {tr("The readings of the run taken to the front plane"),
                       tr("The readings of the run taken to the rear plane"),
                       tr("By the limits of both planes")}),
            newestRun() > 0 ? bob_text::runs(Words(), solution()) : ResultRows()};
}

Results BobWeightsModel::planeResults() const {
    const Words words;
    const ResultRows planes = bob_text::planes(words, solution());
    const QStringList names = bob_text::planeHead(words);
    const QStringList tips{
        tr("Both readings taken to the correction planes: same force, same moment"),
        tr("Angle of the heavy spot from the machine's zero mark"),
        tr("Mass that makes this unbalance at the plane's radius"),
        tr("What the holes below leave, their depths rounded, added up as vectors"),
        tr("By the limit of the plane: as measured → after the correction")};
    Results results{{bob_text::planeHead(words).first(), words.translate("BobWeights", "Front"),
                     words.translate("BobWeights", "Rear")}};
    ResultRows& rows = results.rows;
    for (qsizetype i = 1; i < names.size() && planes.size() == 2; ++i) {
        rows << ResultRow({names[i], planes[0][i], planes[1][i]}, tips.value(i - 1));
    }
    return results;
}

namespace {

/// Of depth, angle and mass of a hole.
QStringList holeTips() {
    return {shownText(field::maximum_depth.hint),
            BobWeightsModel::tr("From the machine's zero mark"),
            BobWeightsModel::tr(
                "Mass, the cone of the point included; negative: a slug adds its own weight, which "
                "stands beside its diameter, less what its hole took off")};
}

}  // namespace

Results BobWeightsModel::holeResults() const {
    return {columnsOf(bob_text::holeHead(Words()), holeTips()),
            bob_text::holes(Words(), solution())};
}

Results BobWeightsModel::drilledResults() const {
    return {columnsOf(bob_text::drilledHead(Words()), QStringList(QString()) + holeTips()),
            bob_text::drilled(Words(), solution())};
}

QString BobWeightsModel::drilledNote() const {
    return bob_text::drilledNote(Words(), solution());
}

}  // namespace ravnoves
