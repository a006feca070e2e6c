#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QHash>
#include <QList>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "case-file/case_context.h"
#include "case-file/case_file.h"
#include "case-file/json.h"
#include "model/worker_thread.h"

class QTimer;

namespace ravnoves {

class CaseDocument;

/// An unsaved case as the program left it when it ended unexpectedly.
struct RecoveredCase {
    QString file;  ///< that it was kept in
    QDateTime saved;
    QString path;      ///< of the case; empty where it had no file
    QByteArray known;  ///< FileOnDisk::digest() of that file
    CaseContext context;
    QString draft;  ///< ScenePage::draftName()
    Json refused;   ///< texts that stood on the page and were refused
    CaseFile content;

    /// By which the cases of one program stand in the order in which they were opened.
    std::pair<QString, int> place() const;
};

/// Keeps every unsaved case in a file of its own while it is open, so that a program that is killed
/// loses what was changed in the last half second. Each running program locks its files: others
/// take over only what nobody holds any more.
class Recovery : public QObject {
    Q_OBJECT

  public:
    explicit Recovery(const QString& folder = defaultFolder(), QObject* parent = nullptr);
    ~Recovery() override;

    /// In the user's data folder.
    static QString defaultFolder();

    /// Keeps the document from now on.
    /// @param draft    asked for RecoveredCase::draft whenever it is written
    /// @param refused  the same for RecoveredCase::refused
    void watch(
        CaseDocument* document, const std::function<QString()>& draft,
        const std::function<Json()>& refused = [] { return Json(); });
    /// Writes it now rather than soon. @return false where it could not be kept
    bool keep(CaseDocument* document);
    /// The document is closed: nothing of it is kept.
    void release(CaseDocument* document);
    /// The program ends as it should: nothing is kept.
    void releaseAll();

    struct Found {
        QList<RecoveredCase> cases;  ///< the newest first
        QStringList damaged;         ///< files that cannot be read, where they lie now
        QStringList newer;           ///< files of a newer program, left to it
    };
    /// What programs have left that run no longer. Nobody else is offered it while this one runs.
    Found leftBehind();
    /// It was restored and is kept anew, or nobody wants it.
    void discard(const RecoveredCase& recovered);

  Q_SIGNALS:
    /// A case cannot be kept, and why; said once.
    void failed(const QString& why);

  private:
    struct Watched {
        QString file;
        QByteArray written;
        QTimer* timer;
        std::function<QString()> draft;
        std::function<Json()> refused;
        bool mayBeWritten = false;  ///< in the thread
    };

    void keepSoon(CaseDocument* document);
    std::optional<Json> contentOf(CaseDocument* document, const Watched& watched);
    void forget(Watched& watched);
    void tellFailed(const QString& why);
    enum class Lock { Ours, Others, Failed };
    Lock lock(const QString& session);
    QStringList filesOf(const QString& session) const;

    QString folder_;
    QString session_;
    int count_ = 0;
    bool failed_ = false;
    std::map<QString, std::unique_ptr<QLockFile>> locks_;  ///< by session
    QHash<CaseDocument*, Watched> watched_;
    WorkerThread writer_;  ///< of cases that take long to write
};

}  // namespace ravnoves
