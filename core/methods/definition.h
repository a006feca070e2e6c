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

/// All that a kernel's file has to say. Case needs outputs() and evaluations().
template <typename Case>
struct Definition {
    Kernel kernel;  ///< without methods, sweeps and problem
    std::vector<Method<Case>> methods;
    std::vector<Sweep<Case>> sweeps;
    std::function<std::vector<Expected>(const Case&)> reference;
    /// In the place of the largest |out − expected| / scale, where the error is something else.
    std::function<double(const Case&, std::span<const double>, const std::vector<Expected>&)>
        measure;
};

template <typename Case>
class ProblemOf final : public Problem {
  public:
    ProblemOf(std::shared_ptr<const Definition<Case>> definition, Case instance)
        : definition_(std::move(definition)), case_(std::move(instance)) {}

    std::size_t outputs() const override { return case_.outputs(); }
    double evaluations() const override { return case_.evaluations(); }
    Run prepare(std::size_t method, std::size_t setting) const override {
        const Method<Case>& chosen = definition_->methods.at(method);
        return chosen.prepare(case_, chosen.info.settings.at(setting).value);
    }
    double error(std::span<const double> out) const override {
        if (definition_->measure) {
            return definition_->measure(case_, out, reference());
        }
        Real50 worst(0);
        for (const Expected& expected : reference()) {
            const Real50 error = abs(Real50(out[expected.index] - expected.value)) / expected.scale;
            worst = std::max(worst, error);
        }
        return static_cast<double>(worst);
    }

  private:
    const std::vector<Expected>& reference() const {
        if (!reference_) {
            reference_ = definition_->reference(case_);
        }
        return *reference_;
    }

    std::shared_ptr<const Definition<Case>> definition_;
    Case case_;
    mutable std::optional<std::vector<Expected>> reference_;
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
                         std::size_t sweep, double value) -> std::unique_ptr<Problem> {
        return std::make_unique<ProblemOf<Case>>(shared, shared->sweeps.at(sweep).make(value));
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
