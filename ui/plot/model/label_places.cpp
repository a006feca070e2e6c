#include "plot/model/label_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "pictures/model/stroke.h"

namespace ravnoves {

namespace {

constexpr double cell = 2.0;  // pixels: a label beside a line is not on it

}  // namespace

LabelPlaces::LabelPlaces(const QRectF& area)
    : area_(area),
      taken_((area.size() / cell).toSize().expandedTo({1, 1}), QImage::Format_Grayscale8) {
    taken_.fill(0);
}

QRect LabelPlaces::cells(const QRectF& box) const {
    const QRectF scaled((box.topLeft() - area_.topLeft()) / cell, box.size() / cell);
    return (scaled & QRectF(taken_.rect())).toAlignedRect() & taken_.rect();
}

void LabelPlaces::addLine(const QPolygonF& line) {
    uchar* const cells = taken_.bits();
    const QSize last = taken_.size() - QSize(1, 1);
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QLineF part(line[i - 1], line[i]);
        const auto seen = crossings(part, area_);
        if (!seen) {
            continue;
        }
        const QPointF start = (part.pointAt(seen->first) - area_.topLeft()) / cell;
        const QPointF along = (part.p2() - part.p1()) * ((seen->second - seen->first) / cell);
        const int steps = 1 + static_cast<int>(std::max(std::abs(along.x()), std::abs(along.y())));
        for (int step = 0; step <= steps; ++step) {
            const QPointF at = start + along * (static_cast<double>(step) / steps);
            const int row = std::clamp(static_cast<int>(at.y()), 0, last.height());
            cells[row * taken_.bytesPerLine() +
                  std::clamp(static_cast<int>(at.x()), 0, last.width())] = drawn;
        }
    }
}

void LabelPlaces::fill(const QRectF& box, uchar grey) {
    const QRect where = cells(box);
    for (int row = where.top(); row <= where.bottom(); ++row) {
        std::fill_n(taken_.scanLine(row) + where.left(), where.width(), grey);
    }
}

int LabelPlaces::covered(const QRectF& label) const {
    const QRect where = cells(label);
    int sum = 0;
    for (int row = where.top(); row <= where.bottom(); ++row) {
        const uchar* line = taken_.constScanLine(row) + where.left();
        sum = std::accumulate(line, line + where.width(), sum);
    }
    return sum;
}

QRectF LabelPlaces::place(std::span<const QRectF> places) {
    QRectF best;
    double minimum = std::numeric_limits<double>::infinity();
    // A place farther down the list must be better by something, so that labels stay where they
    // are wanted and rest while curves move a little.
    constexpr double wish = 0.15;
    double wished = 0.0;
    for (QRectF label : places) {
        if (minimum <= wished) {
            break;
        }
        label.moveLeft(
            std::max(area_.left(), std::min(label.left(), area_.right() - label.width())));
        label.moveTop(
            std::max(area_.top(), std::min(label.top(), area_.bottom() - label.height())));
        if (const double costs = covered(label) + wished; costs < minimum) {
            minimum = costs;
            best = label;
        }
        wished += wish;
    }
    addLabel(best);
    return best;
}

}  // namespace ravnoves
