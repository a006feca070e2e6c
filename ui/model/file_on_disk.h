#pragma once

#include <QByteArray>
#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>
#include <string_view>

namespace ravnoves {

/// Whether a file still holds what was read from it or written to it. It is looked at when the
/// system says that it changed, and when asked for; what counts is the content.
class FileOnDisk : public QObject {
    Q_OBJECT

  public:
    enum class State { Same, Changed, Gone };

    explicit FileOnDisk(QObject* parent = nullptr);

    /// The file was read or written now. Empty: there is none.
    void setPath(const QString& path);
    /// The same with the digest of what was read or written, which others may have changed since.
    void setPath(const QString& path, const QByteArray& known);
    static QByteArray digestOf(std::string_view content);
    const QString& path() const { return path_; }
    /// Of the content known; empty where there is none.
    const QByteArray& digest() const { return known_; }
    State state() const { return state_; }
    /// Looks at the file now.
    State check();
    /// What was found there by the last look is known from now on.
    void accept();

  Q_SIGNALS:
    /// Also where a changed file changed again.
    void stateChanged();

  private:
    void watch();

    QString path_;
    QByteArray known_;
    QByteArray found_;  ///< by the last look; empty where nothing can be read
    State state_ = State::Same;
    QFileSystemWatcher watcher_;
    QTimer settle_;  ///< others write in several steps
};

}  // namespace ravnoves
