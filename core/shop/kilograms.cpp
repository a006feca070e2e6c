#include "shop/kilograms.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace ravnoves::shop {

namespace {

/// No such part of a car or truck weighs less, kg; in kilograms each does.
double min_mass(Part part) {
    return (part == Part::rings || part == Part::shells ? 2.0 : 5.0) * units::gram;
}

}  // namespace

std::optional<double> mass_in_kilograms(Part part, const std::optional<double>& nominal,
                                        std::span<const Weighed> masses) {
    const double minimum = min_mass(part);
    if (nominal && *nominal < minimum) {
        return nominal;
    }
    for (const Weighed& mass : masses) {
        if (!mass || *mass == 0.0) {
            continue;
        }
        if (*mass < minimum || (nominal && *mass <= 0.01 * *nominal)) {
            return mass;
        }
        if (nominal && *nominal <= 0.01 * *mass) {
            return nominal;
        }
    }
    return std::nullopt;
}

namespace {

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// The usual scatter of masses: as a standard deviation, from the median of the distances, which no
/// slip among them moves.
double robust_scatter(std::vector<double> masses, double middle) {
    constexpr double of_normal = 1.4826;  // σ over the median of |x − μ|
    for (double& mass : masses) {
        mass = std::abs(mass - middle);
    }
    return of_normal * median(std::move(masses));
}

}  // namespace

std::vector<std::size_t> OddMass::cylinders() const {
    std::vector<std::size_t> all = also;
    all.insert(std::upper_bound(all.begin(), all.end(), cylinder), cylinder);
    return all;
}

std::optional<OddMass> odd_mass(const PartColumn& column) {
    const auto& nominal = column.nominal;
    const auto& masses = column.mass;
    std::optional<OddMass> found;
    double farthest = 0.0;
    std::vector<std::size_t> odd;
    std::vector<OddMass> scattered;  // within the tenth, but far beyond the others' scatter
    for (std::size_t i = 0; i < masses.size(); ++i) {
        std::vector<double> others;
        for (std::size_t k = 0; k < masses.size(); ++k) {
            if (k != i && masses[k] && *masses[k] > 0.0) {
                others.push_back(*masses[k]);
            }
        }
        if (!masses[i] || !(*masses[i] > 0.0) || others.empty()) {
            continue;
        }
        const double usual = median(others);
        const double maximum = others.size() < 3 ? 3.0 : 1.1;
        const double away = std::abs(std::log(*masses[i] / usual));
        constexpr double min_scatter = 1e-4;  // of a mass: what scales read
        constexpr double rounding = 1e-9;
        constexpr double min_away = 0.01;
        const double off = std::abs(*masses[i] - usual);
        std::optional<double> score;
        if (others.size() >= 3) {
            score = off / std::max(robust_scatter(others, usual), min_scatter * usual);
        }
        if (away <= std::log(maximum)) {
            // What the shop permits is no slip, however equal the others are.
            if (score && *score > max_score && away > min_away &&
                off > column.permitted_spread.value_or(0.0) + rounding) {
                scattered.push_back({i, *masses[i], usual, score, {}, true});
            }
            continue;
        }
        odd.push_back(i);
        // Of two both are as far from each other: the nominal mass says which is right.
        const double tie = others.size() > 1 ? 0.0
                           : nominal && *nominal > 0.0
                               ? 1e-3 * std::abs(std::log(*masses[i] / *nominal))
                               : 1e-3 * (*masses[i] > usual ? 1.0 : 0.0);
        if (away + tie > farthest) {
            farthest = away + tie;
            found = OddMass{i, *masses[i], usual, score};
        }
    }
    const auto weighed = std::count_if(masses.begin(), masses.end(),
                                       [](const Weighed& mass) { return mass && *mass > 0.0; });
    // Parts of another make differ by less from the others; more than a third of them are another
    // kind, and no slips.
    constexpr double min_repeated = 0.03;
    if (scattered.size() > 1) {
        std::erase_if(scattered, [](const OddMass& each) {
            return std::abs(std::log(each.mass / each.usual)) <= min_repeated;
        });
    }
    if (!found && 3 * std::ssize(scattered) <= weighed) {
        for (const OddMass& each : scattered) {
            odd.push_back(each.cylinder);
            if (!found || *each.score > *found->score) {
                found = each;
            }
        }
    }
    if (found && weighed > 3) {
        std::erase(odd, found->cylinder);
        found->also = std::move(odd);
    }
    return found;
}

std::vector<std::size_t> swapped_rod_ends(std::span<const Weighed> big_ends,
                                          std::span<const Weighed> small_ends) {
    std::vector<std::size_t> swapped;
    for (std::size_t i = 0; i < std::min(big_ends.size(), small_ends.size()); ++i) {
        if (big_ends[i] && *big_ends[i] > 0.0 && small_ends[i] && *small_ends[i] > *big_ends[i]) {
            swapped.push_back(i);
        }
    }
    return swapped;
}

}  // namespace ravnoves::shop
