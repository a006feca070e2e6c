#include "inertia-moments/scene.h"

#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/result_json.h"
#include "inertia-moments/results.h"

namespace ravnoves::inertia_moments {

Input read_input(const Json& json) {
    Input input = read_fields<Input>(json);
    check_input(input);
    return input;
}

Json write_input(const Input& input) {
    return write_fields(input);
}

Json solve_scene(const Json& json, const CaseContext& /*context*/, const Wanted& wanted) {
    return result_json(wanted, read_input(json));
}

}  // namespace ravnoves::inertia_moments
