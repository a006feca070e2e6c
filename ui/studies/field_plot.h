#pragma once

#include <vector>

#include "plot/plot_view.h"

namespace ravnoves {

/// A value over two inputs: colours, pale to deep, and lines with their numbers.
class FieldPlot : public PlotView {
    Q_OBJECT

  public:
    struct Field {
        std::vector<double> x;  ///< rising at equal distances
        std::vector<double> y;  ///< likewise
        /// As they are shown, a row of x for each y; not a number where there is none.
        std::vector<double> values;
    };

    explicit FieldPlot(QWidget* parent = nullptr);

    void setField(Field field);
    const Field& field() const { return field_; }
    /// Of the lines.
    const std::vector<double>& levels() const { return levels_; }
    QString csv(const CsvFormat& format) const override;
    QString sentence() const override;

  protected:
    void paintGround(QPainter& painter) override;

  private:
    void showImage();

    Field field_;
    std::vector<double> levels_;
    double low_ = 0.0;
    double high_ = 0.0;
    double step_ = 1.0;
};

}  // namespace ravnoves
