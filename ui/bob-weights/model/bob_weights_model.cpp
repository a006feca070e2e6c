#include "bob-weights/model/bob_weights_model.h"

#include <QDate>
#include <QRegularExpression>

#include "bob-weights/fields.h"
#include "bob-weights/model/bob_text.h"
#include "bob-weights/scene.h"
#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "model/case_model_json.h"
#include "text/error_text.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "workshop/weigh_in.h"

namespace ravnoves {

using namespace bob_weights;

namespace {

/// Those of the machine are of one shaft; where it reads stays.
void forgetReadings(Input& input) {
    if (input.correction) {
        for (Reading& reading : input.correction->readings) {
            reading.unbalance.reset();
            reading.angle.reset();
        }
    }
}

}  // namespace

Input BobWeightsScene::defaultInput() const {
    Input input;
    input.engine.bank_angle = 90.0 * degree;
    if (dated) {
        input.job.date = QDate::currentDate().toString(Qt::ISODate).toStdString();
    }
    return input;
}

Input BobWeightsScene::read(const Json& input, const CaseContext& /*context*/) {
    return read_input(input, Completeness::as_is);
}

Json BobWeightsScene::write(const Input& input) {
    return write_input(input);
}

Result BobWeightsScene::solve(const Input& input) {
    Result result = bob_weights::solve(input);
    try {
        check_bob_weight(input);
    } catch (const InputError&) {
        result.lines.clear();
        result.bob_weight.reset();
        result.first_order.reset();
        result.crankpins.clear();
        result.correction.reset();
    }
    return result;
}

template class CaseModel<BobWeightsScene>;

BobWeightsModel::BobWeightsModel(const QString& journalPath, QObject* parent)
    : CaseModel({.dated = !journalPath.isEmpty()}, parent), desk_(this, journalPath, deskScene()) {}

Json BobWeightsModel::resultJson() const {
    try {
        return solve_scene(inputJson(), context());
    } catch (const InputError& error) {
        return {{"error", error.what()}};  // a sheet half filled has no result yet
    }
}

bool BobWeightsModel::setViewOption(const QString& key, const QString& value) {
    if (key != QLatin1String("sheet")) {
        return false;
    }
    Q_EMIT sheetChosen(oneOf(key, value, {"job", "parts", "weigh-in", "machine", "drills"}));
    return true;
}

// ------------------------------------------------------------------------------------- changes

QString BobWeightsModel::chooseType(int type) {
    return edit(fieldName(field::type), [type](Input& input) {
        Engine& engine = input.engine;
        engine.type = static_cast<EngineType>(type);
        engine.rods_per_pin = engine.type == EngineType::v && engine.cylinders % 2 == 0 ? 2 : 1;
        if (engine.type != EngineType::v) {
            engine.pin_split = 0.0;
        }
    });
}

QString BobWeightsModel::editCorrection(const QString& name,
                                        const std::function<void(Correction&)>& mutate) {
    return edit(name, [&](Input& input) {
        Correction correction = input.correction.value_or(Correction{});
        correction.planes.resize(2);
        correction.readings.resize(2);
        mutate(correction);
        input.correction =
            correction == Correction{} ? std::nullopt : std::optional(std::move(correction));
    });
}

QString BobWeightsModel::editSlug(const QString& name, const std::function<void(Slug&)>& mutate) {
    return editCorrection(name, [&](Correction& correction) {
        Slug slug = correction.slug.value_or(Slug{});
        mutate(slug);
        correction.slug = slug == Slug{} ? std::nullopt : std::optional(slug);
    });
}

QString BobWeightsModel::editTolerance(const QString& name,
                                       const std::function<void(Tolerance&)>& mutate) {
    return edit(name, [&](Input& input) {
        Tolerance tolerance = input.tolerance.value_or(Tolerance{});
        mutate(tolerance);
        input.tolerance = tolerance == Tolerance{} ? std::nullopt : std::optional(tolerance);
    });
}

QString BobWeightsModel::editWeights(const QString& name,
                                     const std::function<void(WeighIn&)>& mutate) {
    return edit(name, [&](Input& input) {
        if (!input.weigh_in) {
            input.weigh_in.emplace();
        }
        fit_weigh_in(input);
        mutate(*input.weigh_in);
        if (input.weigh_in->is_empty()) {
            input.weigh_in.reset();
        }
    });
}

BobWeightsModel::ColumnNote BobWeightsModel::columnNote(workshop::Part part) const {
    for (const Matching& each : solution().matching) {
        if (each.part->column == part) {
            const Words words;
            return {words.digits(each.statistics.mean, units::gram, 2),
                    words.digits(each.statistics.spread, units::gram, 2),
                    each.statistics.count == input().engine.cylinders};
        }
    }
    return {};
}

QString BobWeightsModel::weighInText() const {
    return bob_text::weighIn(Words(), solution());
}

std::optional<std::vector<double>> BobWeightsModel::readDrills(const QString& typed) {
    static const QRegularExpression between(QStringLiteral("\\s*;\\s*|,\\s+|\\s+"));
    std::vector<double> drills;
    for (const QString& word : typed.split(between, Qt::SkipEmptyParts)) {
        const auto value = readFormNumber(word);
        if (!value || !field::diameters.range.contains(*value)) {
            return std::nullopt;
        }
        drills.push_back(*value);
    }
    return drills;
}

QString BobWeightsModel::drillsText() const {
    QStringList list;
    if (input().correction) {
        for (const double diameter : input().correction->drill.diameters_mm) {
            list << formNumber(diameter, QLocale());
        }
    }
    return list.join(QStringLiteral("; "));
}

void BobWeightsModel::newJob() {
    Input next = scene().defaultInput();
    next.engine = input().engine;
    next.factor = input().factor;
    next.balance = input().balance;
    next.correction = input().correction;
    forgetReadings(next);
    next.tolerance = input().tolerance;
    next.job.technician = input().job.technician;
    desk_.beginJob([&] {
        setTitle({});
        // Undo must not bring another job's values under this job's number.
        restart(next);
    });
}

// --------------------------------------------------------------------------- what the page shows

QString BobWeightsModel::contradiction() const {
    if (!missing_for_bob_weight(input()).empty()) {
        return {};
    }
    try {
        check_bob_weight(input());
    } catch (const InputError& error) {
        return shownError(error);
    }
    return {};
}

QString BobWeightsModel::shownError(const InputError& error) const {
    const QStringList place =
        QString::fromStdString(error.where()).split(QLatin1Char('/'), Qt::SkipEmptyParts);
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

QString BobWeightsModel::headline() const {
    if (const QString why = contradiction(); !why.isEmpty()) {
        return why;
    }
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
    return bob_text::limits(Words(), solution());
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
    return list + bob_text::shortfalls(Words(), solution());
}

bool BobWeightsModel::isDone() const {
    return solution().correction &&
           std::all_of(solution().correction->begin(), solution().correction->end(),
                       [](const PlaneResult& plane) { return plane.reason.empty(); });
}

QStringList BobWeightsModel::lineColumns() const {
    return bob_text::lineHead(Words());
}

QVector<QStringList> BobWeightsModel::lineRows() const {
    return bob_text::lines(Words(), solution());
}

QStringList BobWeightsModel::planeColumns() const {
    return bob_text::planeHead(Words());
}

QVector<QStringList> BobWeightsModel::planeRows() const {
    return bob_text::planes(Words(), solution());
}

QStringList BobWeightsModel::holeColumns() const {
    return bob_text::holeHead(Words());
}

QVector<QStringList> BobWeightsModel::holeRows() const {
    return bob_text::holes(Words(), solution());
}

ResultTips BobWeightsModel::lineTips() {
    ResultTips tips{
        {Words().translate("BobWeights", "Counts"),
         tr("How many times the mass is in the bob weight: rods on it, times the factor for what "
            "moves with the piston")},
        {Words().translate("BobWeights", "In the bob weight"), tr("Mass × how often it counts")},
        {Words().translate("BobWeights", "Bob weight"), tr("Sum of the lines: weigh it out so")}};
    for (const PartField& part : part_fields()) {
        tips << std::pair(fieldName(part.field), shownText(part.field.hint));
    }
    return tips;
}

ResultTips BobWeightsModel::planeTips() {
    const Words words;
    return {{words.translate("BobWeights", "Unbalance"),
             tr("Both readings taken to the correction planes: same force, same moment")},
            {words.translate("BobWeights", "Heavy at"),
             tr("Angle of the heavy spot from the machine's zero mark")},
            {words.translate("BobWeights", "At the radius"),
             tr("Mass that makes this unbalance at the plane's radius")},
            {words.translate("BobWeights", "Remains"),
             tr("What the holes below leave, added up as vectors")},
            {words.translate("BobWeights", "Verdict"), tr("By the limit of the plane")}};
}

ResultTips BobWeightsModel::holeTips() {
    const Words words;
    return {{words.translate("BobWeights", "Depth"),
             tr("Of the full diameter; the point of the drill lies beyond")},
            {words.translate("BobWeights", "Angle"), tr("From the machine's zero mark")},
            {words.translate("BobWeights", "Takes off"),
             tr("Mass, the cone of the point included; negative: a slug adds so much more than the "
                "steel weighed")}};
}

// ------------------------------------------------------------------------------------- journal

JobDesk::Scene BobWeightsModel::deskScene() {
    return {[this] { return journalEntry(); },
            [this](const CaseFile& file, bool isCopy) { takeJob(file, isCopy); },
            [this] { return solution().bob_weight.has_value(); },
            [this] { return solution().bob_weight ? QString() : headline(); }};
}

JournalJob BobWeightsModel::journalEntry() const {
    const workshop::JobHeader& head = input().job;
    JournalJob job;
    job.engineNumber = QString::fromStdString(head.engine_number);
    job.crankshaftNumber = QString::fromStdString(head.crankshaft_number);
    job.customer = QString::fromStdString(head.customer);
    job.technician = QString::fromStdString(head.technician);
    job.engine = bob_text::engineName(Words(QStringLiteral("en")), input().engine);
    job.date = QDate::fromString(QString::fromStdString(head.date), Qt::ISODate);
    if (solution().bob_weight) {
        job.bobWeight = *solution().bob_weight / units::gram;
    }
    if (input().correction) {
        const auto reading = [&](std::size_t i) {
            const auto& unbalance = input().correction->readings.at(i).unbalance;
            return unbalance ? std::optional(*unbalance / units::gram_mm) : std::nullopt;
        };
        job.frontReading = reading(0);
        job.rearReading = reading(1);
    }
    if (solution().correction && solution().permissible) {
        bool passes = true;
        for (std::size_t i = 0; i < 2; ++i) {
            passes =
                passes && (*solution().correction)[i].unbalance <= (*solution().permissible)[i];
        }
        job.verdict = passes ? QStringLiteral("passes") : QStringLiteral("fails");
    }
    return job;
}

void BobWeightsModel::takeJob(const CaseFile& file, bool isCopy) {
    Input next = read_input(file.input, Completeness::as_is);
    if (isCopy) {
        next.job.engine_number.clear();
        next.job.crankshaft_number.clear();
        next.job.notes.clear();
        next.job.date = QDate::currentDate().toString(Qt::ISODate).toStdString();
        forgetReadings(next);
    }
    setTitle(QString::fromStdString(file.title));
    // Undo must not bring another job's values under this job's number.
    restart(next);
}

}  // namespace ravnoves
