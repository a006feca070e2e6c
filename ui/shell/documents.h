#pragma once

#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "model/case_document.h"
#include "shell/scene_list.h"

class QStackedWidget;
class QTabBar;

namespace ravnoves {

class Panel;
class Recovery;
class ScenePage;
struct RecoveredCase;

/// A case that is open, or a page without cases.
struct OpenDocument {
    std::size_t scene = 0;  ///< its place in the list of scenes
    ScenePage* page = nullptr;
    CaseDocument* document = nullptr;
    std::string beginning;  ///< the input that the page was made with, as text
    bool hasTab = false;
};

/// The open documents as tabs over the page of the one in front, its notices between them. Each has
/// a page, a history and a file of its own. The program decides which have a tab, the user in which
/// order.
///
/// The first document of a scene is made when the scene is shown; while it is untouched and has no
/// file, a case that is opened may take its place, and it gets a tab only in front. With one tab
/// there is no bar.
class Documents : public QWidget {
    Q_OBJECT

  public:
    explicit Documents(QWidget* parent = nullptr);
    ~Documents() override;

    const std::vector<SceneInfo>& scenes() const { return scenes_; }
    /// The one in front. Before anything was shown it is the first scene's, made now, silently: the
    /// start page needs none.
    OpenDocument& current();
    bool hasCurrent() const { return current_ != nullptr; }
    const SceneInfo& currentScene() const {
        return scenes_[current_ != nullptr ? current_->scene : 0];
    }
    /// The one in front last is the last.
    const std::vector<std::unique_ptr<OpenDocument>>& all() const { return documents_; }
    /// By its CaseDocument; null where it is closed.
    OpenDocument* of(const QObject* document) const;
    /// The one that a file is open in, by whatever name; null: none.
    OpenDocument* withFile(const QString& path) const;
    /// Its case's name, or else its scene's title.
    QString nameOf(const OpenDocument& document) const;

    /// Brings the document of a scene to the front that was there last, or makes its first.
    /// @return false for a word that is no scene
    bool showScene(const QString& scene);
    void bringToFront(OpenDocument& document);
    /// The next tab, or with −1 the one before; round about.
    void step(int by);
    bool hasSeveralTabs() const;

    /// Opens a case file; one that is open already comes to the front.
    /// @param locates  prompts for files that the case names and that cannot be read
    /// @return an empty string, or the fault with the file's name; all is unchanged then
    QString open(const QString& path, bool locates = false);
    /// Begins a case without a file from another, as from an example, and brings it to the front.
    /// Returns as open().
    /// @param isFirst  of the page: while it is untouched, another replaces it
    QString begin(const CaseFile& file, bool isFirst = false);

    /// Saves a case in its file, else in a place of its page's own, else where the user says.
    /// @return false where the user wants to stay, or it could not be written
    bool save(OpenDocument& document);
    bool saveAs(OpenDocument& document);

    /// Closes the document, or the one in front: the previous one comes to the front. Asks about
    /// unsaved changes.
    /// @return false where the user cancels
    bool close(OpenDocument& document);
    /// Before all of them close: asks about unsaved changes.
    bool canClose();

    /// Keeps unsaved work for the case of a crash, from now on.
    void keepIn(Recovery* recovery);
    /// Opens a recovered case in a tab of its own; it needs saving. Prompts for files that the case
    /// names and that cannot be read, and shows other faults.
    /// @return false where the copy is still needed
    bool restore(const RecoveredCase& recovered);

    /// Makes every page again over its model, in another language or with other units.
    void renewPages();

  Q_SIGNALS:
    /// Another document is in front, or none is open any more, or the one in front shall be seen.
    void currentChanged();
    /// The open documents, their order or names, or whether one needs saving.
    void changed();
    /// Undo and redo of the document in front, and its rejected entries.
    void historyChanged();
    /// A line for the status bar; empty: what the scene is for.
    void status(const QString& text);
    void saved(const QString& path);

  protected:
    bool event(QEvent* event) override;

  private:
    std::optional<std::size_t> indexOf(const QString& scene) const;
    OpenDocument* at(int tab) const;
    OpenDocument& firstOf(std::size_t scene);
    OpenDocument& add(std::size_t scene);
    void putPage(OpenDocument& document, ScenePage* page);
    void remove(OpenDocument& document);
    static bool isUntouched(const OpenDocument& document);
    OpenDocument* untouchedOf(std::size_t scene) const;
    void makeTabs();
    void dressTabs();
    void showTab(int tab);
    /// Brings a case into a document of its own, or into one that is there; one that is rejected
    /// leaves none behind.
    void put(const CaseFile& file, OpenDocument* there,
             const std::function<void(CaseDocument&)>& load);
    /// Loads a case; where a file that it names cannot be read, prompts for its present place,
    /// enters that into the case, and tries again.
    /// @param title  of the questions: the action
    /// @param name   of the case, for the fault
    /// @param folder of the case
    /// @return false after Cancel
    /// @throws InputError of another fault
    bool locate(const QString& title, const QString& name, const QString& folder, CaseFile& file,
                const std::function<void()>& load);
    bool chooseAndSave(OpenDocument& document);
    bool saveAt(OpenDocument& document, const QString& path);
    /// It could not be saved in its place: says why, and saves it elsewhere if the user wants.
    /// @param overwrites  it may be saved there all the same
    bool saveInstead(OpenDocument& document, const QString& path, const QString& trouble,
                     bool overwrites);
    /// Before it closes: asks about unsaved changes.
    bool mayClose(OpenDocument& document);
    /// That the case's file, or one that it reads, was changed or deleted by others, and what to do
    /// about it.
    void showNotices();
    void nameTabs();
    void arrangeTabs();

    std::vector<SceneInfo> scenes_;
    std::vector<std::unique_ptr<OpenDocument>> documents_;
    OpenDocument* current_ = nullptr;  ///< the last of them
    QTabBar* tabs_ = nullptr;
    Panel* notices_ = nullptr;
    QStackedWidget* stack_ = nullptr;
    Recovery* recovery_ = nullptr;
};

}  // namespace ravnoves
