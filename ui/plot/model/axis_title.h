#pragma once

#include <QFont>
#include <QString>

namespace ravnoves {

/// The title of an axis within `room` pixels: its words are shortened, its unit never. "first-order
/// force F₁, N" becomes "first-or…, N", at last "N".
QString fittedAxisTitle(const QString& title, const QFont& font, double room);

}  // namespace ravnoves
