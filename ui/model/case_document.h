#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <string>
#include <vector>

#include "model/file_on_disk.h"
#include "model/scene_model.h"

namespace ravnoves {

struct CaseFile;
class InputError;
struct RecoveredCase;

/// Why nothing but a case may be written to this file: it is an open case, or one that an open
/// case reads. Empty where it is neither.
QString sourceTrouble(const QString& path);

/// A case between its file and its model: its origin, and whether it has to be saved. Title,
/// history and the folder of its files are the model's; `Documents` asks the user.
class CaseDocument : public QObject {
    Q_OBJECT

  public:
    /// The model outlives the document.
    explicit CaseDocument(SceneModel* model, QObject* parent = nullptr);
    ~CaseDocument() override;

    SceneModel* model() const { return model_; }
    /// Of the file, absolute; empty without one.
    QString path() const { return path_; }
    /// The file's name, else what its job is known by, else the case's title; may be empty.
    QString name() const;
    /// Also a case whose file is missing, or no case file any more: this is the last copy.
    bool needsSaving() const { return model_->hasChanges() || isLastCopy_; }
    /// Where it may be saved as: its file, or one by its job or scene.
    QString proposedPath() const;
    /// Whether the document of a model has a file.
    static bool hasFile(const SceneModel& model);
    /// The text of its case for a path, from where files are named; empty: for none.
    /// @throws InputError
    std::string asText(const QString& path) const;
    /// Whether this is a file that the case names, in its present state or as its own file has it.
    bool names(const QString& path) const;

    /// A case file, not yet checked by its scene.
    /// @param digest  is set to the FileOnDisk::digest() of the contents
    /// @throws InputError
    static CaseFile read(const QString& path, QByteArray* digest = nullptr);
    /// Adopts the file that read() found at the path, or a case without a file, with a new history.
    /// A fault leaves all unchanged.
    /// @param known  the digest of read(); empty: of the path's present contents
    /// @throws InputError
    void open(const CaseFile& file, const QString& path, const QByteArray& known = {});
    void begin(const CaseFile& file);
    /// Where the case names the file that open() could not read; null where something else is
    /// wrong, with the name itself, too.
    static Json* fileNamedAt(CaseFile& file, const InputError& error);
    /// Adopts an unsaved case, with its file and its place, and needs saving.
    /// @param file  its content, possibly converted
    /// @throws InputError
    void restore(const CaseFile& file, const RecoveredCase& from);
    /// @return an empty string, or the fault with the file's name
    QString saveTo(const QString& path);

    /// The file, as others may change it.
    const FileOnDisk& disk() const { return disk_; }
    /// Its file, else the first of the files that it reads (CSV), that others have changed or
    /// deleted since; null where all are as they were.
    const FileOnDisk* changedFile() const;
    bool isOwn(const FileOnDisk* file) const { return file == &disk_; }
    /// Looks at all of them now.
    void checkFiles();
    /// Adopts the present contents of the changed file, else of its own, as one step of the
    /// history.
    /// @return an empty string, or the fault with the file's name
    QString reload();
    /// Keeps this case, whatever others did to that file. It needs saving where it was its own.
    void keepMine();

    /// The case files last opened or saved, the newest first.
    static QStringList recentPaths();

  Q_SIGNALS:
    /// name() or needsSaving() is another.
    void nameChanged();
    /// changedFile() is another, or changed again.
    void filesChanged();

  private:
    void tellFiles();
    void watchSources();
    void keepSources();
    void setPath(const QString& path, const QByteArray& known);
    void updateNeed();
    void load(const CaseFile& file, const CaseContext& context, bool isNamed = false);
    void take(const CaseFile& file, const CaseContext& context, bool isNamed = false);

    SceneModel* model_;
    QString path_;
    QString jobName_;
    std::unique_ptr<CaseFile> loaded_;  ///< as loaded
    FileOnDisk disk_;
    std::vector<FileOnDisk> sources_;  ///< that the case reads
    QTimer* sourcesLater_;
    bool isLastCopy_ = false;
    bool neededSaving_ = false;
};

}  // namespace ravnoves
