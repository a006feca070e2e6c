#pragma once

#include <QPointer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

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

  Q_SIGNALS:
    /// What is shown then.
    void stopped(const QString& what);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void setTexts();
    void showRunning();

    QPointer<ToleranceBands> bands_;
    QLabel* title_;
    QProgressBar* progress_;
    QToolButton* stop_;
};

}  // namespace ravnoves
