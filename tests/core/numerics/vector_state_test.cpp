#include "numerics/vector_state.h"

#include <gtest/gtest.h>

#include "vector_registers.h"

namespace ravnoves {
namespace {

TEST(VectorState, IsCleared) {
    if (!test::has_wide_vectors()) {
        GTEST_SKIP() << "no wide vectors";
    }
    test::dirty_vector_registers();
    EXPECT_TRUE(test::are_vector_registers_dirty());
    clear_vector_state();
    EXPECT_FALSE(test::are_vector_registers_dirty());
}

}  // namespace
}  // namespace ravnoves
