#include "studies/study_run.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>
#include <tuple>

#include "case-file/input_error.h"
#include "numerics/constants.h"
#include "studies/sampler.h"
#include "studies/workers.h"

namespace ravnoves::studies {

struct FirstSamples {
    std::vector<double> values;   ///< row by row
    std::vector<Reason> reasons;  ///< empty where solved
};

struct KeptValues {
    std::vector<double> values;  ///< row by row from the part's first sample; NaN where refused
};

namespace {

constexpr std::uint64_t most_first_samples = 4096;
constexpr std::uint64_t pairs_per_input = 16'384;
/// Points at which an expansion is asked for its percentiles.
constexpr std::uint64_t expansion_points = 16'384;
constexpr std::uint64_t block = 256;
constexpr double not_solved = std::numeric_limits<double>::quiet_NaN();

/// The work was stopped while a part began.
struct Stopped {};

/// Tells `begun` now and then how much of the work is done.
class Pace {
  public:
    using Clock = std::chrono::steady_clock;
    explicit Pace(const Begun& begun) : begun_(begun) {}

    /// @throws Stopped
    void tell(double done, const std::function<Part()>& so_far) {
        constexpr auto often = std::chrono::milliseconds(50);
        if (!begun_ || Clock::now() - told_ < often) {
            return;
        }
        if (!begun_(done, so_far)) {
            throw Stopped{};
        }
        told_ = Clock::now();
    }

  private:
    const Begun& begun_;
    Clock::time_point told_ = Clock::now();
};

/// What a study costs, in solutions.
struct Work {
    double basis = 0.0;  ///< expansions and looking for departures, estimated
    double samples = 0.0;
    double first = 0.0;  ///< of the samples, solved while the part begins
    double pairs = 0.0;  ///< samples that are solved a second time

    double whole() const { return basis + samples + pairs; }
};

/// Samples, points of a grid, or points of an expansion.
std::uint64_t points_of(const Study& study) {
    return is_sampled(study.method) || study.method == Method::grid ? study.points()
                                                                    : expansion_points;
}

/// Samples that an expansion is tried by.
constexpr std::uint64_t tried_samples = 64;

Work work_of(const Part& part) {
    const auto inputs = static_cast<double>(part.study.vary.size());
    const auto count = static_cast<double>(part.to - part.from);
    if (part.study.method == Method::grid) {
        return {.samples = count};
    }
    constexpr double of_slopes = 20.0;
    constexpr double of_departures = 33.0;
    const double basis = inputs * (of_slopes + of_departures);
    if (!is_sampled(part.study.method)) {
        const double curvatures = part.study.method == Method::second_order ? inputs * inputs : 0.0;
        return {.basis = basis + 4.0 * curvatures + tried_samples};
    }
    return {.basis = basis,
            .samples = count,
            .first = static_cast<double>(std::min(points_of(part.study), most_first_samples)),
            .pairs = std::min(count, static_cast<double>(pairs_per_input) * inputs)};
}

/// Counts what is asked of another.
class CountingResponse final : public Response {
  public:
    CountingResponse(std::unique_ptr<Response> response,
                     std::function<void(std::uint64_t count)> counted)
        : response_(std::move(response)), counted_(std::move(counted)) {}

    bool evaluate(std::span<const double> x, std::span<double> y) override {
        counted_(count_);
        const bool there = response_->evaluate(x, y);
        if (!there) {
            reason_ = response_->reason();
            tally_.refuse(count_, reason_);
        }
        ++count_;
        return there;
    }
    std::uint64_t count() const { return count_; }
    const Refusals& refusals() const { return tally_.refusals(); }

  private:
    std::unique_ptr<Response> response_;
    std::function<void(std::uint64_t count)> counted_;
    Tally tally_;
    std::uint64_t count_ = 0;
};

/// In the place of the scene once it is expanded.
class ExpansionResponse final : public Response {
  public:
    explicit ExpansionResponse(const Basis& basis) : basis_(basis) {
        for (const Taylor& expansion : basis.expansions) {
            known_.push_back(expansion.propagated(basis.laws, false).has_value());
        }
    }

    bool evaluate(std::span<const double> x, std::span<double> y) override {
        for (std::size_t w = 0; w < y.size(); ++w) {
            const Taylor& expansion = basis_.expansions[w];
            y[w] = known_[w] ? expansion.at(basis_.laws, x) : 0.0;
        }
        return true;
    }

