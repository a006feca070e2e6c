#pragma once

#include <QMainWindow>
#include <vector>

#include "model/case_document.h"
#include "shell/scene_list.h"

class QActionGroup;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace ravnoves {

class ScenePage;

/// The window: navigation between the scenes, menus, toolbar, status bar, documents.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Brings a scene to the front by its word in case files.
    /// @return false where there is none
    bool showScene(const QString& name);
    QString currentScene() const;
    /// The page of a scene, made now if it was not yet; null for a word that is no scene.
    ScenePage* page(const QString& name);
    ScenePage* currentPage();

    /// Opens a case file and shows its scene.
    /// @return an empty string, or what is wrong, with the file's name; all stays as it was then
    /// @param asks  whether unsaved changes of what it replaces are asked about; no: undo has them
    QString openCase(const QString& path, bool asks = false);
    /// Writes the current page's case. The same return.
    QString saveCase(const QString& path) { return current().document->saveTo(path); }

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    struct Entry {
        SceneInfo info;
        ScenePage* page = nullptr;
        QWidget* holder = nullptr;
        QToolButton* button = nullptr;
        QAction* action = nullptr;
        CaseDocument* document = nullptr;  ///< of the page, as soon as that is made
    };

    void buildNavigation();
    void buildMenus();
    void showEntry(std::size_t index);
    Entry* entryOf(const QString& scene);
    Entry& current() { return entries_[current_]; }
    DocumentDialogs dialogsOf(Entry& entry);
    void makePage(Entry& entry);
    void openOrSayWhy(const QString& path);
    void openWithDialog();
    void exportPicture();
    void fillRecentFiles();
    void updateTitle();
    void updateSceneActions();
    void updateCaseActions();
    void updateHistoryActions();
    void showHelp(const QString& topic);
    void showAbout();

    std::vector<Entry> entries_;
    std::size_t current_ = 0;
    QStackedWidget* stack_ = nullptr;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    QActionGroup* sceneGroup_ = nullptr;
    QMenu* recentMenu_ = nullptr;
    QMenu* sceneMenu_ = nullptr;
    QToolBar* toolBar_ = nullptr;
    QLabel* hint_ = nullptr;
    QList<QAction*> caseActions_;   ///< need a page with a case file; data: their tip
    QList<QAction*> sceneActions_;  ///< in the toolbar for the present page
};

}  // namespace ravnoves
