#include "balance-shaft/model/shaft_map_model.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "model/background_job.h"
#include "numerics/constants.h"
#include "numerics/units.h"

namespace ravnoves {

using balance_shaft::BestPosition;
using balance_shaft::Input;
using balance_shaft::Obstacle;

namespace {

/// The input without the shaft's place, which the map does not depend on.
Input withoutPlace(Input input) {
    input.centre_distance = 0.0;
    input.shaft_angle = 0.0;
    return input;
}

}  // namespace

QString ShaftMapModel::Marker::name() const {
    return criterion == Criterion::range
               ? (isBuildable ? tr("best by range") : tr("min. range, ignoring clearance"))
               : (isBuildable ? tr("best by RMS") : tr("min. RMS, ignoring clearance"));
}

ShaftMapModel::ShaftMapModel(BalanceShaftModel* model)
    : QObject(model), model_(model), job_(new BackgroundJob(this)), seenAt_(present()) {
    job_->setPatience(500, 30);
    const auto move = [this] {
        seenAt_ = present();
        Q_EMIT moved();
    };
    connect(model_, &SceneModel::changed, this, move);
    connect(model_, &SceneModel::shownChanged, this, [this, move] {
        if (!(present() == seenAt_)) {
            move();
        }
    });
    connect(job_, &BackgroundJob::runningChanged, this, &ShaftMapModel::staleChanged);
    connect(job_, &BackgroundJob::failed, this, [this](const QString& why) {
        map_.reset();
        trouble_ = why;
        showMap();
    });
}

bool ShaftMapModel::isStale() const {
    return job_->isRunning();
}

bool ShaftMapModel::fits() const {
    const double distance = model_->input().centre_distance;
    constexpr double tooWide = 1.5;
    return distance <= map_->view &&
           (model_->isEditing() || map_->view <= tooWide * map_->viewFor(distance));
}

void ShaftMapModel::need() {
    if (std::exchange(seen_, model_->solutions()) != model_->solutions()) {
        isMapped_ = mapped_ && *mapped_ == withoutPlace(model_->input());
    }
    const bool rests = held_ || model_->isMoved() || job_->isRunning();
    if (!isMapped_ || (map_ && !rests && !fits())) {
        mapped_ = withoutPlace(model_->input());
        isMapped_ = true;
        start();
    }
}

void ShaftMapModel::setHeld(bool held) {
    held_ = held;
    if (!held) {
        need();
    }
}

void ShaftMapModel::start() {
    job_->start([this, solver = model_->solver(), present = model_->input().centre_distance](
                    const BackgroundJob::Progress& progress) -> std::function<void()> {
        const auto map = makeShaftMap(solver, present, progress);
        if (map == nullptr) {
            return {};
        }
        return [this, map] {
            map_ = map;
            trouble_.clear();
            showMap();
        };
    });
}

void ShaftMapModel::showMap() {
    markers_.clear();
    if (map_) {
        addMarker(Criterion::range, true, map_->smallRange);
        addMarker(Criterion::range, false, map_->best.range);
        addMarker(Criterion::rms, true, map_->smallRms);
        addMarker(Criterion::rms, false, map_->best.rms);
    }
    showCriterion();
    Q_EMIT model_->shownChanged();
}

void ShaftMapModel::addMarker(Criterion criterion, bool isBuildable,
                              const std::optional<BestPosition>& best) {
    // What is best of all is named once where it can be built.
    if (!best || (!isBuildable && this->isBuildable(best->position))) {
        return;
    }
    // What is best lies on the edge of what can be built: with a few digits it would be beyond.
    const Position place = shortened(best->position, criterion);
    markers_.push_back({criterion, isBuildable, place, map_->study.at(place)});
}

ShaftMapModel::Position ShaftMapModel::shortened(const Position& exact, Criterion by) const {
    constexpr double parts = 100.0;  // of a millimetre and of a degree
    constexpr int around = 3;
    const double l = std::floor(parts * exact.centre_distance() / units::mm);
    const double alpha = std::floor(parts * exact.shaft_angle() / degree);
    const bool canBeBuilt = isBuildable(exact);
    Position best = exact;
    double minimum = std::numeric_limits<double>::infinity();
    for (int i = 1 - around; i <= around; ++i) {
        for (int k = 1 - around; k <= around; ++k) {
            const Position at = Position::at(std::max(l + i, 0.0) / parts * units::mm,
                                             (alpha + k) / parts * degree);
            if (isBuildable(at) != canBeBuilt) {
                continue;
            }
            const Criteria here = map_->study.at(at);
            const double value = by == Criterion::range ? here.range : here.rms;
            if (value < minimum) {
                minimum = value;
                best = at;
            }
        }
    }
    return best;
}

bool ShaftMapModel::isAtBest() const {
    const Marker* marker = best();
    if (marker == nullptr || !marker->isBuildable || !isBuildable(present())) {
        return false;
    }
    constexpr double same = 1e-9;
    constexpr double noticed = 2e-3;
    const Criteria here = map_->study.at(present());
    return change(here).value_or(0.0) <= change(marker->criteria).value_or(0.0) + same &&
           here.size <= (1.0 + noticed) * marker->criteria.size;
}

std::optional<double> ShaftMapModel::change(const Criteria& criteria) const {
    if (!map_ || !(map_->study.range_without() > 0.0 && map_->study.rms_without() > 0.0)) {
        return std::nullopt;
    }
    return byRange() ? balance_shaft::relative_change(map_->study.range_without(), criteria.range)
                     : balance_shaft::relative_change(map_->study.rms_without(), criteria.rms);
}

void ShaftMapModel::showCriterion() {
    field_ = {};
    if (change({})) {
        const balance_shaft::PositionMap& of = map_->field;
        std::vector<double> changes(of.range.size());
        for (std::size_t i = 0; i < changes.size(); ++i) {
            changes[i] = *change({of.range[i], of.rms[i]});
        }
        field_ = changeContours(
            std::move(changes), of.columns,
            QRectF(of.left / units::mm, of.bottom / units::mm, (of.right - of.left) / units::mm,
                   (of.top - of.bottom) / units::mm));
    }
    Q_EMIT mapChanged();
}

const ShaftMapModel::Marker* ShaftMapModel::best() const {
    const Marker* found = nullptr;
    for (const Marker& marker : markers_) {
        if (marker.criterion == criterion() && (found == nullptr || marker.isBuildable)) {
            found = &marker;
        }
    }
    return found;
}

ShaftMapModel::Position ShaftMapModel::present() const {
    return Position::at(model_->input().centre_distance, model_->input().shaft_angle);
}

bool ShaftMapModel::isBuildable(const Position& position) const {
    return map_ && map_->study.obstacle(position) == Obstacle::none;
}

namespace {

/// To whole parts of a unit, as the number that its decimals stand for.
double inParts(double value, double unit, double parts) {
    return std::round(value / unit * parts) / parts * unit;
}

}  // namespace

void ShaftMapModel::moveTo(const Position& position, Parts parts) {
    const auto fine = static_cast<double>(parts);
    model_->drag(tr("Move shaft"), [&](Input& input) {
        input.centre_distance = inParts(position.centre_distance(), units::mm.to_si, fine);
        if (input.centre_distance > 0.0) {
            input.shaft_angle = std::fmod(inParts(position.shaft_angle(), degree, fine), two_pi);
        }
    });
}

void ShaftMapModel::goTo(const Position& position, Parts parts) {
    model_->finishDrag();
    moveTo(position, parts);
    model_->finishDrag();
}

void ShaftMapModel::goToBest() {
    if (const Marker* marker = best()) {
        goTo(marker->position);
    }
}

double ShaftMapModel::largestDistance() const {
    const double present = model_->input().centre_distance;
    return std::max(map_ ? map_->view : 0.0, present * (map_ ? 1.0 : 2.0));
}

}  // namespace ravnoves
