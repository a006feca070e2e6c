#include "studies/tally.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "numerics/angle.h"
#include "numerics/constants.h"
#include "studies/taylor.h"

namespace ravnoves::studies {

namespace {

/// Of the inputs, for the first-order sensitivity; a power of two.
constexpr std::size_t slice_count = 64;
/// Beyond, the slices would take more memory than all else.
constexpr std::size_t max_slice_lists = 1000;
constexpr std::size_t below = bin_count;
constexpr std::size_t above = bin_count + 1;

double square(double x) {
    return x * x;
}

/// From the centre, in widths of bins: so that 10⁹ of them add up exactly.
std::int64_t places(const CountingPlan& plan, double distance, double maximum) {
    return std::llround(std::clamp(distance / plan.width, -maximum, maximum));
}

template <typename Counts>
void add_each(Counts& sums, const Counts& others) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] += others[i];
    }
}

/// A value with its standard error by what it is without each replicate in turn (jackknife).
/// @param of  the value without the replicate of that number
template <typename Of>
Estimate jackknife(const Of& of) {
    constexpr auto n = static_cast<double>(replicates);
    constexpr double student = 1.077;  // seven degrees of freedom: ± holds 68.3 of 100
    std::array<double, replicates> values{};
    double mean = 0.0;
    for (std::size_t i = 0; i < replicates; ++i) {
        values[i] = of(i);
        mean += values[i] / n;
    }
    double variance = 0.0;
    for (const double value : values) {
        variance += (n - 1.0) / n * square(value - mean);
    }
    return {of(replicates), student * std::sqrt(variance)};
}

/// The 95 % interval of a share by Wilson's score: near its nominal coverage on average for any
/// share, and never empty at 0 or 1.
std::pair<double, double> wilson_interval(std::uint64_t hits, std::uint64_t count) {
    constexpr double z = 1.959963984540054;
    const auto n = static_cast<double>(count);
    const double share = static_cast<double>(hits) / n;
    const double middle = (share + z * z / (2.0 * n)) / (1.0 + z * z / n);
    const double half =
        z / (1.0 + z * z / n) * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
    return {hits == 0 ? 0.0 : std::max(middle - half, 0.0),
            hits == count ? 1.0 : std::min(middle + half, 1.0)};
}

/// The sums of all replicates but one.
Sums without(const std::array<Sums, replicates>& all, std::size_t replicate) {
    Sums sums;
    for (std::size_t i = 0; i < replicates; ++i) {
        sums += i == replicate ? Sums() : all[i];
    }
    return sums;
}

}  // namespace

double CountingPlan::unwrapped(double value) const {
    return period == 0.0 ? value : centre + std::remainder(value - centre, period);
}

bool CountingPlan::within(double value) const {
    if (period != 0.0 && min.has_value() != max.has_value()) {
        return min ? difference(value, *min, period) >= 0.0
                   : difference(value, *max, period) <= 0.0;
    }
    const auto inside = [&](double v) { return !(min && v < *min) && !(max && v > *max); };
    return inside(value) || (period != 0.0 && (inside(value - period) || inside(value + period)));
}

double Sums::variance() const {
    return std::max(0.0, squares - sum * sum / n) / (n - 1.0);
}

Sums& Sums::operator+=(const Sums& more) {
    n += more.n;
    sum += more.sum;
    squares += more.squares;
    versines += more.versines;
    sines += more.sines;
    return *this;
}

Tally::Tally(std::vector<CountingPlan> plan, std::size_t inputs)
    : plan_(std::move(plan)), inputs_(inputs), values_(plan_.size()) {
    const bool slices = inputs * plan_.size() <= max_slice_lists;
    slice_counts_.resize(slices ? inputs * replicates * slice_count : 0);
    pair_counts_.resize(inputs * replicates);
    for (Value& value : values_) {
        value.bins.resize(bin_count + 2);
        value.slices.resize(slice_counts_.size());
        value.pairs.resize(pair_counts_.size());
    }
}

