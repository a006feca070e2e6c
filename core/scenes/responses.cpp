#include "scenes/responses.h"

#include <utility>

#include "balance-shaft/input_check.h"
#include "balance-shaft/results.h"
#include "balance-shaft/scene.h"
#include "bob-weights/results.h"
#include "bob-weights/scene.h"
#include "case-file/case_file.h"
#include "elastic-hinge/results.h"
#include "elastic-hinge/scene.h"
#include "inertia-moments/results.h"
#include "inertia-moments/scene.h"
#include "scenes/typed_response.h"
#include "v8-plugs/results.h"
#include "v8-plugs/scene.h"
#include "workshop/results.h"
#include "workshop/scene.h"

namespace ravnoves {

namespace {

template <typename Input, auto read>
Input read_alone(const Json& json, const CaseContext& /*context*/) {
    return read(json);
}

template <typename Input, auto read>
Input read_whole(const Json& json, const CaseContext& /*context*/) {
    return read(json, Completeness::required);
}

/// How a scene's results come of its "input" object.
template <typename In, auto read_json, auto check, typename Repeated = AnewResults<In>>
struct Described {
    using Input = In;
    using Response = TypedResponse<In, read_json, check, Repeated>;
    static In read(const Json& json, const CaseContext& context) {
        return read_json(json, context);
    }
};

/// Calls with the Described of a scene. @return what that returns; for another scene, empty
template <typename Use>
auto with_scene(std::string_view scene, Use&& use) {
    if (scene == "balance-shaft") {
        using Input = balance_shaft::Input;
        return use(Described<Input, balance_shaft::read_input, balance_shaft::check_joined,
                             balance_shaft::RepeatedResults>());
    }
    if (scene == "elastic-hinge") {
        using Input = elastic_hinge::Input;
        return use(Described<Input, read_alone<Input, elastic_hinge::read_input>,
                             elastic_hinge::check_input>());
    }
    if (scene == "inertia-moments") {
        using Input = inertia_moments::Input;
        return use(Described<Input, read_alone<Input, inertia_moments::read_input>,
                             inertia_moments::check_input>());
    }
    if (scene == "workshop") {
        using Input = workshop::Input;
        return use(
            Described<Input, read_whole<Input, workshop::read_input>, workshop::check_input>());
    }
    if (scene == "v8-plugs") {
        using Input = v8_plugs::Input;
        return use(
            Described<Input, read_whole<Input, v8_plugs::read_input>, v8_plugs::check_input>());
    }
    if (scene == "bob-weights") {
        using Input = bob_weights::Input;
        return use(Described<Input, read_whole<Input, bob_weights::read_input>,
                             bob_weights::check_input>());
    }
    return decltype(use(
        Described<elastic_hinge::Input, read_alone<elastic_hinge::Input, elastic_hinge::read_input>,
                  elastic_hinge::check_input>()))();
}

}  // namespace

std::unique_ptr<Response> typed_response(const CaseFile& file, const CaseContext& context,
                                         std::span<const std::string> varied,
                                         std::span<const std::string> watched) {
    return with_scene(
        file.scene, [&]<typename Scene>(Scene /*scene*/) -> std::unique_ptr<Response> {
            return std::make_unique<typename Scene::Response>(file.input, context, varied, watched);
        });
}

std::vector<ResultEntry> case_results(std::string_view scene, const Json& input,
                                      const CaseContext& context) {
    return with_scene(scene, [&]<typename Scene>(Scene /*scene*/) {
        return list_results(Scene::read(input, context));
    });
}

std::optional<std::string> buildable_value(const CaseFile& file) {
    if (file.scene == "balance-shaft") {
        return "/buildable/at_shaft_angle";
    }
    return std::nullopt;
}

std::vector<Message> file_notes(const CaseFile& file, const CaseContext& context) {
    std::vector<Message> notes;
    if (file.scene == "balance-shaft") {
        const auto input = balance_shaft::read_input(file.input, context);
        if (Message changed = input.torque.changed_note(); !changed.empty()) {
            notes.push_back(std::move(changed));
        }
    }
    return notes;
}

}  // namespace ravnoves
