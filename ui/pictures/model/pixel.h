#pragma once

#include <QImage>
#include <QRect>
#include <QRgb>

class QPainter;

namespace ravnoves {

/// Whether a painter paints pixels, moved and scaled at most, and alike in both directions.
bool paintsPixels(const QPainter& painter);

/// The pixels that a box covers under such a painter, to be written to: of the picture that it
/// paints on, or of a clear layer, which is laid over anything else in the end. Of a small box
/// where the painter is clipped a layer, too: reading the clip takes as long.
class PaintedPixels {
  public:
    /// @param box  on the device
    PaintedPixels(QPainter& painter, const QRectF& box);
    ~PaintedPixels();
    PaintedPixels(const PaintedPixels&) = delete;
    PaintedPixels& operator=(const PaintedPixels&) = delete;

    /// RGB32 or premultiplied ARGB32.
    QImage& picture() { return picture_ != nullptr ? *picture_ : layer_; }
    QPoint corner() const { return picture_ != nullptr ? QPoint() : seen_.topLeft(); }
    /// What of the box may be written to, on the device, where the picture begins at the corner.
    const QRect& seen() const { return seen_; }

  private:
    QPainter& painter_;
    QRect seen_;
    QImage* picture_ = nullptr;
    QImage layer_;
};

/// A premultiplied colour over another.
inline QRgb laidOver(QRgb colour, QRgb below) {
    constexpr QRgb pair = 0xff00ff;
    const QRgb rest = 255 - (colour >> 24);
    const auto dimmed = [rest](QRgb channels) {
        const QRgb part = channels * rest;
        return ((part + ((part >> 8) & pair) + 0x800080) >> 8) & pair;
    };
    return colour + (dimmed(below & pair) | dimmed((below >> 8) & pair) << 8);
}

/// A share from 0 to 1 in the 256 steps of a pixel's channel: for each pixel, so without a call.
inline int pixelStep(double share) {
    return static_cast<int>(255.0 * share + 0.5);  // NOLINT(bugprone-incorrect-roundings)
}

}  // namespace ravnoves
