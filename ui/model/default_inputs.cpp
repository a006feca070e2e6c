#include "model/default_inputs.h"

#include "case-file/json.h"
#include "model/scene_model.h"

namespace ravnoves {

void giveDefaults(const SceneModel& model, Json& input, const std::vector<std::string>& pointers) {
    for (const std::string& pointer : pointers) {
        if (!pointer.starts_with('/') || input.contains(Json::json_pointer(pointer))) {
            continue;
        }
        const Json::json_pointer place(pointer);
        const auto field = model.fields(pointer);
        // An object that is not there is no default: giving it would change the case.
        if (!field.empty() && std::holds_alternative<double>(field.front().value) &&
            input.contains(place.parent_pointer()) &&
            input.at(place.parent_pointer()).is_object()) {
            input[place] = std::get<double>(field.front().value);
        }
    }
}

}  // namespace ravnoves
