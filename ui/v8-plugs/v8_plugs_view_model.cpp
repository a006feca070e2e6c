#include "v8-plugs/v8_plugs_view_model.h"

#include <QDate>
#include <QSettings>
#include <algorithm>
#include <array>
#include <cmath>

#include "case-file/input_error.h"
#include "numerics/constants.h"
#include "shell/input_command.h"
#include "v8-plugs/v8_text.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {

constexpr double gram = 1e-3;
constexpr double millimetre = 1e-3;
constexpr double gramMillimetre = 1e-6;
constexpr int draftDelay = 300;  // ms after the first change that is in no draft yet

const QString dash = QStringLiteral("–");

std::size_t index(OptionId id) {
    return static_cast<std::size_t>(id);
}

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

// ----------------------------------------------------------------------- what the page shows

QString V8PlugsViewModel::adviceText() const {
    if (solution_.advice) {
        return v8_text::advice(words_, input_, solution_);
    }
    QStringList names;
    for (const EngineField* field : missing_fields(input_.engine, false)) {
        names << v8_text::fieldName(words_, field->spec.key);
    }
    return names.isEmpty() ? tr("The values do not go together.")
                           : tr("Still needed: %1.").arg(names.join(QStringLiteral(", ")));
}

QString V8PlugsViewModel::boringText() const {
    return solution_.advice && solution_.advice->kind == Advice::Kind::option
               ? v8_text::boring(words_, input_, solution_, solution_.advice->option->id)
               : QString();
}

QString V8PlugsViewModel::excessText() const {
    if (!solution_.unbalanced_mass || !input_.engine.crank_radius) {
        return tr("Excess Δm_y: not known yet");
    }
    return tr("Excess Δm_y: %1, %2")
        .arg(v8_text::grams(words_, *solution_.unbalanced_mass, 3),
             v8_text::gramMillimetres(words_,
                                      *solution_.unbalanced_mass * *input_.engine.crank_radius));
}

QStringList V8PlugsViewModel::troubles() const {
    QStringList list;
    for (const EngineConflict& conflict : engine_conflicts(input_.engine)) {
        const bool steel = conflict.key == "max_steel_reduction_g";
        const double mass =
            (steel ? input_.engine.steel_plug_mass : input_.engine.aluminium_plug_mass).value();
        list << tr("%1: must be less than the plug's mass, %2.")
                    .arg(v8_text::fieldName(words_, conflict.key), v8_text::grams(words_, mass, 3));
    }
    if (input_.plug) {
        const auto geometry = input_.plug->geometry();
        if (geometry && geometry_fault(*geometry)) {
            list
                << (geometry->bore_depth >= geometry->height
                        ? tr("The bore is as deep as the plug is high: there is no bottom.")
                        : tr("The bore is wider than the root of the thread, %1: there is no wall.")
                              .arg(v8_text::millimetres(words_, geometry->thread.root_diameter())));
        }
        if (input_.plug->bore_diameter.has_value() != input_.plug->bore_depth.has_value()) {
            list << tr("A bore needs both its diameter and its depth.");
        }
    }
    list << v8_text::massWarnings(words_, solution_);
    if (input_.weigh_in) {
        for (const Part part : all_parts) {
            const auto s = statistics((*input_.weigh_in)[part]);
            if (s && !s->within_permitted) {
                list << tr("%1: spread %2, permitted %3 (heaviest: cylinder %4, lightest: %5).")
                            .arg(v8_text::partName(words_, part), v8_text::grams(words_, s->spread),
                                 v8_text::grams(words_,
                                                (*input_.weigh_in)[part].permitted_spread.value()))
                            .arg(s->heaviest + 1)
                            .arg(s->lightest + 1);
            }
        }
    }
    return list;
}

QString V8PlugsViewModel::shiftText() const {
    if (!solution_.plugs) {
        return {};
    }
    const auto chosen = v8_text::chosenOption(solution_);
    return v8_text::shiftText(words_, input_,
                              chosen ? *chosen : *solution_.option(OptionId::steel_machined));
}

QString V8PlugsViewModel::checkText() const {
    return v8_text::bobWeightCheck(words_, input_, solution_);
}

