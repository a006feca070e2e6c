#pragma once

#include <QDeadlineTimer>
#include <QMainWindow>
#include <vector>

#include "case-file/case_context.h"
#include "report/patience.h"

class QActionGroup;
class QLabel;
class QStackedWidget;

namespace ravnoves {

struct CaseFile;
class Documents;
class Recovery;
class ScaleButton;
class ScenePage;
class StartPage;
class ToleranceWindow;
class VariantMenu;
class WorkshopPage;

/// The window: navigation between the scenes, menus, toolbar, status bar, over its documents.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    /// The first content: the page of the first scene, or nothing, because something else will be
    /// shown before the window is.
    enum class First { Scene, Nothing };

    explicit MainWindow(First first = First::Scene);
    ~MainWindow() override;

    /// Brings a scene to the front by its word in case files: its latest document.
    /// @return false without one
    bool showScene(const QString& name);
    QString currentScene() const;
    /// Brings the start page to the front, until something is opened or begun.
    void showStart();
    bool isAtStart() const;
    ScenePage* currentPage() const;
    Documents& documents() { return *documents_; }

    /// Opens a case file in a tab of its own and shows it; one that is open comes to the front.
    /// @return an empty string, or the fault with the file's name; all is unchanged then
    QString openCase(const QString& path);
    /// The same for a user at the window: shows faults, and for one file prompts for missing files
    /// that the case names. At most 20 files at once.
    void openOrSayWhy(const QStringList& paths);
    /// Shows the open case of a scene, or begins its first.
    void goToScene(const QString& scene);
    /// Begins the first case of a scene, one that works.
    /// @param isFirst  as Documents::begin()
    /// @return false without one
    bool newCase(const QString& scene, bool isFirst = false);
    /// Writes a report of the current page's case, PDF or HTML by the suffix. The same return.
    QString writeReport(const QString& path, const Patience& patience = Patience());

    /// Keeps unsaved work for the case of a crash.
    void beginSession();
    /// Offers what a crash has left, where there is any.
    void offerRecovered();

  protected:
    bool event(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void buildNavigation();
    void buildMenus();
    /// Makes menus, navigation and pages again, in the present language, units and size of text.
    void renew();
    /// Settings make the pages again: asks where that would discard rejected texts.
    bool mayRenew(const QString& title);
    void copyResults(QString (ScenePage::*results)() const, const QString& said);
    void showCurrent();
    /// Brings the documents back in front of the start page.
    void leaveStart();
    void beginOrSayWhy(const CaseFile& file);
    void fillNewMenu();
    void openWithDialog();
    void exportPicture();
    void exportReport();
    void fillRecentFiles();
    /// The other open cases whose engine can be taken.
    void fillEngines();
    /// Of an open case, by its CaseDocument, as one step.
    void takeEngine(const QObject* document);
    void updateTitle();
    void updateSceneActions();
    /// In the status bar, while it has no other message.
    void showHint(const QString& text);
    /// Reports an action, before all else in the status bar; no tip under the pointer replaces it
    /// meanwhile.
    void say(const QString& text, std::chrono::milliseconds during = std::chrono::seconds(5));
    void updateCaseActions();
    void updateHistoryActions();
    WorkshopPage* showWorkshop();
    void showHelp(const QString& topic);
    void showAbout();
    /// The window of the tolerances of the case in front; one that is open comes to the front.
    void showTolerances();
    ToleranceWindow* openTolerances(ScenePage* page);

    QStackedWidget* front_ = nullptr;  ///< the documents, or the start page
    Documents* documents_ = nullptr;
    Recovery* recovery_ = nullptr;  ///< from beginSession() on
    StartPage* start_ = nullptr;    ///< while it is in front
    QAction* startAction_ = nullptr;
    std::vector<QAction*> scenes_;  ///< in the order of the navigation
    QAction* save_ = nullptr;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    QActionGroup* sceneGroup_ = nullptr;
    QMenu* recentMenu_ = nullptr;
    QMenu* engineMenu_ = nullptr;
    QMenu* newMenu_ = nullptr;  ///< of the New button, too
    QMenu* sceneMenu_ = nullptr;
    QToolBar* toolBar_ = nullptr;
    VariantMenu* variants_ = nullptr;
    ScaleButton* scale_ = nullptr;
    QLabel* hint_ = nullptr;
    QDeadlineTimer said_;  ///< until when the report is shown
    QAction* nextTab_ = nullptr;
    QAction* previousTab_ = nullptr;
    QList<QAction*> caseActions_;   ///< need a page with a case file; data: their tip
    QList<QAction*> pageActions_;   ///< need a page in front
    QList<QAction*> sceneActions_;  ///< in the toolbar for the present page
};

}  // namespace ravnoves
