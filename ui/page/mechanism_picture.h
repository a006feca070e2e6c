#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include "model/crank_angle.h"
#include "widgets/panel.h"

class QAction;
class QPainter;

namespace ravnoves {

class PlotView;
class ValueSlider;

/// φ in a plot over φ: the cursor turns the crank, a mark shows its angle.
void showCrankAngle(PlotView* plot, CrankAngle* crank);

/// A picture of a mechanism that turns. Space plays and pauses, the left and right arrows step by
/// a degree.
class MechanismPicture : public QWidget {
    Q_OBJECT

  public:
    /// @param name  for screen readers
    MechanismPicture(CrankAngle* crank, const QString& name, const QString& hint,
                     QWidget* parent = nullptr);

    CrankAngle* crank() const { return crank_; }
    /// By hand: a step, the slider.
    virtual void turnTo(double degrees) { crank_->turnTo(degrees); }
    bool isPlaying() const { return timer_.isActive(); }
    void setPlaying(bool playing);

  Q_SIGNALS:
    void playingChanged(bool playing);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    /// All that is on the panel; smooth.
    virtual void paintPicture(QPainter& painter) = 0;
    /// Moves on by the time since the picture before, s.
    virtual void play(double seconds);
    /// An arrow key: −1 or +1, degrees.
    virtual void step(double degrees) { turnTo(crank_->degrees() + degrees); }

  private:
    CrankAngle* crank_;
    QTimer timer_;
    QElapsedTimer sinceStep_;
};

/// A panel with a picture and below it its bar: play and pause, the crank angle.
class PicturePanel : public Panel {
    Q_OBJECT

  public:
    /// @param hint  what the crank angle is
    PicturePanel(MechanismPicture* picture, const QString& hint, QWidget* parent = nullptr);

    ValueSlider* slider() const { return slider_; }
    /// Plays and pauses, for menu and toolbar.
    QAction* action() const { return action_; }
    /// Puts other controls into a row of their own above the bar: the angle's slider needs its
    /// width.
    void addControls(const QList<QWidget*>& controls);

  private:
    ValueSlider* slider_;
    QAction* action_;
};

}  // namespace ravnoves
