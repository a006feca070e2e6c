// What the page shows of the solution: what is missing, sentences and tables.

#include <algorithm>

#include "bob-weights/fields.h"
#include "bob-weights/model/bob_text.h"
#include "bob-weights/model/bob_weights_model.h"
#include "case-file/input_error.h"
#include "text/message_text.h"
#include "text/shown_units.h"
#include "text/typed_number.h"

namespace ravnoves {

using namespace bob_weights;

QString BobWeightsModel::shownError(const InputError& error) const {
    const QStringList place =
        QString::fromStdString(error.where()).split(QLatin1Char('/'), Qt::SkipEmptyParts);
    const bool isEarlier = place.value(2) == QLatin1String("earlier_runs");
    if (error.found().empty() && (isEarlier || place.value(2) == QLatin1String("readings"))) {
        // What is missing of a run.
        const QString& key = place.last();
        const Field& field =
            key == QLatin1String(field::angle.key.data()) ? field::angle : field::unbalance;
        const auto run = isEarlier ? place.value(3).toULongLong() : newestRun();
        const auto plane = place.value(place.size() - 2).toULongLong();
        return tr("Sheet 4, %1, %2: %3 is still needed.")
            .arg(bob_text::runName(Words(), run), bob_text::planeName(Words(), plane),
                 fieldName(field));
    }
    if (error.found().empty() && (place.value(1) == QLatin1String("correction") ||
                                  place.value(1) == QLatin1String("tolerance"))) {
        return missingText(error.where());
    }
    if (place.value(1) == QLatin1String("correction") &&
        place.value(2) == QLatin1String("planes") && place.size() == 5) {
        // The form has a column for each plane, no rows.
        const auto described = describedFields("/correction/planes/0/" + place[4].toStdString());
        const QString plane = bob_text::planeName(Words(), place[3].toULongLong());
        if (!described.empty()) {
            return explain(
                {(plane + QStringLiteral(", ") + inSentence(fieldName(described.front().field)))
                     .toStdString(),
                 error.allowed_message(), error.found_message()});
        }
    }
    if (place.value(1) == QLatin1String("weigh_in") && place.size() >= 5) {
        for (const Word& word : workshop::part_words) {
            if (place[2] == QLatin1String(word.word.data())) {
                return tr("Weigh-in sheet: %1 of cylinder %2 is missing or no weight.")
                    .arg(shownText(word.label))
                    .arg(place[4].toInt() + 1);
            }
        }
    }
    return explain(error);
}

/// Where something is missing, and what is to be typed there.
QString BobWeightsModel::missingText(const std::string& where) const {
    const QString pointer = QString::fromStdString(where);
    const auto is = [&](const char* list) { return pointer.contains(QLatin1String(list)); };
    const QString sheet = is("/planes/0/") ? tr("Sheet 4, %1").arg(bob_text::planeName(Words(), 0))
                          : is("/planes/1/")
                              ? tr("Sheet 4, %1").arg(bob_text::planeName(Words(), 1))
                          : is("/tolerance/") ? tr("Sheet 4, what may remain")
                          : is("/slug/")      ? tr("Sheet 5, heavy metal")
                                              : tr("Sheet 5, drills");
    const std::string_view place = std::string_view(where).substr(sizeof "/input" - 1);
    for (const auto& found : {fields(place), describedFields(place)}) {
        if (!found.empty()) {
            const Field& missing = found.front().field;
            const QString name = fieldName(missing);
            return missing.key == field::diameters.key
                       ? tr("%1: %2 are still needed, in %3, one after the other: %4")
                             .arg(sheet, name, shownUnit(units::mm).name,
                                  numberListText({8, 10, 12.5}, missing))
                       : tr("%1: %2 is still needed. %3").arg(sheet, name, shownText(missing.hint));
        }
    }
    return {};
}

QString BobWeightsModel::headline() const {
    return bob_text::headline(Words(), input(), solution());
}

QString BobWeightsModel::hangText() const {
    return solution().bob_weight ? bob_text::hang(Words(), input().engine) : QString();
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
    list.removeAll(QString());
    return list + doubts() + bob_text::warnings(Words(), input(), solution()) +
           bob_text::shortfalls(Words(), solution());
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
