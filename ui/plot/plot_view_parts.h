#pragma once

// What PlotView's own sources share; pages include plot_view.h alone.

#include <QAbstractAxis>
#include <QLocale>
#include <QPolygonF>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "plot/legend_item.h"
#include "plot/plot_view.h"

namespace ravnoves {

namespace plot {
inline constexpr int labelGap = 6;
inline constexpr double zoomPerStep = 1.2;
inline constexpr double columnPerTick = 56.0;    ///< pixels along x that a tick label needs
inline constexpr double chartRowPerTick = 28.0;  ///< and along y
inline constexpr double rowPerTick = 36.0;  ///< along y with labels of our own: powers stand higher
}  // namespace plot

struct PlotView::AxisState {
    Axis spec;
    QAbstractAxis* chartAxis = nullptr;  // owned by the chart
    double low = 0.0;                    ///< shown interval
    double high = 1.0;
    std::optional<std::pair<double, double>> fixed;
    double step = 1.0;

    /// Neither grid nor labels of Qt Charts fit such an axis: PlotView draws them.
    bool isOwn() const { return spec.logarithmic || spec.scale.place; }
    /// What the axis is linear in.
    double scaled(double value) const {
        if (spec.logarithmic) {
            return std::log10(std::max(value, 1e-300));
        }
        return spec.scale.place ? spec.scale.place(value) : value;
    }
    double unscaled(double place) const {
        if (spec.logarithmic) {
            return std::pow(10.0, place);
        }
        return spec.scale.value ? spec.scale.value(place) : place;
    }
    /// Position of a value on the axis, 0 at low and 1 at high.
    double fraction(double value) const {
        const double start = scaled(low);
        return (scaled(value) - start) / (scaled(high) - start);
    }
    double value(double fraction) const {
        const double start = scaled(low);
        return unscaled(start + fraction * (scaled(high) - start));
    }
    /// Ticks of an own axis that is so many pixels long.
    std::vector<double> ownTicks(double pixels, double pixelsPerTick) const;
    QString ownLabel(double value, const QLocale& locale) const;
};

struct PlotView::Curve {
    CurveStyle style;
    std::vector<QPolygonF> stretches;  ///< the line as drawn, thinned, in pixels
    LegendItem* button = nullptr;
    std::vector<double> x;
    std::vector<double> y;
    std::vector<std::size_t> starts;  ///< points that do not hang together with the one before
    std::vector<double> low;          ///< ends of the error bars
    std::vector<double> high;
    Qt::Orientation bars = Qt::Vertical;
    QStringList texts;      ///< read out, one for each point; or none
    bool ascending = true;  ///< x never decreases, so the cursor may interpolate
    bool shown = true;
    bool stale = true;
};

}  // namespace ravnoves
