#include <array>

#include "balance-shaft/scene.h"
#include "case-file/case_file.h"

namespace ravnoves {

std::span<const SceneSolver> scene_solvers() {
    // One line per scene; the order is that of the navigation.
    static const std::array scenes{
        SceneSolver{"balance-shaft", balance_shaft::solve_scene},
    };
    return scenes;
}

}  // namespace ravnoves
