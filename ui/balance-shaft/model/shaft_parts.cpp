// What the page of the balance shaft shows.

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "balance-shaft/crank_balance.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/model/shaft_map_model.h"
#include "balance-shaft/model/speed_study_model.h"
#include "balance-shaft/result_fields.h"
#include "numerics/constants.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

using balance_shaft::CrankBalance;
using balance_shaft::ForceLocus;
using balance_shaft::GearError;
using balance_shaft::MomentMetrics;
using balance_shaft::Result;
using Criterion = BalanceShaftModel::Criterion;

namespace {

using Model = BalanceShaftModel;

/// The words of the parts.
struct ShaftParts {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ShaftParts)
};

/// Shades the infeasible angles of the shaft, 0 to 360°.
/// @param orientation  Qt::Horizontal where α runs along x
std::vector<plot::Band> unbuildableBands(const balance_shaft::BuildableAngles& buildable,
                                         Qt::Orientation orientation = Qt::Horizontal) {
    const QString text = BalanceShaftModel::tr("does not fit");
    std::vector<plot::Band> bands;
    for (const balance_shaft::AngleStretch& gap : buildable.gaps()) {
        bands.push_back(
            {gap.from / degree, gap.to / degree, Role::Forbidden, 0.13, text, orientation});
    }
    return bands;
}

/// Of a figure whose curves follow the crank.
Figure overCycle(const Model& model, const QString& title, const QString& unit) {
    return {.title = title,
            .x = {.title = ShaftParts::tr("φ, °"),
                  .min = 0.0,
                  .max = model.cycleDeg(),
                  .degrees = true},
            .left = {.title = unit}};
}

/// A figure over α, with the infeasible angles and the shaft's.
Figure overAngle(const Model& model, const QString& title, const QString& unit) {
    return {
        .title = title,
        .x = {.title = ShaftParts::tr("α, °"), .min = 0.0, .max = 360.0, .degrees = true},
        .left = {.title = unit},
        .bands = unbuildableBands(model.result().buildable),
        .presentX = model.shaftAngleDeg(),
    };
}

std::vector<double> inUnit(std::vector<double> values, const Unit& unit) {
    for (double& value : values) {
        value /= unit.to_si;
    }
    return values;
}

/// Of a map of changes, in percent.
QString changeTitle(const Model& model) {
    return model.byRange() ? ShaftParts::tr("Change in range vs. no shaft, %")
                           : ShaftParts::tr("Change in RMS vs. no shaft, %");
}

// The moments on the engine over φ and over α, how large they are over α, and what that costs.

Figure moments(const Model& model) {
    const Result& result = model.result();
    Figure figure =
        overCycle(model, ShaftParts::tr("Moments over the cycle"), ShaftParts::tr("N·m"));
    // Room for every α, so that the axis rests while the shaft moves.
    figure.leftRange = std::pair(result.M_up.min - result.moment_amplitude,
                                 result.M_up.max + result.moment_amplitude);
    const auto add = [&](const char* id, const QString& name, Role role, double width,
                         const QString& tip, const std::vector<double>& moment) {
        figure.add(id, {.name = name, .role = role, .width = width, .toolTip = tip},
                   result.curves.crank_angle_deg, moment);
    };
    add("M_up", ShaftParts::tr("without shaft (Mᵤₚ)"), Role::Engine, 1.4,
        ShaftParts::tr("Tipping moment: the reaction to the engine torque"), result.curves.M_up);
    add("M_s", ShaftParts::tr("shaft (Mₛ)"), Role::Shaft, 1.4,
        ShaftParts::tr("Moment of the balance shaft, P₁ l sin(α + φ), (4)"), result.curves.M_s);
    add("M_ups", ShaftParts::tr("with shaft (Mᵤₚₛ)"), Role::Sum, 2.0,
        ShaftParts::tr("Moment on the mounts, Mᵤₚ + Mₛ, (5)"), result.curves.M_ups);
    auto& marks = figure.marks.emplace();
    const auto mark = [&](const char* curve, const MomentMetrics& metrics, Role role) {
        for (const auto& [angle, moment] : {std::pair(metrics.max_angle, metrics.max),
                                            std::pair(metrics.min_angle, metrics.min)}) {
            marks.push_back({.x = angle / degree,
                             .y = moment,
                             .text = shownDigits(moment, units::N_m, 0),
                             .role = role,
                             .curve = curve});
        }
    };
    mark("M_ups", result.M_ups, Role::Sum);
    mark("M_up", result.M_up, Role::Engine);
    mark("M_s", result.M_s, Role::Shaft);
    return figure;
}

