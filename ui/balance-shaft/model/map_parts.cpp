// Where the shaft goes: the plots of the map of its places, and of the band of speeds.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "balance-shaft/model/shaft_map_model.h"
#include "balance-shaft/model/speed_study_model.h"
#include "numerics/constants.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves::shaft_parts {

namespace {

/// Null: none is there.
const ShaftMap* mapOf(const BalanceShaftModel& model) {
    return model.shaftMap() != nullptr ? model.shaftMap()->map() : nullptr;
}

}  // namespace

Figure places(const BalanceShaftModel& model) {
    const ShaftMap* map = mapOf(model);
    const double view = map != nullptr ? map->view / units::mm : 100.0;
    Figure figure;
    figure.title = changeTitle(model.placeCriterion());
    figure.x = {.title = ShaftParts::tr("x, mm"), .min = -view, .max = view};
    figure.left = {.title = ShaftParts::tr("y, mm")};
    figure.leftRange = std::pair(-view, view);
    figure.equalScale = true;
    if (map == nullptr) {
        return figure;
    }
    for (const ShaftMapModel::Marker& marker : model.shaftMap()->markers()) {
        const bool byRange = marker.criterion == ShaftMapModel::Criterion::range;
        const std::string id = byRange ? "range" : "RMS";
        Figure::Curve& curve =
            figure.add(id + (marker.isBuildable ? "" : "-free"),
                       {.name = marker.name(),
                        .role = byRange ? Role::Range : Role::Rms,
                        .shape = marker.isBuildable ? plot::Shape::Points : plot::Shape::Rings},
                       {marker.position.x / units::mm}, {marker.position.y / units::mm});
        curve.text = [places = model.shaftMap(), at = marker.position](std::size_t) {
            return places->placeLines(at).join(QLatin1Char('\n'));
        };
    }
    return figure;
}

Figure front(const BalanceShaftModel& model) {
    Figure figure;
    figure.title = model.placeCriterion() == BalanceShaftModel::Criterion::range
                       ? ShaftParts::tr("Range and size")
                       : ShaftParts::tr("RMS and size");
    figure.x = {.title = ShaftParts::tr("width × height, cm²"), .min = 0.0, .max = 1.0};
    figure.left = {.title = ShaftParts::tr("change, %")};
    const ShaftMapModel* places = model.shaftMap();
    if (mapOf(model) == nullptr || !places->change({})) {
        return figure;
    }
    const auto change = [&](const ShaftMap::Criteria& of) {
        return *places->change(of) / units::percent;
    };
    Figure::Curve all;
    Figure::Curve efficient;
    std::vector<ShaftMap::Position> positions;
    double minimum = std::numeric_limits<double>::infinity();
    for (const balance_shaft::BestPosition& place : mapOf(model)->front) {
        positions.push_back(place.position);
        all.x.push_back(place.criteria.size / units::cm2);
        all.y.push_back(change(place.criteria));
        if (all.y.back() < minimum) {  // sizes ascend
            minimum = all.y.back();
            efficient.x.push_back(all.x.back());
            efficient.y.push_back(minimum);
        }
    }
    // The axis holds the present place too, whose point is hollow where it cannot be built.
    const balance_shaft::Result& result = model.result();
    const ShaftMap::Criteria now{result.M_ups.range, result.M_ups.rms,
                                 result.envelope.width() * result.envelope.height()};
    const double area = now.size / units::cm2;
    const auto ends = std::minmax_element(all.x.begin(), all.x.end());
    const double low = all.x.empty() ? area : *ends.first;
    const double high = all.x.empty() ? area : *ends.second;
    const double pad = std::max(0.04 * (high - low), 1e-3 * high);
    figure.x.min = std::min(low, area) - pad;
    figure.x.max = std::max(high, area) + pad;
    Figure::Curve& shown =
        figure.add("front",
                   {.name = ShaftParts::tr("Pareto-optimal"),
                    .role = Role::Neutral,
                    .shape = plot::Shape::Rings,
                    .toolTip = ShaftParts::tr("Pareto-optimal in range, RMS and size")},
                   std::move(all.x), std::move(all.y));
    shown.text = [places, positions = std::move(positions)](std::size_t point) {
        return places->placeLines(positions[point], 1).join(QLatin1Char('\n'));
    };
    figure.add("efficient",
               {.name = ShaftParts::tr("by this criterion"),
                .role = Role::Best,
                .shape = plot::Shape::Points,
                .toolTip = ShaftParts::tr("Pareto-optimal in this criterion and size")},
               std::move(efficient.x), std::move(efficient.y));
    figure.add("present",
               {.name = ShaftParts::tr("present place"),
                .role = Role::Present,
                .shape = result.is_buildable ? plot::Shape::Points : plot::Shape::Rings},
               {area}, {change(now)});
    return figure;
}

