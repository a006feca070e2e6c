#include "v8-plugs/weigh_in.h"

#include <algorithm>

#include "numerics/constants.h"

namespace ravnoves::v8_plugs {

namespace {

double mean_deviation(const PartColumn& column) {
    double sum = 0.0;
    if (column.is_complete()) {
        for (const shop::Weighed& mass : column.mass) {
            sum += *mass - *column.nominal;
        }
    }
    return sum / cylinder_count;
}

std::optional<double> nominal_sum(const WeighIn& sheet, std::initializer_list<Part> parts) {
    double sum = 0.0;
    for (const Part part : parts) {
        if (!sheet[part].nominal) {
            return std::nullopt;
        }
        sum += *sheet[part].nominal;
    }
    return sum;
}

}  // namespace

std::optional<double> nominal_reciprocating(const WeighIn& sheet) {
    return nominal_sum(sheet, {Part::piston, Part::pin, Part::rings, Part::rod_small_end});
}

std::optional<double> nominal_rotating(const WeighIn& sheet) {
    return nominal_sum(sheet, {Part::rod_big_end, Part::shells});
}

double MassChanges::*change_of(Part part, Process process) {
    const bool is_renewed = part == Part::piston || part == Part::rings;
    return part == Part::rod_big_end                  ? &MassChanges::rod_big_end
           : part == Part::shells                     ? &MassChanges::repair_bearing
           : is_renewed && process == Process::repair ? &MassChanges::repair_piston_and_rings
                                                      : &MassChanges::piston;
}

bool is_weighed(const WeighIn& sheet, Process process, double MassChanges::*change) {
    return std::any_of(all_parts.begin(), all_parts.end(), [&](Part part) {
        return change_of(part, process) == change && sheet[part].is_complete();
    });
}

MassChanges mass_changes(const WeighIn& sheet, Process process, const MassChanges& typed) {
    MassChanges changes = typed;
    for (const Part part : all_parts) {
        const auto change = change_of(part, process);
        if (is_weighed(sheet, process, change)) {
            changes.*change = 0.0;
        }
    }
    for (const Part part : all_parts) {
        const double rods = part == Part::shells ? 2.0 : 1.0;  // shells count by crankpin
        changes.*change_of(part, process) += rods * mean_deviation(sheet[part]);
    }
    return changes;
}

shop::PartFactors excess_factors(const WeighIn& sheet, double rod_coefficient) {
    // Half of what reciprocates: it counts once for a crankpin that carries two of them.
    shop::PartFactors factors{0.5, 0.5, 0.5, 0.5, 0.5 * (2.0 + rod_coefficient), 1.0};
    for (const Part part : all_parts) {
        if (!sheet[part].is_complete()) {
            factors[static_cast<std::size_t>(part)] = 0.0;
        }
    }
    return factors;
}

}  // namespace ravnoves::v8_plugs
