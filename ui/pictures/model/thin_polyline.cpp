#include "pictures/model/thin_polyline.h"

#include <algorithm>
#include <utility>

namespace ravnoves {

QPolygonF thinPolyline(const std::vector<QPointF>& points, double tolerance) {
    if (points.size() <= 2) {
        return QPolygonF(QList<QPointF>(points.begin(), points.end()));
    }
    std::vector<char> keep(points.size(), 0);
    keep.front() = 1;
    std::size_t kept = 1;
    // In pieces: halving the whole line would look at each point as often as that takes.
    constexpr std::size_t piece = 48;
    std::vector<std::pair<std::size_t, std::size_t>> spans;
    for (std::size_t first = 0; first + 1 < points.size(); first += piece) {
        const std::size_t last = std::min(first + piece, points.size() - 1);
        spans.emplace_back(first, last);
        keep[last] = 1;
        ++kept;
    }
    while (!spans.empty()) {
        const auto [first, last] = spans.back();
        spans.pop_back();
        const QPointF a = points[first];
        const QPointF way = points[last] - a;
        const double reach = QPointF::dotProduct(way, way);
        // A closed span has no direction: any will do.
        const QPointF d = reach > 0.0 ? way : QPointF(1.0, 0.0);
        // Squares of distances, times that of d's length: nothing is divided.
        double farthest = 0.0;
        std::size_t at = first;
        for (std::size_t i = first + 1; i < last; ++i) {
            const QPointF p = points[i] - a;
            // Beside the span the distance to its end counts: a line that comes back on itself
            // keeps its turning points.
            const double along = QPointF::dotProduct(p, d);
            const double across = d.x() * p.y() - d.y() * p.x();
            const double past = along > reach ? along - reach : std::min(along, 0.0);
            const double distance = across * across + past * past;
            if (distance > farthest) {
                farthest = distance;
                at = i;
            }
        }
        if (farthest > tolerance * tolerance * QPointF::dotProduct(d, d)) {
            keep[at] = 1;
            ++kept;
            spans.emplace_back(first, at);
            spans.emplace_back(at, last);
        }
    }
    QPolygonF thinned;
    thinned.reserve(static_cast<qsizetype>(kept));
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (keep[i] != 0) {
            thinned.append(points[i]);
        }
    }
    return thinned;
}

}  // namespace ravnoves
