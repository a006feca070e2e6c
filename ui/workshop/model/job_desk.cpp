#include "workshop/model/job_desk.h"

#include <QDate>
#include <QSettings>
#include <algorithm>
#include <exception>

#include "case-file/case_file.h"
#include "case-file/field_reader.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/case_document.h"
#include "model/recovery.h"
#include "scenes/scenes.h"
#include "shop/model/verdict.h"
#include "text/error_text.h"
#include "v8-plugs/compensation.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plugs/model/v8_text.h"

namespace ravnoves {

namespace {

const QString languageKey = QStringLiteral("workshop/card-language");
const QString technicianKey = QStringLiteral("workshop/technician");

}  // namespace

JobDesk::JobDesk(WorkshopModel* model, const QString& journalPath)
    : QObject(model), model_(model), journalPath_(journalPath) {
    if (!journalPath_.isEmpty()) {
        const QSettings settings;
        cardLanguage_ =
            settings.value(languageKey, settings.value(QStringLiteral("v8-plugs/card-language")))
                .toString();
    }
    connect(model_, &SceneModel::changed, this, [this] { isJournaled_ = false; });
    connect(model_->history(), &QUndoStack::indexChanged, this, [this] { isJournaled_ = false; });
}

void JobDesk::setJournalTrouble(const QString& text) {
    if (text != journalTrouble_) {
        journalTrouble_ = text;
        Q_EMIT journalTroubleChanged(text);
    }
}

bool JobDesk::openJournal() {
    if (isOpen()) {
        return true;
    }
    if (journalPath_.isEmpty()) {
        return false;
    }
    if (!journal_) {
        journal_ = std::make_unique<Journal>(journalPath_);
    }
    if (!journal_->open()) {
        setJournalTrouble(journal_->lastError());
        return false;
    }
    setJournalTrouble(journal_->openMessage());
    moveDrafts();
    moveEngines();
    return true;
}

/// What an older version kept in the journal is offered as any unsaved case is.
void JobDesk::moveDrafts() {
    for (const JournalDraft& draft : journal_->orphanedDrafts()) {
        try {
            Recovery::leave(parse_shown_case(draft.form.toStdString()),
                            {{"id", draft.jobId}, {"revision", draft.jobRevision}});
            journal_->discardDraft(draft.session);
        } catch (const InputError&) {
            // It stays where it is: nothing can be made of it here.
        }
    }
}

/// An engine that an older version kept by its name becomes a job to be copied.
void JobDesk::moveEngines() {
    for (const JournalEngine& engine : journal_->engines()) {
        try {
            Json input = parse_json(engine.values.toStdString());
            if (!input.contains("engine")) {  // kept before its sheets were
                input = Json{{"engine", std::move(input)}};
            }
            input["engine"]["name"] = engine.name.toStdString();
            input["process"] = "repair";
            JournalJob job;
            job.scene = model_->sceneName();
            job.engine = engine.name;
            job.process = QStringLiteral("repair");
            job.isFinished = false;
            job.form = QByteArray::fromStdString(
                write_case(parse_shown_case(write_case({"v8-plugs", {}, input}).dump())).dump());
            const auto known = journal_->search({.text = engine.name});
            if (std::ranges::find(known, job.form, &JournalJob::form) != known.end() ||
                journal_->save(job) != Journal::Saved::No) {
                journal_->removeEngine(engine.name);
            }
        } catch (const std::exception&) {
            // As a draft that is damaged.
        }
    }
}

void JobDesk::setJob(qint64 id, int revision) {
    jobId_ = id;
    jobRevision_ = revision;
}

bool JobDesk::isNameless() const {
    return jobId_ == 0 && model_->journalEntry().names().isEmpty() && model_->hasNumbers();
}

void JobDesk::replaceJob(qint64 id, int revision, const std::function<void()>& take) {
    const auto before = std::pair(jobId_, jobRevision_);
    setJob(id, revision);
    try {
        take();
    } catch (...) {
        setJob(before.first, before.second);
        throw;
    }
    // What was rejected was typed for another job, and one value may be that of both.
    Q_EMIT model_->broughtIn();
    Q_EMIT model_->restarted();
}

QByteArray JobDesk::formText() const {
    return QByteArray::fromStdString(write_case(model_->caseFile()).dump());
}

/// Of an older version it may be the case of another scene.
bool JobDesk::isSameForm(const QByteArray& form) const {
    try {
        return form == formText() ||
               QByteArray::fromStdString(write_case(parse_shown_case(form.toStdString())).dump()) ==
                   formText();
    } catch (const InputError&) {
        return false;
    }
}

QString JobDesk::backUpJournal(const QString& file) {
    if (!openJournal()) {
        return journalTrouble_;
    }
    return journal_->backUp(file) ? tr("The journal is backed up: %1").arg(file)
                                  : journal_->lastError();
}

QString JobDesk::restoreJournal(const QString& path, const QString& file,
                                const std::atomic<bool>& cancelled) {
    Journal journal(path);
    const auto done = journal.open() ? journal.restore(file, &cancelled) : std::nullopt;
    return done ? tr("Jobs restored: %1; already in the journal: %2.")
                      .arg(done->added)
                      .arg(done->known)
                : journal.lastError();
}

void JobDesk::takeRestored() {
    setJournalTrouble({});
    moveEngines();
}

QStringList JobDesk::wordsOf(const CaseFile& file) {
    try {
        const Json& head = file.input.at(std::string(shop::field::job.key));
        return entryOf(read_fields<shop::JobHeader>(head, Completeness::as_is)).names();
    } catch (const std::exception&) {
        return {};  // of another scene
    }
}

bool JobDesk::isSameEngine(const JournalJob& there, const JournalJob& here) const {
    if (there.engine == here.engine) {
        return true;
    }
    try {
        return model_->isEngineOf(parse_shown_case(there.form.toStdString()));
    } catch (const InputError&) {
        return false;
    }
}

QString JobDesk::otherEngine() {
    if (jobId_ == 0 || !isOpen()) {
        return {};
    }
    const auto there = journal_->job(jobId_);
    if (!there) {
        return {};
    }
    const JournalJob here = model_->journalEntry();
    // A number that comes later is of the same engine.
    const auto isOther = [](const QString& before, const QString& now) {
        return !before.isEmpty() && before != now;
    };
    return isOther(there->engineNumber, here.engineNumber) ||
                   isOther(there->crankshaftNumber, here.crankshaftNumber) ||
                   (!there->engine.isEmpty() && !isSameEngine(*there, here))
               ? there->numbers()
               : QString();
}

std::optional<JournalJob> JobDesk::sameJob() {
    if (jobId_ != 0 || !openJournal()) {
        return std::nullopt;
    }
    const JournalJob here = model_->journalEntry();
    for (const JournalJob& there : journal_->search({.text = here.date.toString(Qt::ISODate)})) {
        const auto agree = [](const QString& a, const QString& b) {
            return a == b || a.isEmpty() || b.isEmpty();
        };
        const auto are = [](const QString& a, const QString& b) { return !a.isEmpty() && a == b; };
        // A number that came later is of the same job; without any it may be anybody's.
        const bool isSame = there.date == here.date &&
                            agree(there.engineNumber, here.engineNumber) &&
                            agree(there.crankshaftNumber, here.crankshaftNumber) &&
                            (are(there.engineNumber, here.engineNumber) ||
                             are(there.crankshaftNumber, here.crankshaftNumber)) &&
                            isSameEngine(there, here);
        if (isSame && isSameForm(there.form)) {
            setJob(there.id, there.revision);
            return std::nullopt;
        }
        if (isSame) {
            return there;
        }
    }
    return std::nullopt;
}

QString JobDesk::verdictToLose() {
    if (jobId_ == 0 || !isOpen() || !isWithheld(model_->journalEntry().verdict)) {
        return {};
    }
    const auto there = journal_->job(jobId_);
    return there && there->isFinished && !isWithheld(there->verdict) ? there->verdict : QString();
}

QString JobDesk::saveJob(bool* ok, bool isFinished) {
    if (ok != nullptr) {
        *ok = false;
    }
    if (jobId_ == 0 && model_->journalEntry().names().isEmpty() && !model_->hasNumbers()) {
        return tr("The sheet is empty: not saved.") + QLatin1Char(' ') + model_->answerLacks();
    }
    if (!openJournal()) {
        return journalTrouble_.isEmpty() ? tr("The journal is not available.") : journalTrouble_;
    }
    if (QString why = model_->keepForSaving(); !why.isEmpty()) {
        return why;
    }
    model_->keepPlan();
    JournalJob job = model_->journalEntry();
    job.id = jobId_;
    job.revision = jobRevision_;
    job.scene = model_->sceneName();
    job.isFinished = isFinished && !job.names().isEmpty() && model_->answerLacks().isEmpty();
    job.form = formText();
    const Journal::Saved saved = journal_->save(job);
    if (saved == Journal::Saved::No) {
        setJournalTrouble(journal_->lastError());
        return journal_->lastError();
    }
    takeSaved(job);
    if (ok != nullptr) {
        *ok = true;
    }
    return savedText(saved, job);
}

void JobDesk::takeSaved(const JournalJob& job) {
    if (!job.technician.isEmpty()) {
        QSettings().setValue(technicianKey, job.technician);
    }
    setJob(job.id, job.revision);
    isJournaled_ = true;
    if (CaseDocument::hasFile(*model_) && model_->hasChanges()) {
        Q_EMIT model_->historyChanged();  // its place is kept for a crash
        return;
    }
    model_->history()->setClean();
    isJournaled_ = true;
}

QString JobDesk::savedText(Journal::Saved saved, const JournalJob& job) const {
    const QString number =
        job.engineNumber.isEmpty() ? tr("without an engine number") : job.engineNumber;
    const QString done =
        saved == Journal::Saved::AsCopy
            ? tr("Job %1 was changed by another program: saved as a new job.").arg(number)
        : job.isFinished ? tr("Job %1 saved in the journal.").arg(number)
                         : tr("Job %1 put aside in the journal, unfinished.").arg(number);
    QStringList said{done, model_->answerLacks()};
    if (job.names().isEmpty()) {
        said << tr("Enter a number of engine or crankshaft, or a customer, to find the job again.");
    }
    said.removeAll(QString());
    return said.join(QLatin1Char(' '));
}

QString JobDesk::openJob(qint64 id, bool isCopy) {
    if (!openJournal()) {
        return journalTrouble_;
    }
    const auto job = journal_->job(id);
    if (!job) {
        return journal_->lastError();
    }
    try {
        const CaseFile file = parse_shown_case(job->form.toStdString());
        if (file.scene != model_->sceneName().toStdString()) {
            throw InputError(
                "/scene",
                {Text::tr("must be one of %1"), quoted_list({model_->sceneName().toStdString()})},
                file.scene);
        }
        replaceJob(isCopy ? 0 : id, isCopy ? 0 : job->revision,
                   [&] { model_->takeJob(file, isCopy); });
        return {};
    } catch (const InputError& error) {
        return tr("The job's sheet cannot be read: %1").arg(errorText(error));
    }
}

JournalJob JobDesk::entryOf(const shop::JobHeader& head) {
    JournalJob job;
    job.engineNumber = QString::fromStdString(head.engine_number);
    job.crankshaftNumber = QString::fromStdString(head.crankshaft_number);
    job.customer = QString::fromStdString(head.customer);
    job.technician = QString::fromStdString(head.technician);
    job.date = QDate::fromString(QString::fromStdString(head.date), Qt::ISODate);
    return job;
}

QString JobDesk::rememberedTechnician() {
    return QSettings().value(technicianKey).toString();
}

void JobDesk::setCardLanguage(const QString& code) {
    cardLanguage_ = code;
    if (!journalPath_.isEmpty()) {
        QSettings().setValue(languageKey, code);
    }
}

Words JobDesk::cardWords() const {
    return cardLanguage_.isEmpty() ? Words() : Words(cardLanguage_);
}

namespace {

/// Of a job without plugs, in the language of the list.
QString listedEngine(const Words& words, const JournalJob& job) {
    try {
        const Json engine = parse_json(job.form.toStdString()).at("input").at("engine");
        return WorkshopModel::engineName(
            words, read_fields<bob_weights::Engine>(engine, Completeness::as_is));
    } catch (const std::exception&) {
        return job.engine;  // a sheet that cannot be read says so when it is opened
    }
}

}  // namespace

ListedJob listedJob(const Words& words, const JournalJob& job) {
    if (job.process.isEmpty()) {
        return {listedEngine(words, job),
                job.bobWeight ? words.translate("BobWeights", "Bob weight %1")
                                    .arg(words.number(*job.bobWeight * units::gram, units::gram, 1))
                              : QStringLiteral("–")};
    }
    ListedJob text{v8_text::engineName(words, job.engine.toStdString()), job.recommended};
    if (job.recommended.isEmpty()) {
        text.result = QStringLiteral("–");
    } else if (job.recommended == QLatin1String("none-needed")) {
        text.result = words.translate("ravnoves::WorkshopPage", "no action required");
    } else if (job.recommended == QLatin1String("not-compensated")) {
        text.result = words.translate("ravnoves::WorkshopPage", "not compensated");
    }
    for (const v8_plugs::OptionId id : v8_plugs::all_options) {
        if (job.recommended.toStdString() == v8_plugs::option_word(id).word) {
            text.result = v8_text::optionName(words, id);
            if (job.reduction) {
                text.result +=
                    QStringLiteral(", ") + v8_text::grams(words, *job.reduction * units::gram);
            }
        }
    }
    return text;
}

}  // namespace ravnoves
