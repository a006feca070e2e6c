#pragma once

#include <QRect>
#include <QRgb>

class QImage;
class QPainter;

namespace ravnoves {

/// Whether a painter paints pixels, moved and scaled at most, and alike in both directions.
bool paintsPixels(const QPainter& painter);

/// Whether the pixels of a picture can be written to beside a painter: opaque or premultiplied, 4
/// bytes each.
bool hasWritablePixels(const QImage& picture);

/// The picture under a painter, where its pixels can be written directly, in 4 bytes each, and the
/// pixels of a box that the painter may change.
struct PaintedPixels {
    QImage* picture = nullptr;
    QRect seen;
};
/// No picture for other devices, as a widget, and of a small box where the painter is clipped:
/// reading the clip takes as long as a layer of that size.
PaintedPixels pixelsOf(const QPainter& painter, const QRectF& box);

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
