#pragma once

#include <QWidget>
#include <vector>

#include "methods/model/methods_model.h"
#include "plot/plot_view.h"

namespace ravnoves {

/// The two charts of a kernel over one scale of errors: time against error (work and precision),
/// and error along the hard parameter (stability).
///
/// Both follow the newest measurement and pale while a newer one is on the way. An error of 0,
/// which has no logarithm, and a rejection have rows of their own at the bottom and at the top, so
/// that no point is lost.
class MethodPlots : public QWidget {
    Q_OBJECT

  public:
    explicit MethodPlots(MethodsModel* model, QWidget* parent = nullptr);

    PlotView* workPlot() const { return work_; }
    PlotView* stabilityPlot() const { return stability_; }
    /// Both charts side by side, as SVG or PNG by the file's ending.
    /// @return an empty string, or what went wrong
    QString exportPicture(const QString& path);
    /// There is no room for the charts side by side: one is above the other, and the page
    /// scrolls.
    bool isFolded() const { return isFolded_; }

  Q_SIGNALS:
    void foldChanged();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// Interval of errors with the rows for what has no place on a logarithmic axis.
    struct ErrorScale {
        static constexpr double least = 1e-18;  ///< what is less counts as none
        double floor = least;                   ///< such an error is drawn here
        double ceiling = 10.0;                  ///< a rejection is drawn here
        bool hasZero = false;
        bool hasRefusal = false;
        double place(const methods::Result& result) const;
        bool isPlain(const methods::Result& result) const {
            return !result.refused() && result.error > least;
        }
    };
    static ErrorScale scaleOf(const MethodMeasurement& shown);

    void setUpCurves(const methods::Kernel& kernel);
    void showMeasurement();
    void showWork(const MethodMeasurement& shown, const ErrorScale& scale);
    void showStability(const MethodMeasurement& shown, const ErrorScale& scale);
    void showValue();
    void showFailing();
    void showStale();
    std::vector<PlotView::Line> errorLines(const methods::Kernel& kernel,
                                           const ErrorScale& scale) const;
    QString pointText(const MethodMeasurement& shown, const methods::WorkPoint& point) const;

    MethodsModel* model_;
    PlotView* work_;
    PlotView* stability_;
    const methods::Kernel* curvesOf_ = nullptr;  ///< the kernel whose curves are there
    ErrorScale scale_;
    bool isFolded_ = false;
};

}  // namespace ravnoves
