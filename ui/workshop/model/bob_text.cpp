#include "workshop/model/bob_text.h"

#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "bob-weights/fields.h"
#include "bob-weights/matching.h"
#include "case-file/field_index.h"
#include "shop/balance_grade.h"
#include "shop/model/verdict.h"
#include "shop/model/weigh_again.h"
#include "shop/results.h"
#include "text/capital.h"
#include "text/shown_units.h"
#include "text/typed_number.h"

namespace ravnoves::bob_text {

using namespace bob_weights;

namespace {

const QString noNumber = QStringLiteral("–");

QString degreesOf(const Words& words, double angle) {
    return words.number(angle, units::degree, 1);
}

ResultCell direction(const Words& words, double angle) {
    return {angle / degree, degreesOf(words, angle), ResultCell::Kind::Direction};
}

QString unbalanceOf(const Words& words, double unbalance) {
    return words.number(unbalance, units::gram_mm, 1);
}

/// An unbalance as text with its direction, where it has one.
QString atAngle(const Words& words, const QString& shown, double unbalance, double angle) {
    return has_direction(unbalance) ? shown + QStringLiteral(" ∠ ") + degreesOf(words, angle)
                                    : shown;
}

/// By what limit, and how the planes share it.
QString limitOrigin(const Words& words, const Tolerance& tolerance) {
    if (!tolerance.by_grade) {
        return words.translate("BobWeights", "Shop limit for each plane, instead of a grade.");
    }
    const QString grade =
        words.translate("BobWeights", "By G %1 of ISO 21940-11, %2 at %3.")
            .arg(words.plain(*tolerance.grade / units::mm_per_s, 2),
                 words.plainWithUnit(*tolerance.rotor_mass, shop::field::rotor_mass, 2),
                 words.plainWithUnit(*tolerance.service_speed, units::rpm, 0));
    const QString share =
        tolerance.front_bearing && tolerance.rear_bearing
            ? words.translate("BobWeights",
                              "Shared between the planes by the distances of the end bearings.")
        : tolerance.centre_of_mass
            ? words.translate("BobWeights", "Shared between the planes by the centre of mass.")
            : words.translate("BobWeights", "Half in each plane.");
    return grade + QLatin1Char(' ') + share;
}

}  // namespace

QString engineName(const Words& words, const Engine& engine) {
    switch (engine.type) {
        case EngineType::v:
            return engine.bank_angle
                       ? words.translate("BobWeights", "V-%1, %2")
                             .arg(engine.cylinders)
                             .arg(words.plain(*engine.bank_angle / degree, 1) + QStringLiteral("°"))
                       : QStringLiteral("V-%1").arg(engine.cylinders);
        case EngineType::in_line:
            return words.translate("BobWeights", "%1 in line").arg(engine.cylinders);
        case EngineType::boxer:
            return words.translate("BobWeights", "Boxer, %1").arg(engine.cylinders);
    }
    return {};
}

QString engineName(const Words& words, const QString& english) {
    static const QRegularExpression form(
        QStringLiteral("^(?:V-(\\d+)(?:, ([\\d.]+)°)?|(\\d+) in line|Boxer, (\\d+))$"));
    const QRegularExpressionMatch match = form.match(english);
    if (!match.hasMatch()) {
        return english;
    }
    Engine engine;
    engine.type = match.hasCaptured(1)   ? EngineType::v
                  : match.hasCaptured(3) ? EngineType::in_line
                                         : EngineType::boxer;
    engine.cylinders = (match.captured(1) + match.captured(3) + match.captured(4)).toInt();
    if (match.hasCaptured(2)) {
        engine.bank_angle = match.captured(2).toDouble() * degree;
    }
    return engineName(words, engine);
}

namespace {

/// The field of an error's place; nothing where that is none.
std::optional<Field> fieldAt(const InputError& error) {
    constexpr std::string_view root = "/input";
    // All elements of a list are described by its first.
    static const QRegularExpression element(QStringLiteral("/\\d+(?=/)"));
    const QString pointer = QString::fromStdString(error.where().substr(root.size()))
                                .replace(element, QStringLiteral("/0"));
    const auto found = describe_fields<workshop::Input>(pointer.toStdString());
    return found.empty() ? std::nullopt : std::optional(found.front().field);
}

QString ruleText(const Words& words, const QString& name, const InputError& error) {
    const QString rule = words.message(
        error.found_message().empty() ? error.allowed_message()
                                      : Message(CORE_TEXT("core", "%1, got %2"),
                                                error.allowed_message(), error.found_message()));
    return name.isEmpty() ? rule : name + QStringLiteral(": ") + rule;
}

/// Its name without the place.
QString ruleText(const Words& words, const InputError& error) {
    const auto field = fieldAt(error);
    return ruleText(words, field ? words.name(*field) : QString(), error);
}

/// Where something is missing, and what is to be typed there.
QString missingText(const Words& words, const workshop::Machine& machine, const InputError& error) {
    const QString pointer = QString::fromStdString(error.where());
    const auto is = [&](const char* list) { return pointer.contains(QLatin1String(list)); };
    const QString sheet =
        is("/planes/0/")
            ? words.translate("BobWeights", "Sheet 5, %1").arg(planeName(words, machine, 0))
        : is("/planes/1/")
            ? words.translate("BobWeights", "Sheet 5, %1").arg(planeName(words, machine, 1))
        : is("/tolerance/") ? words.translate("BobWeights", "Sheet 5, permissible residual")
        : is("/slug/")      ? words.translate("BobWeights", "Sheet 6, heavy metal")
                            : words.translate("BobWeights", "Sheet 6, drills");
    const auto missing = fieldAt(error);
    if (!missing) {
        return {};
    }
    const QString name = words.name(*missing);
    return missing->key == field::diameters.key
               ? words.translate("BobWeights", "%1: enter %2 in %3, separated by semicolons: %4")
                     .arg(sheet, name, words.unit(units::mm),
                          numberListText({8, 10, 12.5}, *missing))
               : words.translate("BobWeights", "%1: enter %2. %3")
                     .arg(sheet, name, words.text(missing->hint));
}

/// "Sheet 5, Run 1, Front plane: enter Heavy spot."
QString valueMissing(const Words& words, const workshop::Input& input, std::size_t run,
                     std::size_t plane, const Field& field) {
    return words.translate("BobWeights", "Sheet 5, %1, %2: enter %3.")
        .arg(runName(words, run - firstRun(input)), planeName(words, input.machine, plane),
             words.name(field));
}

/// What an error says of the sheets of the machine and of the weights, with its place on the form:
/// "Sheet 4, Front plane: enter Radius. …"; empty of other places.
QString sheetError(const Words& words, const workshop::Input& input, const InputError& error) {
    const QStringList place =
        QString::fromStdString(error.where()).split(QLatin1Char('/'), Qt::SkipEmptyParts);
    const bool isOfCorrection = place.value(1) == QLatin1String("correction");
    const bool isEarlier = place.value(2) == QLatin1String("earlier_runs");
    if (error.found().empty() && (isEarlier || place.value(2) == QLatin1String("readings"))) {
        // What is missing of a run.
        const QString& key = place.last();
        const Field& field =
            key == QLatin1String(field::angle.key.data()) ? field::angle : field::unbalance;
        const auto newest = input.correction ? input.correction->earlier_runs.size() : 0;
        const auto run = isEarlier ? place.value(3).toULongLong() : newest;
        const auto plane = place.value(place.size() - 2).toULongLong();
        return valueMissing(words, input, run, plane, field);
    }
    if (error.found().empty() && (isOfCorrection || place.value(1) == QLatin1String("tolerance"))) {
        return missingText(words, input.machine, error);
    }
    if (isOfCorrection && place.size() == 3 && place.value(2) == QLatin1String("planes")) {
        return words.translate("BobWeights", "Sheet 5: enter position and radius of both planes.");
    }
    if (isOfCorrection && place.value(2) == QLatin1String("planes") && place.size() == 5) {
        // The form has a column for each plane, no rows.
        const QString plane = planeName(words, input.machine, place[3].toULongLong());
        const auto field = fieldAt(error);
        return field
                   ? ruleText(words, plane + QStringLiteral(", ") + inSentence(words.name(*field)),
                              error)
                   : QString();
    }
    if (place.value(1) == QLatin1String("weigh_in") && place.size() >= 5) {
        for (const Word& word : shop::part_words) {
            if (place[2] == QLatin1String(word.word.data())) {
                return words
                    .translate("BobWeights",
                               "Weigh-in sheet: %1 of cylinder %2 is missing or not a mass.")
                    .arg(words.text(word.label))
                    .arg(place[4].toInt() + 1);
            }
        }
    }
    return {};
}

}  // namespace

QStringList missingAngles(const Words& words, const workshop::Input& input, const Result& result) {
    QStringList list;
    const RunResult* newest = result.newest();
    if (!input.correction || input.correction->planes.empty() || newest == nullptr ||
        newest->passes() == true) {
        return list;
    }
    const Correction& correction = *input.correction;
    for (std::size_t plane = 0; plane < correction.readings.size(); ++plane) {
        const Reading& reading = correction.readings[plane];
        if (reading.unbalance && !is_read(reading)) {
            list << valueMissing(words, input, correction.earlier_runs.size(), plane, field::angle);
        }
    }
    return list;
}

QString brokenRule(const Words& words, const workshop::Input& input, const Result& result) {
    if (!result.bob_weight) {
        return {};
    }
    try {
        workshop::check_input(input);
    } catch (const InputError& error) {
        const QString said = sheetError(words, input, error);
        return said.isEmpty() ? ruleText(words, error) : said;
    }
    return {};
}

QString contradiction(const Words& words, const Input& input) {
    if (!missing_for_bob_weight(input).empty()) {
        return {};
    }
    try {
        check_bob_weight(input);
    } catch (const InputError& error) {
        return ruleText(words, error);
    }
    return {};
}

QString factor(const Words& words, const Input& input, const Result& result) {
    const auto percent = [&](double share) {
        return words.plain(100.0 * share, 2) + QStringLiteral("\u00A0%");
    };
    QString text = input.factor.reciprocating
                       ? words.translate("BobWeights", "Balance factor %1 (theory: %2)")
                             .arg(percent(result.factor), percent(result.theory_factor))
                       : words.translate("BobWeights", "Balance factor %1, by theory")
                             .arg(percent(result.factor));
    if (input.factor.overbalance != 0.0) {
        text += words
                    .translate("BobWeights", " + %1 overbalance",
                               "after the factor; negative numbers have their sign")
                    .arg(percent(input.factor.overbalance));
    }
    return text + QStringLiteral(". ") +
           words.message(factor_effect(input.engine, result.factor + input.factor.overbalance));
}

QString limits(const Words& words, const Input& input, const Result& result) {
    if (!result.permissible || !input.tolerance) {
        return {};
    }
    const QString first = unbalanceOf(words, (*result.permissible)[0]);
    const QString second = unbalanceOf(words, (*result.permissible)[1]);
    const QString planes =
        first == second
            ? words.translate("BobWeights", "%1 in each plane").arg(first)
            : words.translate("BobWeights", "%1 in the front plane, %2 in the rear plane")
                  .arg(first, second);
    const QString said =
        result.permissible_whole
            ? words.translate("BobWeights", "Permissible residual: %1, of %2 for the crankshaft.")
                  .arg(planes, unbalanceOf(words, *result.permissible_whole))
            : words.translate("BobWeights", "Permissible residual: %1.").arg(planes);
    return said + QLatin1Char(' ') + limitOrigin(words, *input.tolerance);
}

QString otherRun(const Words& words, const Result& result) {
    for (std::size_t run = result.runs.size(); run-- > 0;) {
        const RunResult& read = result.runs[run];
        if (!read.holds()) {
            const QString said = words.message(
                shop::other_readings(read.read_with, read.read_on, result.bob_weight));
            return &read == result.newest()
                       ? said
                       : runName(words, run - firstRun(result)) + QStringLiteral(": ") + said;
        }
    }
    return {};
}

QString notGiven(const Words& words, const Result& result) {
    if (!result.bob_weight || result.not_given.empty()) {
        return {};
    }
    QStringList names;
    for (const PartField* part : result.not_given) {
        names << inSentence(words.name(part->field));
    }
    return words
        .translate("BobWeights", "Not given, %1 is used: %2. Enter 0 if there is no such part.")
        .arg(words.plainWithUnit(0.0, units::gram, 0), names.join(QStringLiteral(", ")));
}

QStringList correctedRuns(const Words& words, const workshop::Input& input, const Result& result) {
    QStringList list;
    // Without planes or readings nothing was planned.
    const std::size_t runs =
        input.correction ? std::min(input.correction->earlier_runs.size(), result.runs.size()) : 0;
    for (std::size_t run = 0; run < runs; ++run) {
        if (!input.correction->earlier_runs[run].drilled_by.empty() &&
            result.runs[run].is_drilled()) {
            list << words
                        .translate("BobWeights",
                                   "%1: the drilled holes were planned from another reading.")
                        .arg(runName(words, run - firstRun(input)));
        }
    }
    return list;
}

QString asReadNote(const Words& words, const Input& input, const Result& result) {
    if (!result.correction || !input.correction) {
        return {};
    }
    QStringList read;
    bool isMoved = false;
    for (std::size_t i = 0; i < 2; ++i) {
        const Reading& reading = input.correction->readings.at(i);
        const double plane = input.correction->planes.at(i).position.value_or(0.0);
        const double at = reading.position.value_or(plane);
        constexpr double same = 1e-9;  // m
        isMoved = isMoved || std::abs(at - plane) > same;
        const double unbalance = reading.unbalance.value_or(0.0);
        read << words.translate("BobWeights", "%1 at %2")
                    .arg(atAngle(words, unbalanceOf(words, unbalance), unbalance,
                                 reading.angle.value_or(0.0)),
                         words.plainWithUnit(at, units::mm, 1));
    }
    return isMoved ? words
                         .translate("BobWeights",
                                    "Readings: %1 and %2. “Measured” is the reading transferred to "
                                    "the planes.")
                         .arg(read[0], read[1])
                   : QString();
}

namespace {

/// Nothing is drilled by readings that may not hold.
bool hasHoles(const Result& result) {
    return result.correction && result.holds() &&
           std::any_of(result.correction->begin(), result.correction->end(),
                       [](const PlaneResult& plane) {
                           return !plane.holes.empty() || !plane.slugs.empty();
                       });
}

QString slugNote(const Words& words, const std::array<PlaneResult, 2>& planes) {
    const bool hasSlugs = std::any_of(planes.begin(), planes.end(), [](const PlaneResult& plane) {
        return !plane.slugs.empty();
    });
    return hasSlugs ? QLatin1Char(' ') +
                          words.translate("BobWeights",
                                          "A slug is as long as its hole; its mass is given with "
                                          "its diameter. Secure it: a press fit alone does not "
                                          "withstand the force at service speed.")
                    : QString();
}

}  // namespace

QString holeNote(const Words& words, const Result& result) {
    return !hasHoles(result)
               ? QString()
               : words.translate("BobWeights",
                                 "Depths exclude the drill point; the rim is taken as flat.") +
                     slugNote(words, *result.correction);
}

QString metals(const Words& words, const Input& input, const Result& result) {
    if (!input.correction || !hasHoles(result)) {
        return {};
    }
    const Drill& drill = input.correction->drill;
    const auto density = [&](double value) { return words.plainWithUnit(value, units::kg_m3, 1); };
    QString said =
        words
            .translate("BobWeights",
                       "Planned with a point angle of %1 and a crankshaft density of %2")
            .arg(words.plainWithUnit(drill.point_angle, units::degree, 1), density(drill.density));
    const auto& slug = input.correction->slug;
    if (!slugNote(words, *result.correction).isEmpty() && slug && slug->density) {
        said += words.translate("BobWeights", ", slugs of %1").arg(density(*slug->density));
    }
    return said + QLatin1Char('.');
}

QString planeName(const Words& words, const workshop::Machine& machine, std::size_t plane) {
    const std::string& own = machine.planes.at(plane);
    return !own.empty() ? capitalised(QString::fromStdString(own))
           : plane == 0 ? words.translate("BobWeights", "Front plane")
                        : words.translate("BobWeights", "Rear plane");
}

std::size_t firstRun(const workshop::Input& input) {
    return input.correction && starts_with_holes(*input.correction) ? 1 : 0;
}

std::size_t firstRun(const Result& result) {
    return result.runs.size() > 1 && !result.runs.front().is_read() &&
                   result.runs.front().is_drilled()
               ? 1
               : 0;
}

QStringList shortfalls(const Words& words, const workshop::Machine& machine, const Result& result) {
    QStringList list;
    // Nothing is said of a correction by readings that may not hold.
    if (result.correction && result.holds()) {
        for (std::size_t i = 0; i < 2; ++i) {
            const PlaneResult& plane = (*result.correction)[i];
            if (!plane.reason.empty()) {
                list << planeName(words, machine, i) + QStringLiteral(": ") +
                            words.message(plane.reason);
            }
        }
    }
    return list;
}

QStringList cylindersOfCrankpins(const Input& input) {
    if (input.engine.cylinders % input.engine.rods_per_pin != 0) {
        return {};
    }
    QStringList pins;
    const auto places = places_of(crank_of(input));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto pin = static_cast<qsizetype>(places[i].crankpin);
        pins.resize(std::max(pins.size(), pin + 1));
        pins[pin] +=
            (pins[pin].isEmpty() ? QString() : QStringLiteral("+")) + QString::number(i + 1);
    }
    return pins;
}