Figure range(const Model& model) {
    const balance_shaft::AngleSweep& sweep = model.result().sweep;
    const std::vector<double>& alpha = sweep.shaft_angle_deg;
    Figure figure = overAngle(model, ShaftParts::tr("Range and RMS over α"), ShaftParts::tr("N·m"));
    figure.add("range",
               {.name = ShaftParts::tr("range (ΔMᵤₚₛ)"),
                .role = Role::Range,
                .width = 1.8,
                .toolTip = ShaftParts::tr("Range of Mᵤₚₛ, max − min")},
               alpha, sweep.range);
    figure.add("RMS",
               {.name = ShaftParts::tr("RMS"),
                .role = Role::Rms,
                .toolTip = ShaftParts::tr("RMS of Mᵤₚₛ about its mean")},
               alpha, sweep.rms);
    auto& marks = figure.marks.emplace();
    const auto add = [&](const balance_shaft::Optimum& best, Role role) {
        if (best.shaft_angle) {
            const double at = *best.shaft_angle / degree;
            marks.push_back({.x = at,
                             .y = best.value,
                             .text = fixedNumber(at, 2, QLocale()) + QStringLiteral("°"),
                             .role = role,
                             .ring = true});
        }
    };
    add(model.best(Criterion::range), Role::Range);
    add(model.best(Criterion::rms), Role::Rms);
    return figure;
}

/// Over a whole turn: the first comes again at its end.
std::vector<double> closedTurn(const std::vector<double>& values, const Unit& unit) {
    std::vector<double> closed = inUnit(values, unit);
    closed.push_back(closed.front());
    return closed;
}

Figure sizes(const Model& model) {
    const balance_shaft::EnvelopeStudy& study = model.envelopeStudy();
    std::vector<double> angle = study.shaft_angle_deg;
    angle.push_back(360.0);
    Figure figure = overAngle(model, ShaftParts::tr("Overall size over α"), ShaftParts::tr("mm"));
    figure.add("width", {.name = ShaftParts::tr("width"), .role = Role::Horizontal, .width = 1.8},
               angle, closedTurn(study.width, units::mm));
    figure.add("height", {.name = ShaftParts::tr("height"), .role = Role::Vertical, .width = 1.8},
               angle, closedTurn(study.height, units::mm));
    return figure;
}

Figure rangeOverSize(const Model& model) {
    const balance_shaft::EnvelopeStudy& study = model.envelopeStudy();
    const std::vector<double> area = closedTurn(study.area, units::cm2);
    const auto [minimum, maximum] = std::minmax_element(area.begin(), area.end());
    const double pad = std::max(0.04 * (*maximum - *minimum), 1e-6);
    Figure figure;
    figure.title = ShaftParts::tr("Range and overall size, α along the curve");
    figure.x = {.title = ShaftParts::tr("width × height, cm²"),
                .min = *minimum - pad,
                .max = *maximum + pad};
    figure.left = {.title = ShaftParts::tr("ΔMᵤₚₛ, N·m")};

    std::vector<double> built = study.range;
    Figure::Curve efficient;
    auto& marks = figure.marks.emplace();
    double marked = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < built.size(); ++i) {
        if (!study.buildable[i]) {
            built[i] = std::numeric_limits<double>::quiet_NaN();
        }
        if (!study.efficient[i]) {
            continue;
        }
        efficient.x.push_back(area[i]);
        efficient.y.push_back(study.range[i]);
        constexpr double apart = 15.0;  // degrees
        if (const double angle = study.shaft_angle_deg[i]; angle - marked >= apart) {
            marked = angle;
            // A ring: the present α is seen in it.
            marks.push_back({.x = area[i],
                             .y = study.range[i],
                             .text = fixedNumber(angle, 0, QLocale()) + QStringLiteral("°"),
                             .role = Role::Best,
                             .ring = true});
        }
    }
    figure.add("all", {.name = ShaftParts::tr("all α"), .role = Role::Limit, .width = 1.0}, area,
               closedTurn(study.range, units::none));
    figure.add("built",
               {.name = ShaftParts::tr("feasible"),
                .role = Role::Neutral,
                .width = 1.8,
                .toolTip = ShaftParts::tr("The shaft clears cylinder, crank and rod"),
                .gaps = true},
               area, closedTurn(built, units::none));
    figure.add("efficient",
               {.name = ShaftParts::tr("Pareto-optimal"),
                .role = Role::Best,
                .shape = plot::Shape::Points,
                .toolTip = ShaftParts::tr("Feasible and Pareto-optimal in size and range")},
               std::move(efficient.x), std::move(efficient.y));
    const balance_shaft::Envelope& box = model.result().envelope;
    figure.add(
        "present",
        {.name = ShaftParts::tr("present α"), .role = Role::Present, .shape = plot::Shape::Points},
        {box.width() * box.height() / units::cm2}, {model.result().M_ups.range});
    return figure;
}

