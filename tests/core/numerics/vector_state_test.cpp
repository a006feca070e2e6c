#include "numerics/vector_state.h"

#include <gtest/gtest.h>

#include <thread>

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

/// What a thread leaves in its registers its children begin with: that is how a worker of the
/// window gets them.
TEST(VectorState, AThreadBeginsWithThatOfItsMaker) {
    if (!test::has_wide_vectors()) {
        GTEST_SKIP() << "no wide vectors";
    }
    bool before = false;
    bool after = true;
    test::dirty_vector_registers();
    std::thread([&] {
        before = test::are_vector_registers_dirty();
        clear_vector_state();
        after = test::are_vector_registers_dirty();
    }).join();
    clear_vector_state();
    RecordProperty("inherited", before ? "yes" : "no");  // libraries on the way may clear it
    EXPECT_FALSE(after);
}

}  // namespace
}  // namespace ravnoves
