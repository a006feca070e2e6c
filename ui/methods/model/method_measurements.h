#pragma once

#include <map>
#include <memory>

#include "methods/measure.h"
#include "methods/report.h"
#include "model/background_job.h"

namespace ravnoves {

/// Times and errors of a kernel at one value of one of its hard parameters, and its errors along
/// that parameter.
struct MethodMeasurement {
    methods::WorkPrecision work;
    std::shared_ptr<const methods::StabilityMap> map;
    methods::KernelReport report;  ///< both as a table

    const methods::Kernel& kernel() const { return *work.kernel; }
    const methods::SweepInfo& sweep() const { return kernel().sweeps[work.sweep]; }
    bool isOf(const methods::Kernel& kernel, std::size_t sweep, double value) const {
        return work.kernel == &kernel && work.sweep == sweep && work.value == value;
    }
};

/// How much patience a measurement has.
enum class MeasurementEffort {
    quick,     ///< about a second: by itself, when something was chosen
    thorough,  ///< as the command line measures, on demand
};

/// Measures kernels in a worker thread, one at a time, and keeps the newest measurement of every
/// kernel, and the errors along every sweep (they do not change).
class MethodMeasurements : public BackgroundJob {
    Q_OBJECT

  public:
    using BackgroundJob::BackgroundJob;

    /// Begins a measurement in the place of one that runs.
    void start(const methods::Kernel& kernel, std::size_t sweep, double value,
               MeasurementEffort effort);
    /// The newest measurement of a kernel; null before the first.
    std::shared_ptr<const MethodMeasurement> newest(const methods::Kernel& kernel) const;

  Q_SIGNALS:
    void measured(std::shared_ptr<const MethodMeasurement> measurement);

  private:
    void keep(std::shared_ptr<const MethodMeasurement> measurement);

    using Place = std::pair<const methods::Kernel*, std::size_t>;  // kernel, sweep

    std::map<const methods::Kernel*, std::shared_ptr<const MethodMeasurement>> newest_;
    std::map<Place, std::shared_ptr<const methods::StabilityMap>> maps_;
};

}  // namespace ravnoves
