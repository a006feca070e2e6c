#pragma once

#include <QPolygonF>
#include <QRectF>
#include <span>
#include <vector>

namespace ravnoves {

/// What is drawn in a plot, on a coarse grid, and the labels that are in it: finds the place for
/// one more where it covers least.
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
    /// That of a line of so many pixels.
    static double coveredBy(double length);
    /// True where another label stands.
    bool meetsLabel(const QRectF& label) const;
    /// Of places for one label, the most wanted first, that which covers least; moved into the
    /// area. It is taken then.
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
