#include "studies/model/sweep_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <thread>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/key_units.h"
#include "model/scene_model.h"
#include "scenes/scenes.h"
#include "studies/model/part_numbers.h"
#include "studies/model/solved_once.h"
#include "studies/model/study_model.h"
#include "studies/study_run.h"

namespace ravnoves {

namespace {

constexpr int places = 121;
constexpr int coarsest = 8;  ///< every so many of them first
static_assert((places - 1) % coarsest == 0);
constexpr int sweepRestMs = 200;

constexpr double unsolved = std::numeric_limits<double>::quiet_NaN();

/// Samples of the inputs behind the first, which is swept.
std::vector<std::vector<double>> othersOf(const studies::Problem& problem) {
    const studies::Study& study = problem.study;
    std::vector<studies::Law> laws;
    for (std::size_t j = 1; j < study.vary.size(); ++j) {
        laws.push_back(studies::law_of(study.vary[j], problem.nominal[j]));
    }
    return laws.empty() ? std::vector<std::vector<double>>(1)
                        : samplesOf(laws, studies::Method::sobol, study.seed);
}

/// @param values  of the samples; not a number where one was rejected
Sweep::Place placeOf(double x, std::vector<double> values, std::ptrdiff_t built) {
    const auto samples = static_cast<double>(values.size());
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) {
        return {x, unsolved, unsolved, unsolved, unsolved, 0.0, 1.0};
    }
    std::sort(values.begin(), values.end());
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    std::vector<double> sizes = values;
    for (double& size : sizes) {
        size = std::abs(size);
    }
    std::sort(sizes.begin(), sizes.end());
    return {x,
            sum / static_cast<double>(values.size()),
            percentileOf(values, 0.05),
            percentileOf(values, 0.95),
            percentileOf(sizes, 0.95),
            static_cast<double>(built) / samples,
            1.0 - static_cast<double>(values.size()) / samples};
}

/// Solves the samples at values of the first input; a second watched value says whether one can be
/// built.
class Sweeper {
  public:
    Sweeper(const studies::Problem& problem, const BackgroundJob::Progress& keepGoing, int values)
        : problem_(problem),
          samples_(othersOf(problem)),
          progress_(keepGoing, samples_.size() * static_cast<std::size_t>(values)),
          // One core stays free for the window.
          responses_(std::max(2U, std::thread::hardware_concurrency()) - 1) {}

    bool isStopped() const { return progress_.is_stopped(); }
    /// Nothing once it is stopped.
    std::vector<Sweep::Place> at(const std::vector<double>& values) {
        const std::size_t watched = problem_.study.watch.size();
        std::vector<std::vector<double>> found(values.size(),
                                               std::vector<double>(samples_.size(), unsolved));
        std::vector<std::vector<char>> built(values.size(), std::vector<char>(samples_.size()));
        const auto solve = [&](std::size_t worker, std::uint64_t i) {
            auto& response = responses_[worker];
            if (!response) {
                response = problem_.make();
            }
            std::vector<double> x = samples_[i];
            x.insert(x.begin(), 0.0);
            std::vector<double> y(watched);
            for (std::size_t k = 0; k < values.size() && progress_.step(worker); ++k) {
                x[0] = values[k];
                if (response->evaluate(x, y)) {
                    found[k][i] = y[0];
                    built[k][i] = watched == 1 || y[1] > 0.5;
                }  // else it is rejected, as in a study
            }
            return !isStopped();
        };
        studies::share_out(responses_.size(), samples_.size(), solve);
        std::vector<Sweep::Place> all;
        for (std::size_t k = 0; k < values.size() && !isStopped(); ++k) {
            all.push_back(placeOf(values[k], found[k],
                                  std::count(built[k].begin(), built[k].end(), char{1})));
        }
        return all;
    }

  private:
    const studies::Problem& problem_;
    std::vector<std::vector<double>> samples_;
    studies::Progress progress_;
    std::vector<std::unique_ptr<Response>> responses_;  ///< by worker
};

/// Where the 95 % amount is smallest, of the places at which so many of the samples can be built.
std::optional<Sweep::Place> bestOf(const std::vector<Sweep::Place>& places, double built) {
    std::optional<Sweep::Place> best;
    for (const Sweep::Place& place : places) {
        if (std::isfinite(place.size) && place.built > 0.0 && place.built >= built &&
            (!best || place.size < best->size)) {
            best = place;
        }
    }
    return best;
}

/// @param show  is given the results so far, from coarse to fine
/// @return nothing where it was stopped
std::optional<Sweep> computed(const studies::Problem& problem,
                              const BackgroundJob::Progress& keepGoing,
                              const std::function<void(const Sweep&)>& show) {
    constexpr int rounds = 3;  // each a tenth as wide
    constexpr int finer = 21;
    const double from = problem.study.vary[0].from;
    const double to = problem.study.vary[0].to;
    Sweeper sweeper(problem, keepGoing, places + rounds * finer);
    Sweep sweep{.nominalResult = problem.nominal_result.front()};
    const std::vector<double> all = studies::spaced(from, to, places);
    for (int step = coarsest; step > 0 && !sweeper.isStopped(); step /= 2) {
        std::vector<double> values;
        const bool isFirst = step == coarsest;
        for (int i = isFirst ? 0 : step; i < places; i += isFirst ? step : 2 * step) {
            values.push_back(all[static_cast<std::size_t>(i)]);
        }
        std::ranges::move(sweeper.at(values), std::back_inserter(sweep.places));
        std::ranges::sort(sweep.places, {}, &Sweep::Place::x);
        if (!sweeper.isStopped()) {
            show(sweep);
        }
    }
    double maximum = 0.0;
    for (const Sweep::Place& place : sweep.places) {
        maximum = std::max(maximum, place.built);
    }
    const double built = std::min(maximum, Sweep::minBuilt);
    sweep.best = bestOf(sweep.places, built);
    double step = (to - from) / (places - 1);
    for (int round = 0; round < rounds && sweep.best; ++round) {
        const auto near = sweeper.at(studies::spaced(std::max(from, sweep.best->x - step),
                                                     std::min(to, sweep.best->x + step), finer));
        step *= 2.0 / (finer - 1);
        if (const auto best = bestOf(near, built); best && best->size < sweep.best->size) {
            sweep.best = best;
        }
    }
    return sweeper.isStopped() ? std::nullopt : std::optional(sweep);
}

}  // namespace

