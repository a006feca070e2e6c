#include "balance-shaft/shaft_bending.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "balance-shaft/relieved_shaft.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {
namespace {

/// A round steel bar.
ShaftPiece round_bar(double length, double diameter, double eccentricity = 0.0) {
    const double area = pi * diameter * diameter / 4.0;
    const double second = pi * std::pow(diameter, 4) / 64.0;
    return {length, 210e9 * second, 7850.0 * area, eccentricity, area, second / (diameter / 2.0)};
}

/// The first root of the frequency equation of a stepped beam on two simple supports, by transfer
/// matrices of the exact solution: another derivation than finite elements.
double whirling_by_transfer(const std::vector<ShaftPiece>& pieces, double from, double to) {
    const auto determinant = [&](double omega) {
        Eigen::Matrix4d whole = Eigen::Matrix4d::Identity();
        for (const ShaftPiece& piece : pieces) {
            // State: deflection, slope, moment, shear, each the derivative of the one before.
            const double ei = piece.stiffness;
            const double k = std::pow(omega * omega * piece.mass / ei, 0.25);
            const double x = k * piece.length;
            const double c0 = (std::cosh(x) + std::cos(x)) / 2.0;
            const double c1 = (std::sinh(x) + std::sin(x)) / (2.0 * k);
            const double c2 = (std::cosh(x) - std::cos(x)) / (2.0 * k * k);
            const double c3 = (std::sinh(x) - std::sin(x)) / (2.0 * k * k * k);
            const double k4 = k * k * k * k;
            Eigen::Matrix4d step;
            step << c0, c1, c2 / ei, c3 / ei,        //
                k4 * c3, c0, c1 / ei, c2 / ei,       //
                k4 * ei * c2, k4 * ei * c3, c0, c1,  //
                k4 * ei * c1, k4 * ei * c2, k4 * c3, c0;
            whole = step * whole;
        }
        // Deflection and moment are 0 at both ends.
        return whole(0, 1) * whole(2, 3) - whole(0, 3) * whole(2, 1);
    };
    const double sign = determinant(from);
    EXPECT_LT(sign * determinant(to), 0.0);
    for (int i = 0; i < 200; ++i) {
        const double middle = (from + to) / 2.0;
        (sign * determinant(middle) > 0.0 ? from : to) = middle;
    }
    return (from + to) / 2.0;
}

TEST(ShaftBending, AnEvenBarHasTheClosedForms) {
    const ShaftPiece bar = round_bar(0.5, 0.04, 0.001);
    const double closed = pi * pi / 0.25 * std::sqrt(bar.stiffness / bar.mass);
    const double weight = bar.mass * standard_gravity;
    for (const double share : {0.02, 0.5, 0.9}) {
        const double omega = share * closed;
        const ShaftBending bending = shaft_bending({bar}, omega);
        EXPECT_NEAR(bending.critical_speed, closed, 1e-6 * closed);
        EXPECT_NEAR(bending.weight_sag, 5.0 * weight * std::pow(0.5, 4) / (384.0 * bar.stiffness),
                    1e-9 * bending.weight_sag);
        // The fourth derivative of w is k⁴ (e + w): from the middle w = e (cosh kx / (2 cosh kL/2)
        // + cos kx / (2 cos kL/2) − 1).
        const double k = std::pow(omega * omega * bar.mass / bar.stiffness, 0.25);
        const double end = k * 0.25;
        const double middle = bar.eccentricity * (0.5 / std::cosh(end) + 0.5 / std::cos(end) - 1.0);
        EXPECT_NEAR(bending.deflection, middle + bending.weight_sag, 1e-5 * bending.deflection);
        const double moment =
            bar.stiffness * bar.eccentricity * k * k * (0.5 / std::cos(end) - 0.5 / std::cosh(end));
        EXPECT_NEAR(bending.bending_stress, (moment + weight * 0.25 / 8.0) / bar.section_modulus,
                    1e-5 * bending.bending_stress);
        const double shear = bar.stiffness * bar.eccentricity * k * k * k *
                             (0.5 * std::tan(end) + 0.5 * std::tanh(end));
        EXPECT_NEAR(bending.bearing_load, shear + weight * 0.25, 1e-5 * bending.bearing_load);
        EXPECT_GE(bending.combined_stress, bending.bending_stress);
    }
    // Far below the whirling speed the static formulas of an even load hold.
    const double slow = 0.01 * closed;
    const ShaftBending bending = shaft_bending({bar}, slow);
    const double load = bar.mass * (bar.eccentricity * slow * slow + standard_gravity);
    EXPECT_NEAR(bending.bearing_load, load * 0.25, 2e-4 * load * 0.25);
    EXPECT_NEAR(bending.journal_slope, load * 0.125 / (24.0 * bar.stiffness),
                2e-4 * bending.journal_slope);
    EXPECT_NEAR(bending.deflection, 5.0 * load * 0.0625 / (384.0 * bar.stiffness),
                2e-4 * bending.deflection);
}

TEST(ShaftBending, SteppedShaftsHaveTheFrequenciesOfTheirTransferMatrices) {
    const std::vector<std::vector<ShaftPiece>> shafts{
        {round_bar(0.2, 0.04), round_bar(0.3, 0.03)},
        {round_bar(0.1, 0.02), round_bar(0.4, 0.05)},
        {round_bar(0.1, 0.05), round_bar(0.3, 0.025), round_bar(0.1, 0.05)},
        {round_bar(0.025, 0.05), round_bar(0.4, 0.04), round_bar(0.025, 0.05)},
    };
    for (const auto& shaft : shafts) {
        const double found = shaft_bending(shaft, 0.0).critical_speed;
        EXPECT_NEAR(found, whirling_by_transfer(shaft, 0.9 * found, 1.1 * found), 3e-6 * found);
    }
}

/// Dunkerley's sum bounds the whirling speed from below, Rayleigh's quotient from above: with a
/// heavy disc in the middle of a light shaft they lie close to one another.
TEST(ShaftBending, ADiscInTheMiddleLiesBetweenDunkerleyAndRayleigh) {
    const ShaftPiece half = round_bar(0.2495, 0.03);
    ShaftPiece disc = round_bar(0.001, 0.03);
    disc.mass = 20.0 / disc.length;
    const double found = shaft_bending({half, disc, half}, 0.0).critical_speed;
    const double of_disc = std::sqrt(48.0 * half.stiffness / (20.0 * 0.125));
    const double of_bar = pi * pi / 0.25 * std::sqrt(half.stiffness / half.mass);
    const double dunkerley = 1.0 / std::sqrt(1.0 / (of_disc * of_disc) + 1.0 / (of_bar * of_bar));
    // The line of a central load: 17/35 of the bar's mass moves with the disc, without what the
    // disc replaces.
    const double moving = 20.0 + half.mass * (17.0 / 35.0 * 0.5 - disc.length);
    const double rayleigh = std::sqrt(48.0 * half.stiffness / (0.125 * moving));
    EXPECT_GT(found, dunkerley * (1.0 - 1e-5));
    EXPECT_LT(found, rayleigh * (1.0 + 1e-5));
    EXPECT_LT((rayleigh - dunkerley) / rayleigh, 0.01);
}

TEST(ShaftBending, FromTheWhirlingSpeedOnThereIsNoLoadToJudge) {
    const ShaftPiece bar = round_bar(0.5, 0.04, 0.001);
    const double critical = shaft_bending({bar}, 0.0).critical_speed;
    const ShaftBending above = shaft_bending({bar}, 1.01 * critical);
    EXPECT_EQ(above.deflection, 0.0);
    EXPECT_EQ(above.bearing_load, 0.0);
    EXPECT_GT(above.weight_sag, 0.0);
    EXPECT_GT(shaft_bending({bar}, 0.999 * critical).deflection, 0.1);
}

// What decides whether a relieved shaft is feasible.

constexpr double needed_unbalance = 0.658 * 0.046;
constexpr double shaft_speed = 376.8;

RelievedShaftSizes good_sizes() {
    return {0.056, std::nullopt, 0.35};
}

TEST(RelievedShaftLimits, LoadsFollowFromTheUnbalance) {
    const RelievedShaft shaft = design_relieved_shaft(good_sizes(), needed_unbalance, shaft_speed);
    ASSERT_TRUE(shaft.feasible) << shaft.reason.english();
    EXPECT_NEAR(shaft.bearing_span, 0.35 + 0.056, 1e-12);
    EXPECT_NEAR(shaft.permitted_sag, shaft.bearing_span / 1200.0, 1e-12);
    // Half of U ω² and of the weight, and a little more for the deflection.
    const double rigid = (needed_unbalance * shaft_speed * shaft_speed + shaft.weight) / 2.0;
    EXPECT_GT(shaft.bending.bearing_load, rigid);
    EXPECT_LT(shaft.bending.bearing_load, 1.03 * rigid);
    EXPECT_GT(shaft.bending.critical_speed, 2.0 * shaft_speed);
    // The relieved part alone is shorter than the shaft.
    EXPECT_GT(shaft.bending.deflection, shaft.sag);
    EXPECT_GT(shaft.bending.bending_stress, shaft.bending_stress);
    // With the bearings at its ends the two agree but for weight and whirl.
    RelievedShaftSizes sizes = good_sizes();
    sizes.bearing_span = 0.35;
    const RelievedShaft alone = design_relieved_shaft(sizes, needed_unbalance, shaft_speed);
    EXPECT_NEAR(alone.bending.deflection, alone.sag, 0.04 * alone.sag);
    EXPECT_NEAR(alone.bending.bending_stress, alone.bending_stress, 0.04 * alone.bending_stress);
}

TEST(RelievedShaftLimits, EachOneDecidesAndSaysWhy) {
    const auto reason = [](const auto& change) {
        RelievedShaftSizes sizes = good_sizes();
        change(sizes);
        const RelievedShaft shaft = design_relieved_shaft(sizes, needed_unbalance, shaft_speed);
        EXPECT_EQ(shaft.feasible, shaft.reason.empty());
        return shaft.reason.english();
    };
    EXPECT_EQ(reason([](RelievedShaftSizes&) {}), "");
    EXPECT_EQ(reason([](RelievedShaftSizes& sizes) { sizes.bearing_span = 0.3; }),
              "The relieved length, 350 mm, does not fit between the bearings, 300 mm apart.");
    const auto begins = [&](const char* words, const auto& change) {
        EXPECT_EQ(reason(change).rfind(words, 0), 0U) << reason(change);
    };
    begins("The shaft whirls at ", [](RelievedShaftSizes& sizes) { sizes.speed_margin = 20.0; });
    begins("The stress, ", [](RelievedShaftSizes& sizes) { sizes.allowable_stress = 10e6; });
    begins("The shaft sags by ", [](RelievedShaftSizes& sizes) { sizes.permitted_sag = 1e-5; });
    begins("A bearing carries ", [](RelievedShaftSizes& sizes) { sizes.bearing_limit = 1500.0; });
    EXPECT_EQ(reason([](RelievedShaftSizes& sizes) { sizes.bearing_limit = 5000.0; }), "");
    // A shaft that has the unbalance and is of no use: one metre between the bearings.
    const std::string useless = reason([](RelievedShaftSizes& sizes) { sizes.bearing_span = 1.0; });
    EXPECT_NE(useless.find("whirls"), std::string::npos) << useless;
    EXPECT_NE(useless.find("sags"), std::string::npos) << useless;
}

}  // namespace
}  // namespace ravnoves::balance_shaft
