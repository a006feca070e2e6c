#pragma once

#include <limits>
#include <string>

#include "methods/kernel.h"

namespace ravnoves::methods {

inline bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// A method with a setting at a value of a sweep.
inline Result result_of(const char* kernel_id, const char* sweep, double value, const char* method,
                        const char* setting) {
    const Kernel& kernel = *find_kernel(kernel_id);
    const std::size_t m = kernel.find_method(method);
    return evaluate(*kernel.problem(kernel.find_sweep(sweep), value), m,
                    kernel.find_setting(m, setting));
}

/// Its error; infinite where it rejects.
inline double error_of(const char* kernel_id, const char* sweep, double value, const char* method,
                       const char* setting) {
    const Result result = result_of(kernel_id, sweep, value, method, setting);
    return result.rejected() ? std::numeric_limits<double>::infinity() : result.error;
}

}  // namespace ravnoves::methods