namespace {

/// Null: nothing is solved.
const SpeedStudyModel* solvedOf(const BalanceShaftModel& model) {
    const SpeedStudyModel* study = model.speedStudy();
    return study != nullptr && study->isSolved() ? study : nullptr;
}

/// The speeds that are seen, min⁻¹.
std::pair<double, double> speedsOf(const BalanceShaftModel& model) {
    if (const SpeedStudyModel* study = solvedOf(model)) {
        const QRectF& where = study->map().where;
        return {where.top(), where.bottom()};
    }
    const balance_shaft::SpeedBand band = SpeedStudyModel::bandOf(model.input());
    return {band.from / units::rpm, band.to / units::rpm};
}

struct Curve {
    std::vector<double> speed;  ///< min⁻¹
    std::vector<double> angle;  ///< °
};

/// Best α over speed: of the feasible ones, of all where none is. It is broken where the angle
/// passes 0, which is no jump.
Curve bestOverSpeed(const SpeedStudyModel& study, bool byRange) {
    Curve curve;
    for (const balance_shaft::SpeedStudy::Point& point : study.points()) {
        const double best = byRange ? point.buildable_range_angle.value_or(point.best_range_angle)
                                    : point.buildable_rms_angle.value_or(point.best_rms_angle);
        const double angle = best / degree;
        if (!curve.angle.empty() && std::abs(angle - curve.angle.back()) > 180.0) {
            curve.speed.push_back(point.angular_speed / units::rpm);
            curve.angle.push_back(std::numeric_limits<double>::quiet_NaN());
        }
        curve.speed.push_back(point.angular_speed / units::rpm);
        curve.angle.push_back(angle);
    }
    return curve;
}

bool isByRange(const BalanceShaftModel& model) {
    return model.speedCriterion() == BalanceShaftModel::Criterion::range;
}

}  // namespace

Figure bestAngles(const BalanceShaftModel& model) {
    const auto [lowest, highest] = speedsOf(model);
    Figure figure;
    figure.title = ShaftParts::tr("Best α over speed");
    figure.x = {.title = ShaftParts::tr("n, min⁻¹"), .min = lowest, .max = highest};
    figure.left = {.title = ShaftParts::tr("α, °")};
    figure.leftRange = std::pair(0.0, 360.0);
    const SpeedStudyModel* study = solvedOf(model);
    if (study == nullptr) {
        return figure;
    }
    const auto add = [&](const char* id, const QString& name, Role role, const QString& tip) {
        Curve curve = bestOverSpeed(*study, role == Role::Range);
        figure.add(id, {.name = name, .role = role, .width = 1.8, .toolTip = tip, .gaps = true},
                   std::move(curve.speed), std::move(curve.angle));
    };
    add("range", ShaftParts::tr("range"), Role::Range,
        ShaftParts::tr("α of the minimum range at each speed"));
    add("RMS", ShaftParts::tr("RMS"), Role::Rms,
        ShaftParts::tr("α of the minimum RMS at each speed"));
    const double best = study->bestCompromiseDeg();
    figure.lines = {
        {.at = best,
         .role = Role::Best,
         .text = ShaftParts::tr("best compromise %1°").arg(fixedNumber(best, 1, QLocale()))}};
    figure.bands = unbuildableBands(study->buildable(), Qt::Vertical);
    return figure;
}

Figure speedMap(const BalanceShaftModel& model) {
    Figure figure;
    figure.title = ShaftParts::tr("Map over α and speed");
    figure.x = {.title = ShaftParts::tr("α, °"), .min = 0.0, .max = 360.0, .degrees = true};
    figure.left = {.title = ShaftParts::tr("n, min⁻¹")};
    figure.leftRange = speedsOf(model);
    figure.presentX = model.shaftAngleDeg();
    const SpeedStudyModel* study = solvedOf(model);
    if (study == nullptr) {
        return figure;
    }
    figure.title = changeTitle(model.speedCriterion());
    figure.bands = unbuildableBands(study->buildable());
    Curve line = bestOverSpeed(*study, isByRange(model));
    figure.add("best",
               {.name = ShaftParts::tr("best α"), .role = Role::Best, .width = 2.0, .gaps = true},
               std::move(line.angle), std::move(line.speed));
    return figure;
}

}  // namespace ravnoves::shaft_parts
