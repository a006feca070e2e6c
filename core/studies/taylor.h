#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case-file/response.h"
#include "numerics/units.h"
#include "studies/law.h"
#include "studies/response.h"

namespace ravnoves::studies {

/// Expansion of one watched value about the inputs' means. Empty where the value does not exist
/// there or to either side.
struct Taylor {
    struct Slope {
        double value = 0.0;  ///< per unit of the input's key
        double error = 0.0;  ///< estimated, as much as differences and rounding leave open
        friend bool operator==(const Slope&, const Slope&) = default;
    };
    std::optional<double> value;
    std::vector<std::optional<Slope>> slopes;  ///< by input
    std::vector<double> curvatures;            ///< second derivatives; of the second order alone
    std::vector<double> crossed;  ///< mixed ones, row by row: inputs² of them, 0 on the diagonal

    /// Propagated through the slopes, or, where there are curvatures, to the second order.
    struct Propagated {
        double mean = 0.0;
        double deviation = 0.0;
        double deviation_error = 0.0;
        std::vector<double> first_order;
        std::vector<double> total;
    };
    /// @param second  the slopes alone where false
    /// @return nothing where a slope is missing
    std::optional<Propagated> propagated(std::span<const Law> laws, bool second) const;
    /// The polynomial at the inputs.
    double at(std::span<const Law> laws, std::span<const double> x) const;
};

/// Differences of a response about the means of its inputs.
///
/// First derivatives by Ridders' extrapolation of central differences, one-sided where one side
/// is refused; the error is what two extrapolations differ by, and at least what rounding leaves.
class Differences {
  public:
    Differences(Response& response, std::span<const Law> laws, std::size_t watched);

    /// @param periods  of the watched values that are angles; else 0
    std::vector<Taylor> expand(std::span<const double> periods, bool second);

  private:
    using Values = std::optional<std::vector<double>>;
    Values at(std::span<const double> x);
    Values moved(std::size_t input, double step);
    Values moved(std::size_t one, double step, std::size_t other, double other_step);
    void set_slopes(std::size_t input, std::span<const double> periods, std::vector<Taylor>& all);
    void set_curvatures(std::span<const double> periods, std::vector<Taylor>& all);

    Response& response_;
    std::span<const Law> laws_;
    std::size_t watched_;
    std::vector<double> means_;
    Values middle_;
};

/// Where a watched value leaves its expansion most, along one input with the others at their means.
struct Departure {
    enum class Kind { curved, corner, jump, refused };
    Kind kind = Kind::curved;
    std::size_t input = 0;
    double at = 0.0;    ///< the input there; of a refusal the first that is refused
    double size = 0.0;  ///< of the jump, or largest distance from the expansion
    Reason reason{};    ///< of a refusal
    friend bool operator==(const Departure&, const Departure&) = default;
};

/// Why an expansion fails, as the end of a sentence.
/// @param input  its name or pointer
/// @param unit  of the input
/// @param deviation  of the value; what is much less is not the reason
Message departure_text(const Departure& departure, const Law& law, const std::string& input,
                       const Unit& unit, double deviation);
/// That samples lie so far from the linear answer, and why.
Message distance_text(const std::string& name, double distance, double deviation,
                      const Message& why);

/// Looks along every input, 33 places each, and finds places of jumps and refusals by bisection.
/// @param reach  standard deviations to each side, no further than the law goes
std::vector<Departure> find_departures(Response& response, std::span<const Law> laws,
                                       std::span<const Taylor> expansions,
                                       std::span<const double> periods, double reach);

}  // namespace ravnoves::studies