SweepModel::SweepModel(StudyModel* study, QObject* parent)
    : QObject(parent), study_(study), job_(new BackgroundJob(this)) {
    job_->setPatience(0, sweepRestMs, true);
    connect(study_, &StudyModel::changed, this, &SweepModel::follow);
    connect(job_, &BackgroundJob::failed, this, [this](const QString& why) {
        trouble_ = why;
        Q_EMIT changed();
    });
    follow();
}

std::vector<const StudyModel::Input*> SweepModel::inputs() const {
    std::vector<const StudyModel::Input*> inputs;
    for (const bool scatters : {true, false}) {
        for (const StudyModel::Input& input : study_->inputs()) {
            if (input.varied.has_value() == scatters && !input.isMissing) {
                inputs.push_back(&input);
            }
        }
    }
    return inputs;
}

std::optional<SweepModel::Ends> SweepModel::usualEnds() const {
    const StudyModel::Input* input = study_->input(choice_.input);
    if (input == nullptr) {
        return std::nullopt;
    }
    constexpr double part = 0.1;
    const double nominal = input->value;
    const double half = input->half();
    const double reach = half > 0.0 ? half : nominal != 0.0 ? part * std::abs(nominal) : 1.0;
    const bool turns = half == 0.0 && unit_at(choice_.input) == units::degree;
    const Range range = study_->rangeOf(choice_.input);
    return Ends{std::clamp(turns ? 0.0 : nominal - reach, range.min, range.max),
                std::clamp(turns ? 360.0 : nominal + reach, range.min, range.max)};
}

void SweepModel::setWatched(bool watched) {
    watched_ = watched;
    if (watched && (stale_ || !sweep_) && !isBusy()) {
        start();
    }
}

void SweepModel::follow() {
    choice_ = study_->scene()->sweepChoice();
    const auto offered = inputs();
    if (!offered.empty() &&
        std::ranges::find(offered, choice_.input, &StudyModel::Input::pointer) == offered.end()) {
        choice_.input = offered.front()->pointer;
    }
    const auto& watch = study_->study().watch;
    if (!watch.empty() &&
        std::ranges::find(watch, choice_.result, &studies::Watched::pointer) == watch.end()) {
        choice_.result = watch.front().pointer;
    }
    Wanted wanted = wantedNow();
    if (wanted != wanted_) {
        wanted_ = std::move(wanted);
        stale_ = true;
        partial_ = false;
        job_->cancel();  // what it finds is of what was before
        const auto& vary = wanted_.study.vary;
        const bool isEmpty = !vary.empty() && !(vary.front().from < vary.front().to);
        trouble_ = isEmpty ? tr("“From” must be less than “to”.") : QString();
        start();
    }
    Q_EMIT changed();
}

SweepModel::Wanted SweepModel::wantedNow() const {
    const StudyModel::Input* swept = study_->input(choice_.input);
    if (swept == nullptr || choice_.result.empty()) {
        return {};
    }
    const Ends usual = *usualEnds();
    const SceneModel& scene = *study_->scene();
    Wanted wanted{.study = {.vary = {{.pointer = choice_.input,
                                      .spread = studies::Varied::Spread::uniform,
                                      .from = choice_.from.value_or(usual.first),
                                      .to = choice_.to.value_or(usual.second)}},
                            .watch = {{.pointer = choice_.result}},
                            .seed = study_->study().seed},
                  .solution = scene.solutions()};
    for (const StudyModel::Input& input : study_->inputs()) {
        if (&input != swept && !input.isMissing && input.half() > 0.0) {
            wanted.study.vary.push_back(*input.varied);
        }
    }
    watchFeasible(wanted.study, scene);
    return wanted;
}

void SweepModel::start() {
    if (!watched_ || wanted_.study.vary.empty() || !trouble_.isEmpty()) {
        return;
    }
    const SceneModel& scene = *study_->scene();
    CaseFile file = scene.caseFile();
    scene.giveDefaults(file.input, {choice_.input});
    file.study = studies::write_study(wanted_.study);
    job_->start([this, job = job_, file = std::move(file), context = scene.context()](
                    const BackgroundJob::Progress& progress) -> std::function<void()> {
        const studies::Problem problem = studies::problem_of(file, context);
        const auto found = solvedOnce<Sweep>(problem, 1, [&] {
            return computed(problem, progress, [this, job](const Sweep& soFar) {
                job->tellSoFar([this, soFar] { show(soFar, true); });
            });
        });
        if (!found) {
            return {};
        }
        return [this, found] { show(*found, false); };
    });
}

void SweepModel::show(const Sweep& sweep, bool isPartial) {
    sweep_ = sweep;
    partial_ = isPartial;
    stale_ = isPartial;
    trouble_.clear();
    Q_EMIT changed();
}

void SweepModel::takeBest() {
    if (sweep_ && sweep_->best) {
        study_->scene()->editField(choice_.input, sweep_->best->x, tr("Minimum 95th percentile"));
    }
}

}  // namespace ravnoves
