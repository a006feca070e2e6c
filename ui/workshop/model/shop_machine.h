#pragma once

#include "workshop/input.h"

/// The balancing machine as the shop has set it up: new jobs begin with it.
namespace ravnoves::shop_machine {

workshop::Machine kept();
void keep(const workshop::Machine& machine);

}  // namespace ravnoves::shop_machine
