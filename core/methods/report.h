#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case-file/verdict.h"
#include "methods/measure.h"

namespace ravnoves::methods {

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
    /// Order of convergence found over the method's settings; the same in all its rows.
    std::optional<double> order;
    bool in_use = false;  ///< the scene's method and setting
    bool holds = false;   ///< its error at the measured value is within the scene's tolerance
    /// Along every hard parameter that was mapped, in the kernel's order. The stability curves are
    /// of the method's finest setting (or the one in use), so only that row has them.
    std::vector<Failing> fails;
};

/// A kernel as measured on this machine.
struct KernelReport {
    const Kernel* kernel = nullptr;
    std::size_t sweep = 0;  ///< at whose value times and errors were taken
    double value = 0.0;
    std::vector<MethodRow> rows;

    const MethodInfo& method(const MethodRow& row) const { return kernel->methods[row.method]; }
    const Message& setting(const MethodRow& row) const {
        return method(row).settings[row.setting].label;
    }
};

/// The table of what has been measured.
/// @param maps  of the same kernel, each of another sweep
KernelReport make_report(const WorkPrecision& work, std::span<const StabilityMap* const> maps);

/// Measures a kernel at the present value of its first sweep, and its errors along every sweep.
/// @throws Cancelled
KernelReport measure_kernel(const Kernel& kernel, const MeasureOptions& options = {},
                            const Progress& progress = {});

/// Whether the method in use keeps the scene's tolerance at the measured point, and its rank among
/// those that do.
Verdict verdict(const KernelReport& report);

/// How a hard parameter is called.
enum class SweepName {
    title,  ///< "crank ratio λ, K = 0"
    id,     ///< "lambda"
};

/// A row's stretches in one: "nowhere", "everywhere", or by hard parameter where they differ,
/// without those where it never fails: "lambda: from 0.4; points: from 7200". Empty for a row
/// without a stability curve.
Message failing_summary(const Kernel& kernel, const MethodRow& row,
                        SweepName name = SweepName::title);

/// Which method the scene uses and why: "The scene balance-shaft uses: … (…), to 1e-09 (part of
/// …)." and MethodChoice::reason.
std::string choice_paragraph(const Kernel& kernel);

/// The report as aligned text (UTF-8): title, table, paragraph.
std::string write_text(const KernelReport& report);
/// As CSV with a header, one line per method and setting: kernel, sweep, value, method, setting,
/// in_use, tolerance, median_ns, low_ns, high_ns, error, order, `holds`, fails, rejection, limits.
/// Missing values are empty; decimal point, full precision.
std::string write_csv(std::span<const KernelReport> reports);

}  // namespace ravnoves::methods
