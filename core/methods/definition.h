#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "methods/kernel.h"
#include "numerics/real50.h"

namespace ravnoves::methods {

/// A reference for one output.
struct Expected {
    std::size_t index;  ///< of the output
    Real50 value;
    double scale;  ///< the error is divided by this, > 0
};

/// The one interface of a kernel whose problems are of type Case: a method is made ready for a
/// case and then run.
template <typename Case>
struct Method {
    MethodInfo info;
    std::function<Run(const Case&, double setting)> prepare;
};

template <typename Case>
struct Sweep {
    SweepInfo info;
    std::function<Case(double)> make;
};

/// All that a kernel's file has to say.
template <typename Case>
struct Definition {
    Kernel kernel;  ///< without methods, sweeps and problem
    std::size_t outputs = 1;
    double (*evaluations)(const Case&) = [](const Case&) { return 1.0; };
    std::vector<Method<Case>> methods;
    std::vector<Sweep<Case>> sweeps;
    std::function<std::vector<Expected>(const Case&)> reference;
    /// In the place of the largest |out − expected| / scale, where the error is something else.
    std::function<double(const Case&, std::span<const double>, const std::vector<Expected>&)>
        measure =
            [](const Case&, std::span<const double> out, const std::vector<Expected>& reference) {
                Real50 worst(0);
                for (const auto& [index, value, scale] : reference) {
                    worst = std::max(worst, Real50(abs(Real50(out[index] - value)) / scale));
                }
                return static_cast<double>(worst);
            };
};

/// The kernel of a definition.
template <typename Case>
Kernel make_kernel(Definition<Case> definition) {
    Kernel kernel = definition.kernel;
    for (const Method<Case>& method : definition.methods) {
        kernel.methods.push_back(method.info);
    }
    for (const Sweep<Case>& sweep : definition.sweeps) {
        kernel.sweeps.push_back(sweep.info);
    }
    kernel.problem = [shared = std::make_shared<const Definition<Case>>(std::move(definition))](
                         std::size_t sweep, double value) -> Problem {
        const auto of = std::make_shared<const Case>(shared->sweeps.at(sweep).make(value));
        return {shared->outputs, shared->evaluations(*of),
                [shared, of](std::size_t method, std::size_t setting) {
                    const Method<Case>& chosen = shared->methods.at(method);
                    return chosen.prepare(*of, chosen.info.settings.at(setting).value);
                },
                [shared, of, reference = std::optional<std::vector<Expected>>()](
                    std::span<const double> out) mutable {
                    if (!reference) {
                        reference = shared->reference(*of);
                    }
                    return shared->measure(*of, out, *reference);
                }};
    };
    return kernel;
}

// The kernels, one file each.
Kernel slider_crank_kernel();
Kernel cycle_mean_kernel();
Kernel moment_range_kernel();
Kernel best_angle_kernel();
Kernel best_position_kernel();
Kernel guide_kernel();
Kernel inertia_orders_kernel();
Kernel hinge_motion_kernel();
Kernel scatter_kernel();

}  // namespace ravnoves::methods
