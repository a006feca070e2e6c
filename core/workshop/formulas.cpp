#include "workshop/results.h"

#include <array>

#include "bob-weights/results.h"
#include "v8-plugs/results.h"

namespace ravnoves::workshop {

std::vector<Formula> formulas(const Input& input) {
    std::vector<Formula> list =
        input.plugs ? v8_plugs::formulas(*input.plugs) : std::vector<Formula>();
    const std::vector<Formula> shaft = bob_weights::formulas(input);
    list.insert(list.end(), shaft.begin(), shaft.end());
    return list;
}

std::span<const Text> left_out() {
    static constexpr std::array texts{
        Text::tr("The crankshaft is rigid."),
        Text::tr("The factor uses the first order only; bob weights cannot affect higher orders."),
        Text::tr("Couples along the crankshaft are not part of the factor: see inertia moments."),
        Text::tr("The rim of a counterweight is taken as flat at a hole."),
        Text::tr("All bob weights are equal, from the means of the weighed parts."),
        Text::tr("Not included: drilling in the webs, flywheel and damper."),
    };
    return texts;
}

}  // namespace ravnoves::workshop
