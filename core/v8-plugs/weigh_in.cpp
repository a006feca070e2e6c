#include "v8-plugs/weigh_in.h"

#include <algorithm>

#include "numerics/constants.h"

namespace ravnoves::v8_plugs {

namespace {

double column_deviation(const PartColumn& column, std::size_t cylinder) {
    return column.is_complete() ? *column.mass[cylinder] - *column.nominal : 0.0;
}

double mean_deviation(const PartColumn& column) {
    double sum = 0.0;
    for (std::size_t cylinder = 0; cylinder < cylinder_count; ++cylinder) {
        sum += column_deviation(column, cylinder);
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
    const bool repair = process == Process::repair;
    switch (part) {
        case Part::piston:
        case Part::rings:
            return repair ? &MassChanges::repair_piston_and_rings : &MassChanges::piston;
        case Part::pin:
        case Part::rod_small_end:
            return &MassChanges::piston;
        case Part::rod_big_end:
            return &MassChanges::rod_big_end;
        case Part::shells:
            return &MassChanges::repair_bearing;
    }
    return nullptr;
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

double excess_factor(Part part, double rod_coefficient) {
    switch (part) {
        case Part::piston:
        case Part::pin:
        case Part::rings:
        case Part::rod_small_end:
            // Half: the reciprocating mass counts once for a crankpin that carries two of them.
            return 0.5;
        case Part::rod_big_end:
            return 0.5 * (2.0 + rod_coefficient);
        case Part::shells:
            return 1.0;
    }
    return 0.0;
}

std::array<double, crankpin_count> crankpin_excess(const WeighIn& sheet, double rod_coefficient) {
    std::array<double, crankpin_count> excess{};
    const auto places = places_of(crank_of(sheet));
    for (std::size_t i = 0; i < cylinder_count; ++i) {
        for (const Part part : all_parts) {
            excess.at(static_cast<std::size_t>(places[i].crankpin)) +=
                excess_factor(part, rod_coefficient) * column_deviation(sheet[part], i);
        }
    }
    return excess;
}

double spread(const std::array<double, crankpin_count>& totals) {
    const auto [minimum, maximum] = std::minmax_element(totals.begin(), totals.end());
    return *maximum - *minimum;
}

shop::Crank crank_of(const WeighIn& sheet) {
    shop::Crank crank;
    crank.cylinders = cylinder_count;
    crank.bank_angle = 90.0 * degree;
    crank.angles = {0.0, 90.0 * degree, 270.0 * degree, 180.0 * degree};
    crank.follow(sheet);
    return crank;
}

shop::MatchingTask matching_task(const WeighIn& sheet, double rod_coefficient) {
    std::array<double, 6> factors{};
    for (const Part part : all_parts) {
        if (sheet[part].is_complete()) {
            factors[static_cast<std::size_t>(part)] = excess_factor(part, rod_coefficient);
        }
    }
    return {sheet, crank_of(sheet), factors};
}

}  // namespace ravnoves::v8_plugs
