#pragma once

#include <QTimer>
#include <QWidget>

namespace ravnoves {

class BalanceShaftModel;

/// Front view of the mechanism to scale: cylinder, piston, rod, crank, both counterweights, the
/// shaft at α, gear circles, force arrows, the envelope. Space plays and pauses; dragging the shaft
/// turns α, dragging elsewhere turns the crank.
class MechanismView : public QWidget {
    Q_OBJECT

  public:
    explicit MechanismView(BalanceShaftModel* model, QWidget* parent = nullptr);

    bool isPlaying() const { return timer_.isActive(); }
    void setPlaying(bool playing);

    QSize sizeHint() const override { return {300, 300}; }
    QSize minimumSizeHint() const override { return {180, 180}; }

  Q_SIGNALS:
    void playingChanged(bool playing);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    struct Scale;
    Scale scale() const;

    BalanceShaftModel* model_;
    QTimer timer_;
    bool draggingShaft_ = false;
};

}  // namespace ravnoves
