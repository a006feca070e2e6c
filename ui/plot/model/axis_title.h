#pragma once

#include <QFont>
#include <QString>

namespace ravnoves {

/// The title of an axis in so many pixels: its words give way first, then its symbol, its unit
/// never. "first-order force F₁, N" becomes "first-or… F₁, N", then "F₁, N", at last "N".
QString fittedAxisTitle(const QString& title, const QFont& font, double room);

}  // namespace ravnoves
