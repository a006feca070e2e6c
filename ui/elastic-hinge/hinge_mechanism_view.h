#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

namespace ravnoves {

class ElasticHingeModel;

/// The mechanism to scale, with the crank's spring and guide (relief enlarged as in the plot), the
/// rod's hinge and the counterweight. Space plays the computed motion in slow motion; dragging
/// turns the crank.
class HingeMechanismView : public QWidget {
    Q_OBJECT

  public:
    explicit HingeMechanismView(ElasticHingeModel* model, QWidget* parent = nullptr);

    bool isPlaying() const { return timer_.isActive(); }
    void setPlaying(bool playing);
    /// Seconds of the motion to one second on the screen.
    double slowness() const;

    QSize sizeHint() const override { return {300, 210}; }
    QSize minimumSizeHint() const override { return {180, 130}; }

  Q_SIGNALS:
    void playingChanged(bool playing);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    struct Scale;
    Scale scale() const;
    void step();

    ElasticHingeModel* model_;
    QTimer timer_;
    QElapsedTimer sinceStep_;
};

}  // namespace ravnoves
