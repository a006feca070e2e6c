#pragma once

#include <QLineF>
#include <QRectF>
#include <algorithm>
#include <optional>
#include <utility>

namespace ravnoves {

/// Where a straight line enters and leaves a rectangle, as shares of its length; nothing where it
/// passes by.
inline std::optional<std::pair<double, double>> crossings(const QLineF& line, const QRectF& box) {
    double from = 0.0;
    double to = 1.0;
    const auto keep = [&](double at, double along, double low, double high) {
        if (along == 0.0) {
            if (at < low || at > high) {
                to = -1.0;
            }
            return;
        }
        const auto [enters, leaves] = std::minmax({(low - at) / along, (high - at) / along});
        from = std::max(from, enters);
        to = std::min(to, leaves);
    };
    keep(line.x1(), line.dx(), box.left(), box.right());
    keep(line.y1(), line.dy(), box.top(), box.bottom());
    return from < to ? std::optional(std::pair(from, to)) : std::nullopt;
}

}  // namespace ravnoves
