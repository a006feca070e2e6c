#pragma once

#include <QByteArray>
#include <QIcon>
#include <QString>

namespace ravnoves {

/// The bundled line icon of that name (resources/icons/NAME.svg), drawn in the text colour of the
/// present theme at any size; a null icon where there is none.
QIcon themedIcon(const QString& name);

/// A picture's SVG in the colours of the present theme: currentColor is the text's, and
/// var(--panel), --grid, --muted, --accent, --error and --curve-0 … --curve-7 are those of Theme.
/// Empty where there is no such file.
QByteArray themedSvg(const QString& path);

}  // namespace ravnoves
