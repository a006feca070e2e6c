#include "studies/robust_best.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <thread>

#include "case-file/json.h"
#include "numerics/angle.h"
#include "numerics/constants.h"
#include "studies/sampler.h"
#include "studies/study_run.h"
#include "studies/workers.h"

namespace ravnoves::studies {

namespace {

constexpr std::uint64_t robust_samples = 2048;
constexpr std::uint64_t fewest_samples = 64;
constexpr std::size_t left_out_groups = 16;

bool are_around(const AngleStretches& stretches, double angle) {
    return std::any_of(stretches.begin(), stretches.end(), [&](const auto& stretch) {
        constexpr double rounding = 1e-9;
        return wrap(angle - stretch.first + rounding, turn_deg) <=
               stretch.second - stretch.first + 2.0 * rounding;
    });
}

/// What is left of the stretches where enough of the samples can be built: the share that robust
/// angles ask for, or where that is nowhere so, the most there is.
AngleStretches enough_buildable(const AngleStretches& stretches,
                                const std::vector<std::optional<AngleStretches>>& samples) {
    // How many more can be built behind an angle than before it, about the turn from 0°.
    std::map<double, int> steps{{0.0, 0}, {turn_deg, 0}};
    const auto add = [&](const std::pair<double, double>& stretch, int one) {
        const double from = wrap(stretch.first, turn_deg);
        const double to = from + std::min(stretch.second - stretch.first, turn_deg);
        steps[from] += one;
        steps[std::min(to, turn_deg)] -= one;
        if (to > turn_deg) {
            steps[0.0] += one;
            steps[to - turn_deg] -= one;
        }
    };
    int known = 0;
    for (const auto& sample : samples) {
        known += sample ? 1 : 0;
        for (const auto& stretch : sample.value_or(AngleStretches())) {
            add(stretch, 1);
        }
    }
    for (const auto& stretch : stretches) {
        add(stretch, 0);  // its ends
    }
    struct Part {
        std::pair<double, double> stretch;
        int built;
    };
    std::vector<Part> parts;
    int most = 0;
    int built = 0;
    for (auto step = steps.begin(); std::next(step) != steps.end(); ++step) {
        built += step->second;
        const double to = std::next(step)->first;
        if (are_around(stretches, 0.5 * (step->first + to))) {
            parts.push_back({{step->first, to}, built});
            most = std::max(most, built);
        }
    }
    if (known == 0) {
        return stretches;
    }
    const int needed =
        std::min(most, static_cast<int>(std::ceil(RobustBest::least_buildable * known)));
    AngleStretches left;
    for (const Part& part : parts) {
        if (part.built < needed) {
            continue;
        }
        if (!left.empty() && left.back().second == part.stretch.first) {
            left.back().second = part.stretch.second;
        } else {
            left.push_back(part.stretch);
        }
    }
    if (left.size() > 1 && left.front().first == 0.0 && left.back().second == turn_deg) {
        left.back().second += left.front().second;
        left.erase(left.begin());
    }
    return left;
}

/// The value of every sample at every angle that was tried.
class AngleTable {
  public:
    AngleTable(const Problem& problem, int threads, const std::function<bool()>& goes_on)
        : problem_(problem), goes_on_(goes_on) {
        const Study& study = problem.study;
        const bool sampled = is_sampled(study.method);
        count_ = sampled ? std::min(study.samples, robust_samples) : robust_samples;
        method_ = sampled ? study.method : Method::sobol;
        refused_.resize(count_);
        for (std::size_t j = 0; j < study.vary.size(); ++j) {
            laws_.push_back(law_of(study.vary[j], problem.nominal[j]));
            if (study.vary[j].pointer == problem.choice->input) {
                place_ = j;
            }
        }
        const auto cores =
            threads > 0 ? static_cast<unsigned>(threads) : std::thread::hardware_concurrency();
        responses_.resize(std::clamp<std::size_t>(cores, 1, count_ / 16 + 1));
        for (auto& response : responses_) {
            response = problem.choice->make();
        }
        steepest_.resize(responses_.size());
        stretches_ = problem.choice->buildable;
    }