bool isMean(const Words& words, const Result& result) {
    const auto shown = [&](double mass) { return words.digits(mass, units::gram, 1); };
    return result.bob_weight &&
           std::any_of(result.crankpins.begin(), result.crankpins.end(),
                       [&](double own) { return shown(own) != shown(*result.bob_weight); });
}

QString weighIn(const Words& words, const Input& input, const Result& result) {
    if (result.crankpins.empty()) {
        return {};
    }
    const QStringList cylinders = cylindersOfCrankpins(input);
    QStringList pins;
    for (std::size_t i = 0; i < result.crankpins.size(); ++i) {
        const QString own = cylinders.value(static_cast<qsizetype>(i));
        const QString mass = words.digits(result.crankpins[i], units::gram, 1);
        pins << (own.isEmpty() ? mass
                               : (i == 0 ? words.translate("BobWeights", "%1 (cylinders %2)")
                                         : QStringLiteral("%1 (%2)"))
                                     .arg(mass, own));
    }
    return words.translate("BobWeights", "Bob weight by crankpin, %1: %2.")
        .arg(words.unit(units::gram), pins.join(QStringLiteral("; ")));
}

QString weighAgain(const Words& words, const Input& input) {
    const auto sheet = fitted(input).weigh_in;
    return sheet ? weighAgainText(words, *sheet) : QString();
}

