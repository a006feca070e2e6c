#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>
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

/// What a document asks its user. The window shows it; a test answers it.
struct DocumentDialogs {
    enum class Answer { Save, Discard, Stay };

    /// What to do with changes that are not saved. A case without a file may be saved in a place of
    /// the page's own; nothing is left to be saved then, hence Discard.
    std::function<Answer(bool hasFile)> saveChanges;
    /// Where to save; empty where the user wants to stay.
    std::function<QString(const QString& suggestion)> choosePath;
    /// The case could not be saved, with the trouble; without one, the file was changed by others
    /// since it was read or written.
    enum class Instead { Overwrite, Elsewhere, Stay };
    std::function<Instead(const QString& path, const QString& trouble)> instead{};
    /// Before it is saved, or closed with nothing else unsaved: entries may be rejected, and are
    /// not in the case; @return false to stay.
    std::function<bool(bool closes)> continueWithoutRejected{};
    /// Saves a case without a file in a place of the page's own: whether it is saved there; nothing
    /// where the page has none.
    std::function<std::optional<bool>()> saveInPlace{};
};

/// A case between its file and its model: its origin, whether it has to be saved, and the questions
/// about that. Title, history and the folder of its files are the model's.
class CaseDocument : public QObject {
    Q_OBJECT

  public:
    /// The model outlives the document.
    CaseDocument(SceneModel* model, DocumentDialogs dialogs, QObject* parent = nullptr);
    ~CaseDocument() override;

    SceneModel* model() const { return model_; }
    /// Of the file, absolute; empty without one.
    QString path() const { return path_; }
    /// The file's name, else what its job is known by, else the case's title; may be empty.
    QString name() const;
    /// Also a case whose file is missing, or no case file any more: this is the last copy.
    bool needsSaving() const { return model_->hasChanges() || isLastCopy_; }
    /// For other pages to refer to.
    OpenCase asOpenCase() const;
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
    FileOnDisk& disk() { return disk_; }
    /// Adopts the file's present contents, as one step of the history.
    /// @return an empty string, or the fault with the file's name
    QString reload();
    /// Keeps this case, whatever others did to the file, and needs saving.
    void keepMine();

    /// Of the files that the case reads (CSV) the first that others have changed or deleted since;
    /// null where all are as they were.
    const FileOnDisk* changedSource() const;
    /// Looks at them now.
    void checkSources();
    /// Reads them again, as one step of the history.
    /// @return an empty string, or the fault
    QString readSources();
    /// Keeps their previous contents.
    void keepSources();

    // With the user's help; false where the user wants to stay, or the file could not be written.
    bool save();
    bool saveAs();
    /// Before the document closes: asks about unsaved changes.
    bool canClose();

    /// The case files last opened or saved, the newest first.
    static QStringList recentPaths();

  Q_SIGNALS:
    /// name() or needsSaving() is another.
    void nameChanged();
    void saved(const QString& path);
    /// changedSource() is another, or changed again.
    void sourcesChanged();

  private:
    void watchSources();
    void setPath(const QString& path, const QByteArray& known);
    void updateNeed();
    void load(const CaseFile& file, const CaseContext& context);
    void take(const CaseFile& file, const CaseContext& context);
    bool mayGo(bool closes) const {
        return !dialogs_.continueWithoutRejected || dialogs_.continueWithoutRejected(closes);
    }
    bool chooseAndSave();
    bool saveAt(const QString& path);

    SceneModel* model_;
    DocumentDialogs dialogs_;
    QString path_;
    QString jobName_;
    std::unique_ptr<CaseFile> loaded_;  ///< as loaded
    FileOnDisk disk_;
    std::vector<std::unique_ptr<FileOnDisk>> sources_;  ///< that the case reads
    QTimer* sourcesLater_;
    bool isLastCopy_ = false;
    bool neededSaving_ = false;
};

}  // namespace ravnoves
