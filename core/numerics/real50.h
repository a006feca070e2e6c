#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

namespace ravnoves {

/// The scalar of references: 50 decimal digits. Without expression templates, so that kernels
/// written for double accept it.
using Real50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                             boost::multiprecision::et_off>;

}  // namespace ravnoves
