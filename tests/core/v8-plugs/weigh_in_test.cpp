#include "v8-plugs/weigh_in.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>

#include "support.h"

namespace ravnoves::v8_plugs {
namespace {

using test::gram;
using test::Workshop;

// Sanitizers and builds for the debugger are not what the user waits for.
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
constexpr double slow_build = 1.0;
#else
constexpr double slow_build = 20.0;
#endif

using Pins = std::vector<std::array<int, 2>>;

Pins pins_of(std::size_t n) {
    Pins pins;
    for (std::size_t k = 0; k < n / 2; ++k) {
        pins.push_back({static_cast<int>(k), static_cast<int>(k + n / 2)});
    }
    return pins;
}

/// Every permutation of the pistons with every permutation of the rods.
double brute_force(const std::vector<double>& pistons, const std::vector<double>& rods,
                   const Pins& pins) {
    const std::size_t n = pistons.size();
    Assignment assignment;
    assignment.pistons.resize(n);
    assignment.rods.resize(n);
    double best = std::numeric_limits<double>::infinity();
    std::iota(assignment.pistons.begin(), assignment.pistons.end(), 0);
    do {
        std::iota(assignment.rods.begin(), assignment.rods.end(), 0);
        do {
            best = std::min(best, assignment_spread(pistons, rods, pins, assignment));
        } while (std::next_permutation(assignment.rods.begin(), assignment.rods.end()));
    } while (std::next_permutation(assignment.pistons.begin(), assignment.pistons.end()));
    return best;
}

bool is_permutation_of_cylinders(std::vector<int> from) {
    std::sort(from.begin(), from.end());
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (from[i] != static_cast<int>(i)) {
            return false;
        }
    }
    return true;
}

TEST(BestAssignment, EqualsBruteForceOnSmallCases) {
    Workshop workshop(5);
    for (const std::size_t n : {2U, 4U, 6U}) {
        const Pins pins = pins_of(n);
        for (int round = 0; round < (n == 6 ? 12 : 100); ++round) {
            auto pistons = workshop.contributions(n);
            auto rods = workshop.contributions(n);
            if (round % 3 == 0) {  // coarse masses: many ties
                for (double& mass : pistons) {
                    mass = std::round(mass / gram / 5) * 5 * gram;
                }
            }
            const Assignment best = best_assignment(pistons, rods, pins);
            EXPECT_TRUE(is_permutation_of_cylinders(best.pistons));
            EXPECT_TRUE(is_permutation_of_cylinders(best.rods));
            EXPECT_NEAR(best.spread, brute_force(pistons, rods, pins), 1e-15);
            EXPECT_DOUBLE_EQ(best.spread, assignment_spread(pistons, rods, pins, best));
        }
    }
}

TEST(BestAssignment, BeatsTenThousandRandomOnesOnEightCylinders) {
    Workshop workshop(6);
    const Pins pins = pins_of(8);
    for (int round = 0; round < 5; ++round) {
        const auto pistons = workshop.contributions(8);
        const auto rods = workshop.contributions(8);
        const Assignment best = best_assignment(pistons, rods, pins);
        Assignment random = best;
        for (int trial = 0; trial < 10000; ++trial) {
            std::shuffle(random.pistons.begin(), random.pistons.end(), workshop.generator());
            std::shuffle(random.rods.begin(), random.rods.end(), workshop.generator());
            ASSERT_LE(best.spread, assignment_spread(pistons, rods, pins, random) + 1e-15);
        }
    }
}

TEST(BestAssignment, TakesLessThanFiftyMillisecondsOnEightCylinders) {
    // Time of this program alone, whatever else the machine does. Masses to the gram tie the most.
    const Pins pins = pins_of(8);
    for (const bool coarse : {false, true}) {
        Workshop workshop(8);
        auto pistons = workshop.contributions(8);
        auto rods = workshop.contributions(8);
        if (coarse) {
            for (auto* masses : {&pistons, &rods}) {
                for (double& mass : *masses) {
                    mass = std::round(mass / gram / 10) * 10 * gram;
                }
            }
        }
        double best = 1e9;
        for (int round = 0; round < 5; ++round) {
            const std::clock_t begin = std::clock();
            const Assignment found = best_assignment(pistons, rods, pins);
            best =
                std::min(best, 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
            EXPECT_GE(found.spread, 0.0);
        }
        EXPECT_LT(best, 50.0 * slow_build) << "ms, coarse " << coarse;
    }
}

TEST(BestAssignment, LeavesPartsThatAreWellPlaced) {
    const Pins pins = pins_of(8);
    const std::vector<double> equal(8, 0.5);
    Assignment best = best_assignment(equal, equal, pins);
    EXPECT_EQ(best.moved, 0);
    EXPECT_EQ(best.spread, 0.0);
    // One heavy and one light piston on different crankpins: it takes two moves, not more.
    std::vector<double> pistons(8, 0.5);
    pistons[0] += 2 * gram;
    pistons[1] -= 2 * gram;
    best = best_assignment(pistons, equal, pins);
    EXPECT_NEAR(best.spread, 0.0, 1e-15);
    EXPECT_EQ(best.moved, 2);
    // All pistons but two alike, so that very many matches tie.
    std::vector<double> rods(8, 0.25);
    rods[3] += 1 * gram;
    best = best_assignment(equal, rods, pins);
    EXPECT_EQ(best.moved, 0);
}

WeighIn random_sheet(Workshop& workshop) {
    WeighIn sheet;
    for (const Part part : all_parts) {
        PartColumn& column = sheet[part];
        column.nominal = workshop.between(50, 900) * gram;
        for (auto& mass : column.mass) {
            mass = *column.nominal + workshop.between(-2, 6) * gram;
        }
    }
    sheet.numbering = workshop.between(0, 1) < 0.5 ? CylinderNumbering::bank_by_bank
                                                   : CylinderNumbering::alternating;
    return sheet;
}

TEST(WeighInSheet, MeanOfTheCrankpinsIsTheMethodsExcess) {
    Workshop workshop(7);
    for (int round = 0; round < 500; ++round) {
        const WeighIn sheet = random_sheet(workshop);
        const Process process = workshop.process();
        const double k = workshop.between(0, 1);
        const double excess = unbalanced_mass(process, mass_changes(sheet, process), k);
        const auto by_crankpin = crankpin_excess(sheet, process, k);
        EXPECT_NEAR(std::accumulate(by_crankpin.begin(), by_crankpin.end(), 0.0) / crankpin_count,
                    excess, 1e-12);
        // Moving parts keeps the mean and makes the crankpins no less equal.
        const Assignment best = best_assignment(sheet, process, k).value();
        const auto after = crankpin_excess(reassigned(sheet, best), process, k);
        EXPECT_NEAR(std::accumulate(after.begin(), after.end(), 0.0) / crankpin_count, excess,
                    1e-12);
        const auto spread = [](const auto& totals) {
            const auto [least, most] = std::minmax_element(totals.begin(), totals.end());
            return *most - *least;
        };
        EXPECT_NEAR(spread(after), best.spread, 1e-12);
        EXPECT_LE(spread(after), spread(by_crankpin) + 1e-15);
    }
}

TEST(WeighInSheet, NominalMassesOfTheGearFollowFromTheParts) {
    WeighIn sheet;
    EXPECT_FALSE(nominal_rotating(sheet));
    double grams = 100.0;
    for (const Part part : all_parts) {
        sheet[part].nominal = (grams += 100.0) * gram;  // 200, 300, … 700
    }
    EXPECT_NEAR(*nominal_reciprocating(sheet), (200 + 300 + 400 + 600) * gram, 1e-12);
    EXPECT_NEAR(*nominal_rotating(sheet), (500 + 700) * gram, 1e-12);
    sheet[Part::rings].nominal.reset();
    EXPECT_FALSE(nominal_reciprocating(sheet));
    EXPECT_TRUE(nominal_rotating(sheet));
}

TEST(WeighInSheet, KilogramsAreNoticed) {
    PartColumn column;
    EXPECT_FALSE(mass_in_kilograms(Part::piston, column));
    column.mass[3] = 568.2 * gram;
    column.nominal = 560 * gram;
    EXPECT_FALSE(mass_in_kilograms(Part::piston, column));
    column.mass[2] = 0.5682 * gram;
    EXPECT_EQ(mass_in_kilograms(Part::piston, column), column.mass[2]);
    column.mass[2].reset();
    column.nominal = 5.6 * gram;  // a hundredth of the mass
    EXPECT_EQ(mass_in_kilograms(Part::piston, column), column.nominal);
    EXPECT_FALSE(mass_in_kilograms(Part::rings, PartColumn{3 * gram, {}, {}}));
}

TEST(WeighInSheet, StatisticsOfAColumn) {
    PartColumn column;
    EXPECT_FALSE(statistics(column));
    column.mass[2] = 500 * gram;
    column.mass[5] = 503 * gram;
    column.permitted_spread = 3 * gram;
    auto s = statistics(column);
    ASSERT_TRUE(s);
    EXPECT_EQ(s->count, 2);
    EXPECT_DOUBLE_EQ(s->mean, 501.5 * gram);
    EXPECT_NEAR(s->spread, 3 * gram, 1e-15);
    EXPECT_EQ(s->heaviest, 5);
    EXPECT_EQ(s->lightest, 2);
    EXPECT_TRUE(s->within_permitted);
    column.mass[0] = 499.9 * gram;
    EXPECT_FALSE(statistics(column)->within_permitted);
    EXPECT_FALSE(column.is_complete());
}

TEST(WeighInSheet, HeavierByAHandfulOfGramsByHand) {
    WeighIn sheet;
    const auto fill = [&](Part part, double nominal_g, double more_g) {
        sheet[part].nominal = nominal_g * gram;
        sheet[part].mass.fill((nominal_g + more_g) * gram);
    };
    fill(Part::piston, 600, 1.5);
    fill(Part::rings, 60, 0.5);
    fill(Part::pin, 150, 0.25);
    fill(Part::rod_small_end, 250, 0.25);
    fill(Part::rod_big_end, 700, 0.5);
    fill(Part::shells, 80, 0.55);
    const MassChanges repair = mass_changes(sheet, Process::repair);
    EXPECT_NEAR(repair.repair_piston_and_rings / gram, 2.0, 1e-9);
    EXPECT_NEAR(repair.piston / gram, 0.5, 1e-9);
    EXPECT_NEAR(repair.rod_big_end / gram, 0.5, 1e-9);
    EXPECT_NEAR(repair.repair_bearing / gram, 1.1, 1e-9);  // shells of two rods on a crankpin
    const MassChanges manufacture = mass_changes(sheet, Process::manufacture);
    EXPECT_NEAR(manufacture.piston / gram, 2.5, 1e-9);
    EXPECT_EQ(manufacture.repair_bearing, 0.0);
    EXPECT_EQ(manufacture.repair_piston_and_rings, 0.0);
}

TEST(WeighInSheet, WhatIsNotWeighedStaysAsTyped) {
    const MassChanges typed{1 * gram, 2 * gram, 3 * gram, 4 * gram};
    for (const Process process : {Process::manufacture, Process::repair}) {
        EXPECT_EQ(mass_changes({}, process, typed), typed);
        for (const Part part : all_parts) {
            WeighIn sheet;
            sheet[part].nominal = 500 * gram;
            sheet[part].mass.fill(500.5 * gram);
            const double MassChanges::*changes[] = {&MassChanges::piston, &MassChanges::rod_big_end,
                                                    &MassChanges::repair_piston_and_rings,
                                                    &MassChanges::repair_bearing};
            for (const auto change : changes) {
                const double weighed = mass_changes(sheet, process).*change;
                const double found = mass_changes(sheet, process, typed).*change;
                EXPECT_EQ(found, weighed != 0.0 ? weighed : typed.*change);
            }
            sheet[part].mass[3].reset();
            EXPECT_EQ(mass_changes(sheet, process, typed), typed) << "one is missing";
        }
    }
}

TEST(WeighInSheet, CrankpinsOfBothNumberings) {
    EXPECT_EQ(crankpins(CylinderNumbering::bank_by_bank)[1], (std::array<int, 2>{1, 5}));
    EXPECT_EQ(crankpins(CylinderNumbering::alternating)[1], (std::array<int, 2>{2, 3}));
}

}  // namespace
}  // namespace ravnoves::v8_plugs
