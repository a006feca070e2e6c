#pragma once

#include <QHBoxLayout>
#include <QMargins>
#include <QScreen>
#include <QVBoxLayout>

#include "theme/theme.h"

namespace ravnoves {

// Margins on a page, beside none at all.
inline constexpr QMargins tabMargins(0, Theme::space, 0, 0);  ///< below the titles of tabs
inline constexpr QMargins panelMargins(Theme::margin, Theme::space, Theme::margin, Theme::space);
inline constexpr QMargins barMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
/// Of a panel with a table, which has margins of its own.
inline constexpr QMargins tableMargins(Theme::space, Theme::space, Theme::space, Theme::space);

/// A column over all of a widget.
/// @param spacing  −1: the style's
inline QVBoxLayout* columnIn(QWidget* widget, int spacing = Theme::space,
                             const QMargins& margins = {}) {
    auto* column = new QVBoxLayout(widget);
    column->setContentsMargins(margins);
    column->setSpacing(spacing);
    return column;
}

/// The same beside each other.
inline QHBoxLayout* rowIn(QWidget* widget, int spacing = Theme::space,
                          const QMargins& margins = {}) {
    auto* row = new QHBoxLayout(widget);
    row->setContentsMargins(margins);
    row->setSpacing(spacing);
    return row;
}

/// Gives a dialog its size at normal text, grown with the text within the screen.
inline void resizeWithText(QWidget* dialog, int width, int height) {
    constexpr QSize frame(20, 50);  // of the window, with its title
    dialog->resize(QSize(Theme::withText(width), Theme::withText(height))
                       .boundedTo(dialog->screen()->availableSize() - frame));
}

}  // namespace ravnoves
