#include "plot/model/thin_polyline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ravnoves {

QPolygonF thinPolyline(const std::vector<QPointF>& points, double tolerance) {
    if (points.size() <= 2) {
        return QPolygonF(QList<QPointF>(points.begin(), points.end()));
    }
    std::vector<char> keep(points.size(), 0);
    keep.front() = 1;
    keep.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> spans{{0, points.size() - 1}};
    while (!spans.empty()) {
        const auto [first, last] = spans.back();
        spans.pop_back();
        const QPointF a = points[first];
        const QPointF d = points[last] - a;
        const double length = std::hypot(d.x(), d.y());
        double farthest = 0.0;
        std::size_t at = first;
        for (std::size_t i = first + 1; i < last; ++i) {
            const QPointF p = points[i] - a;
            // Beside the span or in a closed one, which has no direction, the distance to its end
            // counts: a line that comes back on itself keeps its turning points.
            const double along = QPointF::dotProduct(p, d);
            const QPointF away = along > length * length ? p - d : p;
            const double distance = along > 0.0 && along <= length * length
                                        ? std::abs(d.x() * p.y() - d.y() * p.x()) / length
                                        : std::hypot(away.x(), away.y());
            if (distance > farthest) {
                farthest = distance;
                at = i;
            }
        }
        if (farthest > tolerance) {
            keep[at] = 1;
            spans.emplace_back(first, at);
            spans.emplace_back(at, last);
        }
    }
    QPolygonF thinned;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (keep[i] != 0) {
            thinned.append(points[i]);
        }
    }
    return thinned;
}

}  // namespace ravnoves
