#pragma once

#include "shell/scene_page.h"
#include "v8-plugs/model/journal.h"

class QPrinter;
class QTabWidget;

namespace ravnoves {

class AnswerView;
class JournalBanner;
class MachineSheet;
class PlotView;
class SheetForm;
class V8PlugsModel;

/// The V-8 workshop page: the sheets of the job to the left, the answer with its options, bob
/// weights, plug and plots to the right; journal and job card in the toolbar.
///
/// Made for hands that are not clean: fields are large, Tab and Enter go down the sheet and on to
/// the next, and every action has a key.
class V8PlugsPage : public ScenePage {
    Q_OBJECT

  public:
    explicit V8PlugsPage(QWidget* parent = nullptr, SceneModel* kept = nullptr);
    V8PlugsPage(const QString& journalPath, QWidget* parent, SceneModel* kept = nullptr);

    SceneModel* model() override;
    V8PlugsModel* viewModel() { return model_; }
    QList<QAction*> sceneActions() override;
    QString resultsAsText() const override;
    QString resultsAsCsv() const override;
    void setActive(bool active) override;
    std::optional<bool> askToSave() override;
    QString draftName() const override;
    void takeDraft(const QString& name) override;
    void dropDraft(const QString& name) override;

    /// Opens the journal and offers drafts that a crash left; happens by itself once shown.
    void openJournal();

    // For tests.
    QTabWidget* sheets() const { return sheets_; }
    PlotView* compensationPlot() const;
    PlotView* shiftPlot() const;
    /// The fields of a sheet in the order of Enter.
    QList<QWidget*> fieldsOf(int sheet) const;
    QString writeCard(const QString& file);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    QWidget* buildSheets();
    void addSheet(SheetForm* form, const QString& title);
    void buildActions();
    void goOn(QWidget* from);
    void continueDraft(const JournalDraft& draft);
    /// Asks about an unsaved job. @return false where the user wants to stay
    bool leaveJob();
    /// Says which entries were refused. @return false where the user goes back to them
    bool refusedEntriesAreKnown();
    void saveJob();
    void showJournal();
    void newJob();
    void printCard();
    void previewCard();
    void exportCard();
    void paintCard(QPrinter* printer);

    V8PlugsModel* model_;
    JournalBanner* banner_ = nullptr;
    QTabWidget* sheets_ = nullptr;
    QList<SheetForm*> forms_;  // in the order of the tabs
    MachineSheet* machine_ = nullptr;
    AnswerView* answer_ = nullptr;
    bool journalTried_ = false;
    QList<QAction*> actions_;
};

}  // namespace ravnoves
