#include "balance-shaft/change_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "theme/theme.h"

namespace ravnoves {

QColor mixedColour(const QColor& from, const QColor& to, double part) {
    const auto channel = [&](int a, int b) {
        return static_cast<int>(std::lround(a + (b - a) * part));
    };
    return {channel(from.red(), to.red()), channel(from.green(), to.green()),
            channel(from.blue(), to.blue())};
}

QColor changeColour(double part) {
    const bool dark = Theme::instance().isDark();
    const QColor neutral = dark ? QColor(0x2b3036) : QColor(0xf7f7f5);
    const std::array help = dark ? std::array{QColor(0x24557f), QColor(0x6cc0ff)}
                                 : std::array{QColor(0x92c5de), QColor(0x15508f)};
    const std::array harm = dark ? std::array{QColor(0x7a4a1c), QColor(0xe09a48)}
                                 : std::array{QColor(0xfccf9c), QColor(0xc2650f)};
    const auto& ends = part < 0.0 ? help : harm;
    const double size = std::min(std::abs(part), 1.0);
    return size <= 0.5 ? mixedColour(neutral, ends[0], 0.25 + 1.5 * size)
                       : mixedColour(ends[0], ends[1], 2.0 * size - 1.0);
}

}  // namespace ravnoves