QString V8PlugsViewModel::hangText() const {
    return solution_.before ? v8_text::hang(words_, solution_) : missingText();
}

QString V8PlugsViewModel::missingText() const {
    QStringList names;
    for (const EngineField* field : missing_fields(input_.engine, true)) {
        names << v8_text::fieldName(words_, field->spec.key);
    }
    return names.isEmpty()
               ? QString()
               : tr("The bob weight still needs: %1.").arg(names.join(QStringLiteral(", ")));
}

QString V8PlugsViewModel::isoText() const {
    if (!solution_.balancing || !input_.balancing) {
        return tr("ISO 21940-11 needs grade, mass and speed.");
    }
    return tr("ISO 21940-11: U_per = 1000 m G / ω = %1 for the whole crankshaft; the method's own "
              "limit is %2 in each plane.")
        .arg(v8_text::gramMillimetres(words_, solution_.balancing->permissible),
             v8_text::gramMillimetres(words_, input_.tolerance));
}

QString V8PlugsViewModel::plugWeightText() const {
    if (!input_.plug || !input_.plug->geometry() || geometry_fault(*input_.plug->geometry())) {
        return tr("With thread and height the sheet says what the plug would weigh.");
    }
    const double volume = input_.plug->geometry()->volume();
    return tr("A plug of these dimensions weighs %1 in steel, %2 in aluminium.")
        .arg(v8_text::grams(words_, volume * input_.plug->steel_density, 1),
             v8_text::grams(words_, volume * input_.plug->aluminium_density, 1));
}

QString V8PlugsViewModel::assignmentText() const {
    return v8_text::assignmentText(words_, solution_);
}

QStringList V8PlugsViewModel::optionColumns() const {
    return {tr("Option"), tr("const., g"), tr("reach, g"), tr("needed, g"), tr("left, g·mm")};
}

QVector<QStringList> V8PlugsViewModel::optionRows() const {
    QVector<QStringList> rows;
    for (const OptionId id : all_options) {
        const auto& option = solution_.option(id);
        const QString name = v8_text::optionName(words_, id);
        if (!option) {
            rows << QStringList{name, dash, dash, dash, dash};
            continue;
        }
        rows << QStringList{(option->feasible ? QStringLiteral("✓ ") : QStringLiteral("✗ ")) + name,
                            words_.number(option->constant / gram, 3),
                            words_.number(option->maximum / gram, 3),
                            words_.number(option->required_reduction / gram, 3),
                            words_.number(option->residual_unbalance / gramMillimetre, 1)};
    }
    return rows;
}

QString V8PlugsViewModel::optionToolTip(int row) const {
    const OptionId id = all_options.at(static_cast<std::size_t>(row));
    const auto& option = solution_.option(id);
    if (!option) {
        return tr("The engine has no such plug, or its data are missing.");
    }
    QStringList text{
        tr("%1: %2.").arg(v8_text::optionName(words_, id),
                          v8_text::verdict(words_, *option, input_.tolerance)),
        tr("At most %1 may come off a plug; slope k_y = %2, %3°.")
            .arg(v8_text::grams(words_, option->max_reduction, 3), words_.number(option->slope, 3),
                 words_.number(std::atan(option->slope) / degree, 1))};
    const QString boring = v8_text::boring(words_, input_, solution_, id);
    if (!boring.isEmpty()) {
        text << boring;
    }
    text << v8_text::shiftText(words_, input_, *option);
    return text.join(QLatin1Char('\n'));
}

QStringList V8PlugsViewModel::bobWeightColumns() const {
    return {tr("factor × mass, g"), tr("nominal"), tr("before"), tr("after")};
}

