#include "model/recovery.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTimer>
#include <QUuid>
#include <algorithm>
#include <utility>

#include "case-file/input_error.h"
#include "case-file/text_file.h"
#include "model/case_document.h"
#include "scenes/scenes.h"
#include "text/error_text.h"
#include "text/file_path.h"

namespace ravnoves {

namespace {

constexpr int keepDelay = 400;  // ms
constexpr int sessionLength = 32;
const QString keptEnding = QStringLiteral(".json");
const QString lockEnding = QStringLiteral(".lock");
const QString damagedEnding = QStringLiteral(".damaged");

QString keptText(const Json& json, const char* key) {
    return QString::fromStdString(json.value(key, std::string()));
}

/// A case that only a newer program can read.
struct NewerCase : std::exception {};

/// @throws InputError, Json::exception for a file that is none of ours, NewerCase
RecoveredCase readKept(const QString& file) {
    const Json json = parse_json(read_text_file(fsPath(file)));
    if (json.at("case").value("version", 0) > case_version) {
        throw NewerCase();
    }
    RecoveredCase kept;
    kept.file = file;
    kept.saved = QFileInfo(file).lastModified();
    kept.content = read_case(json.at("case"));
    kept.path = keptText(json, "path");
    kept.known = QByteArray::fromHex(keptText(json, "known").toLatin1());
    kept.context = {fsPath(keptText(json, "directory"))};
    kept.draft = keptText(json, "draft");
    return kept;
}

}  // namespace

Recovery::Recovery(const QString& folder, QObject* parent)
    : QObject(parent), folder_(folder), session_(QUuid::createUuid().toString(QUuid::Id128)) {
    lock(session_);  // else keep() tries again
}

Recovery::~Recovery() = default;

QString Recovery::defaultFolder() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
        .filePath(QStringLiteral("recovery"));
}

Recovery::Lock Recovery::lock(const QString& session) {
    if (locks_.count(session) > 0) {
        return Lock::Ours;
    }
    QDir().mkpath(folder_);
    auto file = std::make_unique<QLockFile>(QDir(folder_).filePath(session + lockEnding));
    file->setStaleLockTime(0);
    if (!file->tryLock(0)) {
        return file->error() == QLockFile::LockFailedError ? Lock::Others : Lock::Failed;
    }
    locks_[session] = std::move(file);
    return Lock::Ours;
}

QStringList Recovery::filesOf(const QString& session) const {
    QStringList files;
    const QDir folder(folder_);
    for (const QString& name :
         folder.entryList({session + QLatin1Char('*') + keptEnding}, QDir::Files)) {
        files << folder.filePath(name);
    }
    return files;
}

// ------------------------------------------------------------------------------------ keeping

void Recovery::watch(CaseDocument* document, const std::function<QString()>& draft) {
    if (watched_.contains(document) || !document->model()->hasCaseFile()) {
        return;
    }
    auto* timer = new QTimer(this);
    timer->setSingleShot(true);
    timer->setInterval(keepDelay);
    connect(timer, &QTimer::timeout, this, [this, document] { keep(document); });
    const QString name = session_ + QStringLiteral("-%1").arg(++count_) + keptEnding;
    watched_.insert(document, {QDir(folder_).filePath(name), {}, timer, draft});
    // Not restarted by further changes: the first waits no longer than the delay.
    const auto later = [timer] {
        if (!timer->isActive()) {
            timer->start();
        }
    };
    connect(document->model(), &SceneModel::changed, timer, later);
    connect(document->model(), &SceneModel::historyChanged, timer, later);
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
    const SceneModel& model = *document->model();
    Json json = {{"case", write_case(document->asFile())},
                 {"path", document->path().toStdString()},
                 {"known", document->disk().digest().toHex().toStdString()},
                 {"directory", model.context().directory.string()},
                 {"draft", found->draft().toStdString()}};
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    const QByteArray bytes = QByteArray::fromStdString(text);
    if (bytes == found->written) {
        return true;
    }
    try {
        CaseDocument::checkReadable(text);
        // Without the lock another program would take the case for one that a crash has left.
        if (lock(session_) == Lock::Ours) {
            write_text_file(fsPath(found->file), text);
            found->written = bytes;
            return true;
        }
        tellFailed(tr("%1 cannot be written to").arg(folder_));
    } catch (const InputError& error) {
        tellFailed(errorText(error));
    }
    return false;
}

void Recovery::tellFailed(const QString& why) {
    if (!std::exchange(failed_, true)) {
        Q_EMIT failed(tr("Unsaved changes are not kept for a crash: %1").arg(why));
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

Recovery::Found Recovery::leftBehind() {
    Found found;
    const QDir folder(folder_);
    QStringList sessions;
    for (const QString& name : folder.entryList(
             {QLatin1Char('*') + keptEnding, QLatin1Char('*') + lockEnding}, QDir::Files)) {
        sessions << name.left(sessionLength);
    }
    sessions.removeDuplicates();
    sessions.removeAll(session_);
    for (const QString& session : sessions) {
        if (lock(session) == Lock::Others) {
            continue;  // that program runs
        }
        for (const QString& file : filesOf(session)) {
            try {
                found.cases << readKept(file);
            } catch (const NewerCase&) {
                found.newer << file;
            } catch (const std::exception&) {
                const QString aside = file + damagedEnding;
                QFile::remove(aside);
                found.damaged << (QFile::rename(file, aside) ? aside : file);
            }
        }
        if (filesOf(session).isEmpty()) {
            locks_.erase(session);
        }
    }
    std::sort(found.cases.begin(), found.cases.end(),
              [](const RecoveredCase& a, const RecoveredCase& b) { return a.saved > b.saved; });
    return found;
}

void Recovery::discard(const RecoveredCase& recovered) {
    QFile::remove(recovered.file);
    const QString session = QFileInfo(recovered.file).fileName().left(sessionLength);
    if (session != session_ && filesOf(session).isEmpty()) {
        locks_.erase(session);
    }
}

}  // namespace ravnoves