void Tally::add(Block& block, std::uint64_t sample, std::span<const double> u,
                std::span<const double> y) {
    const std::size_t replicate = sample % replicates;
    const auto slice = [&](std::size_t input) {
        const auto place = static_cast<std::size_t>(u[input] * static_cast<double>(slice_count));
        return (input * replicates + replicate) * slice_count + std::min(place, slice_count - 1);
    };
    const std::size_t sliced = slice_counts_.empty() ? 0 : inputs_;
    for (std::size_t j = 0; j < sliced; ++j) {
        ++slice_counts_[slice(j)];
    }
    for (std::size_t w = 0; w < values_.size(); ++w) {
        Value& value = values_[w];
        Sums& sums = block.sums[w * replicates + replicate];
        const CountingPlan& plan = plan_[w];
        const double number = plan.unwrapped(y[w]);
        const double from_centre = number - plan.centre;
        sums.n += 1.0;
        sums.sum += from_centre;
        sums.squares += from_centre * from_centre;
        if (plan.period != 0.0) {
            const double angle = from_centre * (two_pi / plan.period);
            sums.versines += 2.0 * square(std::sin(0.5 * angle));
            sums.sines += std::sin(angle);
        }
        value.min = std::min(value.min, number);
        value.max = std::max(value.max, number);
        value.within += plan.within(y[w]) ? 1 : 0;
        const double bin = std::floor((number - plan.low) / plan.width);
        ++value.bins[bin < 0.0                               ? below
                     : bin >= static_cast<double>(bin_count) ? above
                                                             : static_cast<std::size_t>(bin)];
        if (sliced != 0) {
            const std::int64_t place = places(plan, from_centre, 0x1p30);
            for (std::size_t j = 0; j < sliced; ++j) {
                value.slices[slice(j)] += place;
            }
        }
    }
    ++solved_;
}

void Tally::add_pair(std::uint64_t sample, std::size_t input, std::span<const double> y,
                     std::span<const double> other) {
    const std::size_t cell = input * replicates + sample % replicates;
    ++pair_counts_[cell];
    for (std::size_t w = 0; w < values_.size(); ++w) {
        const std::int64_t apart =
            places(plan_[w], difference(other[w], y[w], plan_[w].period), 0x1p23);
        values_[w].pairs[cell] += apart * apart;
    }
}

void Tally::add(const Tally& other) {
    for (std::size_t w = 0; w < values_.size(); ++w) {
        Value& value = values_[w];
        const Value& more = other.values_[w];
        add_each(value.bins, more.bins);
        value.min = std::min(value.min, more.min);
        value.max = std::max(value.max, more.max);
        value.within += more.within;
        add_each(value.slices, more.slices);
        add_each(value.pairs, more.pairs);
    }
    solved_ += other.solved_;
    add_each(slice_counts_, other.slice_counts_);
    add_each(pair_counts_, other.pair_counts_);
    for (const auto& [kind, more] : other.rejections_) {
        rejections_[kind] += more;
    }
}

Rejection& Rejection::operator+=(const Rejection& more) {
    if (count == 0 || more.first < first) {
        first = more.first;
        reason = more.reason;
    }
    count += more.count;
    return *this;
}

std::uint64_t count_of(const Rejections& rejections) {
    std::uint64_t count = 0;
    for (const auto& [kind, rejection] : rejections) {
        count += rejection.count;
    }
    return count;
}

std::string without_numbers(const Message& message) {
    if (message.pattern().empty()) {
        return message.verbatim();
    }
    std::vector<std::string> values;
    for (const Argument& argument : message.arguments()) {
        const Message* words = std::get_if<Message>(&argument);
        values.push_back(words != nullptr ? without_numbers(*words) : "#");
    }
    return fill_pattern(message.pattern().english, values);
}

void reject(Rejections& rejections, std::uint64_t sample, const Reason& reason) {
    rejections[without_numbers(reason.message())] += {1, sample, reason.message()};
}