  private:
    const Basis& basis_;
    std::vector<bool> known_;  ///< 0 stands for the others, which are not shown
};

/// One thread's samples.
class Worker {
  public:
    Worker(const Problem& problem, const Part& part)
        : study_(part.study),
          part_(part),
          sampled_(is_sampled(part.study.method)),
          response_(sampled_ || study_.method == Method::grid
                        ? problem.make()
                        : std::make_unique<ExpansionResponse>(part.basis)),
          random_(study_.seed),
          inputs_(study_.vary.size()),
          u_(inputs_),
          x_(inputs_),
          y_(study_.watch.size()),
          other_(study_.watch.size()) {
        if (study_.method != Method::grid) {
            sampler_.emplace(study_.method, study_.points(), study_.seed, inputs_);
        }
    }

    Tally tally;

    void start_tally() { tally = Tally(part_.basis.plan, inputs_); }

    /// The sample's values, without counting them.
    bool solve(std::uint64_t sample, std::span<double> y) {
        sampler_->point(sample, u_);
        set_inputs();
        return response_->evaluate(x_, y);
    }
    const Reason& reason() const { return response_->reason(); }

    void count(std::uint64_t sample) {
        const FirstSamples* first = part_.first.get();
        bool solved = false;
        if (first != nullptr && sample < first->reasons.size()) {
            sampler_->point(sample, u_);
            const Reason& reason = first->reasons[sample];
            solved = reason.empty();
            std::copy_n(first->values.begin() + static_cast<std::ptrdiff_t>(sample * y_.size()),
                        y_.size(), y_.begin());
            if (!solved) {
                tally.refuse(sample, reason);
            }
        } else if (solved = solve(sample, y_); !solved) {
            tally.refuse(sample, reason());
        }
        if (!solved) {
            return;
        }
        tally.add(u_, y_);
        if (KeptValues* kept = part_.kept.get()) {
            std::copy(y_.begin(), y_.end(),
                      kept->values.begin() +
                          static_cast<std::ptrdiff_t>((sample - part_.from) * y_.size()));
        }
        if (sampled_ && sample < pairs_per_input * inputs_) {
            const auto input = static_cast<std::size_t>(random_.bits(sample, 1, 0) % inputs_);
            u_[input] = random_.uniform(sample, 1, 1);
            set_inputs();
            if (response_->evaluate(x_, other_)) {
                tally.add_pair(input, y_, other_);
            }
        }
    }

    Row row(std::uint64_t point) {
        std::uint64_t rest = point;
        for (std::size_t j = inputs_; j-- > 0;) {  // the last input changes fastest
            const std::vector<double>& values = study_.vary[j].values;
            x_[j] = values[rest % values.size()];
            rest /= values.size();
        }
        if (!response_->evaluate(x_, y_)) {
            tally.refuse(point, reason());
        }
        Row row(x_.begin(), x_.end());
        for (const double value : y_) {
            row.push_back(std::isfinite(value) ? std::optional(value) : std::nullopt);
        }
        return row;
    }

  private:
    void set_inputs() {
        for (std::size_t j = 0; j < inputs_; ++j) {
            x_[j] = part_.basis.laws[j].at(u_[j]);
        }
    }

