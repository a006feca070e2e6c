#pragma once

#include <QSet>

#include "page/scene_page.h"

class QLabel;
class QPrinter;
class QPushButton;
class QTabWidget;

namespace ravnoves {

class CorrectionSheet;
class JobDesk;
class MachineSheet;
class WorkshopSheet;
class VerdictLine;
class WorkshopAnswer;
struct Paper;
class WorkshopModel;

/// The page Workshop: the sheets of a job to the left, the answer to the right, journal and job
/// card in the toolbar.
///
/// Made for hands that are not clean: fields are large, Tab and Enter go down the sheet, Enter on
/// to the next one, and every action has a key.
class WorkshopPage : public ScenePage {
    Q_OBJECT

  public:
    explicit WorkshopPage(QWidget* parent = nullptr, SceneModel* kept = nullptr);
    WorkshopPage(const QString& journalPath, QWidget* parent, SceneModel* kept = nullptr);

    SceneModel* model() override;
    WorkshopModel* viewModel() { return model_; }
    QList<QAction*> sceneActions() override { return actions_; }
    std::optional<bool> askToSave() override;
    std::optional<bool> saveInPlace() override;
    QString savingTip() const override;
    void showJournal(const QString& search = {});
    /// Brings a job of the journal onto the page, where it is open already that page to the front.
    void openJob(qint64 id);

    /// Opens the journal; happens by itself once shown.
    void openJournal();

    // For tests.
    QString writeCard(const QString& file);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    JobDesk* desk() const;
    /// With the shop's name, and the entries rejected now.
    Paper card();
    /// Does what the verdict proposes.
    void doVerdictAct();
    void showVerdict();
    void addSheet(WorkshopSheet* form, const QString& title);
    void markTab(int tab);
    /// The model knows which entries are rejected.
    void noteRejected();
    void buildActions();
    void buildCardLanguages();
    QWidget* buildBanner();
    /// Above the sheets, until it is understood, or with an empty text.
    void say(const QString& text);
    void showNews();
    void goToBeginning();
    /// Where one continues with a sheet: the next reading of the machine; elsewhere the first
    /// field, or the first that is empty. Not a list, which would take letters for a choice.
    static QWidget* nextEntry(const WorkshopSheet& sheet, bool isEmpty);
    /// Another job is on the sheets: none of them continues where the last job was.
    void beginSheets();
    void focusNext(QWidget* from);
    bool hasUnsavedJob();
    /// Asks about an unsaved job and its rejected entries, where another one is to come onto the
    /// sheet. @return false where the user wants to stay
    bool mayReplaceJob();
    /// Names the rejected entries.
    /// @return false where the user returns to them
    bool rejectedEntriesAreKnown();
    /// @return false where it is not saved
    bool saveJob(bool isFinished);
    bool store(bool isFinished);
    /// Asks about a job of the journal. @return the place of the answer; -1 to stay
    /// @param usual  place of the answer by Enter; -1 likewise
    int ask(const QString& question, const QStringList& answers, int usual);
    /// Asks where F2 would save a job without a name to find it by, make a second one of the same
    /// engine and day, or overwrite the job of another engine, or a verdict by readings that may be
    /// invalid.
    /// @return false to cancel
    bool isJobKnown();
    /// In the background, until it ends or is cancelled.
    void restoreFrom(const QString& file);
    /// A job of the journal comes onto the sheet, unchanged or as a new one like it.
    void bringJob(qint64 id, bool isCopy);
    /// The sheet of a new job, from its beginning.
    void showNewJob();
    void printCard();
    void previewCard();
    void exportCard();
    /// @return false where the printer failed, which it says
    bool paintCard(QPrinter* printer);

    WorkshopModel* model_;
    VerdictLine* verdict_ = nullptr;
    WorkshopAnswer* answer_ = nullptr;
    MachineSheet* machine_ = nullptr;
    CorrectionSheet* correction_ = nullptr;
    QWidget* banner_ = nullptr;
    QLabel* news_ = nullptr;
    QPushButton* offer_ = nullptr;  ///< to restore the backup of a damaged journal
    QString said_;                  ///< instead of the journal's news
    QTabWidget* sheets_ = nullptr;
    QList<WorkshopSheet*> forms_;  // in the order of the tabs
    QSet<int> unseen_;             ///< sheets that were not in front since the job came
    bool journalTried_ = false;
    QList<QAction*> actions_;
};

}  // namespace ravnoves
