#include "workshop/model/workshop_model.h"

#include <QDate>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "bob-weights/fields.h"
#include "bob-weights/solver.h"
#include "case-file/case_file.h"
#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/result_json.h"
#include "model/case_model_json.h"
#include "shop/kilograms.h"
#include "shop/model/verdict.h"
#include "shop/weigh_in.h"
#include "text/message_text.h"
#include "v8-plugs/fields.h"
#include "workshop/input.h"
#include "workshop/results.h"
#include "workshop/solver.h"

namespace ravnoves {

using namespace bob_weights;
using Job = workshop::Input;

namespace {

const QString machineKey = QStringLiteral("workshop/machine");

/// The balancing machine that new jobs begin with.
workshop::Machine shopsMachine() {
    const QString text = QSettings().value(machineKey).toString();
    try {
        return text.isEmpty() ? workshop::Machine()
                              : read_fields<workshop::Machine>(parse_json(text.toStdString()),
                                                               Completeness::as_is);
    } catch (const InputError&) {
        return {};  // damaged settings are none
    }
}

/// The sheet for other parts of the same engine: its rules, nominal masses and permitted spreads;
/// nothing where it has none of its own.
std::optional<WeighIn> rulesAlone(const Job& input) {
    Job next;
    next.engine = input.engine;
    next.weigh_in.emplace();
    fit_weigh_in(next);
    const std::optional<WeighIn> blank = next.weigh_in;
    if (input.weigh_in) {
        next.weigh_in->numbering = input.weigh_in->numbering;
        next.weigh_in->matching = input.weigh_in->matching;
        for (const shop::Part part : shop::all_parts) {
            (*next.weigh_in)[part].nominal = (*input.weigh_in)[part].nominal;
            (*next.weigh_in)[part].permitted_spread = (*input.weigh_in)[part].permitted_spread;
        }
    }
    return next.weigh_in == blank ? std::nullopt : next.weigh_in;
}

/// Those of the machine are of one shaft; where it reads stays.
void forgetReadings(Job& input) {
    if (input.correction) {
        for (Reading& reading : input.correction->readings) {
            reading = {reading.position, {}, {}, {}, {}};
        }
        input.correction->earlier_runs.clear();
        input.correction->record = {};
        input.correction->planned = {};
    }
}

/// Whether both may have the same crankshaft.
bool isSameCrank(const Engine& a, const Engine& b) {
    return a.type == b.type && a.cylinders == b.cylinders && a.bank_angle == b.bank_angle &&
           a.pin_split == b.pin_split;
}

/// Takes out what is still as the job before had it of its crankshaft.
/// @return whether there was any
bool forgetCrank(Job& input, const Job& before) {
    const Job whole = input;
    const auto forget = [](auto& now, const auto& then) {
        if (now == then) {
            now = {};
        }
    };
    if (input.correction && before.correction) {
        Correction& now = *input.correction;
        const Correction& then = *before.correction;
        for (std::size_t i = 0; i < std::min(now.planes.size(), then.planes.size()); ++i) {
            forget(now.planes[i], then.planes[i]);
        }
        for (std::size_t i = 0; i < std::min(now.readings.size(), then.readings.size()); ++i) {
            forget(now.readings[i].position, then.readings[i].position);
        }
        forget(now.slug, then.slug);
    }
    if (input.tolerance && before.tolerance) {
        for (const auto member :
             {&Tolerance::service_speed, &Tolerance::centre_of_mass, &Tolerance::front_bearing,
              &Tolerance::rear_bearing, &Tolerance::plane}) {
            forget(*input.tolerance.*member, *before.tolerance.*member);
        }
    }
    if (input.weigh_in && before.weigh_in) {
        for (const shop::Part part : shop::all_parts) {
            forget((*input.weigh_in)[part].nominal, (*before.weigh_in)[part].nominal);
        }
    }
    return input != whole;
}

bool hasReading(const Correction& correction) {
    return std::ranges::any_of(correction.readings,
                               [](const Reading& reading) { return has_number(reading); });
}

/// What has nothing in it is not there.
void dropEmpty(Job& input) {
    const auto drop = [](auto& object) {
        if (object && *object == typename std::decay_t<decltype(object)>::value_type{}) {
            object.reset();
        }
    };
    drop(input.tolerance);
    if (!input.correction) {
        return;
    }
    drop(input.correction->slug);
    const auto isBlank = [](const Plane& plane) { return plane == Plane{}; };
    if (std::ranges::all_of(input.correction->planes, isBlank)) {
        Correction whole = *input.correction;
        whole.planes.resize(2);
        whole.readings.resize(2);
        input.correction->planes.clear();  // readings alone have a verdict
        if (whole == Correction{}) {
            input.correction.reset();
        }
    }
}

/// The card has become another crankshaft's: the readings are marked with their own.
/// @param before  the editing
void noteShaft(Job& input, const Job& before) {
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

/// Notes what the holes were planned from once the readings are others: what is put right
/// afterwards drills nothing and fills no hole.
void noteCorrected(DrillingRecord& record, const std::vector<Reading>& before,
                   const std::vector<Reading>& now) {
    if (!record.drilled) {
        return;
    }
    if (record.drilled_by.empty()) {
        record.drilled_by = before;
    }
    const auto isSame = [](const Reading& a, const Reading& b) {
        return a.unbalance == b.unbalance && a.angle == b.angle;
    };
    if (std::equal(now.begin(), now.end(), record.drilled_by.begin(), record.drilled_by.end(),
                   isSame)) {
        record.drilled_by.clear();
    }
}

}  // namespace

void WorkshopScene::keepBeside(Job& undone, const Job& present) {
    if (undone.correction && present.correction && present.correction->planned.drilled &&
        hasReading(*undone.correction) &&
        undone.correction->earlier_runs.size() == present.correction->earlier_runs.size()) {
        undone.correction->planned = present.correction->planned;
    }
}

Job WorkshopScene::defaultInput() const {
    Job input;
    input.engine.bank_angle = 90.0 * degree;
    startJob(input);
    return input;
}

void WorkshopScene::startJob(Job& input) const {
    if (!dated) {
        return;
    }
    if (input.machine == workshop::Machine{}) {
        input.machine = shopsMachine();
    }
    if (input.plugs) {
        startPlugs(*input.plugs);
    }
    input.job.technician = JobDesk::rememberedTechnician().toStdString();
    input.job.date = QDate::currentDate().toString(Qt::ISODate).toStdString();
}

Job WorkshopScene::read(const Json& input, const CaseContext& /*context*/) {
    return workshop::read_input(input, Completeness::as_is);
}

Json WorkshopScene::write(const Job& input) {
    return workshop::write_input(input);
}

WorkshopScene::Solved WorkshopScene::solve(const Job& input) {
    Solved solved{workshop::solve(input, false), {}, {}, fitted(input).weigh_in, {}};
    solved.allowed = workshop::allowed(solved.found);
    solved.verdict = workshop::short_verdict(input, solved.found);
    if (!solved.sheet) {
        return solved;
    }
    using shop::Part;
    const WeighIn& sheet = *solved.sheet;
    const auto swapped =
        shop::swapped_rod_ends(sheet[Part::rod_big_end].mass, sheet[Part::rod_small_end].mass);
    for (const Part part : shop::all_parts) {
        const bool isRod = part == Part::rod_big_end || part == Part::rod_small_end;
        const auto odd = shop::odd_mass(sheet[part]);
        if (odd && !(isRod && !swapped.empty())) {  // whole rods are named below
            for (const std::size_t cylinder : odd->cylinders()) {
                solved.unlikely.emplace_back(part, cylinder);
            }
        }
    }
    for (const std::size_t cylinder : swapped) {
        solved.unlikely.emplace_back(std::nullopt, cylinder);
    }
    if (!solved.unlikely.empty()) {
        solved.allowed.shaft.placing.reset();
    }
    return solved;
}

template class CaseModel<WorkshopScene>;

WorkshopModel::WorkshopModel(const QString& journalPath, QObject* parent)
    : CaseModel({.dated = !journalPath.isEmpty()}, parent), desk_(this, journalPath) {}

void WorkshopModel::setRejected(const QStringList& rejected,
                                const std::vector<std::string>& places) {
    const bool isSame = rejected == rejected_;
    if (!isSame || places != rejectedAt_) {
        rejected_ = rejected;
        rejectedAt_ = places;
        stopped_.reset();
    }
    if (!isSame) {
        Q_EMIT shownChanged();
    }
}

bool WorkshopModel::hasAnswer() const {
    return solution().bob_weight || solution().newest() != nullptr ||
           (plugs() != nullptr && plugs()->advice);
}

std::unique_ptr<WorkshopModel> WorkshopModel::stoppedBy(const QString& why) const {
    static constexpr workshop::DoubtRule rule{
        "rejected-entry", Severity::error, {true, true, true, true}, {}, nullptr};
    auto stopped = std::make_unique<WorkshopModel>(QString());
    stopped->restart(withoutRejected());
    WorkshopScene::Solved& solved = stopped->solvedInPlace();
    solved.found.doubts.insert(solved.found.doubts.begin(), {&rule, why.toStdString(), {}});
    solved.allowed = workshop::allowed(solved.found);
    solved.verdict = workshop::short_verdict(stopped->input(), solved.found);
    solved.allowed.shaft.placing.reset();
    solved.sheet.reset();  // nor is a part made lighter
    return stopped;
}

void WorkshopModel::leaveOutRejected(Json& input) const {
    for (const std::string& place : rejectedAt_) {
        const Json::json_pointer at(place);
        if (input.contains(at)) {
            Json& parent = input[at.parent_pointer()];
            parent.is_array() ? void(input[at] = nullptr) : void(parent.erase(at.back()));
        }
    }
}

Job WorkshopModel::withoutRejected() const {
    Json whole = inputJson();
    leaveOutRejected(whole);
    try {
        return WorkshopScene::read(whole, context());
    } catch (const InputError&) {
        return input();
    }
}

QString WorkshopModel::mustBeCorrected() const {
    return std::ssize(rejectedAt_) == rejected_.size()
               ? QString()
               : tr("Correct this first, or restore the value with Escape: %1")
                     .arg(rejected_.join(QLatin1Char(' ')));
}

void WorkshopModel::leaveOutRejected() {
    if (!rejectedAt_.empty()) {
        edit(tr("Entries not accepted"),
             [without = withoutRejected()](Job& job) { job = without; });
    }
}

const WorkshopModel& WorkshopModel::shown() const {
    if (!isOutdated()) {
        return *this;
    }
    if (!stopped_ || stoppedAt_ != solutions()) {
        stopped_ = stoppedBy(Words()
                                 .translate("JobCard", "Entries not accepted: %1")
                                 .arg(rejected_.join(QLatin1Char(' '))));
        stoppedAt_ = solutions();
    }
    return *stopped_;
}

QString WorkshopModel::stopText() const {
    QStringList said;
    for (const WorkshopModel* each : {isOutdated() ? &shown() : nullptr, this}) {
        if (each != nullptr && each->withheld().any()) {
            said << messageText(each->solved().verdict.text);
        }
    }
    return said.join(QLatin1Char(' '));
}

bool WorkshopModel::setViewOption(const QString& key, const QString& value) {
    if (key != QLatin1String("sheet")) {
        return false;
    }
    Q_EMIT sheetChosen(
        oneOf(key, value,
              {QStringLiteral("job"), QStringLiteral("parts"), QStringLiteral("weigh-in"),
               QStringLiteral("plugs"), QStringLiteral("machine"), QStringLiteral("correction")}));
    return true;
}

// ------------------------------------------------------------------------------ case and place

Json WorkshopModel::resultJson() const {
    try {
        return result_json({}, workshop::read_input(inputJson()));
    } catch (const InputError& error) {
        return {{"error", error.what()}};  // a sheet half filled has no result yet
    }
}

Json WorkshopModel::placeJson() const {
    Json place;
    if (desk_.jobId() != 0) {
        place = {{"id", desk_.jobId()}, {"revision", desk_.jobRevision()}};
    }
    if (!rejected_.isEmpty()) {
        place["rejected"] = rejected_.join(QLatin1Char(' ')).toStdString();
    }
    return place;
}

void WorkshopModel::takePlace(const Json& place) {
    const auto number = [&](const char* key) {
        return place.is_object() && place.contains(key) && place.at(key).is_number_integer()
                   ? place.at(key).get<qint64>()
                   : 0;
    };
    desk_.setJob(number("id"), static_cast<int>(number("revision")));
    if (place.is_object() && place.contains("rejected") && place.at("rejected").is_string()) {
        Q_EMIT broughtWithoutRejected(
            QString::fromStdString(place.at("rejected").get<std::string>()));
    }
}

/// A sheet without a job, such as a preset's, becomes one as any new job is: of today.
CaseFile WorkshopModel::asNew(const CaseFile& file) const {
    CaseFile next = file;
    try {
        Job input = WorkshopScene::read(file.input, context());
        if (input.job == decltype(input.job){}) {
            scene().startJob(input);
            next.input = WorkshopScene::write(input);
        }
    } catch (const InputError&) {
        return file;  // loading it says why
    }
    return next;
}

QString WorkshopModel::jobName() const {
    return JobDesk::entryOf(input().job).names().value(0);
}

void WorkshopModel::aboutToLoad() {
    desk_.setJob();
    otherForm_.reset();
    carried_.reset();
    isLoading_ = true;
}

void WorkshopModel::taken() {
    if (std::exchange(isLoading_, false)) {
        bobWeightAsLoaded_ = bobWeightNow();
    }
}

// ------------------------------------------------------------------------------------- changes

QString WorkshopModel::engineTrouble(const Job& next) {
    const Engine& engine = next.engine;
    if (next.plugs && !workshop::may_have_plugs(engine)) {
        return tr(
            "Only a V-8 at 90° with two rods on a crankpin has sludge-trap plugs. Untick "
            "them first.");
    }
    return engine.cylinders % engine.rods_per_pin != 0
               ? tr("Two rods share a bob weight, and %1 is odd. Choose one rod on a bob weight "
                    "first.")
                     .arg(engine.cylinders)
               : QString();
}

QString WorkshopModel::edit(const QString& name, const std::function<void(Job&)>& mutate,
                            const QString& title) {
    Job next = input();
    if (bobWeightAsLoaded_ && next.correction) {
        for (Reading& reading : next.correction->readings) {
            if (reading.unbalance && !reading.bob_weight) {
                reading.bob_weight = bobWeightAsLoaded_;
            }
        }
    }
    mutate(next);
    const bool isOtherCrank = carried_ && isSameCrank(input().engine, carried_->engine) &&
                              !isSameCrank(next.engine, carried_->engine) &&
                              forgetCrank(next, *carried_);
    dropEmpty(next);
    // A case that came so stays as it came, until its engine changes.
    if (QString why = engineTrouble(next); !why.isEmpty() && next.engine != input().engine) {
        setRejection(why);
        return why;
    }
    if (!isTyped()) {
        beforeEditing_ = input();
    }
    if (next.job != input().job) {
        noteShaft(next, beforeEditing_);
    }
    if (next.correction && next.machine.counts != input().machine.counts) {
        workshop::note_counts_changed(*next.correction);
    }
    QString why = CaseModel::edit(
        name, [&](Job& input) { input = std::move(next); }, title);
    if (isOtherCrank && why.isEmpty()) {
        Q_EMIT crankForgotten();
    }
    return why;
}

QString WorkshopModel::editField(const std::string& pointer, const FieldValue& value,
                                 const QString& name) {
    return edit(name, [&](Job& input) { setField(input, pointer, value); });
}

QString WorkshopModel::chooseType(int type) {
    return edit(fieldName(field::type), [type](Job& input) {
        Engine& engine = input.engine;
        if (std::exchange(engine.type, static_cast<EngineType>(type)) == engine.type) {
            return;
        }
        const bool isV = engine.type == EngineType::v;
        engine.rods_per_pin = isV && engine.cylinders % 2 == 0 ? 2 : 1;
        engine.pin_split = isV ? engine.pin_split : 0.0;
    });
}

QString WorkshopModel::editCorrection(const QString& name,
                                      const std::function<void(Correction&)>& mutate) {
    return edit(name, [&](Job& input) {
        Correction correction = input.correction.value_or(Correction{});
        correction.planes.resize(2);
        correction.readings.resize(2);
        for (EarlierRun& run : correction.earlier_runs) {
            run.readings.resize(run.readings.empty() ? 0 : 2);  // without any it was not read
        }
        mutate(correction);
        input.correction = std::move(correction);
    });
}

QString WorkshopModel::editTolerance(const QString& name,
                                     const std::function<void(Tolerance&)>& mutate) {
    return edit(name, [&](Job& input) {
        mutate(input.tolerance ? *input.tolerance : input.tolerance.emplace());
    });
}

QString WorkshopModel::editWeights(const QString& name,
                                   const std::function<void(WeighIn&)>& mutate) {
    return edit(name, [&](Job& input) {
        if (!input.weigh_in) {
            input.weigh_in.emplace();
        }
        fit_weigh_in(input);
        const bool wasEmpty = input.weigh_in->is_empty();
        mutate(*input.weigh_in);
        shop::forget_sets(*input.weigh_in);
        const bool isEmpty = input.weigh_in->is_empty();
        if (input.plugs && isEmpty != wasEmpty) {
            input.plugs->changes_from_weigh_in = wasEmpty;
        }
        if (isEmpty) {
            input.weigh_in = rulesAlone(input);
        }
    });
}

void WorkshopModel::swapRodEnds() {
    if (input().weigh_in && !(*input().weigh_in)[shop::Part::rod_small_end].is_empty()) {
        editWeights(tr("Swap the columns"), [](WeighIn& sheet) {
            std::swap(sheet[shop::Part::rod_small_end].mass, sheet[shop::Part::rod_big_end].mass);
        });
        return;
    }
    edit(tr("Swap the rod’s ends"),
         [](Job& input) { std::swap(input.parts.small_end, input.parts.big_end); });
}

// -------------------------------------------------------------------------- runs of the machine

std::size_t WorkshopModel::firstRun() const {
    return first_run(input().correction);
}

std::size_t WorkshopModel::newestRun() const {
    return input().correction ? input().correction->earlier_runs.size() - firstRun() : 0;
}

const RunResult* WorkshopModel::runResult(std::size_t run) const {
    const auto& runs = solution().runs;
    return run + firstRun() < runs.size() ? &runs[run + firstRun()] : nullptr;
}

bool WorkshopModel::isRunRead() const {
    return is_read(reading(newestRun(), 0)) && is_read(reading(newestRun(), 1));
}

bool WorkshopModel::isPlanned() const {
    const auto plan = planned_holes(solution());
    return (isRunRead() && plan && !plan->empty()) ||
           (input().correction && input().correction->record.is_drilled());
}

Reading WorkshopModel::reading(std::size_t run, std::size_t plane) const {
    if (!input().correction || run > newestRun()) {
        return {};
    }
    const Correction& correction = *input().correction;
    const auto& readings = run < newestRun() ? correction.earlier_runs[run + firstRun()].readings
                                             : correction.readings;
    return plane < readings.size() ? readings[plane] : Reading{};
}

std::string WorkshopModel::readingPlace(std::size_t run, std::size_t plane) const {
    const std::string of = run < newestRun()
                               ? "/correction/earlier_runs/" + std::to_string(run + firstRun())
                               : std::string(run == newestRun() ? "/correction" : "/none");
    return of + "/readings/" + std::to_string(plane) + '/';
}

QString WorkshopModel::editReading(const QString& name, std::size_t shownRun, std::size_t plane,
                                   bool isAngle, std::optional<double> value) {
    const std::size_t first = firstRun();
    const std::size_t run = shownRun + first;
    return editCorrection(name, [&](Correction& correction) {
        auto& earlier = correction.earlier_runs;
        const auto set = [&](auto& reading) {
            (isAngle ? reading.angle : reading.unbalance) = value;
            reading.bob_weight = has_number(reading) ? bobWeightNow() : std::nullopt;
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
            // A record of no hole says nothing: the plan of the card is drilled, or that shown.
            DrillingRecord plan = std::exchange(correction.planned, {});
            if (!plan.drilled) {
                plan.drilled = planned_holes(solution());
            }
            if (plan.drilled && !correction.record.is_drilled()) {
                correction.record = std::move(plan);
            }
            static_cast<DrillingRecord&>(last) = std::exchange(correction.record, {});
            last.readings = at_places_of({}, correction.readings);
            for (Reading& newest : correction.readings) {
                newest = {newest.position, {}, {}, {}, {}};
            }
        }
        const auto before = at_places_of({}, correction.readings);
        Reading& reading = correction.readings[plane];
        if (shop::is_other_bob_weight(reading.bob_weight, bobWeightNow()) ||
            shop::other_shaft(reading.shaft, input().job)) {
            (isAngle ? reading.unbalance : reading.angle).reset();  // read again with it
        }
        set(reading);
        note(correction.record, before, correction.readings);
        note(correction.planned, before, correction.readings);
        if (hasReading(correction) || correction.record.is_drilled()) {
            return;
        }
        correction.record = {};
        if (earlier.size() > first) {
            // It may be typed again: what was drilled before it is there.
            correction.record = earlier.back();
            correction.readings = at_places_of(correction.readings, earlier.back().readings);
            earlier.pop_back();
        }
    });
}

void WorkshopModel::keepPlan() {
    auto plan = planned_holes(solution());
    // A kept one that is not the present one is a STOP.
    if (!stopText().isEmpty() || !isRunRead() || !plan || plan->empty() ||
        input().correction->planned.drilled) {
        return;
    }
    editCorrection(tr("Plan printed or put aside"),
                   [&](Correction& next) { next.planned.drilled = std::move(plan); });
}

void WorkshopModel::usePresentPlan() {
    editCorrection(tr("Use the present plan"),
                   [](Correction& correction) { correction.planned = {}; });
}

void WorkshopModel::confirmReadings() {
    editCorrection(tr("Readings are still valid"), [this](Correction& correction) {
        const auto hold = [this](auto& readings) {
            for (auto& reading : readings) {
                reading.bob_weight = bobWeightNow();
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
            if (!run.readings.empty() && run.readings[0].shaft == shaft &&
                !shop::is_other_bob_weight(run.readings[0].bob_weight, bobWeight)) {
                hold(run.readings);
            }
        }
        if (isLast) {
            hold(correction.readings);
        }
        // What was drilled by them is kept as if they had held when the next run began.
        Job then = input();
        then.correction = std::move(correction);
        record_plans(then, firstRun(),
                     [](const Job& job) { return workshop::allowed(workshop::solve(job)).shaft; });
        correction = *std::move(then.correction);
    });
}

void WorkshopModel::keepMachine() {
    if (scene().dated) {
        QSettings().setValue(machineKey,
                             QString::fromStdString(write_fields(input().machine).dump()));
        Q_EMIT changed();
    }
}

bool WorkshopModel::isShopsMachine() const {
    return !scene().dated || input().machine == shopsMachine();
}

// ------------------------------------------------------------------------------------ the job

Job WorkshopModel::nextOf(const Job& before) const {
    Job next = scene().defaultInput();
    next.engine = before.engine;
    next.factor = before.factor;
    next.balance = before.balance;
    next.correction = before.correction;
    next.machine = before.machine;
    forgetReadings(next);
    next.tolerance = before.tolerance;
    if (next.tolerance) {
        next.tolerance->rotor_mass.reset();
    }
    next.weigh_in = rulesAlone(before);
    if (before.plugs) {
        next.plugs = before.plugs;
        next.plugs->typed_changes = {};
        next.plugs->changes_given = false;
        next.plugs->changes_from_weigh_in = false;
        next.plugs->weigh_in.reset();
    }
    return next;
}

void WorkshopModel::newJob() {
    Job next = nextOf(input());
    if (next.plugs && scene().dated) {
        next.plugs->tolerance = v8_plugs::default_tolerance;
        scene().startPlugs(*next.plugs);
    }
    next.job.technician = input().job.technician;
    otherForm_.reset();
    carried_ = next;
    desk_.replaceJob(0, 0, [&] {
        setTitle({});
        isLoading_ = true;  // no bob weight of the job before
        // Undo must not bring another job's values under this job's number.
        restart(next);
    });
}

void WorkshopModel::takeJob(const CaseFile& file, bool isCopy) {
    Job next = WorkshopScene::read(file.input, context());
    if (isCopy) {
        next = nextOf(next);  // other parts
        next.job.technician = input().job.technician;
    }
    carried_ = isCopy ? std::optional(next) : std::nullopt;
    otherForm_.reset();
    const CaseTexts texts = textsOf(file);
    editText(texts.title, isCopy ? QString() : texts.notes);
    // Undo must not bring another job's values under this job's number.
    isLoading_ = true;
    restart(next);
    if (!isCopy) {
        setTexts(texts);
    }
}

std::vector<std::string> WorkshopModel::replacedInputs() const {
    std::vector<std::string> replaced;
    for (const PartField& part : part_fields()) {
        if (is_weighed(input(), part)) {
            replaced.push_back("/parts_g/" + std::string(part.field.key));
        }
    }
    if (plugsInput() != nullptr) {
        for (const v8_plugs::MassChangeField& each : v8_plugs::mass_change_fields()) {
            if (!plugsInput()->takes_typed(each.member)) {
                replaced.push_back("/plugs/mass_changes_g/" + std::string(each.field.key));
            }
        }
    }
    return replaced;
}

bool WorkshopModel::hasNumbers() const {
    const auto parts = part_fields();
    const bool isTyped = std::any_of(parts.begin(), parts.end(), [&](const PartField& part) {
        return (input().parts.*part.member).has_value();
    });
    const bool isWeighed = input().weigh_in && !input().weigh_in->is_empty();
    const bool isRead = input().correction && hasReading(*input().correction);
    return isTyped || isWeighed || isRead || (hasPlugs() && input().plugs->has_typed_changes());
}

QString WorkshopModel::readingsMissing() const {
    return reading(newestRun(), 0).unbalance && reading(newestRun(), 1).unbalance
               ? tr("Enter the angles of the readings.")
               : tr("Enter the readings of both planes.");
}

QString WorkshopModel::answerLacks() const {
    if (withheld().any()) {
        return Words().message(solved().verdict.text);
    }
    if (!solution().bob_weight && !balances_itself(input().engine)) {
        return headline();
    }
    if (plugs() != nullptr && !plugs()->advice) {
        return adviceText();
    }
    const bool hasPlanes =
        input().correction &&
        std::any_of(input().correction->planes.begin(), input().correction->planes.end(),
                    [](const Plane& plane) { return plane.position || plane.radius; });
    if (hasPlanes && !isRunRead()) {
        return readingsMissing();
    }
    const RunResult* newest = solution().newest();
    return newest != nullptr && newest->passes() == false && isPlanned()
               ? tr("Drill the holes and measure again.")
               : QString();
}

bool WorkshopModel::isEngineOf(const CaseFile& job) const {
    Job there = WorkshopScene::read(job.input, context());
    if (there.plugs && input().plugs) {
        there.plugs->engine.name = input().plugs->engine.name;
        return there.plugs->engine == input().plugs->engine;
    }
    return !there.plugs && !input().plugs && there.engine == input().engine;
}

QString WorkshopModel::verdictNow() const {
    const RunResult* newest = solution().newest();
    if (newest == nullptr || (newest->holds() && withheld().any())) {
        return withheld().any() ? stopped : QString();
    }
    return newest->holds() && newest->passes() == true &&
                   solved().verdict.severity >= Severity::warning
               ? passesWithWarnings
               : readWord(*newest, newest->passes(), solution().passes_after(),
                          solution().is_planned());
}

JournalJob WorkshopModel::journalEntry() const {
    JournalJob job = JobDesk::entryOf(input().job);
    job.engine = engineName(Words(QStringLiteral("en")), input().engine);
    if (plugs() != nullptr) {
        notePlugs(job);
    }
    if (solution().bob_weight) {
        job.bobWeight = *solution().bob_weight / units::gram;
    }
    if (input().correction) {
        const auto reading = [&](std::size_t i) {
            const auto& readings = input().correction->readings;
            return i < readings.size() && readings[i].unbalance
                       ? std::optional(*readings[i].unbalance / units::gram_mm)
                       : std::nullopt;
        };
        job.frontReading = reading(0);
        job.rearReading = reading(1);
    }
    job.verdict = verdictNow();
    return job;
}

}  // namespace ravnoves