    const Study& study_;
    const Part& part_;
    bool sampled_;
    std::unique_ptr<Response> response_;
    std::optional<Sampler> sampler_;
    CounterRandom random_;
    std::size_t inputs_;
    std::vector<double> u_, x_, y_, other_;
};

/// As many workers as there are threads, or as blocks to be done.
std::vector<std::unique_ptr<Worker>> make_workers(const Problem& problem, const Part& part,
                                                  int threads, std::uint64_t samples) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const std::uint64_t wanted = threads > 0 ? static_cast<unsigned>(threads) : cores;
    const std::uint64_t count = std::clamp<std::uint64_t>((samples + block - 1) / block, 1, wanted);
    std::vector<std::unique_ptr<Worker>> workers;
    for (std::uint64_t i = 0; i < count; ++i) {
        workers.push_back(std::make_unique<Worker>(problem, part));
    }
    return workers;
}

/// Every worker takes blocks of the stretch until none is left. The first one works in the thread
/// that calls.
template <typename Visit>
void share_out(std::vector<std::unique_ptr<Worker>>& workers, std::uint64_t from, std::uint64_t to,
               const Visit& visit) {
    std::atomic<std::uint64_t> next{from};
    const std::uint64_t taken =
        std::clamp<std::uint64_t>((to - from) / (8 * workers.size()), 1, block);
    const auto work = [&](std::size_t i) {
        for (;;) {
            const std::uint64_t start = next.fetch_add(taken);
            if (start >= to) {
                return;
            }
            for (std::uint64_t k = start; k < std::min(start + taken, to); ++k) {
                visit(*workers[i], k);
            }
        }
    };
    run_workers(workers.size(), work, [&] { next = to; });
}

/// 360° or, where a value says so, the 720° of a four-stroke cycle; 0 of what is no angle.
double period_of(const std::string& pointer, std::span<const double> values) {
    if (!pointer.ends_with("_deg")) {
        return 0.0;
    }
    return std::any_of(values.begin(), values.end(),
                       [](double value) { return std::abs(value) > turn_deg; })
               ? 2.0 * turn_deg
               : turn_deg;
}

/// Bins about the middle of what nearly all values span, four times as fine as they must be.
CountingPlan counting_plan(const Watched& watched, std::optional<double> nominal,
                           std::vector<double> values, double period) {
    CountingPlan plan{.period = period, .min = watched.min, .max = watched.max};
    plan.centre = nominal ? *nominal : values.empty() ? 0.0 : values.front();
    for (double& value : values) {
        value = plan.unwrapped(value);
    }
    std::sort(values.begin(), values.end());
    double low = plan.centre;
    double high = plan.centre;
    if (!values.empty()) {
        const auto n = static_cast<double>(values.size() - 1);
        low = values[static_cast<std::size_t>(std::floor(0.001 * n))];
        high = values[static_cast<std::size_t>(std::ceil(0.999 * n))];
    }
    const double middle = 0.5 * low + 0.5 * high;
    const double span = high - low;
    constexpr double fineness = 6e-5;
    const double least = std::max(std::abs(middle), 1e-6) * 0x1p-44;
    const double width = std::max(span * fineness, least);
    plan.width = std::ldexp(1.0, std::ilogb(width));
    plan.low =
        (std::floor(middle / plan.width) - 0.5 * static_cast<double>(bin_count)) * plan.width;
    return plan;
}

void plan_counting(Part& part, const FirstSamples& first) {
    const std::size_t watched = part.study.watch.size();
    for (std::size_t w = 0; w < watched; ++w) {
        std::vector<double> values;
        for (std::size_t i = 0; i < first.reasons.size(); ++i) {
            if (first.reasons[i].empty()) {
                values.push_back(first.values[i * watched + w]);
            }
        }
        part.basis.periods[w] =
            std::max(part.basis.periods[w], period_of(part.study.watch[w].pointer, values));
        part.basis.plan.push_back(counting_plan(part.study.watch[w], part.basis.nominal[w],
                                                std::move(values), part.basis.periods[w]));
    }
}

/// What is known of a part while its first samples are solved.
Part part_so_far(const Part& part, const FirstSamples& first,
                 const std::vector<std::atomic<bool>>& solved) {
    Part now = part;
    auto known = std::make_shared<FirstSamples>(
        FirstSamples{first.values, std::vector<Reason>(solved.size(), Reason{{}, no_value})});
    now.kept = std::make_shared<KeptValues>();
    now.kept->values.resize(first.values.size(), not_solved);
    const std::size_t watched = part.study.watch.size();
    std::vector<std::size_t> there;
    for (std::size_t i = 0; i < solved.size(); ++i) {
        if (solved[i].load(std::memory_order_acquire)) {
            known->reasons[i] = first.reasons[i];
            there.push_back(i);
        }
    }
    plan_counting(now, *known);
    now.tally = Tally(now.basis.plan, part.study.vary.size());
    Sampler sampler(part.study.method, part.study.points(), part.study.seed,
                    part.study.vary.size());
    std::vector<double> u(part.study.vary.size());
    for (const std::size_t i : there) {
        if (!known->reasons[i].empty()) {
            now.tally.refuse(i, known->reasons[i]);
            continue;
        }
        sampler.point(i, u);
        const auto values = std::span(first.values).subspan(i * watched, watched);
        now.tally.add(u, values);
        std::copy(values.begin(), values.end(),
                  now.kept->values.begin() + static_cast<std::ptrdiff_t>(i * watched));
    }
    now.done = now.from + there.size();
    now.first = std::move(known);
    return now;
}

/// @throws Stopped
FirstSamples take_first(const Problem& problem, const Part& part, int threads, Pace& pace) {
    const std::uint64_t count = std::min(points_of(part.study), most_first_samples);
    const std::size_t watched = part.study.watch.size();
    FirstSamples first{std::vector<double>(count * watched), std::vector<Reason>(count)};
    std::vector<std::atomic<bool>> solved(count);
    std::atomic<std::uint64_t> done{0};
    const Work work = work_of(part);
    auto workers = make_workers(problem, part, threads, count);
    share_out(workers, 0, count, [&](Worker& worker, std::uint64_t i) {
        if (!worker.solve(i, std::span(first.values).subspan(i * watched, watched))) {
            first.reasons[i] = worker.reason();
        }
        solved[i].store(true, std::memory_order_release);
        ++done;
        if (&worker == workers.front().get()) {
            const auto so_far = [&] { return part_so_far(part, first, solved); };
            pace.tell((work.basis + static_cast<double>(done)) / std::max(work.whole(), 1.0),
                      is_sampled(part.study.method) ? std::function<Part()>(so_far) : nullptr);
        }
    });
    return first;
}

/// How far true samples lie from the expansions that stand for them.
void try_expansions(Response& response, const Study& study, Basis& basis) {
    const std::size_t watched = study.watch.size();
    basis.tried = tried_samples;
    basis.distances.assign(watched, 0.0);
    Sampler sampler(Method::sobol, tried_samples, study.seed, study.vary.size());
    std::vector<double> u(study.vary.size());
    std::vector<double> x(u.size());
    std::vector<double> y(watched);
    std::vector<double> expected(watched);
    ExpansionResponse expansions(basis);
    for (std::uint64_t i = 0; i < tried_samples; ++i) {
        sampler.point(i, u);
        for (std::size_t j = 0; j < x.size(); ++j) {
            x[j] = basis.laws[j].at(u[j]);
        }
        if (!response.evaluate(x, y)) {
            ++basis.tried_refused;
            continue;
        }
        expansions.evaluate(x, expected);
        for (std::size_t w = 0; w < watched; ++w) {
            const double off = y[w] - expected[w];
            const double period = basis.periods[w];
            basis.distances[w] += std::pow(period == 0.0 ? off : std::remainder(off, period), 2);
        }
    }
    const std::uint64_t solved = tried_samples - basis.tried_refused;
    for (double& each : basis.distances) {
        each = solved == 0 ? 0.0 : std::sqrt(each / static_cast<double>(solved));
    }
}

}  // namespace

