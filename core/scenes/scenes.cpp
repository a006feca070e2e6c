#include "scenes/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "balance-shaft/scene.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "elastic-hinge/scene.h"
#include "inertia-moments/scene.h"
#include "numerics/demand.h"
#include "v8-plugs/scene.h"

namespace ravnoves {

namespace {

void check_finite(const Json& value, const std::string& pointer) {
    RAVNOVES_DEMAND(!value.is_number_float() || std::isfinite(value.get<double>()),
                    "the result " + pointer + " must be finite");
    if (value.is_structured()) {
        for (const auto& item : value.items()) {
            check_finite(item.value(), pointer + "/" + item.key());
        }
    }
}

void collect_files(const Json& value, const std::filesystem::path& directory,
                   std::vector<std::filesystem::path>& files) {
    if (!value.is_structured()) {
        return;
    }
    for (const auto& item : value.items()) {
        if (item.value().is_string() && value.is_object() && item.key() == "csv") {
            files.push_back(directory / item.value().get_ref<const std::string&>());
        }
        collect_files(item.value(), directory, files);
    }
}

}  // namespace

std::span<const SceneSolver> scene_solvers() {
    // One line per scene; the order is that of the navigation.
    static const std::array scenes{
        SceneSolver{"balance-shaft", balance_shaft::solve_scene},
        SceneSolver{"elastic-hinge", elastic_hinge::solve_scene},
        SceneSolver{"v8-plugs", v8_plugs::solve_scene},
        SceneSolver{"inertia-moments", inertia_moments::solve_scene},
    };
    return scenes;
}

CaseFile read_case(Json document) {
    std::vector<std::string> names;
    for (const SceneSolver& scene : scene_solvers()) {
        names.emplace_back(scene.name);
    }
    return read_case(std::move(document), names);
}

CaseFile parse_case(std::string_view text) {
    return read_case(parse_json(text));
}

std::vector<std::filesystem::path> files_named_by(const CaseFile& file,
                                                  const CaseContext& context) {
    std::vector<std::filesystem::path> files;
    collect_files(file.input, context.directory, files);
    collect_files(file.kept, context.directory, files);
    for (const CaseVariant& variant : file.variants) {
        collect_files(variant.input, context.directory, files);
    }
    return files;
}

Json solve_case(const CaseFile& file, const CaseContext& context) {
    const auto scenes = scene_solvers();
    const auto scene = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const SceneSolver& s) { return s.name == file.scene; });
    if (scene == scenes.end()) {
        throw InputError("/scene", CORE_TEXT("core", "must be a known scene"), file.scene);
    }
    Json result = scene->solve(file.input, context);
    check_finite(result, "/result");
    return {{"format", result_format},
            {"version", case_version},
            {"scene", file.scene},
            {"title", file.title},
            {"result", std::move(result)}};
}

}  // namespace ravnoves
