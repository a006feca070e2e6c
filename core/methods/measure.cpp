#include "methods/measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "numerics/vector_state.h"

namespace ravnoves::methods {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_of(const Run& run, std::vector<double>& out, std::size_t repeats) {
    clear_vector_state();  // whichever thread measures, it is the same that is measured
    const auto start = Clock::now();
    for (std::size_t i = 0; i < repeats; ++i) {
        run(out);
    }
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void tell(const Progress& progress, double part) {
    if (progress && !progress(part)) {
        throw Cancelled{};
    }
}

/// The q-quantile of sorted values, between neighbours by proportion.
double quantile(const std::vector<double>& sorted, double q) {
    const double place = q * static_cast<double>(sorted.size() - 1);
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, sorted.size() - 1);
    return std::lerp(sorted[low], sorted[high], place - static_cast<double>(low));
}

}  // namespace

Timing time_run(const Problem& problem, std::size_t method, std::size_t setting,
                const MeasureOptions& options) {
    const Run run = problem.prepare(method, setting);
    std::vector<double> out(problem.outputs, 0.0);
    std::size_t repeats = 1;
    double warm = seconds_of(run, out, repeats);
    while (warm < options.batch_seconds) {
        constexpr double max_growth = 64.0;
        const double growth =
            std::clamp(1.5 * options.batch_seconds / std::max(warm, 1e-9), 2.0, max_growth);
        repeats = static_cast<std::size_t>(std::ceil(static_cast<double>(repeats) * growth));
        warm = seconds_of(run, out, repeats);
    }
    constexpr int fewest = 3;
    const int batches = std::clamp(static_cast<int>(options.max_seconds / warm), fewest,
                                   std::max(options.batches, fewest));
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(batches));
    for (int batch = 0; batch < batches; ++batch) {
        times.push_back(1e9 * seconds_of(run, out, repeats) /
                        (static_cast<double>(repeats) * problem.evaluations));
    }
    std::sort(times.begin(), times.end());
    return {quantile(times, 0.5), quantile(times, 0.25), quantile(times, 0.75), batches};
}

std::optional<double> KernelReport::order(std::size_t method) const {
    const MethodInfo& info = kernel->methods[method];
    if (!info.has_order) {
        return std::nullopt;
    }
    // Slopes between settings whose errors are neither rounding nor of the size of the answer. A
    // single one may be off by chance (an error that passes through zero), so the median counts.
    constexpr double rounding = 1e-13;
    constexpr double too_coarse = 0.05;
    std::vector<double> slopes;
    const MethodRow* last = nullptr;
    for (const MethodRow& point : rows) {
        if (point.method != method || point.result.rejected() || point.result.error < rounding ||
            point.result.error > too_coarse) {
            continue;
        }
        if (last != nullptr) {
            const double step =
                std::log(info.settings[point.setting].value / info.settings[last->setting].value);
            slopes.push_back(-std::log(point.result.error / last->result.error) / step);
        }
        last = &point;
    }
    if (slopes.empty()) {
        return std::nullopt;
    }
    std::sort(slopes.begin(), slopes.end());
    return slopes[slopes.size() / 2];
}

KernelReport measure_work(const Kernel& kernel, std::size_t sweep, double value,
                          const MeasureOptions& options, const Progress& progress) {
    KernelReport report{&kernel, sweep, value, {}};
    const Problem problem = kernel.problem(sweep, value);
    std::size_t total = 0;
    for (const MethodInfo& method : kernel.methods) {
        total += method.settings.size();
    }
    for (std::size_t method = 0; method < kernel.methods.size(); ++method) {
        for (std::size_t setting = 0; setting < kernel.methods[method].settings.size(); ++setting) {
            tell(progress, static_cast<double>(report.rows.size()) / static_cast<double>(total));
            const Result result = evaluate(problem, method, setting);
            report.rows.push_back(
                {method, setting, time_run(problem, method, setting, options), result,
                 method == kernel.chosen_method() && setting == kernel.chosen_setting(),
                 !result.rejected() && result.error <= kernel.choice.tolerance});
        }
    }
    tell(progress, 1.0);
    return report;
}

std::vector<StabilityCurve::Span> StabilityCurve::failing(double tolerance) const {
    std::vector<Span> spans;
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (!results[i].rejected() && results[i].error <= tolerance) {
            continue;
        }
        if (!spans.empty() && spans.back().last + 1 == i) {
            spans.back().last = i;
        } else {
            spans.push_back({i, i});
        }
    }
    return spans;
}

StabilityMap map_stability(const Kernel& kernel, std::size_t sweep, const MeasureOptions& options,
                           const Progress& progress) {
    StabilityMap map{&kernel, sweep, {}, {}};
    const SweepInfo& info = kernel.sweeps.at(sweep);
    map.values = info.values(options.sweep_points > 0 ? options.sweep_points : info.points);
    for (std::size_t method = 0; method < kernel.methods.size(); ++method) {
        const std::size_t last = kernel.methods[method].settings.size() - 1;
        const bool chosen = method == kernel.chosen_method();
        map.curves.push_back({method, chosen ? kernel.chosen_setting() : last, {}});
    }
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        tell(progress, static_cast<double>(i) / static_cast<double>(map.values.size()));
        const auto problem = kernel.problem(sweep, map.values[i]);
        for (StabilityCurve& curve : map.curves) {
            curve.results.push_back(evaluate(problem, curve.method, curve.setting));
        }
    }
    tell(progress, 1.0);
    return map;
}

Message failing_text(const StabilityMap& map, const StabilityCurve& curve, double tolerance) {
    const auto spans = curve.failing(tolerance);
    if (spans.empty()) {
        return failing_nowhere;
    }
    if (spans.front().first == 0 && spans.front().last + 1 == map.values.size()) {
        return failing_everywhere;
    }
    const SweepInfo& sweep = map.kernel->sweeps[map.sweep];
    const auto number = [&](std::size_t i) { return Number{map.values[i], sweep.unit, 3}; };
    const auto words = [&](const StabilityCurve::Span& span) -> Message {
        if (span.first == span.last) {
            return {Text::tr("at %1"), number(span.first)};
        }
        if (span.last + 1 == map.values.size()) {
            return {Text::tr("from %1"), number(span.first)};
        }
        if (span.first == 0) {
            return {Text::tr("up to %1"), number(span.last)};
        }
        return {Text::tr("%1 to %2"), number(span.first), number(span.last)};
    };
    constexpr std::size_t maximum = 3;
    Message text = words(spans.front());
    for (std::size_t k = 1; k < std::min(spans.size(), maximum); ++k) {
        text = joined(std::move(text), words(spans[k]));
    }
    return spans.size() > maximum ? Message(Text{"%1 …"}, std::move(text)) : text;
}

}  // namespace ravnoves::methods
