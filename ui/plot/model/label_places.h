#pragma once

#include <QPolygonF>
#include <QRectF>
#include <span>
#include <vector>

namespace ravnoves {

/// The drawing of a plot, on a coarse grid, and its labels: finds the place for one more where it
/// covers the minimum.
class LabelPlaces {
  public:
    explicit LabelPlaces(const QRectF& area);

    void addLine(const QPolygonF& line);
    void addLine(const QPointF& from, const QPointF& to);
    /// A dot or a bar.
    void addShape(const QRectF& shape);
    /// Nothing may be over it.
    void addLabel(const QRectF& label);
    /// How much a label here would cover; 0 where nothing is.
    double covered(const QRectF& label) const;
    /// Of places for one label, the most wanted first, the one that covers the minimum; moved into
    /// the area and occupied.
    QRectF place(std::span<const QRectF> places);

  private:
    QRectF moved(QRectF label) const;
    void take(const QPointF& at);

    QRectF area_;
    int columns_;
    int rows_;
    std::vector<unsigned char> taken_;  ///< each cell of the grid
    std::vector<QRectF> labels_;
};

}  // namespace ravnoves
