#pragma once

#include <QByteArray>
#include <QString>
#include <optional>
#include <string_view>

namespace ravnoves {

/// Whether a file is unchanged since it was read or written here. It is checked on demand: when the
/// window comes to the front, and before it is written or closed; the content decides.
class FileOnDisk {
  public:
    enum class State { Same, Changed, Missing };

    /// The file was read or written. Empty: no file.
    /// @param known  digest of these contents, which others may have changed since, empty of a file
    ///               that was missing; without one: of the present contents
    /// @return as check()
    bool setPath(const QString& path, const std::optional<QByteArray>& known = std::nullopt);
    static QByteArray digestOf(std::string_view content);
    const QString& path() const { return path_; }
    /// Of the known content; empty without one.
    const QByteArray& digest() const { return known_; }
    State state() const { return state_; }
    bool isSame() const { return state_ == State::Same; }
    /// Looks at the file now. @return whether its state is another, or it changed again
    bool check();
    /// Accepts the contents found by the last check. @return as check()
    bool accept();

  private:
    QString path_;
    QByteArray known_;
    QByteArray found_;  ///< by the last look; empty where nothing can be read
    State state_ = State::Same;
};

}  // namespace ravnoves
