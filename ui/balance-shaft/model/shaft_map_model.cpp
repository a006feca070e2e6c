#include "balance-shaft/model/shaft_map_model.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "model/background_job.h"
#include "numerics/constants.h"
#include "plot/model/contour_lines.h"
#include "plot/model/ticks.h"
#include "text/csv_format.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

using balance_shaft::BestPosition;
using balance_shaft::Input;
using balance_shaft::Obstacle;
using balance_shaft::PositionStudy;

namespace {

/// The input without the shaft's place, which the map does not depend on.
Input withoutPlace(Input input) {
    input.centre_distance = 0.0;
    input.shaft_angle = 0.0;
    return input;
}

// The field reaches further than the square shown first: the picture may be wider or higher. Its
// steps are equal; of its points every second is looked at for obstacles.
constexpr double reachAcross = 2.6;
constexpr double reachUp = 1.6;
constexpr std::size_t obstacleColumns = 196;
constexpr std::size_t obstacleRows = 121;
constexpr double roomAround = 1.25;

void findObstacles(ShaftMap& map, const std::function<bool(double)>& progress) {
    const balance_shaft::PositionMap& field = map.field;
    std::vector<double> blocked;
    const double stepX = (field.right - field.left) / (obstacleColumns - 1);
    const double stepY = (field.top - field.bottom) / (obstacleRows - 1);
    const auto place = [&](double column, double row) {
        return ShaftMap::Position{field.left + stepX * column, field.bottom + stepY * row};
    };
    for (std::size_t row = 0; row < obstacleRows; ++row) {
        if (!progress(static_cast<double>(row) / obstacleRows)) {
            return;
        }
        for (std::size_t column = 0; column < obstacleColumns; ++column) {
            const auto at = place(static_cast<double>(column), static_cast<double>(row));
            blocked.push_back(map.study.obstacle(at) == Obstacle::none ? 0.0 : 1.0);
        }
    }
    // The boundary between two places by bisection: the lines are as smooth as what they follow.
    const auto crossing = [&](std::size_t from, std::size_t to) {
        const auto at = [&](std::size_t element, double part) {
            const bool upwards = to - from > 1;
            const std::size_t row = element / obstacleColumns;
            return place(static_cast<double>(element % obstacleColumns) + (upwards ? 0.0 : part),
                         static_cast<double>(row) + (upwards ? part : 0.0));
        };
        double low = 0.0;
        double high = 1.0;
        for (int i = 0; i < 6; ++i) {
            const double middle = 0.5 * (low + high);
            const bool isBlocked = map.study.obstacle(at(from, middle)) != Obstacle::none;
            (isBlocked == (blocked[from] > 0.5) ? low : high) = middle;
        }
        return 0.5 * (low + high);
    };
    map.blocked = contourRegion({blocked, obstacleColumns, obstacleRows}, 0.5, crossing);
    for (QPolygonF& line : map.blocked) {
        for (QPointF& point : line) {
            const ShaftMap::Position at = place(point.x(), point.y());
            point = QPointF(at.x, at.y);
        }
    }
}

/// @param present   l of the shaft now, which is to be seen; m
/// @param progress  receives the part that is done, 0…1; false stops it
/// @return null where it was stopped
std::shared_ptr<const ShaftMap> makeShaftMap(const balance_shaft::Solver& solver, double present,
                                             const std::function<bool(double)>& progress) {
    auto map = std::make_shared<ShaftMap>(ShaftMap{.study = PositionStudy(solver)});
    map->best = map->study.best();
    map->buildable = map->study.best_buildable();
    map->view = map->viewFor(present);
    const double across = reachAcross * map->view;
    const double up = reachUp * map->view;
    map->field =
        map->study.map(-across, across, -up, up, 2 * obstacleColumns - 1, 2 * obstacleRows - 1);
    findObstacles(*map, progress);
    if (!progress(0.8)) {
        return nullptr;
    }
    // Against a torque without a range no place is better than another.
    if (map->best.reason.empty() && map->buildable.range) {
        map->front = map->study.front(map->buildable);
        map->smallRange = map->study.smallest_buildable(*map->buildable.range, true);
        map->smallRms = map->study.smallest_buildable(*map->buildable.rms, false);
    }
    return map;
}

}  // namespace

double ShaftMap::viewFor(double centreDistance) const {
    double farthest = centreDistance;
    for (const auto* places : {&best, &buildable}) {
        for (const auto& each : {places->range, places->rms}) {
            farthest = std::max(farthest, each ? each->position.centre_distance() : 0.0);
        }
    }
    if (!(farthest > 0.0)) {
        return 0.1;
    }
    const double step = niceStep(roomAround * farthest, 8);
    return step * std::ceil(roomAround * farthest / step - 1e-9);
}

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

