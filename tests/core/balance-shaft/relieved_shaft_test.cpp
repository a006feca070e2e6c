#include "balance-shaft/relieved_shaft.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "balance-shaft/input.h"
#include "balance-shaft/presets.h"
#include "case-file/json.h"
#include "dxf_drawing.h"
#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using test::error_of;

constexpr double needed = 0.658 * 0.046;  // the paper's m₁ ρ₁, kg·m

/// Moments of the section below the flat by quadrature over y.
double section_integral(const RelievedShaft& shaft, const auto& weight) {
    const double radius = shaft.diameter / 2.0;
    boost::math::quadrature::tanh_sinh<double> rule;
    return rule.integrate(
        [&](double y) {
            return weight(y) * 2.0 * std::sqrt(std::max((radius - y) * (radius + y), 0.0));
        },
        -radius, radius - shaft.depth);
}

TEST(RelievedShaft, UnbalanceAndMassAgreeWithQuadrature) {
    for (const double depth : {0.002, 0.011, 0.025, 0.031}) {
        const RelievedShaftSizes sizes{0.050, depth, 0.3, 7850.0};
        const RelievedShaft shaft = design_relieved_shaft(sizes, needed);
        const double area = section_integral(shaft, [](double) { return 1.0; });
        const double first = section_integral(shaft, [](double y) { return y; });
        EXPECT_NEAR(shaft.unbalance, -7850.0 * 0.3 * first, 1e-9 * shaft.unbalance) << depth;
        EXPECT_NEAR(shaft.mass, 7850.0 * 0.3 * area, 1e-9 * shaft.mass);
        EXPECT_NEAR(shaft.mass + shaft.removed_mass, 7850.0 * 0.3 * pi * 0.025 * 0.025, 1e-9);
        EXPECT_NEAR(shaft.centre_of_mass_radius, -first / area, 1e-9);
    }
}

TEST(RelievedShaft, SizesWhatIsMissing) {
    const RelievedShaft by_depth = design_relieved_shaft({0.050, std::nullopt, 0.45}, needed);
    ASSERT_TRUE(by_depth.feasible) << by_depth.reason.english();
    EXPECT_NEAR(by_depth.unbalance, needed, 1e-12 * needed);
    EXPECT_LT(by_depth.depth, 0.025);
    const RelievedShaft by_length =
        design_relieved_shaft({0.050, by_depth.depth, std::nullopt}, needed);
    EXPECT_NEAR(by_length.length, 0.45, 1e-12);
    const RelievedShaft by_diameter =
        design_relieved_shaft({std::nullopt, by_depth.depth, 0.45}, needed);
    EXPECT_NEAR(by_diameter.diameter, 0.050, 1e-12);
    const RelievedShaft checked = design_relieved_shaft({0.050, by_depth.depth, 0.45}, needed);
    EXPECT_TRUE(checked.feasible);
    const RelievedShaft weak = design_relieved_shaft({0.050, 0.005, 0.45}, needed);
    EXPECT_FALSE(weak.feasible);
    EXPECT_NE(weak.reason.english().find("% of the required unbalance"), std::string::npos);
}

TEST(RelievedShaft, TheCriticalSizesAreThoseOfHalfABar) {
    const RelievedShaft shaft = design_relieved_shaft({0.060, std::nullopt, 0.3}, needed);
    ASSERT_TRUE(shaft.feasible);
    // Just at the critical radius the depth is half the bar; below it nothing helps.
    const double critical = 2.0 * shaft.critical_radius;
    const RelievedShaft at =
        design_relieved_shaft({critical * (1.0 + 1e-9), std::nullopt, 0.3}, needed);
    ASSERT_TRUE(at.feasible);
    EXPECT_NEAR(at.depth / at.diameter, 0.5, 1e-4);
    const RelievedShaft below =
        design_relieved_shaft({critical * (1.0 - 1e-9), std::nullopt, 0.3}, needed);
    EXPECT_FALSE(below.feasible);
    EXPECT_EQ(below.reason.english().rfind("The bar is too thin", 0), 0U);
    // And the critical length of that bar is the length asked for.
    EXPECT_NEAR(below.critical_length, 0.3, 1e-6);
    const RelievedShaft longer = design_relieved_shaft(
        {below.diameter, std::nullopt, below.critical_length * 1.0001}, needed);
    EXPECT_TRUE(longer.feasible);
    // Twice the depth beyond the axis: the same unbalance, and a word about it.
    const RelievedShaftSizes deep{0.060, 0.060 - shaft.depth, 0.3};
    const RelievedShaft beyond = design_relieved_shaft(deep, needed);
    EXPECT_TRUE(beyond.feasible) << beyond.reason.english();
    EXPECT_NE(beyond.note.english().find("More than half"), std::string::npos);
}

