#pragma once

#include <QIcon>
#include <QString>

namespace ravnoves {

/// The bundled line icon of that name (resources/icons/NAME.svg), drawn in the text colour of the
/// present theme at any size; a null icon where there is none.
QIcon themedIcon(const QString& name);

}  // namespace ravnoves
