#include "plot/model/label_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pictures/model/crossings.h"

namespace ravnoves {

namespace {

constexpr double cell = 2.0;  // pixels: a label beside a line is not on it
constexpr int maxCells = 4000;

int cellsOf(double pixels) {
    return std::clamp(static_cast<int>(std::ceil(pixels / cell)), 1, maxCells);
}

}  // namespace

LabelPlaces::LabelPlaces(const QRectF& area)
    : area_(area),
      columns_(cellsOf(area.width())),
      rows_(cellsOf(area.height())),
      taken_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void LabelPlaces::take(const QPointF& at) {
    const int column =
        std::clamp(static_cast<int>((at.x() - area_.left()) / cell), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>((at.y() - area_.top()) / cell), 0, rows_ - 1);
    taken_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column)] = 1;
}

void LabelPlaces::addLine(const QPolygonF& line) {
    for (qsizetype i = 1; i < line.size(); ++i) {
        addLine(line[i - 1], line[i]);
    }
}

void LabelPlaces::addLine(const QPointF& from, const QPointF& to) {
    const auto seen = crossings({from, to}, area_);
    if (!seen) {
        return;
    }
    const QPointF start = QLineF(from, to).pointAt(seen->first);
    const QPointF along = QLineF(from, to).pointAt(seen->second) - start;
    const int steps =
        1 + static_cast<int>(std::max(std::abs(along.x()), std::abs(along.y())) / cell);
    for (int i = 0; i <= steps; ++i) {
        take(start + along * i / steps);
    }
}

void LabelPlaces::addShape(const QRectF& shape) {
    if (!shape.intersects(area_)) {
        return;
    }
    const QRectF inside = shape.intersected(area_);
    const auto columns = static_cast<int>(std::ceil(inside.width() / cell));
    const auto rows = static_cast<int>(std::ceil(inside.height() / cell));
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            take({std::min(inside.left() + column * cell, inside.right()),
                  std::min(inside.top() + row * cell, inside.bottom())});
        }
    }
}

void LabelPlaces::addLabel(const QRectF& label) {
    if (!label.isEmpty()) {
        labels_.push_back(label);
    }
}

double LabelPlaces::covered(const QRectF& label) const {
    const auto index = [](double pixels, int maximum) {
        return std::clamp(static_cast<int>(std::floor(pixels / cell)), 0, maximum - 1);
    };
    const int left = index(label.left() - area_.left(), columns_);
    const int right = index(label.right() - area_.left(), columns_);
    const int top = index(label.top() - area_.top(), rows_);
    const int bottom = index(label.bottom() - area_.top(), rows_);
    int sum = 0;
    for (int row = top; row <= bottom; ++row) {
        const auto* line = taken_.data() + static_cast<std::ptrdiff_t>(row) * columns_;
        for (int column = left; column <= right; ++column) {
            sum += line[column];
        }
    }
    constexpr double perLabel = 1000.0;
    const auto over = std::count_if(labels_.begin(), labels_.end(),
                                    [&](const QRectF& other) { return other.intersects(label); });
    return sum + perLabel * static_cast<double>(over);
}

QRectF LabelPlaces::moved(QRectF label) const {
    label.moveLeft(std::max(area_.left(), std::min(label.left(), area_.right() - label.width())));
    label.moveTop(std::max(area_.top(), std::min(label.top(), area_.bottom() - label.height())));
    return label;
}

QRectF LabelPlaces::place(std::span<const QRectF> places) {
    QRectF best;
    double minimum = std::numeric_limits<double>::infinity();
    // A place farther down the list must be better by something, so that labels stay where they
    // are wanted and rest while curves move a little.
    constexpr double wish = 0.15;
    double wished = 0.0;
    for (const QRectF& each : places) {
        if (minimum <= wished) {
            break;
        }
        const QRectF label = moved(each);
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
