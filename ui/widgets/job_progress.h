#pragma once

#include <QProgressBar>

class QPushButton;

namespace ravnoves {

class BackgroundJob;

/// How far a job is, seen while it runs. Its place stays, so that nothing moves when a run begins.
class JobProgress : public QProgressBar {
  public:
    /// @param name  for screen readers
    JobProgress(BackgroundJob* job, const QString& name, QWidget* parent);

    /// A button that stops the job; it is shown and hidden likewise.
    QPushButton* cancelButton(const QString& text, const QString& tip);

  private:
    /// Shows a widget while the job runs.
    void follow(QWidget* widget) const;

    BackgroundJob* job_;
};

}  // namespace ravnoves
