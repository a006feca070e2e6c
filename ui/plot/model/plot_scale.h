#pragma once

#include <QLocale>
#include <QString>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace ravnoves {

namespace plot {

struct Axis {
    QString title;     ///< with the unit at its end: "φ, °"
    double min = 0.0;  ///< ignored for y axes, which follow the data
    double max = 1.0;
    bool degrees = false;  ///< ticks at 15, 30, 45, 90, …
    bool logarithmic = false;
    /// Text of ticks and of values read out of a logarithmic axis; powers of ten where null.
    QString (*label)(double) = nullptr;
    double factor =
        1.0;  ///< numbers shown per number of the data, where the user's unit is another

    bool operator==(const Axis&) const = default;
};

}  // namespace plot

/// One axis of a plot without the plot: the interval shown, where values are in it, its ticks
/// and its numbers.
struct PlotScale {
    plot::Axis spec;
    double low = 0.0;  ///< shown interval
    double high = 1.0;
    std::optional<std::pair<double, double>> fixed = {};  ///< what fit() keeps to
    /// The interval before the user zoomed; the limit of zooming out.
    std::pair<double, double> home = {0.0, 1.0};
    std::pair<double, double> section = {0.0, 1.0};  ///< that the user zoomed to
    double step = 1.0;  ///< between ticks of a linear axis, in numbers shown

    /// Adopts what the axis is to be, in the units that the user wants.
    /// @return whether that is another one
    bool setSpec(const plot::Axis& axis);
    /// A value as a number of the axis.
    double number(double value) const;

    /// A value that has a place here.
    bool holds(double value) const {
        return std::isfinite(value) && (!spec.logarithmic || value > 0.0);
    }
    /// What the axis is linear in.
    double scaled(double value) const {
        return spec.logarithmic ? std::log10(std::max(value, 1e-300)) : value;
    }
    double unscaled(double place) const { return spec.logarithmic ? std::pow(10.0, place) : place; }
    /// Position of a value on the axis, 0 at low and 1 at high.
    double fraction(double value) const {
        const double start = scaled(low);
        return (scaled(value) - start) / (scaled(high) - start);
    }
    double value(double fraction) const {
        const double start = scaled(low);
        return unscaled(start + fraction * (scaled(high) - start));
    }

    /// Shows data from minimum to maximum. Without data (minimum > maximum) it is unchanged.
    /// @param steady  unchanged too while the data fit and fill more than half: during a drag, axes
    ///                that follow each step are illegible, and take half of each frame
    void fit(double minimum, double maximum, bool steady = false);
    /// Keeps to this interval, with a little room.
    /// @return whether it has changed; an invalid interval is rejected
    bool fix(double min, double max);
    /// Widens the interval by the factor about one of its fractions; within the precision of
    /// numbers and within home.
    void zoom(double factor, double about);
    std::pair<double, double> interval() const { return {low, high}; }
    bool isHome() const { return home == interval(); }
    /// Moves the interval by a fraction of itself.
    void shift(double by);
    /// The same middle, another span.
    void widen(double span);

    /// Chooses `step` for an axis of that many pixels, and its decimals with it.
    /// @param width  of labels that are beside one another; null: they are not
    void chooseStep(double pixels, double pixelsPerTick,
                    const std::function<double(const QString& label)>& width = {},
                    const QLocale& locale = {});
    /// Values that get a tick: multiples of `step`, of a logarithmic axis decades or parts of them.
    std::vector<double> ticks(double pixels, double pixelsPerTick) const;
    QString tickText(double value, const QLocale& locale) const;
    /// A value of the data: three digits finer than the interval.
    QString readout(double value, const QLocale& locale) const;
};

}  // namespace ravnoves
