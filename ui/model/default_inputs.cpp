#include "model/default_inputs.h"

#include <algorithm>

#include "case-file/json.h"
#include "model/scene_model.h"

namespace ravnoves {

void giveDefaults(const SceneModel& model, Json& input, const std::vector<std::string>& pointers) {
    std::vector<FieldEntry> fields;
    for (const std::string& pointer : pointers) {
        if (!pointer.starts_with('/') || input.contains(Json::json_pointer(pointer))) {
            continue;
        }
        if (fields.empty()) {
            fields = model.fields();
        }
        const Json::json_pointer place(pointer);
        const auto field = std::find_if(fields.begin(), fields.end(), [&](const FieldEntry& each) {
            return each.pointer == pointer && each.kind == FieldKind::number;
        });
        // An object that is not there is no default: giving it would change the case.
        if (field != fields.end() && std::holds_alternative<double>(field->value) &&
            input.contains(place.parent_pointer()) &&
            input.at(place.parent_pointer()).is_object()) {
            input[place] = std::get<double>(field->value);
        }
    }
}

}  // namespace ravnoves