QString placedWeighIn(const Words& words, const Input& input, const Result& result) {
    if (!result.placing || result.placing->moved == 0 || result.placed_crankpins.empty() ||
        !weighAgain(words, input).isEmpty()) {
        return {};
    }
    QStringList pins;
    for (const double mass : result.placed_crankpins) {
        pins << words.digits(mass, units::gram, 1);
    }
    return words.translate("BobWeights", "After moving the sets as suggested: %1.")
        .arg(pins.join(QStringLiteral("; ")));
}

std::optional<matching_text::Shown> matchingShown(const Input& given, const Result& result) {
    if (!given.weigh_in || !result.placing || !weighAgain(Words(), given).isEmpty()) {
        return std::nullopt;
    }
    const Input input = fitted(given);
    const WeighIn& sheet = *input.weigh_in;
    matching_text::Shown shown{*result.placing,      crank_of(input),   sheet.matching.crank_radius,
                               service_speed(input), sheet.piston_sets, sheet.rod_sets};
    shown.is_origin_unknown = given.weigh_in->is_moved() && !sheet.is_moved();
    matching_text::takeAsWeighed(
        shown, matching_task(input, result.factor + input.factor.overbalance), sheet);
    return shown;
}

QString balance(const Words& words, Balance balance) {
    return words.text(balance_words[static_cast<std::size_t>(balance)].label);
}

