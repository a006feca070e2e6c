#include "studies/tally.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "numerics/angle.h"
#include "numerics/constants.h"

namespace ravnoves::studies {

namespace {

constexpr auto last_bin = static_cast<std::int64_t>(bin_count) - 1;
/// Beyond, the slices would take more memory than all else.
constexpr std::size_t most_slice_lists = 5000;

[[noreturn]] void refuse_part(const std::string& where) {
    throw InputError(where, CORE_TEXT("studies", "is not what this program writes"));
}

template <typename Integer>
std::vector<Integer> read_integers(const Json& json, std::size_t size, const std::string& where) {
    if (!json.is_array() || json.size() != size) {
        refuse_part(where);
    }
    std::vector<Integer> values;
    values.reserve(size);
    for (const Json& each : json) {
        if (!each.is_number_integer() || each.get<std::int64_t>() < 0) {
            refuse_part(where);
        }
        values.push_back(each.get<Integer>());
    }
    return values;
}

using Wide = Tally::Wide;

/// High and low halves, one after the other.
Json write_wide(const std::vector<Wide>& values) {
    Json list = Json::array();
    for (const Wide& each : values) {
        list.push_back(static_cast<std::uint64_t>(each >> 64));
        list.push_back(static_cast<std::uint64_t>(each));
    }
    return list;
}

std::vector<Wide> read_wide(const Json& json, std::size_t size, const std::string& where) {
    if (!json.is_array() || json.size() != 2 * size) {
        refuse_part(where);
    }
    std::vector<Wide> values(size);
    for (std::size_t i = 0; i < json.size(); ++i) {
        if (!json[i].is_number_unsigned()) {
            refuse_part(where);
        }
        values[i / 2] = (values[i / 2] << 64) | json[i].get<std::uint64_t>();
    }
    return values;
}

double read_number(const Json& json, const std::string& where) {
    if (!json.is_number()) {
        refuse_part(where);
    }
    return json.get<double>();
}

const Json& member(const Json& json, const char* key, const std::string& where) {
    if (!json.is_object() || !json.contains(key)) {
        refuse_part(where + "/" + key);
    }
    return json.at(key);
}

template <typename Integer>
void add_each(std::vector<Integer>& sums, const std::vector<Integer>& others) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] += others[i];
    }
}

/// Counts with a space between, and −n for n empty bins.
std::string write_bins(const std::vector<std::uint64_t>& bins) {
    std::string text;
    std::size_t empty = 0;
    for (const std::uint64_t count : bins) {
        if (count == 0) {
            ++empty;
            continue;
        }
        if (empty != 0) {
            text += '-' + std::to_string(empty) + ' ';
        }
        text += std::to_string(count) + ' ';
        empty = 0;
    }
    return text;
}

bool read_bins(std::string_view text, std::vector<std::uint64_t>& bins) {
    std::size_t at = 0;
    const char* place = text.data();
    const char* const end = place + text.size();
    while (place != end) {
        const bool skips = *place == '-';
        std::uint64_t number = 0;
        const auto [stopped, fault] = std::from_chars(place + (skips ? 1 : 0), end, number);
        if (fault != std::errc{} || stopped == end || *stopped != ' ' || at >= bins.size() ||
            (skips && number > bins.size() - at)) {
            return false;
        }
        if (skips) {
            at += number;
        } else {
            bins[at++] = number;
        }
        place = stopped + 1;
    }
    return true;
}

double square(double x) {
    return x * x;
}

}  // namespace

double CountingPlan::unwrapped(double value) const {
    return period == 0.0 ? value : centre + std::remainder(value - centre, period);
}

bool CountingPlan::within(double value) const {
    const auto inside = [&](double v) { return !(min && v < *min) && !(max && v > *max); };
    return inside(value) || (period != 0.0 && (inside(value - period) || inside(value + period)));
}

Tally::Tally(std::vector<CountingPlan> plan, std::size_t inputs)
    : plan_(std::move(plan)), inputs_(inputs), values_(plan_.size()) {
    const bool slices = inputs * plan_.size() <= most_slice_lists;
    slice_counts_.resize(slices ? inputs * slice_count : 0);
    pair_counts_.resize(inputs);
    for (Value& value : values_) {
        value.bins.resize(bin_count);
        value.slices.resize(slice_counts_.size());
        value.pairs.resize(inputs);
        value.pair_squares.resize(inputs);
    }
}

