#include "studies/study_run.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "case-file/input_error.h"
#include "studies/sampler.h"

namespace ravnoves::studies {

namespace {

constexpr std::uint64_t max_first_samples = 4096;
constexpr std::uint64_t pairs_per_input = 16'384;

/// Of these the bins are made.
std::uint64_t first_samples_of(const Study& study) {
    return study.method == Method::grid ? 0 : std::min(study.points(), max_first_samples);
}

/// Stands for the scene once it is expanded.
class ExpansionResponse final : public Response {
  public:
    explicit ExpansionResponse(const Basis& basis) : basis_(basis) {}
    bool evaluate(std::span<const double> x, std::span<double> y) override {
        for (std::size_t w = 0; w < y.size(); ++w) {
            y[w] = basis_.expansions[w].at(basis_.laws, x);
        }
        return true;
    }

  private:
    const Basis& basis_;
};

/// One thread's samples.
class Worker {
  public:
    Worker(const Problem& problem, const Part& part)
        : study_(part.study),
          part_(part),
          sampled_(is_sampled(part.study.method)),
          response_(study_.method == Method::linear
                        ? std::make_unique<ExpansionResponse>(part.basis)
                        : problem.make()),
          sampler_(study_.method, study_.seed, study_.vary.size()),
          inputs_(study_.vary.size()),
          u_(inputs_),
          x_(inputs_),
          y_(study_.watch.size()),
          other_(study_.watch.size()) {}

    Tally tally;

    /// The sample's values, without counting them.
    bool solve(std::uint64_t sample, std::span<double> y) {
        sampler_.point(sample, u_);
        set_inputs();
        return response_->evaluate(x_, y);
    }
    void count(Block& block, std::uint64_t sample) {
        if (!solve(sample, y_)) {
            tally.reject(sample, response_->reason());
            return;
        }
        tally.add(block, sample, u_, y_);
        if (sampled_ && sample < pairs_per_input * inputs_) {
            const auto input =
                static_cast<std::size_t>(random_bits(study_.seed, sample, 1, 0) % inputs_);
            u_[input] = random_uniform(study_.seed, sample, 1, 1);
            set_inputs();
            if (response_->evaluate(x_, other_)) {
                tally.add_pair(sample, input, y_, other_);
            }
        }
    }

