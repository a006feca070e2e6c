#include "v8-plugs/model/v8_plugs_model.h"

#include <QDate>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "text/error_text.h"
#include "v8-plugs/fields.h"
#include "v8-plugs/model/v8_names.h"
#include "v8-plugs/model/v8_text.h"
#include "v8-plugs/presets.h"
#include "v8-plugs/scene.h"
#include "workshop/model/workshop_model_json.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

/// What belongs to an engine beside its values: the plug's sizes, the parts' nominal masses and
/// permitted spreads. The weights of this job's parts stay, and the shop's cutter.
struct OwnedSheets {
    PlugSheet plug;
    WeighIn parts;

    friend bool operator==(const OwnedSheets&, const OwnedSheets&) = default;
};

OwnedSheets ownedSheets(const Input& input) {
    OwnedSheets owned{input.plug.value_or(PlugSheet{}), {}};
    owned.plug.cutter_diameter.reset();
    if (input.weigh_in) {
        for (const Part part : all_parts) {
            owned.parts[part].nominal = (*input.weigh_in)[part].nominal;
            owned.parts[part].permitted_spread = (*input.weigh_in)[part].permitted_spread;
        }
    }
    return owned;
}

void takeSheets(Input& input, const OwnedSheets& owned) {
    PlugSheet plug = owned.plug;
    plug.cutter_diameter = input.plug ? input.plug->cutter_diameter : std::nullopt;
    input.plug = plug == PlugSheet{} ? std::nullopt : std::optional(plug);
    WeighIn parts = input.weigh_in.value_or(WeighIn{});
    for (const Part part : all_parts) {
        parts[part].nominal = owned.parts[part].nominal;
        parts[part].permitted_spread = owned.parts[part].permitted_spread;
    }
    if (input.weigh_in || parts != WeighIn{}) {
        input.weigh_in = parts;
    }
}

/// The paper's engine with the sizes it prints of the plug.
void takePreset(Input& input, const Engine& preset) {
    if (input.preset != preset.name) {
        takeSheets(input, {printed_plug(preset.name), {}});
    }
    input.preset = preset.name;
    input.engine = preset;
}

struct OwnEngine {
    Engine engine;
    OwnedSheets sheets;
};

/// An engine that was kept before its sheets were is the engine's values alone.
/// @throws InputError where the values kept are damaged
OwnEngine readOwnEngine(const JournalEngine& own) {
    Json kept = parse_json(own.values.toStdString());
    if (!kept.is_object() || !kept.contains("engine")) {
        kept = Json{{"engine", std::move(kept)}};
    }
    kept["process"] = "repair";
    const Input input = read_input(kept, Completeness::as_is);
    OwnEngine engine{input.engine, ownedSheets(input)};
    engine.engine.name = own.name.toStdString();
    return engine;
}

const QString toleranceKey = QStringLiteral("workshop/tolerance_g_mm");

double shopsTolerance() {
    bool isNumber = false;
    const double kept = QSettings().value(toleranceKey).toDouble(&isNumber);
    return isNumber && field::tolerance.range.contains(kept) ? kept * field::tolerance.unit
                                                             : default_tolerance;
}

}  // namespace

Input V8PlugsScene::defaultInput() const {
    Input input;
    takePreset(input, engine_presets().front());
    startJob(input);
    return input;
}

void V8PlugsScene::startJob(Input& input) const {
    if (!dated) {
        return;
    }
    if (input.tolerance == default_tolerance) {
        input.tolerance = shopsTolerance();
    }
    input.job.technician = JobDesk::rememberedTechnician().toStdString();
    input.job.date = QDate::currentDate().toString(Qt::ISODate).toStdString();
}

bool V8PlugsScene::isSameEngine(const Input& input, const Input& named) {
    const Engine& a = input.engine;
    const Engine& b = named.engine;
    return input.preset == named.preset && a.name == b.name &&
           a.has_aluminium_plug == b.has_aluminium_plug && a.has_new_plug == b.has_new_plug &&
           std::ranges::all_of(engine_fields(), [&](const EngineField& each) {
               return !(b.*each.member) || a.*each.member == b.*each.member;
           });
}

