#pragma once

#include <QPointer>
#include <QWidget>

class QProgressBar;

namespace ravnoves {

class ScenePage;
class ToleranceBands;

/// How far the samples of a page's bands are, and a button that stops them; there while they are
/// solved.
class BandProgress : public QWidget {
    Q_OBJECT

  public:
    explicit BandProgress(QWidget* parent = nullptr);

    /// Null: of none.
    void follow(const ScenePage* page);

  private:
    void showRunning();

    QPointer<ToleranceBands> bands_;
    QProgressBar* progress_;
};

}  // namespace ravnoves