    void fill(Row& row, std::uint64_t point) {
        std::uint64_t rest = point;
        for (std::size_t j = inputs_; j-- > 0;) {  // the last input changes fastest
            const std::vector<double>& values = study_.vary[j].values;
            x_[j] = values[rest % values.size()];
            rest /= values.size();
        }
        if (!response_->evaluate(x_, y_)) {
            tally.reject(point, response_->reason());
        }
        row.assign(x_.begin(), x_.end());
        for (const double value : y_) {
            row.push_back(std::isfinite(value) ? std::optional(value) : std::nullopt);
        }
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
    Sampler sampler_;
    std::size_t inputs_;
    std::vector<double> u_, x_, y_, other_;
};

using Workers = std::vector<std::unique_ptr<Worker>>;

/// As many workers as there are threads, or as work for them.
Workers make_workers(const Problem& problem, const Part& part, int threads, std::uint64_t work) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const std::uint64_t wanted = threads > 0 ? static_cast<unsigned>(threads) : cores;
    Workers workers;
    for (std::uint64_t i = 0; i < std::clamp<std::uint64_t>(work, 1, wanted); ++i) {
        workers.push_back(std::make_unique<Worker>(problem, part));
    }
    return workers;
}

/// Bins about the middle of what nearly all values span.
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
    const double minimum = std::max(std::abs(middle), 1e-6) * 0x1p-44;
    const double width = std::max(span * fineness, minimum);
    plan.width = std::ldexp(1.0, std::ilogb(width));
    plan.low =
        (std::floor(middle / plan.width) - 0.5 * static_cast<double>(bin_count)) * plan.width;
    return plan;
}

/// The watched values of the first samples, one after the other; of samples that are rejected none.
std::vector<std::vector<double>> take_first(const Problem& problem, const Part& part, int threads,
                                            Progress& progress) {
    const std::uint64_t count = first_samples_of(part.study);
    std::vector<std::vector<double>> samples(count);
    Workers workers = make_workers(problem, part, threads, count);
    share_out(workers.size(), count, [&](std::size_t worker, std::uint64_t k) {
        std::vector<double> y(part.study.watch.size());
        if (workers[worker]->solve(k, y)) {
            samples[k] = std::move(y);
        }
        return progress.step(worker);
    });
    std::erase_if(samples, [](const std::vector<double>& y) { return y.empty(); });
    return samples;
}

/// How far true samples lie from the expansions that stand for them.
void try_expansions(Response& response, const Study& study, Basis& basis) {
    Sampler sampler(Method::sobol, study.seed, basis.laws.size());
    std::vector<double> x(basis.laws.size());
    std::vector<double> y(study.watch.size());
    std::vector<double> expected(study.watch.size());
    ExpansionResponse expansions(basis);
    for (std::uint64_t i = 0; i < tried_samples; ++i) {
        sampler.point(i, x);
        for (std::size_t j = 0; j < x.size(); ++j) {
            x[j] = basis.laws[j].at(x[j]);
        }
        if (!response.evaluate(x, y)) {
            reject(basis.rejections, i, response.reason());
            continue;
        }
        expansions.evaluate(x, expected);
        for (std::size_t w = 0; w < y.size(); ++w) {
            basis.distances[w] += std::pow(difference(y[w], expected[w], response.period(w)), 2);
        }
    }
    const auto solved = static_cast<double>(tried_samples - count_of(basis.rejections));
    for (double& each : basis.distances) {
        each = solved == 0.0 ? 0.0 : std::sqrt(each / solved);
    }
}

void make_basis(const Problem& problem, Part& part, int threads, Progress& progress) {
    Basis& basis = part.basis;
    const Study& study = part.study;
    const std::size_t watched = study.watch.size();
    for (std::size_t j = 0; j < study.vary.size(); ++j) {
        basis.laws[j] = law_of(study.vary[j], problem.nominal[j]);
    }
    const auto response = problem.make();
    basis.expansions = expand(*response, basis.laws, watched);
    try_expansions(*response, study, basis);
    const auto first = take_first(problem, part, threads, progress);
    if (progress.is_stopped()) {
        return;
    }
    for (std::size_t w = 0; w < watched; ++w) {
        std::vector<double> values;
        for (const std::vector<double>& sample : first) {
            values.push_back(sample[w]);
        }
        basis.plan[w] =
            counting_plan(study.watch[w], basis.nominal[w], values, response->period(w));
    }
}

/// Several threads take blocks, each of one thread.
void solve_blocks(const Problem& problem, Part& part, int threads, Progress& progress) {
    Workers workers = make_workers(problem, part, threads, part.blocks.size());
    for (const auto& worker : workers) {
        worker->tally = Tally(part.basis.plan, part.study.vary.size());
    }
    share_out(workers.size(), part.blocks.size(), [&](std::size_t worker, std::uint64_t b) {
        Block& block = part.blocks[b];
        for (std::uint64_t sample = block.from; sample < block.to; ++sample) {
            if (part.study.method == Method::grid) {
                workers[worker]->fill(part.rows[sample - part.blocks.front().from], sample);
            } else {
                workers[worker]->count(block, sample);
            }
            if (!progress.step(worker)) {
                return false;
            }
        }
        return true;
    });
    for (const auto& worker : workers) {
        part.tally.add(worker->tally);
    }
}

}  // namespace

std::uint64_t Part::size() const {
    return blocks.empty() ? 0 : blocks.back().to - blocks.front().from;
}