QStringList lineHead(const Words& words) {
    const QString gram = words.unit(units::gram);
    return {words.translate("BobWeights", "Part"),
            words.translate("BobWeights", "Each, %1").arg(gram),
            words.translate("BobWeights", "Multiplier"),
            words.translate("BobWeights", "Total, %1").arg(gram)};
}

namespace {

/// The products of the lines in tenths of a gram, so that they add up to the sum printed.
std::vector<long> tenthsOf(const Result& result) {
    constexpr double tenth = 0.1 * units::gram;
    std::vector<long> tenths;
    long left = std::lround(result.bob_weight.value_or(0.0) / tenth);
    for (const Line& line : result.lines) {
        tenths.push_back(std::lround(line.product() / tenth));
        left -= tenths.back();
    }
    while (left != 0 && !tenths.empty()) {
        const long step = left > 0 ? 1 : -1;
        std::size_t nearest = 0;
        double most = -1.0;
        for (std::size_t i = 0; i < tenths.size(); ++i) {
            const double short_by = static_cast<double>(step) * (result.lines[i].product() / tenth -
                                                                 static_cast<double>(tenths[i]));
            if (short_by > most) {
                most = short_by;
                nearest = i;
            }
        }
        tenths[nearest] += step;
        left -= step;
    }
    return tenths;
}

}  // namespace

