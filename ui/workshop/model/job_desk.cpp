#include "workshop/model/job_desk.h"

#include <QSettings>
#include <utility>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/case_document.h"
#include "scenes/scenes.h"
#include "text/error_text.h"

namespace ravnoves {

namespace {

constexpr int draftDelay = 300;  // ms after the first change that is in no draft yet
const QString languageKey = QStringLiteral("workshop/card-language");
const QString technicianKey = QStringLiteral("workshop/technician");

}  // namespace

JobDesk::JobDesk(SceneModel* model, const QString& journalPath, Scene scene)
    : QObject(model), model_(model), scene_(std::move(scene)), journalPath_(journalPath) {
    if (!journalPath_.isEmpty()) {
        const QSettings settings;
        cardLanguage_ =
            settings.value(languageKey, settings.value(QStringLiteral("v8-plugs/card-language")))
                .toString();
    }
    draftTimer_.setSingleShot(true);
    draftTimer_.setInterval(draftDelay);
    connect(&draftTimer_, &QTimer::timeout, this, &JobDesk::flushDraft);
    connect(model_, &SceneModel::changed, this, [this] {
        draftStale_ = true;
        isJournaled_ = false;
        // Not restarted by further changes: the first waits no longer than the delay.
        if (journal_ && !draftTimer_.isActive()) {
            draftTimer_.start();
        }
    });
    connect(model_->history(), &QUndoStack::indexChanged, this, [this] { isJournaled_ = false; });
    // A job that was saved as a case file, or undone to where it was, needs no draft.
    connect(model_, &SceneModel::historyChanged, this, [this] {
        if (!model_->hasChanges() && draftKept_ && isOpen()) {
            draftStale_ = false;
            draftTimer_.stop();
            draftKept_ = !journal_->discardDraft(journal_->session());
        }
    });
}

JobDesk::~JobDesk() {
    // An ordinary end: the user was asked about unsaved changes, the draft has done its work.
    if (draftKept_ && isOpen()) {
        journal_->discardDraft(journal_->session());
    }
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
        connect(journal_.get(), &Journal::waits, this, &JobDesk::journalWaits);
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
    Q_EMIT journalOpened();
    return true;
}

void JobDesk::putJobId(qint64 id, int revision) {
    jobId_ = id;
    jobRevision_ = revision;
}

void JobDesk::replaceJob(qint64 id, int revision, const std::function<void()>& take) {
    const auto before = std::pair(jobId_, jobRevision_);
    putJobId(id, revision);
    try {
        take();
    } catch (...) {
        putJobId(before.first, before.second);
        throw;
    }
    draftStale_ = false;
    draftTimer_.stop();
}

void JobDesk::beginJob(const std::function<void()>& take) {
    replaceJob(0, 0, take);
    Q_EMIT model_->begunAnew();
}

QByteArray JobDesk::formText() const {
    return QByteArray::fromStdString(write_case(model_->caseFile()).dump());
}

QString JobDesk::backUpJournal(const QString& file) {
    if (!openJournal()) {
        return journalTrouble_;
    }
    return journal_->backUp(file) ? tr("The journal is backed up: %1").arg(file)
                                  : journal_->lastError();
}

QString JobDesk::restoreJournal(const QString& file) {
    if (!openJournal()) {
        return journalTrouble_;
    }
    const auto done = journal_->restore(file);
    if (!done) {
        return journal_->lastError();
    }
    Q_EMIT journalOpened();  // engines may have come with it
    QString said =
        tr("Jobs brought back: %1; already in the journal: %2.").arg(done->added).arg(done->known);
    if (done->missing > 0) {
        said += QLatin1Char(' ') + tr("Jobs that could not be read: %1.").arg(done->missing);
    }
    return said;
}

QString JobDesk::numbersOf(const JournalJob& job) {
    QStringList numbers{job.engineNumber, job.crankshaftNumber};
    numbers.removeAll(QString());
    return numbers.isEmpty() ? QStringLiteral("–") : numbers.join(QStringLiteral(" / "));
}

QString JobDesk::otherEngine() {
    if (jobId_ == 0 || !isOpen()) {
        return {};
    }
    const auto there = journal_->job(jobId_);
    if (!there) {
        return {};
    }
    const JournalJob here = scene_.entry();
    // A number that comes later is of the same engine.
    const auto isOther = [](const QString& before, const QString& now) {
        return !before.isEmpty() && before != now;
    };
    return isOther(there->engineNumber, here.engineNumber) ||
                   isOther(there->crankshaftNumber, here.crankshaftNumber) ||
                   isOther(there->engine, here.engine)
               ? numbersOf(*there)
               : QString();
}

QString JobDesk::saveJob(bool* ok, bool isFinished) {
    if (ok != nullptr) {
        *ok = false;
    }
    if (jobId_ == 0 && !model_->hasChanges() && !scene_.isWorthKeeping()) {
        return tr("The sheet is empty: nothing is saved.") + QLatin1Char(' ') + scene_.missing();
    }
    if (!openJournal()) {
        return journalTrouble_.isEmpty() ? tr("There is no journal.") : journalTrouble_;
    }
    model_->keepTyped();
    JournalJob job = scene_.entry();
    job.id = jobId_;
    job.revision = jobRevision_;
    job.scene = model_->sceneName();
    job.isFinished = isFinished;
    job.form = formText();
    const Journal::Saved saved = journal_->save(job);
    if (saved == Journal::Saved::No) {
        setJournalTrouble(journal_->lastError());
        return journal_->lastError();
    }
    putJobId(job.id, job.revision);
    if (!job.technician.isEmpty()) {
        QSettings().setValue(technicianKey, job.technician);
    }
    draftTimer_.stop();
    if (CaseDocument::hasFile(*model_) && model_->hasChanges()) {
        // The file does not have it yet: a crash must not part the job from it.
        draftStale_ = true;
        flushDraft();
    } else {
        draftStale_ = false;
        journal_->discardDraft(journal_->session());
        draftKept_ = false;
        model_->history()->setClean();
    }
    isJournaled_ = true;
    if (ok != nullptr) {
        *ok = true;
    }
    const QString number =
        job.engineNumber.isEmpty() ? tr("without an engine number") : job.engineNumber;
    const QString done =
        saved == Journal::Saved::AsCopy
            ? tr("Job %1 had been changed elsewhere meanwhile: saved as a new job.").arg(number)
        : isFinished ? tr("Job %1 saved in the journal.").arg(number)
                     : tr("Job %1 put aside in the journal, unfinished.").arg(number);
    const QString missing = scene_.missing();
    return missing.isEmpty() ? done : done + QLatin1Char(' ') + missing;
}

QString JobDesk::takeForm(const QByteArray& form, qint64 id, int revision, bool isCopy) {
    try {
        const CaseFile file = parse_case(form.toStdString());
        if (file.scene != model_->sceneName().toStdString()) {
            throw InputError("/scene",
                             {CORE_TEXT("core", "must be one of %1"),
                              quoted_list({model_->sceneName().toStdString()})},
                             file.scene);
        }
        replaceJob(isCopy ? 0 : id, isCopy ? 0 : revision, [&] { scene_.take(file, isCopy); });
        return {};
    } catch (const InputError& error) {
        return tr("The job's sheet cannot be read: %1").arg(errorText(error));
    }
}

QString JobDesk::takeJob(qint64 id, bool isCopy) {
    if (!openJournal()) {
        return journalTrouble_;
    }
    const auto job = journal_->job(id);
    if (!job) {
        return journal_->lastError();
    }
    QString trouble = takeForm(job->form, job->id, job->revision, isCopy);
    if (trouble.isEmpty()) {
        Q_EMIT model_->begunAnew();
    }
    return trouble;
}

void JobDesk::flushDraft() {
    draftTimer_.stop();
    if (isWaiting()) {
        draftTimer_.start();
        return;
    }
    if (!draftStale_ || !isOpen() || !model_->hasChanges()) {
        return;
    }
    JournalDraft draft;
    draft.scene = model_->sceneName();
    draft.jobId = jobId_;
    draft.jobRevision = jobRevision_;
    draft.engineNumber = scene_.entry().engineNumber;
    draft.form = formText();
    if (journal_->saveDraft(draft)) {
        draftStale_ = false;
        draftKept_ = true;
    } else if (journal_->wasBusy()) {
        draftTimer_.start();
    } else {
        setJournalTrouble(journal_->lastError());
    }
}

QList<JournalDraft> JobDesk::crashedDrafts() {
    return isOpen() ? journal_->orphanedDrafts(model_->sceneName()) : QList<JournalDraft>();
}

QString JobDesk::restoreDraft(const JournalDraft& draft, bool keepsFile) {
    QString trouble = takeForm(draft.form, draft.jobId, draft.jobRevision, false);
    if (!trouble.isEmpty()) {
        return trouble;
    }
    if (!keepsFile) {
        Q_EMIT model_->begunAnew();
    }
    model_->history()->resetClean();  // not saved yet; the draft is this program's from now on
    draftStale_ = true;
    flushDraft();
    if (draftKept_ && !draftStale_) {
        journal_->discardDraft(draft.session);
    }
    return {};
}

void JobDesk::discardDraft(const QString& session) {
    if (isOpen()) {
        journal_->discardDraft(session);
    }
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

}  // namespace ravnoves
