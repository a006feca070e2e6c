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

template <typename Input, auto read, auto check, typename Results = AnewResults<Input>>
std::unique_ptr<Response> respond(const CaseFile& file, const CaseContext& context,
                                  std::span<const std::string> varied,
                                  std::span<const std::string> watched) {
    return std::make_unique<TypedResponse<Input, read, check, Results>>(file.input, context, varied,
                                                                        watched);
}

}  // namespace

std::unique_ptr<Response> typed_response(const CaseFile& file, const CaseContext& context,
                                         std::span<const std::string> varied,
                                         std::span<const std::string> watched) {
    if (file.scene == "balance-shaft") {
        using Input = balance_shaft::Input;
        return respond<Input, balance_shaft::read_input, balance_shaft::check_joined,
                       balance_shaft::RepeatedResults>(file, context, varied, watched);
    }
    if (file.scene == "elastic-hinge") {
        using Input = elastic_hinge::Input;
        return respond<Input, read_alone<Input, elastic_hinge::read_input>,
                       elastic_hinge::check_input>(file, context, varied, watched);
    }
    if (file.scene == "inertia-moments") {
        using Input = inertia_moments::Input;
        return respond<Input, read_alone<Input, inertia_moments::read_input>,
                       inertia_moments::check_input>(file, context, varied, watched);
    }
    if (file.scene == "workshop") {
        using Input = workshop::Input;
        return respond<Input, read_whole<Input, workshop::read_input>, workshop::check_input>(
            file, context, varied, watched);
    }
    if (file.scene == "v8-plugs") {
        using Input = v8_plugs::Input;
        return respond<Input, read_whole<Input, v8_plugs::read_input>, v8_plugs::check_input>(
            file, context, varied, watched);
    }
    if (file.scene == "bob-weights") {
        using Input = bob_weights::Input;
        return respond<Input, read_whole<Input, bob_weights::read_input>, bob_weights::check_input>(
            file, context, varied, watched);
    }
    return nullptr;
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