ResultRows lines(const Words& words, const Result& result) {
    ResultRows rows;
    const std::vector<long> tenths =
        result.bob_weight ? tenthsOf(result) : std::vector<long>(result.lines.size());
    const auto printed = [&](long value) {
        return words.cell(0.1 * units::gram * static_cast<double>(value), units::gram, 1);
    };
    std::array<long, 2> subtotals{};
    bool haveParts = true;
    for (std::size_t i = 0; i < result.lines.size(); ++i) {
        const Line& line = result.lines[i];
        rows << ResultRow(
            {words.text(line.name().label).remove(QLatin1Char('&')),
             words.cell(line.mass, units::gram, 1),
             QStringLiteral("× ") + words.plain(line.factor, 4),
             result.bob_weight ? printed(tenths[i]) : words.cell(line.product(), units::gram, 1)},
            line.part != nullptr ? words.text(line.part->field.hint) : QString());
        haveParts = haveParts && line.part != nullptr;
        if (line.part != nullptr) {
            subtotals[line.part->kind == PartKind::reciprocating ? 0 : 1] += tenths[i];
        }
    }
    if (!result.bob_weight) {
        return rows;
    }
    if (haveParts && !result.lines.empty()) {
        rows << ResultRow{words.translate("BobWeights", "Reciprocating"), QString(), QString(),
                          printed(subtotals[0])}
             << ResultRow{words.translate("BobWeights", "Rotating"), QString(), QString(),
                          printed(subtotals[1])};
    }
    rows << ResultRow{words.translate("BobWeights", "Sum"), QString(), QString(),
                      words.cell(*result.bob_weight, units::gram, 1)};
    return rows;
}