TEST(RelievedShaft, BadSizesAreRejectedAndImpossibleOnesAreAResult) {
    const auto rejection = [](const RelievedShaftSizes& sizes) {
        return error_of([&] { design_relieved_shaft(sizes, needed); });
    };
    EXPECT_EQ(rejection({0.05, std::nullopt, std::nullopt}),
              "/input/relieved_shaft: must have two of diameter_mm, depth_mm and length_mm, got 1");
    EXPECT_EQ(rejection({0.05, 0.05, std::nullopt}),
              "/input/relieved_shaft/depth_mm: must be less than the diameter, 50, got 50");
    EXPECT_EQ(rejection({-0.05, 0.01, std::nullopt})
                  .rfind("/input/relieved_shaft/diameter_mm: must be from 0.001 to 100000", 0),
              0U);
    EXPECT_EQ(rejection({std::nan(""), 0.01, std::nullopt}).rfind("/input/relieved_shaft/", 0), 0U);
    EXPECT_FALSE(design_relieved_shaft({0.05, 0.01, std::nullopt}, 0.0).feasible);
    for (const double required : {5e-324, 1e-200, 1e99}) {
        for (const RelievedShaftSizes& sizes :
             {RelievedShaftSizes{0.05, std::nullopt, 0.3}, RelievedShaftSizes{0.05, 1e-9, {}},
              RelievedShaftSizes{std::nullopt, 1e-9, 0.3}}) {
            const RelievedShaft shaft = design_relieved_shaft(sizes, required);
            for (const double value : {shaft.mass, shaft.diameter, shaft.depth, shaft.length,
                                       shaft.critical_radius, shaft.critical_length}) {
                EXPECT_TRUE(std::isfinite(value)) << required;
            }
            EXPECT_EQ(shaft.feasible, shaft.reason.empty());
        }
    }
}

// Clearances took a half disc of 30 mm, whatever the bar that was found feasible.
TEST(RelievedShaft, IsTheShaftOfMapAndClearances) {
    Input input = preset_tmz_650d();
    const Solver half_disc(input);
    const RelievedShaft usual = half_disc.result().relieved_shaft;
    EXPECT_TRUE(usual.feasible) << usual.reason.english();
    EXPECT_NEAR(usual.diameter / 2.0, half_disc.front_view().shaft_swing_radius, 1e-15);
    EXPECT_NEAR(usual.depth, usual.diameter / 2.0, 1e-6 * usual.depth);
    EXPECT_NEAR(usual.length, half_disc.front_view().cylinder_bore, 1e-15);
    EXPECT_NEAR(usual.unbalance, input.unbalance(), 1e-9 * usual.unbalance);
    // Nor can a shaft of any radius have the unbalance.
    const auto needs_length = [](const Input& of) {
        return verdict(solve(of)).text.english().find("more than two bores") != std::string::npos;
    };
    EXPECT_FALSE(needs_length(input));
    Input thin = input;
    thin.envelope.shaft_swing_radius = half_disc.front_view().shaft_swing_radius / std::cbrt(2.1);
    EXPECT_TRUE(needs_length(thin));
    // The bar of that circle is sized so that it suffices, and the note has its length.
    const RelievedShaft longer = solve(thin).relieved_shaft;
    EXPECT_TRUE(longer.feasible) << longer.reason.english();
    EXPECT_NEAR(longer.diameter, 2.0 * thin.envelope.shaft_swing_radius.value(), 1e-15);
    EXPECT_NEAR(longer.length, 2.1 * usual.length, 1e-9);
    EXPECT_NE(longer.note.english().find("longer than two bores"), std::string::npos);
    thin.envelope.shaft_swing_radius = half_disc.front_view().shaft_swing_radius / std::cbrt(1.9);
    EXPECT_FALSE(needs_length(thin));

    input.relieved_shaft = RelievedShaftSizes{0.050, std::nullopt, 0.400};
    const Solver bar(input);
    ASSERT_TRUE(bar.result().relieved_shaft.feasible);
    EXPECT_NE(bar.result().relieved_shaft.note.english().find("longer than two bores"),
              std::string::npos);
    EXPECT_EQ(half_disc.result().relieved_shaft.note.english(),
              "Same unbalance as 0.658 kg at ρ₁ = 46 mm; map and clearances use the swing radius "
              "39.27 mm.");
    EXPECT_EQ(bar.front_view().shaft_swing_radius, 0.025);
    EXPECT_EQ(shaft_clearance(bar.front_view(), 1.0).crank -
                  shaft_clearance(half_disc.front_view(), 1.0).crank,
              half_disc.front_view().shaft_swing_radius - 0.025);
    const auto built = [](const Solver& solver) {
        double sum = 0.0;
        for (const AngleStretch& stretch : solver.buildable().stretches) {
            sum += stretch.to - stretch.from;
        }
        return sum;
    };
    EXPECT_GT(built(bar), built(half_disc) + 10.0 * degree);
    EXPECT_EQ(bar.result().assumed_sizes.english().find("swing radius of the shaft"),
              std::string::npos);
    // A diameter that is found counts too.
    input.relieved_shaft = RelievedShaftSizes{std::nullopt, 0.020, 0.300};
    EXPECT_EQ(Solver(input).front_view().shaft_swing_radius,
              solve(input).relieved_shaft.diameter / 2.0);

    input.envelope.shaft_swing_radius = 0.020;
    const Result too_wide = solve(input);
    EXPECT_FALSE(too_wide.relieved_shaft.feasible);
    EXPECT_EQ(too_wide.relieved_shaft.reason.english().rfind("The bar (radius", 0), 0U);
    // The shaft that is drawn is the one that is judged.
    EXPECT_GE(verdict(too_wide).severity, Severity::warning);
    EXPECT_NE(verdict(too_wide).text.english().find("Relieved shaft: The bar (radius"),
              std::string::npos);
}