Input V8PlugsScene::read(const Json& input, const CaseContext& /*context*/) {
    return read_input(input, Completeness::as_is);
}

Json V8PlugsScene::write(const Input& input) {
    return write_input(input);
}

Result V8PlugsScene::solve(const Input& input) {
    return v8_plugs::solve(input, input.changes_known());
}

Json V8PlugsScene::solvedJson(const Json& input, const CaseContext& context) {
    return solve_scene(input, context);
}

template class CaseModel<V8PlugsScene>;
template class WorkshopModel<V8PlugsScene>;

V8PlugsModel::V8PlugsModel(const QString& journalPath, QObject* parent)
    : WorkshopModel(journalPath, parent) {
    connect(desk(), &JobDesk::journalOpened, this, &V8PlugsModel::reloadEngines);
}

bool V8PlugsModel::setViewOption(const QString& key, const QString& value) {
    if (key != QLatin1String("sheet")) {
        return false;
    }
    Q_EMIT sheetChosen(oneOf(key, value, {"job", "engine", "weigh-in", "plug", "machine"}));
    return true;
}

void V8PlugsModel::noteBobWeight(Input& input, double bobWeight) const {
    if (input.balancing) {
        BalancingSheet& machine = *input.balancing;
        if (machine.front_reading && !machine.front_bob_weight) {
            machine.front_bob_weight = bobWeight;
        }
        if (machine.rear_reading && !machine.rear_bob_weight) {
            machine.rear_bob_weight = bobWeight;
        }
    }
}

void V8PlugsModel::noteShaft(Input& input, const Input& before) const {
    if (!input.balancing || !before.balancing) {
        return;
    }
    const auto note = [&](const std::optional<double>& reading,
                          shop::ReadShaft BalancingSheet::*shaft) {
        if (reading) {
            shop::ReadShaft& noted = *input.balancing.*shaft;
            noted = *before.balancing.*shaft;
            noted.note(before.job, input.job);
        }
    };
    note(input.balancing->front_reading, &BalancingSheet::front_shaft);
    note(input.balancing->rear_reading, &BalancingSheet::rear_shaft);
}

void V8PlugsModel::forgetReadings(Input& input) const {
    if (input.balancing) {
        input.balancing->forget_readings();
    }
}

QString V8PlugsModel::editField(const std::string& pointer, const FieldValue& value,
                                const QString& name) {
    return edit(name, [&](Input& input) {
        setField(input, pointer, value);
        if (pointer == "/balancing/front_reading_g_mm") {
            input.balancing->front_bob_weight =
                input.balancing->front_reading ? solution().hung() : std::nullopt;
            input.balancing->front_shaft = {};
        } else if (pointer == "/balancing/rear_reading_g_mm") {
            input.balancing->rear_bob_weight =
                input.balancing->rear_reading ? solution().hung() : std::nullopt;
            input.balancing->rear_shaft = {};
        }
    });
}

void V8PlugsModel::confirmReadings() {
    edit(tr("Readings hold"), [this](Input& input) {
        if (input.balancing) {
            BalancingSheet& machine = *input.balancing;
            machine.front_bob_weight = machine.front_reading ? solution().hung() : std::nullopt;
            machine.rear_bob_weight = machine.rear_reading ? solution().hung() : std::nullopt;
            machine.front_shaft = machine.rear_shaft = {};
        }
    });
}

QString V8PlugsModel::otherReadingsText() const {
    return v8_text::otherReadings(words_, solution());
}

void V8PlugsModel::moveParts() {
    if (const auto assignment = solution().assignment) {
        edit(tr("Move parts"), [&](Input& input) {
            input.weigh_in = reassigned(input.weigh_in.value(), *assignment);
        });
    }
}

void V8PlugsModel::moveBack() {
    editWeights(tr("Parts as weighed"), [](WeighIn& sheet) { move_back(sheet); });
}