    /// Keeps to the angles at which enough of the samples can be built.
    /// @return false where the work was stopped
    bool find_buildable() {
        const auto& make = problem_.choice->make_buildable;
        if (!make || !make() || !stretches_) {
            return true;
        }
        samples_stretches_.resize(count_);
        std::atomic<bool> stopped{false};
        run_workers(
            responses_.size(),
            [&](std::size_t worker) {
                const BuildableOf buildable = make();
                each_sample(worker, stopped, [&](std::uint64_t k, std::vector<double>& x) {
                    auto found = buildable(x);
                    const double off = off_of(x);
                    if (found) {
                        for (auto& [from, to] : *found) {
                            const double width = to - from;
                            from = wrap(from - off, turn_deg);
                            to = from + width;
                        }
                    }
                    samples_stretches_[k] = std::move(found);
                });
            },
            [&] { stopped = true; });
        if (!stopped) {
            stretches_ = enough_buildable(*stretches_, samples_stretches_);
        }
        return !stopped;
    }
    /// Share of the samples that can be built at an angle.
    std::optional<double> buildable_share(double angle) const {
        std::size_t known = 0;
        std::size_t built = 0;
        for (const auto& stretches : samples_stretches_) {
            known += stretches ? 1 : 0;
            built += stretches && are_around(*stretches, angle) ? 1 : 0;
        }
        return known > 0 ? std::optional(static_cast<double>(built) / static_cast<double>(known))
                         : std::nullopt;
    }

    /// @return false where the work was stopped
    bool add(std::vector<double> angles) {
        for (double& angle : angles) {
            angle = wrap(angle, turn_deg);
        }
        const std::size_t first = angles_.size();
        angles_.insert(angles_.end(), angles.begin(), angles.end());
        columns_.resize(angles_.size(), std::vector<double>(count_));
        std::atomic<bool> stopped{false};
        run_workers(
            responses_.size(), [&](std::size_t worker) { fill(worker, first, stopped); },
            [&] { stopped = true; });
        return !stopped;
    }

    /// Whether there is room for the shaft at an angle, in enough of the samples.
    bool is_buildable(double angle) const { return !stretches_ || are_around(*stretches_, angle); }
    /// Ends of the stretches that can be built.
    std::vector<double> ends() const {
        std::vector<double> found;
        for (const auto& [from, to] : stretches_.value_or(AngleStretches())) {
            found.insert(found.end(), {from, to});
        }
        return found;
    }

    std::size_t size() const { return angles_.size(); }
    double angle(std::size_t i) const { return angles_[i]; }
    std::uint64_t samples() const { return count_; }
    std::uint64_t refused() const {
        return static_cast<std::uint64_t>(std::count(refused_.begin(), refused_.end(), 1));
    }
    /// Most that a percentile moves per degree.
    double steepest() const { return *std::max_element(steepest_.begin(), steepest_.end()); }

    /// The percentile at the i-th angle. @param group  that is left out; default: none
    double percentile(std::size_t i, std::size_t group = left_out_groups) {
        const std::uint64_t from = count_ * group / left_out_groups;
        const std::uint64_t to = count_ * (group + 1) / left_out_groups;
        kept_.clear();
        for (std::uint64_t k = 0; k < count_; ++k) {
            if (refused_[k] == 0 && (k < from || k >= to)) {
                kept_.push_back(columns_[i][k]);
            }
        }
        const double rank = static_cast<double>(kept_.size() - 1) * RobustBest::percent / 100.0;
        const auto place = kept_.begin() + static_cast<std::ptrdiff_t>(rank);
        std::nth_element(kept_.begin(), place, kept_.end());
        const double low = *place;
        const double high =
            place + 1 == kept_.end() ? low : *std::min_element(place + 1, kept_.end());
        return std::lerp(low, high, rank - std::floor(rank));
    }

