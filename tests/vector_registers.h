#pragma once

#include <array>
#include <cstdint>

/// The upper halves of the vector registers, which clear_vector_state() clears.
namespace ravnoves::test {

#if defined(__x86_64__) && defined(__GNUC__)

inline bool has_wide_vectors() {
    return __builtin_cpu_supports("avx") != 0;
}

/// Leaves the upper halves of all registers in use, as code of others does.
inline void dirty_vector_registers() {
    if (has_wide_vectors()) {
        asm volatile(
            "vcmpps $15, %%ymm0, %%ymm0, %%ymm0\n vcmpps $15, %%ymm1, %%ymm1, %%ymm1\n"
            "vcmpps $15, %%ymm6, %%ymm6, %%ymm6\n vcmpps $15, %%ymm7, %%ymm7, %%ymm7\n"
            "vcmpps $15, %%ymm14, %%ymm14, %%ymm14\n vcmpps $15, %%ymm15, %%ymm15, %%ymm15\n" ::
                : "xmm0", "xmm1", "xmm6", "xmm7", "xmm14", "xmm15");
    }
}

/// True where any upper half is not zero.
inline bool are_vector_registers_dirty() {
    if (!has_wide_vectors()) {
        return false;
    }
    std::array<std::uint64_t, 32> upper{};
    asm volatile(
        "vextractf128 $1, %%ymm0, 0(%0)\n vextractf128 $1, %%ymm1, 16(%0)\n"
        "vextractf128 $1, %%ymm2, 32(%0)\n vextractf128 $1, %%ymm3, 48(%0)\n"
        "vextractf128 $1, %%ymm4, 64(%0)\n vextractf128 $1, %%ymm5, 80(%0)\n"
        "vextractf128 $1, %%ymm6, 96(%0)\n vextractf128 $1, %%ymm7, 112(%0)\n"
        "vextractf128 $1, %%ymm8, 128(%0)\n vextractf128 $1, %%ymm9, 144(%0)\n"
        "vextractf128 $1, %%ymm10, 160(%0)\n vextractf128 $1, %%ymm11, 176(%0)\n"
        "vextractf128 $1, %%ymm12, 192(%0)\n vextractf128 $1, %%ymm13, 208(%0)\n"
        "vextractf128 $1, %%ymm14, 224(%0)\n vextractf128 $1, %%ymm15, 240(%0)\n"
        :
        : "r"(upper.data())
        : "memory");
    std::uint64_t any = 0;
    for (const std::uint64_t half : upper) {
        any |= half;
    }
    return any != 0;
}

#else

inline bool has_wide_vectors() {
    return false;
}
inline void dirty_vector_registers() {}
inline bool are_vector_registers_dirty() {
    return false;
}

#endif

}  // namespace ravnoves::test
