// The job's place in the journal: saved, opened, copied, kept as a draft.

#include <QDate>
#include <QSettings>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "scenes/scenes.h"
#include "text/error_text.h"
#include "v8-plugs/fields.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/scene.h"

namespace ravnoves {

using namespace v8_plugs;

namespace {
using units::gram;
}

void V8PlugsModel::setJournalTrouble(const QString& text) {
    if (text != journalTrouble_) {
        journalTrouble_ = text;
        Q_EMIT journalTroubleChanged(text);
    }
}

bool V8PlugsModel::openJournal() {
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

QByteArray V8PlugsModel::formText() const {
    return QByteArray::fromStdString(
        write_case({sceneName().toStdString(), title().toStdString(), inputJson()}).dump());
}

JournalJob V8PlugsModel::journalJob() const {
    JournalJob job;
    job.id = jobId_;
    job.revision = jobRevision_;
    job.engineNumber = QString::fromStdString(input().job.engine_number);
    job.customer = QString::fromStdString(input().job.customer);
    job.technician = QString::fromStdString(input().job.technician);
    job.engine = QString::fromStdString(input().engine.name);
    job.date = QDate::fromString(QString::fromStdString(input().job.date), Qt::ISODate);
    const std::string process(process_words[static_cast<std::size_t>(input().process)].word);
    job.process = QString::fromStdString(process);
    if (solution().unbalanced_mass) {
        job.unbalancedMass = *solution().unbalanced_mass / gram;
    }
    if (solution().advice) {
        if (solution().advice->kind == Advice::Kind::none_needed) {
            job.recommended = QStringLiteral("none-needed");
        } else if (solution().advice->kind == Advice::Kind::option) {
            const Option& option = *solution().advice->option;
            job.recommended = QString::fromStdString(std::string(option_word(option.id).word));
            job.reduction = option.reduction / gram;
            if (const auto& weights = solution().bob_weights[index(option.id)]) {
                job.bobWeight = weights->after.sum() / gram;
            }
        }
    }
    job.form = formText();
    return job;
}

QString V8PlugsModel::saveJob(bool* ok) {
    if (ok != nullptr) {
        *ok = false;
    }
    if (jobId_ == 0 && !hasChanges() && !input().changes_known()) {
        return tr("The sheet is empty: nothing is saved.") + QLatin1Char(' ') + adviceText();
    }
    if (!openJournal()) {
        return journalTrouble_.isEmpty() ? tr("There is no journal.") : journalTrouble_;
    }
    keepTyped();
    JournalJob job = journalJob();
    const Journal::Saved saved = journal_->save(job);
    if (saved == Journal::Saved::No) {
        setJournalTrouble(journal_->lastError());
        return journal_->lastError();
    }
    putJobId(job.id, job.revision);
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
    const QString done =
        saved == Journal::Saved::AsCopy
            ? tr("Job %1 had been changed elsewhere meanwhile: saved as a new job.").arg(number)
            : tr("Job %1 saved in the journal.").arg(number);
    return solution().advice ? done : done + QLatin1Char(' ') + adviceText();
}

QString V8PlugsModel::takeForm(const QByteArray& form, qint64 id, int revision, bool copy) {
    try {
        const CaseFile file = parse_case(form.toStdString());
        if (file.scene != sceneName().toStdString()) {
            throw InputError("/scene",
                             {CORE_TEXT("core", "must be one of %1"), quoted_list({"v8-plugs"})},
                             file.scene);
        }
        Input next = read_input(file.input, Completeness::as_is);
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
        takeJob(next, QString::fromStdString(file.title), copy ? 0 : id, copy ? 0 : revision);
        return {};
    } catch (const InputError& error) {
        return tr("The job's sheet cannot be read: %1").arg(errorText(error));
    }
}

QString V8PlugsModel::openJob(qint64 id) {
    if (!openJournal()) {
        return journalTrouble_;
    }
    const auto job = journal_->job(id);
    if (!job) {
        return journal_->lastError();
    }
    return takeForm(job->form, job->id, job->revision, false);
}

QString V8PlugsModel::copyJob(qint64 id) {
    if (!openJournal()) {
        return journalTrouble_;
    }
    const auto job = journal_->job(id);
    if (!job) {
        return journal_->lastError();
    }
    return takeForm(job->form, 0, 0, true);
}

void V8PlugsModel::flushDraft() {
    draftTimer_.stop();
    if (!draftStale_ || !journal_ || !journal_->isOpen() || !hasChanges()) {
        return;
    }
    JournalDraft draft;
    draft.jobId = jobId_;
    draft.jobRevision = jobRevision_;
    draft.engineNumber = QString::fromStdString(input().job.engine_number);
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

QList<JournalDraft> V8PlugsModel::crashedDrafts() {
    return journal_ && journal_->isOpen() ? journal_->orphanedDrafts() : QList<JournalDraft>();
}

QString V8PlugsModel::restoreDraft(const JournalDraft& draft) {
    QString trouble = takeForm(draft.form, draft.jobId, draft.jobRevision, false);
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

void V8PlugsModel::discardDraft(const QString& session) {
    if (journal_ && journal_->isOpen()) {
        journal_->discardDraft(session);
    }
}

void V8PlugsModel::setCardLanguage(const QString& code) {
    cardLanguage_ = code;
    if (!journalPath_.isEmpty()) {
        QSettings().setValue(QStringLiteral("v8-plugs/card-language"), code);
    }
}

Words V8PlugsModel::cardWords() const {
    return cardLanguage_.isEmpty() ? Words() : Words(cardLanguage_);
}

}  // namespace ravnoves
