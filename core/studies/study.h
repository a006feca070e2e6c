#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case-file/field.h"
#include "case-file/json_fwd.h"

/// What the scatter of a case's inputs does to its results. Above the scenes: they do not know it.
namespace ravnoves::studies {

/// One input that scatters, by its JSON pointer below "input".
struct Varied {
    enum class Spread {
        plus_minus,          ///< uniform, nominal ± size
        plus_minus_percent,  ///< uniform, nominal ± size % of its amount
        normal,              ///< normal about the nominal, standard deviation size
        uniform,             ///< uniform from … to
        grid,                ///< the values, each with each of the other inputs
    };
    std::string pointer;
    Spread spread = Spread::plus_minus;
    double size = 0.0;  ///< in the unit of the key, or %
    double from = 0.0;
    double to = 0.0;
    std::vector<double> values{};  ///< of a grid
    /// Number of values from … to; 0 where they were listed.
    int steps = 0;
    friend bool operator==(const Varied&, const Varied&) = default;
};

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

/// One value that is watched, by its JSON pointer below "result".
struct Watched {
    std::string pointer;
    std::optional<double> min{};  ///< limits, inclusive
    std::optional<double> max{};
    friend bool operator==(const Watched&, const Watched&) = default;
};

enum class Method {
    linear,       ///< derivatives at the means
    monte_carlo,  ///< independent points
    sobol,        ///< scrambled Sobol points
    grid,         ///< every combination of the values
};

/// The words of the methods, in the order of the enumeration, with their names.
std::span<const Word> method_words();
inline bool is_sampled(Method method) {
    return method == Method::monte_carlo || method == Method::sobol;
}

/// "study" of a case.
struct Study {
    std::vector<Varied> vary;
    std::vector<Watched> watch;
    Method method = Method::sobol;
    std::uint64_t samples = 10'000;  ///< 1 … 10⁹
    std::uint64_t seed = 1;          ///< 0 … 2⁶³ − 1

    /// The samples, or the points of a grid or of an expansion.
    std::uint64_t points() const;
    friend bool operator==(const Study&, const Study&) = default;
};

inline constexpr std::uint64_t max_samples = 1'000'000'000;
inline constexpr std::uint64_t max_grid_points = 1'000'000;

/// @param half_filled  nothing needs to be varied or watched yet
/// @throws InputError that names the JSON pointer below /study
Study read_study(const Json& study, bool half_filled = false);
Json write_study(const Study& study);

/// `steps` values at equal distances, both ends included.
std::vector<double> spaced(double from, double to, int steps);

/// The place of an input or a result in the case file: "/study/vary/~1crank_radius_mm".
std::string vary_place(const std::string& pointer);
std::string watch_place(const std::string& pointer);

}  // namespace ravnoves::studies
