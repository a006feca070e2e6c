// What page, card and journal say of the crankshaft: what is missing, sentences and tables. Each
// text is made once, in the language of its Words.

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "bob-weights/fields.h"
#include "bob-weights/matching.h"
#include "case-file/field_index.h"
#include "case-file/input_error.h"
#include "shop/balance_grade.h"
#include "shop/model/verdict.h"
#include "shop/results.h"
#include "text/capital.h"
#include "text/message_text.h"
#include "text/shown_units.h"
#include "text/typed_number.h"
#include "workshop/fields.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plugs/model/v8_text.h"

namespace ravnoves {

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

QString planeTitle(const Words& words, const workshop::Input& input, std::size_t plane) {
    return words.message(shop::plane_title(input.machine.planes, plane));
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

QString WorkshopModel::engineName(const Words& words, const bob_weights::Engine& engine) {
    switch (engine.type) {
        case EngineType::v: {
            const auto degrees = [&](double angle) {
                return words.plain(angle / degree, 1) + QStringLiteral("°");
            };
            const QString name = engine.bank_angle ? words.translate("BobWeights", "V-%1, %2")
                                                         .arg(engine.cylinders)
                                                         .arg(degrees(*engine.bank_angle))
                                                   : QStringLiteral("V-%1").arg(engine.cylinders);
            return engine.pin_split != 0.0
                       ? words.translate("BobWeights", "%1, crankpins split by %2")
                             .arg(name, degrees(engine.pin_split))
                       : name;
        }
        case EngineType::in_line:
            return words.translate("BobWeights", "%1 in line").arg(engine.cylinders);
        case EngineType::boxer:
            return words.translate("BobWeights", "Boxer, %1").arg(engine.cylinders);
    }
    return {};
}

QString WorkshopModel::planeName(std::size_t plane, const Words& words) const {
    return planeTitle(words, input(), plane);
}

QString WorkshopModel::spotName(const Words& words) const {
    return words.text(workshop::shows_words[static_cast<std::size_t>(input().machine.shows)].label);
}

QString WorkshopModel::runName(const Words& words, std::size_t run) {
    return run == 0 ? words.translate("BobWeights", "Before")
                    : words.translate("BobWeights", "Run %1").arg(run);
}

namespace {

/// Where the form has the values of a group; %1 is the plane.
constexpr std::pair<const char*, const char*> groups[] = {
    {"/correction/planes/0/", QT_TRANSLATE_NOOP("BobWeights", "Sheet 5, %1")},
    {"/tolerance/", QT_TRANSLATE_NOOP("BobWeights", "Sheet 5, permissible residual")},
    {"/correction/slug/", QT_TRANSLATE_NOOP("BobWeights", "Sheet 6, heavy metal")},
    {"/correction/drill/", QT_TRANSLATE_NOOP("BobWeights", "Sheet 6, drills")}};

/// Where a value is: as if of the first elements of the lists around it, and of which it is.
std::pair<std::string, std::vector<std::size_t>> placeOf(const InputError& error) {
    std::pair<std::string, std::vector<std::size_t>> place;
    const QString where = QString::fromStdString(error.where());
    for (const QString& key : where.split(QLatin1Char('/')).sliced(2)) {  // below "input"
        bool isElement = false;
        const auto element = key.toULongLong(&isElement);
        place.first += '/' + (isElement ? "0" : key.toStdString());
        if (isElement) {
            place.second.push_back(element);
        }
    }
    return place;
}

/// "Sheet 5, Run 1, Front plane: enter the angle."
QString valueMissing(const Words& words, const workshop::Input& input, std::size_t run,
                     std::size_t plane, const Field& field) {
    return (field.key == field::angle.key
                ? words.translate("BobWeights", "Sheet 5, %1, %2: enter the angle.")
                : words.translate("BobWeights", "Sheet 5, %1, %2: enter the unbalance."))
        .arg(WorkshopModel::runName(words, run - first_run(input.correction)),
             planeTitle(words, input, plane));
}

/// What an error says, with its place on the form.
QString ruleText(const Words& words, const workshop::Input& input, const InputError& error) {
    const auto [pointer, elements] = placeOf(error);
    if (pointer == "/correction/planes") {
        return words.translate("BobWeights", "Sheet 5: enter position and radius of both planes.");
    }
    const auto described = describe_fields<workshop::Input>(pointer);
    const Field field = described.empty() ? Field() : described.front().field;
    QString name = words.name(field);
    const bool isMissing = error.found().empty();
    if (isMissing && pointer.find("/readings/0/") != std::string::npos) {
        const std::size_t run =
            elements.size() > 1 ? elements.front() : input.correction->earlier_runs.size();
        return valueMissing(words, input, run, elements.back(), field);
    }
    const auto group = std::ranges::find_if(
        groups, [&at = pointer](const auto& each) { return at.starts_with(each.first); });
    if (isMissing && group != std::end(groups)) {
        QString sheet = words.translate("BobWeights", group->second);
        for (const std::size_t plane : elements) {
            sheet = sheet.arg(planeTitle(words, input, plane));
        }
        return field.key == field::diameters.key
                   ? words
                         .translate("BobWeights", "%1: enter %2 in %3, separated by semicolons: %4")
                         .arg(sheet, name, words.unit(units::mm),
                              numberListText({8, 10, 12.5}, field))
                   : words.translate("BobWeights", "%1: enter %2. %3")
                         .arg(sheet, name, words.text(field.hint));
    }
    if (group == std::begin(groups)) {  // the form has a column for each plane, no rows
        name = planeTitle(words, input, elements.front()) + QStringLiteral(", ") + inSentence(name);
    }
    const QString rule =
        words.message(isMissing ? error.allowed_message()
                                : Message(Text::tr("%1, got %2"), error.allowed_message(),
                                          error.found_message()));
    return name.isEmpty() ? rule : name + QStringLiteral(": ") + rule;
}

/// The angles that a correction still needs, each with its place; nothing where none is begun, or
/// the readings pass as they are.
QStringList missingAngles(const Words& words, const workshop::Input& input,
                          const bob_weights::Result& result) {
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

/// The rule that the input breaks first, with its place on the form; empty where it breaks none.
/// @param check  throws of the first
template <typename Checked>
QString brokenRule(const Words& words, const workshop::Input& input,
                   void (*check)(const Checked& input)) {
    try {
        check(input);
    } catch (const InputError& error) {
        // Of a column that is half weighed it is said how far it is.
        const bool isHalfWeighed = error.where().starts_with("/input/weigh_in/") &&
                                   (error.found().empty() || error.found() == "null");
        return isHalfWeighed ? QString() : ruleText(words, input, error);
    }
    return {};
}

/// What counts as 0 because it was not given; empty where everything was.
QString notGiven(const Words& words, const bob_weights::Result& result) {
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

/// Runs whose holes were planned before their readings were put right.
QStringList correctedRuns(const Words& words, const workshop::Input& input,
                          const bob_weights::Result& result) {
    QStringList list;
    // Without planes or readings nothing was planned.
    const std::size_t runs =
        input.correction ? std::min(input.correction->earlier_runs.size(), result.runs.size()) : 0;
    for (std::size_t run = 0; run < runs; ++run) {
        // The next run has shown what those of before the last did.
        if (!input.correction->earlier_runs[run].drilled_by.empty() &&
            result.runs[run].is_drilled() && run + 2 == result.runs.size() &&
            result.newest()->passes() != true) {
            list << words
                        .translate("BobWeights",
                                   "%1: the drilled holes were planned from another reading.")
                        .arg(WorkshopModel::runName(words, run - first_run(input.correction)));
        }
    }
    return list;
}

/// What falls short, plane by plane.
QStringList shortfalls(const Words& words, const workshop::Input& input,
                       const bob_weights::Result& result) {
    QStringList list;
    // Nothing is said of a correction by readings that may not hold.
    if (result.correction && result.holds()) {
        for (std::size_t i = 0; i < 2; ++i) {
            const PlaneResult& plane = (*result.correction)[i];
            if (!plane.reason.empty()) {
                list << planeTitle(words, input, i) + QStringLiteral(": ") +
                            words.message(plane.reason);
            }
        }
    }
    return list;
}

/// Nothing is drilled by readings that may not hold.
bool hasHoles(const bob_weights::Result& result) {
    return result.is_planned() && result.holds();
}

bool hasSlugs(const std::array<PlaneResult, 2>& planes) {
    return std::ranges::any_of(planes,
                               [](const PlaneResult& plane) { return !plane.slugs.empty(); });
}

QString slugNote(const Words& words, const std::array<PlaneResult, 2>& planes) {
    return hasSlugs(planes)
               ? QLatin1Char(' ') +
                     words.translate("BobWeights",
                                     "A slug is as long as its hole; its mass is given with "
                                     "its diameter. Secure it: a press fit alone does not "
                                     "withstand the force at service speed.")
               : QString();
}

}  // namespace

// ----------------------------------------------------------------------------- the bob weight

QString WorkshopModel::headline(const Words& words) const {
    if (withheld().bob_weight) {
        return words.translate("BobWeights", "STOP: no bob weight yet");
    }
    if (!hasPlugs() && balances_itself(input().engine)) {
        return words.translate("BobWeights", "No bob weights are needed");
    }
    if (const auto& weight = solution().bob_weight) {
        const bool isNearest = plugs() != nullptr && plugs()->advice && !v8_text::works(*plugs());
        const QString said =
            (isNearest  ? words.translate("BobWeights", "Bob weight with the nearest option: %1")
             : isMean() ? words.translate("BobWeights", "Mean bob weight %1")
                        : words.translate("BobWeights", "Bob weight %1"))
                .arg(words.number(*weight, units::gram, 1));
        return isProvisional() ? provisional(words, said) : said;
    }
    QStringList missing;
    if (hasPlugs()) {
        missing = missingForPlugs(words, true);
    } else {
        for (const Field* field : missing_for_bob_weight(input())) {
            missing << inSentence(words.name(*field));
        }
        if (QString why = brokenRule(words, input(), check_bob_weight);
            missing.isEmpty() && !why.isEmpty()) {
            return why;
        }
    }
    return words.translate("BobWeights", "Missing for the bob weight: %1")
        .arg(missing.join(QStringLiteral(", ")));
}

QString WorkshopModel::provisional(const Words& words, const QString& answer) {
    return words.translate("BobWeights", "Provisional: %1").arg(inSentence(answer));
}

QString WorkshopModel::hangText(const Words& words) const {
    const bool isNeeded = !balances_itself(input().engine);
    if (!solution().bob_weight) {
        return isNeeded || withheld().bob_weight
                   ? QString()
                   : words.translate("BobWeights", "The crankpins balance one another.");
    }
    QStringList said;
    if (!isNeeded) {
        said << words
                    .translate("BobWeights",
                               "The crankpins balance one another. If you use bob weights: %1.")
                    .arg(words.number(*solution().bob_weight, units::gram, 1));
    }
    const int crankpins = input().engine.crankpins();
    said << (crankpins == 1
                 ? words.translate("BobWeights", "On the crankpin.")
                 : words.translate("BobWeights", "On each of the %1 crankpins.").arg(crankpins));
    if (isMean()) {
        said << weighInText(words);
    }
    if (plugs() != nullptr) {
        said << plugsWhileHung(words);
    }
    said.removeAll(QString());
    return said.join(QLatin1Char(' '));
}

QString WorkshopModel::factorText(const Words& words) const {
    const Factor& typed = input().factor;
    const bob_weights::Result& result = solution();
    const auto percent = [&](double share) {
        return words.plain(100.0 * share, 2) + QStringLiteral("\u00A0%");
    };
    QString text = typed.reciprocating
                       ? words.translate("BobWeights", "Balance factor %1 (theory: %2)")
                             .arg(percent(result.factor), percent(result.theory_factor))
                       : words.translate("BobWeights", "Balance factor %1, by theory")
                             .arg(percent(result.factor));
    if (typed.overbalance != 0.0) {
        text += words
                    .translate("BobWeights", " + %1 overbalance",
                               "after the factor; negative numbers have their sign")
                    .arg(percent(typed.overbalance));
    }
    return text + QStringLiteral(". ") +
           words.message(factor_effect(input().engine, result.factor + typed.overbalance));
}

QString WorkshopModel::limitText(const Words& words) const {
    const bob_weights::Result& result = solution();
    // The mass that a limit is by may be what is doubted.
    if (!result.permissible || !input().tolerance || withheld().limits) {
        return {};
    }
    std::array<QString, 2> limits;
    for (std::size_t i = 0; i < 2; ++i) {
        const double limit = (*result.permissible)[i];
        limits[i] = unbalanceOf(words, limit);
        const auto& correction = input().correction;
        if (correction && i < correction->planes.size() && correction->planes[i].radius) {
            // A slip in the mass is seen in what the shop weighs.
            const double radius = *correction->planes[i].radius;
            limits[i] = words.translate("BobWeights", "%1 (%2 at R %3)")
                            .arg(limits[i], words.number(limit / radius, units::gram, 2),
                                 words.plainWithUnit(radius, units::mm, 1));
        }
    }
    const QString planes =
        limits[0] == limits[1]
            ? words.translate("BobWeights", "%1 in each plane").arg(limits[0])
            : QStringLiteral("%1: %2; %3: %4")
                  .arg(planeName(0, words), limits[0], planeName(1, words), limits[1]);
    const QString said =
        result.permissible_whole
            ? words.translate("BobWeights", "Permissible residual: %1, of %2 for the crankshaft.")
                  .arg(planes, unbalanceOf(words, *result.permissible_whole))
            : words.translate("BobWeights", "Permissible residual: %1.").arg(planes);
    return said + QLatin1Char(' ') + limitOrigin(words, *input().tolerance);
}

namespace {

/// The products of the lines in tenths of a gram, so that they add up to the sum printed.
std::vector<long> tenthsOf(const bob_weights::Result& result) {
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
        double maximum = -1.0;
        for (std::size_t i = 0; i < tenths.size(); ++i) {
            const double short_by = static_cast<double>(step) * (result.lines[i].product() / tenth -
                                                                 static_cast<double>(tenths[i]));
            if (short_by > maximum) {
                maximum = short_by;
                nearest = i;
            }
        }
        tenths[nearest] += step;
        left -= step;
    }
    return tenths;
}

}  // namespace

Results WorkshopModel::lineResults(const Words& words) const {
    const bob_weights::Result& result = solution();
    const QString gram = words.unit(units::gram);
    Results results{
        {words.translate("BobWeights", "Part"),
         words.translate("BobWeights", "Each, %1").arg(gram),
         {words.translate("BobWeights", "Multiplier"),
          tr("Multiplier of the mass in the bob weight: number of rods, times the balance factor "
             "for reciprocating parts")},
         {words.translate("BobWeights", "Total, %1").arg(gram), tr("Mass × multiplier")}}};
    ResultRows& rows = results.rows;
    const std::vector<long> tenths =
        result.bob_weight ? tenthsOf(result) : std::vector<long>(result.lines.size());
    const auto printed = [&](long value) {
        return words.cell(0.1 * units::gram * static_cast<double>(value), units::gram, 1);
    };
    std::array<long, 2> subtotals{};
    for (std::size_t i = 0; i < result.lines.size(); ++i) {
        const Line& line = result.lines[i];
        rows << ResultRow(
            {words.text(line.name.label).remove(QLatin1Char('&')),
             // With all digits of a mean, so that it times its multiplier is the total.
             ResultCell(shownValue(line.mass, units::gram), words.plain(line.mass, units::gram, 3)),
             QStringLiteral("× ") + words.plain(line.factor, 4),
             result.bob_weight ? printed(tenths[i]) : words.cell(line.product(), units::gram, 1)},
            line.part != nullptr ? words.text(line.part->field.hint) : QString());
        subtotals[line.reciprocates ? 0 : 1] += tenths[i];
    }
    if (!result.bob_weight) {
        return results;
    }
    if (!result.lines.empty()) {
        rows << ResultRow{words.translate("BobWeights", "Reciprocating"), QString(), QString(),
                          printed(subtotals[0])}
             << ResultRow{words.translate("BobWeights", "Rotating"), QString(), QString(),
                          printed(subtotals[1])};
    }
    rows << ResultRow({words.translate("BobWeights", "Sum"), QString(), QString(),
                       words.cell(*result.bob_weight, units::gram, 1)},
                      tr("Mass of the bob weight"));
    return results;
}

// ------------------------------------------------------------------ what is wrong or doubtful

QString WorkshopModel::doubtfulText() const {
    const auto& weight = solved().found.shaft.bob_weight;
    return withheld().bob_weight && weight
               ? tr("Do not use: bob weight %1.").arg(Words().number(*weight, units::gram, 1))
               : QString();
}

QString WorkshopModel::rejectedText() const {
    const Words words;
    return rejected_.isEmpty()
               ? QString()
               : (isOutdated()
                      ? words.translate("JobCard", "Result outdated: entries not accepted: %1")
                      : words.translate("JobCard", "Entries not accepted: %1"))
                     .arg(rejected_.join(QLatin1Char(' ')));
}

QStringList WorkshopModel::notCounted(const Words& words) const {
    QStringList list;
    // What weighed masses replace is grey on its sheet.
    for (const Message& message :
         hasPlugs() ? v8_plugs::not_counted(*plugsInput()) : bob_weights::not_counted(input())) {
        list << words.message(message);
    }
    return list;
}

QStringList WorkshopModel::troubles(const Words& words, bool withDoubts) const {
    const bob_weights::Result& result = solution();
    // Where there is no bob weight that is said by itself.
    QStringList list{result.bob_weight ? brokenRule(words, input(), workshop::check_input)
                                       : QString()};
    // The first of those that block is in the verdict.
    bool isSaid = withDoubts;
    for (const workshop::Doubt& doubt : doubts()) {
        if (doubt.rule->blocks.any() ? std::exchange(isSaid, true) : !withheld().any()) {
            list << words.message(doubt.text);
        }
    }
    list << notCounted(words) << notGiven(words, result) << missingAngles(words, input(), result)
         << shortfalls(words, input(), result) << correctedRuns(words, input(), result)
         << plugTroubles(words);
    list.removeAll(QString());
    list.removeDuplicates();
    return list;
}

QString WorkshopModel::otherRunText() const {
    const Words words;
    const bob_weights::Result& result = solution();
    for (std::size_t run = result.runs.size(); run-- > 0;) {
        const RunResult& read = result.runs[run];
        if (!read.holds()) {
            const QString said = words.message(
                shop::other_readings(read.read_with, read.read_on, result.bob_weight));
            return &read == result.newest()
                       ? said
                       : runName(words, run - firstRun()) + QStringLiteral(": ") + said;
        }
    }
    return {};
}

// ----------------------------------------------------------------------------------- the parts

WeighedColumn WorkshopModel::columnNote(shop::Part part) const {
    const auto& sheet = solved().sheet;
    const auto statistics = sheet ? shop::statistics((*sheet)[part]) : std::nullopt;
    WeighedColumn column;
    if (!statistics) {
        return column;
    }
    const Words words;
    const shop::PartColumn& weighed = (*sheet)[part];
    const auto grams = [&](double mass) { return words.digits(mass, units::gram, 2); };
    column.texts[0] = grams(statistics->mean);
    if (weighed.nominal) {
        const double deviation = statistics->mean - *weighed.nominal;
        column.texts[1] =
            (deviation >= 0.005 * units::gram ? QStringLiteral("+") : QString()) + grams(deviation);
    }
    column.texts[2] = grams(statistics->spread);
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

QStringList WorkshopModel::cylindersOfCrankpins() const {
    if (input().engine.cylinders % input().engine.rods_per_pin != 0) {
        return {};
    }
    QStringList pins;
    const auto places = places_of(crank_of(input()));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto pin = static_cast<qsizetype>(places[i].crankpin);
        pins.resize(std::max(pins.size(), pin + 1));
        pins[pin] +=
            (pins[pin].isEmpty() ? QString() : QStringLiteral("+")) + QString::number(i + 1);
    }
    return pins;
}

bool WorkshopModel::isMean() const {
    const bob_weights::Result& result = solution();
    const auto shown = [](double mass) { return Words().digits(mass, units::gram, 1); };
    return result.bob_weight &&
           std::any_of(result.crankpins.begin(), result.crankpins.end(),
                       [&](double own) { return shown(own) != shown(*result.bob_weight); });
}

QString WorkshopModel::weighInText(const Words& words) const {
    const bob_weights::Result& result = solution();
    if (result.crankpins.empty()) {
        return {};
    }
    const QStringList cylinders = cylindersOfCrankpins();
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

QString WorkshopModel::placedText(const Words& words) const {
    const bob_weights::Result& result = solution();
    if (!result.placing || result.placing->moved == 0 || result.placed_crankpins.empty()) {
        return {};
    }
    QStringList pins;
    for (const double mass : result.placed_crankpins) {
        pins << words.digits(mass, units::gram, 1);
    }
    return words.translate("BobWeights", "After moving the sets as suggested: %1.")
        .arg(pins.join(QStringLiteral("; ")));
}

bool WorkshopModel::canMoveBack() const {
    // By the numbers of a sheet of another number of cylinders they cannot.
    return solved().sheet && solved().sheet->is_moved();
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

// ----------------------------------------------------------------------------- the correction

QString WorkshopModel::machineText(const Words& words) const {
    const workshop::Machine& machine = input().machine;
    QStringList said{
        machine.counts == workshop::Machine::Counts::clockwise
            ? words.translate("BobWeights", "Angles are clockwise, seen from the front.")
            : words.translate("BobWeights", "Angles are counter-clockwise, seen from the front.")};
    if (!machine.zero.empty()) {
        said << words.translate("BobWeights", "0°: %1.")
                    .arg(QString::fromStdString(machine.zero).simplified());
    }
    said << words.translate("BobWeights", "Drill radially from the rim, towards the axis.");
    const bool showsLight = machine.shows == workshop::Machine::Shows::light;
    const bool takesSlugs = solution().correction && hasSlugs(*solution().correction);
    said << (takesSlugs && showsLight
                 ? words.translate("BobWeights",
                                   "Work at the listed angles: holes are opposite the light spot "
                                   "that the machine shows, slugs are at it.")
             : takesSlugs ? words.translate("BobWeights",
                                            "Work at the listed angles: holes are at the heavy "
                                            "spot that the machine shows, slugs are opposite it.")
             : showsLight ? words.translate("BobWeights",
                                            "Hole angles are where to drill: opposite the light "
                                            "spot that the machine shows.")
                          : words.translate("BobWeights",
                                            "Hole angles are where to drill: at the heavy spot "
                                            "that the machine shows."));
    return said.join(QLatin1Char(' '));
}

QString WorkshopModel::correctionText() const {
    const QString verdict = verdictText(Words(), verdictNow());
    return withheld().any()     ? tr("STOP: do not drill yet")
           : !verdict.isEmpty() ? verdict
           : isRunRead()        ? tr("Enter the permissible residual.")
                                : readingsMissing();
}

QString WorkshopModel::asReadNote() const {
    const Words words;
    if (!solution().correction || !input().correction) {
        return {};
    }
    QStringList read;
    bool isMoved = false;
    for (std::size_t i = 0; i < 2; ++i) {
        const Reading& reading = input().correction->readings.at(i);
        const double plane = input().correction->planes.at(i).position.value_or(0.0);
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

QString WorkshopModel::holeNote(const Words& words) const {
    if (withheld().holes && input().correction) {
        return tr("STOP: correct the top line before drilling.");
    }
    return !hasHoles(solution())
               ? QString()
               : words.translate("BobWeights",
                                 "Depths exclude the drill point; the rim is taken as flat.") +
                     slugNote(words, *solution().correction);
}

QString WorkshopModel::metalsText(const Words& words) const {
    if (!input().correction || !hasHoles(solution())) {
        return {};
    }
    const Drill& drill = input().correction->drill;
    const auto density = [&](double value) { return words.plainWithUnit(value, units::kg_m3, 1); };
    QString said =
        words
            .translate("BobWeights",
                       "Planned with a point angle of %1 and a crankshaft density of %2")
            .arg(words.plainWithUnit(drill.point_angle, units::degree, 1), density(drill.density));
    const auto& slug = input().correction->slug;
    if (!slugNote(words, *solution().correction).isEmpty() && slug && slug->density) {
        said += words.translate("BobWeights", ", slugs of %1").arg(density(*slug->density));
    }
    return said + QLatin1Char('.');
}

Results WorkshopModel::runResults() const {
    const Words words;
    const QString unit = QStringLiteral(", ") + words.unit(units::gram_mm);
    Results results{
        {words.translate("BobWeights", "Run"),
         {planeName(0) + unit,
          tr("Readings of the run, transferred to this plane, as the machine shows them")},
         {planeName(1) + unit,
          tr("Readings of the run, transferred to this plane, as the machine shows them")},
         {words.translate("BobWeights", "Verdict"), tr("By the limits of both planes")}}};
    const auto& runs = solution().runs;
    for (std::size_t run = firstRun(); newestRun() > 0 && run < runs.size(); ++run) {
        const auto cell = [&](std::size_t i) {
            const auto& read = runs[run].planes[i];
            if (!read) {
                return noNumber;
            }
            const QString unbalance = words.digits(read->unbalance, units::gram_mm, 1);
            // Without the angle of the other plane it is as the machine read it.
            const auto angle = read->angle ? std::optional(input().machine.shown(*read->angle))
                                           : reading(run - firstRun(), i).angle;
            return angle ? atAngle(words, unbalance, read->unbalance, *angle) : unbalance;
        };
        const QString verdict = verdictText(words, readWord(runs[run], runs[run].passes()));
        results.rows << ResultRow{runName(words, run - firstRun()), cell(0), cell(1),
                                  verdict.isEmpty() ? noNumber : verdict};
    }
    return results;
}

Results WorkshopModel::planeResults(const Words& words) const {
    Results results{
        {words.translate("BobWeights", "Plane"), planeName(0, words), planeName(1, words)}};
    const RunResult* newest = solution().newest();
    if (newest == nullptr) {
        return results;
    }
    const auto add = [&](const QString& name, const QString& tip, const auto& cellOf) {
        const ResultRow row({name, cellOf(0U), cellOf(1U)}, tip);
        if (row[1].text != noNumber || row[2].text != noNumber) {
            results.rows << row;
        }
    };
    const auto unbalance = [&](const std::optional<double>& value) {
        return value ? words.cellWithUnit(*value, units::gram_mm, 1) : ResultCell(noNumber);
    };
    const auto& planned = solution().correction;
    add(words.translate("BobWeights", "Measured"),
        tr("Both readings, transferred to the correction planes (same force, same moment)"),
        [&](std::size_t i) {
            return unbalance(planned ? (*planned)[i].unbalance : newest->unbalances()[i]);
        });
    if (planned) {
        add(words.translate("BobWeights", "Heavy spot"),
            tr("Angle of the heavy spot from the machine's zero mark"), [&](std::size_t i) {
                const PlaneResult& plane = (*planned)[i];
                return has_direction(plane.unbalance) ? direction(words, plane.angle)
                                                      : ResultCell(noNumber);
            });
        add(words.translate("BobWeights", "Mass at drilling radius"),
            tr("Mass at the drilling radius for this unbalance"), [&](std::size_t i) {
                return words.cellWithUnit(
                    (*planned)[i].unbalance / *input().correction->planes[i].radius, units::gram,
                    2);
            });
    }
    if (hasHoles(solution())) {
        add(words.translate("BobWeights", "After correction"),
            tr("Residual after the holes below, with rounded depths"),
            [&](std::size_t i) { return unbalance((*planned)[i].remaining); });
    }
    add(words.translate("BobWeights", "Verdict"),
        tr("By the limit of the plane: as measured → after the correction"), [&](std::size_t i) {
            // What is planned rests on that the holes before acted as they were to.
            const QString verdict = verdictText(
                words, planned ? readWord(*newest, newest->within(i),
                                          newest->contradicts(i) ? std::nullopt
                                                                 : (*planned)[i].within_tolerance,
                                          (*planned)[i].is_planned())
                               : readWord(*newest, newest->within(i)));
            return ResultCell(verdict.isEmpty() ? noNumber : verdict);
        });
    return results;
}

namespace {

/// "⌀ 16 mm", "slug ⌀ 25 mm, 33.5 g".
QString sizeName(const Words& words, bool isSlug, const Hole& hole) {
    const QString size = words.plainWithUnit(hole.diameter, units::mm, 2);
    const QString name =
        isSlug ? words.translate("BobWeights", "slug ⌀ %1").arg(size) : QStringLiteral("⌀ ") + size;
    QStringList said{name};
    if (hole.slug > 0.0) {  // as it is found on the scale; old records lack it
        said << words.number(hole.slug, units::gram, 1);
    }
    if (hole.is_axial) {  // its hole is below the rim, where no other is
        said << words.translate("BobWeights", "hole centre at R %1")
                    .arg(words.plainWithUnit(hole.slug_radius, units::mm, 1));
    }
    return said.join(QStringLiteral(", "));
}

/// What is taken off, or with a slug added.
ResultCell massCell(const Words& words, double mass, bool isSlug) {
    return isSlug ? ResultCell(-mass / units::gram, words.translate("BobWeights", "adds %1")
                                                        .arg(words.digits(mass, units::gram, 2)))
                  : words.cell(mass, units::gram, 2);
}

ResultCell depthCell(const Words& words, const Hole& hole) {
    return hole.from_depth > 0.0 ? ResultCell(words.translate("BobWeights", "%1 → %2")
                                                  .arg(words.digits(hole.from_depth, units::mm, 1),
                                                       words.digits(hole.depth, units::mm, 1)))
                                 : words.cell(hole.depth, units::mm, 1);
}

/// Holes that are alike are a row, with the angle of each, as many as a cell has room for.
void addDrilled(ResultRows& rows, const Words& words, const QString& run, const QString& plane,
                const std::vector<Hole>& holes, bool isSlug) {
    for (auto first = holes.begin(); first != holes.end();) {
        constexpr std::ptrdiff_t maximum = 4;
        const auto end = first + std::min(maximum, holes.end() - first);
        const auto last = std::find_if(first, end, [&](const Hole& hole) {
            return hole.diameter != first->diameter || hole.depth != first->depth ||
                   hole.from_depth != first->from_depth || hole.slug != first->slug;
        });
        QStringList angles;
        constexpr double printed = 0.01 * units::gram;  // so that the lines add up to it
        double mass = 0.0;
        for (auto hole = first; hole != last; ++hole) {
            angles << degreesOf(words, hole->angle);
            mass += std::round(hole->mass / printed) * printed;
        }
        rows << ResultRow{run, plane + QStringLiteral(": ") + sizeName(words, isSlug, *first),
                          depthCell(words, *first),
                          angles.size() == 1 ? direction(words, first->angle)
                                             : ResultCell(angles.join(QStringLiteral("; "))),
                          massCell(words, mass, isSlug)};
        first = last;
    }
}

}  // namespace

Results WorkshopModel::holeResults(const Words& words, std::optional<std::size_t> plane) const {
    Results results{
        {words.translate("BobWeights", "Hole"),
         {words.translate("BobWeights", "Depth, %1").arg(words.unit(units::mm)),
          shownText(field::drilled_depth.hint)},
         {words.translate("BobWeights", "Angle"), tr("From the machine's zero mark")},
         {words.translate("BobWeights", "Takes off, %1").arg(words.unit(units::gram)),
          tr("Mass taken off, including the drill point; a slug adds its own mass minus its "
             "hole")}}};
    // Nothing is drilled by readings that may not hold.
    if (!solution().correction || !solution().holds()) {
        return results;
    }
    const auto speed = service_speed(input());
    QString before;
    const auto add = [&](const Hole& hole, bool isSlug) {
        results.rows << ResultRow{before + sizeName(words, isSlug, hole), depthCell(words, hole),
                                  direction(words, hole.angle), massCell(words, hole.mass, isSlug)};
        if (isSlug) {  // more than a line has room for
            QStringList how{words.text(direction_words[hole.is_axial ? 0 : 1].label)};
            if (speed) {
                how << words.translate("BobWeights", "centrifugal force %1 at %2")
                           .arg(words.number(hole.slug_force(*speed), units::newton, 0),
                                words.plainWithUnit(*speed, units::rpm, 0));
            }
            results.rows << ResultRow{inSentence(how.join(QStringLiteral(", "))), QString(),
                                      QString(), QString()};
        }
    };
    for (std::size_t i = 0; i < 2; ++i) {
        if (plane.value_or(i) != i) {
            continue;
        }
        before = plane ? QString() : planeName(i, words) + QStringLiteral(": ");
        for (const Hole& hole : (*solution().correction)[i].holes) {
            add(hole, false);
        }
        for (const Hole& slug : (*solution().correction)[i].slugs) {
            add(slug, true);
        }
    }
    return results;
}

QString WorkshopModel::drilledName(const Words& words, std::size_t run) const {
    return run < firstRun() ? words.translate("BobWeights", "Older holes")
           : run == firstRun()
               ? words.translate("BobWeights", "After “Before”")
               : words.translate("BobWeights", "After Run %1").arg(run - firstRun());
}

Results WorkshopModel::drilledResults(const Words& words) const {
    Results results{holeResults(words).columns};
    results.columns.push_front(words.translate("BobWeights", "Run"));
    results.columns.last() =
        words.translate("BobWeights", "Taken off, %1").arg(words.unit(units::gram));
    const auto& runs = solution().runs;
    for (std::size_t run = 0; run < runs.size(); ++run) {
        for (std::size_t i = 0; i < 2; ++i) {
            const Metal& metal = runs[run].drilled[i];
            const QString name = drilledName(words, run);
            addDrilled(results.rows, words, name, planeName(i, words), metal.holes, false);
            addDrilled(results.rows, words, name, planeName(i, words), metal.slugs, true);
        }
    }
    return results;
}

QString WorkshopModel::drilledName(std::size_t run, const DrilledHole& hole) const {
    const Words words;
    const QString size = words.plainWithUnit(hole.diameter, units::mm, 2);
    return drilledName(words, run) + QStringLiteral(": ") +
           (hole.is_slug() ? words.translate("BobWeights", "slug ⌀ %1").arg(size)
                           : QStringLiteral("⌀\u00A0") + size);
}

}  // namespace ravnoves
