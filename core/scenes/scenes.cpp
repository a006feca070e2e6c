#include "scenes/scenes.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "balance-shaft/dead_centre.h"
#include "balance-shaft/fields.h"
#include "balance-shaft/input.h"
#include "balance-shaft/presets.h"
#include "balance-shaft/results.h"
#include "case-file/field_reader.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "elastic-hinge/input.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/results.h"
#include "inertia-moments/input.h"
#include "inertia-moments/presets.h"
#include "inertia-moments/results.h"
#include "numerics/constants.h"
#include "scenes/typed_response.h"
#include "workshop/input.h"
#include "workshop/older_formats.h"
#include "workshop/presets.h"
#include "workshop/results.h"

namespace ravnoves {

namespace {

/// Of what was read field by field: rules that join fields, and files that it names, change none.
template <typename Input>
std::vector<Formula> formulas_of(const Json& input) {
    return formulas(read_fields<Input>(input, Completeness::as_is));
}

/// By whichever of its forms a scene reads its input.
template <auto read>
auto read_whole(const Json& json, const CaseContext& context) {
    if constexpr (requires { read(json, context); }) {
        return read(json, context);
    } else if constexpr (requires { read(json); }) {
        return read(json);
    } else {
        return read(json, Completeness::required);
    }
}

template <typename Input, auto read, auto check, typename Results>
std::unique_ptr<Response> respond(const Json& input, const CaseContext& context,
                                  std::span<const std::string> varied,
                                  std::span<const std::string> watched) {
    return std::make_unique<TypedResponse<Input, read_whole<read>, check, Results>>(
        input, context, varied, watched);
}

template <auto read>
void visit(ResultVisitor& visitor, const Json& input, const CaseContext& context) {
    visit_results(visitor, read_whole<read>(input, context));
}

template <typename Input>
std::vector<FieldEntry> fields_in(const Json& input) {
    return list_fields(read_fields<Input>(input, Completeness::as_is));
}

template <auto presets>
std::vector<Preset<Json>> written() {
    std::vector<Preset<Json>> list;
    for (const auto& [title, input] : presets()) {
        list.push_back({title, write_input(input)});
    }
    return list;
}

/// A scene by what each of them has.
template <typename Input, const auto& leading, auto left_out, auto presets, auto read, auto check,
          typename Results = FreshResults<Input>>
SceneSolver scene(std::string_view name, Text title = {}, Text summary = {},
                  std::string_view method = {}, std::string_view buildable = {}) {
    return {.name = name,
            .title = title,
            .summary = summary,
            .visit = visit<read>,
            .formulas = formulas_of<Input>,
            .left_out = left_out,
            .leading = leading,
            .presets = written<presets>,
            .respond = respond<Input, read, check, Results>,
            .fields = fields_in<Input>,
            .buildable = buildable,
            .method = method};
}

/// Of a format that the workshop reads: nobody begins in it.
template <typename Input, const auto& leading, auto read, auto check>
SceneSolver older_scene(std::string_view name) {
    constexpr auto no_presets = [] { return std::vector<Preset<Input>>(); };
    return scene<Input, leading, workshop::left_out, no_presets, read, check>(name);
}

}  // namespace

Json SceneSolver::solve(const Json& input, const CaseContext& context, const Wanted& wanted) const {
    return result_json(
        wanted, VisitResults([&](ResultVisitor& visitor) { visit(visitor, input, context); }));
}

std::vector<ResultEntry> SceneSolver::results(const Json& input, const CaseContext& context) const {
    return list_results([&](ResultVisitor& visitor) { visit(visitor, input, context); });
}

std::span<const SceneSolver> scene_solvers() {
    // One line per scene; the order is that of the navigation.
    static const std::array scenes{
        scene<balance_shaft::Input, balance_shaft::leading, balance_shaft::left_out,
              balance_shaft::presets, balance_shaft::read_input, balance_shaft::check_joined,
              balance_shaft::RepeatedResults>(
            "balance-shaft", Text::tr("Balance shaft"),
            Text::tr("Position the balance shaft of a single-cylinder engine"), "/interpolation",
            "/buildable/at_shaft_angle"),
        scene<elastic_hinge::Input, elastic_hinge::leading, elastic_hinge::left_out,
              elastic_hinge::presets, elastic_hinge::read_input, elastic_hinge::check_input>(
            "elastic-hinge", Text::tr("Elastic hinges"),
            Text::tr("Spring guides for constant crank speed"), "/kinematics"),
        scene<workshop::Input, workshop::leading, workshop::left_out, workshop::presets,
              workshop::read_input, workshop::check_input>(
            "workshop", Text::tr("Workshop"),
            Text::tr("From the scale to the drilled crankshaft, plugs of a V-8 included")),
        older_scene<workshop::PlugsCase, workshop::leading_of_plugs, workshop::read_plugs_case,
                    workshop::check_plugs_case>("v8-plugs"),
        older_scene<workshop::BobWeightsCase, workshop::leading_of_bob_weights,
                    workshop::read_bob_weights_case, workshop::check_bob_weights_case>(
            "bob-weights"),
        scene<inertia_moments::Input, inertia_moments::leading, inertia_moments::left_out,
              inertia_moments::presets, inertia_moments::read_input, inertia_moments::check_input>(
            "inertia-moments", Text::tr("Inertia moments"),
            Text::tr("Forces and moments of VR5 and any other cylinder layout")),
    };
    return scenes;
}

const SceneSolver& scene_solver(const std::string& name) {
    const auto scenes = scene_solvers();
    const auto found = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const SceneSolver& each) { return each.name == name; });
    if (found == scenes.end()) {
        throw InputError("/scene", Text::tr("must be a known module"), name);
    }
    return *found;
}

CaseFile read_case(Json document) {
    std::vector<std::string> names;
    for (const SceneSolver& scene : scene_solvers()) {
        names.emplace_back(scene.name);
    }
    CaseFile file = read_case(std::move(document), names);
    if (file.scene == "balance-shaft") {
        balance_shaft::gather_cylinder(file);
    }
    return file;
}

CaseFile parse_case(std::string_view text) {
    return read_case(parse_json(text));
}

CaseFile parse_shown_case(std::string_view text) {
    return workshop::as_job(parse_case(text));
}

std::optional<std::pair<double, double>> open_ends(const CaseFile& file,
                                                   const CaseContext& context) {
    if (file.scene != "balance-shaft") {
        return std::nullopt;
    }
    const balance_shaft::Input input = balance_shaft::read_input(file.input, context);
    const auto centre = find_dead_centre(input);
    const double shift = input.torque.trace_shift;
    return centre ? std::optional(std::pair((shift - centre->uncertainty) / degree,
                                            (shift + centre->uncertainty) / degree))
                  : std::nullopt;
}

Json solve_case(const CaseFile& file, const CaseContext& context, const Wanted& wanted) {
    Json result = wanted.pick(scene_solver(file.scene).solve(file.input, context, wanted));
    return {{"format", result_format},
            {"version", case_version},
            {"scene", file.scene},
            {"title", file.title},
            {"result", std::move(result)}};
}

}  // namespace ravnoves
