#include "model/file_on_disk.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

namespace ravnoves {

namespace {

constexpr int settleTime = 150;  // ms

QByteArray digestOf(const QString& path) {
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    return QFileInfo(path).isFile() && file.open(QIODevice::ReadOnly) && hash.addData(&file)
               ? hash.result()
               : QByteArray();
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

void FileOnDisk::setPath(const QString& path) {
    setPath(path, path.isEmpty() ? QByteArray() : digestOf(path));
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
    if (!path_.isEmpty()) {
        watch();
        const QByteArray found = digestOf(path_);
        now = found == known_            ? State::Same
              : !found.isEmpty()         ? State::Changed
              : QFileInfo::exists(path_) ? State::Same  // it cannot be read now
                                         : State::Gone;
    }
    if (now != state_) {
        state_ = now;
        Q_EMIT stateChanged();
    }
    return state_;
}

void FileOnDisk::accept() {
    known_ = digestOf(path_);
    check();
}

}  // namespace ravnoves