QString runName(const Words& words, std::size_t run) {
    return run == 0 ? words.translate("BobWeights", "Before")
                    : words.translate("BobWeights", "Run %1").arg(run);
}

QStringList runHead(const Words& words, const workshop::Machine& machine) {
    const QString unit = QStringLiteral(", ") + words.unit(units::gram_mm);
    return {words.translate("BobWeights", "Run"), planeName(words, machine, 0) + unit,
            planeName(words, machine, 1) + unit, words.translate("BobWeights", "Verdict")};
}

ResultRows runs(const Words& words, const Result& result) {
    ResultRows rows;
    for (std::size_t run = firstRun(result); run < result.runs.size(); ++run) {
        const auto& planes = result.runs[run].planes;
        const auto cell = [&](std::size_t i) {
            if (!planes) {
                const auto& alone = result.runs[run].alone[i];
                return alone ? words.digits(alone->unbalance, units::gram_mm, 1) : noNumber;
            }
            const auto& plane = (*planes)[i];
            return atAngle(words, words.digits(plane.unbalance, units::gram_mm, 1), plane.unbalance,
                           plane.angle);
        };
        const QString verdict =
            verdictText(words, readWord(result.runs[run], result.runs[run].passes()));
        rows << ResultRow{runName(words, run - firstRun(result)), cell(0), cell(1),
                          verdict.isEmpty() ? noNumber : verdict};
    }
    return rows;
}

QStringList planeHead(const Words& words) {
    return {words.translate("BobWeights", "Plane"),
            words.translate("BobWeights", "Measured"),
            words.translate("BobWeights", "Heavy spot"),
            words.translate("BobWeights", "Mass at drilling radius"),
            words.translate("BobWeights", "After correction"),
            words.translate("BobWeights", "Verdict")};
}

