#include "balance-shaft/model/shaft_map_model.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "balance-shaft/fields.h"
#include "model/background_job.h"
#include "numerics/constants.h"
#include "numerics/units.h"
#include "plot/model/contour_lines.h"
#include "plot/model/ticks.h"
#include "text/csv_format.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/result_row.h"
#include "text/shown_units.h"

namespace ravnoves {

using balance_shaft::BestPosition;
using balance_shaft::Input;
using balance_shaft::Obstacle;
using balance_shaft::PositionStudy;
using balance_shaft::SpeedStudy;

namespace {

// The field reaches further than the square shown first: the picture may be wider or higher. Its
// steps are equal; of its points every second is looked at for obstacles.
constexpr double reachAcross = 2.6;
constexpr double reachUp = 1.6;
constexpr std::size_t obstacleColumns = 196;
constexpr std::size_t obstacleRows = 121;
constexpr std::size_t distances = 120;
constexpr double roomAround = 1.25;

QString mm(double metres, int decimals = 1) {
    return shownNumber(metres, units::mm, decimals);
}

QString newtonMetres(double moment) {
    return shownNumber(moment, units::N_m, 1);
}

QString degrees(double radians, int decimals = 1) {
    return fixedNumber(radians / degree, decimals, QLocale());
}

/// The input without the shaft's place, which the map does not depend on.
Input withoutPlace(Input input) {
    input.centre_distance = 0.0;
    input.shaft_angle = 0.0;
    return input;
}

void findObstacles(ShaftMap& map, const std::function<bool(double)>& progress) {
    const balance_shaft::PositionMap& field = map.field;
    map.obstacleColumns = obstacleColumns;
    map.obstacles.reserve(obstacleColumns * obstacleRows);
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
            const Obstacle found =
                map.study.obstacle(place(static_cast<double>(column), static_cast<double>(row)));
            map.obstacles.push_back(found);
            blocked.push_back(found == Obstacle::none ? 0.0 : 1.0);
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

/// @param goesOn  false stops it
ShaftMap::Distances bestOfDistances(const PositionStudy& study, double reach,
                                    const std::function<bool()>& goesOn) {
    ShaftMap::Distances found;
    for (std::size_t i = 1; i <= distances && goesOn(); ++i) {
        const double distance = reach * static_cast<double>(i) / distances;
        found.distance.push_back(distance);
        found.range.push_back(study.best_range_at(distance));
        found.rms.push_back(study.best_rms_at(distance));
        found.rangeBuilt.push_back(study.best_buildable_at(distance, 1.0));
        found.rmsBuilt.push_back(study.best_buildable_at(distance, 0.0));
    }
    return found;
}

/// Half of the square to show: it holds what is best and the present place, with room around.
double viewOf(const ShaftMap& map, double present) {
    double farthest = present;
    for (const auto* best : {&map.best, &map.buildable}) {
        for (const auto& each : {best->range, best->rms}) {
            farthest = std::max(farthest, each ? each->position.centre_distance() : 0.0);
        }
    }
    if (!(farthest > 0.0)) {
        return 0.1;
    }
    const double step = niceStep(roomAround * farthest, 8);
    return step * std::ceil(roomAround * farthest / step - 1e-9);
}

}  // namespace

ShaftMapModel::ShaftMapModel(BalanceShaftModel* model, QObject* parent)
    : QObject(parent),
      model_(model),
      job_(new BackgroundJob(this)),
      bandJob_(new BackgroundJob(this)) {
    job_->setPatience(500, 30);
    connect(model_, &SceneModel::changed, this, [this] { follow(); });
    connect(model_, &SceneModel::broughtIn, this, [this] { follow(true); });
    connect(model_, &BalanceShaftModel::shaftMoved, this, &ShaftMapModel::moved);
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

void ShaftMapModel::setWatched(bool watched) {
    watched_ = watched;
    follow();
}

void ShaftMapModel::setHeld(bool held) {
    held_ = held;
    follow(true);
}

void ShaftMapModel::follow(bool mayShrink) {
    if (!watched_) {
        return;
    }
    const Input& input = model_->input();
    const bool same = mapped_ && *mapped_ == withoutPlace(input);
    const auto fits = [&] {
        constexpr double tooWide = 1.5;
        return input.centre_distance <= map_->view &&
               (!mayShrink || map_->view <= tooWide * viewOf(*map_, input.centre_distance));
    };
    if (!same || (map_ && !held_ && !job_->isRunning() && !fits())) {
        mapped_ = withoutPlace(input);
        start();
    }
}

void ShaftMapModel::start() {
    bandJob_->cancel();
    job_->start([this, solver = model_->solver(), present = model_->input().centre_distance](
                    const BackgroundJob::Progress& progress) -> std::function<void()> {
        auto map = std::make_shared<ShaftMap>(ShaftMap{.study = PositionStudy(solver)});
        map->best = map->study.best();
        map->buildable = map->study.best_buildable();
        map->view = viewOf(*map, present);
        const double across = reachAcross * map->view;
        const double up = reachUp * map->view;
        map->field =
            map->study.map(-across, across, -up, up, 2 * obstacleColumns - 1, 2 * obstacleRows - 1);
        findObstacles(*map, progress);
        if (!progress(0.6)) {
            return {};
        }
        // Against a torque without a range no place is better than another.
        if (map->study.range_without() > 0.0) {
            map->distances = bestOfDistances(map->study, map->view, [&] { return progress(0.6); });
            if (!progress(0.8)) {
                return {};
            }
            map->front = map->study.front(map->buildable);
        }
        return [this, map] {
            map_ = map;
            bandRange_.reset();
            bandRms_.reset();
            trouble_.clear();
            showMap();
            startBand();
        };
    });
}

void ShaftMapModel::startBand() {
    if (!model_->input().speed_band) {
        return;
    }
    bandJob_->start([this, input = model_->input()](
                        const BackgroundJob::Progress& progress) -> std::function<void()> {
        const SpeedStudy study(input, *input.speed_band, progress);
        if (!study.reason().empty() || !study.is_complete()) {
            return {};
        }
        const auto leastBad = [&](SpeedStudy::Criterion criterion) -> std::optional<BandPlace> {
            constexpr auto relative = SpeedStudy::Measure::relative;
            if (const auto built = study.least_bad_place_buildable(criterion, relative)) {
                return BandPlace{*built, true};
            }
            const auto any = study.least_bad_place(criterion, relative);
            return any ? std::optional(BandPlace{*any, false}) : std::nullopt;
        };
        return [this, range = leastBad(SpeedStudy::Criterion::range),
                rms = leastBad(SpeedStudy::Criterion::rms)] {
            bandRange_ = range;
            bandRms_ = rms;
            showCriterion();
        };
    });
}

void ShaftMapModel::addBandMarker() {
    const auto& band = criterion_ == Criterion::Range ? bandRange_ : bandRms_;
    if (!band || criterion_ == Criterion::Both) {
        return;
    }
    const Position position{band->place.x, band->place.y};
    const Position place = shortened(position, criterion_);
    markers_.push_back({criterion_, band->isBuildable, place, map_->study.at(place),
                        tr("least bad over the speeds"), band->place.value - 1.0});
}

void ShaftMapModel::showMap() {
    markers_.clear();
    if (map_) {
        addMarker(Criterion::Range, true, map_->buildable.range);
        addMarker(Criterion::Range, false, map_->best.range);
        addMarker(Criterion::Rms, true, map_->buildable.rms);
        addMarker(Criterion::Rms, false, map_->best.rms);
    }
    showCriterion();
}

void ShaftMapModel::addMarker(Criterion criterion, bool isBuildable,
                              const std::optional<BestPosition>& best) {
    // What is best of all is named once where it can be built.
    if (!best || (!isBuildable && this->isBuildable(best->position))) {
        return;
    }
    QString name;
    switch (criterion) {
        case Criterion::Range:
            name = isBuildable ? tr("least range") : tr("least range, cannot be built");
            break;
        case Criterion::Rms:
            name = isBuildable ? tr("least RMS") : tr("least RMS, cannot be built");
            break;
        case Criterion::Both:
            name = isBuildable ? tr("least sum") : tr("least sum, cannot be built");
            break;
    }
    // What is best lies on the edge of what can be built: with a few digits it would be beyond.
    const Position place = shortened(best->position, criterion);
    markers_.push_back({criterion, isBuildable, place, map_->study.at(place), name});
}

double ShaftMapModel::valueOf(const Criteria& criteria, Criterion by) const {
    return by == Criterion::Range ? criteria.range
           : by == Criterion::Rms ? criteria.rms
                                  : weighted(criteria.range, criteria.rms);
}

ShaftMapModel::Position ShaftMapModel::shortened(const Position& exact, Criterion by,
                                                 bool keepsDistance) const {
    constexpr double parts = 100.0;  // of a millimetre and of a degree
    constexpr int around = 3;
    const double length = parts * exact.centre_distance() / units::mm;
    const double l = keepsDistance ? std::round(length) : std::floor(length);
    const double alpha = std::floor(parts * exact.shaft_angle() / degree);
    const bool canBeBuilt = isBuildable(exact);
    Position best = exact;
    double least = std::numeric_limits<double>::infinity();
    for (int i = keepsDistance ? 0 : 1 - around; i <= (keepsDistance ? 0 : around); ++i) {
        for (int k = 1 - around; k <= around; ++k) {
            const Position at = Position::at(std::max(l + i, 0.0) / parts * units::mm,
                                             (alpha + k) / parts * degree);
            if (isBuildable(at) != canBeBuilt) {
                continue;
            }
            if (const double value = valueOf(map_->study.at(at), by); value < least) {
                least = value;
                best = at;
            }
        }
    }
    return best;
}

bool ShaftMapModel::isAtBest() const {
    const Marker* marker = best();
    const Position at = present();
    constexpr double same = 1e-9;  // m
    return marker != nullptr &&
           std::hypot(marker->position.x - at.x, marker->position.y - at.y) < same;
}

double ShaftMapModel::rangeShare() const {
    return criterion_ == Criterion::Range ? 1.0 : criterion_ == Criterion::Rms ? 0.0 : weight_;
}

/// Of the sum in N·m, whose parts are not relative to the engine without a shaft.
double ShaftMapModel::rangeWeight() const {
    const double share = rangeShare();
    const double range = share * map_->study.rms_without();
    const double rms = (1.0 - share) * map_->study.range_without();
    return range + rms > 0.0 ? range / (range + rms) : share;
}

double ShaftMapModel::weighted(double range, double rms) const {
    const double share = rangeShare();
    const PositionStudy& study = map_->study;
    double sum = 0.0;
    if (share > 0.0) {
        sum += share * range / study.range_without();
    }
    if (share < 1.0) {
        sum += (1.0 - share) * rms / study.rms_without();
    }
    return sum - 1.0;
}

std::optional<double> ShaftMapModel::change(const Criteria& criteria) const {
    if (!map_ || !(map_->study.range_without() > 0.0) || !(map_->study.rms_without() > 0.0)) {
        return std::nullopt;
    }
    return weighted(criteria.range, criteria.rms);
}

void ShaftMapModel::setCriterion(Criterion criterion) {
    if (criterion != criterion_) {
        criterion_ = criterion;
        showCriterion();
    }
}

void ShaftMapModel::setWeight(double weight) {
    weight = std::clamp(weight, 0.0, 1.0);
    if (weight != weight_) {
        weight_ = weight;
        showCriterion();
    }
}

QString ShaftMapModel::criterionName() const {
    return criterion_ == Criterion::Range ? tr("range")
           : criterion_ == Criterion::Rms ? tr("RMS")
                                          : tr("weighted sum");
}

void ShaftMapModel::showCriterion() {
    std::erase_if(markers_, [](const Marker& each) {
        return each.criterion == Criterion::Both || each.worst.has_value();
    });
    changes_.clear();
    levels_.clear();
    contours_.clear();
    if (change({})) {
        if (criterion_ == Criterion::Both) {
            addMarker(Criterion::Both, true, map_->study.best_sum_buildable(rangeWeight()));
            addMarker(Criterion::Both, false, map_->study.best_sum(rangeWeight()));
        }
        addBandMarker();
        const balance_shaft::PositionMap& field = map_->field;
        changes_.resize(field.range.size());
        for (std::size_t i = 0; i < changes_.size(); ++i) {
            changes_[i] = weighted(field.range[i], field.rms[i]);
        }
        levels_ = chooseLevels();
        const QPointF corner(field.left, field.bottom);
        const double stepX = (field.right - field.left) / static_cast<double>(field.columns - 1);
        const double stepY = (field.top - field.bottom) / static_cast<double>(field.rows - 1);
        for (const double level : levels_) {
            Contour contour{level, contourLines({changes_, field.columns, field.rows}, level)};
            for (QPolygonF& line : contour.lines) {
                for (QPointF& point : line) {
                    point = corner + QPointF(point.x() * stepX, point.y() * stepY);
                }
            }
            contours_.push_back(std::move(contour));
        }
    }
    Q_EMIT mapChanged();
}

/// Equal steps where the shaft helps; where it harms 1, 2, 5, 10 … times as much, for there the
/// field has no end.
std::vector<double> ShaftMapModel::chooseLevels() const {
    const auto [least, most] = std::minmax_element(changes_.begin(), changes_.end());
    std::vector<double> found{0.0};
    constexpr double smallest = 1e-4;  // less is nothing
    double step = 0.0;
    if (*least < -smallest) {
        step = niceStep(-*least, 5);
        for (int i = 1; - step * i > *least; ++i) {
            found.insert(found.begin(), -step * i);
        }
    }
    constexpr int mostSteps = 6;
    std::vector<double> above;
    const double first = std::max(step, 1e-3 * *most);
    double power = std::pow(10.0, std::floor(std::log10(std::max(first, smallest))));
    while (power < *most) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (factor * power >= 0.999 * first && factor * power < *most) {
                above.push_back(factor * power);
            }
        }
        power *= 10.0;
    }
    const auto kept = std::min<std::ptrdiff_t>(mostSteps, std::ssize(above));
    found.insert(found.end(), above.end() - kept, above.end());
    return found;
}

const ShaftMapModel::Marker* ShaftMapModel::best() const {
    const Marker* found = nullptr;
    for (const Marker& marker : markers_) {
        if (marker.criterion == criterion_ && !marker.worst &&
            (found == nullptr || marker.isBuildable)) {
            found = &marker;
        }
    }
    return found;
}

namespace {

QString whereText(const ShaftMapModel::Position& position) {
    return ShaftMapModel::tr("l %1, α %2°")
        .arg(mm(position.centre_distance(), 2), degrees(position.shaft_angle(), 2));
}

/// "+1.2 N·m (+3.0 %)".
QString differenceText(double present, double reference, const Unit& unit, int decimals) {
    const auto found =
        shownCell(present, unit, decimals).from(shownCell(reference, unit, decimals));
    return !found ? shownNumber(present, unit, decimals)
                  : QStringLiteral("%1 (%2)").arg(withUnit(found->absolute, shownUnit(unit).name),
                                                  found->percent);
}

}  // namespace

QString ShaftMapModel::valueText(const Criteria& criteria) const {
    const QString change = signedPercentText(this->change(criteria).value_or(0.0));
    return criterion_ == Criterion::Both
               ? change
               : QStringLiteral("%1 (%2)").arg(
                     newtonMetres(criterion_ == Criterion::Range ? criteria.range : criteria.rms),
                     change);
}

QString ShaftMapModel::againstText(const ShaftMapModel& other, const QString& name,
                                   const Position& position) const {
    if (!map_ || !other.map_) {
        return {};
    }
    const Criteria now = map_->study.at(position);
    const Criteria was = other.map_->study.at(position);
    return tr("Against %1 here: range %2; RMS %3; box %4")
        .arg(name, differenceText(now.range, was.range, units::N_m, 1),
             differenceText(now.rms, was.rms, units::N_m, 1),
             differenceText(now.size, was.size, units::cm2, 0));
}

QString ShaftMapModel::bestAgainstText(const ShaftMapModel& other, const QString& name) const {
    const Marker* best = this->best();
    const Marker* was = other.best();
    if (!map_ || !other.map_ || best == nullptr || was == nullptr ||
        other.criterion_ != criterion_) {
        return {};
    }
    const QString text = tr("Best place of %1: %2 at %3")
                             .arg(name, other.valueText(was->criteria), whereText(was->position));
    if (criterion_ == Criterion::Both) {
        return text + QLatin1Char('.');
    }
    const bool byRange = criterion_ == Criterion::Range;
    const auto value = [&](const Criteria& criteria) {
        return byRange ? criteria.range : criteria.rms;
    };
    return text +
           tr("; against it %1.")
               .arg(differenceText(value(best->criteria), value(was->criteria), units::N_m, 1));
}

QString ShaftMapModel::bestText() const {
    if (!trouble_.isEmpty()) {
        return trouble_;
    }
    if (!map_) {
        return tr("The map is being computed …");
    }
    const Marker* best = this->best();
    if (best == nullptr || !map_->best.reason.empty()) {
        return messageText(map_->best.reason);
    }
    const auto value = [this](const Criteria& criteria) { return valueText(criteria); };
    QString text = tr("Best place by the %1: %2 at %3.")
                       .arg(criterionName(), value(best->criteria), whereText(best->position));
    constexpr double shown = 5e-4;  // less is 0.0 %
    if (change(best->criteria).value_or(0.0) >= shown) {
        text += QLatin1Char(' ') + tr("It is worse than without a shaft.");
    }
    if (!best->isBuildable) {
        text += QLatin1Char(' ') + (map_->buildable.reason.empty()
                                        ? reason(best->position)
                                        : messageText(map_->buildable.reason));
        return text;
    }
    for (const Marker& other : markers_) {
        if (other.criterion == criterion_ && !other.isBuildable && !other.worst) {
            text += QLatin1Char(' ') + tr("%1 at %2 – cannot be built.")
                                           .arg(value(other.criteria), whereText(other.position));
        }
    }
    return text;
}

QString ShaftMapModel::reason(const Position& position) const {
    return map_ ? messageText(map_->study.obstacle_reason(position)) : QString();
}

QStringList ShaftMapModel::placeLines(const Position& position, int decimals) const {
    if (!map_) {
        return {};
    }
    const PositionStudy& study = map_->study;
    const Criteria criteria = study.at(position);
    const auto withChange = [&](const QString& text, double with, double without) {
        const QString value = text.arg(newtonMetres(with));
        return without > 0.0 ? value + QStringLiteral(" (") +
                                   signedPercentText(with / without - 1.0) + QLatin1Char(')')
                             : value;
    };
    return {tr("l %1, α %2°")
                .arg(mm(position.centre_distance(), decimals),
                     degrees(position.shaft_angle(), decimals)),
            withChange(tr("range %1"), criteria.range, study.range_without()),
            withChange(tr("RMS %1"), criteria.rms, study.rms_without()),
            tr("box %1").arg(shownNumber(criteria.size, units::cm2, 0))};
}

QString ShaftMapModel::placeText(const Position& position, int decimals) const {
    QString text = placeLines(position, decimals).join(QStringLiteral("; "));
    if (const QString why = reason(position); !why.isEmpty()) {
        text += QStringLiteral(". ") + why;
    }
    return text;
}

QString ShaftMapModel::markerText(const Marker& marker) const {
    return marker.worst ? tr("Least bad over the band of speeds: %1 at the worst one. Here: %2")
                              .arg(signedPercentText(*marker.worst), placeText(marker.position))
                        : placeText(marker.position);
}

ShaftMapModel::Position ShaftMapModel::present() const {
    return Position::at(model_->input().centre_distance, model_->input().shaft_angle);
}

bool ShaftMapModel::isBuildable(const Position& position) const {
    return map_ && map_->study.obstacle(position) == Obstacle::none;
}

void ShaftMapModel::placeShaft(double centreDistance, double shaftAngle) {
    model_->drag(tr("Move shaft"), [&](Input& input) {
        input.centre_distance = centreDistance;
        if (centreDistance > 0.0) {
            input.shaft_angle = shaftAngle;
        }
    });
}

namespace {

/// To whole parts of a unit, as the number that its decimals stand for.
double inParts(double value, double unit, double parts) {
    return std::round(value / unit * parts) / parts * unit;
}

double angleInParts(double radians, double parts) {
    return std::fmod(inParts(radians, degree, parts), two_pi);
}

}  // namespace

void ShaftMapModel::moveTo(const Position& position) {
    constexpr double parts = 1e11;  // what is a short number leaves x and y as one
    placeShaft(inParts(position.centre_distance(), units::mm.to_si, parts),
               angleInParts(position.shaft_angle(), parts));
}

void ShaftMapModel::dragTo(const Position& position) {
    constexpr double parts = 1e4;
    placeShaft(inParts(position.centre_distance(), units::mm.to_si, parts),
               angleInParts(position.shaft_angle(), parts));
}

void ShaftMapModel::goTo(const Position& position) {
    model_->finishDrag();
    moveTo(position);
    model_->finishDrag();
}

void ShaftMapModel::goToBest() {
    if (const Marker* marker = best()) {
        goTo(marker->position);
    }
}

void ShaftMapModel::setDistance(double metres) {
    model_->drag(fieldName(balance_shaft::field::centre_distance),
                 [&](Input& input) { input.centre_distance = metres; });
}

void ShaftMapModel::goToDistance(double metres) {
    constexpr double parts = 100.0;  // of a millimetre and of a degree
    metres = inParts(metres, units::mm.to_si, parts);
    if (!map_ || !(metres > 0.0)) {
        return;
    }
    const auto built = map_->study.best_buildable_at(metres, rangeWeight());
    const Position best = (built ? *built : map_->study.best_at(metres, rangeWeight())).position;
    moveTo(shortened(best, criterion_, true));
}

double ShaftMapModel::largestDistance() const {
    const double present = model_->input().centre_distance;
    return std::max(map_ ? map_->view : 0.0, present * (map_ ? 1.0 : 2.0));
}

QString ShaftMapModel::fieldCsv(const CsvFormat& csv) const {
    if (!map_ || map_->obstacles.empty()) {
        return {};
    }
    const balance_shaft::PositionMap& field = map_->field;
    const ShownTitle range = shownTitle(tr("ΔMᵤₚₛ, N·m"));
    QString text =
        QStringList{csv.field(shownTitle(tr("x, mm")).text),
                    csv.field(shownTitle(tr("y, mm")).text), csv.field(range.text),
                    csv.field(shownTitle(tr("RMS, N·m")).text), csv.field(tr("can be built"))}
            .join(csv.separator) +
        QLatin1Char('\n');
    const std::size_t columns = map_->obstacleColumns;
    const std::size_t rows = map_->obstacles.size() / columns;
    const std::size_t stride = (field.columns - 1) / (columns - 1);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t element = stride * (row * field.columns + column);
            const auto along = [](double from, double to, std::size_t i, std::size_t count) {
                return (from +
                        (to - from) * static_cast<double>(i) / static_cast<double>(count - 1)) /
                       shownAs(units::mm);
            };
            const bool built = map_->obstacles[row * columns + column] == Obstacle::none;
            text += QStringList{csv.number(along(field.left, field.right, column, columns)),
                                csv.number(along(field.bottom, field.top, row, rows)),
                                csv.number(range.factor * field.range[element]),
                                csv.number(range.factor * field.rms[element]),
                                QString::number(built ? 1 : 0)}
                        .join(csv.separator) +
                    QLatin1Char('\n');
        }
    }
    return text;
}

}  // namespace ravnoves
