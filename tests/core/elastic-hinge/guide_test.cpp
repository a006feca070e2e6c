#include "elastic-hinge/guide.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "elastic-hinge/guide_export.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/results.h"
#include "support.h"

namespace ravnoves::elastic_hinge {
namespace {

/// A spring so soft that the guide has a relief of millimetres.
Input soft_zotov() {
    Input input = preset_zotov();
    input.spring = Spring{2e5, 0.2, 0.09};
    return input;
}

double energy_at(const Design& design, double phi) {
    return design.demand(Hinge::crank, phi).energy;
}

/// As printed the spring stores what the mechanism takes up, too.
TEST(ElasticHingeGuide, SpringAndMechanismKeepTheirEnergyOnBothBranches) {
    for (const auto& [rho, sign] : {std::pair(0.09, 1.0), {0.11, 1.0}, {0.09, -1.0}}) {
        Input input = soft_zotov();
        input.spring->guide_radius_at_zero = rho;
        input.guide_sign = sign > 0.0 ? GuideSign::energy : GuideSign::as_printed;
        const Result result = solve(input);
        const GuideShape& shape = *result.crank_guide.shape;
        EXPECT_EQ(result.crank_guide.branch, rho < 0.1 ? Branch::compressed : Branch::stretched);
        for (const Branch branch : {Branch::compressed, Branch::stretched}) {
            const double total = test::energy_in(shape, shape.at(branch, 0.0).radius);
            for (int i = 0; i < 360; ++i) {
                const double phi = i * degree;
                const double sum = test::energy_in(shape, shape.at(branch, phi).radius) +
                                   sign * energy_at(*result.design, phi);
                EXPECT_NEAR(sum, total, 1e-13 * total);
            }
        }
    }
}

TEST(ElasticHingeGuide, SlopeAndSecondDerivativeAreThoseOfTheRadius) {
    Input input = soft_zotov();
    input.rod_hinge_spring = Spring{3e5, 0.2, 0.115};
    const Result result = solve(input);
    for (const Guide* guide :
         {&result.crank_guide, &result.crank_guide_with_rod, &result.rod_guide}) {
        ASSERT_TRUE(guide->feasible) << guide->reason.english();
        for (const Branch branch : {Branch::compressed, Branch::stretched}) {
            for (const double phi : {0.3, 1.7, 2.9, 4.4, 6.0}) {
                const double h = 1e-4;
                const GuidePoint a = guide->shape->at(branch, phi - h);
                const GuidePoint b = guide->shape->at(branch, phi + h);
                const GuidePoint m = guide->shape->at(branch, phi);
                EXPECT_NEAR(m.slope, (b.radius - a.radius) / (b.angle - a.angle),
                            1e-6 * (std::abs(m.slope) + 1e-3));
                EXPECT_NEAR(m.second, (b.slope - a.slope) / (b.angle - a.angle),
                            1e-5 * (std::abs(m.second) + 1e-3));
            }
        }
    }
}

TEST(ElasticHingeGuide, TooLittlePreloadIsRejectedWithWhatWouldDo) {
    Input input = preset_zotov();
    input.spring->guide_radius_at_zero = 0.0995;  // 0.5 mm of the 0.6 mm that are needed
    const Result result = solve(input);
    const Guide& guide = result.crank_guide;
    EXPECT_FALSE(guide.feasible);
    EXPECT_TRUE(guide.lacks_preload);
    EXPECT_NE(guide.reason.english().find("minimum 0.6001 mm"), std::string::npos)
        << guide.reason.english();
    EXPECT_NE(guide.reason.english().find("75.9257°"), std::string::npos) << guide.reason.english();
    EXPECT_NEAR(guide.worst_angle / degree, 75.9257, 1e-3);
    // The first angle without a guide: where the energy given out reaches that stored.
    const double stored = 0.5 * 2e7 * 4 * 0.0005 * 0.0005;
    EXPECT_LT(energy_at(*result.design, guide.first_missing_angle - degree), stored);
    EXPECT_GT(energy_at(*result.design, guide.first_missing_angle), stored);
    // The curve stands where there is a guide and is a gap where there is none.
    std::size_t missing = 0;
    for (std::size_t i = 0; i < result.crank_angle_deg.size(); ++i) {
        const bool gap = std::isnan(guide.radius_compressed[i]);
        missing += gap ? 1 : 0;
        EXPECT_EQ(gap, energy_at(*result.design, result.crank_angle_deg[i] * degree) > stored);
    }
    EXPECT_GT(missing, 10U);

    // What is shown suffices, to the last of four decimals.
    const std::string reason = guide.reason.english();
    const double shown = std::stod(reason.substr(reason.find("the minimum ") + 12));
    EXPECT_GE(shown, guide.minimum_preload / units::mm - 1e-9);
    EXPECT_LT(shown, guide.minimum_preload / units::mm + 1e-4);

    Input stiffer = input;
    ASSERT_TRUE(guide.minimum_stiffness);
    stiffer.spring->stiffness = *guide.minimum_stiffness * (1 + 1e-9);
    EXPECT_TRUE(solve(stiffer).crank_guide.feasible);
    stiffer.spring->stiffness = *guide.minimum_stiffness * (1 - 1e-6);
    EXPECT_FALSE(solve(stiffer).crank_guide.feasible);
}

TEST(ElasticHingeGuide, UnloadedSpringWorksAsPrintedOnlyAndAlmost) {
    // The paper's guides 1, ρ₀ = ℓ₀/2: with the printed sign 9 µm of preload are enough.
    Input input = preset_zotov();
    input.spring->guide_radius_at_zero = 0.1;
    EXPECT_FALSE(solve(input).crank_guide.feasible);
    EXPECT_FALSE(solve(input).crank_guide.minimum_stiffness.has_value());
    input.guide_sign = GuideSign::as_printed;
    const Result printed = solve(input);
    EXPECT_NEAR(printed.crank_guide.minimum_preload, 8.6e-6, 0.1e-6);
    input.spring->guide_radius_at_zero = 0.1 - 9e-6;
    EXPECT_TRUE(solve(input).crank_guide.feasible);
}

TEST(ElasticHingeGuide, SpringPressedToNothingIsRejected) {
    Input input = preset_zotov();
    input.guide_sign = GuideSign::as_printed;  // stores the 14 J on top of what it has
    input.spring = Spring{3000.0, 0.2, 0.001};
    const Guide guide = solve(input).crank_guide;
    EXPECT_FALSE(guide.feasible);
    EXPECT_FALSE(guide.lacks_preload);
    EXPECT_TRUE(guide.stretched.exists);
}

TEST(ElasticHingeGuide, CurvatureOfACircleIsItsInverseRadius) {
    const GuidePoint centred{0.4, 0.09, 0.0, 0.0};
    EXPECT_DOUBLE_EQ(centred.curvature(), 1 / 0.09);
    // A circle of radius 50 mm about a point 20 mm off the centre.
    const double e = 0.02;
    const double R = 0.05;
    for (const double a : {0.3, 1.2, 2.5, 4.0}) {
        const double root = std::sqrt(R * R - e * e * std::sin(a) * std::sin(a));
        const double rho = e * std::cos(a) + root;
        const double slope = -e * std::sin(a) - e * e * std::sin(a) * std::cos(a) / root;
        const double second = -e * std::cos(a) - e * e * std::cos(2 * a) / root -
                              std::pow(e * e * std::sin(a) * std::cos(a), 2) / std::pow(root, 3);
        const GuidePoint point{a, rho, slope, second};
        EXPECT_NEAR(point.curvature(), 1 / R, 1e-10);
        // Its offset is a circle about the same point.
        const PlanePoint p = offset_point(point, 0.01);
        EXPECT_NEAR(std::hypot(p.x - e, p.y), R + 0.01, 1e-15);
    }
}

TEST(ElasticHingeGuide, LargestRollerIsTheOneAtWhichTheProfileStartsToRunBackwards) {
    Input input = preset_zotov();
    input.spring = Spring{23e3, 0.06, 0.012};  // from 12 mm to 27 mm
    const Result result = solve(input);
    const Guide& guide = result.crank_guide;
    ASSERT_TRUE(guide.feasible) << guide.reason.english();
    ASSERT_TRUE(guide.compressed.largest_roller_radius.has_value());
    for (const Branch branch : {Branch::compressed, Branch::stretched}) {
        const double limit = branch == Branch::compressed ? *guide.compressed.largest_roller_radius
                                                          : *guide.stretched.largest_roller_radius;
        const double side = branch == Branch::compressed ? 1.0 : -1.0;
        const auto runs_backwards = [&](double roller) {
            const int n = 14400;
            PlanePoint before = offset_point(guide.shape->at(branch, 0.0), side * roller);
            PlanePoint path_before = offset_point(guide.shape->at(branch, 0.0), 0.0);
            for (int i = 1; i <= n; ++i) {
                const GuidePoint point = guide.shape->at(branch, two_pi * i / n);
                const PlanePoint profile = offset_point(point, side * roller);
                const PlanePoint path = offset_point(point, 0.0);
                if ((profile.x - before.x) * (path.x - path_before.x) +
                        (profile.y - before.y) * (path.y - path_before.y) <
                    0) {
                    return true;
                }
                before = profile;
                path_before = path;
            }
            return false;
        };
        EXPECT_FALSE(runs_backwards(0.995 * limit));
        EXPECT_TRUE(runs_backwards(1.005 * limit));
    }
    input.roller_radius = 1.01 * *guide.compressed.largest_roller_radius;
    EXPECT_TRUE(solve(input).crank_guide.compressed.undercut);
    input.roller_radius = 0.99 * *guide.compressed.largest_roller_radius;
    EXPECT_FALSE(solve(input).crank_guide.compressed.undercut);
}

// The rollers of both ends of a spring are 2ρ apart.
TEST(ElasticHingeGuide, RollersThatOverlapAreDoubted) {
    Input input = preset_zotov();
    input.spring = Spring{2e5, 0.2, 0.0498};
    const Result smooth = solve(input);
    struct Row {
        const Guide Result::*guide;
        const char* name;
    };
    for (const auto& [guide, name] :
         {Row{&Result::crank_guide, "(the crank's hinge)"},
          Row{&Result::crank_guide_with_rod, "(the crank's hinge with the rod's hinge)"},
          Row{&Result::rod_guide, "(the rod's hinge)"}}) {
        const double touching = (smooth.*guide).compressed.min_radius;
        for (const double share : {1.0 - 1e-9, 1.0 + 1e-9, 1.2}) {
            input.roller_radius = share * touching;
            const Result result = solve(input);
            EXPECT_TRUE((result.*guide).feasible);
            EXPECT_FALSE((result.*guide).summary().undercut);
            const bool told = std::any_of(result.guide_notes.begin(), result.guide_notes.end(),
                                          [name = name](const Message& note) {
                                              return note.english().find(name) != std::string::npos;
                                          });
            EXPECT_EQ(told, share > 1.0) << name << share;
            if (guide == &Result::crank_guide) {
                EXPECT_EQ(verdict(input, result).severity,
                          share > 1.0 ? Severity::warning : Severity::good);
            }
        }
    }
    GuideDrawing drawing;
    drawing.roller_radius = 0.06;
    EXPECT_NE(guide_dxf(smooth.crank_guide, drawing).find("WARNING: The two rollers overlap"),
              std::string::npos);
}

TEST(ElasticHingeGuide, SpringsThatBecomeTooShortAreDoubtedAndSolidOnesRejected) {
    Input input = preset_zotov();
    input.roller_radius = 0.001;
    for (const auto& [radius, shortest, severity] :
         {std::tuple(0.005, std::optional<double>(), Severity::error),
          std::tuple(0.03, std::optional<double>(), Severity::warning),
          std::tuple(0.0405, std::optional<double>(), Severity::good),
          std::tuple(0.005, std::optional(0.009), Severity::good),
          std::tuple(0.06, std::optional(0.121), Severity::error)}) {
        input.spring = Spring{2e5, 0.2, radius};
        input.guide_search = GuideWish{};
        input.guide_search->smallest_spring_length = shortest;
        EXPECT_EQ(verdict(input, solve(input)).severity, severity) << radius;
    }
}

TEST(ElasticHingeGuide, TheVerdictIsOfEachHingeThatIsDesigned) {
    Input input = preset_zotov();
    input.roller_radius = 0.01;
    input.spring = Spring{2e5, 0.2, 0.08};
    ASSERT_EQ(verdict(input, solve(input)).severity, Severity::good);
    input.rod_hinge_spring = Spring{2e5, 0.2, 0.0999};
    const Result result = solve(input);
    ASSERT_TRUE(result.crank_guide.feasible);
    ASSERT_FALSE(result.rod_guide.feasible);
    const Verdict told = verdict(input, result);
    EXPECT_EQ(told.severity, Severity::error);
    const std::string text = told.text.english();
    EXPECT_TRUE(text.starts_with("Rod hinge guide: none, because from a crank angle")) << text;
    EXPECT_NE(text.find("Crank guide: feasible"), std::string::npos) << text;
    EXPECT_EQ(told.act, "") << "the remedy is for the crank guide";
}

// What a designer reads must not depend on where samples fall.
TEST(ElasticHingeGuide, NoNumberDependsOnTheSamples) {
    for (const double lambda : {0.3, 0.7, 0.93}) {
        Input input = preset_zotov();
        input.lambda = lambda;
        input.spring = Spring{23e3, 0.16, 0.04};
        input.roller_radius = 0.008;
        input.kinematics = Kinematics::series;
        input.rod_counterweight = RodCounterweight{0.1, 2.0, CounterweightInertia::as_printed};
        const auto numbers = [&](int samples) {
            SolveOptions options;
            options.samples = samples;
            const Result result = solve(input, options);
            const Guide& guide = result.crank_guide;
            std::vector<double> list{result.largest_side_force_without,
                                     result.largest_side_force_with,
                                     *result.largest_side_force_true,
                                     result.series_error,
                                     result.series_moment_error.value(),
                                     guide.largest_moment,
                                     guide.error.torque};
            for (const auto branch : {&Guide::compressed, &Guide::stretched}) {
                const BranchSummary& summary = guide.*branch;
                list.insert(list.end(),
                            {summary.min_radius, summary.max_radius, summary.profile_min_radius,
                             summary.profile_max_radius, summary.max_pressure_angle,
                             summary.smallest_curvature_radius,
                             summary.largest_roller_radius.value_or(1.0)});
            }
            return list;
        };
        const auto usual = numbers(721);
        const auto shifted = numbers(1000);
        const auto fine = numbers(20001);
        for (std::size_t i = 0; i < usual.size(); ++i) {
            EXPECT_GT(usual[i], 0.0) << i;
            EXPECT_NEAR(usual[i], fine[i], 1e-9 * fine[i]) << lambda << " " << i;
            EXPECT_NEAR(shifted[i], fine[i], 1e-9 * fine[i]) << lambda << " " << i;
        }
    }
}

// Near locking all happens within a degree: by brute force on angles that crowd there.
TEST(ElasticHingeGuide, MinimumPreloadHoldsNearLocking) {
    for (const double lambda : {0.9, 0.999, 0.99999}) {
        Input input = preset_zotov();
        input.lambda = lambda;
        const Mechanism<double> m = mechanism_of(input);
        const double square = input.angular_speed * input.angular_speed;
        const auto energy = [&](double phi) {
            return 0.5 * test::inertia_at(m, phi).value * square +
                   potential_amplitude(m) * std::sin(phi);
        };
        double maximum = energy(0.0);
        for (const double centre : {0.0, 0.5 * pi, pi, 1.5 * pi}) {
            for (int i = -20000; i <= 20000; ++i) {
                const double x = i / 20000.0;
                maximum = std::max(maximum, energy(centre + 0.25 * pi * x * x * x));
            }
        }
        const double minimum = std::sqrt((maximum - energy(0.0)) / (2.0 * input.spring->stiffness));
        EXPECT_NEAR(solve(input).crank_guide.minimum_preload, minimum, 1e-8 * minimum) << lambda;
    }
}

TEST(ElasticHingeGuide, ProfileErrorIsTheWorstOverAngleAndPhase) {
    for (const int waves : {1, 2, 7}) {
        Input input = soft_zotov();
        input.profile_error = 20e-6;
        input.profile_error_waves = waves;
        const Guide guide = solve(input).crank_guide;
        const double c = input.spring->stiffness;
        double worst = 0.0;
        for (int phase = 0; phase < 48; ++phase) {
            for (int i = 0; i < 720; ++i) {
                const double phi = i * 0.5 * degree;
                const GuidePoint p = guide.shape->at(Branch::compressed, phi);
                const double argument = waves * phi + two_pi * phase / 48;
                const double error = input.profile_error * std::sin(argument);
                const double slope_error = input.profile_error * waves * std::cos(argument);
                const double change = 0.2 - 2 * p.radius;
                const double moment = 2 * c * change * p.slope;
                const double made = 2 * c * (change - 2 * error) * (p.slope + slope_error);
                worst = std::max(worst, std::abs(made - moment));
            }
        }
        EXPECT_LE(worst, guide.error.torque);
        EXPECT_GT(worst, 0.99 * guide.error.torque);
    }
}

}  // namespace
}  // namespace ravnoves::elastic_hinge
