#pragma once

#include "balance-shaft/model/speed_study_model.h"
#include "plot/plot_view.h"

namespace ravnoves {

/// The map of SpeedStudyModel over α and speed, with a bar of its colours and their values, the
/// line along which the shaft changes nothing, and what is under the pointer in words.
class SpeedMapPlot : public PlotView {
    Q_OBJECT

  public:
    explicit SpeedMapPlot(QWidget* parent = nullptr);

    /// Nothing to show without a map.
    void setMap(std::optional<SpeedStudyModel::Map> map);
    /// The lines at 1.0, in α (°) and speed (min⁻¹).
    const std::vector<QPolygonF>& borders() const { return borders_; }
    /// The numbers at the bar.
    QStringList barTexts() const;
    /// α, speed and value at a place of the chart; empty without a map.
    QString wordsAt(double angleDeg, double speed) const;
    /// The field under the picture.
    QString csv(const CsvFormat& format) const override;

  Q_SIGNALS:
    void hovered(const QString& text);

  protected:
    void paintGround(QPainter& painter) override;
    bool readsUnderPointer() const override { return false; }  // in words beside the map
    double keyHeight() const override;
    bool event(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void stopReading() override;

  private:
    struct Tick {
        double part;  ///< of changeColour()
        double value;
    };
    std::vector<Tick> ticks() const;
    void paintBar(QPainter& painter) const;
    void showMap();

    std::optional<SpeedStudyModel::Map> map_;
    std::vector<QPolygonF> borders_;
};

}  // namespace ravnoves
