#include "elastic-hinge/model/motion_runner.h"

#include <QMetaObject>
#include <array>
#include <utility>

#include "text/error_text.h"

namespace ravnoves {

using elastic_hinge::HingeSet;
using elastic_hinge::Input;
using elastic_hinge::Motion;
using elastic_hinge::MotionWish;
using elastic_hinge::Result;

namespace {

constexpr int patienceMs = 150;  ///< a run older than that makes room for a newer one
constexpr int pauseMs = 30;      ///< so that a drag's frames have most of the machine
constexpr double offFactor = 1.2;

}  // namespace

MotionRunner::MotionRunner(QObject* parent) : QObject(parent) {
    pool_.setMaxThreadCount(1);
    pool_.setThreadPriority(QThread::LowPriority);
    pause_.setSingleShot(true);
    pause_.setInterval(pauseMs);
    connect(&pause_, &QTimer::timeout, this, &MotionRunner::launch);
}

MotionRunner::~MotionRunner() {
    if (job_) {
        job_->cancelled = true;
    }
    pool_.waitForDone();
}

double MotionRunner::offSpeed(const Input& input) {
    if (input.motion && input.motion->start_speed) {
        return *input.motion->start_speed;
    }
    return offFactor * input.angular_speed;
}

void MotionRunner::start(const Input& input, std::shared_ptr<const Result> result) {
    auto job = std::make_shared<Job>();
    job->input = input;
    job->result = std::move(result);
    const bool was = isRunning();
    pending_ = std::move(job);
    if (job_) {
        if (clock_.elapsed() > patienceMs) {
            job_->cancelled = true;
        }
    } else if (!pause_.isActive()) {
        pause_.start();
    }
    if (!was) {
        Q_EMIT runningChanged(true);
    }
}

void MotionRunner::cancel() {
    const bool waiting = !job_ && pending_;
    pending_.reset();
    pause_.stop();
    if (job_) {
        job_->cancelled = true;
    } else if (waiting) {
        Q_EMIT runningChanged(false);
    }
}

void MotionRunner::launch() {
    job_ = std::exchange(pending_, nullptr);
    if (!job_) {
        return;
    }
    clock_.start();
    pool_.start([this, job = job_] {
        auto motions = compute(*job);
        // Runs in this object's thread; dropped where the object is gone by then.
        QMetaObject::invokeMethod(
            this, [this, job, motions] { done(job, motions); }, Qt::QueuedConnection);
    });
}

void MotionRunner::done(const std::shared_ptr<Job>& job,
                        std::shared_ptr<const HingeMotions> motions) {
    const bool whole = !job->cancelled;
    job_.reset();
    if (whole) {
        Q_EMIT finished(std::move(motions));
    }
    if (pending_) {
        pause_.start();
    } else if (!job_) {
        Q_EMIT runningChanged(false);
    }
}

std::shared_ptr<const HingeMotions> MotionRunner::compute(Job& job) {
    auto motions = std::make_shared<HingeMotions>();
    motions->offSpeed = offSpeed(job.input);
    const Result& result = *job.result;
    if (!result.design->has_exact_kinematics()) {
        return motions;
    }
    Input atDesign = job.input;
    atDesign.motion = job.input.motion.value_or(MotionWish{});
    atDesign.motion->start_speed.reset();
    Input off = atDesign;
    off.motion->start_speed = motions->offSpeed;

    struct Run {
        const Input* input;
        HingeSet hinges;
        std::optional<Motion>* into;
        bool possible;
    };
    const bool crank = result.crank_guide.feasible;
    const bool both = result.crank_guide_with_rod.feasible && result.rod_guide.feasible;
    const std::array<Run, 4> runs{{
        {&atDesign, HingeSet::none, &motions->without, true},
        {&atDesign, HingeSet::crank, &motions->crank, crank},
        {&atDesign, HingeSet::crank_and_rod, &motions->both, both},
        {&off, HingeSet::crank, &motions->offDesign, crank},
    }};
    QElapsedTimer sinceReport;
    sinceReport.start();
    double before = 0.0;
    const auto report = [&](double part) {
        if (sinceReport.elapsed() > 40) {
            sinceReport.restart();
            const double whole = (before + part) / static_cast<double>(runs.size());
            QMetaObject::invokeMethod(
                this, [this, whole] { Q_EMIT progress(whole); }, Qt::QueuedConnection);
        }
        return !job.cancelled;
    };
    try {
        for (const Run& run : runs) {
            if (job.cancelled) {
                break;
            }
            if (run.possible) {
                *run.into = elastic_hinge::simulate(*run.input, result, run.hinges, report);
            }
            before += 1.0;
        }
    } catch (const std::exception& error) {
        motions->trouble = errorText(error);
    }
    return motions;
}

}  // namespace ravnoves