TEST(RelievedShaft, CasesWithSizesOfItsBendingOpenAndSaySo) {
    Json json = write_input(preset_tmz_650d());
    json["relieved_shaft"] = {{"diameter_mm", 52}, {"length_mm", 430}};
    EXPECT_FALSE(read_input(json, {}).relieved_shaft->had_bending);
    json["relieved_shaft"].update({{"elastic_modulus_GPa", 210},
                                   {"bearing_span_mm", 500},
                                   {"allowable_stress_MPa", 150},
                                   {"permitted_sag_mm", 0.3},
                                   {"speed_margin", 2},
                                   {"bearing_load_limit_N", 5000}});
    const Input input = read_input(json, {});
    EXPECT_TRUE(input.relieved_shaft->had_bending);
    const auto notes = solve(input).notes;
    EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const Message& note) {
        return note.english().starts_with(
            "Not used, since bending of the relieved shaft is no longer computed");
    }));
    EXPECT_EQ(write_input(input).at("relieved_shaft").size(), 2U);
    json["relieved_shaft"]["bearing_spam_mm"] = 500;
    EXPECT_NE(error_of([&] { read_input(json, {}); }), "no error");
}

TEST(RelievedShaftDxf, ReadsBackAsTheSectionThatWasDesigned) {
    const RelievedShaft shaft = design_relieved_shaft({0.056, std::nullopt, 0.35}, needed);
    ASSERT_TRUE(shaft.feasible);
    const std::string text = relieved_shaft_dxf(shaft);
    const ravnoves::test::DxfDrawing reader(text);
    for (const char* layer : {"SHAFT", "REMOVED", "AXIS", "NOTE"}) {
        EXPECT_TRUE(reader.layers.contains(layer)) << layer;
    }
    ASSERT_EQ(reader.arcs.count("SHAFT"), 1U);
    const DL_ArcData arc = reader.arcs.find("SHAFT")->second;
    EXPECT_NEAR(arc.radius, 28.0, 1e-9);
    // The outline closes: the arc's ends are the flat's ends.
    const DL_LineData flat = reader.lines.find("SHAFT")->second;
    const auto on_arc = [&](double angle) {
        return std::pair(arc.radius * std::cos(angle * degree),
                         arc.radius * std::sin(angle * degree));
    };
    EXPECT_NEAR(on_arc(arc.angle1).first, flat.x1, 1e-6);
    EXPECT_NEAR(on_arc(arc.angle1).second, flat.y1, 1e-6);
    EXPECT_NEAR(on_arc(arc.angle2).first, flat.x2, 1e-6);
    EXPECT_NEAR(flat.y1, 28.0 - shaft.depth * 1e3, 1e-6);
    EXPECT_NEAR(flat.x2 - flat.x1, 2e3 * shaft.half_width, 1e-6);
    // The section's own unbalance, by Green's theorem on the drawing, is the one asked for.
    double moment = 0.0;  // ∫ y dA = −∮ y²/2 dx, counter-clockwise, mm³
    constexpr int steps = 20'000;
    double from = arc.angle1;
    double to = arc.angle2 < arc.angle1 ? arc.angle2 + 360.0 : arc.angle2;
    for (int i = 0; i < steps; ++i) {
        const auto [x1, y1] = on_arc(from + (to - from) * i / steps);
        const auto [x2, y2] = on_arc(from + (to - from) * (i + 1) / steps);
        moment -= (y1 * y1 + y1 * y2 + y2 * y2) / 6.0 * (x2 - x1);
    }
    moment -= flat.y1 * flat.y1 / 2.0 * (flat.x1 - flat.x2);
    EXPECT_NEAR(-moment * 1e-9 * shaft.length * 7850.0, needed, 1e-6 * needed);
    EXPECT_EQ(reader.polylines.at("SHAFT").points.size(), 8U);
    EXPECT_TRUE(reader.texts.front().text.starts_with("Balance shaft"));
    double lowest = -1.2 * 28.0;  // the end of the section's axes
    for (const DL_TextData& note : reader.texts) {
        EXPECT_LT(note.ipy + note.height, lowest) << note.text;
        lowest = note.ipy;
    }
    EXPECT_EQ(text.find(','), text.find(',', text.find("NOTE")));  // commas in notes alone
    EXPECT_NE(error_of([] { relieved_shaft_dxf({}); }), "no error");
}

}  // namespace
}  // namespace ravnoves::balance_shaft
