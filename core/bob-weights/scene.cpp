#include "bob-weights/scene.h"

#include "bob-weights/results.h"
#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/json.h"
#include "case-file/result_json.h"

namespace ravnoves::bob_weights {

Input read_input(const Json& json, Completeness completeness) {
    Input input = read_fields<Input>(json, completeness);
    if (completeness == Completeness::required) {
        check_input(input);
    } else {
        fit_weigh_in(input);
    }
    return input;
}

Json write_input(const Input& input) {
    return write_fields(fitted(input));
}

Json solve_scene(const Json& json, const CaseContext& /*context*/, const Wanted& wanted) {
    return result_json(wanted, read_input(json));
}

}  // namespace ravnoves::bob_weights
