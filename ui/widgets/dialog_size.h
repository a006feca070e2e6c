#pragma once

#include <QScreen>
#include <QWidget>

#include "theme/theme.h"

namespace ravnoves {

/// Gives a dialog the size that it has with normal text, grown with the text as far as the screen
/// goes.
inline void resizeWithText(QWidget* dialog, int width, int height) {
    constexpr QSize frame(20, 50);  // of the window, with its title
    dialog->resize(QSize(Theme::withText(width), Theme::withText(height))
                       .boundedTo(dialog->screen()->availableSize() - frame));
}

}  // namespace ravnoves