std::int64_t Tally::bin(std::size_t watched, double value) const {
    const CountingPlan& plan = plan_[watched];
    const double place = std::floor((value - plan.low) / plan.width);
    return static_cast<std::int64_t>(std::clamp(place, -1.0, static_cast<double>(bin_count)));
}

void Tally::add(std::span<const double> u, std::span<const double> y) {
    std::array<std::size_t, 64> near{};  // without memory of its own for the usual few inputs
    std::vector<std::size_t> far;
    std::size_t* slice = near.data();
    if (inputs_ > near.size()) {
        far.resize(inputs_);
        slice = far.data();
    }
    const bool slices = !slice_counts_.empty();
    for (std::size_t j = 0; slices && j < inputs_; ++j) {
        const auto place = static_cast<std::size_t>(u[j] * static_cast<double>(slice_count));
        slice[j] = j * slice_count + std::min(place, slice_count - 1);
        ++slice_counts_[slice[j]];
    }
    for (std::size_t w = 0; w < values_.size(); ++w) {
        Value& value = values_[w];
        const CountingPlan& plan = plan_[w];
        const double number = plan.unwrapped(y[w]);
        value.min = solved_ == 0 ? number : std::min(value.min, number);
        value.max = solved_ == 0 ? number : std::max(value.max, number);
        const double from_centre = number - plan.centre;
        value.sum.add(from_centre);
        value.squares.add(from_centre * from_centre);
        if (plan.period != 0.0) {
            const double angle = from_centre * (two_pi / plan.period);
            value.cosines.add(std::cos(angle));
            value.sines.add(std::sin(angle));
        }
        value.within += plan.within(y[w]) ? 1 : 0;
        const std::int64_t place = bin(w, number);
        if (place < 0) {
            ++value.below;
        } else if (place > last_bin) {
            ++value.above;
        } else {
            ++value.bins[static_cast<std::size_t>(place)];
        }
        const std::int64_t clamped = std::clamp<std::int64_t>(place, 0, last_bin);
        for (std::size_t j = 0; slices && j < inputs_; ++j) {
            value.slices[slice[j]] += clamped;
        }
    }
    ++solved_;
}

void Tally::refuse(std::uint64_t sample, const Reason& reason) {
    Refusal& refusal = refusals_[without_numbers(reason.message().english())];
    if (refusal.count == 0 || sample < refusal.first) {
        refusal.first = sample;
        refusal.reason = reason;
    }
    ++refusal.count;
}

void Tally::add_pair(std::size_t input, std::span<const double> y, std::span<const double> other) {
    ++pair_counts_[input];
    for (std::size_t w = 0; w < values_.size(); ++w) {
        const CountingPlan& plan = plan_[w];
        const double one = plan.unwrapped(y[w]);
        const double two =
            plan.period == 0.0 ? other[w] : one + std::remainder(other[w] - one, plan.period);
        const auto place = [&](double v) {
            return std::clamp<std::int64_t>(bin(w, v), 0, last_bin);
        };
        const std::int64_t difference = place(two) - place(one);
        values_[w].pairs[input] += difference * difference;
        values_[w].pair_squares[input] +=
            Wide(difference * difference) * Wide(difference * difference);
    }
}

void Tally::set_limits(std::size_t watched, std::optional<double> min, std::optional<double> max,
                       std::uint64_t within) {
    plan_[watched].min = min;
    plan_[watched].max = max;
    values_[watched].within = within;
}