ResultRows planes(const Words& words, const workshop::Machine& machine, const Result& result) {
    ResultRows rows;
    const RunResult* newest = result.newest();
    for (std::size_t i = 0; !result.correction && newest != nullptr && i < 2; ++i) {
        // Readings without a plan: a verdict alone.
        const auto unbalance = newest->unbalances()[i];
        const auto within = newest->planes     ? (*newest->planes)[i].within_tolerance
                            : newest->alone[i] ? newest->alone[i]->within_tolerance
                                               : std::nullopt;
        const QString verdict = verdictText(words, readWord(*newest, within));
        rows << ResultRow{
            planeName(words, machine, i),
            unbalance ? words.cellWithUnit(*unbalance, units::gram_mm, 1) : ResultCell(noNumber),
            noNumber,
            noNumber,
            noNumber,
            verdict.isEmpty() ? noNumber : verdict};
    }
    if (!result.correction) {
        return rows;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        const PlaneResult& plane = (*result.correction)[i];
        // What is planned rests on that the holes before acted as they were to.
        const auto after = result.newest()->other_effect[i] ? std::nullopt : plane.within_tolerance;
        const QString verdict =
            verdictText(words, result.holds() ? verdictWord(plane.measured_within, after)
                                              : otherWord(*result.newest()));
        const auto unbalance = [&](double value) {
            return words.cellWithUnit(value, units::gram_mm, 1);
        };
        rows << ResultRow{
            planeName(words, machine, i), unbalance(plane.unbalance),
            has_direction(plane.unbalance) ? direction(words, plane.angle) : ResultCell(noNumber),
            words.cellWithUnit(plane.grams_at_radius, units::gram, 2),
            // Of readings that may not hold nothing is known to remain.
            result.holds() ? unbalance(plane.remaining) : ResultCell(noNumber),
            verdict.isEmpty() ? noNumber : verdict};
    }
    return rows;
}

QStringList holeHead(const Words& words) {
    return {words.translate("BobWeights", "Hole"),
            words.translate("BobWeights", "Depth, %1").arg(words.unit(units::mm)),
            words.translate("BobWeights", "Angle"),
            words.translate("BobWeights", "Takes off, %1").arg(words.unit(units::gram))};
}

namespace {

/// "⌀ 16 mm", "slug ⌀ 25 mm, 33.5 g".
QString sizeName(const Words& words, bool isSlug, const Hole& hole) {
    const QString size = words.plainWithUnit(hole.diameter, units::mm, 2);
    const QString name =
        isSlug ? words.translate("BobWeights", "slug ⌀ %1").arg(size) : QStringLiteral("⌀ ") + size;
    // As it is found on the scale; old records lack it.
    return hole.slug > 0.0 ? name + QStringLiteral(", ") + words.number(hole.slug, units::gram, 1)
                           : name;
}

/// Holes that are alike are a row, with the angle of each, as many as a cell has room for.
void addDrilled(ResultRows& rows, const Words& words, const QString& run, const QString& plane,
                const std::vector<Hole>& holes, bool isSlug) {
    const double sign = isSlug ? -1.0 : 1.0;
    for (auto first = holes.begin(); first != holes.end();) {
        constexpr std::ptrdiff_t most = 4;
        const auto end = first + std::min(most, holes.end() - first);
        const auto last = std::find_if(first, end, [&](const Hole& hole) {
            return hole.diameter != first->diameter || hole.depth != first->depth ||
                   hole.slug != first->slug;
        });
        QStringList angles;
        double mass = 0.0;
        for (auto hole = first; hole != last; ++hole) {
            angles << degreesOf(words, hole->angle);
            mass += sign * hole->mass;
        }
        rows << ResultRow{run, plane + QStringLiteral(": ") + sizeName(words, isSlug, *first),
                          words.cell(first->depth, units::mm, 1),
                          angles.size() == 1 ? direction(words, first->angle)
                                             : ResultCell(angles.join(QStringLiteral("; "))),
                          words.cell(mass, units::gram, 2)};
        first = last;
    }
}

}  // namespace