QVector<QStringList> V8PlugsViewModel::bobWeightRows() const {
    QVector<QStringList> rows;
    if (!solution_.nominal || !solution_.before) {
        return rows;
    }
    const auto chosen = v8_text::chosenOption(solution_);
    const BobWeight* after = chosen ? &solution_.bob_weights[index(chosen->id)]->after : nullptr;
    const auto product = [&](const BobWeight* weight, BobWeightLine::Part part) {
        if (weight != nullptr) {
            for (const BobWeightLine& line : weight->lines) {
                if (line.part == part) {
                    return words_.number(line.product() / gram, 2);
                }
            }
        }
        return dash;
    };
    for (const BobWeightLine& line : solution_.before->lines) {
        rows << QStringList{v8_text::shortLine(words_, line),
                            product(&*solution_.nominal, line.part),
                            product(&*solution_.before, line.part), product(after, line.part)};
    }
    rows << QStringList{tr("Bob weight"), words_.number(solution_.nominal->sum() / gram, 2),
                        words_.number(solution_.before->sum() / gram, 2),
                        after != nullptr ? words_.number(after->sum() / gram, 2) : dash};
    return rows;
}

QStringList V8PlugsViewModel::planeColumns() const {
    return {tr("Plane"), tr("allowed, g·mm"), tr("reading, g·mm"), tr("verdict")};
}

QVector<QStringList> V8PlugsViewModel::planeRows() const {
    QVector<QStringList> rows;
    const auto add = [&](const QString& name, const PlaneVerdict* plane,
                         const std::optional<double>& reading) {
        rows << QStringList{
            name, plane != nullptr ? words_.number(plane->permissible / gramMillimetre, 1) : dash,
            reading ? words_.number(*reading / gramMillimetre, 1) : dash,
            plane == nullptr || !plane->passes ? dash
            : *plane->passes                   ? tr("✓ passes")
                                               : tr("✗ fails")};
    };
    const auto reading = [&](std::optional<double> BalancingSheet::*member) {
        return input_.balancing ? *input_.balancing.*member : std::nullopt;
    };
    add(tr("Front (pulley)"), solution_.balancing ? &solution_.balancing->front : nullptr,
        reading(&BalancingSheet::front_reading));
    add(tr("Rear (flywheel)"), solution_.balancing ? &solution_.balancing->rear : nullptr,
        reading(&BalancingSheet::rear_reading));
    return rows;
}

QStringList V8PlugsViewModel::assignmentColumns() const {
    QStringList columns{tr("Cylinder")};
    for (int i = 1; i <= cylinder_count; ++i) {
        columns << QString::number(i);
    }
    return columns;
}

QVector<QStringList> V8PlugsViewModel::assignmentRows() const {
    QVector<QStringList> rows;
    if (!solution_.assignment) {
        return rows;
    }
    const auto row = [](const QString& name, const std::vector<int>& from) {
        QStringList cells{name};
        for (std::size_t i = 0; i < from.size(); ++i) {
            // A set that stays where it is needs no number.
            cells << (from[i] == static_cast<int>(i) ? QStringLiteral("·")
                                                     : QString::number(from[i] + 1));
        }
        return cells;
    };
    return {row(tr("Piston from"), solution_.assignment->pistons),
            row(tr("Rod from"), solution_.assignment->rods)};
}

QStringList V8PlugsViewModel::crankpinColumns() const {
    return {tr("Crankpin"),      QStringLiteral("1"), QStringLiteral("2"),
            QStringLiteral("3"), QStringLiteral("4"), tr("spread")};
}

QVector<QStringList> V8PlugsViewModel::crankpinRows() const {
    QVector<QStringList> rows;
    if (!solution_.crankpin_excess || !solution_.assigned_excess) {
        return rows;
    }
    const auto row = [&](const QString& name, const std::array<double, crankpin_count>& excess) {
        QStringList cells{name};
        for (const double mass : excess) {
            cells << words_.number(mass / gram, 2);
        }
        const auto [least, most] = std::minmax_element(excess.begin(), excess.end());
        cells << words_.number((*most - *least) / gram, 2);
        return cells;
    };
    return {row(tr("as weighed, g"), *solution_.crankpin_excess),
            row(tr("after moving, g"), *solution_.assigned_excess)};
}

