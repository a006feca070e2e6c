#pragma once

#include <span>
#include <string_view>

#include "model/part.h"

namespace ravnoves {

class BalanceShaftModel;

/// What the page of the balance shaft shows.
std::span<const PagePart> shaftParts();
Content shaftPart(const BalanceShaftModel& model, std::string_view id);

}  // namespace ravnoves
