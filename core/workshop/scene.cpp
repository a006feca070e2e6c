#include "workshop/scene.h"

#include "case-file/field_writer.h"
#include "case-file/json.h"
#include "case-file/result_json.h"
#include "workshop/results.h"

namespace ravnoves::workshop {

Input read_input(const Json& json, Completeness completeness) {
    Input input = read_fields<Input>(json, completeness);
    if (completeness == Completeness::required) {
        check_input(input);
    } else {
        bob_weights::fit_weigh_in(input);
    }
    return input;
}

Json write_input(const Input& input) {
    Input whole = input;
    bob_weights::fit_weigh_in(whole);
    return write_fields(whole);
}

Json solve_scene(const Json& json, const CaseContext& /*context*/, const Wanted& wanted) {
    return result_json(wanted, read_input(json));
}

}  // namespace ravnoves::workshop
