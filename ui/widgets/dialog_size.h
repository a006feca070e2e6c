#pragma once

#include <QScreen>
#include <QWidget>

#include "theme/theme.h"

namespace ravnoves {

/// Gives a dialog its size at normal text, grown with the text within the screen.
inline void resizeWithText(QWidget* dialog, int width, int height) {
    constexpr QSize frame(20, 50);  // of the window, with its title
    dialog->resize(QSize(Theme::withText(width), Theme::withText(height))
                       .boundedTo(dialog->screen()->availableSize() - frame));
}

}  // namespace ravnoves
