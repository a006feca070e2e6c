#include "methods/kernel.h"

#include <algorithm>
#include <cmath>

#include "methods/definition.h"
#include "numerics/demand.h"

namespace ravnoves::methods {

namespace {

template <typename List, typename Key>
std::size_t index_of(const List& list, std::string_view wanted, const Key& key, const char* what) {
    const auto found = std::find_if(list.begin(), list.end(),
                                    [&](const auto& item) { return key(item) == wanted; });
    RAVNOVES_DEMAND(found != list.end(),
                    std::string("there is a ") + what + " '" + std::string(wanted) + "'");
    return static_cast<std::size_t>(found - list.begin());
}

}  // namespace

double SweepInfo::at(double place) const {
    place = std::clamp(place, 0.0, 1.0);
    if (logarithmic() && place > 0.0 && place < 1.0) {
        return from * std::pow(to / from, place);
    }
    return std::lerp(from, to, place);
}

double SweepInfo::place(double value) const {
    value = std::clamp(value, from, to);
    return logarithmic() ? std::log(value / from) / std::log(to / from)
                         : (value - from) / (to - from);
}

std::vector<double> SweepInfo::values(std::size_t n) const {
    std::vector<double> list(std::max<std::size_t>(n, 2));
    const double last = static_cast<double>(list.size() - 1);
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i] = at(static_cast<double>(i) / last);
    }
    return list;
}

std::size_t Kernel::find_method(std::string_view wanted) const {
    return index_of(
        methods, wanted, [](const MethodInfo& m) { return m.id; }, "method");
}

std::size_t Kernel::find_setting(std::size_t method, std::string_view label) const {
    return index_of(
        methods.at(method).settings, label, [](const Setting& s) { return s.label.english(); },
        "setting");
}

std::vector<Setting> counted(Text label, std::initializer_list<double> values) {
    std::vector<Setting> settings;
    for (const double value : values) {
        settings.push_back(counted(label, value));
    }
    return settings;
}

const std::vector<Kernel>& kernels() {
    static const std::vector<Kernel> list = [] {
        std::vector<Kernel> kernels;
        kernels.push_back(slider_crank_kernel());
        kernels.push_back(cycle_mean_kernel());
        kernels.push_back(moment_range_kernel());
        kernels.push_back(best_angle_kernel());
        kernels.push_back(best_position_kernel());
        kernels.push_back(guide_kernel());
        kernels.push_back(inertia_orders_kernel());
        kernels.push_back(hinge_motion_kernel());
        kernels.push_back(scatter_kernel());
        return kernels;
    }();
    return list;
}

const Kernel* find_kernel(std::string_view id) {
    const auto& list = kernels();
    const auto found =
        std::find_if(list.begin(), list.end(), [&](const Kernel& k) { return k.id == id; });
    return found == list.end() ? nullptr : &*found;
}

Result evaluate(const Problem& problem, std::size_t method, std::size_t setting) {
    std::vector<double> out(problem.outputs, 0.0);
    Result result;
    result.rejection = problem.prepare(method, setting)(out);
    if (result.rejected()) {
        return result;
    }
    if (!std::all_of(out.begin(), out.end(), [](double x) { return std::isfinite(x); })) {
        result.rejection = Text::tr("gives no finite number");
        return result;
    }
    result.error = problem.error(out);
    if (!std::isfinite(result.error)) {
        result.rejection = Text::tr("has an error beyond the range of numbers");
        result.error = 0.0;
    }
    return result;
}

}  // namespace ravnoves::methods
