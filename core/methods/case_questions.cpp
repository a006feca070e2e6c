#include "methods/case_questions.h"

#include <algorithm>
#include <array>

#include "balance-shaft/dead_centre.h"
#include "balance-shaft/scene.h"
#include "case-file/field_reader.h"
#include "elastic-hinge/input.h"
#include "inertia-moments/input.h"
#include "numerics/constants.h"
#include "numerics/demand.h"
#include "workshop/older_formats.h"

namespace ravnoves::methods {

namespace {

using Pointers = std::span<const std::string_view>;

constexpr std::array<std::string_view, 6> balance_shaft_results{
    "/metrics/M_ups/range_Nm", "/metrics/M_ups/rms_Nm", "/optimum/range/shaft_angle_deg",
    "/optimum/range/range_Nm", "/moment_amplitude_Nm",  "/flywheel/excess_work_J"};
constexpr std::array<std::string_view, 1> balance_shaft_choices{"/interpolation"};
constexpr std::array<std::string_view, 6> elastic_hinge_results{
    "/guide/minimum_preload_mm", "/guide/relief_mm",           "/rod_hinge_moment_integral_J",
    "/counterweight_weight_N",   "/rod_hinge_guide/relief_mm", "/side_force/largest_with_hinge_N"};
constexpr std::array<std::string_view, 1> elastic_hinge_choices{"/kinematics"};
constexpr std::array<std::string_view, 8> inertia_moments_results{
    "/exact/order_1/force_N/forward/amplitude",   "/exact/order_1/force_N/backward/amplitude",
    "/exact/order_1/moment_Nm/forward/amplitude", "/exact/order_1/moment_Nm/backward/amplitude",
    "/exact/order_2/force_N/forward/amplitude",   "/exact/order_2/force_N/backward/amplitude",
    "/exact/order_2/moment_Nm/forward/amplitude", "/exact/order_2/moment_Nm/backward/amplitude"};
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
                      balance_shaft_results,
                      fields_of<balance_shaft::Input>,
                      balance_shaft_choices,
                      {},
                      {},
                      phase_of_trace},
        CaseQuestions{"elastic-hinge", elastic_hinge_results, fields_of<elastic_hinge::Input>,
                      elastic_hinge_choices},
        CaseQuestions{"workshop", workshop_results, fields_of<workshop::Input>},
        CaseQuestions{"v8-plugs", plugs_results, fields_of<workshop::PlugsCase>},
        CaseQuestions{"bob-weights", bob_weights_results, fields_of<workshop::BobWeightsCase>},
        CaseQuestions{"inertia-moments", inertia_moments_results, fields_of<inertia_moments::Input>,
                      Pointers(), "/exact", "/two_term"},
    };
    const auto found = std::find_if(all.begin(), all.end(), [&](const CaseQuestions& questions) {
        return questions.scene == scene;
    });
    RAVNOVES_DEMAND(found != all.end(), "every scene says what its answers lead with");
    return *found;
}

}  // namespace ravnoves::methods
