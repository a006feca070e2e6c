#include "v8-plugs/weigh_in.h"

#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "shop/kilograms.h"
#include "shop/matching.h"
#include "support.h"
#include "v8-plugs/presets.h"
#include "v8-plugs/solver.h"

namespace ravnoves::v8_plugs {
namespace {

using test::gram;
using test::Workshop;

WeighIn random_sheet(Workshop& workshop) {
    WeighIn sheet;
    for (const Part part : all_parts) {
        PartColumn& column = sheet[part];
        column.nominal = workshop.between(50, 900) * gram;
        column.mass.resize(8);
        for (auto& mass : column.mass) {
            mass = *column.nominal + workshop.between(-2, 6) * gram;
        }
    }
    sheet.numbering = workshop.between(0, 1) < 0.5 ? CylinderNumbering::bank_by_bank
                                                   : CylinderNumbering::alternating;
    return sheet;
}

shop::Crank crank_of(const WeighIn& sheet) {
    shop::Crank crank;
    crank.cylinders = 8;
    crank.bank_angle = 90 * degree;
    crank.follow(sheet);
    return crank;
}

TEST(WeighInSheet, MeanOfTheCrankpinsIsTheMethodsExcess) {
    Workshop workshop(7);
    for (int round = 0; round < 60; ++round) {
        const WeighIn sheet = random_sheet(workshop);
        const Process process = workshop.process();
        const double k = workshop.between(0, 1);
        const double excess = unbalanced_mass(mass_changes(sheet, process), k);
        const auto factors = excess_factors(sheet, k);
        // By hand, where the parts are; the placing gives each crankpin less their mean.
        const shop::MatchingTask task{sheet, crank_of(sheet), factors};
        const auto places = places_of(task.crank);
        std::array<double, 4> by_crankpin{};
        for (std::size_t i = 0; i < cylinder_count; ++i) {
            for (const Part part : all_parts) {
                by_crankpin.at(static_cast<std::size_t>(places[i].crankpin)) +=
                    factors.at(static_cast<std::size_t>(part)) *
                    (*sheet[part].mass[i] - *sheet[part].nominal);
            }
        }
        const shop::Placed placed = shop::match(task)->before;
        for (std::size_t pin = 0; pin < 4; ++pin) {
            EXPECT_NEAR(excess + placed.crankpins[pin], by_crankpin.at(pin), 1e-12);
        }
    }
}

// All parts weighed: two rods turn, one of two pistons counts, and no coefficient stands for a
// part.
TEST(WeighInSheet, WeighedSmallEndsReplaceTheRodCoefficient) {
    Workshop workshop(19);
    for (int round = 0; round < 60; ++round) {
        Input input;
        input.process = workshop.process();
        input.engine = *find_preset("4.25 l");
        input.changes_from_weigh_in = true;
        input.weigh_in = random_sheet(workshop);
        double expected = 0.0;
        for (const Part part : all_parts) {
            const bool turns = part == Part::rod_big_end || part == Part::shells;
            for (const auto& mass : (*input.weigh_in)[part].mass) {
                expected += (turns ? 2.0 : 1.0) * (*mass - *(*input.weigh_in)[part].nominal) / 8.0;
            }
        }
        EXPECT_NEAR(solve(input).unbalanced_mass.value(), expected, 1e-12);
        (*input.weigh_in)[Part::rod_small_end].mass.front().reset();
        EXPECT_EQ(input.rod_coefficient(), input.engine.rod_coefficient);
    }
}

TEST(WeighInSheet, NominalMassesOfTheGearFollowFromTheParts) {
    WeighIn sheet;
    EXPECT_FALSE(nominal_rotating(sheet));
    double grams = 100.0;
    for (const Part part : all_parts) {
        sheet[part].nominal = (grams += 100.0) * gram;  // 200, 300, … 700
    }
    EXPECT_NEAR(*nominal_reciprocating(sheet), (200 + 300 + 400 + 500) * gram, 1e-12);
    EXPECT_NEAR(*nominal_rotating(sheet), (600 + 700) * gram, 1e-12);
    sheet[Part::rings].nominal.reset();
    EXPECT_FALSE(nominal_reciprocating(sheet));
    EXPECT_TRUE(nominal_rotating(sheet));
}

TEST(WeighInSheet, KilogramsAreNoticed) {
    PartColumn column;
    column.mass.resize(8);
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

TEST(WeighInSheet, AMassUnlikeTheOthersIsFound) {
    using shop::Weighed;
    const auto odd_mass = [](Weighed nominal, const std::vector<Weighed>& masses,
                             Weighed permitted = {}) {
        return shop::odd_mass({nominal, permitted, masses});
    };
    const auto grams = [](std::initializer_list<double> values) {
        std::vector<Weighed> masses;
        for (const double value : values) {
            masses.push_back(value > 0.0 ? Weighed(value * gram) : Weighed());
        }
        return masses;
    };
    EXPECT_FALSE(odd_mass({}, grams({})));
    EXPECT_FALSE(odd_mass({}, grams({584, 0, 0})));
    EXPECT_FALSE(odd_mass({}, grams({584, 600, 400, 0})));
    const auto heavy = odd_mass({}, grams({584, 583, 5840, 585}));
    ASSERT_TRUE(heavy);
    EXPECT_EQ(heavy->cylinder, 2U);
    EXPECT_NEAR(heavy->mass, 5840 * gram, 1e-12);
    EXPECT_NEAR(heavy->usual, 584 * gram, 1e-12);
    EXPECT_EQ(odd_mass({}, grams({58.4, 583, 584, 0}))->cylinder, 0U);
    // Of four and more the others agree to a few percent.
    EXPECT_EQ(odd_mass({}, grams({587, 688.1, 585, 590}))->cylinder, 1U);
    EXPECT_NEAR(odd_mass({}, grams({570, 571, 5700, 569, 570.4}))->usual, 0.5702, 1e-12);
    EXPECT_FALSE(odd_mass({}, grams({587, 612, 585, 560})));
    // One of eight, 30 g heavier than seven within 6 g: no tenth, but far beyond their scatter.
    const auto one = odd_mass({}, grams({600, 602, 604, 606, 601, 633, 603, 605}));
    ASSERT_TRUE(one);
    EXPECT_EQ(one->cylinder, 5U);
    EXPECT_NEAR(*one->score, 30 / (1.4826 * 2), 1e-9) << "603 ± 2 g by the medians";
    // The same slip twice, by 5 per cent: both are named. A third that is like them makes a kind.
    EXPECT_EQ(odd_mass({}, grams({600, 602, 634, 606, 601, 633, 603, 605}))->cylinders(),
              (std::vector<std::size_t>{2, 5}));
    EXPECT_EQ(odd_mass({}, grams({600, 602, 633, 601, 632, 603}))->cylinders(),
              (std::vector<std::size_t>{2, 4}));
    EXPECT_FALSE(odd_mass({}, grams({600, 602, 634, 606, 601, 633, 603, 635})));
    EXPECT_FALSE(odd_mass({}, grams({450, 450, 450, 460, 450, 450, 460, 450}))) << "another make";
    // Sets as they come, two kinds of parts, and a scale's last digit are no slips.
    EXPECT_FALSE(odd_mass({}, grams({600, 602, 604, 606, 601, 609, 603, 605})));
    EXPECT_FALSE(odd_mass({}, grams({600, 600.1, 600.2, 600, 620, 620.1, 620, 620.2})));
    EXPECT_FALSE(odd_mass({}, grams({600, 600, 600, 600, 600, 600, 600, 602})));
    // Of seven that do not scatter at all the permitted range decides.
    const auto rings = grams({60, 60, 60, 61, 60, 60, 60, 60});
    EXPECT_TRUE(odd_mass({}, rings));
    EXPECT_TRUE(odd_mass({}, rings, 0.5 * gram));
    EXPECT_FALSE(odd_mass({}, rings, 1.0 * gram));
    EXPECT_FALSE(odd_mass({}, rings, 2.0 * gram));
    EXPECT_TRUE(odd_mass({}, grams({60, 60, 60, 67, 60, 60, 60, 60}), 10 * gram)) << "a tenth";
    // All that are unlike the others, and both kinds where there are two.
    EXPECT_EQ(odd_mass({}, grams({584, 651, 583, 584, 585, 655}))->also,
              std::vector<std::size_t>{1});
    EXPECT_EQ(odd_mass({}, grams({584, 651, 583, 584, 585, 655}))->cylinders(),
              (std::vector<std::size_t>{1, 5}));
    EXPECT_EQ(odd_mass({}, grams({584, 651, 583, 650}))->also.size(), 3U);
    // Of two the nominal mass says which is right.
    EXPECT_EQ(odd_mass(584 * gram, grams({584, 58.4}))->cylinder, 1U);
    EXPECT_EQ(odd_mass(58 * gram, grams({584, 58.4}))->cylinder, 0U);
}

TEST(WeighInSheet, ARodHeavierAtItsSmallEndWasTypedTheWrongWayRound) {
    const std::vector<shop::Weighed> big{431 * gram, 180 * gram, std::nullopt, 430 * gram};
    const std::vector<shop::Weighed> small{180 * gram, 431 * gram, 181 * gram, std::nullopt};
    EXPECT_EQ(shop::swapped_rod_ends(big, small), std::vector<std::size_t>{1});
    EXPECT_TRUE(shop::swapped_rod_ends(big, std::vector<shop::Weighed>{}).empty());
}

TEST(WeighInSheet, StatisticsOfAColumn) {
    PartColumn column;
    column.mass.resize(8);
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
        sheet[part].mass.assign(8, (nominal_g + more_g) * gram);
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
    EXPECT_NEAR(manufacture.repair_bearing / gram, 1.1, 1e-9) << "what is weighed acts";
    EXPECT_EQ(manufacture.repair_piston_and_rings, 0.0);
}

TEST(WeighInSheet, WhatIsNotWeighedStaysAsTyped) {
    const MassChanges typed{1 * gram, 2 * gram, 3 * gram, 4 * gram};
    for (const Process process : {Process::manufacture, Process::repair}) {
        EXPECT_EQ(mass_changes({}, process, typed), typed);
        for (const Part part : all_parts) {
            WeighIn sheet;
            sheet[part].nominal = 500 * gram;
            sheet[part].mass.assign(8, 500.5 * gram);
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

}  // namespace
}  // namespace ravnoves::v8_plugs
