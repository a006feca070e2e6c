#include "workshop/formulas.h"

#include "bob-weights/formulas.h"
#include "v8-plugs/formulas.h"

namespace ravnoves::workshop {

std::vector<Formula> formulas(const Input& input) {
    std::vector<Formula> list =
        input.plugs ? v8_plugs::formulas(*input.plugs) : std::vector<Formula>();
    for (Formula& formula : bob_weights::formulas(input)) {
        list.push_back(std::move(formula));
    }
    return list;
}

std::span<const Text> left_out() {
    static const std::vector<Text> texts = [] {
        std::vector<Text> all(bob_weights::left_out().begin(), bob_weights::left_out().end());
        const auto plugs = v8_plugs::left_out();
        all.insert(all.end(), plugs.begin(), plugs.end());
        return all;
    }();
    return texts;
}

}  // namespace ravnoves::workshop
