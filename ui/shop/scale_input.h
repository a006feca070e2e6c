#pragma once

#include <QString>

#include "shop/scale_line.h"

class QWidget;

namespace ravnoves {

/// No scale writes into a field, unless the user has focused it.
void setTypedAlone(QWidget* field);
bool isTypedAlone(const QWidget* field);

/// A weight as text that every mass field takes: "568.50 g".
QString scaleText(const shop::ScaleLine& line);

/// What a line means: "568.50 g, stable".
QString meaningOf(const shop::ScaleLine& line);

/// Puts a weight into the field with the focus, as if it were typed and Enter pressed: the
/// next one has the focus then. Only fields of masses accept it; one that rejects it keeps its
/// value and the focus.
/// @return the result, for the status bar
QString enterWeight(const shop::ScaleLine& line);

}  // namespace ravnoves
