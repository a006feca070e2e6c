#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case-file/response.h"
#include "studies/exact_sum.h"

namespace ravnoves::studies {

/// How one watched value is counted, fixed before the first sample.
struct CountingPlan {
    double low = 0.0;     ///< of the first bin
    double width = 1.0;   ///< of each; a power of two
    double centre = 0.0;  ///< sums are taken about it
    /// 360 or 720 of an angle in degrees, which is counted within half of that about the centre; 0
    /// of other values.
    double period = 0.0;
    std::optional<double> min{};  ///< limits
    std::optional<double> max{};

    double unwrapped(double value) const;
    bool within(double value) const;
    friend bool operator==(const CountingPlan&, const CountingPlan&) = default;
};

inline constexpr std::size_t bin_count = 65'536;
/// Of the inputs, for the first-order sensitivity.
inline constexpr std::size_t slice_count = 64;
inline constexpr std::array percent_points{0.1, 1.0, 5.0, 25.0, 50.0, 75.0, 95.0, 99.0, 99.9};

/// What is known of one watched value.
struct Statistics {
    double mean = 0.0;
    double deviation = 0.0;  ///< standard, with n − 1; of an angle √(−2 ln R), with the same factor
    double plain_deviation = 0.0;  ///< with n − 1, of an angle along the unrolled circle
    double min = 0.0;
    double max = 0.0;
    std::array<double, percent_points.size()> percentiles{};
    double share = 0.0;  ///< within the limits
    double share_low = 0.0;
    double share_high = 0.0;
    double deviation_error = 0.0;     ///< standard error of the deviation, of independent samples
    std::vector<double> first_order;  ///< empty where the samples do not allow it
    std::vector<double> total;
    // Standard errors of these: of the first as of a correlation ratio of normal values, of the
    // total by its pairs, the variance being taken as known.
    std::vector<double> first_order_error;
    std::vector<double> total_error;
};

/// Why samples were refused, alike but for the numbers in it.
struct Refusal {
    std::uint64_t count = 0;
    std::uint64_t first = 0;  ///< the sample that the reason is of
    Reason reason;
};

/// By the English reason without its numbers.
using Refusals = std::map<std::string, Refusal>;
std::uint64_t count_of(const Refusals& refusals);
Json write_refusals(const Refusals& refusals);
/// @throws InputError
Refusals read_refusals(const Json& json, const std::string& where);

/// Counts and exact sums of samples: no sample is kept, and neither order nor sharing out changes
/// anything. 65536 bins of each watched value, laid out beforehand; their places serve the
/// sensitivities too.
class Tally {
  public:
    __extension__ using Wide = unsigned __int128;

    Tally() = default;
    Tally(std::vector<CountingPlan> plan, std::size_t inputs);

    /// @param u  the sample in the unit cube
    void add(std::span<const double> u, std::span<const double> y);
    void refuse(std::uint64_t sample, const Reason& reason);
    /// Two samples that differ in one input alone.
    void add_pair(std::size_t input, std::span<const double> y, std::span<const double> other);
    /// Other limits of a watched value, which so many of the samples keep.
    void set_limits(std::size_t watched, std::optional<double> min, std::optional<double> max,
                    std::uint64_t within);
    /// Of another with the same plan.
    void add(const Tally& other);

    std::uint64_t solved() const { return solved_; }
    std::uint64_t refused() const { return count_of(refusals_); }
    const Refusals& refusals() const { return refusals_; }
    /// Of at least one solved sample.
    Statistics statistics(std::size_t watched) const;
    /// All samples in so many bars between two values, at least one bar; the first and the last
    /// hold what lies beyond them too.
    std::vector<std::uint64_t> histogram(std::size_t watched, double from, double to,
                                         std::size_t bars) const;

    Json write() const;
    /// @throws InputError
    static Tally read(const Json& json, std::vector<CountingPlan> plan, std::size_t inputs);

  private:
    struct Value {
        std::vector<std::uint64_t> bins;  ///< those below and above are counted in the next two
        std::uint64_t below = 0;
        std::uint64_t above = 0;
        ExactSum sum;      ///< of value − centre
        ExactSum squares;  ///< of its square
        ExactSum cosines;  ///< of angles
        ExactSum sines;
        double min = 0.0;
        double max = 0.0;
        std::uint64_t within = 0;
        std::vector<std::int64_t> slices;  ///< sums of bin numbers, by input and its slice
        std::vector<std::int64_t> pairs;   ///< sums of squared differences, by input
        std::vector<Wide> pair_squares;    ///< and of the squares of these
    };

    std::int64_t bin(std::size_t watched, double value) const;
    double order_statistic(std::size_t watched, std::uint64_t place) const;
    void set_sensitivities(std::size_t watched, Statistics& statistics) const;

    std::vector<CountingPlan> plan_;
    std::size_t inputs_ = 0;
    std::vector<Value> values_;
    std::uint64_t solved_ = 0;
    std::vector<std::uint64_t> slice_counts_;
    std::vector<std::uint64_t> pair_counts_;
    Refusals refusals_;
};

/// The text with its numbers left out: refusals of one kind read the same.
std::string without_numbers(const std::string& text);

/// The 95 % interval of a share by Wilson's score: near its nominal coverage on average for any
/// share, and never empty at 0 or 1.
std::pair<double, double> wilson_interval(std::uint64_t hits, std::uint64_t count);

}  // namespace ravnoves::studies
