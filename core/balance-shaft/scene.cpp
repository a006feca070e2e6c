#include "balance-shaft/scene.h"

#include "balance-shaft/balance_shaft.h"

namespace ravnoves::balance_shaft {

Json solve_scene(const Json& input, const CaseContext& context) {
    return write_result(solve(read_input(input, context)));
}

}  // namespace ravnoves::balance_shaft
