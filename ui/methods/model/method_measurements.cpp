#include "methods/model/method_measurements.h"

#include <span>
#include <utility>

namespace ravnoves {

using methods::Kernel;
using methods::MeasureOptions;
using methods::StabilityMap;

namespace {

MeasureOptions optionsOf(MeasurementEffort effort) {
    MeasureOptions options;
    if (effort == MeasurementEffort::quick) {
        options.batch_seconds = 1e-4;
        options.batches = 9;
        options.max_seconds = 0.03;
    }
    return options;
}

constexpr double workShare = 0.6;  ///< of the progress

std::shared_ptr<const MethodMeasurement> measure(const Kernel& kernel, std::size_t sweep,
                                                 double value, const MeasureOptions& options,
                                                 std::shared_ptr<const StabilityMap> known,
                                                 const BackgroundJob::Progress& progress) {
    const double share = known ? 1.0 : workShare;
    auto work = methods::measure_work(kernel, sweep, value, options,
                                      [&](double part) { return progress(share * part); });
    if (!known) {
        known = std::make_shared<const StabilityMap>(methods::map_stability(
            kernel, sweep, options,
            [&](double part) { return progress(workShare + (1.0 - workShare) * part); }));
    }
    const StabilityMap* const map = known.get();
    auto report = methods::make_report(work, std::span(&map, 1));
    return std::make_shared<const MethodMeasurement>(
        MethodMeasurement{std::move(work), std::move(known), std::move(report)});
}

}  // namespace

void MethodMeasurements::start(const Kernel& kernel, std::size_t sweep, double value,
                               MeasurementEffort effort) {
    const auto known = maps_.find({&kernel, sweep});
    BackgroundJob::start(
        [this, &kernel, sweep, value, options = optionsOf(effort),
         map = known == maps_.end() ? nullptr : known->second](const Progress& progress) {
            auto measurement = measure(kernel, sweep, value, options, map, progress);
            return [this, measurement] { keep(measurement); };
        });
}

std::shared_ptr<const MethodMeasurement> MethodMeasurements::newest(const Kernel& kernel) const {
    const auto found = newest_.find(&kernel);
    return found == newest_.end() ? nullptr : found->second;
}

void MethodMeasurements::keep(std::shared_ptr<const MethodMeasurement> measurement) {
    maps_[{measurement->work.kernel, measurement->work.sweep}] = measurement->map;
    newest_[measurement->work.kernel] = measurement;
    Q_EMIT measured(std::move(measurement));
}

}  // namespace ravnoves