    /// The value of the inputs as they are.
    std::optional<double> nominal(double angle) {
        std::vector<double> x = problem_.nominal;
        x.resize(std::max(x.size(), place() + 1));
        x[place()] = angle;
        std::array<double, 2> y{};
        return responses_.front()->evaluate(x, y) ? std::optional(y[0]) : std::nullopt;
    }

  private:
    std::size_t place() const { return place_.value_or(laws_.size()); }

    /// An angle that scatters does so about each that is tried.
    double off_of(const std::vector<double>& x) const {
        return place_ ? x[*place_] - laws_[*place_].mean : 0.0;
    }

    /// Calls `look` with each sample of a worker and its inputs.
    template <typename Look>
    void each_sample(std::size_t worker, std::atomic<bool>& stopped, const Look& look) {
        Sampler sampler(method_,
                        is_sampled(problem_.study.method) ? problem_.study.samples : count_,
                        problem_.study.seed, laws_.size());
        std::vector<double> u(laws_.size());
        std::vector<double> x(std::max(laws_.size(), place() + 1));
        const std::uint64_t end = count_ * (worker + 1) / responses_.size();
        for (std::uint64_t k = count_ * worker / responses_.size(); k < end; ++k) {
            if (worker == 0 && k % 64 == 0 && goes_on_ && !goes_on_()) {
                stopped = true;
            }
            if (stopped) {
                return;
            }
            sampler.point(k, u);
            for (std::size_t j = 0; j < laws_.size(); ++j) {
                x[j] = laws_[j].at(u[j]);
            }
            look(k, x);
        }
    }

    void fill(std::size_t worker, std::size_t first, std::atomic<bool>& stopped) {
        Response& response = *responses_[worker];
        std::array<double, 2> y{};
        each_sample(worker, stopped, [&](std::uint64_t k, std::vector<double>& x) {
            const double off = off_of(x);
            for (std::size_t i = first; i < angles_.size() && refused_[k] == 0; ++i) {
                x[place()] = angles_[i] + off;
                if (!response.evaluate(x, y)) {
                    refused_[k] = 1;
                    return;
                }
                columns_[i][k] = y[0];
                steepest_[worker] = std::max(steepest_[worker], 2.0 * y[1] * degree);
            }
        });
    }

    const Problem& problem_;
    const std::function<bool()>& goes_on_;
    std::uint64_t count_ = 0;
    Method method_ = Method::sobol;
    std::vector<Law> laws_;
    std::optional<std::size_t> place_;  ///< of the angle, where it is varied
    std::vector<std::unique_ptr<Response>> responses_;
    std::vector<double> steepest_;  ///< by worker
    /// That may be tried: of the inputs as they are, later of enough of the samples.
    std::optional<AngleStretches> stretches_;
    std::vector<std::optional<AngleStretches>> samples_stretches_;  ///< empty: not known
    std::vector<double> angles_;
    std::vector<std::vector<double>> columns_;
    std::vector<char> refused_;
    std::vector<double> kept_;
};

/// Of what sixteen samples with a group left out give.
double jackknife_error(const std::array<double, left_out_groups>& found) {
    constexpr auto n = static_cast<double>(left_out_groups);
    const double mean = std::accumulate(found.begin(), found.end(), 0.0) / n;
    double squares = 0.0;
    for (const double each : found) {
        squares += (each - mean) * (each - mean);
    }
    return std::sqrt(squares * (n - 1.0) / n);
}

double percentile_error(AngleTable& table, std::size_t i) {
    std::array<double, left_out_groups> found{};
    for (std::size_t g = 0; g < left_out_groups; ++g) {
        found[g] = table.percentile(i, g);
    }
    return jackknife_error(found);
}

/// Of the first `count` angles.
std::vector<double> percentiles(AngleTable& table, std::size_t count,
                                std::size_t group = left_out_groups) {
    std::vector<double> found(count);
    for (std::size_t i = 0; i < found.size(); ++i) {
        found[i] = table.percentile(i, group);
    }
    return found;
}

std::size_t least(const std::vector<double>& values) {
    return static_cast<std::size_t>(std::min_element(values.begin(), values.end()) -
                                    values.begin());
}

bool is_flat(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    constexpr double rounding = 1e-12;
    return !(*high - *low > rounding * std::abs(*high));
}

bool has_enough(const AngleTable& table) {
    return table.samples() - table.refused() >= fewest_samples;
}

/// Angles that quarter the stretches that may hold less than the best does by the tolerance. A new
/// sample costs more than an angle of it, where the torque is computed: so not by halves.
std::vector<double> quarters(const AngleTable& table, const std::vector<double>& values,
                             double tolerance) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return table.angle(a) < table.angle(b); });
    const double best = *std::min_element(values.begin(), values.end());
    constexpr double narrowest = 0.1;
    std::vector<double> found;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t next = order[(i + 1) % order.size()];
        const double from = table.angle(order[i]);
        const double width = wrap(table.angle(next) - from, turn_deg);
        const double bound = 0.5 * (values[order[i]] + values[next] - table.steepest() * width);
        if (width > narrowest && bound < best - tolerance &&
            table.is_buildable(from + 0.5 * width)) {
            for (const double part : {0.25, 0.5, 0.75}) {
                found.push_back(from + part * width);
            }
        }
    }
    return found;
}

