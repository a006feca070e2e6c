#include "model/file_on_disk.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <new>

#include "case-file/input_error.h"
#include "case-file/text_file.h"
#include "text/file_path.h"

namespace ravnoves {

namespace {

constexpr int settleTime = 150;  // ms

/// Empty where nothing is there, or it cannot be read or held; a pipe, which is never opened, or a
/// folder is like no file's content.
QByteArray digestNow(const QString& path) {
    try {
        return FileOnDisk::digestOf(read_text_file(fsPath(path)));
    } catch (const InputError&) {
        const QFileInfo info(path);
        return info.exists() && !info.isFile() ? QByteArrayLiteral("no file") : QByteArray();
    } catch (const std::bad_alloc&) {
        return {};
    }
}

}  // namespace

FileOnDisk::FileOnDisk(QObject* parent) : QObject(parent) {
    settle_.setSingleShot(true);
    settle_.setInterval(settleTime);
    connect(&settle_, &QTimer::timeout, this, &FileOnDisk::check);
    const auto look = [this] { settle_.start(); };
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, look);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, look);
}

QByteArray FileOnDisk::digestOf(std::string_view content) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(QByteArray::fromRawData(content.data(), static_cast<qsizetype>(content.size())));
    return hash.result();
}

void FileOnDisk::setPath(const QString& path) {
    setPath(path, path.isEmpty() ? QByteArray() : digestNow(path));
}

void FileOnDisk::setPath(const QString& path, const QByteArray& known) {
    if (path != path_) {
        const QStringList watched = watcher_.files() + watcher_.directories();
        if (!watched.isEmpty()) {
            watcher_.removePaths(watched);
        }
        path_ = path;
    }
    known_ = known;
    check();
}

void FileOnDisk::watch() {
    // A file that is replaced is watched no longer; its folder tells of the new one.
    for (const QString& each : {path_, QFileInfo(path_).absolutePath()}) {
        if (!watcher_.files().contains(each) && !watcher_.directories().contains(each) &&
            QFileInfo::exists(each)) {
            watcher_.addPath(each);
        }
    }
}

FileOnDisk::State FileOnDisk::check() {
    State now = State::Same;
    QByteArray found;
    if (!path_.isEmpty()) {
        watch();
        found = digestNow(path_);
        now = found == known_            ? State::Same
              : !found.isEmpty()         ? State::Changed
              : QFileInfo::exists(path_) ? State::Same  // it cannot be read now
                                         : State::Missing;
    }
    const bool changedAgain = now == State::Changed && found != found_;
    found_ = found;
    if (now != state_ || changedAgain) {
        state_ = now;
        Q_EMIT stateChanged();
    }
    return state_;
}

void FileOnDisk::accept() {
    known_ = found_;
    check();
}

}  // namespace ravnoves
