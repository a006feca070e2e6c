#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "methods/measure.h"

namespace ravnoves::methods {

/// One line of a kernel's table: a method with one setting, as measured.
struct MethodRow {
    std::size_t method = 0;   ///< in Kernel::methods
    std::size_t setting = 0;  ///< in MethodInfo::settings
    Text title;               ///< of the method
    Message label;            ///< of the setting
    Timing timing;            ///< ns per evaluation
    double operations = 0.0;  ///< of one evaluation
    Result result;            ///< error at the measured value, or why there is none
    /// Order of convergence found over the method's settings; the same in all its rows.
    std::optional<double> order;
    bool in_use = false;  ///< the scene's method and setting
    bool holds = false;   ///< its error at the measured value is within the scene's tolerance
    /// Where it exceeds the scene's tolerance along the sweep, as failing_text(); the stability
    /// curve is that of the method's finest setting (or the one in use), so only that row has it.
    std::optional<Message> fails;
    Text limits;  ///< MethodInfo::limits: why, as a sentence
};

/// A kernel as measured on this machine.
struct KernelReport {
    const Kernel* kernel = nullptr;
    std::size_t sweep = 0;  ///< along which `fails` was found
    double value = 0.0;     ///< of the sweep, where times and errors were taken
    std::vector<MethodRow> rows;
};

/// The table of what has been measured. Both must be of the same kernel and sweep.
KernelReport make_report(const WorkPrecision& work, const StabilityMap& map);

/// Measures a kernel at the present value of its first sweep.
/// @throws Cancelled
KernelReport measure_kernel(const Kernel& kernel, const MeasureOptions& options = {},
                            const Progress& progress = {});

/// Which method the scene uses and why: "The scene balance-shaft uses: … (…), to 1e-09 (part of
/// …)." and MethodChoice::reason.
std::string choice_paragraph(const Kernel& kernel);

/// The report as aligned text (UTF-8): title, table, paragraph.
std::string write_text(const KernelReport& report);
/// As CSV with a header, one line per method and setting: kernel, sweep, value, method, setting,
/// in_use, tolerance, median_ns, low_ns, high_ns, operations, error, order, holds, fails, refusal,
/// limits. Empty where there is none; decimal point, full precision.
std::string write_csv(std::span<const KernelReport> reports);

}  // namespace ravnoves::methods
