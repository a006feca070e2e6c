#include "v8-plugs/v8_plugs_view_model.h"

#include <QDate>
#include <QSettings>

#include "case-file/input_error.h"
#include "shell/input_command.h"
#include "v8-plugs/v8_text.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

constexpr int draftDelay = 300;  // ms after the first change that is in no draft yet

CaseInput freshJob(bool dated) {
    CaseInput input;
    const Engine& first = engine_presets().front();
    input.preset = first.name;
    input.engine = first;
    if (dated) {
        input.job.date = QDate::currentDate().toString(Qt::ISODate).toStdString();
    }
    return input;
}

}  // namespace

V8PlugsViewModel::V8PlugsViewModel(const QString& journalPath, QObject* parent)
    : SceneViewModel(parent), journalPath_(journalPath) {
    input_ = freshJob(!journalPath_.isEmpty());
    solution_ = solve(input_);
    if (!journalPath_.isEmpty()) {
        cardLanguage_ = QSettings().value(QStringLiteral("v8-plugs/card-language")).toString();
    }
    draftTimer_.setSingleShot(true);
    draftTimer_.setInterval(draftDelay);
    connect(&draftTimer_, &QTimer::timeout, this, &V8PlugsViewModel::flushDraft);
    // A job that was saved as a case file, or undone to where it was, needs no draft.
    connect(history(), &QUndoStack::cleanChanged, this, [this](bool clean) {
        if (clean && draftKept_ && journal_ && journal_->isOpen()) {
            draftStale_ = false;
            draftTimer_.stop();
            draftKept_ = !journal_->discardDraft(journal_->session());
        }
    });
}

V8PlugsViewModel::~V8PlugsViewModel() {
    // An ordinary end: the user was asked about unsaved changes, the draft has done its work.
    if (draftKept_ && journal_ && journal_->isOpen()) {
        journal_->discardDraft(journal_->session());
    }
}

Json V8PlugsViewModel::inputJson() const {
    return write_input(input_);
}

Json V8PlugsViewModel::resultJson() const {
    try {
        return solve_case_input(inputJson(), context());
    } catch (const InputError& error) {
        return {{"error", error.what()}};  // a sheet half filled has no result yet
    }
}

void V8PlugsViewModel::loadInput(const Json& json, const CaseContext& /*context*/) {
    const CaseInput next = read_input(json, Completeness::as_is);
    jobId_ = 0;
    jobRevision_ = 0;
    lastEdit_.clear();
    push(tr("Open case"), next, -1);
}

void V8PlugsViewModel::loadDefault() {
    jobId_ = 0;
    jobRevision_ = 0;
    lastEdit_.clear();
    push(tr("New case"), freshJob(!journalPath_.isEmpty()), -1);
    setTitle({});
}

bool V8PlugsViewModel::setViewOption(const QString& key, const QString& value) {
    if (key != QLatin1String("sheet")) {
        return false;
    }
    const QStringList allowed{QStringLiteral("job"), QStringLiteral("engine"),
                              QStringLiteral("weigh-in"), QStringLiteral("plug"),
                              QStringLiteral("machine")};
    if (!allowed.contains(value)) {
        throw InputError(key.toStdString(),
                         "must be one of " + allowed.join(QStringLiteral(", ")).toStdString(),
                         value.toStdString());
    }
    Q_EMIT sheetChosen(static_cast<int>(allowed.indexOf(value)));
    return true;
}

void V8PlugsViewModel::push(const QString& name, const CaseInput& next, int mergeNumber) {
    history()->push(new InputCommand<CaseInput>(name, input_, next, mergeNumber,
                                                [this](const CaseInput& i) { apply(i); }));
}

void V8PlugsViewModel::edit(const QString& name, const std::function<void(CaseInput&)>& mutate) {
    CaseInput next = input_;
    mutate(next);
    if (next == input_) {
        return;
    }
    if (name != lastEdit_) {
        ++mergeNumber_;
        lastEdit_ = name;
    }
    push(name, next, mergeNumber_);
}

void V8PlugsViewModel::apply(const CaseInput& input) {
    input_ = input;
    solution_ = solve(input_);
    Q_EMIT changed();
    draftStale_ = true;
    // Not restarted by further changes: the first waits no longer than the delay.
    if (journal_ && !draftTimer_.isActive()) {
        draftTimer_.start();
    }
}

