#pragma once

#include <QColor>
#include <QRectF>
#include <QString>
#include <vector>

#include "theme/theme.h"

class QPainter;

namespace ravnoves {

/// The colour of what a shaft does: blue where it helps, orange where it harms, the more the
/// stronger; the eye that sees no red tells them apart, and so does grey from either.
/// @param part  from −1, helps most, over 0, no change, to 1, harms most
QColor changeColour(double part);

/// Of the key to these colours, pixels.
inline double colourBarHeight() {
    return Theme::withText(10);
}
inline double longestColourBar() {
    return Theme::withText(460);
}

/// A number below a bar of colours, with a line in the bar.
struct BarNumber {
    double part;  ///< of the bar's width
    QString text;
    bool isNoChange = false;  ///< its line is broad
};
/// Frames a bar and writes its numbers, in the painter's font or, where two would meet, in
/// a smaller one; what meets those before it in the list even so has its line alone.
void paintBarNumbers(QPainter& painter, const QRectF& bar, const std::vector<BarNumber>& numbers);

/// From one colour to another, 0…1.
QColor mixedColour(const QColor& from, const QColor& to, double part);

}  // namespace ravnoves
