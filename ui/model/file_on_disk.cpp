#include "model/file_on_disk.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <new>
#include <utility>

#include "case-file/input_error.h"
#include "case-file/text_file.h"
#include "text/file_path.h"

namespace ravnoves {

namespace {

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

QByteArray FileOnDisk::digestOf(std::string_view content) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(QByteArray::fromRawData(content.data(), static_cast<qsizetype>(content.size())));
    return hash.result();
}

bool FileOnDisk::setPath(const QString& path, const std::optional<QByteArray>& known) {
    path_ = path;
    known_ = known || path.isEmpty() ? known.value_or(QByteArray()) : digestNow(path);
    return check();
}

bool FileOnDisk::check() {
    State now = State::Same;
    QByteArray found;
    if (!path_.isEmpty()) {
        found = digestNow(path_);
        now = found == known_            ? State::Same
              : !found.isEmpty()         ? State::Changed
              : QFileInfo::exists(path_) ? State::Same  // it cannot be read now
                                         : State::Missing;
    }
    const bool changedAgain = now == State::Changed && found != found_;
    found_ = found;
    return std::exchange(state_, now) != now || changedAgain;
}

bool FileOnDisk::accept() {
    known_ = found_;
    return check();
}

}  // namespace ravnoves