// ------------------------------------------------------------------------------------- engines

QStringList V8PlugsViewModel::engineNames() const {
    QStringList names;
    for (const Engine& preset : engine_presets()) {
        names << v8_text::engineName(words_, preset.name);
    }
    for (const JournalEngine& own : ownEngines_) {
        names << own.name;
    }
    return names;
}

bool V8PlugsViewModel::isOwnEngine(int place) const {
    return place >= static_cast<int>(engine_presets().size());
}

int V8PlugsViewModel::engineIndex() const {
    const auto presets = engine_presets();
    for (std::size_t i = 0; i < presets.size(); ++i) {
        if (presets[i].name == input_.preset) {
            return static_cast<int>(i);
        }
    }
    for (qsizetype i = 0; i < ownEngines_.size(); ++i) {
        if (ownEngines_.at(i).name == QString::fromStdString(input_.engine.name)) {
            return static_cast<int>(presets.size()) + static_cast<int>(i);
        }
    }
    return -1;
}

void V8PlugsViewModel::chooseEngine(int place) {
    const auto presets = engine_presets();
    if (place < 0 || place >= static_cast<int>(presets.size()) + ownEngines_.size()) {
        return;
    }
    lastEdit_.clear();
    if (!isOwnEngine(place)) {
        const Engine& preset = presets[static_cast<std::size_t>(place)];
        edit(tr("Engine"), [&](CaseInput& input) {
            input.preset = preset.name;
            input.engine = preset;
        });
    } else {
        const JournalEngine& own =
            ownEngines_.at(place - static_cast<int>(engine_presets().size()));
        try {
            const Json input{{"engine", parse_json(own.values.toStdString())},
                             {"process", "repair"}};
            const CaseInput read = read_input(input, Completeness::as_is);
            edit(tr("Engine"), [&](CaseInput& next) {
                next.preset.clear();
                next.engine = read.engine;
                next.engine.name = own.name.toStdString();
            });
        } catch (const InputError& error) {
            setJournalTrouble(own.name + QStringLiteral(": ") + QString::fromUtf8(error.what()));
        }
    }
    lastEdit_.clear();
    if (input_.crankshaft == Crankshaft::new_plugs && !input_.engine.has_new_plug) {
        edit(tr("Crankshaft"), [](CaseInput& input) { input.crankshaft = Crankshaft::standard; });
    }
}

QString V8PlugsViewModel::saveEngineAs(const QString& name) {
    const QString trimmed = name.trimmed();
    if (trimmed.isEmpty()) {
        return tr("The engine needs a name.");
    }
    if (find_preset(trimmed.toStdString()) != nullptr) {
        return tr("“%1” is the name of a preset; choose another.").arg(trimmed);
    }
    if (!openJournal()) {
        return journalTrouble_;
    }
    CaseInput own = input_;
    own.preset.clear();
    own.engine.name = trimmed.toStdString();
    const std::string values = write_input(own).at("engine").dump();
    if (!journal_->saveEngine({trimmed, QByteArray::fromStdString(values)})) {
        return journal_->lastError();
    }
    ownEngines_ = journal_->engines();
    edit(tr("Save engine"), [&](CaseInput& input) {
        input.preset.clear();
        input.engine.name = trimmed.toStdString();
    });
    Q_EMIT enginesChanged();
    return {};
}

QString V8PlugsViewModel::removeEngine(const QString& name) {
    if (!openJournal()) {
        return journalTrouble_;
    }
    if (!journal_->removeEngine(name)) {
        return journal_->lastError();
    }
    ownEngines_ = journal_->engines();
    Q_EMIT enginesChanged();
    return {};
}

QString V8PlugsViewModel::engineNote() const {
    const Engine* preset = find_preset(input_.preset);
    if (preset == nullptr) {
        return {};
    }
    if (!preset->steel_plug_mass) {
        return tr(
            "The paper gives only the crank radius of this engine; the rest has to be "
            "measured.");
    }
    if (input_.engine.steel_plug_mass == preset->steel_plug_mass) {
        return tr(
            "Plug masses as the paper prints them. They look too small for the threads it "
            "prints: weigh the plugs and type what the scale says.");
    }
    return {};
}

}  // namespace ravnoves
