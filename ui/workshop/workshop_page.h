#pragma once

#include <QSet>
#include <memory>

#include "page/scene_page.h"
#include "workshop/model/journal.h"

class QPrinter;
class QTabWidget;

namespace ravnoves {

class JobCard;
class JobDesk;
class JournalBanner;
struct ListedJob;
class SheetForm;
class Words;

/// A page of the workshop: the sheets of a job to the left, the answer to the right, journal and
/// job card in the toolbar.
///
/// Made for hands that are not clean: fields are large, Tab and Enter go down the sheet, Enter on
/// to the next one, and every action has a key.
class WorkshopPage : public ScenePage {
    Q_OBJECT

  public:
    using ScenePage::ScenePage;

    QList<QAction*> sceneActions() override { return actions_; }
    /// Never without what is refused: the answer is that of the values before it.
    QString resultsAsText() const override;
    std::optional<bool> askToSave() override;
    void showJournal(const QString& search) override;

    /// Opens the journal; happens by itself once shown.
    void openJournal();

    // For tests.
    QTabWidget* sheets() const { return sheets_; }
    /// The fields of a sheet in the order of Enter.
    QList<QWidget*> fieldsOf(int sheet) const;
    QString writeCard(const QString& file);

  protected:
    // What differs from scene to scene.
    virtual JobDesk* desk() const = 0;
    virtual std::unique_ptr<JobCard> card() = 0;
    /// Empties the sheet for the next job.
    virtual void emptySheet() = 0;
    /// What a new job has of the one before, as a sentence.
    virtual QString carriedOver() const = 0;
    /// Engine and result as the journal's list says them.
    virtual ListedJob listed(const Words& words, const JournalJob& job) const = 0;

    /// What is typed and refused now, whenever that changes.
    virtual void showRefused(const QStringList& /*refused*/) {}

    /// Puts banner, sheets and answer onto the page and makes the actions; called once, by the
    /// page's constructor.
    void build(const QList<std::pair<SheetForm*, QString>>& sheets, QWidget* answer);

    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    void addSheet(SheetForm* form, const QString& title);
    void markTab(int tab);
    void buildActions();
    void buildCardLanguages();
    static QWidget* firstEntry(const SheetForm& sheet);
    void goToBeginning();
    /// Where one goes on with a sheet: its first empty field, or where it begins.
    static QWidget* firstEmpty(const SheetForm& sheet);
    /// Another job is on the sheets: none of them is gone on with where the last one was.
    void beginSheets();
    void goOn(QWidget* from);
    bool hasUnsavedJob();
    /// Asks about an unsaved job. @return false where the user wants to stay
    bool leaveJob();
    /// The same, where another job is to come onto the sheet: refused entries go with this one.
    bool mayReplaceJob();
    /// Says which entries were refused. @return false where the user goes back to them
    bool refusedEntriesAreKnown();
    void saveJob(bool isFinished);
    /// Where F2 would save a job that nobody could find again, make a second one of the same engine
    /// and day, or overwrite the job of another engine, or a verdict by readings that may not hold
    /// any more: asks. @return false to stay
    bool isJobKnown();
    void backUp();
    void restore();
    /// In the background, until it ends or is cancelled.
    void restoreFrom(const QString& file);
    std::unique_ptr<JobCard> shopsCard();
    void newJob();
    /// The sheet of a new job, from its beginning. @param said  what became of the sheet
    void showNewJob(const QString& said);
    void printCard();
    void previewCard();
    void exportCard();
    void paintCard(QPrinter* printer);

    JournalBanner* banner_ = nullptr;
    QTabWidget* sheets_ = nullptr;
    QList<SheetForm*> forms_;  // in the order of the tabs
    QSet<int> unseen_;         ///< sheets that nobody has looked at since the job came
    bool journalTried_ = false;
    QList<QAction*> actions_;
};

}  // namespace ravnoves
