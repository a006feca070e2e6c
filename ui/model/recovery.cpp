#include "model/recovery.h"

#include <QDir>
#include <QStandardPaths>
#include <QTimer>
#include <QUuid>
#include <algorithm>
#include <exception>
#include <new>

#include "case-file/input_error.h"
#include "case-file/text_file.h"
#include "model/case_document.h"
#include "scenes/scenes.h"
#include "text/error_text.h"
#include "text/file_path.h"
#include "workshop/older_formats.h"

namespace ravnoves {

namespace {

constexpr int keepDelay = 400;  // ms
constexpr int sessionLength = 32;
const QString keptEnding = QStringLiteral(".json");
const QString lockEnding = QStringLiteral(".lock");
const QString damagedEnding = QStringLiteral(".damaged");

QString newSession() {
    return QUuid::createUuid().toString(QUuid::Id128);
}

QString keptText(const Json& json, const char* key) {
    return QString::fromStdString(json.value(key, std::string()));
}

std::string textOf(const Json& content) {
    return content.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// @throws InputError, Json::exception for a file that is none of ours
RecoveredCase readKept(const QString& file) {
    const Json json = parse_json(read_text_file(fsPath(file)));
    RecoveredCase kept;
    kept.content = workshop::as_job(read_case(json.at("case")));
    kept.path = keptText(json, "path");
    kept.known = QByteArray::fromHex(keptText(json, "known").toLatin1());
    kept.context = {fsPath(keptText(json, "directory"))};
    kept.place = json.value("place", Json());
    return kept;
}

}  // namespace

Recovery::Recovery(const QString& folder, QObject* parent)
    : QObject(parent),
      folder_(folder),
      session_(newSession()),
      lock_(QDir(folder).filePath(session_ + lockEnding)) {
    lock_.setStaleLockTime(0);
    isLocked();  // else keep() tries again
}

bool Recovery::isLocked() {
    return lock_.isLocked() || (QDir().mkpath(folder_) && lock_.tryLock(0));
}

QString Recovery::defaultFolder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
        .filePath(QStringLiteral("recovery"));
}

void Recovery::leave(const CaseFile& content, const Json& place, const QString& folder) {
    QDir().mkpath(folder);
    write_text_file(
        fsPath(QDir(folder).filePath(newSession() + QStringLiteral("-0001") + keptEnding)),
        textOf({{"case", write_case(content)}, {"place", place}}));
}

QString Recovery::newFile() {
    return QDir(folder_).filePath(
        session_ + QStringLiteral("-%1").arg(++count_, 4, 10, QLatin1Char('0')) + keptEnding);
}

// ------------------------------------------------------------------------------------ keeping

void Recovery::watch(CaseDocument* document) {
    if (watched_.contains(document) || !document->model()->hasCaseFile()) {
        return;
    }
    auto* timer = new QTimer(this);
    timer->setSingleShot(true);
    timer->setInterval(keepDelay);
    connect(timer, &QTimer::timeout, this, [this, document] { keep(document); });
    watched_.insert(document, {newFile(), {}, timer});
    // Not restarted by further changes: the first waits no longer than the delay.
    const auto later = [timer] {
        if (!timer->isActive()) {
            timer->start();
        }
    };
    connect(document->model(), &SceneModel::changed, timer, later);
    connect(document->model(), &SceneModel::historyChanged, timer, later);
    connect(document->model(), &SceneModel::rejectedInChanged, timer, later);
    connect(document, &CaseDocument::nameChanged, timer, [this, document, later] {
        if (document->needsSaving()) {
            later();
        } else {
            keep(document);  // saved: at once
        }
    });
    later();
}

bool Recovery::keep(CaseDocument* document) {
    const auto found = watched_.find(document);
    if (found == watched_.end()) {
        return false;
    }
    if (!document->needsSaving()) {
        forget(*found);
        return true;
    }
    const auto fail = [this](const QString& why) {
        if (!failed_) {
            failed_ = true;
            Q_EMIT failed(tr("Unsaved changes are not protected against a crash: %1").arg(why));
        }
        return false;
    };
    try {
        CaseFile file = document->model()->caseFile();
        document->model()->leaveOutRejected(file.input);
        const std::string text =
            textOf({{"case", write_case(file)},
                    {"path", document->path().toStdString()},
                    {"known", document->disk().digest().toHex().toStdString()},
                    {"directory", document->model()->context().directory.string()},
                    {"place", document->model()->placeJson()}});
        QByteArray bytes = QByteArray::fromStdString(text);
        if (bytes == found->written) {
            return true;
        }
        check_text_size(text.size());
        // Without the lock another program would take the case for one that a crash has left.
        if (!isLocked()) {
            return fail(tr("%1 is not writable").arg(folder_));
        }
        write_text_file(fsPath(found->file), text);
        found->written = std::move(bytes);
        return true;
    } catch (const InputError& error) {
        return fail(errorText(error));
    } catch (const std::bad_alloc&) {
        return fail(errorText(std::current_exception()));
    }
}

void Recovery::forget(Watched& watched) {
    watched.timer->stop();
    if (!watched.written.isEmpty()) {
        QFile::remove(watched.file);
        watched.written.clear();
    }
}

void Recovery::release(CaseDocument* document) {
    const auto found = watched_.find(document);
    if (found != watched_.end()) {
        forget(*found);
        delete found->timer;
        watched_.erase(found);
    }
}

void Recovery::releaseAll() {
    for (CaseDocument* document : watched_.keys()) {
        release(document);
    }
}

// ---------------------------------------------------------------------------------- taking over

/// Of programs that run, too; the newest first.
QFileInfoList Recovery::leftFiles() const {
    QFileInfoList files =
        QDir(folder_).entryInfoList({QLatin1Char('*') + keptEnding}, QDir::Files, QDir::Time);
    files.removeIf([this](const QFileInfo& file) {
        return std::any_of(watched_.begin(), watched_.end(),
                           [&](const Watched& each) { return each.file == file.filePath(); });
    });
    return files;
}

bool Recovery::isLeft(const QString& name) const {
    const QString session = name.left(sessionLength);
    if (session == session_) {
        return true;
    }
    const QString path = QDir(folder_).filePath(session + lockEnding);
    QLockFile lock(path);
    lock.setStaleLockTime(0);
    // Where nothing can be written it cannot be locked: nobody has it all the same.
    return lock.tryLock(0) || lock.error() != QLockFile::LockFailedError;
}

/// Takes the files over under names of its own, so that no other lock has to be held.
Recovery::Found Recovery::leftBehind() {
    Found found;
    const QDir folder(folder_);
    // Those that killed programs have left go with it.
    for (const QString& name : folder.entryList({QLatin1Char('*') + lockEnding}).mid(0, maximum)) {
        isLeft(name);
    }
    isLocked();
    int files = 0;
    for (const QFileInfo& left : leftFiles()) {
        if (files >= maximum) {
            break;
        }
        if (!isLeft(left.fileName())) {
            continue;  // that program runs
        }
        ++files;
        QString file = newFile();
        const QDateTime saved = left.lastModified();  // asked of the file, while it has this name
        if (!QFile::rename(left.filePath(), file)) {
            if (!QFile::exists(left.filePath())) {
                continue;  // another program was faster
            }
            file = left.filePath();
        }
        try {
            RecoveredCase kept = readKept(file);
            kept.file = file;
            kept.saved = saved;
            found.cases << std::move(kept);
        } catch (const std::bad_alloc&) {
            QFile::rename(file, left.filePath());  // whole, for a machine that has the memory
        } catch (const std::exception&) {
            const QString aside = file + damagedEnding;
            found.damaged << (QFile::rename(file, aside) ? aside : file);
        }
    }
    return found;
}

}  // namespace ravnoves
