#include "plot/model/label_places.h"

#include <QPainter>
#include <algorithm>
#include <limits>
#include <numeric>

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
    QPainter painter(&taken_);
    painter.setPen(QPen(QColor(drawn, drawn, drawn), 0.0));
    painter.scale(1.0 / cell, 1.0 / cell);
    painter.translate(-area_.topLeft());
    painter.drawPolyline(line);
}

void LabelPlaces::fill(const QRectF& box, int grey) {
    const QRect where = cells(box);
    for (int row = where.top(); row <= where.bottom(); ++row) {
        std::fill_n(taken_.scanLine(row) + where.left(), where.width(), static_cast<uchar>(grey));
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