std::pair<std::uint64_t, std::uint64_t> shard_range(const Study& study, std::uint64_t shard,
                                                    std::uint64_t shards) {
    const auto boundary = [&](std::uint64_t k) {
        __extension__ using Wide = unsigned __int128;
        return static_cast<std::uint64_t>(static_cast<Wide>(points_of(study)) * k / shards);
    };
    return {boundary(shard - 1), boundary(shard)};
}

std::vector<std::vector<double>> first_samples(const Part& part, std::size_t most) {
    std::vector<std::vector<double>> rows;
    if (part.first == nullptr || !is_sampled(part.study.method)) {
        return rows;
    }
    const std::size_t inputs = part.study.vary.size();
    const auto watched = static_cast<std::ptrdiff_t>(part.study.watch.size());
    Sampler sampler(part.study.method, part.study.points(), part.study.seed, inputs);
    std::vector<double> u(inputs);
    auto values = part.first->values.begin();
    for (std::size_t i = 0; i < part.first->reasons.size() && rows.size() < most; ++i) {
        sampler.point(i, u);
        if (part.first->reasons[i].empty()) {
            std::vector<double>& row = rows.emplace_back();
            for (std::size_t j = 0; j < inputs; ++j) {
                row.push_back(part.basis.laws[j].at(u[j]));
            }
            row.insert(row.end(), values, values + watched);
        }
        values += watched;
    }
    return rows;
}

