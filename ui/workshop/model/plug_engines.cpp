#include "workshop/model/plug_engines.h"

#include <QSettings>
#include <algorithm>
#include <utility>

#include "case-file/case_file.h"
#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "shop/model/verdict.h"
#include "text/error_text.h"
#include "v8-plugs/fields.h"
#include "v8-plugs/presets.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plugs/model/v8_text.h"

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

OwnedSheets ownedSheets(const v8_plugs::Input& plugs, const std::optional<shop::WeighIn>& sheet) {
    OwnedSheets owned{plugs.plug.value_or(PlugSheet{}), {}};
    owned.plug.cutter_diameter.reset();
    for (const Part part : all_parts) {
        if (sheet) {
            owned.parts[part].nominal = (*sheet)[part].nominal;
            owned.parts[part].permitted_spread = (*sheet)[part].permitted_spread;
        }
    }
    return owned;
}

OwnedSheets ownedSheets(const workshop::Input& job) {
    return ownedSheets(*job.plugs, job.weigh_in);
}

void takePlug(v8_plugs::Input& plugs, PlugSheet plug) {
    plug.cutter_diameter = plugs.plug ? plugs.plug->cutter_diameter : std::nullopt;
    plugs.plug = plug == PlugSheet{} ? std::nullopt : std::optional(plug);
}

void takeSheets(workshop::Input& job, const OwnedSheets& owned) {
    takePlug(*job.plugs, owned.plug);
    if (!job.weigh_in && owned.parts == WeighIn{}) {
        return;
    }
    if (!job.weigh_in) {
        job.weigh_in.emplace().fit(cylinder_count);
    }
    for (const Part part : all_parts) {
        (*job.weigh_in)[part].nominal = owned.parts[part].nominal;
        (*job.weigh_in)[part].permitted_spread = owned.parts[part].permitted_spread;
    }
}

/// The paper's engine with the sizes it prints of the plug.
void takePreset(workshop::Input& job, const v8_plugs::Engine& preset) {
    if (job.plugs->preset != preset.name) {
        takeSheets(job, {printed_plug(preset.name), {}});
    }
    job.plugs->preset = preset.name;
    job.plugs->engine = preset;
}

struct OwnEngine {
    v8_plugs::Engine engine;
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
    const v8_plugs::Input input = read_fields<v8_plugs::Input>(kept, Completeness::as_is);
    OwnEngine engine{input.engine, ownedSheets(input, input.weigh_in)};
    engine.engine.name = own.name.toStdString();
    return engine;
}

bool isSameName(const QString& a, const QString& b) {
    return a.compare(b, Qt::CaseInsensitive) == 0;
}

const QString toleranceKey = QStringLiteral("workshop/tolerance_g_mm");

}  // namespace

double plug_engines::shopsTolerance() {
    bool isNumber = false;
    const double kept = QSettings().value(toleranceKey).toDouble(&isNumber);
    return isNumber && field::tolerance.range.contains(kept) ? kept * field::tolerance.unit
                                                             : default_tolerance;
}

void plug_engines::keepTolerance(double tolerance) {
    QSettings().setValue(toleranceKey, tolerance / field::tolerance.unit);
}

bool plug_engines::isSame(const v8_plugs::Input& input, const v8_plugs::Input& named) {
    const v8_plugs::Engine& a = input.engine;
    const v8_plugs::Engine& b = named.engine;
    return input.preset == named.preset && a.name == b.name &&
           a.has_aluminium_plug == b.has_aluminium_plug && a.has_new_plug == b.has_new_plug &&
           std::ranges::all_of(engine_fields(), [&](const EngineField& each) {
               return !(b.*each.member) || a.*each.member == b.*each.member;
           });
}

v8_plugs::Input plug_engines::nextOf(const v8_plugs::Input& before) {
    v8_plugs::Input next;
    next.preset = before.preset;
    next.engine = before.engine;
    next.crankshaft = before.crankshaft;
    next.process = before.process;
    next.tolerance = before.tolerance;
    next.plug = before.plug;
    return next;
}