/// Within a bin the values are taken to lie evenly.
double Tally::order_statistic(const Value& value, const CountingPlan& plan,
                              std::uint64_t place) const {
    if (place == 0 || place + 1 >= solved_) {
        return place == 0 ? value.min : value.max;
    }
    auto rank = static_cast<std::int64_t>(place);
    double from = value.min;
    double to = plan.low;
    std::size_t bin = below;
    for (std::size_t i = 0; bin != above && rank >= value.bins[bin]; ++i) {
        rank -= value.bins[bin];
        bin = i < bin_count ? i : above;
        from = plan.low + plan.width * static_cast<double>(i);
        to = i < bin_count ? from + plan.width : value.max;
    }
    const double at = from + (to - from) * (static_cast<double>(rank) + 0.5) /
                                 static_cast<double>(value.bins[bin]);
    return std::clamp(at, value.min, value.max);
}

Statistics Tally::statistics(std::size_t watched, std::span<const Block> blocks) const {
    const Value& value = values_[watched];
    const CountingPlan& plan = plan_[watched];
    Replicates whole{};
    for (const Block& block : blocks) {  // in their order: so that digits stay
        for (std::size_t i = 0; i < replicates; ++i) {
            whole[i] += block.sums[watched * replicates + i];
        }
    }
    const Sums all = without(whole, replicates);
    const double n = all.n;
    Statistics found;
    found.mean = plan.centre + all.mean();
    found.deviation = solved_ < 2 ? 0.0 : std::sqrt(all.variance());
    found.min = value.min;
    found.max = value.max;
    double shift = 0.0;
    if (plan.period != 0.0) {
        const double to_degrees = plan.period / two_pi;
        const double versine = all.versines / n;
        const double sine = all.sines / n;
        found.mean = plan.centre + std::atan2(sine, 1.0 - versine) * to_degrees;
        // −ln R², which keeps its digits where angles scatter little.
        const double length = square(versine) + square(sine) - 2.0 * versine;  // R² − 1
        // Angles that cancel out have no mean, but a deviation that is a number.
        constexpr double least = -1.0 + std::numeric_limits<double>::epsilon();
        const double spread = -std::log1p(std::clamp(length, least, 0.0));
        found.deviation = solved_ < 2 ? 0.0 : std::sqrt(spread * n / (n - 1.0)) * to_degrees;
        if (plan.centre >= 0.0 && plan.centre < plan.period) {
            shift = wrap(found.mean, plan.period) - found.mean;
        }
    }
    for (std::size_t i = 0; i < percent_points.size(); ++i) {
        const double place = (n - 1.0) * percent_points[i] / 100.0;
        const auto rank = static_cast<std::uint64_t>(place);
        const double low = order_statistic(value, plan, rank);
        const double high = order_statistic(value, plan, rank + 1);
        found.percentiles[i] = low + (high - low) * (place - static_cast<double>(rank)) + shift;
    }
    found.mean += shift;
    found.min += shift;
    found.max += shift;
    found.share = static_cast<double>(value.within) / n;
    std::tie(found.share_low, found.share_high) =
        wilson_interval(static_cast<std::uint64_t>(value.within), solved_);
    set_sensitivities(watched, whole, found);
    return found;
}

/// The variance of the slices' means, in squared widths of bins, without one replicate.
///
/// It rests on products of different replicates alone: these are independent, so that what the
/// other inputs leave in a slice's mean adds nothing on average, however evenly the points lie.
double Tally::between_slices(const Value& value, std::size_t input, double mean,
                             std::size_t left_out, std::size_t joined) const {
    using Each = std::array<double, replicates>;
    const auto added_up = [](const Each& values) {
        return std::accumulate(values.begin(), values.end(), 0.0);
    };
    // Of two replicates that differ: all products less those with itself.
    const auto products = [&](const Each& values) {
        return square(added_up(values)) -
               std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
    };
    const auto mean_product = [&](const Each& counts, const Each& sums) {
        const double pairs = products(counts);
        return pairs > 0.0 ? products(sums) / pairs : 0.0;
    };
    double between = 0.0;
    Each all_counts{};
    Each all_sums{};
    for (std::size_t k = 0; k < slice_count; k += joined) {
        Each counts{};
        Each sums{};
        for (std::size_t i = 0; i < replicates; ++i) {
            const std::size_t first = (input * replicates + i) * slice_count + k;
            for (std::size_t at = first; i != left_out && at < first + joined; ++at) {
                counts[i] += static_cast<double>(slice_counts_[at]);
                sums[i] += static_cast<double>(value.slices[at]);
            }
            sums[i] -= counts[i] * mean;
            all_counts[i] += counts[i];
            all_sums[i] += sums[i];
        }
        between += added_up(counts) * mean_product(counts, sums);
    }
    return between / added_up(all_counts) - mean_product(all_counts, all_sums);
}

