#include "balance-shaft/model/shown_curves.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "numerics/units.h"

namespace ravnoves {

namespace {

std::vector<double> in(double unit, std::vector<double> values) {
    for (double& value : values) {
        value /= unit;
    }
    return values;
}

std::vector<double> closed(std::vector<double> values, double last) {
    values.push_back(last);
    return values;
}

std::vector<double> closed(std::vector<double> values) {
    const double first = values.front();
    return closed(std::move(values), first);
}

}  // namespace

ShownOrders shownOrders(const balance_shaft::Result& result) {
    ShownOrders shown;
    for (std::size_t i = 0; i < result.spectrum_M_up.size(); ++i) {
        shown.order.push_back(result.spectrum_M_up[i].order);
        shown.without.push_back(result.spectrum_M_up[i].amplitude);
        shown.with.push_back(result.spectrum_M_ups[i].amplitude);
    }
    return shown;
}

double boxArea(const balance_shaft::Envelope& box) {
    return box.width() * box.height() / units::cm2;
}

ShownSizes shownSizes(const balance_shaft::EnvelopeStudy& study) {
    ShownSizes shown;
    shown.angle = closed(study.shaft_angle_deg, 360.0);
    shown.width = closed(in(units::mm.to_si, study.width));
    shown.height = closed(in(units::mm.to_si, study.height));
    shown.area = closed(in(units::cm2.to_si, study.area));
    shown.range = closed(study.range);
    std::vector<double> built = study.range;
    for (std::size_t i = 0; i < built.size(); ++i) {
        if (!study.buildable[i]) {
            built[i] = std::numeric_limits<double>::quiet_NaN();
        }
        if (!study.efficient[i]) {
            continue;
        }
        const ShownSizes::Point& point = shown.efficient.emplace_back(
            ShownSizes::Point{shown.area[i], study.range[i], study.shaft_angle_deg[i]});
        if (shown.marked.empty() || point.angle - shown.marked.back().angle >= 15.0) {
            shown.marked.push_back(point);
        }
    }
    shown.builtRange = closed(std::move(built));
    return shown;
}

ShownCycle shownCycle(const balance_shaft::Result& result) {
    const balance_shaft::MomentCurves& curves = result.curves;
    ShownCycle shown;
    if (!result.indicated || curves.M_gas.empty()) {
        return shown;
    }
    shown.torque.resize(curves.M_up.size());
    std::transform(curves.M_offset.begin(), curves.M_offset.end(), curves.M_up.begin(),
                   shown.torque.begin(), std::minus<>());
    shown.pressure = in(units::bar.to_si, curves.pressure);
    shown.volume = in(units::cm3.to_si, curves.volume);
    shown.largestVolume = *std::max_element(shown.volume.begin(), shown.volume.end());
    return shown;
}

}  // namespace ravnoves
