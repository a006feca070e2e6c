#include "methods/report.h"

#include <algorithm>
#include <utility>

#include "case-file/decimal.h"
#include "methods/plain_text.h"

namespace ravnoves::methods {

namespace {

constexpr int shown_digits = 3;
constexpr std::size_t text_width = 110;
constexpr std::size_t table_width = 140;

std::string digits(double value) {
    return format_number(value, shown_digits);
}

/// Three digits, but "19200" and not "1.92e+04".
std::string plain_digits(double value) {
    return format_number(rounded_to_digits(value, shown_digits));
}

std::string value_with_unit(const SweepInfo& sweep, double value) {
    return Message(Number{value, sweep.unit, shown_digits}).english();
}

}  // namespace

void add_failing(KernelReport& report, const StabilityMap& map) {
    for (const StabilityCurve& curve : map.curves) {
        for (MethodRow& row : report.rows) {
            if (row.method == curve.method && row.setting == curve.setting) {
                row.fails.push_back(
                    {map.sweep, failing_text(map, curve, map.kernel->choice.tolerance)});
            }
        }
    }
}

Verdict verdict(const KernelReport& report) {
    const MethodRow* used = nullptr;
    for (const MethodRow& row : report.rows) {
        used = row.in_use ? &row : used;
    }
    if (used == nullptr) {
        return {};
    }
    int holding = 0;
    int faster = 0;
    for (const MethodRow& row : report.rows) {
        holding += row.holds ? 1 : 0;
        faster += row.holds && row.timing.median < used->timing.median ? 1 : 0;
    }
    const Message name(Text{"%1, %2"}, report.method(*used).title, report.setting(*used));
    if (used->result.rejected()) {
        return {Severity::note,
                {Text::tr("In use: %1. No values here: %2."), name, used->result.rejection}};
    }
    if (!used->holds) {
        return {Severity::warning,
                {Text::tr("In use: %1. Beyond the tolerance at this value."), name}};
    }
    return {Severity::good,
            {Text::tr("In use: %1. Within the tolerance; %2 of %3 settings within it are faster."),
             name, faster, holding}};
}

KernelReport measure_kernel(const Kernel& kernel, const MeasureOptions& options,
                            const Progress& progress) {
    // The times and each of the maps take about as long.
    const auto parts = static_cast<double>(kernel.sweeps.size() + 1);
    const auto part_from = [&](double done) {
        return [&progress, parts, done](double part) {
            return !progress || progress((done + part) / parts);
        };
    };
    KernelReport report =
        measure_work(kernel, 0, kernel.sweeps.front().present, options, part_from(0.0));
    for (std::size_t sweep = 0; sweep < kernel.sweeps.size(); ++sweep) {
        add_failing(report, map_stability(kernel, sweep, options,
                                          part_from(1.0 + static_cast<double>(sweep))));
    }
    return report;
}

Message failing_summary(const Kernel& kernel, const MethodRow& row, SweepName name) {
    if (row.fails.empty()) {
        return {};
    }
    const Message& first = row.fails.front().where;
    const bool alike = std::all_of(row.fails.begin(), row.fails.end(),
                                   [&](const Failing& failing) { return failing.where == first; });
    const Message nowhere(failing_nowhere);
    const Message everywhere(failing_everywhere);
    if (alike && (first == nowhere || first == everywhere)) {
        return first;
    }
    Message text;
    for (const Failing& failing : row.fails) {
        if (failing.where == nowhere) {
            continue;
        }
        const SweepInfo& sweep = kernel.sweeps[failing.sweep];
        Message part{Text{"%1: %2"},
                     name == SweepName::id ? Message(sweep.id) : Message(sweep.title),
                     failing.where};
        text = text.empty() ? std::move(part)
                            : Message(Text{"%1; %2"}, std::move(text), std::move(part));
    }
    return text;
}

std::string choice_paragraph(const Kernel& kernel) {
    const MethodChoice& choice = kernel.choice;
    return "The scene " + std::string(choice.scene) +
           " uses: " + kernel.methods[kernel.chosen_method()].title.english + " (" +
           std::string(choice.setting) + "), to " + digits(choice.tolerance) + " (" +
           kernel.error_measure.english + "). " + choice.reason.english;
}

std::string write_text(const KernelReport& report) {
    const Kernel& kernel = *report.kernel;
    const SweepInfo& sweep = kernel.sweeps[report.sweep];
    AlignedTable table({{""},
                        {"method"},
                        {"setting"},
                        {"ns", true},
                        {"quartiles", true},
                        {"error", true},
                        {"order", true},
                        {"not trustworthy"}});
    for (const MethodRow& row : report.rows) {
        const auto order = report.order(row.method);
        table.add({row.in_use  ? "●"
                   : row.holds ? "+"
                               : "",
                   report.method(row).title.english, report.setting(row).english(),
                   plain_digits(row.timing.median),
                   plain_digits(row.timing.low) + "…" + plain_digits(row.timing.high),
                   row.result.rejected() ? "refused" : digits(row.result.error),
                   order ? format_number(*order, 2) : "",
                   failing_summary(kernel, row, SweepName::id).english()});
    }
    const std::string tolerance = digits(kernel.choice.tolerance);
    std::string text = std::string(kernel.title.english) + ": " + kernel.quantity.english + "\n\n";
    text +=
        hanging("",
                "Measured at " + value_with_unit(sweep, report.value) + " (" + sweep.title.english +
                    "); not trustworthy: where along each hard parameter the tolerance is "
                    "exceeded.",
                text_width);
    for (const SweepInfo& hard : kernel.sweeps) {
        text += hanging("  ", hard.id + ": " + hard.title.english + ".", text_width);
    }
    text += hanging("Time: ", std::string(kernel.evaluation.english) + ".", text_width);
    text += hanging("Error: ", std::string(kernel.error_measure.english) + ".", text_width);
    text += "● in use, + within the scene's tolerance of " + tolerance + "\n\n";
    text += table.text(table_width) + "\n";
    for (const MethodInfo& method : kernel.methods) {
        text +=
            hanging("  ", std::string(method.title.english) + ": " + method.limits.english + ".",
                    text_width);
    }
    return text + "\n" + hanging("", choice_paragraph(kernel), text_width);
}

std::string write_csv(std::span<const KernelReport> reports) {
    std::string text = csv_line({"kernel", "sweep", "value", "method", "setting", "in_use",
                                 "tolerance", "median_ns", "low_ns", "high_ns", "error", "order",
                                 "holds", "fails", "refusal", "limits"});
    for (const KernelReport& report : reports) {
        const Kernel& kernel = *report.kernel;
        for (const MethodRow& row : report.rows) {
            const auto order = report.order(row.method);
            text += csv_line(
                {kernel.id, kernel.sweeps[report.sweep].id, format_number(report.value),
                 report.method(row).id, report.setting(row).english(), row.in_use ? "yes" : "no",
                 format_number(kernel.choice.tolerance), format_number(row.timing.median),
                 format_number(row.timing.low), format_number(row.timing.high),
                 row.result.rejected() ? "" : format_number(row.result.error),
                 order ? format_number(*order) : "", row.holds ? "yes" : "no",
                 failing_summary(kernel, row, SweepName::id).english(),
                 row.result.rejection.english(), report.method(row).limits.english});
        }
    }
    return text;
}

}  // namespace ravnoves::methods
