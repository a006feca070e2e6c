#include "bob-weights/model/bob_weights_model.h"

#include <QDate>
#include <algorithm>
#include <utility>

#include "bob-weights/fields.h"
#include "bob-weights/model/bob_text.h"
#include "bob-weights/scene.h"
#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "shop/weigh_in.h"
#include "text/error_text.h"
#include "text/message_text.h"
#include "workshop/model/verdict.h"
#include "workshop/model/workshop_model_json.h"

namespace ravnoves {

using namespace bob_weights;

namespace {

/// The sheet for other parts of the same engine; nothing where it has no rules of its own.
std::optional<WeighIn> rulesAlone(const Input& input) {
    Input next;
    next.engine = input.engine;
    next.weigh_in.emplace();
    fit_weigh_in(next);
    const std::optional<WeighIn> blank = next.weigh_in;
    if (input.weigh_in) {
        next.weigh_in->numbering = input.weigh_in->numbering;
        next.weigh_in->matching = input.weigh_in->matching;
    }
    return next.weigh_in == blank ? std::nullopt : next.weigh_in;
}

/// As those of a run before.
std::vector<EarlierReading> earlierOf(const std::vector<Reading>& readings) {
    std::vector<EarlierReading> list;
    for (const Reading& it : readings) {
        list.push_back({it.unbalance, it.angle, it.bob_weight, it.shaft});
    }
    return list;
}

/// Notes what the holes were planned from once the readings are others: what is put right
/// afterwards drills nothing and fills no hole.
void noteCorrected(DrillingRecord& record, const std::vector<EarlierReading>& before,
                   const std::vector<EarlierReading>& now) {
    if (!record.drilled) {
        return;
    }
    if (record.drilled_by.empty()) {
        record.drilled_by = before;
    }
    const auto isSame = [](const EarlierReading& a, const EarlierReading& b) {
        return a.unbalance == b.unbalance && a.angle == b.angle;
    };
    if (std::equal(now.begin(), now.end(), record.drilled_by.begin(), record.drilled_by.end(),
                   isSame)) {
        record.drilled_by.clear();
    }
}

}  // namespace

Input BobWeightsScene::defaultInput() const {
    Input input;
    input.engine.bank_angle = 90.0 * degree;
    startJob(input);
    return input;
}

void BobWeightsScene::startJob(Input& input) const {
    if (dated) {
        input.job.date = QDate::currentDate().toString(Qt::ISODate).toStdString();
    }
}

Input BobWeightsScene::read(const Json& input, const CaseContext& /*context*/) {
    return read_input(input, Completeness::as_is);
}

Json BobWeightsScene::write(const Input& input) {
    return write_input(input);
}

Result BobWeightsScene::solve(const Input& input) {
    return bob_weights::solve(input);
}

Json BobWeightsScene::solvedJson(const Json& input, const CaseContext& context) {
    return solve_scene(input, context);
}

template class CaseModel<BobWeightsScene>;
template class WorkshopModel<BobWeightsScene>;

BobWeightsModel::BobWeightsModel(const QString& journalPath, QObject* parent)
    : WorkshopModel(journalPath, parent) {}

bool BobWeightsModel::setViewOption(const QString& key, const QString& value) {
    if (key != QLatin1String("sheet")) {
        return false;
    }
    Q_EMIT sheetChosen(oneOf(key, value, {"job", "parts", "weigh-in", "machine", "drills"}));
    return true;
}

// ------------------------------------------------------------------------------------- changes

QString BobWeightsModel::oddRods(const Engine& engine) {
    return engine.cylinders % engine.rods_per_pin != 0
               ? tr("Two rods share a bob weight, and %1 is odd: choose one rod on a bob weight "
                    "first.")
                     .arg(engine.cylinders)
               : QString();
}

QString BobWeightsModel::edit(const QString& name, const std::function<void(Input&)>& mutate,
                              const QString& title) {
    // A case that came so stays as it came, until its engine changes.
    Input next = input();
    mutate(next);
    if (QString why = oddRods(next.engine); !why.isEmpty() && next.engine != input().engine) {
        sayRefused(why);
        return why;
    }
    return WorkshopModel::edit(name, mutate, title);
}

void BobWeightsModel::forgetReadings(Input& input) const {
    if (input.correction) {
        for (Reading& reading : input.correction->readings) {
            reading.unbalance.reset();
            reading.angle.reset();
            reading.bob_weight.reset();
            reading.shaft = {};
        }
        input.correction->earlier_runs.clear();
        input.correction->record = {};
    }
}

void BobWeightsModel::noteBobWeight(Input& input, double bobWeight) const {
    if (input.correction) {
        for (Reading& reading : input.correction->readings) {
            if (reading.unbalance && !reading.bob_weight) {
                reading.bob_weight = bobWeight;
            }
        }
    }
}

void BobWeightsModel::noteShaft(Input& input, const Input& before) const {
    if (!input.correction || !before.correction) {
        return;
    }
    const auto note = [&](auto& readings, const auto& old) {
        for (std::size_t i = 0; i < std::min(readings.size(), old.size()); ++i) {
            if (readings[i].unbalance) {
                readings[i].shaft = old[i].shaft;
                readings[i].shaft.note(before.job, input.job);
            }
        }
    };
    Correction& now = *input.correction;
    const Correction& then = *before.correction;
    note(now.readings, then.readings);
    for (std::size_t i = 0; i < std::min(now.earlier_runs.size(), then.earlier_runs.size()); ++i) {
        note(now.earlier_runs[i].readings, then.earlier_runs[i].readings);
    }
}

QString BobWeightsModel::editField(const std::string& pointer, const FieldValue& value,
                                   const QString& name) {
    return edit(name, [&](Input& input) { setField(input, pointer, value); });
}

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
        for (EarlierRun& run : correction.earlier_runs) {
            run.readings.resize(2);
        }
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
            input.weigh_in = rulesAlone(input);
        }
    });
}

