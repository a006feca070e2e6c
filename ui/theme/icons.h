#pragma once

#include <QByteArray>
#include <QIcon>
#include <QString>

namespace ravnoves {

/// The bundled line icon of that name (resources/icons/NAME.svg), drawn in the text colour of the
/// present theme at any size; a null icon without one.
QIcon themedIcon(const QString& name);

/// A picture's SVG in the colours of the present theme: currentColor is the text's, and
/// var(--panel), --grid, --muted, --accent, --warning, --good, --error and the words of the roles
/// are Theme's. Empty without such a file.
QByteArray themedSvg(const QString& path);

}  // namespace ravnoves
