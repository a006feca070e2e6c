#include "methods/case_questions.h"

#include <algorithm>
#include <array>

#include "balance-shaft/dead_centre.h"
#include "balance-shaft/method_choices.h"
#include "balance-shaft/scene.h"
#include "case-file/field_reader.h"
#include "elastic-hinge/method_choices.h"
#include "elastic-hinge/scene.h"
#include "inertia-moments/method_choices.h"
#include "inertia-moments/scene.h"
#include "numerics/constants.h"
#include "numerics/demand.h"
#include "workshop/older_formats.h"

namespace ravnoves::methods {

namespace {

using Pointers = std::span<const std::string_view>;

constexpr std::array<std::string_view, 6> bob_weights_results{"/bobweight_g",
                                                              "/correction/planes/0/unbalance_g_mm",
                                                              "/correction/planes/1/unbalance_g_mm",
                                                              "/correction/planes/0/remaining_g_mm",
                                                              "/correction/planes/1/remaining_g_mm",
                                                              "/permissible_rotor_g_mm"};
constexpr std::array<std::string_view, 2> plugs_results{
    "/options/steel-machined/required_reduction_g", "/k_y"};
constexpr std::array<std::string_view, 6> workshop_results{
    "/bobweight_g",
    "/plugs/options/steel-machined/required_reduction_g",
    "/correction/planes/0/unbalance_g_mm",
    "/correction/planes/1/unbalance_g_mm",
    "/correction/planes/0/remaining_g_mm",
    "/correction/planes/1/remaining_g_mm"};

template <typename Input>
std::vector<FieldEntry> fields_of(const Json& input) {
    return list_fields(read_fields<Input>(input, Completeness::as_is));
}

/// The phase of a pressure trace, as its compression line tells the dead centre.
std::vector<studies::Varied> phase_of_trace(const Json& input, const CaseContext& context) {
    const balance_shaft::Input read = balance_shaft::read_input(input, context);
    const auto centre = find_dead_centre(read);
    if (!centre) {
        return {};
    }
    return {{.pointer = "/torque/pressure/crank_angle_shift_deg",
             .spread = studies::Varied::Spread::uniform,
             .from = (read.torque.trace_shift - centre->uncertainty) / degree,
             .to = (read.torque.trace_shift + centre->uncertainty) / degree}};
}

}  // namespace

const CaseQuestions& questions_of(std::string_view scene) {
    static const std::array all{
        CaseQuestions{"balance-shaft",
                      balance_shaft::leading_results,
                      fields_of<balance_shaft::Input>,
                      balance_shaft::method_choices,
                      {},
                      {},
                      phase_of_trace},
        CaseQuestions{"elastic-hinge", elastic_hinge::leading_results,
                      fields_of<elastic_hinge::Input>, elastic_hinge::method_choices},
        CaseQuestions{"workshop", workshop_results, fields_of<workshop::Input>},
        CaseQuestions{"v8-plugs", plugs_results, fields_of<workshop::PlugsCase>},
        CaseQuestions{"bob-weights", bob_weights_results, fields_of<workshop::BobWeightsCase>},
        CaseQuestions{"inertia-moments", inertia_moments::leading_results,
                      fields_of<inertia_moments::Input>, Pointers(), "/exact", "/two_term"},
    };
    const auto found = std::find_if(all.begin(), all.end(), [&](const CaseQuestions& questions) {
        return questions.scene == scene;
    });
    RAVNOVES_DEMAND(found != all.end(), "every scene says what its answers lead with");
    return *found;
}

}  // namespace ravnoves::methods
