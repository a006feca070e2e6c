#include "workshop/model/journal_writer.h"

#include <exception>
#include <utility>

#include "text/error_text.h"

namespace ravnoves {

JournalWriter::JournalWriter(const QString& path, const QString& session, QObject* parent)
    : QObject(parent), path_(path), session_(session) {}

JournalWriter::~JournalWriter() {
    giveUp_ = true;
    worker_.begin([this]() -> WorkerThread::Telling {
        journal_.reset();  // a connection ends in the thread where it began
        return nullptr;
    });
}

Journal& JournalWriter::opened() {
    if (!journal_) {
        journal_.emplace(path_);
        journal_->writeFor(session_, &giveUp_);
        connect(
            &*journal_, &Journal::waits, this, [this] { worker_.post([this] { Q_EMIT waits(); }); },
            Qt::DirectConnection);
        connect(
            &*journal_, &Journal::reopened, this,
            [this](const QString& message) {
                worker_.post([this, message] { Q_EMIT reopened(message); });
            },
            Qt::DirectConnection);
    }
    if (!journal_->isOpen()) {
        journal_->open();
    }
    return *journal_;
}

void JournalWriter::open(OpenTold told) {
    worker_.begin([this, told = std::move(told)]() -> WorkerThread::Telling {
        bool isOpen = false;
        bool isBusy = false;
        QString said;
        try {
            const Journal& journal = opened();
            isOpen = journal.isOpen();
            isBusy = journal.wasBusy();
            said = isOpen ? journal.openMessage() : journal.lastError();
        } catch (...) {
            said = errorText(std::current_exception());
        }
        return [told, isOpen, isBusy, said] { told(isOpen, isBusy, said); };
    });
}

void JournalWriter::saveJob(const JournalJob& job, bool endsDraft, JobTold told) {
    worker_.begin([this, job, endsDraft, told = std::move(told)]() -> WorkerThread::Telling {
        JournalJob written = job;
        Journal::Saved saved = Journal::Saved::No;
        QString why;
        try {
            Journal& journal = opened();
            if (journal.isOpen()) {
                saved = journal.save(written);
            }
            why = journal.lastError();
            if (saved != Journal::Saved::No && endsDraft) {
                journal.discardDraft(session_);
            }
        } catch (...) {
            why = errorText(std::current_exception());
        }
        return [told, saved, written, why] { told(saved, written, why); };
    });
}

void JournalWriter::saveDraft(const JournalDraft& draft, DraftTold told) {
    worker_.begin([this, draft, told = std::move(told)]() -> WorkerThread::Telling {
        Kept kept = Kept::No;
        QString why;
        try {
            Journal& journal = opened();
            if (journal.isOpen() && journal.saveDraft(draft)) {
                kept = Kept::Yes;
            } else {
                kept = journal.wasBusy() ? Kept::Busy : Kept::No;
                why = journal.lastError();
            }
        } catch (...) {
            why = errorText(std::current_exception());
        }
        return [told, kept, why] { told(kept, why); };
    });
}

void JournalWriter::discardDraft(const QString& session) {
    worker_.begin([this, session]() -> WorkerThread::Telling {
        try {
            opened().discardDraft(session);
        } catch (...) {
            // It is offered once more.
        }
        return nullptr;
    });
}

}  // namespace ravnoves
