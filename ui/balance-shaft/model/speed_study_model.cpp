#include "balance-shaft/model/speed_study_model.h"

#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

#include "model/background_job.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

using balance_shaft::Input;
using balance_shaft::SpeedBand;
using balance_shaft::SpeedStudy;

double SpeedStudyModel::changeAt(double angleDeg, double speed) const {
    const auto along = [](double part, std::size_t count) {  // the element before, and the rest
        const double place = std::clamp(part, 0.0, 1.0) * static_cast<double>(count - 1);
        const auto before = std::min(static_cast<std::size_t>(place), count - 2);
        return std::pair(before, place - static_cast<double>(before));
    };
    const QRectF& where = map_.where;
    const std::size_t columns = map_.columns;
    const auto [left, s] = along((angleDeg - where.left()) / where.width(), columns);
    const auto [below, t] =
        along((speed - where.top()) / where.height(), map_.changes.size() / columns);
    const double* at = map_.changes.data() + below * columns + left;
    return std::lerp(std::lerp(at[0], at[1], s), std::lerp(at[columns], at[columns + 1], s), t);
}

SpeedStudyModel::SpeedStudyModel(BalanceShaftModel* model)
    : QObject(model), model_(model), job_(new BackgroundJob(this)) {
    connect(job_, &BackgroundJob::failed, this, [this](const QString& why) { take({}, why); });
}

SpeedBand SpeedStudyModel::bandOf(const Input& input) {
    return input.speed_band.value_or(
        SpeedBand{0.3 * input.angular_speed, 1.1 * input.angular_speed});
}

void SpeedStudyModel::setBand(double SpeedBand::*end, double speed) {
    model_->edit(tr("Speed band"), [&](Input& input) {
        input.speed_band = band();
        (*input.speed_band).*end = speed;
    });
}

void SpeedStudyModel::showCriterion() {
    map_ = study_.map ? mapOf(*study_.map) : ChangeContours();
    Q_EMIT mapChanged();
}

SpeedStudyModel::Study SpeedStudyModel::studyOf(const Input& input, const SpeedBand& band,
                                                const std::function<bool(double)>& progress) {
    const auto study = std::make_shared<SpeedStudy>(
        input, band, [&](double part) { return progress(0.3 * part); });
    Study result{study, {}, {}, {}};
    if (!study->reason().empty() || !study->is_complete()) {
        return result;
    }
    constexpr std::size_t angles = 360;
    result.map = study->map(angles, [&](double part) { return progress(0.3 + 0.6 * part); });
    const auto bestOf = [&](const std::vector<balance_shaft::AngleStretch>& among) {
        constexpr auto relative = SpeedStudy::Measure::relative;
        return Best{study->best_compromise_angle(Criterion::range, relative, among),
                    study->best_compromise_angle(Criterion::rms, relative, among)};
    };
    result.ofAll = bestOf(balance_shaft::whole_turn());
    const auto& stretches = study->buildable().stretches;
    result.best = stretches.empty() ? result.ofAll : bestOf(stretches);
    return result;
}

void SpeedStudyModel::need() {
    if (std::exchange(seen_, model_->solutions()) == model_->solutions()) {
        return;
    }
    Input input = model_->input();
    input.shaft_angle = 0.0;  // the study does not depend on it
    if (wanted_ == input) {
        return;
    }
    wanted_ = input;
    job_->start([this, input, range = band()](const BackgroundJob::Progress& progress) {
        auto result = std::make_shared<Study>(studyOf(input, range, progress));
        return [this, result] { take(std::move(*result), {}); };
    });
}

void SpeedStudyModel::cancel() {
    job_->cancel();
    take({}, tr("Cancelled. Change an input to solve again."));
}

void SpeedStudyModel::take(Study study, const QString& trouble) {
    study_ = std::move(study);
    trouble_ = trouble;
    showCriterion();
    Q_EMIT model_->shownChanged();
}

ChangeContours SpeedStudyModel::mapOf(const SpeedStudy::Map& studied) const {
    const auto& points = study_.study->points();
    const std::size_t angles = studied.shaft_angle_deg.size();
    std::vector<double> changes;
    changes.reserve(points.size() * (angles + 1));
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double without = model_->byRange() ? points[k].range_without : points[k].rms_without;
        const double* with = (model_->byRange() ? studied.range : studied.rms).data() + k * angles;
        for (std::size_t i = 0; i <= angles; ++i) {  // 360° is 0° again
            changes.push_back(without > 0.0 ? with[i % angles] / without - 1.0 : 0.0);
        }
    }
    const double lowest = points.front().angular_speed / units::rpm;
    return changeContours(
        std::move(changes), angles + 1,
        QRectF(0.0, lowest, 360.0, points.back().angular_speed / units::rpm - lowest));
}

void SpeedStudyModel::goToBestCompromise() {
    model_->finishDrag();
    model_->setShaftAngleDeg(bestCompromiseDeg());
    model_->finishDrag();
}

QString SpeedStudyModel::answer() const {
    if (!trouble_.isEmpty() || study_.study == nullptr) {
        return trouble_;
    }
    if (!isSolved()) {
        return messageText(study_.study->reason()) + QLatin1Char(' ') +
               (model_->canRebuildTorque()
                    ? tr("Rebuild the torque here, or choose a pressure trace or a computed "
                         "cycle on the Torque tab.")
                    : tr("Choose a pressure trace or a computed cycle on the Torque tab."));
    }
    const QLocale locale;
    const BestCompromise& best = among(study_.best);
    const BestCompromise& ofAll = among(study_.ofAll);
    QString other;
    if (buildable().stretches.empty()) {
        other = tr(" No position is feasible.");
    } else if (best.value > ofAll.value + 5e-4) {
        other = tr(" %1° would gain %2 % more but does not fit.")
                    .arg(fixedNumber(ofAll.shaft_angle / degree, 1, locale),
                         fixedNumber((best.value - ofAll.value) / units::percent, 1, locale));
    }
    const double change = (best.value - 1.0) / units::percent;
    return tr("Best compromise α over the band, by %1 vs. no shaft: %2°. At the worst speed, %3, "
              "the %1 is %4 % %5.")
               .arg(model_->byRange() ? tr("range") : tr("RMS"),
                    fixedNumber(best.shaft_angle / degree, 1, locale),
                    shownNumber(best.worst_speed, units::rpm, 0),
                    fixedNumber(std::abs(change), 1, locale),
                    change > 0.0 ? tr("larger") : tr("smaller")) +
           other + QLatin1Char(' ') + gasAtEverySpeed();
}

void SpeedStudyModel::pick(double angleDeg, double speed) {
    model_->pickShaftAngleDeg(angleDeg);
    if (model_->input().torque.is_computed()) {
        model_->setSpeed(std::round(speed / 10.0) * 10.0 * units::rpm);
    }
}

QString SpeedStudyModel::gasAtEverySpeed() const {
    using Kind = balance_shaft::TorqueSource::Kind;
    switch (model_->input().torque.kind) {
        case Kind::pressure:
            return tr("The gas torque at every speed is from one pressure trace.");
        case Kind::cycle:
            return tr("The load is constant over the speed.");
        default:
            return tr("The gas torque at every speed is from the given torque.");
    }
}

}  // namespace ravnoves
