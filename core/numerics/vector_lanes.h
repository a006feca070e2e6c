#pragma once

#include <atomic>
#include <cstddef>
#include <cstring>

/// Kernels that use the processor's wide registers where it has them. A kernel is written once, as
/// a type with an inline template `run` of the kind of lanes; run_kernel() compiles it twice, for
/// any processor with PlainLanes and for AVX2 with WideLanes, and chooses. Both do the same
/// operations on every element, none of them fused (AVX2 alone has no fused multiply-add), and put
/// together by maxima and minima only, so the results are equal to the last bit. AVX-512 is not
/// used: with it the compiler fuses.
namespace ravnoves {

using PlainLanes = double __attribute__((vector_size(16)));  ///< two doubles: any x86-64 has them
using WideLanes = double __attribute__((vector_size(32)));   ///< four doubles: AVX2
template <typename Lanes>
inline constexpr std::size_t lanes_of = sizeof(Lanes) / sizeof(double);

#define RAVNOVES_KERNEL [[gnu::always_inline]] inline

#if defined(__x86_64__) && defined(__GNUC__)
#define RAVNOVES_AVX2 __attribute__((target("avx2")))
inline bool processor_has_avx2() {
    return __builtin_cpu_supports("avx2") != 0;
}
#else
#define RAVNOVES_AVX2
inline bool processor_has_avx2() {
    return false;
}
#endif

namespace detail {
inline std::atomic<bool> avx2_wanted{true};
}  // namespace detail

/// Whether kernels are to run as compiled for AVX2.
inline bool has_avx2() {
    static const bool has = processor_has_avx2();
    return has && detail::avx2_wanted.load(std::memory_order_relaxed);
}
/// For tests and benchmarks: the way for any processor, where `wanted` is false.
inline void want_avx2(bool wanted) {
    detail::avx2_wanted.store(wanted, std::memory_order_relaxed);
}

namespace detail {
template <typename Kernel, typename... Arguments>
RAVNOVES_AVX2 auto run_wide(const Arguments&... arguments) {
    return Kernel::template run<WideLanes>(arguments...);
}
}  // namespace detail

/// Kernel::run<Lanes>(arguments…) with the lanes that the processor has.
template <typename Kernel, typename... Arguments>
auto run_kernel(const Arguments&... arguments) {
    return has_avx2() ? detail::run_wide<Kernel>(arguments...)
                      : Kernel::template run<PlainLanes>(arguments...);
}

// By reference: how such values are passed by value depends on the processor.

template <typename Lanes>
RAVNOVES_KERNEL void load(Lanes& to, const double* from) {
    std::memcpy(&to, from, sizeof to);
}
template <typename Lanes>
RAVNOVES_KERNEL void set_all(Lanes& to, double value) {
    to = value - Lanes{};
}
template <typename Lanes>
RAVNOVES_KERNEL void raise(Lanes& maximum, const Lanes& value) {
    maximum = value > maximum ? value : maximum;
}
template <typename Lanes>
RAVNOVES_KERNEL double max_of(const Lanes& of) {
    double maximum = of[0];
    for (std::size_t i = 1; i < lanes_of<Lanes>; ++i) {
        maximum = of[i] > maximum ? of[i] : maximum;
    }
    return maximum;
}

}  // namespace ravnoves