QString V8PlugsModel::editWeights(const QString& name,
                                  const std::function<void(WeighIn&)>& mutate) {
    return edit(name, [&](Input& input) {
        WeighIn sheet = input.weigh_in.value_or(WeighIn{});
        const bool wasEmpty = sheet.is_empty();
        mutate(sheet);
        if (sheet.is_empty() != wasEmpty) {
            input.changes_from_weigh_in = wasEmpty;
        }
        input.weigh_in = std::move(sheet);
    });
}

void V8PlugsModel::newJob() {
    Input next = nextOf(input());
    next.tolerance = scene().defaultInput().tolerance;  // the shop's
    carried_ = next;
    beginJob(std::move(next));
}

Input V8PlugsModel::nextOf(const Input& before) const {
    Input next = scene().defaultInput();
    next.preset = before.preset;
    next.engine = before.engine;
    next.crankshaft = before.crankshaft;
    next.process = before.process;
    next.tolerance = before.tolerance;
    next.plug = before.plug;
    takeSheets(next, ownedSheets(before));
    if (before.weigh_in && (next.weigh_in || before.weigh_in->matching != WeighIn().matching)) {
        if (!next.weigh_in) {
            next.weigh_in.emplace();
        }
        next.weigh_in->numbering = before.weigh_in->numbering;
        next.weigh_in->matching = before.weigh_in->matching;
    }
    next.balancing = before.balancing;
    forgetReadings(next);
    return next;
}

void V8PlugsModel::takeJob(const CaseFile& file, bool isCopy) {
    std::optional<Input> carried;
    if (isCopy) {
        carried = nextOf(V8PlugsScene::read(file.input, context()));
    }
    carried_ = std::move(carried);
    plugsBefore_.clear();
    WorkshopModel::takeJob(file, isCopy);
}

QString V8PlugsModel::carriedOver() const {
    if (!carried_) {
        return {};
    }
    const OwnedSheets before = ownedSheets(*carried_);
    const OwnedSheets now = ownedSheets(input());
    QStringList names;
    if (input().engine == carried_->engine) {
        names << tr("the engine's values");
    }
    if (now.plug == before.plug && now.plug != PlugSheet{}) {
        names << tr("the plug's sizes");
    }
    if (now.parts == before.parts && now.parts != WeighIn{}) {
        names << tr("nominal masses and permitted spreads");
    }
    if (input().balancing && carried_->balancing &&
        input().balancing->check() == carried_->balancing->check()) {
        names << tr("grade, mass and speed");
    }
    return names.isEmpty() ? QString()
                           : tr("From the job before: %1.").arg(names.join(QStringLiteral(", ")));
}

void V8PlugsModel::keepTolerance() {
    if (scene().dated) {
        QSettings().setValue(toleranceKey, input().tolerance / field::tolerance.unit);
        Q_EMIT changed();
    }
}

bool V8PlugsModel::isShopsTolerance() const {
    return scene().dated && input().tolerance == shopsTolerance();
}

bool V8PlugsModel::canFillNominalMasses() const {
    if (!input().weigh_in) {
        return false;
    }
    const auto differs = [](const std::optional<double>& parts, const std::optional<double>& mass) {
        return parts && parts != mass;
    };
    return differs(nominal_reciprocating(*input().weigh_in), input().engine.reciprocating_mass) ||
           differs(nominal_rotating(*input().weigh_in), input().engine.rotating_mass);
}

void V8PlugsModel::fillNominalMasses() {
    edit(tr("Masses of the nominal parts"), [](Input& input) {
        if (const auto sum = nominal_reciprocating(input.weigh_in.value())) {
            input.engine.reciprocating_mass = sum;
        }
        if (const auto sum = nominal_rotating(input.weigh_in.value())) {
            input.engine.rotating_mass = sum;
        }
    });
}

// ------------------------------------------------------------------------------------- engines

void V8PlugsModel::reloadEngines() {
    if (desk()->isOpen()) {
        ownEngines_ = desk()->journal()->engines();
        Q_EMIT enginesChanged();
    }
}

