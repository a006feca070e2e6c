#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "methods/kernel.h"

namespace ravnoves::methods {

/// Thrown out of a measurement that was cancelled.
struct Cancelled {};

/// Called with the part done, 0…1, between one run and the next; false cancels (Cancelled is
/// thrown). Empty: never asked.
using Progress = std::function<bool(double)>;

/// Time of one evaluation, ns, over repeated batches.
struct Timing {
    double median = 0.0;
    double low = 0.0;   ///< lower quartile
    double high = 0.0;  ///< upper quartile
    int batches = 0;
};

struct MeasureOptions {
    double batch_seconds = 2e-4;   ///< shortest time of a batch…
    int batches = 15;              ///< …and is repeated so often
    double max_seconds = 0.25;     ///< of one point; then there are fewer batches, at least 3
    std::size_t sweep_points = 0;  ///< of a stability curve; 0: as many as its sweep says
};

/// Times a method, prepared once: as many runs per batch as a batch needs, one batch to warm up.
Timing time_run(const Problem& problem, std::size_t method, std::size_t setting,
                const MeasureOptions& options = {});

/// Where a method exceeds the scene's tolerance along one hard parameter.
struct Failing {
    std::size_t sweep = 0;  ///< in Kernel::sweeps
    Message where;          ///< as failing_text()
};

/// One line of a kernel's table: a method with one setting, as measured.
struct MethodRow {
    std::size_t method = 0;   ///< in Kernel::methods
    std::size_t setting = 0;  ///< in MethodInfo::settings
    Timing timing;            ///< ns per evaluation
    Result result;            ///< error at the measured value, or the reason for none
    bool in_use = false;      ///< the scene's method and setting
    bool holds = false;       ///< its error at the measured value is within the scene's tolerance
    /// Along every hard parameter that was mapped, in the kernel's order. The stability curves are
    /// of the method's finest setting (or the one in use), so only that row has them.
    std::vector<Failing> fails{};
};

/// A kernel's methods on the problem of one value of a sweep, as measured on this machine.
struct KernelReport {
    const Kernel* kernel = nullptr;
    std::size_t sweep = 0;
    double value = 0.0;
    std::vector<MethodRow> rows;  ///< by method, then by setting

    const MethodInfo& method(const MethodRow& row) const { return kernel->methods[row.method]; }
    const Message& setting(const MethodRow& row) const {
        return method(row).settings[row.setting].label;
    }
    /// Order of convergence found for a method: the slope of log error over log value between its
    /// settings, above rounding; empty where it has none.
    std::optional<double> order(std::size_t method) const;
};

/// Times and errors.
/// @throws Cancelled
KernelReport measure_work(const Kernel& kernel, std::size_t sweep, double value,
                          const MeasureOptions& options = {}, const Progress& progress = {});

/// The error of one method and setting along a sweep.
struct StabilityCurve {
    std::size_t method = 0;
    std::size_t setting = 0;
    std::vector<Result> results;  ///< one for each value

    /// Indices of values at which it fails a tolerance or rejects, as runs [first, last].
    struct Span {
        std::size_t first = 0;
        std::size_t last = 0;
    };
    std::vector<Span> failing(double tolerance) const;
};

struct StabilityMap {
    const Kernel* kernel = nullptr;
    std::size_t sweep = 0;
    std::vector<double> values;
    std::vector<StabilityCurve> curves;  ///< the last setting of every method, and the chosen one
};

/// Errors of every method along a sweep: each with its finest setting, the scene's with its own.
/// @throws Cancelled
StabilityMap map_stability(const Kernel& kernel, std::size_t sweep,
                           const MeasureOptions& options = {}, const Progress& progress = {});

/// What failing_text() says of a method that fails at no value, and at every value.
inline constexpr Text failing_nowhere = Text::tr("nowhere");
inline constexpr Text failing_everywhere = Text::tr("everywhere");

/// Where a method stops being trustworthy along a sweep, as a clause: "everywhere", "from λ = 0.2",
/// "λ = 0.2 to 0.3" or "nowhere".
Message failing_text(const StabilityMap& map, const StabilityCurve& curve, double tolerance);

}  // namespace ravnoves::methods
