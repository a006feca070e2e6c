#pragma once

#include <string_view>

#include "numerics/text.h"

namespace ravnoves {

/// A scene's declaration of one of its kernels: the method and setting that compute it and the
/// permitted error. The scene "methods" measures it against the other methods, and its tests fail
/// where the declared method exceeds the tolerance or where a cheaper one would not.
struct MethodChoice {
    std::string_view scene;    ///< of the case files
    std::string_view kernel;   ///< id in methods::kernels()
    std::string_view method;   ///< id of the method in that kernel
    std::string_view setting;  ///< label of its setting
    double tolerance;          ///< in the kernel's measure of error
    Text reason;               ///< why this tolerance and this method: sentences for the page
};

}  // namespace ravnoves