void Tally::add(const Tally& other) {
    for (std::size_t w = 0; w < values_.size(); ++w) {
        Value& value = values_[w];
        const Value& more = other.values_[w];
        add_each(value.bins, more.bins);
        value.below += more.below;
        value.above += more.above;
        value.sum.add(more.sum);
        value.squares.add(more.squares);
        value.cosines.add(more.cosines);
        value.sines.add(more.sines);
        if (other.solved_ != 0) {
            value.min = solved_ == 0 ? more.min : std::min(value.min, more.min);
            value.max = solved_ == 0 ? more.max : std::max(value.max, more.max);
        }
        value.within += more.within;
        add_each(value.slices, more.slices);
        add_each(value.pairs, more.pairs);
        add_each(value.pair_squares, more.pair_squares);
    }
    solved_ += other.solved_;
    add_each(slice_counts_, other.slice_counts_);
    add_each(pair_counts_, other.pair_counts_);
    for (const auto& [kind, more] : other.refusals_) {
        Refusal& refusal = refusals_[kind];
        if (refusal.count == 0 || more.first < refusal.first) {
            refusal.first = more.first;
            refusal.reason = more.reason;
        }
        refusal.count += more.count;
    }
}

std::uint64_t count_of(const Refusals& refusals) {
    std::uint64_t count = 0;
    for (const auto& [kind, refusal] : refusals) {
        count += refusal.count;
    }
    return count;
}

Json write_refusals(const Refusals& refusals) {
    Json list = Json::array();
    for (const auto& [kind, refusal] : refusals) {
        list.push_back({{"reason", refusal.reason.message().english()},
                        {"count", refusal.count},
                        {"first", refusal.first}});
    }
    return list;
}

Refusals read_refusals(const Json& json, const std::string& where) {
    Refusals refusals;
    const auto whole = [&](const Json& each, const char* key) {
        return read_integers<std::uint64_t>(Json::array({member(each, key, where)}), 1, where)
            .front();
    };
    for (const Json& each : json) {
        const Json& reason = member(each, "reason", where);
        if (!reason.is_string()) {
            refuse_part(where + "/reason");
        }
        const auto text = reason.get<std::string>();
        refusals[without_numbers(text)] = {whole(each, "count"), whole(each, "first"), {{}, text}};
    }
    return refusals;
}

/// Within a bin the values are taken to lie evenly.
double Tally::order_statistic(std::size_t watched, std::uint64_t place) const {
    const Value& value = values_[watched];
    const CountingPlan& plan = plan_[watched];
    const double high = plan.low + plan.width * static_cast<double>(bin_count);
    if (place == 0 || place + 1 == solved_) {
        return place == 0 ? value.min : value.max;
    }
    const auto spread = [&](double from, double to, std::uint64_t rank, std::uint64_t count) {
        const double at =
            from + (to - from) * (static_cast<double>(rank) + 0.5) / static_cast<double>(count);
        return std::clamp(at, value.min, value.max);
    };
    if (place < value.below) {
        return spread(value.min, plan.low, place, value.below);
    }
    place -= value.below;
    for (std::size_t i = 0; i < bin_count; ++i) {
        if (place < value.bins[i]) {
            const double from = plan.low + plan.width * static_cast<double>(i);
            return spread(from, from + plan.width, place, value.bins[i]);
        }
        place -= value.bins[i];
    }
    return spread(high, value.max, place, value.above);
}

Statistics Tally::statistics(std::size_t watched) const {
    const Value& value = values_[watched];
    const CountingPlan& plan = plan_[watched];
    const auto n = static_cast<double>(solved_);
    const double sum = value.sum.value();
    const double deviation =
        solved_ < 2 ? 0.0
                    : std::sqrt(std::max(0.0, value.squares.value() - sum * sum / n) / (n - 1.0));
    Statistics found;
    found.mean = plan.centre + sum / n;
    found.deviation = deviation;
    found.plain_deviation = deviation;
    found.min = value.min;
    found.max = value.max;
    double shift = 0.0;
    if (plan.period != 0.0) {
        const double cosines = value.cosines.value();
        const double sines = value.sines.value();
        const double to_degrees = plan.period / two_pi;
        const double length = std::min(std::hypot(cosines, sines) / n, 1.0);
        found.mean = plan.centre + std::atan2(sines, cosines) * to_degrees;
        if (solved_ >= 2) {
            // Of narrow scatter 1 − R keeps few digits, while the plain deviation is the same.
            const double around = found.mean - plan.centre;
            const double narrow = std::sqrt(std::max(
                0.0,
                (value.squares.value() - 2.0 * around * sum + n * around * around) / (n - 1.0)));
            const double wide = std::sqrt(-2.0 * std::log(length) * n / (n - 1.0)) * to_degrees;
            found.deviation = narrow < 1e-4 * plan.period ? narrow : wide;
        }
        if (plan.centre >= 0.0 && plan.centre < plan.period) {
            shift = wrap(found.mean, plan.period) - found.mean;
        }
    }
    for (std::size_t i = 0; i < percent_points.size(); ++i) {
        const double place = (n - 1.0) * percent_points[i] / 100.0;
        const auto whole = std::min(static_cast<std::uint64_t>(place), solved_ - 1);
        const double low = order_statistic(watched, whole);
        const double high = order_statistic(watched, std::min(whole + 1, solved_ - 1));
        found.percentiles[i] = low + (high - low) * (place - static_cast<double>(whole)) + shift;
    }
    found.mean += shift;
    found.min += shift;
    found.max += shift;
    found.share = static_cast<double>(value.within) / n;
    std::tie(found.share_low, found.share_high) = wilson_interval(value.within, solved_);
    set_sensitivities(watched, found);
    return found;
}

