#pragma once

#include "balance-shaft/model/speed_study_model.h"
#include "page/part_views.h"

namespace ravnoves {

/// The map of SpeedStudyModel over α and speed with the key to its colours, and the values under
/// the pointer as text.
class SpeedMapPlot : public PartPlot {
    Q_OBJECT

  public:
    explicit SpeedMapPlot(BalanceShaftModel* model, QWidget* parent = nullptr);

    bool isDrawing() const override { return true; }
    /// The field under the picture.
    QString csv(const CsvFormat& format) const override;

  protected:
    void paintGround(QPainter& painter) override;
    void paintOverCurves(QPainter& painter) override;
    bool readsUnderPointer() const override { return false; }  // as text beside the map
    double keyHeight() const override;
    bool event(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

  private:
    void showMap();
    /// α, speed and change at a place of the chart; empty without a map.
    QString wordsAt(double angleDeg, double speed) const;
    /// Null: no map.
    const ChangeContours* map() const { return study_->isSolved() ? &study_->map() : nullptr; }

    SpeedStudyModel* study_;
    std::vector<QPolygonF> lines_;  ///< the longest of each level, pixels
};

}  // namespace ravnoves
