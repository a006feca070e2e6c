#pragma once

#include <QWidget>

#include "plot/plot_view.h"
#include "text/shown_units.h"

class QComboBox;

namespace ravnoves {

class StudyModel;

/// A cloud of points, small and pale where they are many.
class CloudPlot : public PlotView {
    Q_OBJECT

  public:
    using PlotView::PlotView;

    void setPoints(std::vector<double> x, std::vector<double> y);
    const std::vector<double>& pointsX() const { return x_; }
    const std::vector<double>& pointsY() const { return y_; }
    QString csv(const CsvFormat& format) const override;
    QString sentence() const override;

  protected:
    void paintGround(QPainter& painter) override;

  private:
    std::vector<double> x_;
    std::vector<double> y_;
};

/// Some of the samples of a study: any of its inputs and results against any other.
class ScatterView : public QWidget {
    Q_OBJECT

  public:
    explicit ScatterView(StudyModel* study, QWidget* parent = nullptr);

    const CloudPlot* plot() const { return plot_; }

  private:
    void fillChoices();
    void showSamples();

    StudyModel* study_;
    std::vector<ShownTitle> titles_;  ///< of the axes, with what samples are multiplied by
    QComboBox* across_;
    QComboBox* up_;
    CloudPlot* plot_;
};

}  // namespace ravnoves