void Tally::set_sensitivities(std::size_t watched, Statistics& found) const {
    const Value& value = values_[watched];
    const auto n = static_cast<double>(solved_);
    double sum = static_cast<double>(last_bin) * static_cast<double>(value.above);
    for (std::size_t i = 0; i < bin_count; ++i) {
        sum += static_cast<double>(i) * static_cast<double>(value.bins[i]);
    }
    const double mean = sum / n;
    double second = 0.0;
    double fourth = 0.0;
    const auto count_at = [&](double place, std::uint64_t count) {
        const double d = square(place - mean);
        second += d * static_cast<double>(count);
        fourth += d * d * static_cast<double>(count);
    };
    count_at(0.0, value.below);
    count_at(static_cast<double>(last_bin), value.above);
    for (std::size_t i = 0; i < bin_count; ++i) {
        if (value.bins[i] != 0) {
            count_at(static_cast<double>(i), value.bins[i]);
        }
    }
    const double variance = second / n;
    if (!(variance > 0.0)) {
        return;
    }
    found.deviation_error =
        found.deviation * std::sqrt(std::max(0.0, fourth / n / square(variance) - 1.0) / (4.0 * n));
    // Between groups and within them, less what the groups' own noise adds; a line loses 1/K².
    constexpr std::uint64_t for_all_slices = 6400;
    constexpr std::uint64_t for_any = 320;
    const std::size_t joined = solved_ >= for_all_slices ? 1 : 4;
    if (!slice_counts_.empty() && solved_ >= for_any) {
        for (std::size_t j = 0; j < inputs_; ++j) {
            double between = 0.0;
            double groups = 0.0;
            for (std::size_t k = 0; k < slice_count; k += joined) {
                double count = 0.0;
                double total = 0.0;
                for (std::size_t i = k; i < k + joined; ++i) {
                    count += static_cast<double>(slice_counts_[j * slice_count + i]);
                    total += static_cast<double>(value.slices[j * slice_count + i]);
                }
                if (count > 0.0) {
                    between += count * square(total / count - mean);
                    groups += 1.0;
                }
            }
            const double noise = (groups - 1.0) * (second - between) / (n - groups);
            const double line = 1.0 - 1.0 / square(groups);
            const double share =
                std::clamp((between - std::max(noise, 0.0)) / second / line, 0.0, 1.0);
            found.first_order.push_back(share);
            found.first_order_error.push_back(std::sqrt(
                (4.0 * share * (1.0 - share) + 2.0 * (groups - 1.0) * square(1.0 - share) / n) /
                n));
        }
    }
    constexpr std::uint64_t least_pairs = 30;
    if (std::all_of(pair_counts_.begin(), pair_counts_.end(),
                    [](std::uint64_t count) { return count >= least_pairs; })) {
        for (std::size_t j = 0; j < inputs_; ++j) {
            const auto count = static_cast<double>(pair_counts_[j]);
            const double mean_square = static_cast<double>(value.pairs[j]) / count;
            const double spread = std::max(
                0.0, static_cast<double>(value.pair_squares[j]) / count - square(mean_square));
            found.total.push_back(0.5 * mean_square / variance);
            found.total_error.push_back(0.5 * std::sqrt(spread / (count - 1.0)) / variance);
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
        counts[static_cast<std::size_t>(std::clamp(place, 0.0, last))] += value.bins[i];
    }
    counts.front() += value.below;
    counts.back() += value.above;
    return counts;
}

Json Tally::write() const {
    Json json = {{"solved", solved_}, {"refused", write_refusals(refusals_)}};
    json["slice_counts"] = slice_counts_;
    json["pair_counts"] = pair_counts_;
    json["values"] = Json::array();
    for (const Value& value : values_) {
        json["values"].push_back({{"below", value.below},
                                  {"bins", write_bins(value.bins)},
                                  {"above", value.above},
                                  {"sum", value.sum.write()},
                                  {"squares", value.squares.write()},
                                  {"cosines", value.cosines.write()},
                                  {"sines", value.sines.write()},
                                  {"min", value.min},
                                  {"max", value.max},
                                  {"within", value.within},
                                  {"slices", value.slices},
                                  {"pairs", value.pairs},
                                  {"pair_squares", write_wide(value.pair_squares)}});
    }
    return json;
}

Tally Tally::read(const Json& json, std::vector<CountingPlan> plan, std::size_t inputs) {
    const std::string root = "/counts";
    Tally tally(std::move(plan), inputs);
    const auto whole = [](const Json& value, const std::string& where) {
        return read_integers<std::uint64_t>(Json::array({value}), 1, where).front();
    };
    tally.solved_ = whole(member(json, "solved", root), root + "/solved");
    tally.refusals_ = read_refusals(member(json, "refused", root), root + "/refused");
    tally.slice_counts_ = read_integers<std::uint64_t>(
        member(json, "slice_counts", root), tally.slice_counts_.size(), root + "/slice_counts");
    tally.pair_counts_ = read_integers<std::uint64_t>(member(json, "pair_counts", root), inputs,
                                                      root + "/pair_counts");
    const Json& values = member(json, "values", root);
    if (!values.is_array() || values.size() != tally.values_.size()) {
        refuse_part(root + "/values");
    }
    for (std::size_t w = 0; w < values.size(); ++w) {
        const std::string where = root + "/values/" + std::to_string(w);
        const Json& from = values[w];
        Value& value = tally.values_[w];
        value.below = whole(member(from, "below", where), where + "/below");
        value.above = whole(member(from, "above", where), where + "/above");
        const Json& bins = member(from, "bins", where);
        if (!bins.is_string() || !read_bins(bins.get_ref<const std::string&>(), value.bins)) {
            refuse_part(where + "/bins");
        }
        value.sum = ExactSum::read(member(from, "sum", where), where + "/sum");
        value.squares = ExactSum::read(member(from, "squares", where), where + "/squares");
        value.cosines = ExactSum::read(member(from, "cosines", where), where + "/cosines");
        value.sines = ExactSum::read(member(from, "sines", where), where + "/sines");
        value.min = read_number(member(from, "min", where), where + "/min");
        value.max = read_number(member(from, "max", where), where + "/max");
        value.within = whole(member(from, "within", where), where + "/within");
        value.slices = read_integers<std::int64_t>(member(from, "slices", where),
                                                   value.slices.size(), where + "/slices");
        value.pairs =
            read_integers<std::int64_t>(member(from, "pairs", where), inputs, where + "/pairs");
        value.pair_squares =
            read_wide(member(from, "pair_squares", where), inputs, where + "/pair_squares");
    }
    return tally;
}

std::string without_numbers(const std::string& text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const bool inside_word =
            i > 0 && (std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0 ||
                      text[i - 1] == '_' || text[i - 1] == '/');
        if (std::isdigit(c) != 0 && !inside_word) {
            if (plain.ends_with(" -")) {
                plain.pop_back();
            }
            plain += '#';
            while (i + 1 < text.size() &&
                   (std::isdigit(static_cast<unsigned char>(text[i + 1])) != 0 ||
                    text[i + 1] == '.' || text[i + 1] == 'e' ||
                    (text[i] == 'e' && (text[i + 1] == '-' || text[i + 1] == '+')))) {
                ++i;
            }
        } else {
            plain += text[i];
        }
    }
    return plain;
}

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

}  // namespace ravnoves::studies