void V8PlugsModel::setPlugs(const QString& name, EngineGroup group, bool present) {
    if (!present) {
        plugsBefore_[group] = input();
    }
    edit(name, [&](Input& input) {
        set_plugs(input.engine, group, present);
        if (!input.engine.has_new_plug) {
            input.crankshaft = Crankshaft::standard;
        }
        if (!present) {
            return;
        }
        const auto before = plugsBefore_.find(group);
        const bool isSame = before != plugsBefore_.end() && before->second.preset == input.preset &&
                            before->second.engine.name == input.engine.name;
        if (const std::optional<Engine> known = isSame ? before->second.engine : keptEngine()) {
            for (const EngineField& each : engine_fields()) {
                if (each.group == group) {
                    input.engine.*each.member = (*known).*each.member;
                }
            }
        }
    });
}

std::vector<std::string> V8PlugsModel::replacedInputs() const {
    std::vector<std::string> replaced;
    for (const MassChangeField& each : mass_change_fields()) {
        if (!input().takes_typed(each.member)) {
            replaced.push_back("/mass_changes_g/" + std::string(each.field.key));
        }
    }
    return replaced;
}

QStringList V8PlugsModel::engineNames() const {
    QStringList names;
    for (const Engine& preset : engine_presets()) {
        names << v8_names::engineName(words_, preset.name);
    }
    for (const JournalEngine& own : ownEngines_) {
        names << own.name;
    }
    return names;
}

bool V8PlugsModel::isOwnEngine(int place) const {
    return place >= static_cast<int>(engine_presets().size());
}

int V8PlugsModel::engineIndex() const {
    const auto presets = engine_presets();
    for (std::size_t i = 0; i < presets.size(); ++i) {
        if (presets[i].name == input().preset) {
            return static_cast<int>(i);
        }
    }
    for (qsizetype i = 0; i < ownEngines_.size(); ++i) {
        if (ownEngines_.at(i).name == QString::fromStdString(input().engine.name)) {
            return static_cast<int>(presets.size()) + static_cast<int>(i);
        }
    }
    return -1;
}

void V8PlugsModel::chooseEngine(int place) {
    const auto presets = engine_presets();
    if (place < 0 || place >= static_cast<int>(presets.size()) + ownEngines_.size()) {
        return;
    }
    finishDrag();
    if (!isOwnEngine(place)) {
        edit(tr("Engine"),
             [&](Input& input) { takePreset(input, presets[static_cast<std::size_t>(place)]); });
    } else {
        const JournalEngine& own = ownEngines_.at(place - static_cast<int>(presets.size()));
        try {
            const OwnEngine kept = readOwnEngine(own);
            edit(tr("Engine"), [&](Input& input) {
                takeSheets(input, kept.sheets);
                input.preset.clear();
                input.engine = kept.engine;
                if (!kept.engine.has_new_plug) {
                    input.crankshaft = Crankshaft::standard;
                }
            });
        } catch (const InputError& error) {
            desk()->setJournalTrouble(tr("The values kept for the engine “%1” cannot be read: %2")
                                          .arg(own.name, errorText(error)));
        }
    }
    finishDrag();
}

bool V8PlugsModel::hasOwnEngine(const QString& name) const {
    return std::any_of(ownEngines_.cbegin(), ownEngines_.cend(), [&](const JournalEngine& own) {
        return own.name.compare(name.trimmed(), Qt::CaseInsensitive) == 0;
    });
}

QString V8PlugsModel::engineNameTrouble(const QString& name) const {
    const QString trimmed = name.trimmed();
    if (trimmed.isEmpty()) {
        return tr("The engine needs a name.");
    }
    QStringList presets;
    for (const Engine& preset : engine_presets()) {
        presets
            << QString::fromStdString(preset.name)
            << v8_names::engineName(words_, preset.name).replace(QChar(0x00A0), QLatin1Char(' '));
    }
    if (find_preset(trimmed.toStdString()) != nullptr ||
        presets.contains(trimmed, Qt::CaseInsensitive)) {
        return tr("“%1” is the name of a preset; choose another.").arg(trimmed);
    }
    return {};
}

