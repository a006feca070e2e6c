#include "v8-plugs/scene.h"

#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/json.h"
#include "case-file/result_json.h"
#include "v8-plugs/results.h"

namespace ravnoves::v8_plugs {

Input read_input(const Json& json, Completeness completeness) {
    Input input = read_fields<Input>(json, completeness);
    if (completeness == Completeness::required) {
        check_input(input);
    } else {
        check_choices(input);
    }
    return input;
}

Json write_input(const Input& input) {
    return write_fields(input);
}

Json solve_scene(const Json& json, const CaseContext& /*context*/, const Wanted& wanted) {
    return result_json(wanted, read_input(json));
}

}  // namespace ravnoves::v8_plugs
