#pragma once

#include <QPointer>
#include <QString>
#include <vector>

#include "plot/plot_view.h"
#include "studies/model/band_samples.h"
#include "widgets/result_table.h"

namespace ravnoves {

class ScenePage;

/// The numbers that a page shows, points of curves and cells of tables, and the same of its twin,
/// a page of the same scene with another input.
class PageNumbers {
  public:
    /// Of the parts that are seen, or of all that are filled.
    PageNumbers(const ScenePage& page, const ScenePage& twin, bool ofAll);

    bool isWhole() const;
    QList<QWidget*> twins() const;
    /// Of the page; an angle's numbers have the period 360, others 0.
    const std::vector<double>& nominal() const { return nominal_; }
    const std::vector<double>& periods() const { return periods_; }
    /// The same numbers of the twin; not a number where it has none.
    std::vector<double> ofTwin() const;
    /// Bands and ± of the page.
    /// @param how  they were found: a tip
    void show(const BandSamples::Sides& sides, const QString& how) const;

  private:
    struct Curve {
        std::size_t from = 0;  ///< the first of its numbers
        std::vector<double> x;
    };
    struct Plot {
        QPointer<PlotView> own;
        QPointer<PlotView> twin;
        std::vector<Curve> curves;
    };
    struct Cell {
        int row = 0;
        int column = 0;
        QString name;  ///< of its row
    };
    struct Table {
        QPointer<ResultTable> own;
        QPointer<ResultTable> twin;
        std::size_t from = 0;
        std::vector<Cell> cells;
    };

    void add(PlotView* own, PlotView* twin);
    void add(ResultTable* own, ResultTable* twin);
    void showPlot(const Plot& plot, const BandSamples::Sides& sides) const;
    void showTable(const Table& table, const BandSamples::Sides& sides, const QString& how) const;

    std::vector<Plot> plots_;
    std::vector<Table> tables_;
    std::vector<double> nominal_;
    std::vector<double> periods_;
};

}  // namespace ravnoves