// Where the shaft goes: the map of its places, and the band of speeds.

/// Null: none is there.
const ShaftMap* mapOf(const Model& model) {
    return model.shaftMap() != nullptr ? model.shaftMap()->map() : nullptr;
}

Figure places(const Model& model) {
    const ShaftMap* map = mapOf(model);
    const double view = map != nullptr ? map->view / units::mm : 100.0;
    Figure figure;
    figure.title = changeTitle(model);
    figure.x = {.title = ShaftParts::tr("x, mm"), .min = -view, .max = view};
    figure.left = {.title = ShaftParts::tr("y, mm")};
    figure.leftRange = std::pair(-view, view);
    figure.equalScale = true;
    if (map == nullptr) {
        return figure;
    }
    for (const ShaftMapModel::Marker& marker : model.shaftMap()->markers()) {
        const bool byRange = marker.criterion == Criterion::range;
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

Figure front(const Model& model) {
    Figure figure;
    figure.title =
        model.byRange() ? ShaftParts::tr("Range and size") : ShaftParts::tr("RMS and size");
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
    const Result& result = model.result();
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

/// Null: nothing is solved.
const SpeedStudyModel* solvedOf(const Model& model) {
    const SpeedStudyModel* study = model.speedStudy();
    return study != nullptr && study->isSolved() ? study : nullptr;
}

/// The speeds that are seen, min⁻¹.
std::pair<double, double> speedsOf(const Model& model) {
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

Figure bestAngles(const Model& model) {
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

Figure speedMap(const Model& model) {
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
    figure.title = changeTitle(model);
    figure.bands = unbuildableBands(study->buildable());
    Curve line = bestOverSpeed(*study, model.byRange());
    figure.add("best",
               {.name = ShaftParts::tr("best α"), .role = Role::Best, .width = 2.0, .gaps = true},
               std::move(line.angle), std::move(line.speed));
    return figure;
}

// Of what the torque is made, its orders, and what it does to the speed.

Figure torque(const Model& model) {
    const balance_shaft::MomentCurves& curves = model.result().curves;
    Figure figure =
        overCycle(model, ShaftParts::tr("Engine torque and its parts"), ShaftParts::tr("N·m"));
    if (curves.M_gas.empty()) {
        return figure;  // the torque is a table
    }
    const std::vector<double>& phi = curves.crank_angle_deg;
    figure.add("gas",
               {.name = ShaftParts::tr("gas"),
                .role = Role::Gas,
                .toolTip = ShaftParts::tr("−(p − p₀) A s′")},
               phi, curves.M_gas);
    figure.add("inertia",
               {.name = ShaftParts::tr("inertia"),
                .role = Role::Reciprocating,
                .toolTip = ShaftParts::tr("−mⱼ ω² s′ s″")},
               phi, curves.M_inertia);
    if (model.input().cylinder.offset != 0.0) {
        figure.add(
            "offset",
            {.name = ShaftParts::tr("offset"),
             .role = Role::Offset,
             .toolTip = ShaftParts::tr("e mⱼ ω² s″: part of Mᵤₚ due to the offset cylinder")},
            phi, curves.M_offset);
    }
    std::vector<double> total(curves.M_up.size());
    std::transform(curves.M_offset.begin(), curves.M_offset.end(), curves.M_up.begin(),
                   total.begin(), std::minus<>());
    figure.add("total",
               {.name = ShaftParts::tr("engine torque"),
                .role = Role::Engine,
                .width = 2.0,
                .toolTip = ShaftParts::tr("Gas plus inertia")},
               phi, std::move(total));
    return figure;
}

auto pressureStyle() {
    return plot::CurveStyle{
        .name = ShaftParts::tr("p"), .role = Role::Gas, .width = 1.8, .inLegend = false};
}

Figure pressure(const Model& model) {
    const balance_shaft::MomentCurves& curves = model.result().curves;
    Figure figure = overCycle(model, ShaftParts::tr("Cylinder pressure"), ShaftParts::tr("bar"));
    if (!curves.pressure.empty()) {
        figure.add("pressure", pressureStyle(), curves.crank_angle_deg,
                   inUnit(curves.pressure, units::bar));
    }
    return figure;
}

Figure indicator(const Model& model) {
    const Result& result = model.result();
    Figure figure;
    figure.title = ShaftParts::tr("Indicator diagram, p–V");
    figure.left = {.title = ShaftParts::tr("bar")};
    if (!result.indicated || result.curves.volume.empty()) {
        return figure;
    }
    std::vector<double> volume = inUnit(result.curves.volume, units::cm3);
    // A trace has no clearance volume: without it all cycles can be compared.
    for (double& each : volume) {
        each -= result.indicated->clearance.value_or(0.0) / units::cm3;
    }
    figure.x = {.title = ShaftParts::tr("V without clearance, cm³"),
                .min = 0.0,
                .max = 1.03 * *std::max_element(volume.begin(), volume.end())};
    figure.add("loop", pressureStyle(), std::move(volume),
               inUnit(result.curves.pressure, units::bar));
    return figure;
}

Figure orders(const Model& model) {
    const Result& result = model.result();
    Figure figure;
    figure.title = ShaftParts::tr("Order spectrum of the moment");
    figure.x = {.title = ShaftParts::tr("order (per turn of the crank)"), .min = 0.0, .max = 12.5};
    figure.left = {.title = ShaftParts::tr("N·m")};
    const auto add = [&](const char* id, const QString& name, Role role, const QString& tip,
                         double shift, const auto& spectrum) {
        Figure::Curve& curve = figure.add(id,
                                          {.name = name,
                                           .role = role,
                                           .shape = plot::Shape::Bars,
                                           .toolTip = tip,
                                           .barWidth = 0.18,
                                           .barShift = shift},
                                          {}, {});
        for (const auto& order : spectrum) {
            curve.x.push_back(order.order);
            curve.y.push_back(order.amplitude);
        }
    };
    add("M_up", ShaftParts::tr("without shaft (Mᵤₚ)"), Role::Engine,
        ShaftParts::tr("Without a shaft"), -0.1, result.spectrum_M_up);
    add("M_ups", ShaftParts::tr("with shaft (Mᵤₚₛ)"), Role::Sum,
        ShaftParts::tr("With the shaft at the present α"), 0.1, result.spectrum_M_ups);
    return figure;
}

Results orderTable(const Model& model) {
    const Result& result = model.result();
    const ResultColumn phase(
        ShaftParts::tr("phase, °"),
        ShaftParts::tr("Phase of the moment to the left: amplitude × sin(kφ + phase)"));
    Results results{{{ShaftParts::tr("Order"), ShaftParts::tr("Multiple of the crank speed")},
                     {shownTitle(ShaftParts::tr("Mᵤₚ, N·m")).text,
                      ShaftParts::tr("Fourier amplitude of the moment without a shaft")},
                     phase,
                     {shownTitle(ShaftParts::tr("Mᵤₚₛ, N·m")).text,
                      ShaftParts::tr("Fourier amplitude with the shaft at the present α")},
                     phase}};
    const auto moment = [](double value) { return shownCell(value, units::N_m, 2); };
    const auto direction = [](double value) {
        return ResultCell(value / degree, shownDigits(value, units::degree, 1),
                          ResultCell::Kind::Direction);
    };
    for (std::size_t i = 0; i < result.spectrum_M_up.size(); ++i) {
        const auto& without = result.spectrum_M_up[i];
        const auto& with = result.spectrum_M_ups[i];
        results.rows.push_back({formNumber(without.order, QLocale()), moment(without.amplitude),
                                direction(without.phase), moment(with.amplitude),
                                direction(with.phase)});
    }
    return results;
}

Figure energy(const Model& model) {
    const balance_shaft::Flywheel& wheel = model.result().flywheel;
    Figure figure =
        overCycle(model, ShaftParts::tr("Excess energy over the cycle"), ShaftParts::tr("J"));
    figure.add("energy",
               {.name = ShaftParts::tr("E"),
                .role = Role::Value,
                .width = 1.8,
                .inLegend = false,
                .toolTip = ShaftParts::tr("Work of the engine torque minus work of its mean")},
               model.result().curves.crank_angle_deg, wheel.energy);
    auto& marks = figure.marks.emplace();
    const auto mark = [&](double angle, double joules, const QString& text) {
        marks.push_back({.x = angle / degree,
                         .y = joules,
                         .text = text.arg(fixedNumber(joules, 0, QLocale())),
                         .role = Role::Value});
    };
    mark(wheel.max_angle, wheel.max_energy, ShaftParts::tr("fastest, %1 J"));
    mark(wheel.min_angle, wheel.min_energy, ShaftParts::tr("slowest, %1 J"));
    return figure;
}

Figure forceLocus(const Model& model) {
    const CrankBalance balance = balance_shaft::crank_balance(model.solver());
    const auto room = [](double force) { return 1.15 * force / units::kN; };
    const double along = std::max(balance.along, balance.with_shaft);
    Figure figure;
    figure.title = ShaftParts::tr("Force on the engine");
    figure.x = {.title = ShaftParts::tr("across, kN"),
                .min = -room(balance.across),
                .max = room(balance.across)};
    figure.left = {.title = ShaftParts::tr("along, kN")};
    figure.leftRange =
        std::pair(-room(std::max(along, balance.second_order)), room(along + balance.second_order));
    figure.equalScale = true;
    const auto add = [&](const char* id, plot::CurveStyle style, ForceLocus locus) {
        style.turn = 360.0;
        figure.add(id, std::move(style), inUnit(std::move(locus.x), units::kN),
                   inUnit(std::move(locus.y), units::kN));
    };
    add("both",
        {.name = ShaftParts::tr("without shaft, 1st + 2nd order"),
         .role = Role::AllOrders,
         .toolTip = ShaftParts::tr("First and second order without a shaft")},
        force_locus(balance, balance.across, balance.along, balance.second_order));
    add("first",
        {.name = ShaftParts::tr("without shaft, 1st order"),
         .role = Role::Engine,
         .width = 2.0,
         .toolTip = ShaftParts::tr("First order without a shaft: an ellipse")},
        force_locus(balance, balance.across, balance.along, 0.0));
    add("shaft",
        {.name = ShaftParts::tr("with shaft"),
         .role = Role::Sum,
         .width = 2.0,
         .toolTip = ShaftParts::tr("With the shaft the first order is a point; the second order "
                                   "along the cylinder remains")},
        force_locus(balance, 0.0, balance.with_shaft, balance.second_order));
    return figure;
}

Results forces(const Model& model) {
    namespace key = balance_shaft::result_field;
    const CrankBalance balance = balance_shaft::crank_balance(model.solver());
    Results results{{ShaftParts::tr("Force"), ShaftParts::tr("Value"), ShaftParts::tr("Unit")}};
    results.rows = {
        shownRow(key::first_order, balance.first_order),
        shownRow(key::along_cylinder, balance.along),
        shownRow(key::across_cylinder, balance.across),
        shownRow(key::with_shaft, balance.with_shaft),
        shownRow(key::second_order, balance.second_order),
        shownRow(ShaftParts::tr("on crank, κ mⱼ r"), balance.counterweight_moment, units::gram_mm,
                 0, ShaftParts::tr("Static moment of the counterweight on the crank")),
    };
    return results;
}

Figure gearMoment(const Model& model) {
    const GearError& error = model.gearError();
    const Result& result = model.result();
    Figure figure = overCycle(model, ShaftParts::tr("Mᵤₚₛ with gear error"), ShaftParts::tr("N·m"));
    figure.leftRange = std::pair(result.M_up.min - result.moment_amplitude,
                                 result.M_up.max + result.moment_amplitude);
    plot::CurveStyle play{.name = ShaftParts::tr("play, low"), .role = Role::Limit, .width = 1.0};
    if (error.play > 0.0) {
        play.inLegend = false;
        figure.add("low", play, error.crank_angle_deg, error.M_ups_low);
        play.inLegend = true;
        play.name = ShaftParts::tr("play");
        play.toolTip = ShaftParts::tr("Band due to the play of the gears");
        figure.add("high", play, error.crank_angle_deg, error.M_ups_high);
    }
    figure.add("right",
               {.name = ShaftParts::tr("correct"),
                .role = Role::Sum,
                .width = 2.4,
                .toolTip = ShaftParts::tr("Correct timing")},
               result.curves.crank_angle_deg, result.curves.M_ups);
    figure.add("wrong",
               {.name = ShaftParts::tr("k teeth out"),
                .role = Role::Comparison,
                .width = 1.6,
                .toolTip = ShaftParts::tr("Shaft k teeth out")},
               error.crank_angle_deg, error.M_ups);
    return figure;
}

Results gears(const Model& model) {
    namespace key = balance_shaft::result_field;
    const GearError& error = model.gearError();
    const auto& right = model.result().M_ups;
    const auto angle = [](double radians, int digits) {
        return ResultCell(radians / degree, fixedNumber(radians / degree, digits, QLocale()));
    };
    const auto moments = [](double one, const QString& pattern, double other, int digits) {
        return ResultCell::two(pattern, shownCell(one, units::N_m, digits),
                               shownCell(other, units::N_m, digits));
    };
    // What the gears have not is a dash; a report leaves such rows out.
    const auto when = [](bool is, const ResultCell& cell) {
        return is ? cell : ResultCell(QStringLiteral("–"));
    };
    const bool isOut = error.phase_error != 0.0;
    const bool hasPlay = error.play > 0.0;
    const QString to = QStringLiteral("%1 → %2");
    const QString momentUnit = shownUnit(units::N_m).name;
    const QString degrees = QStringLiteral("°");
    Results results{{ShaftParts::tr("Gears"), ShaftParts::tr("Value"), ShaftParts::tr("Unit")}};
    results.rows = {
        {{ShaftParts::tr("phase error"), when(isOut, angle(error.phase_error, 2)), degrees},
         ShaftParts::tr("360° k / z")},
        shownRow(key::residual_force, isOut ? std::optional(error.residual_force) : std::nullopt),
        {{ShaftParts::tr("range"), when(isOut, moments(right.range, to, error.range, 0)),
          momentUnit},
         ShaftParts::tr("ΔMᵤₚₛ, correct timing → k teeth out")},
        {{ShaftParts::tr("RMS"), when(isOut, moments(right.rms, to, error.rms, 1)), momentUnit},
         ShaftParts::tr("RMS of Mᵤₚₛ, correct timing → k teeth out")},
        {{ShaftParts::tr("play, ±"), when(hasPlay, angle(error.play, 3)), degrees},
         ShaftParts::tr("Angle of the shaft within the play, to either side: play / l")},
        {{ShaftParts::tr("range in play"),
          when(hasPlay,
               moments(error.play_range_low, QStringLiteral("%1…%2"), error.play_range_high, 0)),
          momentUnit},
         ShaftParts::tr("Minimum and maximum ΔMᵤₚₛ within the play")}};
    return results;
}

Results relief(const Model& model) {
    namespace key = balance_shaft::result_field;
    const balance_shaft::RelievedShaft& found = model.result().relieved_shaft;
    const auto row = [](const ResultField& field, double si) {
        return shownRow(field, si > 0.0 ? std::optional(si) : std::nullopt);
    };
    Results results{{ShaftParts::tr("Shaft"), ShaftParts::tr("Value"), ShaftParts::tr("Unit")}};
    results.rows = {
        row(key::required_unbalance, found.required),
        row(key::unbalance, found.unbalance),
        row(key::flat_width, 2.0 * found.half_width),
        row(key::relieved_part_mass, found.mass),
        row(key::removed_mass, found.removed_mass),
        row(key::centre_of_mass_radius, found.centre_of_mass_radius),
        row(key::critical_radius, found.critical_radius),
        row(key::critical_length, found.critical_length),
    };
    return results;
}

Notes reliefVerdict(const Model& model) {
    const balance_shaft::RelievedShaft& shaft = model.result().relieved_shaft;
    return shaft.feasible ? Notes::of(Severity::note, (ShaftParts::tr("Feasible.") +
                                                       QLatin1Char(' ') + messageText(shaft.note))
                                                          .trimmed())
                          : Notes::of(Severity::warning, messageText(shaft.reason));
}

// What is said.

template <Criterion criterion>
Notes bestAngle(const Model& model) {
    Notes notes;  // one line: a report says none twice
    notes.say(Severity::note, model.bestText(criterion));
    return notes;
}

Notes notes(const Model& model) {
    return Notes::of(Severity::note, model.notesText());
}

Notes bestPlace(const Model& model) {
    const ShaftMapModel* map = model.shaftMap();
    return map != nullptr ? Notes::of(Severity::note, map->answer()) : Notes();
}

Notes bestCompromise(const Model& model) {
    const SpeedStudyModel* study = model.speedStudy();
    return study != nullptr ? Notes::of(Severity::note, study->answer()) : Notes{};
}

using Maker = PartMaker<Model>;
constexpr std::array makers{
    Maker{{.id = "criteria", .isAnswer = true}, made<&Model::criteria>},
    Maker{{.id = "best-range", .isAnswer = true}, made<bestAngle<Criterion::range>>},
    Maker{{.id = "best-rms", .isAnswer = true}, made<bestAngle<Criterion::rms>>},
    Maker{{.id = "quantities", .isAnswer = true}, made<&Model::quantities>},
    Maker{{.id = "notes"}, made<notes>},
    Maker{{.id = "moments", .tab = "moments"}, made<moments>},
    Maker{{.id = "range", .tab = "moments"}, made<range>},
    Maker{{.id = "places", .tab = "map", .hasBand = false}, made<places>},
    Maker{{.id = "best-place", .tab = "map", .hasBand = false}, made<bestPlace>},
    Maker{{.id = "front", .tab = "map", .hasBand = false}, made<front>},
    Maker{{.id = "torque", .tab = "cycle"}, made<torque>},
    Maker{{.id = "pressure", .tab = "cycle"}, made<pressure>},
    Maker{{.id = "indicator", .tab = "cycle"}, made<indicator>},
    Maker{{.id = "cycle", .tab = "cycle"}, made<&Model::cycle>},
    Maker{{.id = "best-angles", .tab = "speed", .hasBand = false}, made<bestAngles>},
    Maker{{.id = "speed-map", .tab = "speed", .hasBand = false}, made<speedMap>},
    Maker{{.id = "least-bad", .tab = "speed", .hasBand = false}, made<bestCompromise>},
    Maker{{.id = "sizes", .tab = "envelope"}, made<sizes>},
    Maker{{.id = "range-over-size", .tab = "envelope"}, made<rangeOverSize>},
    Maker{{.id = "orders", .tab = "orders"}, made<orders>},
    Maker{{.id = "order-table", .tab = "orders"}, made<orderTable>},
    Maker{{.id = "energy", .tab = "flywheel"}, made<energy>},
    Maker{{.id = "flywheel", .tab = "flywheel"}, made<&Model::flywheel>},
    Maker{{.id = "force-locus", .tab = "forces"}, made<forceLocus>},
    Maker{{.id = "gear-moment", .tab = "forces"}, made<gearMoment>},
    Maker{{.id = "forces", .tab = "forces"}, made<forces>},
    Maker{{.id = "gears", .tab = "forces"}, made<gears>},
    Maker{{.id = "relief", .tab = "relieved"}, made<relief>},
    Maker{{.id = "relief-verdict", .tab = "relieved"}, made<reliefVerdict>},
};

}  // namespace

std::span<const PagePart> BalanceShaftModel::parts() const {
    return partsOf(makers);
}

Content BalanceShaftModel::part(std::string_view id) const {
    return makePart(makers, *this, id);
}

}  // namespace ravnoves