/// Tries angles until the best is found. @return false where the work was stopped
bool search_angles(AngleTable& table) {
    constexpr int first_step_deg = 5;
    std::vector<double> next = table.ends();
    for (int step = 0; step < 360 / first_step_deg; ++step) {
        if (const double angle = step * first_step_deg; table.is_buildable(angle)) {
            next.push_back(angle);
        }
    }
    constexpr std::size_t most_angles = 600;
    while (!next.empty() && table.size() < most_angles) {
        if (!table.add(next)) {
            return false;
        }
        if (!has_enough(table)) {
            return true;
        }
        const auto values = percentiles(table, table.size());
        const std::size_t best = least(values);
        if (is_flat(values)) {
            return true;
        }
        next = quarters(table, values,
                        0.05 * percentile_error(table, best) + 1e-9 * std::abs(values[best]));
    }
    for (const double width : {0.08, 0.01}) {
        const double best = table.angle(least(percentiles(table, table.size())));
        std::vector<double> about;
        for (int k = -7; k <= 7; ++k) {
            if (const double angle = best + 0.125 * k * width;
                k != 0 && table.is_buildable(angle)) {
                about.push_back(angle);
            }
        }
        if (!table.add(about)) {
            return false;
        }
    }
    return true;
}

RobustBest::Place place_at(AngleTable& table, std::size_t i) {
    return {.angle = table.angle(i),
            .percentile = table.percentile(i),
            .percentile_error = percentile_error(table, i),
            .nominal = table.nominal(table.angle(i)),
            .buildable = table.buildable_share(table.angle(i))};
}

Json write_place(const std::optional<RobustBest::Place>& place) {
    if (!place) {
        return nullptr;
    }
    return {{"at", place->angle},
            {"at_error", place->angle_error},
            {"value", place->percentile},
            {"error", place->percentile_error},
            {"nominal", place->nominal ? Json(*place->nominal) : Json(nullptr)},
            {"buildable_share", place->buildable ? Json(*place->buildable) : Json(nullptr)}};
}

std::optional<RobustBest::Place> read_place(const Json& json) {
    if (json.is_null()) {
        return std::nullopt;
    }
    const auto number = [&](const char* key) {
        const Json& value = json.at(key);
        return value.is_null() ? std::nullopt : std::optional(value.get<double>());
    };
    return RobustBest::Place{
        .angle = json.at("at").get<double>(),
        .angle_error = json.at("at_error").get<double>(),
        .percentile = json.at("value").get<double>(),
        .percentile_error = json.at("error").get<double>(),
        .nominal = number("nominal"),
        .buildable = json.contains("buildable_share") ? number("buildable_share") : std::nullopt};
}

}  // namespace