void plug_engines::noteInJournal(JournalJob& job, const v8_plugs::Input& input,
                                 const v8_plugs::Result& solution) {
    job.engine = QString::fromStdString(input.engine.name);
    job.process = QString::fromStdString(
        std::string(process_words[static_cast<std::size_t>(input.process)].word));
    if (solution.unbalanced_mass) {
        job.unbalancedMass = *solution.unbalanced_mass / units::gram;
    }
    if (!solution.advice) {
        return;
    }
    if (solution.advice->kind == Advice::Kind::none_needed) {
        job.recommended = QStringLiteral("none-needed");
    } else if (solution.advice->kind == Advice::Kind::option) {
        const Option& option = *solution.advice->option;
        job.recommended = QString::fromStdString(std::string(option_word(option.id).word));
        job.reduction = option.reduction / units::gram;
    } else if (solution.advice->kind != Advice::Kind::no_new_plug_data) {
        job.recommended = QStringLiteral("not-compensated");
    }
}

// --------------------------------------------------------------------------------- on the page

void WorkshopModel::setHasPlugs(bool there) {
    std::optional<workshop::Input> before = input();
    edit(tr("Sludge-trap plugs"), [&](workshop::Input& job) {
        if (there) {
            job.plugs = otherForm_ ? otherForm_->plugs : std::nullopt;
            if (!job.plugs) {
                workshop::Input first;  // the parts weighed keep their nominal masses
                first.plugs.emplace();
                takePreset(first, engine_presets().front());
                job.plugs = first.plugs;
            }
            scene().startPlugs(*job.plugs);
            job.parts = {};
            job.factor = {};
            if (!job.weigh_in && job.plugs->plug) {
                fit_weigh_in(job);
            }
        } else {
            job.plugs.reset();
            if (otherForm_ && !otherForm_->plugs) {
                job.parts = otherForm_->parts;
                job.factor = otherForm_->factor;
            }
        }
    });
    if (there == hasPlugs()) {
        otherForm_ = std::move(before);
    }
}

QString WorkshopModel::editPlugs(const QString& name,
                                 const std::function<void(v8_plugs::Input&)>& mutate) {
    return edit(name, [&](workshop::Input& job) {
        if (job.plugs) {
            mutate(*job.plugs);
        }
    });
}

void WorkshopModel::keepTolerance() {
    if (scene().dated && hasPlugs()) {
        plug_engines::keepTolerance(input().plugs->tolerance);
        Q_EMIT changed();
    }
}

bool WorkshopModel::isShopsTolerance() const {
    return scene().dated && hasPlugs() &&
           input().plugs->tolerance == plug_engines::shopsTolerance();
}

v8_plugs::Engine WorkshopModel::withNominalMasses() const {
    v8_plugs::Engine engine = plugsInput()->engine;
    if (const auto& sheet = plugsInput()->weigh_in) {
        const auto sum = nominal_reciprocating(*sheet);
        engine.reciprocating_mass = sum ? sum : engine.reciprocating_mass;
        const auto rotating = nominal_rotating(*sheet);
        engine.rotating_mass = rotating ? rotating : engine.rotating_mass;
    }
    return engine;
}

bool WorkshopModel::canFillNominalMasses() const {
    return hasPlugs() && withNominalMasses() != plugsInput()->engine;
}

void WorkshopModel::fillNominalMasses() {
    editPlugs(tr("Masses of the nominal parts"),
              [filled = withNominalMasses()](v8_plugs::Input& plugs) { plugs.engine = filled; });
}

// ------------------------------------------------------------------------------------- engines

void WorkshopModel::reloadEngines() {
    if (desk()->isOpen()) {
        ownEngines_ = desk()->journal()->engines();
        Q_EMIT enginesChanged();
    }
}

