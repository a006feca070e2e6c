#pragma once

#include "case-file/message.h"

namespace ravnoves {

/// What the operating system says of a file, by its errno: "No space left on device". The common
/// ones are translated, the others as the system has them.
Message system_fault(int error);

}  // namespace ravnoves