V8PlugsViewModel::ColumnNote V8PlugsViewModel::columnNote(Part part) const {
    ColumnNote note{dash, dash, false, {}};
    if (!input_.weigh_in) {
        return note;
    }
    const auto s = statistics((*input_.weigh_in)[part]);
    if (!s) {
        return note;
    }
    note.mean = words_.number(s->mean / gram, 2);
    note.spread = words_.number(s->spread / gram, 2);
    note.tooWide = !s->within_permitted;
    note.toolTip = tr("%1: %2 weighed; heaviest in cylinder %3, lightest in cylinder %4.")
                       .arg(v8_text::partName(words_, part))
                       .arg(s->count)
                       .arg(s->heaviest + 1)
                       .arg(s->lightest + 1);
    return note;
}

// ------------------------------------------------------------------------------------- journal

void V8PlugsViewModel::setJournalTrouble(const QString& text) {
    if (text != journalTrouble_) {
        journalTrouble_ = text;
        Q_EMIT journalTroubleChanged(text);
    }
}

bool V8PlugsViewModel::openJournal() {
    if (journal_ && journal_->isOpen()) {
        return true;
    }
    if (journalPath_.isEmpty()) {
        return false;
    }
    if (!journal_) {
        journal_ = std::make_unique<Journal>(journalPath_);
        connect(journal_.get(), &Journal::reopened, this, [this](const QString& message) {
            if (!message.isEmpty()) {
                setJournalTrouble(message);
            }
        });
    }
    if (!journal_->open()) {
        setJournalTrouble(journal_->lastError());
        return false;
    }
    setJournalTrouble(journal_->openMessage());
    ownEngines_ = journal_->engines();
    Q_EMIT enginesChanged();
    return true;
}

QByteArray V8PlugsViewModel::formText() const {
    return QByteArray::fromStdString(
        write_case({sceneName().toStdString(), title().toStdString(), inputJson()}).dump());
}

JournalJob V8PlugsViewModel::journalJob() const {
    JournalJob job;
    job.id = jobId_;
    job.revision = jobRevision_;
    job.engineNumber = QString::fromStdString(input_.job.engine_number);
    job.customer = QString::fromStdString(input_.job.customer);
    job.technician = QString::fromStdString(input_.job.technician);
    job.engine = QString::fromStdString(input_.engine.name);
    job.date = QDate::fromString(QString::fromStdString(input_.job.date), Qt::ISODate);
    job.process = input_.process == Process::repair ? QStringLiteral("repair")
                                                    : QStringLiteral("manufacture");
    if (solution_.unbalanced_mass) {
        job.unbalancedMass = *solution_.unbalanced_mass / gram;
    }
    if (solution_.advice) {
        if (solution_.advice->kind == Advice::Kind::none_needed) {
            job.recommended = QStringLiteral("none-needed");
        } else if (solution_.advice->kind == Advice::Kind::option) {
            const Option& option = *solution_.advice->option;
            const std::string_view name = option_name(option.id);
            job.recommended = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
            job.reduction = option.reduction / gram;
            if (const auto& weights = solution_.bob_weights[index(option.id)]) {
                job.bobWeight = weights->after.sum() / gram;
            }
        }
    }
    job.form = formText();
    return job;
}

QString V8PlugsViewModel::saveJob(bool* ok) {
    if (ok != nullptr) {
        *ok = false;
    }
    if (!openJournal()) {
        return journalTrouble_.isEmpty() ? tr("There is no journal.") : journalTrouble_;
    }
    JournalJob job = journalJob();
    const Journal::Saved saved = journal_->save(job);
    if (saved == Journal::Saved::No) {
        setJournalTrouble(journal_->lastError());
        return journal_->lastError();
    }
    jobId_ = job.id;
    jobRevision_ = job.revision;
    draftTimer_.stop();
    draftStale_ = false;
    journal_->discardDraft(journal_->session());
    draftKept_ = false;
    history()->setClean();
    if (ok != nullptr) {
        *ok = true;
    }
    const QString number =
        job.engineNumber.isEmpty() ? tr("without an engine number") : job.engineNumber;
    return saved == Journal::Saved::AsCopy
               ? tr("Job %1 had been changed elsewhere meanwhile: saved as a new job.").arg(number)
               : tr("Job %1 saved in the journal.").arg(number);
}

