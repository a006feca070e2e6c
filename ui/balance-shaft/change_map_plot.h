#pragma once

#include "balance-shaft/model/change_contours.h"
#include "page/part_views.h"

namespace ravnoves {

/// A plot over a field of changes with its lines, and the key to its colours: blue where the shaft
/// helps, orange where it harms, the more the stronger; the eye that sees no red tells them apart,
/// and so does grey from either.
class ChangeMapPlot : public PartPlot {
    Q_OBJECT

  public:
    /// @param indent  of the key, on both sides, pixels
    ChangeMapPlot(SceneModel* model, std::string_view id, double indent, QWidget* parent);

    bool isDrawing() const override { return true; }

  protected:
    /// Without levels: none is there.
    virtual const ChangeContours& field() const = 0;
    /// The field is another, or the colours are.
    virtual void showField();
    /// Over the colours and below the lines, within the chart.
    virtual void paintOnField(QPainter& /*painter*/) {}
    /// What a tip says of a place of the chart; the line beside the map tells how to read it.
    virtual QString tipAt(const QPointF& pixel) const = 0;

    void paintGround(QPainter& painter) override;
    double keyHeight() const override;
    bool readsUnderPointer() const override { return false; }  // as text beside the map
    bool event(QEvent* event) override;

  private:
    void paintKey(QPainter& painter) const;

    double indent_;
};

}  // namespace ravnoves
