// Of what the torque is made, its orders, and what it does to the speed.

#include <algorithm>
#include <array>
#include <functional>

#include "balance-shaft/model/balance_shaft_model.h"
#include "numerics/constants.h"
#include "text/number_text.h"
#include "text/shown_units.h"

namespace ravnoves {

namespace shaft_parts {

namespace {

std::vector<double> inUnit(const Unit& unit, std::vector<double> values) {
    for (double& value : values) {
        value /= unit.to_si;
    }
    return values;
}

Figure torque(const BalanceShaftModel& model) {
    const balance_shaft::MomentCurves& curves = model.result().curves;
    Figure figure =
        overCycle(model, CycleWords::tr("Engine torque and its parts"), CycleWords::tr("N·m"));
    if (curves.M_gas.empty()) {
        return figure;  // the torque is a table
    }
    const std::vector<double>& phi = curves.crank_angle_deg;
    figure.add("gas",
               {.name = CycleWords::tr("gas"),
                .role = Role::Gas,
                .toolTip = CycleWords::tr("−(p − p₀) A s′")},
               phi, curves.M_gas);
    figure.add("inertia",
               {.name = CycleWords::tr("inertia"),
                .role = Role::Reciprocating,
                .toolTip = CycleWords::tr("−mⱼ ω² s′ s″")},
               phi, curves.M_inertia);
    if (model.input().cylinder.offset != 0.0) {
        figure.add(
            "offset",
            {.name = CycleWords::tr("offset"),
             .role = Role::Offset,
             .toolTip = CycleWords::tr("e mⱼ ω² s″: part of Mᵤₚ due to the offset cylinder")},
            phi, curves.M_offset);
    }
    std::vector<double> total(curves.M_up.size());
    std::transform(curves.M_offset.begin(), curves.M_offset.end(), curves.M_up.begin(),
                   total.begin(), std::minus<>());
    figure.add("total",
               {.name = CycleWords::tr("engine torque"),
                .role = Role::Engine,
                .width = 2.0,
                .toolTip = CycleWords::tr("Gas plus inertia")},
               phi, std::move(total));
    return figure;
}

auto pressureStyle() {
    return plot::CurveStyle{
        .name = CycleWords::tr("p"), .role = Role::Gas, .width = 1.8, .inLegend = false};
}

Figure pressure(const BalanceShaftModel& model) {
    const balance_shaft::MomentCurves& curves = model.result().curves;
    Figure figure = overCycle(model, CycleWords::tr("Cylinder pressure"), CycleWords::tr("bar"));
    if (!curves.pressure.empty()) {
        figure.add("pressure", pressureStyle(), curves.crank_angle_deg,
                   inUnit(units::bar, curves.pressure));
    }
    return figure;
}

Figure indicator(const BalanceShaftModel& model) {
    const balance_shaft::Result& result = model.result();
    Figure figure;
    figure.title = CycleWords::tr("Indicator diagram, p–V");
    figure.left = {.title = CycleWords::tr("bar")};
    if (!result.indicated || result.curves.volume.empty()) {
        return figure;
    }
    std::vector<double> volume = inUnit(units::cm3, result.curves.volume);
    // A trace has no clearance volume: without it all cycles can be compared.
    for (double& each : volume) {
        each -= result.indicated->clearance.value_or(0.0) / units::cm3;
    }
    figure.x = {.title = CycleWords::tr("V without clearance, cm³"),
                .min = 0.0,
                .max = 1.03 * *std::max_element(volume.begin(), volume.end())};
    figure.add("loop", pressureStyle(), std::move(volume),
               inUnit(units::bar, result.curves.pressure));
    return figure;
}

Figure orders(const BalanceShaftModel& model) {
    const balance_shaft::Result& result = model.result();
    Figure figure;
    figure.title = OrderWords::tr("Order spectrum of the moment");
    figure.x = {.title = OrderWords::tr("order (per turn of the crank)"), .min = 0.0, .max = 12.5};
    figure.left = {.title = OrderWords::tr("N·m")};
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
    add("M_up", OrderWords::tr("without shaft (Mᵤₚ)"), Role::Engine,
        OrderWords::tr("Without a shaft"), -0.1, result.spectrum_M_up);
    add("M_ups", OrderWords::tr("with shaft (Mᵤₚₛ)"), Role::Sum,
        OrderWords::tr("With the shaft at the present α"), 0.1, result.spectrum_M_ups);
    return figure;
}

Results orderTable(const BalanceShaftModel& model) {
    const balance_shaft::Result& result = model.result();
    const ResultColumn phase(
        OrderWords::tr("phase, °"),
        OrderWords::tr("Phase of the moment to the left: amplitude × sin(kφ + phase)"));
    Results results{{{OrderWords::tr("Order"), OrderWords::tr("Multiple of the crank speed")},
                     {shownTitle(OrderWords::tr("Mᵤₚ, N·m")).text,
                      OrderWords::tr("Fourier amplitude of the moment without a shaft")},
                     phase,
                     {shownTitle(OrderWords::tr("Mᵤₚₛ, N·m")).text,
                      OrderWords::tr("Fourier amplitude with the shaft at the present α")},
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

Figure energy(const BalanceShaftModel& model) {
    const balance_shaft::Flywheel& wheel = model.result().flywheel;
    Figure figure =
        overCycle(model, FlywheelWords::tr("Excess energy over the cycle"), FlywheelWords::tr("J"));
    figure.add("energy",
               {.name = FlywheelWords::tr("E"),
                .role = Role::Value,
                .width = 1.8,
                .inLegend = false,
                .toolTip = FlywheelWords::tr("Work of the engine torque minus work of its mean")},
               model.result().curves.crank_angle_deg, wheel.energy);
    auto& marks = figure.marks.emplace();
    const auto mark = [&](double angle, double joules, const QString& text) {
        marks.push_back({.x = angle / degree,
                         .y = joules,
                         .text = text.arg(fixedNumber(joules, 0, QLocale())),
                         .role = Role::Value});
    };
    mark(wheel.max_angle, wheel.max_energy, FlywheelWords::tr("fastest, %1 J"));
    mark(wheel.min_angle, wheel.min_energy, FlywheelWords::tr("slowest, %1 J"));
    return figure;
}

constexpr std::array cycleMakers{
    PartMaker<BalanceShaftModel>{{.id = "torque", .tab = "cycle"}, made<torque>},
    PartMaker<BalanceShaftModel>{{.id = "pressure", .tab = "cycle"}, made<pressure>},
    PartMaker<BalanceShaftModel>{{.id = "indicator", .tab = "cycle"}, made<indicator>},
    PartMaker<BalanceShaftModel>{{.id = "cycle", .tab = "cycle"}, made<&BalanceShaftModel::cycle>},
};

constexpr std::array orderMakers{
    PartMaker<BalanceShaftModel>{{.id = "orders", .tab = "orders"}, made<orders>},
    PartMaker<BalanceShaftModel>{{.id = "order-table", .tab = "orders"}, made<orderTable>},
    PartMaker<BalanceShaftModel>{{.id = "energy", .tab = "flywheel"}, made<energy>},
    PartMaker<BalanceShaftModel>{{.id = "flywheel", .tab = "flywheel"},
                                 made<&BalanceShaftModel::flywheel>},
};

}  // namespace

}  // namespace shaft_parts

ShaftPartMakers cycleParts() {
    return shaft_parts::cycleMakers;
}

ShaftPartMakers orderParts() {
    return shaft_parts::orderMakers;
}

}  // namespace ravnoves
