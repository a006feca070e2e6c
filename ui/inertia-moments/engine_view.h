#pragma once

#include <QRectF>
#include <utility>

#include "page/mechanism_picture.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

class InertiaMomentsModel;

/// The engine to scale: front view with banks, offsets, pistons, rods and the crank star, and below
/// it the crank from the side. Space plays and pauses; dragging turns the crank.
class EngineView : public MechanismPicture {
    Q_OBJECT

  public:
    explicit EngineView(InertiaMomentsModel* model, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {320, Theme::withText(160)}; }
    /// Large texts leave it less height: the tables below it need theirs.
    QSize minimumSizeHint() const override { return {Theme::withText(200), Theme::withText(120)}; }

  protected:
    void paintPicture(QPainter& painter) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

  private:
    /// Places of front and side view: one above the other, or beside each other where that makes
    /// the front view larger.
    std::pair<QRectF, QRectF> areas() const;
    /// The mapping of the side view: place along the axis and height over it, m, to pixels.
    struct Side {
        QPointF middle;          ///< of the area, at the height of the axis
        double along = 0.0;      ///< place along the axis that is in the middle, m
        double pixels = 1.0;     ///< to one metre
        double direction = 0.0;  ///< of the first bank from the crank's zero, rad

        /// Cylinder 1 to the left.
        QPointF operator()(double z, double y) const {
            return middle - QPointF(z - along, y) * pixels;
        }
        /// Share of a radius that is seen from the side.
        double height(double angle) const;
    };

    void paintFront(QPainter& painter, const QRectF& area);
    void paintSide(QPainter& painter, const QRectF& area);

    InertiaMomentsModel* model_;
    double dragOffset_ = 0.0;  ///< crank angle less pointer's angle at the press, °
    QPointF crankPixel_;       ///< crank axis in the front view as last drawn
};

}  // namespace ravnoves
