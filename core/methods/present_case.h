#pragma once

#include <optional>

#include "case-file/case_context.h"
#include "case-file/json_fwd.h"
#include "methods/kernel.h"

namespace ravnoves::methods {

/// Where the case that is open in a kernel's scene stands on one of its sweeps: the value that the
/// case's "input" object gives to the hard parameter. It may lie outside from…to.
///
/// What a case states is taken as it stands (λ, α, c). The rest follows from it: K from the
/// cylinder with the largest offset, the shaft's amplitude P₁ l, the preload above the least one,
/// the half width of the torque's highest peak at e^-½ of its height, and the rows of a table.
///
/// @return empty where a case says nothing of it (a made-up problem, a computed torque's rows, a
///         motion at the design speed)
/// @throws InputError for an input that its scene does not take
std::optional<double> present_value(const Kernel& kernel, std::size_t sweep, const Json& input,
                                    const CaseContext& context = {});

}  // namespace ravnoves::methods
