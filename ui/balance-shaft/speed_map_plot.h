#pragma once

#include "balance-shaft/change_colours.h"
#include "balance-shaft/model/speed_study_model.h"
#include "page/part_views.h"

namespace ravnoves {

/// The map of SpeedStudyModel over α and speed, with a bar of its colours and their values, the
/// line along which the shaft changes nothing, and what is under the pointer as text.
class SpeedMapPlot : public PartPlot {
    Q_OBJECT

  public:
    explicit SpeedMapPlot(BalanceShaftModel* model, QWidget* parent = nullptr);

    bool isDrawing() const override { return true; }
    /// The lines at 1.0, in α (°) and speed (min⁻¹).
    const std::vector<QPolygonF>& borders() const { return borders_; }
    /// Those at the bar, the weightiest first.
    std::vector<BarNumber> barNumbers() const;
    /// α, speed and value at a place of the chart; empty without a map.
    QString wordsAt(double angleDeg, double speed) const;
    /// The field under the picture.
    QString csv(const CsvFormat& format) const override;

  Q_SIGNALS:
    void hovered(const QString& text);

  protected:
    void paintGround(QPainter& painter) override;
    bool readsUnderPointer() const override { return false; }  // as text beside the map
    double keyHeight() const override;
    bool event(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void stopReading() override;

  private:
    /// Of the bar, as parts of changeColour().
    std::pair<double, double> barEnds() const;
    void paintBar(QPainter& painter) const;
    void showMap();
    /// Null: there is none.
    const SpeedStudyModel::Map* map() const {
        return study_->isSolved() ? &study_->map() : nullptr;
    }

    SpeedStudyModel* study_;
    std::vector<QPolygonF> borders_;
};

}  // namespace ravnoves