// -------------------------------------------------------------------------- runs of the machine

std::size_t BobWeightsModel::newestRun() const {
    return input().correction ? input().correction->earlier_runs.size() : 0;
}

bool BobWeightsModel::isRunRead() const {
    for (std::size_t plane = 0; plane < 2; ++plane) {
        EarlierReading read;
        read.unbalance = reading(newestRun(), plane, false);
        read.angle = reading(newestRun(), plane, true);
        if (!is_read(read)) {
            return false;
        }
    }
    return true;
}

std::optional<double> BobWeightsModel::reading(std::size_t run, std::size_t plane,
                                               bool isAngle) const {
    if (!input().correction || run > newestRun()) {
        return std::nullopt;
    }
    const auto value = [&](const auto& readings) -> std::optional<double> {
        return plane >= readings.size() ? std::nullopt
               : isAngle                ? readings[plane].angle
                                        : readings[plane].unbalance;
    };
    const Correction& correction = *input().correction;
    return run < newestRun() ? value(correction.earlier_runs[run].readings)
                             : value(correction.readings);
}

QString BobWeightsModel::editReading(const QString& name, std::size_t run, std::size_t plane,
                                     bool isAngle, std::optional<double> value) {
    return editCorrection(name, [&](Correction& correction) {
        auto& earlier = correction.earlier_runs;
        const auto set = [&](auto& reading) {
            (isAngle ? reading.angle : reading.unbalance) = value;
            reading.bob_weight =
                reading.unbalance || reading.angle ? solution().bob_weight : std::nullopt;
            reading.shaft = {};
        };
        const auto& runs = solution().runs;
        const bool isOfOther = run < runs.size() && runs[run].read_on;
        const auto note = [isOfOther](DrillingRecord& record, const auto& before, const auto& now) {
            if (isOfOther) {
                record = {};  // the holes of another crankshaft are not in this one
            }
            noteCorrected(record, before, now);
        };
        if (run < earlier.size()) {
            const auto before = earlier[run].readings;
            set(earlier[run].readings[plane]);
            note(earlier[run], before, earlier[run].readings);
            return;
        }
        if (run > earlier.size()) {
            if (!value) {
                return;
            }
            EarlierRun& last = earlier.emplace_back();
            static_cast<DrillingRecord&>(last) = std::exchange(correction.record, {});
            if (!last.drilled) {
                last.drilled = planned_holes(solution());
            }
            last.readings = earlierOf(correction.readings);
            for (Reading& newest : correction.readings) {
                newest = {newest.position, {}, {}, {}, {}};
            }
        }
        const auto before = earlierOf(correction.readings);
        set(correction.readings[plane]);
        const bool isEmpty =
            std::none_of(correction.readings.begin(), correction.readings.end(),
                         [](const Reading& reading) { return reading.unbalance || reading.angle; });
        if (isEmpty) {
            correction.record = {};
        } else {
            note(correction.record, before, earlierOf(correction.readings));
        }
        if (isEmpty && !earlier.empty()) {
            // It may be typed anew: what was drilled before it is there.
            correction.record = earlier.back();
            for (std::size_t i = 0; i < 2; ++i) {
                const EarlierReading& before = earlier.back().readings[i];
                correction.readings[i] = {correction.readings[i].position, before.unbalance,
                                          before.angle, before.bob_weight, before.shaft};
            }
            earlier.pop_back();
        }
    });
}

