#pragma once

#include <QImage>
#include <QPolygonF>
#include <QRectF>
#include <span>

namespace ravnoves {

/// The drawing of a plot, as a coarse picture, and its labels: finds the place for one more where
/// it covers the minimum.
class LabelPlaces {
  public:
    explicit LabelPlaces(const QRectF& area);

    void addLine(const QPolygonF& line);
    /// A dot or a bar.
    void addShape(const QRectF& shape) { fill(shape, drawn); }
    /// Nothing may be over it.
    void addLabel(const QRectF& label) { fill(label, written); }
    /// How much a label here would cover; 0 where nothing is.
    int covered(const QRectF& label) const;
    /// Of places for one label, the most wanted first, the one that covers the minimum; moved into
    /// the area and occupied.
    QRectF place(std::span<const QRectF> places);

  private:
    static constexpr uchar drawn = 1;
    static constexpr uchar written = 255;

    QRect cells(const QRectF& box) const;
    void fill(const QRectF& box, uchar grey);

    QRectF area_;
    QImage taken_;  ///< grey
};

}  // namespace ravnoves