namespace {

/// Expansions and departures, about the means of the inputs.
void expand(const Problem& problem, Part& part, Pace& pace) {
    Basis& basis = part.basis;
    const bool sampled = is_sampled(part.study.method);
    const Work work = work_of(part);
    CountingResponse response(problem.make(), [&](std::uint64_t count) {
        pace.tell(std::min(static_cast<double>(count), work.basis) / work.whole(), {});
    });
    Differences differences(response, basis.laws, part.study.watch.size());
    basis.expansions = differences.expand(basis.periods, part.study.method == Method::second_order);
    constexpr double sampled_reach = 3.0;
    constexpr double expanded_reach = 2.0;
    basis.departures = find_departures(response, basis.laws, basis.expansions, basis.periods,
                                       sampled ? sampled_reach : expanded_reach);
    if (!sampled) {
        plan_counting(part, take_first(problem, part, 1, pace));
        try_expansions(response, part.study, basis);
    }
    basis.evaluations = response.count();
    basis.refusals = response.refusals();
}

}  // namespace

double share_done(const Part& part) {
    const Work work = work_of(part);
    const auto done = static_cast<double>(part.done - part.from);
    if (!(work.samples > 0.0)) {
        return part.finished() ? 1.0 : 0.99;
    }
    const double solved = work.basis + std::max(work.first, done) + std::min(done, work.pairs);
    return std::min(solved / std::max(work.whole(), 1.0), 1.0);
}

Part begin_part(const Problem& problem, std::uint64_t shard, std::uint64_t shards, int threads,
                const Begun& begun) {
    Part part;
    part.origin = problem.origin;
    part.study = problem.study;
    part.file_notes = problem.file_notes;
    part.shard = shard;
    part.shards = shards;
    std::tie(part.from, part.to) = shard_range(part.study, shard, shards);
    part.done = part.from;
    Basis& basis = part.basis;
    basis.nominal = problem.nominal_result;
    for (std::size_t w = 0; w < part.study.watch.size(); ++w) {
        const double value = basis.nominal[w].value_or(0.0);
        basis.periods.push_back(period_of(part.study.watch[w].pointer, std::span(&value, 1)));
    }
    if (part.study.method == Method::grid) {
        part.tally = Tally({}, part.study.vary.size());
        return part;
    }
    for (std::size_t j = 0; j < part.study.vary.size(); ++j) {
        basis.laws.push_back(law_of(part.study.vary[j], problem.nominal[j]));
    }
    Pace pace(begun);
    try {
        expand(problem, part, pace);
        if (is_sampled(part.study.method)) {
            part.first = std::make_shared<FirstSamples>(take_first(problem, part, threads, pace));
            const std::vector<double> periods = basis.periods;
            plan_counting(part, *part.first);
            if (basis.periods != periods) {
                expand(problem, part, pace);  // an angle that goes on to 720°
            }
        }
    } catch (const Stopped&) {
        return part;
    }
    part.tally = Tally(basis.plan, part.study.vary.size());
    return part;
}

void keep_values(Part& part, std::uint64_t most) {
    if (part.study.method != Method::grid && part.done == part.from &&
        (part.to - part.from) <= most / std::max<std::size_t>(part.study.watch.size(), 1)) {
        part.kept = std::make_shared<KeptValues>();
    }
}

bool change_limits(Part& part, const std::vector<Watched>& watch) {
    if (part.kept == nullptr) {
        return false;
    }
    const std::size_t watched = watch.size();
    for (std::size_t w = 0; w < watched; ++w) {
        if (watch[w] == part.study.watch[w]) {
            continue;
        }
        part.study.watch[w] = watch[w];
        part.basis.plan[w].min = watch[w].min;
        part.basis.plan[w].max = watch[w].max;
        std::uint64_t within = 0;
        for (std::size_t i = w; i < part.kept->values.size(); i += watched) {
            const double value = part.kept->values[i];
            within += !std::isnan(value) && part.basis.plan[w].within(value) ? 1 : 0;
        }
        part.tally.set_limits(w, watch[w].min, watch[w].max, within);
    }
    return true;
}