void WorkshopModel::setPlugs(const QString& name, EngineGroup group, bool present) {
    editPlugs(name, [&](v8_plugs::Input& plugs) {
        set_plugs(plugs.engine, group, present);
        if (!plugs.engine.has_new_plug) {
            plugs.crankshaft = Crankshaft::standard;
        }
        if (const auto known = present ? keptEngine() : std::nullopt) {
            for (const EngineField& each : engine_fields()) {
                if (each.group == group) {
                    plugs.engine.*each.member = (*known).*each.member;
                }
            }
        }
    });
}

QStringList WorkshopModel::engineNames() const {
    QStringList names;
    for (const v8_plugs::Engine& preset : engine_presets()) {
        names << v8_text::engineName(Words(), preset.name);
    }
    for (const JournalEngine& own : ownEngines_) {
        names << own.name;
    }
    return names;
}

int WorkshopModel::engineIndex() const {
    if (!hasPlugs()) {
        return -1;
    }
    const auto presets = engine_presets();
    const auto preset = std::ranges::find(presets, input().plugs->preset, &v8_plugs::Engine::name);
    if (preset != presets.end()) {
        return static_cast<int>(preset - presets.begin());
    }
    const auto own = std::ranges::find(
        ownEngines_, QString::fromStdString(input().plugs->engine.name), &JournalEngine::name);
    return own == ownEngines_.end()
               ? -1
               : static_cast<int>(presets.size()) + static_cast<int>(own - ownEngines_.begin());
}

const JournalEngine* WorkshopModel::ownEngine(int place) const {
    const auto own = place - static_cast<qsizetype>(engine_presets().size());
    return own >= 0 && own < ownEngines_.size() ? &ownEngines_[own] : nullptr;
}

void WorkshopModel::chooseEngine(int place) {
    const auto presets = engine_presets();
    const JournalEngine* own = ownEngine(place);
    if (!hasPlugs() || place < 0 || (own == nullptr && place >= static_cast<int>(presets.size()))) {
        return;
    }
    finishDrag();
    try {
        const auto kept = own != nullptr ? std::optional(readOwnEngine(*own)) : std::nullopt;
        edit(tr("Engine"), [&](workshop::Input& job) {
            if (!kept) {
                takePreset(job, presets[static_cast<std::size_t>(place)]);
                return;
            }
            takeSheets(job, kept->sheets);
            job.plugs->preset.clear();
            job.plugs->engine = kept->engine;
            if (!kept->engine.has_new_plug) {
                job.plugs->crankshaft = Crankshaft::standard;
            }
        });
    } catch (const InputError& error) {
        desk()->setJournalTrouble(tr("The values kept for the engine “%1” cannot be read: %2")
                                      .arg(own->name, errorText(error)));
    }
    finishDrag();
}

bool WorkshopModel::hasOwnEngine(const QString& name) const {
    return std::ranges::any_of(ownEngines_, [&](const JournalEngine& own) {
        return isSameName(own.name, name.trimmed());
    });
}

QString WorkshopModel::engineNameTrouble(const QString& name) const {
    const QString trimmed = name.trimmed();
    if (trimmed.isEmpty()) {
        return tr("Enter a name for the engine.");
    }
    QStringList presets;
    for (const v8_plugs::Engine& preset : engine_presets()) {
        presets
            << QString::fromStdString(preset.name)
            << v8_text::engineName(Words(), preset.name).replace(QChar(0x00A0), QLatin1Char(' '));
    }
    if (find_preset(trimmed.toStdString()) != nullptr ||
        presets.contains(trimmed, Qt::CaseInsensitive)) {
        return tr("“%1” is the name of a preset; choose another.").arg(trimmed);
    }
    return {};
}

QString WorkshopModel::changeEngines(const std::function<bool(Journal&)>& change) {
    if (!desk()->openJournal()) {
        return desk()->journalTrouble();
    }
    Journal& journal = *desk()->journal();
    if (!change(journal)) {
        return journal.lastError();
    }
    ownEngines_ = journal.engines();
    Q_EMIT enginesChanged();
    return {};
}

