#include <array>

#include "balance-shaft/scene.h"
#include "case-file/case_file.h"
#include "elastic-hinge/case_io.h"
#include "inertia-moments/case_io.h"
#include "v8-plugs/solver.h"

namespace ravnoves {

std::span<const SceneSolver> scene_solvers() {
    // One line per scene; the order is that of the navigation.
    static const std::array scenes{
        SceneSolver{"balance-shaft", balance_shaft::solve_scene},
        SceneSolver{"elastic-hinge", elastic_hinge::solve_case_input},
        SceneSolver{"v8-plugs", v8_plugs::solve_case_input},
        SceneSolver{"inertia-moments", inertia_moments::solve_case_input},
    };
    return scenes;
}

}  // namespace ravnoves
