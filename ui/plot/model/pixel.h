#pragma once

class QPainter;

namespace ravnoves {

/// Whether a painter paints pixels, and at most moves and scales what it paints: alike in both
/// directions.
bool paintsPixels(const QPainter& painter);

/// A share from 0 to 1 in the 256 steps of a pixel's channel: for each pixel, so without a call.
inline int pixelStep(double share) {
    return static_cast<int>(255.0 * share + 0.5);  // NOLINT(bugprone-incorrect-roundings)
}

}  // namespace ravnoves