void Tally::set_sensitivities(std::size_t watched, const Replicates& whole,
                              Statistics& found) const {
    const Value& value = values_[watched];
    const double width = plan_[watched].width;
    constexpr std::int64_t min_pairs = 64;
    constexpr std::uint64_t for_slices = 256;
    constexpr std::uint64_t for_all_slices = 4096;
    const std::size_t joined = solved_ >= for_all_slices ? 1 : 4;
    found.first_order.resize(inputs_);
    found.total.resize(inputs_);
    if (!(without(whole, replicates).variance() > 0.0)) {
        return;
    }
    const auto known = [](Estimate estimate) {
        estimate.value = std::clamp(estimate.value, 0.0, 1.0);
        return std::isfinite(estimate.error) ? std::optional(estimate) : std::nullopt;
    };
    for (std::size_t j = 0; j < inputs_; ++j) {
        if (solved_ >= for_slices && !slice_counts_.empty()) {
            // What a slice hides of the input's own variance: of a smooth value a third of what
            // slices of twice its width hide more, of the tails of a normal law and of jumps
            // about as much as that.
            double hidden = 0.0;
            Estimate estimate = jackknife([&](std::size_t i) {
                const Sums sums = without(whole, i);
                const double scale = square(width) / sums.variance();
                const double mean = sums.mean() / width;
                const double fine = scale * between_slices(value, j, mean, i, joined);
                const double coarse = scale * between_slices(value, j, mean, i, 2 * joined);
                hidden = std::max(fine - coarse, 0.0);
                return fine + 0.8 * hidden;
            });
            estimate.error += 0.5 * hidden;  // of all replicates, which come last
            found.first_order[j] = known(estimate);
        }
        const std::span counts = std::span(pair_counts_).subspan(j * replicates, replicates);
        const std::span pairs = std::span(value.pairs).subspan(j * replicates, replicates);
        if (std::accumulate(counts.begin(), counts.end(), std::int64_t{0}) >= min_pairs) {
            found.total[j] = known(jackknife([&](std::size_t left_out) {
                double count = 0.0;
                double sum = 0.0;
                for (std::size_t i = 0; i < replicates; ++i) {
                    count += i == left_out ? 0.0 : static_cast<double>(counts[i]);
                    sum += i == left_out ? 0.0 : static_cast<double>(pairs[i]);
                }
                return 0.5 * square(width) * sum / count / without(whole, left_out).variance();
            }));
        }
    }
}

std::vector<std::uint64_t> Tally::histogram(std::size_t watched, double from, double to,
                                            std::size_t bars) const {
    std::vector<std::uint64_t> counts(bars);
    const CountingPlan& plan = plan_[watched];
    const Value& value = values_[watched];
    const double last = static_cast<double>(bars) - 1.0;
    for (std::size_t i = 0; i < bin_count; ++i) {
        double middle = plan.low + plan.width * (static_cast<double>(i) + 0.5);
        if (plan.period != 0.0) {  // statistics() may speak of another turn
            middle += plan.period * std::round((0.5 * (from + to) - middle) / plan.period);
        }
        const double place = (middle - from) / (to - from) * static_cast<double>(bars);
        counts[static_cast<std::size_t>(std::clamp(place, 0.0, last))] +=
            static_cast<std::uint64_t>(value.bins[i]);
    }
    counts.front() += static_cast<std::uint64_t>(value.bins[below]);
    counts.back() += static_cast<std::uint64_t>(value.bins[above]);
    return counts;
}

}  // namespace ravnoves::studies
