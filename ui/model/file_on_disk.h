#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <string_view>

namespace ravnoves {

/// Whether a file is unchanged since it was read or written here. It is checked on demand: when the
/// window comes to the front, and before it is written or closed; the content decides.
class FileOnDisk : public QObject {
    Q_OBJECT

  public:
    enum class State { Same, Changed, Missing };

    using QObject::QObject;

    /// The file was read or written. Empty: no file.
    /// @param known  digest of these contents, which others may have changed since; empty: of the
    ///               present ones
    void setPath(const QString& path, const QByteArray& known = {});
    static QByteArray digestOf(std::string_view content);
    const QString& path() const { return path_; }
    /// Of the known content; empty without one.
    const QByteArray& digest() const { return known_; }
    State state() const { return state_; }
    /// Looks at the file now.
    State check();
    /// Accepts the contents found by the last check.
    void accept();

  Q_SIGNALS:
    /// Also where a changed file changed again.
    void stateChanged();

  private:
    QString path_;
    QByteArray known_;
    QByteArray found_;  ///< by the last look; empty where nothing can be read
    State state_ = State::Same;
};

}  // namespace ravnoves
