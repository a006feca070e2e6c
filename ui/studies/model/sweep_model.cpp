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
#include "scenes/scenes.h"
#include "studies/model/part_numbers.h"
#include "studies/model/study_model.h"
#include "studies/study_run.h"

namespace ravnoves {

namespace {

constexpr int places = 121;
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

/// One for each worker.
using Responses = std::vector<std::unique_ptr<Response>>;

/// Solves the samples at each value of the input that is swept; a second watched value says whether
/// one can be built.
/// @return none where it was stopped
std::vector<Sweep::Place> placesAt(const std::vector<double>& values,
                                   const studies::Problem& problem,
                                   const std::vector<std::vector<double>>& samples,
                                   Responses& responses, studies::Progress& progress) {
    const std::size_t watched = problem.study.watch.size();
    std::vector<std::vector<double>> found(values.size(),
                                           std::vector<double>(samples.size(), unsolved));
    std::vector<std::vector<char>> built(values.size(), std::vector<char>(samples.size()));
    studies::share_out(responses.size(), samples.size(), [&](std::size_t worker, std::uint64_t i) {
        if (!responses[worker]) {
            responses[worker] = problem.make();
        }
        std::vector<double> x = samples[i];
        x.insert(x.begin(), 0.0);
        std::vector<double> y(watched);
        for (std::size_t k = 0; k < values.size(); ++k) {
            x[0] = values[k];
            if (responses[worker]->evaluate(x, y)) {
                found[k][i] = y[0];
                built[k][i] = watched == 1 || y[1] > 0.5;
            }  // else it is rejected, as in a study
            if (!progress.step(worker)) {
                return false;
            }
        }
        return true;
    });
    std::vector<Sweep::Place> all;
    for (std::size_t k = 0; k < values.size() && !progress.is_stopped(); ++k) {
        all.push_back(
            placeOf(values[k], found[k], std::count(built[k].begin(), built[k].end(), char{1})));
    }
    return all;
}

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

/// @return nothing where it was stopped
std::optional<Sweep> computed(const studies::Problem& problem,
                              const BackgroundJob::Progress& keepGoing) {
    constexpr int rounds = 3;  // each a tenth as wide
    constexpr int finer = 21;
    const double from = problem.study.vary[0].from;
    const double to = problem.study.vary[0].to;
    const auto samples = othersOf(problem);
    studies::Progress progress(keepGoing, samples.size() * (places + rounds * finer));
    // One core stays free for the window.
    Responses responses(std::max(2U, std::thread::hardware_concurrency()) - 1);
    Sweep sweep{.input = problem.study.vary[0].pointer,
                .result = problem.study.watch[0].pointer,
                .nominalResult = problem.nominal_result.front()};
    sweep.places =
        placesAt(studies::spaced(from, to, places), problem, samples, responses, progress);
    double maximum = 0.0;
    for (const Sweep::Place& place : sweep.places) {
        maximum = std::max(maximum, place.built);
    }
    const double built = std::min(maximum, Sweep::minBuilt);
    sweep.best = bestOf(sweep.places, built);
    double step = (to - from) / (places - 1);
    for (int round = 0; round < rounds && sweep.best; ++round) {
        const auto near = placesAt(studies::spaced(std::max(from, sweep.best->x - step),
                                                   std::min(to, sweep.best->x + step), finer),
                                   problem, samples, responses, progress);
        step *= 2.0 / (finer - 1);
        if (const auto best = bestOf(near, built); best && best->size < sweep.best->size) {
            sweep.best = best;
        }
    }
    return progress.is_stopped() ? std::nullopt : std::optional(sweep);
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
    if (watched && !sweep_ && !job_->isRunning()) {
        start();
    }
}

studies::Study SweepModel::wantedNow() const {
    const StudyModel::Input* swept = study_->input(choice_.input);
    if (swept == nullptr || choice_.result.empty()) {
        return {};
    }
    const Ends usual = *usualEnds();
    studies::Study wanted{.vary = {{.pointer = choice_.input,
                                    .spread = studies::Varied::Spread::uniform,
                                    .from = choice_.from.value_or(usual.first),
                                    .to = choice_.to.value_or(usual.second)}},
                          .watch = {{.pointer = choice_.result}},
                          .seed = study_->study().seed};
    for (const StudyModel::Input& input : study_->inputs()) {
        if (&input != swept && !input.isMissing && input.half() > 0.0) {
            wanted.vary.push_back(*input.varied);
        }
    }
    watchFeasible(wanted, *study_->scene());
    return wanted;
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
    studies::Study wanted = wantedNow();
    const int solution = study_->scene()->solutions();
    if (wanted != wanted_ || solution != solution_) {
        wanted_ = std::move(wanted);
        solution_ = solution;
        sweep_.reset();
        job_->cancel();  // what it finds is of what was before
        const auto& vary = wanted_.vary;
        const bool isEmpty = !vary.empty() && !(vary.front().from < vary.front().to);
        trouble_ = isEmpty ? tr("“From” must be less than “to”.") : QString();
        start();
    }
    Q_EMIT changed();
}

void SweepModel::start() {
    if (!watched_ || wanted_.vary.empty() || !trouble_.isEmpty()) {
        return;
    }
    SceneModel& scene = *study_->scene();
    CaseFile file = scene.caseFile();
    scene.giveDefaults(file.input, {choice_.input});
    file.study = studies::write_study(wanted_);
    job_->start([this, file = std::move(file), context = scene.context()](
                    const BackgroundJob::Progress& progress) -> std::function<void()> {
        const auto found = computed(studies::problem_of(file, context), progress);
        if (!found) {
            return {};
        }
        return [this, found] {
            sweep_ = found;
            trouble_.clear();
            Q_EMIT changed();
        };
    });
}

void SweepModel::takeBest() {
    if (sweep_ && sweep_->best) {
        study_->scene()->editField(sweep_->input, sweep_->best->x, tr("Minimum 95th percentile"));
    }
}

}  // namespace ravnoves
