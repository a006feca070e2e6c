#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case-file/response.h"
#include "studies/sampler.h"

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
    /// Of an angle with one limit alone, the half turn from there is within.
    bool within(double value) const;
};

inline constexpr std::size_t bin_count = 65'536;
inline constexpr std::array percent_points{0.1, 1.0, 5.0, 25.0, 50.0, 75.0, 95.0, 99.0, 99.9};

struct Estimate {
    double value = 0.0;
    double error = 0.0;  ///< standard
};

/// Statistics of one watched value. Errors are by the replicates' jackknife.
struct Statistics {
    double mean = 0.0;
    double deviation = 0.0;  ///< standard, with n − 1; of an angle √(−2 ln R), with the same factor
    double min = 0.0;
    double max = 0.0;
    std::array<double, percent_points.size()> percentiles{};
    double share = 0.0;  ///< within the limits
    double share_low = 0.0;
    double share_high = 0.0;
    // By input; empty where the samples do not tell.
    std::vector<std::optional<Estimate>> first_order;
    std::vector<std::optional<Estimate>> total;
};

/// Why samples were rejected, alike but for the numbers in it.
struct Rejection {
    std::uint64_t count = 0;
    std::uint64_t first = 0;  ///< the sample that the reason is of
    Message reason;
    Rejection& operator+=(const Rejection& more);
};

/// By the English reason without its numbers.
using Rejections = std::map<std::string, Rejection>;
std::uint64_t count_of(const Rejections& rejections);
/// In English, with # in the place of a number.
std::string without_numbers(const Message& message);
void reject(Rejections& rejections, std::uint64_t sample, const Reason& reason);

/// Sums of solved samples of one watched value, about the plan's centre.
struct Sums {
    double n = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    double versines = 0.0;  ///< 1 − cosines, of angles
    double sines = 0.0;

    double mean() const { return sum / n; }
    double variance() const;  ///< with n − 1
    Sums& operator+=(const Sums& more);
};

/// Samples from … to, solved one after the other by one thread: so the sums do not depend on
/// threads and shards.
struct Block {
    std::uint64_t from = 0;
    std::uint64_t to = 0;
    std::vector<Sums> sums{};  ///< by watched value, then replicate
};

/// Of a part that this program did not write, or not so.
inline constexpr Text not_ours = Text::tr("was not written by this program");

class PartValues;

/// Whole numbers that samples add up to, whatever their order. 65536 bins of each watched value are
/// fixed beforehand; their places serve the sensitivities too.
class Tally {
  public:
    Tally() = default;
    Tally(std::vector<CountingPlan> plan, std::size_t inputs);

    /// @param u  the sample in the unit cube
    void add(Block& block, std::uint64_t sample, std::span<const double> u,
             std::span<const double> y);
    void reject(std::uint64_t sample, const Reason& reason) {
        studies::reject(rejections_, sample, reason);
    }
    /// Two samples that differ in one input alone.
    void add_pair(std::uint64_t sample, std::size_t input, std::span<const double> y,
                  std::span<const double> other);
    /// Of another with the same plan.
    void add(const Tally& other);

    std::uint64_t solved() const { return solved_; }
    const Rejections& rejections() const { return rejections_; }
    /// Of at least one solved sample.
    /// @param blocks  with all samples that were counted
    Statistics statistics(std::size_t watched, std::span<const Block> blocks) const;
    /// All samples in `bars` between two values, at least one; the first and the last include the
    /// samples beyond.
    std::vector<std::uint64_t> histogram(std::size_t watched, double from, double to,
                                         std::size_t bars) const;

    /// @throws InputError where the values that are read are none of a tally
    void pass(PartValues& values);

  private:
    using Counts = std::vector<std::int64_t>;
    struct Value {
        Counts bins;  ///< the last two: below and above
        double min = std::numeric_limits<double>::max();
        double max = std::numeric_limits<double>::lowest();
        std::int64_t within = 0;
        Counts slices;  ///< sums of places in bins, by input, replicate and slice
        Counts pairs;   ///< sums of squared differences of places, by input and replicate
    };
    using Replicates = std::array<Sums, replicates>;

    double order_statistic(const Value& value, const CountingPlan& plan, std::uint64_t place) const;
    double between_slices(const Value& value, std::size_t input, double mean, std::size_t left_out,
                          std::size_t joined) const;
    void set_sensitivities(std::size_t watched, const Replicates& whole, Statistics& found) const;

    std::vector<CountingPlan> plan_;
    std::size_t inputs_ = 0;
    std::vector<Value> values_;
    std::uint64_t solved_ = 0;
    Counts slice_counts_;
    Counts pair_counts_;
    Rejections rejections_;
};

}  // namespace ravnoves::studies