Part empty_part(Study study, std::uint64_t shard, std::uint64_t shards) {
    Part part{.origin = {}, .study = std::move(study), .shard = shard, .shards = shards};
    const std::uint64_t points = part.study.points();
    const std::uint64_t count = std::min(points, max_blocks);
    const std::size_t inputs = part.study.vary.size();
    const std::size_t watched = part.study.watch.size();
    const bool is_grid = part.study.method == Method::grid;
    for (std::uint64_t b = count * (shard - 1) / shards; b < count * shard / shards; ++b) {
        part.blocks.push_back({.from = points * b / count, .to = points * (b + 1) / count});
        part.blocks.back().sums.resize(is_grid ? 0 : watched * replicates);
    }
    part.basis.nominal.resize(watched);
    if (is_grid) {
        part.rows.resize(part.size());
        return part;
    }
    part.basis.laws.resize(inputs);
    part.basis.distances.resize(watched);
    part.basis.plan.resize(watched);
    part.basis.expansions.resize(watched);
    for (Taylor& each : part.basis.expansions) {
        each.slopes.resize(inputs);
    }
    return part;
}

std::optional<Part> run_study(const Problem& problem, std::uint64_t shard, std::uint64_t shards,
                              int threads, const KeepGoing& keep_going) {
    Part part = empty_part(problem.study, shard, shards);
    part.origin = problem.origin;
    part.file_notes = problem.file_notes;
    part.basis.nominal = problem.nominal_result;
    Progress progress(keep_going, first_samples_of(part.study) + part.size());
    if (part.study.method != Method::grid) {
        make_basis(problem, part, threads, progress);
    }
    part.tally = Tally(part.basis.plan, part.study.vary.size());
    if (!progress.is_stopped()) {
        solve_blocks(problem, part, threads, progress);
    }
    return progress.is_stopped() ? std::nullopt : std::optional(std::move(part));
}

Part merge_parts(const std::vector<std::string>& names,
                 const std::function<Part(const std::string&)>& read) {
    std::optional<Part> whole;
    std::vector<std::string> known;  // names by shard; empty of one that is missing
    const auto label = [&](std::uint64_t shard) {
        return std::to_string(shard) + "/" + std::to_string(known.size());
    };
    for (const std::string& name : names) {
        Part part = read(name);
        const std::string& first = names.front();
        if (whole && (part.origin.case_sha256 != whole->origin.case_sha256 ||
                      part.origin.files_sha256 != whole->origin.files_sha256 ||
                      part.study != whole->study)) {
            throw InputError(name, {Text::tr("is a part of another case than %1"), first});
        }
        if (whole && part.shards != whole->shards) {
            throw InputError(name,
                             {Text::tr("is one of %1 parts, but %2 is one of %3"),
                              std::to_string(part.shards), first, std::to_string(whole->shards)});
        }
        if (whole && (part.origin.program != whole->origin.program ||
                      !same_basis(part.basis, whole->basis))) {
            throw InputError(name, {Text::tr("was computed by another program or machine than %1: "
                                             "the first numbers differ"),
                                    first});
        }
        known.resize(part.shards);
        std::string& same = known[part.shard - 1];
        if (!same.empty()) {
            throw InputError(name,
                             {Text::tr("is the same part as %1: %2"), same, label(part.shard)});
        }
        same = name;
        if (!whole) {
            whole = part;
            Part all = empty_part(part.study, 1, 1);
            whole->blocks = std::move(all.blocks);
            whole->rows = std::move(all.rows);
        } else {
            whole->tally.add(part.tally);
        }
        if (part.blocks.empty()) {
            continue;
        }
        const std::uint64_t from = part.blocks.front().from;
        std::move(part.blocks.begin(), part.blocks.end(),
                  std::ranges::find(whole->blocks, from, &Block::from));
        if (!part.rows.empty()) {  // of a grid
            std::move(part.rows.begin(), part.rows.end(),
                      whole->rows.begin() + static_cast<std::ptrdiff_t>(from));
        }
    }
    std::string missing;
    std::uint64_t count = 0;
    constexpr std::uint64_t max_named = 20;
    for (std::size_t k = 0; k < known.size(); ++k) {
        if (known[k].empty() && ++count <= max_named) {
            missing += (missing.empty() ? "" : ", ") + label(k + 1);
        }
    }
    if (count != 0) {
        missing += count > max_named ? ", …" : "";
        throw InputError("", {Text::tr("%1 of %2 parts are missing; run them again: "
                                       "--shard %3"),
                              std::to_string(count), std::to_string(known.size()), missing});
    }
    whole->shard = whole->shards = 1;
    return std::move(*whole);
}

}  // namespace ravnoves::studies
