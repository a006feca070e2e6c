#include "v8-plugs/weigh_in.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "numerics/demand.h"
#include "workshop/kilograms.h"

namespace ravnoves::v8_plugs {

namespace {

using Pair = std::array<int, 2>;
using Pairing = std::vector<Pair>;

constexpr std::size_t most_pairs = crankpin_count;

/// All ways to split 0…n−1 into pairs.
std::vector<Pairing> all_pairings(int n) {
    std::vector<Pairing> pairings;
    Pairing current;
    std::vector<bool> used(static_cast<std::size_t>(n), false);
    const auto extend = [&](const auto& self, int first) -> void {
        while (first < n && used[static_cast<std::size_t>(first)]) {
            ++first;
        }
        if (first == n) {
            pairings.push_back(current);
            return;
        }
        used[static_cast<std::size_t>(first)] = true;
        for (int second = first + 1; second < n; ++second) {
            if (used[static_cast<std::size_t>(second)]) {
                continue;
            }
            used[static_cast<std::size_t>(second)] = true;
            current.push_back({first, second});
            self(self, first + 1);
            current.pop_back();
            used[static_cast<std::size_t>(second)] = false;
        }
        used[static_cast<std::size_t>(first)] = false;
    };
    extend(extend, 0);
    return pairings;
}

/// A pairing of sets of known contributions, ready to be matched.
struct Candidate {
    std::array<double, most_pairs> total{};   // of each pair, as in the pairing
    std::array<double, most_pairs> sorted{};  // the same, ascending
    // moves[p][k]: sets that change their place when pair p goes to crankpin k
    std::array<std::array<int, most_pairs>, most_pairs> moves{};
};

/// Sets of the pair that move when it goes to the crankpin, in the better of the two orders.
int moves_of(const Pair& pair, const Pair& crankpin) {
    const int straight = (pair[0] != crankpin[0] ? 1 : 0) + (pair[1] != crankpin[1] ? 1 : 0);
    const int crossed = (pair[1] != crankpin[0] ? 1 : 0) + (pair[0] != crankpin[1] ? 1 : 0);
    return std::min(straight, crossed);
}

void place(const Pair& pair, const Pair& crankpin, std::vector<int>& target) {
    const bool crossed = (pair[0] != crankpin[0] ? 1 : 0) + (pair[1] != crankpin[1] ? 1 : 0) >
                         (pair[1] != crankpin[0] ? 1 : 0) + (pair[0] != crankpin[1] ? 1 : 0);
    target[static_cast<std::size_t>(crankpin[0])] = pair[crossed ? 1 : 0];
    target[static_cast<std::size_t>(crankpin[1])] = pair[crossed ? 0 : 1];
}

std::vector<Candidate> candidates(const std::vector<Pairing>& pairings,
                                  const std::vector<double>& contribution,
                                  const std::vector<Pair>& crankpins) {
    std::vector<Candidate> list;
    list.reserve(pairings.size());
    for (const Pairing& pairing : pairings) {
        Candidate candidate;
        for (std::size_t p = 0; p < pairing.size(); ++p) {
            candidate.total[p] = contribution[static_cast<std::size_t>(pairing[p][0])] +
                                 contribution[static_cast<std::size_t>(pairing[p][1])];
            for (std::size_t k = 0; k < crankpins.size(); ++k) {
                candidate.moves[p][k] = moves_of(pairing[p], crankpins[k]);
            }
        }
        candidate.sorted.fill(std::numeric_limits<double>::infinity());  // unused pairs stay last
        std::copy_n(candidate.total.begin(), pairing.size(), candidate.sorted.begin());
        std::sort(candidate.sorted.begin(), candidate.sorted.end());
        list.push_back(candidate);
    }
    return list;
}

std::vector<std::array<std::size_t, most_pairs>> permutations(std::size_t m) {
    std::array<std::size_t, most_pairs> order{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<std::array<std::size_t, most_pairs>> all;
    do {
        all.push_back(order);
    } while (std::next_permutation(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(m)));
    return all;
}

double column_deviation(const PartColumn& column, int cylinder) {
    return column.is_complete() ? *column.mass[static_cast<std::size_t>(cylinder)] - *column.nominal
                                : 0.0;
}

/// What a cylinder's piston with pin and rings adds to its crankpin's excess, kg.
double piston_contribution(const WeighIn& sheet, int cylinder) {
    // Half: the reciprocating mass counts once for a crankpin that carries two of them.
    return 0.5 * (column_deviation(sheet[Part::piston], cylinder) +
                  column_deviation(sheet[Part::pin], cylinder) +
                  column_deviation(sheet[Part::rings], cylinder));
}

/// What a cylinder's rod with its shells adds to its crankpin's excess, kg.
double rod_contribution(const WeighIn& sheet, Process process, double rod_coefficient,
                        int cylinder) {
    const double shells =
        process == Process::repair ? column_deviation(sheet[Part::shells], cylinder) : 0.0;
    return 0.5 * (column_deviation(sheet[Part::rod_small_end], cylinder) +
                  (2.0 + rod_coefficient) * column_deviation(sheet[Part::rod_big_end], cylinder)) +
           shells;
}

double mean_deviation(const PartColumn& column) {
    double sum = 0.0;
    for (int cylinder = 0; cylinder < cylinder_count; ++cylinder) {
        sum += column_deviation(column, cylinder);
    }
    return sum / cylinder_count;
}

}  // namespace

namespace {

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

std::optional<double> mass_in_kilograms(Part part, const PartColumn& column) {
    return workshop::mass_in_kilograms(part, column.nominal, column.mass);
}

Crankpins crankpins(CylinderNumbering numbering) {
    if (numbering == CylinderNumbering::alternating) {
        return {{{0, 1}, {2, 3}, {4, 5}, {6, 7}}};
    }
    return {{{0, 4}, {1, 5}, {2, 6}, {3, 7}}};
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
            return repair ? &MassChanges::repair_bearing : nullptr;
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
        if (change != nullptr && is_weighed(sheet, process, change)) {
            changes.*change = 0.0;
        }
    }
    for (const Part part : all_parts) {
        if (const auto change = change_of(part, process)) {
            const double rods = part == Part::shells ? 2.0 : 1.0;  // shells count by crankpin
            changes.*change += rods * mean_deviation(sheet[part]);
        }
    }
    return changes;
}

std::array<double, crankpin_count> crankpin_excess(const WeighIn& sheet, Process process,
                                                   double rod_coefficient) {
    std::array<double, crankpin_count> excess{};
    const Crankpins pins = crankpins(sheet.numbering);
    for (std::size_t k = 0; k < pins.size(); ++k) {
        for (const int cylinder : pins[k]) {
            excess[k] += piston_contribution(sheet, cylinder) +
                         rod_contribution(sheet, process, rod_coefficient, cylinder);
        }
    }
    return excess;
}

double spread(const std::array<double, crankpin_count>& totals) {
    const auto [least, most] = std::minmax_element(totals.begin(), totals.end());
    return *most - *least;
}

double assignment_spread(const std::vector<double>& pistons, const std::vector<double>& rods,
                         const std::vector<std::array<int, 2>>& crankpins,
                         const Assignment& assignment) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const auto& crankpin : crankpins) {
        double total = 0.0;
        for (const int position : crankpin) {
            const auto at = static_cast<std::size_t>(position);
            total += pistons[static_cast<std::size_t>(assignment.pistons[at])] +
                     rods[static_cast<std::size_t>(assignment.rods[at])];
        }
        least = std::min(least, total);
        most = std::max(most, total);
    }
    return most - least;
}

