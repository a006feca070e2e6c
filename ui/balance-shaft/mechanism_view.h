#pragma once

#include <optional>

#include "page/mechanism_picture.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

class BalanceShaftModel;

/// Front view of the mechanism to scale: cylinder, piston, rod, crank, both counterweights, the
/// shaft at α, gear circles, force arrows, the envelope. Space plays and pauses; dragging the shaft
/// turns α, dragging elsewhere turns the crank.
class MechanismView : public MechanismPicture {
    Q_OBJECT

  public:
    explicit MechanismView(BalanceShaftModel* model, QWidget* parent = nullptr);

    /// The results below it come first: in a low window it is as low as it can be.
    QSize sizeHint() const override { return minimumSizeHint(); }
    QSize minimumSizeHint() const override { return {Theme::withText(180), Theme::withText(180)}; }

  protected:
    void paintPicture(QPainter& painter) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    /// The mapping of metres to pixels: the envelope fills the picture. It rests while the shaft is
    /// dragged.
    drawing::Frame frame() const;

    BalanceShaftModel* model_;
    std::optional<drawing::Frame> held_;  ///< while the shaft is dragged
};

}  // namespace ravnoves
