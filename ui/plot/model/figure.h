#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plot/model/plot_data.h"

namespace ravnoves {

/// What a plot shows of a case, as a value: made again for another input, it is the reference under
/// the curves, a sample of the tolerances, or a picture of a report. What the user does to a plot,
/// zoom and legend, is the plot's and continues with the curve's word.
struct Figure {
    using Curve = plot::Curve;

    Curve& add(std::string id, plot::CurveStyle style, std::vector<double> xs,
               std::vector<double> ys) {
        curves.push_back({.id = std::move(id),
                          .style = std::move(style),
                          .x = std::move(xs),
                          .y = std::move(ys)});
        return curves.back();
    }

    /// The curve with this word; null without one.
    const Curve* find(std::string_view id) const {
        const auto found = std::ranges::find(curves, id, &Curve::id);
        return found != curves.end() ? &*found : nullptr;
    }

    QString title = {};
    plot::Axis x = {};
    plot::Axis left = {};  ///< y
    /// What the y axis shows at least; nothing: it follows the data.
    std::optional<std::pair<double, double>> leftRange = {};
    bool equalScale = false;  ///< one unit is the same length on both axes
    std::vector<Curve> curves = {};
    /// Empty: the present marks follow the crank, not the case.
    std::optional<std::vector<plot::Mark>> marks = {};
    std::vector<plot::Band> bands = {};
    std::vector<plot::Line> lines = {};
    std::optional<double> presentX = {};  ///< likewise
    /// Empty: they follow the tolerances of the case.
    std::optional<plot::Spreads> spreads = {};
};

}  // namespace ravnoves