void run_part(const Problem& problem, Part& part, int threads,
              const std::function<bool(const Part&)>& went_on) {
    using Clock = std::chrono::steady_clock;
    const bool grid = part.study.method == Method::grid;
    auto workers = make_workers(problem, part, threads, part.to - part.done);
    constexpr std::uint64_t few = 16;  // a slow scene shows them soon
    std::uint64_t stretch = few * workers.size();
    while (part.done < part.to) {
        const auto start = Clock::now();
        const std::uint64_t end = std::min(part.done + stretch, part.to);
        for (auto& worker : workers) {
            worker->start_tally();
        }
        if (part.kept != nullptr) {
            part.kept->values.resize((end - part.from) * part.study.watch.size(), not_solved);
        }
        if (grid) {
            part.rows.resize(end - part.from);
            share_out(workers, part.done, end, [&](Worker& worker, std::uint64_t i) {
                part.rows[i - part.from] = worker.row(i);
            });
        } else {
            share_out(workers, part.done, end,
                      [](Worker& worker, std::uint64_t i) { worker.count(i); });
        }
        for (const auto& worker : workers) {
            part.tally.add(worker->tally);
        }
        part.done = end;
        if (went_on && !went_on(part)) {
            return;
        }
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        constexpr double wanted = 0.25;
        if (seconds < 0.5 * wanted) {
            stretch *= 2;
        } else if (seconds > 2.0 * wanted && stretch > workers.size()) {
            stretch /= 2;
        }
    }
}

void PartMerger::add(Part part, const std::string& name) {
    const auto label = [&](std::uint64_t shard) {
        return std::to_string(shard) + "/" + std::to_string(shards_);
    };
    if (!whole_) {
        first_name_ = name;
        shards_ = part.shards;
        names_.resize(shards_);
        rows_.resize(shards_);
    } else if (part.origin.case_sha256 != whole_->origin.case_sha256 ||
               part.origin.files_sha256 != whole_->origin.files_sha256 ||
               part.study != whole_->study) {
        throw InputError(name,
                         {CORE_TEXT("studies", "is a part of another case than %1"), first_name_});
    } else if (part.shards != shards_) {
        throw InputError(name, {CORE_TEXT("studies", "is one of %1 parts, but %2 is one of %3"),
                                std::to_string(part.shards), first_name_, std::to_string(shards_)});
    } else if (part.origin.program != whole_->origin.program ||
               !same_basis(part.basis, whole_->basis)) {
        throw InputError(name, {CORE_TEXT("studies",
                                          "was computed by another program or machine than %1: "
                                          "it began with other numbers"),
                                first_name_});
    }
    if (!part.finished()) {
        throw InputError(
            name,
            {CORE_TEXT("studies", "is not finished (%1 of %2 samples); run it again: --shard %3"),
             std::to_string(part.done - part.from), std::to_string(part.to - part.from),
             label(part.shard)});
    }
    std::string& known = names_[part.shard - 1];
    if (!known.empty()) {
        throw InputError(
            name, {CORE_TEXT("studies", "is the same part as %1: %2"), known, label(part.shard)});
    }
    known = name;
    rows_[part.shard - 1] = std::move(part.rows);
    if (whole_) {
        whole_->tally.add(part.tally);
        if (part.robust_best) {
            whole_->robust_best = std::move(part.robust_best);
        }
        return;
    }
    whole_ = std::move(part);
    whole_->rows.clear();
    whole_->first.reset();
}

Part PartMerger::finish() {
    std::string missing;
    std::uint64_t count = 0;
    constexpr std::uint64_t most_named = 20;
    for (std::size_t k = 0; k < names_.size(); ++k) {
        if (names_[k].empty() && ++count <= most_named) {
            missing += (missing.empty() ? "" : ", ") + std::to_string(k + 1) + "/" +
                       std::to_string(shards_);
        }
    }
    if (count != 0) {
        missing += count > most_named ? ", …" : "";
        throw InputError(
            "", {CORE_TEXT("studies", "%1 of %2 parts are missing; run them again: --shard %3"),
                 std::to_string(count), std::to_string(shards_), missing});
    }
    Part whole = std::move(*whole_);
    whole.shard = whole.shards = 1;
    std::tie(whole.from, whole.to) = shard_range(whole.study, 1, 1);
    whole.done = whole.to;
    for (const auto& rows : rows_) {
        whole.rows.insert(whole.rows.end(), rows.begin(), rows.end());
    }
    return whole;
}

}  // namespace ravnoves::studies
