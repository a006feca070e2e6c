#pragma once

#include <QString>

namespace ravnoves {

/// Why nothing but a case may be written to this file: it is an open case, or one that an open
/// case reads. Empty where it is neither.
QString sourceTrouble(const QString& path);

}  // namespace ravnoves