QString V8PlugsModel::saveEngineAs(const QString& name) {
    const QString trimmed = name.trimmed();
    QString trouble = engineNameTrouble(trimmed);
    if (!trouble.isEmpty()) {
        return trouble;
    }
    if (!desk()->openJournal()) {
        return desk()->journalTrouble();
    }
    // A name that differs in capitals alone is the same engine.
    for (const JournalEngine& own : std::as_const(ownEngines_)) {
        if (own.name != trimmed && own.name.compare(trimmed, Qt::CaseInsensitive) == 0 &&
            !desk()->journal()->removeEngine(own.name)) {
            return desk()->journal()->lastError();
        }
    }
    Input own;
    own.engine = input().engine;
    own.engine.name = trimmed.toStdString();
    takeSheets(own, ownedSheets(input()));
    Json kept = Json::object();
    const Json written = write_input(own);
    for (const char* key : {"engine", "plug", "weigh_in"}) {
        if (written.contains(key)) {
            kept[key] = written.at(key);
        }
    }
    const std::string values = kept.dump();
    if (!desk()->journal()->saveEngine({trimmed, QByteArray::fromStdString(values)})) {
        return desk()->journal()->lastError();
    }
    ownEngines_ = desk()->journal()->engines();
    edit(tr("Save engine"), [&](Input& input) {
        input.preset.clear();
        input.engine.name = trimmed.toStdString();
    });
    Q_EMIT enginesChanged();
    return {};
}

QString V8PlugsModel::renameEngine(const QString& from, const QString& to) {
    const QString trimmed = to.trimmed();
    QString trouble = engineNameTrouble(trimmed);
    if (!trouble.isEmpty()) {
        return trouble;
    }
    if (from.compare(trimmed, Qt::CaseInsensitive) != 0 && hasOwnEngine(trimmed)) {
        return tr("“%1” is the name of another engine of your own; choose another.").arg(trimmed);
    }
    if (!desk()->openJournal()) {
        return desk()->journalTrouble();
    }
    if (!desk()->journal()->renameEngine(from, trimmed)) {
        return desk()->journal()->lastError();
    }
    ownEngines_ = desk()->journal()->engines();
    if (QString::fromStdString(input().engine.name) == from) {
        edit(tr("Rename engine"), [&](Input& input) { input.engine.name = trimmed.toStdString(); });
    }
    Q_EMIT enginesChanged();
    return {};
}

QString V8PlugsModel::removeEngine(const QString& name) {
    if (!desk()->openJournal()) {
        return desk()->journalTrouble();
    }
    if (!desk()->journal()->removeEngine(name)) {
        return desk()->journal()->lastError();
    }
    ownEngines_ = desk()->journal()->engines();
    Q_EMIT enginesChanged();
    return {};
}

bool V8PlugsModel::ownEngineChanged() const {
    const int place = engineIndex();
    if (!isOwnEngine(place)) {
        return false;
    }
    try {
        const OwnEngine kept =
            readOwnEngine(ownEngines_.at(place - static_cast<int>(engine_presets().size())));
        return kept.engine != input().engine || kept.sheets != ownedSheets(input());
    } catch (const InputError&) {
        return true;
    }
}

std::optional<Engine> V8PlugsModel::keptEngine() const {
    if (const Engine* preset = find_preset(input().preset)) {
        return *preset;
    }
    const int place = engineIndex();
    if (!isOwnEngine(place)) {
        return std::nullopt;
    }
    try {
        return readOwnEngine(ownEngines_.at(place - static_cast<int>(engine_presets().size())))
            .engine;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

QString V8PlugsModel::engineNote() const {
    const Engine* preset = find_preset(input().preset);
    if (preset == nullptr) {
        return ownEngineChanged()
                   ? tr("The values differ from those kept under this name; “Keep as own engine” "
                        "keeps these.")
                   : QString();
    }
    if (!preset->steel_plug_mass) {
        return tr(
            "The paper gives only the crank radius of this engine; the rest has to be "
            "measured.");
    }
    if (input().engine.steel_plug_mass == preset->steel_plug_mass) {
        return tr(
            "Plug masses as the paper prints them. They look too small for the threads it "
            "prints: weigh the plugs and type what the scale says.");
    }
    return {};
}

}  // namespace ravnoves
