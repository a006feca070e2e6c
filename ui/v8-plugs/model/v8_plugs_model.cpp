#include "v8-plugs/model/v8_plugs_model.h"

#include <QDate>
#include <algorithm>
#include <utility>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "model/case_model_json.h"
#include "text/error_text.h"
#include "v8-plugs/model/v8_names.h"
#include "v8-plugs/model/v8_text.h"
#include "v8-plugs/presets.h"
#include "v8-plugs/scene.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

/// True where the sheet of sizes holds nothing of the user's own for the plug itself.
bool isPrinted(const std::optional<PlugSheet>& sheet, const std::string& preset) {
    if (!sheet) {
        return true;
    }
    const PlugSheet printed = printed_plug(preset);
    return (!sheet->thread && !sheet->height && !sheet->bore_diameter && !sheet->bore_depth) ||
           (sheet->thread == printed.thread && sheet->height == printed.height &&
            !sheet->bore_diameter && !sheet->bore_depth);
}

/// The paper's engine with the sizes it prints of the plug; sizes that the user typed stay.
void takePreset(Input& input, const Engine& preset) {
    if (isPrinted(input.plug, input.preset)) {
        const PlugSheet printed = printed_plug(preset.name);
        PlugSheet sheet = input.plug.value_or(PlugSheet{});
        sheet.thread = printed.thread;
        sheet.height = printed.height;
        input.plug = sheet == PlugSheet{} ? std::nullopt : std::optional(sheet);
    }
    input.preset = preset.name;
    input.engine = preset;
}

/// @throws InputError where the values kept are damaged
Engine readOwnEngine(const JournalEngine& own) {
    const Json input{{"engine", parse_json(own.values.toStdString())}, {"process", "repair"}};
    Engine engine = read_input(input, Completeness::as_is).engine;
    engine.name = own.name.toStdString();
    return engine;
}

}  // namespace

Input V8PlugsScene::defaultInput() const {
    Input input;
    takePreset(input, engine_presets().front());
    if (dated) {
        input.job.date = QDate::currentDate().toString(Qt::ISODate).toStdString();
    }
    return input;
}

Input V8PlugsScene::read(const Json& input, const CaseContext& /*context*/) {
    return read_input(input, Completeness::as_is);
}

Json V8PlugsScene::write(const Input& input) {
    return write_input(input);
}

template class CaseModel<V8PlugsScene>;

V8PlugsModel::V8PlugsModel(const QString& journalPath, QObject* parent)
    : CaseModel({.dated = !journalPath.isEmpty()}, parent), desk_(this, journalPath, deskScene()) {
    connect(&desk_, &JobDesk::journalOpened, this, &V8PlugsModel::reloadEngines);
}

Json V8PlugsModel::resultJson() const {
    try {
        return solve_scene(inputJson(), context());
    } catch (const InputError& error) {
        return {{"error", error.what()}};  // a sheet half filled has no result yet
    }
}

bool V8PlugsModel::setViewOption(const QString& key, const QString& value) {
    if (key != QLatin1String("sheet")) {
        return false;
    }
    Q_EMIT sheetChosen(oneOf(key, value, {"job", "engine", "weigh-in", "plug", "machine"}));
    return true;
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
    Input next = scene().defaultInput();
    next.preset = input().preset;
    next.engine = input().engine;
    next.crankshaft = input().crankshaft;
    next.process = input().process;
    next.tolerance = input().tolerance;
    next.plug = input().plug;
    next.job.technician = input().job.technician;
    desk_.replaceJob(0, 0, [&] {
        setTitle({});
        // Undo must not bring another job's values under this job's number.
        restart(next);
    });
}

// ------------------------------------------------------------------------------------- engines

void V8PlugsModel::reloadEngines() {
    if (desk_.isOpen()) {
        ownEngines_ = desk_.journal()->engines();
        Q_EMIT enginesChanged();
    }
}

QStringList V8PlugsModel::engineNames() const {
    QStringList names;
    for (const Engine& preset : engine_presets()) {
        names << v8_text::engineName(words_, preset.name);
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
            const Engine engine = readOwnEngine(own);
            edit(tr("Engine"), [&](Input& input) {
                input.preset.clear();
                input.engine = engine;
                if (!engine.has_new_plug) {
                    input.crankshaft = Crankshaft::standard;
                }
            });
        } catch (const InputError& error) {
            desk_.setJournalTrouble(tr("The values kept for the engine “%1” cannot be read: %2")
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
            << v8_text::engineName(words_, preset.name).replace(QChar(0x00A0), QLatin1Char(' '));
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
    if (!desk_.openJournal()) {
        return desk_.journalTrouble();
    }
    // A name that differs in capitals alone is the same engine.
    for (const JournalEngine& own : std::as_const(ownEngines_)) {
        if (own.name != trimmed && own.name.compare(trimmed, Qt::CaseInsensitive) == 0 &&
            !desk_.journal()->removeEngine(own.name)) {
            return desk_.journal()->lastError();
        }
    }
    Input own = input();
    own.preset.clear();
    own.engine.name = trimmed.toStdString();
    const std::string values = write_input(own).at("engine").dump();
    if (!desk_.journal()->saveEngine({trimmed, QByteArray::fromStdString(values)})) {
        return desk_.journal()->lastError();
    }
    ownEngines_ = desk_.journal()->engines();
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
    if (!desk_.openJournal()) {
        return desk_.journalTrouble();
    }
    if (!desk_.journal()->renameEngine(from, trimmed)) {
        return desk_.journal()->lastError();
    }
    ownEngines_ = desk_.journal()->engines();
    if (QString::fromStdString(input().engine.name) == from) {
        edit(tr("Rename engine"), [&](Input& input) { input.engine.name = trimmed.toStdString(); });
    }
    Q_EMIT enginesChanged();
    return {};
}

QString V8PlugsModel::removeEngine(const QString& name) {
    if (!desk_.openJournal()) {
        return desk_.journalTrouble();
    }
    if (!desk_.journal()->removeEngine(name)) {
        return desk_.journal()->lastError();
    }
    ownEngines_ = desk_.journal()->engines();
    Q_EMIT enginesChanged();
    return {};
}

bool V8PlugsModel::ownEngineChanged() const {
    const int place = engineIndex();
    if (!isOwnEngine(place)) {
        return false;
    }
    try {
        return readOwnEngine(ownEngines_.at(place - static_cast<int>(engine_presets().size()))) !=
               input().engine;
    } catch (const InputError&) {
        return true;
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