void BobWeightsModel::confirmReadings() {
    editCorrection(tr("Readings hold"), [this](Correction& correction) {
        const auto hold = [this](auto& readings) {
            for (auto& reading : readings) {
                reading.bob_weight = solution().bob_weight;
                reading.shaft = {};
            }
        };
        // The newest that do not hold, and what was read together with them.
        const auto& runs = solution().runs;
        std::size_t newest = runs.size();
        while (newest > 0 && runs[newest - 1].holds()) {
            --newest;
        }
        if (newest == 0) {
            return;
        }
        const bool isLast = newest > correction.earlier_runs.size();
        auto shaft = correction.readings.front().shaft;
        auto bobWeight = correction.readings.front().bob_weight;
        if (!isLast) {
            shaft = correction.earlier_runs[newest - 1].readings.front().shaft;
            bobWeight = correction.earlier_runs[newest - 1].readings.front().bob_weight;
        }
        for (EarlierRun& run : correction.earlier_runs) {
            const EarlierReading& first = run.readings.front();
            if (first.shaft == shaft && !shop::is_other_bob_weight(first.bob_weight, bobWeight)) {
                hold(run.readings);
            }
        }
        if (isLast) {
            hold(correction.readings);
        }
        // What was drilled by them is kept as if they had held when the next run began.
        Input held = input();
        held.correction = correction;
        const Result now = bob_weights::solve(held);
        for (std::size_t run = 0; run < correction.earlier_runs.size(); ++run) {
            auto& drilled = correction.earlier_runs[run].drilled;
            drilled = drilled ? drilled : drilled_holes(now.runs[run]);
        }
    });
}

QString BobWeightsModel::otherRunText() const {
    return bob_text::otherRun(Words(), solution());
}

QString BobWeightsModel::otherReadingsText() const {
    return bob_text::otherReadings(Words(), solution());
}

WeighedColumn BobWeightsModel::columnNote(shop::Part part) const {
    for (const Matching& each : solution().matching) {
        if (each.part->column == part) {
            return weighedColumn(Words(), part, each.statistics, {},
                                 each.statistics.count == input().engine.cylinders,
                                 tr("Counts once every cylinder is weighed."));
        }
    }
    return weighedColumn(Words(), part, {}, {}, true);
}

QString BobWeightsModel::weighInText() const {
    return bob_text::weighIn(Words(), input(), solution());
}

QString BobWeightsModel::weighAgain() const {
    return bob_text::weighAgain(Words(), input());
}

std::optional<matching_text::Shown> BobWeightsModel::matchingShown() const {
    return bob_text::matchingShown(input(), solution());
}

Results BobWeightsModel::takeOffResults() const {
    const auto sheet = fitted(input()).weigh_in;
    return sheet
               ? matching_text::takeOff(Words(), static_cast<std::size_t>(input().engine.cylinders),
                                        masses_of(*sheet))
               : Results();
}

void BobWeightsModel::moveBack() {
    if (canMoveBack()) {
        editWeights(tr("Parts as weighed"), [](WeighIn& sheet) { move_back(sheet); });
    }
}

bool BobWeightsModel::canMoveBack() const {
    // By the numbers of a sheet of another number of cylinders they cannot.
    const auto sheet = fitted(input()).weigh_in;
    return sheet && sheet->is_moved();
}

void BobWeightsModel::moveParts() {
    if (const auto placing = solution().placing) {
        editWeights(tr("Move parts"),
                    [&](WeighIn& sheet) { move_sets(sheet, placing->pistons, placing->rods); });
    }
}

void BobWeightsModel::newJob() {
    beginJob(nextOf(input()));
}

Input BobWeightsModel::nextOf(const Input& before) const {
    Input next = scene().defaultInput();
    next.engine = before.engine;
    next.factor = before.factor;
    next.balance = before.balance;
    next.correction = before.correction;
    forgetReadings(next);
    next.tolerance = before.tolerance;
    next.weigh_in = rulesAlone(before);
    return next;
}

// ------------------------------------------------------------------------------------- journal

std::vector<std::string> BobWeightsModel::replacedInputs() const {
    std::vector<std::string> replaced;
    for (const PartField& part : part_fields()) {
        if (is_weighed(input(), part)) {
            replaced.push_back("/parts_g/" + std::string(part.field.key));
        }
    }
    return replaced;
}

bool BobWeightsModel::hasNumbers() const {
    const auto parts = part_fields();
    const bool isTyped = std::any_of(parts.begin(), parts.end(), [&](const PartField& part) {
        return (input().parts.*part.member).has_value();
    });
    const bool isWeighed = input().weigh_in && !input().weigh_in->is_empty();
    const bool isRead =
        input().correction &&
        std::any_of(input().correction->readings.begin(), input().correction->readings.end(),
                    [](const Reading& reading) { return reading.unbalance || reading.angle; });
    return isTyped || isWeighed || isRead;
}

QString BobWeightsModel::answerLacks() const {
    if (!solution().bob_weight) {
        return headline();
    }
    const bool hasPlanes =
        input().correction &&
        std::any_of(input().correction->planes.begin(), input().correction->planes.end(),
                    [](const Plane& plane) { return plane.position || plane.radius; });
    return hasPlanes && !isRunRead() ? tr("Still needed: what the machine reads in both planes.")
                                     : QString();
}

JournalJob BobWeightsModel::journalEntry() const {
    JournalJob job = JobDesk::entryOf(input().job);
    job.engine = bob_text::engineName(Words(QStringLiteral("en")), input().engine);
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
    if (!solution().runs.empty()) {
        const RunResult& newest = solution().runs.back();
        job.verdict = readWord(newest, newest.passes(), solution().passes_after());
    }
    return job;
}

}  // namespace ravnoves