QString WorkshopModel::saveEngineAs(const QString& name) {
    const QString trimmed = name.trimmed();
    if (QString trouble = engineNameTrouble(trimmed); !trouble.isEmpty()) {
        return trouble;
    }
    v8_plugs::Input own;
    own.engine = input().plugs->engine;
    own.engine.name = trimmed.toStdString();
    const OwnedSheets sheets = ownedSheets(input());
    takePlug(own, sheets.plug);
    if (sheets.parts != WeighIn{}) {
        own.weigh_in = sheets.parts;
    }
    Json kept = Json::object();
    const Json written = write_fields(own);
    for (const char* key : {"engine", "plug", "weigh_in"}) {
        if (written.contains(key)) {
            kept[key] = written.at(key);
        }
    }
    const QString trouble = changeEngines([&](Journal& journal) {
        // A name that differs in capitals alone is the same engine.
        return std::ranges::all_of(ownEngines_,
                                   [&](const JournalEngine& each) {
                                       return each.name == trimmed ||
                                              !isSameName(each.name, trimmed) ||
                                              journal.removeEngine(each.name);
                                   }) &&
               journal.saveEngine({trimmed, QByteArray::fromStdString(kept.dump())});
    });
    if (trouble.isEmpty()) {
        editPlugs(tr("Save engine"), [&](v8_plugs::Input& plugs) {
            plugs.preset.clear();
            plugs.engine.name = trimmed.toStdString();
        });
    }
    return trouble;
}

QString WorkshopModel::renameEngine(const QString& from, const QString& to) {
    const QString trimmed = to.trimmed();
    QString trouble = engineNameTrouble(trimmed);
    if (trouble.isEmpty() && !isSameName(from, trimmed) && hasOwnEngine(trimmed)) {
        trouble =
            tr("“%1” is the name of another engine of your own; choose another.").arg(trimmed);
    }
    if (trouble.isEmpty()) {
        trouble =
            changeEngines([&](Journal& journal) { return journal.renameEngine(from, trimmed); });
    }
    if (trouble.isEmpty() && hasPlugs() &&
        QString::fromStdString(input().plugs->engine.name) == from) {
        editPlugs(tr("Rename engine"),
                  [&](v8_plugs::Input& plugs) { plugs.engine.name = trimmed.toStdString(); });
    }
    return trouble;
}

QString WorkshopModel::removeEngine(const QString& name) {
    return changeEngines([&](Journal& journal) { return journal.removeEngine(name); });
}

bool WorkshopModel::ownEngineChanged() const {
    const JournalEngine* own = ownEngine(engineIndex());
    try {
        const auto kept = own != nullptr ? std::optional(readOwnEngine(*own)) : std::nullopt;
        return kept &&
               (kept->engine != input().plugs->engine || kept->sheets != ownedSheets(input()));
    } catch (const InputError&) {
        return true;
    }
}

std::optional<v8_plugs::Engine> WorkshopModel::keptEngine() const {
    if (const v8_plugs::Engine* preset = find_preset(input().plugs->preset)) {
        return *preset;
    }
    const JournalEngine* own = ownEngine(engineIndex());
    try {
        return own != nullptr ? std::optional(readOwnEngine(*own).engine) : std::nullopt;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

QString WorkshopModel::engineNote() const {
    if (!hasPlugs()) {
        return {};
    }
    const v8_plugs::Engine* preset = find_preset(input().plugs->preset);
    if (preset == nullptr) {
        return ownEngineChanged() ? tr("The values differ from the saved engine; press “Keep as "
                                       "own engine” to save them.")
                                  : QString();
    }
    if (!preset->steel_plug_mass) {
        return tr(
            "The paper gives only the crank radius of this engine; measure the other values.");
    }
    if (input().plugs->engine.steel_plug_mass == preset->steel_plug_mass) {
        return tr(
            "The paper's plug masses look too small for its threads: weigh the plugs and enter "
            "their masses.");
    }
    return {};
}

}  // namespace ravnoves
