#pragma once

#include "page/mechanism_picture.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

class ElasticHingeModel;

/// The mechanism to scale, with the crank's spring and guide (relief enlarged as in the plot), the
/// rod's hinge and the counterweight. Space plays the computed motion in slow motion; dragging
/// turns the crank.
class HingeMechanismView : public MechanismPicture {
    Q_OBJECT

  public:
    explicit HingeMechanismView(ElasticHingeModel* model, QWidget* parent = nullptr);

    void turnTo(double degrees) override;

    QSize sizeHint() const override { return {300, 210}; }
    QSize minimumSizeHint() const override { return {Theme::withText(180), Theme::withText(130)}; }

  protected:
    void paintPicture(QPainter& painter) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void play(double seconds) override;
    /// The left arrow counter-clockwise.
    void step(double degrees) override { MechanismPicture::step(-degrees); }

  private:
    /// The mapping of metres to pixels; it rests while the mechanism moves.
    drawing::Frame frame() const;
    double reliefFactor() const;
    /// Seconds of the motion to one second on the screen.
    double slowness() const;

    ElasticHingeModel* model_;
};

}  // namespace ravnoves