ResultRows holes(const Words& words, const workshop::Input& input, const Result& result,
                 std::size_t plane) {
    ResultRows rows;
    const auto speed = service_speed(input);
    // Nothing is drilled by readings that may not hold.
    if (!result.correction || !result.holds()) {
        return rows;
    }
    const auto add = [&](const Hole& hole, bool isSlug) {
        const bool isDeeper = hole.deepens && hole.from_depth > 0.0;
        QString name = sizeName(words, isSlug, hole);
        if (isSlug) {
            name += QStringLiteral(", ") +
                    inSentence(words.text(direction_words[hole.is_axial ? 0 : 1].label));
        }
        if (isSlug && speed) {
            name += QStringLiteral(", ") + words.number(hole.slug_force(*speed), units::newton, 0);
        }
        rows << ResultRow{name,
                          isDeeper
                              ? ResultCell(words.translate("BobWeights", "%1 → %2")
                                               .arg(words.digits(hole.from_depth, units::mm, 1),
                                                    words.digits(hole.depth, units::mm, 1)))
                              : words.cell(hole.depth, units::mm, 1),
                          direction(words, hole.angle),
                          words.cell(isSlug ? -hole.mass : hole.mass, units::gram, 2)};
    };
    const PlaneResult& found = result.correction->at(plane);
    for (const Hole& hole : found.holes) {
        add(hole, false);
    }
    for (const Hole& slug : found.slugs) {
        add(slug, true);
    }
    return rows;
}

ResultRows holes(const Words& words, const workshop::Input& input, const Result& result) {
    ResultRows rows;
    for (std::size_t plane = 0; plane < 2; ++plane) {
        for (ResultRow& row : holes(words, input, result, plane)) {
            row.first().text.prepend(planeName(words, input.machine, plane) + QStringLiteral(": "));
            rows << row;
        }
    }
    return rows;
}

QStringList drilledHead(const Words& words) {
    QStringList head = QStringList(words.translate("BobWeights", "Run")) + holeHead(words);
    head.last() =
        words.translate("BobWeights", "Taken off in total, %1").arg(words.unit(units::gram));
    return head;
}

ResultRows drilled(const Words& words, const workshop::Machine& machine, const Result& result,
                   std::optional<std::size_t> plane) {
    ResultRows rows;
    const std::size_t first = firstRun(result);
    const auto nameOf = [&](std::size_t run) {
        return run < first ? words.translate("BobWeights", "Older holes")
                           : runName(words, run - first);
    };
    for (std::size_t run = 0; run < result.runs.size(); ++run) {
        for (std::size_t i = 0; i < 2; ++i) {
            if (!plane || *plane == i) {
                const Metal& metal = result.runs[run].drilled[i];
                addDrilled(rows, words, nameOf(run), planeName(words, machine, i), metal.holes,
                           false);
                addDrilled(rows, words, nameOf(run), planeName(words, machine, i), metal.slugs,
                           true);
            }
        }
    }
    return rows;
}

QString drilledName(const Words& words, const workshop::Input& input, std::size_t run,
                    const DrilledHole& hole) {
    const std::size_t first = firstRun(input);
    const QString when =
        run < first ? words.translate("BobWeights", "Older holes") : runName(words, run - first);
    const QString plane =
        inSentence(planeName(words, input.machine, static_cast<std::size_t>(hole.plane)));
    return (hole.is_slug() ? words.translate("BobWeights", "%1, %2: slug ⌀ %3")
                           : words.translate("BobWeights", "%1, %2: ⌀ %3"))
        .arg(when, plane, words.plainWithUnit(hole.diameter, units::mm, 2));
}

QString machineText(const Words& words, const workshop::Machine& machine) {
    const bool isLight = machine.shows == workshop::Machine::Shows::light;
    QStringList said{
        machine.counts == workshop::Machine::Counts::clockwise
            ? words.translate("BobWeights", "Angles are clockwise, seen from the front.")
            : words.translate("BobWeights", "Angles are counter-clockwise, seen from the front.")};
    if (!machine.zero.empty()) {
        said << words.translate("BobWeights", "0°: %1.")
                    .arg(QString::fromStdString(machine.zero).simplified());
    }
    if (isLight) {
        said << words.translate("BobWeights",
                                "The machine shows the light spot; holes are opposite.");
    }
    return said.join(QLatin1Char(' '));
}

}  // namespace ravnoves::bob_text
