#pragma once

#include <span>
#include <string>

#include "case-file/verdict.h"
#include "methods/measure.h"

namespace ravnoves::methods {

/// Adds where along a map's sweep the methods of a report fail.
void add_failing(KernelReport& report, const StabilityMap& map);

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