namespace {

QString newtonMetres(double moment) {
    return shownNumber(moment, units::N_m, 1);
}

QString whereText(const ShaftMap::Position& position, int decimals = 2) {
    return ShaftMapModel::tr("l %1, α %2°")
        .arg(shownNumber(position.centre_distance(), units::mm, decimals),
             fixedNumber(position.shaft_angle() / degree, decimals, QLocale()));
}

}  // namespace

QString ShaftMapModel::answer() const {
    if (!trouble_.isEmpty()) {
        return trouble_;
    }
    if (map_ == nullptr) {
        return tr("Computing the map…");
    }
    const Marker* best = this->best();
    if (best == nullptr || !map_->best.reason.empty()) {
        return messageText(map_->best.reason);
    }
    const auto valueText = [this](const Criteria& criteria) {  // by the criterion
        return QStringLiteral("%1 (%2)").arg(
            newtonMetres(byRange() ? criteria.range : criteria.rms),
            signedPercentText(change(criteria).value_or(0.0)));
    };
    const auto doesNotFit = [&](const Marker& marker) {
        return QLatin1Char(' ') + tr("%1 at %2 does not fit.")
                                      .arg(valueText(marker.criteria), whereText(marker.position));
    };
    if (!best->isBuildable) {
        return messageText(map_->buildable.reason) + doesNotFit(*best);
    }
    QString text =
        tr("Best place, the smallest box with the %1 within 1 % of its minimum: %2 at %3, box %4.")
            .arg(byRange() ? tr("range") : tr("RMS"), valueText(best->criteria),
                 whereText(best->position), shownNumber(best->criteria.size, units::cm2, 0));
    if (balance_shaft::sign_as_shown(change(best->criteria).value_or(0.0)) > 0) {
        text += QLatin1Char(' ') + tr("Worse than without a shaft.");
    }
    const PositionStudy& study = map_->study;
    const auto tradeOff = [&](const Criteria& from) {
        return messageText(balance_shaft::trade_off(from, best->criteria));
    };
    text += QLatin1Char(' ') + tr("Compared with no shaft: %1.")
                                   .arg(tradeOff({study.range_without(), study.rms_without()}));
    text +=
        QLatin1Char(' ') + (isAtBest() ? tr("Already there, within 1 %.")
                                       : tr("From here: %1.").arg(tradeOff(study.at(present()))));
    for (const Marker& other : markers_) {
        if (other.criterion == criterion() && !other.isBuildable) {
            text += doesNotFit(other);
        }
    }
    return text;
}

QString ShaftMapModel::placeText(const Position& position, int decimals) const {
    QString text = placeLines(position, decimals).join(QStringLiteral("; "));
    if (const QString why = reasonAt(position); !why.isEmpty()) {
        text += QStringLiteral(". ") + why;
    }
    return text;
}

QStringList ShaftMapModel::placeLines(const Position& position, int decimals) const {
    if (map_ == nullptr) {
        return {};
    }
    const PositionStudy& study = map_->study;
    const Criteria criteria = study.at(position);
    const auto withChange = [&](const QString& text, double with, double without) {
        const QString value = text.arg(newtonMetres(with));
        return without > 0.0
                   ? value + QStringLiteral(" (") +
                         signedPercentText(balance_shaft::relative_change(without, with)) +
                         QLatin1Char(')')
                   : value;
    };
    return {whereText(position, decimals),
            withChange(tr("range %1"), criteria.range, study.range_without()),
            withChange(tr("RMS %1"), criteria.rms, study.rms_without()),
            tr("box %1").arg(shownNumber(criteria.size, units::cm2, 0))};
}

QString ShaftMapModel::reasonAt(const Position& position) const {
    return map_ ? messageText(map_->study.obstacle_reason(position)) : QString();
}

QString ShaftMapModel::fieldCsv(const CsvFormat& format) const {
    if (map_ == nullptr) {
        return {};
    }
    const balance_shaft::PositionMap& field = map_->field;
    const ShownTitle range = shownTitle(tr("ΔMᵤₚₛ, N·m"));
    QString text = format.line({shownTitle(tr("x, mm")).text, shownTitle(tr("y, mm")).text,
                                range.text, shownTitle(tr("RMS, N·m")).text, tr("feasible")});
    const auto along = [](double from, double to, std::size_t i, std::size_t count) {
        return from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1);
    };
    constexpr std::size_t step = 2;
    for (std::size_t row = 0; row < field.rows; row += step) {
        for (std::size_t column = 0; column < field.columns; column += step) {
            const std::size_t element = row * field.columns + column;
            const Position at{along(field.left, field.right, column, field.columns),
                              along(field.bottom, field.top, row, field.rows)};
            text += format.line({format.number(at.x / shownAs(units::mm)),
                                 format.number(at.y / shownAs(units::mm)),
                                 format.number(range.factor * field.range[element]),
                                 format.number(range.factor * field.rms[element]),
                                 QString::number(isBuildable(at) ? 1 : 0)});
        }
    }
    return text;
}

}  // namespace ravnoves
