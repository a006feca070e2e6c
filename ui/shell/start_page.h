#pragma once

#include <QWidget>
#include <vector>

#include "shell/new_cases.h"

class QGridLayout;
class QVBoxLayout;

namespace ravnoves {

/// What the program shows when it was given nothing to show: the scenes as pictures, the newest
/// jobs, the files opened last, the examples. It is made again whenever it is shown.
class StartPage : public QWidget {
    Q_OBJECT

  public:
    explicit StartPage(QWidget* parent = nullptr);

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

  private:
    /// The newest jobs of the journal; nothing of a journal that cannot be opened.
    void showJobs();

    std::vector<QWidget*> cards_;
    QGridLayout* grid_;  ///< of the cards
    QWidget* jobsBox_;
    QVBoxLayout* jobs_;
};

}  // namespace ravnoves
