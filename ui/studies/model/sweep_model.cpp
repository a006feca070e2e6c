#include "studies/model/sweep_model.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/background_job.h"
#include "model/default_inputs.h"
#include "model/scene_model.h"
#include "studies/model/study_model.h"
#include "studies/study_run.h"
#include "studies/sweep.h"

namespace ravnoves {

namespace {

constexpr int linePoints = 121;
constexpr int mapPoints = 45;
constexpr int sweepRestMs = 200;

/// One core stays free for the window.
int sweepThreads() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
}

/// @return without numbers where it was stopped
Sweep computed(Sweep sweep, const studies::Problem& problem,
               const BackgroundJob::Progress& progress) {
    studies::Part part = studies::begin_part(problem, 1, 1, sweepThreads());
    studies::run_part(problem, part, sweepThreads(), [&](const studies::Part& now) {
        return progress(static_cast<double>(now.done) / static_cast<double>(now.to));
    });
    if (!part.finished() || !progress(1.0)) {
        return {};
    }
    const studies::SweepTable table = studies::sweep_table(part);
    sweep.x.values = table.axes[0];
    if (!sweep.y) {
        sweep.found = table.values[0];
    } else {
        sweep.y->values = table.axes[1];
        for (std::size_t j = 0; j < sweep.y->values.size(); ++j) {
            for (std::size_t i = 0; i < sweep.x.values.size(); ++i) {
                sweep.found.push_back(table.at(0, i, j));
            }
        }
    }
    sweep.refused =
        static_cast<std::size_t>(std::count_if(sweep.found.begin(), sweep.found.end(),
                                               [](double value) { return !std::isfinite(value); }));
    sweep.nominal = problem.nominal_result.front();
    return sweep;
}

}  // namespace

SweepModel::SweepModel(StudyModel* study, QObject* parent)
    : QObject(parent), study_(study), job_(new BackgroundJob(this)) {
    later_.setSingleShot(true);
    later_.setInterval(sweepRestMs);
    connect(&later_, &QTimer::timeout, this, &SweepModel::start);
    connect(study_, &StudyModel::changed, this, &SweepModel::follow);
    connect(job_, &BackgroundJob::failed, this, [this](const QString& why) {
        trouble_ = why;
        Q_EMIT changed();
    });
}

void SweepModel::choose(const std::string& input, const std::string& other,
                        const std::string& result) {
    if (input != input_ || other != other_ || result != result_) {
        input_ = input;
        other_ = other == input ? std::string() : other;
        result_ = result;
        follow();
    }
}

void SweepModel::setReach(double times) {
    if (times != reach_) {
        reach_ = times;
        follow();
    }
}

void SweepModel::setWatched(bool watched) {
    watched_ = watched;
    if (!watched) {
        later_.stop();
        job_->cancel();
    } else if (stale_ || !sweep_) {
        start();
    }
}

void SweepModel::follow() {
    stale_ = true;
    trouble_.clear();
    Q_EMIT changed();
    if (watched_) {
        later_.start();
    }
}

Sweep::Axis SweepModel::axisOf(const std::string& pointer) const {
    Sweep::Axis axis{.pointer = pointer, .values = {}};
    for (const StudyModel::Input& input : study_->inputs()) {
        if (input.pointer == pointer) {
            axis.nominal = input.nominal;
            if (input.varied && input.varied->spread != studies::Varied::Spread::grid) {
                const auto [low, high] = studies::swept_range(*input.varied, input.nominal);
                axis.half = 0.5 * (high - low);
            }
        }
    }
    return axis;
}

void SweepModel::start() {
    later_.stop();
    if (!watched_ || input_.empty() || result_.empty()) {
        return;
    }
    Sweep sweep{.x = axisOf(input_), .y = {}, .result = result_, .found = {}, .nominal = {}};
    std::vector<studies::SweptInput> swept;
    const auto add = [&](const Sweep::Axis& axis, int steps) {
        constexpr double part = 0.1;
        const double whole = axis.nominal != 0.0 ? part * std::abs(axis.nominal) : 1.0;
        const double reach = reach_ * (axis.half > 0.0 ? axis.half : whole);
        swept.push_back({axis.pointer, axis.nominal - reach, axis.nominal + reach, steps});
    };
    add(sweep.x, other_.empty() ? linePoints : mapPoints);
    if (!other_.empty()) {
        sweep.y = axisOf(other_);
        add(*sweep.y, mapPoints);
    }
    const studies::Study tried = studies::sweep_study(swept, {{.pointer = result_}});
    SceneModel& scene = *study_->scene();
    CaseFile file = scene.caseFile();
    giveDefaults(scene, file.input, {input_, other_});
    file.study = studies::write_study(tried);
    job_->start([this, sweep = std::move(sweep), file = std::move(file), context = scene.context()](
                    const BackgroundJob::Progress& progress) -> std::function<void()> {
        Sweep found = computed(sweep, studies::problem_of(file, context), progress);
        if (found.found.empty()) {
            return {};
        }
        return [this, found = std::move(found)] {
            sweep_ = found;
            stale_ = false;
            trouble_.clear();
            Q_EMIT changed();
        };
    });
}

}  // namespace ravnoves