Assignment best_assignment(const std::vector<double>& pistons, const std::vector<double>& rods,
                           const std::vector<std::array<int, 2>>& crankpins) {
    const std::size_t m = crankpins.size();
    RAVNOVES_DEMAND(
        m >= 1 && m <= most_pairs && pistons.size() == 2 * m && rods.size() == 2 * m,
        "each crankpin has two pistons and two rods, and there are one to most_pairs of them");
    const std::vector<Pairing> pairings = all_pairings(static_cast<int>(2 * m));
    const std::vector<Candidate> piston_pairs = candidates(pairings, pistons, crankpins);
    const std::vector<Candidate> rod_pairs = candidates(pairings, rods, crankpins);

    double best = std::numeric_limits<double>::infinity();
    const auto matched_spread = [m](const Candidate& a, const Candidate& b) {
        double least = a.sorted[0] + b.sorted[m - 1];
        double most = least;
        for (std::size_t i = 1; i < m; ++i) {
            const double total = a.sorted[i] + b.sorted[m - 1 - i];
            least = std::min(least, total);
            most = std::max(most, total);
        }
        return most - least;
    };
    double scale = 0.0;
    for (std::size_t i = 0; i < 2 * m; ++i) {
        scale = std::max({scale, std::abs(pistons[i]), std::abs(rods[i])});
    }
    for (const Candidate& a : piston_pairs) {
        for (const Candidate& b : rod_pairs) {
            best = std::min(best, matched_spread(a, b));
        }
    }

    // Among the matches of that spread (to rounding), the one that moves the fewest sets.
    const double limit = best + 1e-14 * scale;
    const auto orders = permutations(m);
    Assignment assignment;
    assignment.moved = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < pairings.size() && assignment.moved > 0; ++i) {
        for (std::size_t j = 0; j < pairings.size() && assignment.moved > 0; ++j) {
            const Candidate& a = piston_pairs[i];
            const Candidate& b = rod_pairs[j];
            if (matched_spread(a, b) > limit) {
                continue;
            }
            for (const auto& match : orders) {  // piston pair p with rod pair match[p]
                double least = std::numeric_limits<double>::infinity();
                double most = -least;
                for (std::size_t p = 0; p < m; ++p) {
                    const double total = a.total[p] + b.total[match[p]];
                    least = std::min(least, total);
                    most = std::max(most, total);
                }
                if (most - least > limit) {
                    continue;
                }
                for (const auto& pin : orders) {  // piston pair p on crankpin pin[p]
                    int moved = 0;
                    for (std::size_t p = 0; p < m; ++p) {
                        moved += a.moves[p][pin[p]] + b.moves[match[p]][pin[p]];
                    }
                    if (moved >= assignment.moved) {
                        continue;
                    }
                    assignment.moved = moved;
                    assignment.pistons.assign(2 * m, 0);
                    assignment.rods.assign(2 * m, 0);
                    for (std::size_t p = 0; p < m; ++p) {
                        place(pairings[i][p], crankpins[pin[p]], assignment.pistons);
                        place(pairings[j][match[p]], crankpins[pin[p]], assignment.rods);
                    }
                }
            }
        }
    }
    assignment.spread = assignment_spread(pistons, rods, crankpins, assignment);
    return assignment;
}

