#pragma once

#include <QImage>
#include <algorithm>
#include <cstdlib>

namespace ravnoves::test {

/// How two pictures differ, where they have the same place.
struct Difference {
    int most = 0;       ///< of a channel, 0…255
    double grey = 0.0;  ///< sum over the pixels, in 255 shades
    int drawn = 0;      ///< pixels that are not white in both
    int seen = 0;       ///< pixels that an eye tells apart; a text cursor has some thirty

    /// Of the drawn pixels.
    double mean() const { return drawn > 0 ? grey / drawn : 0.0; }
};

inline Difference differenceOf(const QImage& one, const QImage& other) {
    constexpr int seen = 50;  // the three channels' sum
    Difference found;
    const QRect both = one.rect() & other.rect();
    for (int y = 0; y < both.height(); ++y) {
        for (int x = 0; x < both.width(); ++x) {
            const QRgb a = one.pixel(x, y);
            const QRgb b = other.pixel(x, y);
            const int red = std::abs(qRed(a) - qRed(b));
            const int green = std::abs(qGreen(a) - qGreen(b));
            const int blue = std::abs(qBlue(a) - qBlue(b));
            found.most = std::max({found.most, red, green, blue});
            found.grey += std::abs(qGray(a) - qGray(b));
            found.drawn += qGray(a) < 255 || qGray(b) < 255 ? 1 : 0;
            found.seen += red + green + blue >= seen ? 1 : 0;
        }
    }
    return found;
}

}  // namespace ravnoves::test
