#pragma once

#include <algorithm>
#include <limits>
#include <string>

#include "methods/kernel.h"

namespace ravnoves::methods {

inline bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

inline std::size_t find_sweep(const Kernel& kernel, std::string_view id) {
    const auto found = std::ranges::find(kernel.sweeps, id, &SweepInfo::id);
    return static_cast<std::size_t>(found - kernel.sweeps.begin());
}

/// A method with a setting at a value of a sweep.
inline Result result_of(const char* kernel_id, const char* sweep, double value, const char* method,
                        const char* setting) {
    const Kernel& kernel = *find_kernel(kernel_id);
    const std::size_t m = kernel.find_method(method);
    return evaluate(kernel.problem(find_sweep(kernel, sweep), value), m,
                    kernel.find_setting(m, setting));
}

/// Its error; infinite where it rejects.
inline double error_of(const char* kernel_id, const char* sweep, double value, const char* method,
                       const char* setting) {
    const Result result = result_of(kernel_id, sweep, value, method, setting);
    return result.rejected() ? std::numeric_limits<double>::infinity() : result.error;
}

}  // namespace ravnoves::methods
