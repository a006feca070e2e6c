#pragma once

#include <optional>
#include <span>
#include <vector>

#include "case-file/response.h"
#include "studies/study.h"

namespace ravnoves::studies {

/// What two values differ by, of angles the short way round.
/// @param period  of an angle; else 0
double difference(double a, double b, double period);

/// Linear expansion of one watched value about the inputs' means. Empty where the value does not
/// exist there or to either side.
struct Taylor {
    struct Slope {
        double value = 0.0;  ///< per unit of the input's key
        double error = 0.0;  ///< estimated, as much as differences and rounding leave open
    };
    std::optional<double> value;
    std::vector<std::optional<Slope>> slopes;  ///< by input; nothing of what does not scatter

    struct Propagated {
        double deviation = 0.0;
        double deviation_error = 0.0;
        std::vector<double> shares;  ///< of the variance, by input
    };
    /// @return nothing where a slope is missing
    std::optional<Propagated> propagated(std::span<const Law> laws) const;
    /// The expansion at the inputs; 0 of what does not exist.
    double at(std::span<const Law> laws, std::span<const double> x) const;
};

/// Whether an input moves by more than its own rounding; one that does not has no slope, and adds
/// nothing.
bool scatters(const Law& law);

/// Expands a response about the means of its inputs.
///
/// Derivatives by Ridders' extrapolation of central differences, one-sided where one side is
/// rejected; the error is what two extrapolations differ by, and at least what rounding leaves.
/// @param watched  how many values it has
std::vector<Taylor> expand(Response& response, std::span<const Law> laws, std::size_t watched);

}  // namespace ravnoves::studies
