#pragma once

#include <QWidget>

#include "shell/new_cases.h"

class QGridLayout;
class QVBoxLayout;

namespace ravnoves {

/// What the program shows when it was given nothing to show: the scenes as pictures, the files
/// opened last, the examples.
class StartPage : public QWidget {
    Q_OBJECT

  public:
    explicit StartPage(QWidget* parent = nullptr);

    /// The files opened last, again.
    void showRecent();
    /// The newest jobs of the journal, again; nothing of a journal that cannot be opened.
    void showJobs();

  Q_SIGNALS:
    /// A picture was pressed: the scene as it starts.
    void sceneRequested(const QString& scene);
    /// A case that has no file yet.
    void newRequested(const CaseFile& file);
    void openRequested(const QString& path);
    /// The user wants to be asked for a file.
    void openDialogRequested();
    /// The journal of the workshop, by F3 as on its pages.
    void journalRequested();
    /// A job of that journal.
    void jobRequested(qint64 id);

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void arrange();

    QGridLayout* cards_;
    QWidget* jobsBox_;
    QVBoxLayout* jobs_;
    bool isLooked_ = false;  ///< into the journal, since the page is shown
    QGridLayout* lists_;
    QWidget* recentBox_;
    QVBoxLayout* recent_;
    QWidget* examplesBox_;
    int columns_ = 0;
    bool areListsBeside_ = false;
};

}  // namespace ravnoves
