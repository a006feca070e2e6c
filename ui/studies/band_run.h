#pragma once

#include <QElapsedTimer>
#include <QPointer>
#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "case-file/json.h"
#include "plot/plot_view.h"
#include "studies/model/band_samples.h"
#include "studies/model/band_slopes.h"
#include "studies/study.h"
#include "widgets/result_table.h"

namespace ravnoves {

/// The numbers of a page while one input after the other is moved, and how the page shows what that
/// makes of each of them.
struct BandRun : BandSlopes {
    /// Numbers that stand together.
    struct Stretch {
        std::size_t from = 0;
        std::size_t count = 0;
    };

    Json input;
    studies::Study study;
    std::vector<BandTask::Source> sources;
    std::vector<std::pair<QPointer<PlotView>, QPointer<PlotView>>> plots;  ///< page's and twin's
    std::vector<std::pair<QPointer<ResultTable>, QPointer<ResultTable>>> tables;
    /// Plots of what the twin computes in the background.
    std::vector<std::pair<QPointer<PlotView>, QPointer<PlotView>>> slow;
    QList<QWidget*> shown;  ///< the plots and tables of the twin

    std::vector<std::vector<std::vector<double>>> x;  ///< by plot and curve
    std::vector<std::vector<Stretch>> curves;         ///< likewise
    std::vector<Stretch> cells;                       ///< by table, row by row

    bool isLaidOut = false;
    bool waits = false;     ///< for what the twin computes in the background
    bool isLoaded = false;  ///< it computes
    QElapsedTimer clock;
    std::size_t next = 0;  ///< solution: up and down for each source
    std::optional<std::vector<double>> plus;

    bool isWhole() const {
        return std::all_of(plots.begin(), plots.end(),
                           [](const auto& each) { return each.first && each.second; }) &&
               std::all_of(tables.begin(), tables.end(),
                           [](const auto& each) { return each.first && each.second; });
    }
    bool isDone() const { return isLaidOut && next == 2 * sources.size(); }
    std::size_t source() const { return next / 2; }
    bool isUp() const { return next % 2 == 0; }

    /// Of the twin as it stands, as many as the nominal ones.
    std::vector<double> numbers() const;
    /// The twin shows what is nominal.
    void layOut();
    /// One side of a source, or nothing where it is refused there.
    void take(std::optional<std::vector<double>> found);
    /// Curves first, then the cells that hold a number.
    std::vector<BandTask::Group> groups() const;

    /// Bands and ± of the page.
    struct Shown {
        std::vector<double> below;
        std::vector<double> above;
        std::vector<std::pair<BandTask::Group, QString>> fails;
        QString howCurves;
        QString howNumbers;
        bool isStale = false;
    };
    Shown slopes() const;
    void show(const Shown& shown) const;

  private:
    void showPlot(std::size_t p, const Shown& shown,
                  const std::map<std::size_t, QString>& fails) const;
    void showTable(std::size_t t, const Shown& shown,
                   const std::map<std::size_t, QString>& fails) const;
};

}  // namespace ravnoves
