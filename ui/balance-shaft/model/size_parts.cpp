// How large the engine is over α, and what that costs.

#include <algorithm>
#include <array>
#include <limits>

#include "balance-shaft/model/balance_shaft_model.h"
#include "text/number_text.h"

namespace ravnoves {

namespace shaft_parts {

namespace {

/// Over a whole turn: the first comes again at its end.
std::vector<double> closedTurn(std::vector<double> values, const Unit& unit, double last) {
    for (double& value : values) {
        value /= unit.to_si;
    }
    values.push_back(last);
    return values;
}

std::vector<double> closedTurn(const std::vector<double>& values, const Unit& unit) {
    return closedTurn(values, unit, values.front() / unit.to_si);
}

Figure sizes(const BalanceShaftModel& model) {
    const balance_shaft::EnvelopeStudy& study = model.envelopeStudy();
    const std::vector<double> angle = closedTurn(study.shaft_angle_deg, units::none, 360.0);
    Figure figure = overAngle(model, SizeWords::tr("Overall size over α"), SizeWords::tr("mm"));
    figure.add("width", {.name = SizeWords::tr("width"), .role = Role::Horizontal, .width = 1.8},
               angle, closedTurn(study.width, units::mm));
    figure.add("height", {.name = SizeWords::tr("height"), .role = Role::Vertical, .width = 1.8},
               angle, closedTurn(study.height, units::mm));
    return figure;
}

Figure rangeOverSize(const BalanceShaftModel& model) {
    const balance_shaft::EnvelopeStudy& study = model.envelopeStudy();
    const std::vector<double> area = closedTurn(study.area, units::cm2);
    const auto [minimum, maximum] = std::minmax_element(area.begin(), area.end());
    const double pad = std::max(0.04 * (*maximum - *minimum), 1e-6);
    Figure figure;
    figure.title = SizeWords::tr("Range and overall size, α along the curve");
    figure.x = {.title = SizeWords::tr("width × height, cm²"),
                .min = *minimum - pad,
                .max = *maximum + pad};
    figure.left = {.title = SizeWords::tr("ΔMᵤₚₛ, N·m")};

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
    figure.add("all", {.name = SizeWords::tr("all α"), .role = Role::Limit, .width = 1.0}, area,
               closedTurn(study.range, units::none));
    figure.add("built",
               {.name = SizeWords::tr("feasible"),
                .role = Role::Neutral,
                .width = 1.8,
                .toolTip = SizeWords::tr("The shaft clears cylinder, crank and rod"),
                .gaps = true},
               area, closedTurn(built, units::none));
    figure.add("efficient",
               {.name = SizeWords::tr("Pareto-optimal"),
                .role = Role::Best,
                .shape = plot::Shape::Points,
                .toolTip = SizeWords::tr("Feasible and Pareto-optimal in size and range")},
               std::move(efficient.x), std::move(efficient.y));
    const balance_shaft::Envelope& box = model.result().envelope;
    figure.add(
        "present",
        {.name = SizeWords::tr("present α"), .role = Role::Present, .shape = plot::Shape::Points},
        {box.width() * box.height() / units::cm2}, {model.result().M_ups.range});
    return figure;
}

constexpr std::array sizeMakers{
    PartMaker<BalanceShaftModel>{{.id = "sizes", .tab = "envelope"}, made<sizes>},
    PartMaker<BalanceShaftModel>{{.id = "range-over-size", .tab = "envelope"}, made<rangeOverSize>},
};

}  // namespace

}  // namespace shaft_parts

ShaftPartMakers sizeParts() {
    return shaft_parts::sizeMakers;
}

}  // namespace ravnoves
