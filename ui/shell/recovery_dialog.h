#pragma once

#include <functional>

#include "model/recovery.h"

class QWidget;

namespace ravnoves {

/// Offers what a crash has left: to restore it, to delete it, or to ask again at the next start.
/// @param restore  of a case; false where its copy is still needed
void offerRecovered(QWidget* over, const Recovery::Found& found,
                    const std::function<bool(const RecoveredCase&)>& restore);

}  // namespace ravnoves
