#pragma once

#include "workshop/input.h"

/// The balancing machine that new jobs begin with, in the settings of the program.
namespace ravnoves::shop_machine {

workshop::Machine kept();
void keep(const workshop::Machine& machine);

}  // namespace ravnoves::shop_machine
