#include "model/recovery.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTimer>
#include <QUuid>
#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <utility>

#include "case-file/input_error.h"
#include "case-file/json.h"
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

/// Also for what stands in a dialog that is still open, or is refused.
bool needsKeeping(const CaseDocument& document) {
    return document.needsSaving() || document.model()->hasTyping() ||
           document.model()->newestRefused() != nullptr;
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
    kept.refused = json.value("refused", Json());
    return kept;
}

}  // namespace

std::pair<QString, int> RecoveredCase::place() const {
    const QString name = QFileInfo(file).completeBaseName();
    return {name.left(sessionLength), name.section(QLatin1Char('-'), 1).toInt()};
}

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

void Recovery::watch(CaseDocument* document, const std::function<QString()>& draft,
                     const std::function<Json()>& refused) {
    if (watched_.contains(document) || !document->model()->hasCaseFile()) {
        return;
    }
    auto* timer = new QTimer(this);
    timer->setSingleShot(true);
    timer->setInterval(keepDelay);
    connect(timer, &QTimer::timeout, this, [this, document] { keepSoon(document); });
    const QString name = session_ + QStringLiteral("-%1").arg(++count_) + keptEnding;
    watched_.insert(document, {QDir(folder_).filePath(name), {}, timer, draft, refused});
    // Not restarted by further changes: the first waits no longer than the delay.
    const auto later = [timer] {
        if (!timer->isActive()) {
            timer->start();
        }
    };
    connect(document->model(), &SceneModel::changed, timer, later);
    connect(document->model(), &SceneModel::historyChanged, timer, later);
    connect(document->model(), &SceneModel::typingChanged, timer, later);
    connect(document->model(), &SceneModel::refusedInChanged, timer, later);
    connect(document, &CaseDocument::nameChanged, timer, [this, document, later] {
        if (document->needsSaving()) {
            later();
        } else {
            keep(document);  // saved: at once
        }
    });
    later();
}

namespace {

constexpr int writeWait = 60'000;  ///< ms, for a text that is being written

/// The text, unless it is that which was written. @throws InputError where it cannot be kept
std::optional<QByteArray> write(const Json& content, const QString& file,
                                const QByteArray& written) {
    const std::string text = content.dump(-1, ' ', false, Json::error_handler_t::replace);
    QByteArray bytes = QByteArray::fromStdString(text);
    if (bytes == written) {
        return std::nullopt;
    }
    CaseDocument::checkReadable(text);
    write_text_file(fsPath(file), text);
    return bytes;
}

}  // namespace

/// Nothing where the document needs no saving, or another program would take it for its own.
std::optional<Json> Recovery::contentOf(CaseDocument* document, const Watched& watched) {
    // Without the lock another program would take the case for one that a crash has left.
    if (lock(session_) != Lock::Ours) {
        tellFailed(tr("%1 cannot be written to").arg(folder_));
        return std::nullopt;
    }
    Json content{{"case", write_case(document->model()->draftFile())},
                 {"path", document->path().toStdString()},
                 {"known", document->disk().digest().toHex().toStdString()},
                 {"directory", document->model()->context().directory.string()},
                 {"draft", watched.draft().toStdString()}};
    if (Json refused = watched.refused(); !refused.is_null()) {
        content["refused"] = std::move(refused);
    }
    return content;
}

bool Recovery::keep(CaseDocument* document) {
    const auto found = watched_.find(document);
    if (found == watched_.end()) {
        return false;
    }
    if (!needsKeeping(*document)) {
        forget(*found);
        return true;
    }
    const auto content = contentOf(document, *found);
    if (!content) {
        return false;
    }
    writer_.wait(writeWait);
    try {
        if (auto written = write(*content, found->file, found->written)) {
            found->written = *std::move(written);
        }
        return true;
    } catch (const InputError& error) {
        tellFailed(errorText(error));
    }
    return false;
}

/// In a thread, where the case is large.
void Recovery::keepSoon(CaseDocument* document) {
    const auto found = watched_.find(document);
    if (found == watched_.end() || !needsKeeping(*document) || !document->model()->isLarge()) {
        keep(document);
        return;
    }
    auto content = contentOf(document, *found);
    if (!content) {
        return;
    }
    found->mayBeWritten = true;
    writer_.begin(
        [this, document, file = found->file, before = found->written,
         content = std::make_shared<Json>(*std::move(content))]() mutable -> WorkerThread::Telling {
            try {
                const auto written = write(*content, file, before);
                content.reset();
                return [this, document, written] {
                    const auto there = watched_.find(document);
                    if (written && there != watched_.end() && there->mayBeWritten) {
                        there->written = *written;
                    }
                };
            } catch (...) {
                return [this, thrown = std::current_exception()] { tellFailed(errorText(thrown)); };
            }
        });
}

void Recovery::tellFailed(const QString& why) {
    if (!std::exchange(failed_, true)) {
        Q_EMIT failed(tr("Unsaved changes are not kept for a crash: %1").arg(why));
    }
}

void Recovery::forget(Watched& watched) {
    watched.timer->stop();
    if (watched.mayBeWritten) {
        writer_.wait(writeWait);
    }
    if (!watched.written.isEmpty() || watched.mayBeWritten) {
        QFile::remove(watched.file);
        watched.written.clear();
        watched.mayBeWritten = false;
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