std::optional<Assignment> best_assignment(const WeighIn& sheet, Process process,
                                          double rod_coefficient) {
    if (!sheet.is_counted()) {
        return std::nullopt;
    }
    std::vector<double> pistons;
    std::vector<double> rods;
    for (int cylinder = 0; cylinder < cylinder_count; ++cylinder) {
        pistons.push_back(piston_contribution(sheet, cylinder));
        rods.push_back(rod_contribution(sheet, process, rod_coefficient, cylinder));
    }
    const Crankpins pins = crankpins(sheet.numbering);
    return best_assignment(pistons, rods, {pins.begin(), pins.end()});
}

WeighIn reassigned(const WeighIn& sheet, const Assignment& assignment) {
    WeighIn moved = sheet;
    for (const Part part : all_parts) {
        const bool with_piston = part == Part::piston || part == Part::pin || part == Part::rings;
        const std::vector<int>& from = with_piston ? assignment.pistons : assignment.rods;
        for (std::size_t i = 0; i < from.size(); ++i) {
            moved[part].mass[i] = sheet[part].mass[static_cast<std::size_t>(from[i])];
        }
    }
    for (std::size_t i = 0; i < cylinder_count; ++i) {
        moved.piston_sets[i] = sheet.piston_sets[static_cast<std::size_t>(assignment.pistons[i])];
        moved.rod_sets[i] = sheet.rod_sets[static_cast<std::size_t>(assignment.rods[i])];
    }
    return moved;
}

}  // namespace ravnoves::v8_plugs