bool asks_for_robust_best(const Problem& problem) {
    const std::vector<Watched>& watch = problem.study.watch;
    return problem.choice && is_sampled(problem.study.method) &&
           std::any_of(watch.begin(), watch.end(), [&](const Watched& watched) {
               return watched.pointer == problem.choice->value;
           });
}

std::optional<RobustBest> find_robust_best(const Problem& problem, int threads,
                                           const std::function<bool()>& goes_on) {
    if (!problem.choice || problem.study.method == Method::grid) {
        return std::nullopt;
    }
    RobustBest found{.input = problem.choice->input, .value = problem.choice->value};
    const auto& buildable = problem.choice->buildable;
    if (buildable && buildable->empty()) {
        found.reason = {CORE_TEXT("studies", "No angle can be built: %1"),
                        problem.choice->unbuildable};
        return found;
    }
    AngleTable table(problem, threads, goes_on);
    if (!table.find_buildable()) {
        return std::nullopt;
    }
    // An angle that the search may not find is added behind what it tries, and never the best.
    const auto nominal = problem.choice->nominal_best;
    const bool tries_nominal = nominal && table.is_buildable(*nominal);
    if ((tries_nominal && !table.add({*nominal})) || !search_angles(table)) {
        return std::nullopt;
    }
    const std::size_t tried = table.size();
    std::size_t of_nominal = 0;
    if (nominal && !tries_nominal) {
        of_nominal = tried;
        if (!table.add({*nominal})) {
            return std::nullopt;
        }
    }
    found.samples = table.samples();
    found.refused = table.refused();
    if (!has_enough(table)) {
        found.reason = {CORE_TEXT("studies", "Too few samples can be solved: %1 of %2."),
                        std::to_string(found.samples - found.refused),
                        std::to_string(found.samples)};
        return found;
    }
    const auto values = percentiles(table, tried);
    const std::size_t best = least(values);
    if (values.size() > 1 && is_flat(values)) {
        found.reason = CORE_TEXT("studies", "No angle is better than another.");
        return found;
    }
    found.robust = place_at(table, best);
    if (nominal) {
        found.nominal = place_at(table, of_nominal);
        found.gain = found.nominal->percentile - found.robust->percentile;
    }
    std::array<double, left_out_groups> angles{};
    std::array<double, left_out_groups> gains{};
    for (std::size_t g = 0; g < left_out_groups; ++g) {
        const auto without = percentiles(table, tried, g);
        angles[g] = std::remainder(table.angle(least(without)) - found.robust->angle, turn_deg);
        gains[g] = nominal ? table.percentile(of_nominal, g) - without[best] : 0.0;
    }
    found.robust->angle_error = jackknife_error(angles);
    found.gain_error = jackknife_error(gains);
    return found;
}

Json write_robust_best(const RobustBest& best) {
    const bool both = best.robust && best.nominal;
    return {{"input", best.input},
            {"watched", best.value},
            {"percentile", RobustBest::percent},
            {"samples", best.samples},
            {"refused", best.refused},
            {"best", write_place(best.robust)},
            {"nominal_best", write_place(best.nominal)},
            {"gain", both ? Json(best.gain) : Json(nullptr)},
            {"gain_error", both ? Json(best.gain_error) : Json(nullptr)},
            {"reason", best.robust ? Json(nullptr) : Json(best.reason.english())}};
}

RobustBest read_robust_best(const Json& json) {
    const auto number = [&](const char* key) {
        return json.at(key).is_null() ? 0.0 : json.at(key).get<double>();
    };
    return {.input = json.at("input").get<std::string>(),
            .value = json.at("watched").get<std::string>(),
            .samples = json.at("samples").get<std::uint64_t>(),
            .refused = json.at("refused").get<std::uint64_t>(),
            .robust = read_place(json.at("best")),
            .reason = json.contains("reason") && json.at("reason").is_string()
                          ? json.at("reason").get<std::string>()
                          : std::string(),
            .nominal = read_place(json.at("nominal_best")),
            .gain = number("gain"),
            .gain_error = number("gain_error")};
}

}  // namespace ravnoves::studies
