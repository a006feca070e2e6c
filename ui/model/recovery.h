#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QList>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QStringList>

#include "case-file/case_context.h"
#include "case-file/case_file.h"
#include "case-file/json.h"

class QTimer;

namespace ravnoves {

class CaseDocument;

/// An unsaved case as the program left it when it ended unexpectedly.
struct RecoveredCase {
    QString file;  ///< that it is kept in
    QDateTime saved;
    QString path;      ///< of the case; empty where it had no file
    QByteArray known;  ///< FileOnDisk::digest() of that file
    CaseContext context;
    Json place;  ///< SceneModel::placeJson()
    CaseFile content;
};

/// The one store for a crash, of cases and jobs alike: every unsaved document is kept in a file of
/// its own while it is open, so that a killed program loses only the changes of the last half
/// second. A job is a case with a place in the journal (SceneModel::placeJson()), and is kept and
/// offered as any other. Each running program locks its files: others use only unlocked ones.
class Recovery : public QObject {
    Q_OBJECT

  public:
    explicit Recovery(const QString& folder = defaultFolder(), QObject* parent = nullptr);

    /// In the user's data folder.
    static QString defaultFolder();
    /// Puts a case there as if a crash had left it: what an older version kept elsewhere.
    /// @throws InputError where it cannot be written
    static void leave(const CaseFile& content, const Json& place,
                      const QString& folder = defaultFolder());

    /// Keeps the document from now on.
    void watch(CaseDocument* document);
    /// Writes it now rather than soon. @return false where it could not be kept
    bool keep(CaseDocument* document);
    /// The document is closed: nothing of it is kept.
    void release(CaseDocument* document);
    /// The program ends as it should: nothing is kept.
    void releaseAll();

    struct Found {
        QList<RecoveredCase> cases;  ///< the newest first, `most` or fewer
        QStringList damaged;         ///< files that it cannot read, where they are now
    };
    static constexpr int maximum = 100;
    /// Files of programs that have ended. No other program is offered them while this one runs. Of
    /// more than `maximum` the older ones stay for a next time.
    Found leftBehind();
    /// It was restored and is kept again, or was discarded.
    static void discard(const RecoveredCase& recovered) { QFile::remove(recovered.file); }

  Q_SIGNALS:
    /// A case cannot be kept, and why; said once.
    void failed(const QString& why);

  private:
    struct Watched {
        QString file;
        QByteArray written;
        QTimer* timer;
    };

    bool isLocked();
    void forget(Watched& watched);
    QString newFile();
    QFileInfoList leftFiles() const;
    /// Of a program that does not run; its lock is removed then.
    bool isLeft(const QString& name) const;

    QString folder_;
    QString session_;
    QLockFile lock_;
    int count_ = 0;
    bool failed_ = false;
    QHash<CaseDocument*, Watched> watched_;
};

}  // namespace ravnoves
