#pragma once

#include "studies/study.h"

namespace ravnoves::studies {

/// How one input scatters.
struct Law {
    bool normal = false;
    double mean = 0.0;
    double deviation = 0.0;  ///< standard
    double low = 0.0;        ///< of a uniform one; else mean ∓ 3 deviations
    double high = 0.0;

    /// The value that is exceeded with the probability 1 − u, 0 < u < 1.
    double at(double u) const;
    friend bool operator==(const Law&, const Law&) = default;
};

/// A percentage of 0 does not scatter: its deviation is 0.
Law law_of(const Varied& varied, double nominal);

}  // namespace ravnoves::studies
