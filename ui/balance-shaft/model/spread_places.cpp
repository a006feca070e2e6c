#include "balance-shaft/model/spread_places.h"

#include <cmath>

namespace ravnoves {

std::vector<QPointF> spreadApart(std::vector<QPointF> places, double apart, const QRectF& inside) {
    constexpr int rounds = 40;  // what is left then may touch
    bool moved = inside.isValid();
    for (int round = 0; round < rounds && moved; ++round) {
        moved = false;
        for (std::size_t i = 0; i < places.size(); ++i) {
            for (std::size_t other = i + 1; other < places.size(); ++other) {
                QPointF way = places[other] - places[i];
                const double distance = std::hypot(way.x(), way.y());
                constexpr double same = 0.5;
                if (distance >= apart - same || !inside.contains(places[i]) ||
                    !inside.contains(places[other])) {
                    continue;
                }
                way = distance < same ? QPointF(0.0, 1.0) : way / distance;
                places[i] -= 0.5 * (apart - distance) * way;
                places[other] += 0.5 * (apart - distance) * way;
                moved = true;
            }
        }
    }
    return places;
}

}  // namespace ravnoves
