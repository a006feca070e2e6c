#include "studies/model/robust_model.h"

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "model/background_job.h"
#include "model/scene_model.h"
#include "scenes/responses.h"
#include "studies/model/study_model.h"
#include "studies/study_run.h"
#include "text/message_text.h"

namespace ravnoves {

namespace {

constexpr int robustRestMs = 300;

}  // namespace

RobustModel::RobustModel(StudyModel* study, QObject* parent)
    : QObject(parent), study_(study), job_(new BackgroundJob(this)) {
    later_.setSingleShot(true);
    later_.setInterval(robustRestMs);
    connect(&later_, &QTimer::timeout, this, &RobustModel::start);
    connect(study_, &StudyModel::changed, this, &RobustModel::follow);
    connect(job_, &BackgroundJob::failed, this, [this](const QString& why) {
        best_.reset();
        trouble_ = why;
        Q_EMIT changed();
    });
}

bool RobustModel::isAsked() const {
    return best_choice(study_->scene()->caseFile()).has_value();
}

void RobustModel::setWatched(bool watched) {
    watched_ = watched;
    stopped_ = false;
    if (!watched) {
        later_.stop();
        job_->cancel();
    } else if (stale_ || !best_) {
        start();
    }
}

void RobustModel::stop() {
    later_.stop();
    stopped_ = true;
    job_->cancel();
    Q_EMIT changed();
}

void RobustModel::run() {
    stopped_ = false;
    stale_ = true;
    start();
    Q_EMIT changed();
}

void RobustModel::follow() {
    // Where the angle stands now, and what else is watched, changes nothing.
    CaseFile file = study_->scene()->caseFile();
    const auto choice = best_choice(file);
    if (!choice) {
        return;
    }
    file.input[Json::json_pointer(choice->input)] = nullptr;
    studies::Study study = study_->study();
    study.watch.clear();
    std::string all = file.input.dump() + studies::write_study(study).dump();
    if (all == followed_ && (best_ || later_.isActive() || job_->isRunning())) {
        return;
    }
    followed_ = std::move(all);
    stale_ = true;
    stopped_ = false;
    trouble_.clear();
    Q_EMIT changed();
    if (watched_) {
        later_.start();
    }
}

void RobustModel::start() {
    later_.stop();
    if (!watched_) {
        return;
    }
    CaseFile file = study_->scene()->caseFile();
    const auto choice = best_choice(file);
    studies::Study study = study_->study();
    if (!choice || study.vary.empty() || study.method == studies::Method::grid) {
        job_->cancel();
        best_.reset();
        trouble_ = tr("Give an input its tolerance first.");
        Q_EMIT changed();
        return;
    }
    study.watch = {{.pointer = choice->value}};
    file.study = studies::write_study(study);
    job_->start([this, file = std::move(file), context = study_->scene()->context()](
                    const BackgroundJob::Progress& progress) -> std::function<void()> {
        const auto best = studies::find_robust_best(studies::problem_of(file, context), 1,
                                                    [&] { return progress(0.0); });
        if (!progress(1.0)) {
            return {};
        }
        return [this, best] {
            best_ = best;
            stale_ = false;
            trouble_ = best && !best->robust ? messageText(best->reason) : QString();
            Q_EMIT changed();
        };
    });
}

void RobustModel::goTo(double angle) {
    if (best_) {
        study_->scene()->editField(best_->input, angle, tr("Robust best α"));
    }
}

}  // namespace ravnoves