QString V8PlugsViewModel::takeForm(const QByteArray& form, qint64 id, int revision, bool copy) {
    try {
        const CaseFile file = parse_case(form.toStdString());
        if (file.scene != sceneName().toStdString()) {
            throw InputError("/scene", "must be \"v8-plugs\"", file.scene);
        }
        CaseInput next = read_input(file.input, Completeness::as_is);
        if (copy) {
            next.job.engine_number.clear();
            next.job.crankshaft_number.clear();
            next.job.notes.clear();
            next.job.date = QDate::currentDate().toString(Qt::ISODate).toStdString();
            if (next.balancing) {
                next.balancing->front_reading.reset();
                next.balancing->rear_reading.reset();
            }
        }
        jobId_ = copy ? 0 : id;
        jobRevision_ = copy ? 0 : revision;
        // Undo must not bring another job's values under this job's number.
        history()->clear();
        lastEdit_.clear();
        setTitle(QString::fromStdString(file.title));
        apply(next);
        draftStale_ = false;
        draftTimer_.stop();
        return {};
    } catch (const InputError& error) {
        return tr("The job's sheet cannot be read: %1").arg(QString::fromUtf8(error.what()));
    }
}

QString V8PlugsViewModel::openJob(qint64 id) {
    if (!openJournal()) {
        return journalTrouble_;
    }
    const auto job = journal_->job(id);
    if (!job) {
        return journal_->lastError();
    }
    return takeForm(job->form, job->id, job->revision, false);
}

QString V8PlugsViewModel::copyJob(qint64 id) {
    if (!openJournal()) {
        return journalTrouble_;
    }
    const auto job = journal_->job(id);
    if (!job) {
        return journal_->lastError();
    }
    return takeForm(job->form, 0, 0, true);
}

void V8PlugsViewModel::newJob() {
    CaseInput next = freshJob(!journalPath_.isEmpty());
    next.preset = input_.preset;
    next.engine = input_.engine;
    next.crankshaft = input_.crankshaft;
    next.process = input_.process;
    next.tolerance = input_.tolerance;
    next.plug = input_.plug;
    next.job.technician = input_.job.technician;
    jobId_ = 0;
    jobRevision_ = 0;
    history()->clear();
    lastEdit_.clear();
    setTitle({});
    apply(next);
    draftStale_ = false;
    draftTimer_.stop();
}

void V8PlugsViewModel::flushDraft() {
    draftTimer_.stop();
    if (!draftStale_ || !journal_ || !journal_->isOpen() || history()->isClean()) {
        return;
    }
    JournalDraft draft;
    draft.jobId = jobId_;
    draft.jobRevision = jobRevision_;
    draft.engineNumber = QString::fromStdString(input_.job.engine_number);
    draft.form = formText();
    if (journal_->saveDraft(draft)) {
        draftStale_ = false;
        draftKept_ = true;
    } else {
        setJournalTrouble(journal_->lastError());
    }
}

QList<JournalDraft> V8PlugsViewModel::crashedDrafts() {
    return journal_ && journal_->isOpen() ? journal_->orphanedDrafts() : QList<JournalDraft>();
}

QString V8PlugsViewModel::restoreDraft(const JournalDraft& draft) {
    const QString trouble = takeForm(draft.form, draft.jobId, draft.jobRevision, false);
    if (!trouble.isEmpty()) {
        return trouble;
    }
    history()->resetClean();  // not saved yet; the draft is this program's from now on
    draftStale_ = true;
    flushDraft();
    if (draftKept_ && !draftStale_) {
        journal_->discardDraft(draft.session);
    }
    return {};
}

void V8PlugsViewModel::discardDraft(const QString& session) {
    if (journal_ && journal_->isOpen()) {
        journal_->discardDraft(session);
    }
}

void V8PlugsViewModel::setCardLanguage(const QString& code) {
    cardLanguage_ = code;
    if (!journalPath_.isEmpty()) {
        QSettings().setValue(QStringLiteral("v8-plugs/card-language"), code);
    }
}

Words V8PlugsViewModel::cardWords() const {
    return cardLanguage_.isEmpty() ? Words() : Words(cardLanguage_);
}

}  // namespace ravnoves
