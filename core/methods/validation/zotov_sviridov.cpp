/// The numbers of [zotov-sviridov].

#include <cmath>

#include "case-file/decimal.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/result.h"
#include "methods/validation/rows.h"
#include "numerics/constants.h"

namespace ravnoves::methods {

namespace {

using elastic_hinge::GuideSign;
using elastic_hinge::Input;
using elastic_hinge::Kinematics;
using elastic_hinge::Mechanism;
using elastic_hinge::Result;

/// The paper's mechanism with the paper's series for M₁₂.
Input paper_input(double speed) {
    Input input = elastic_hinge::preset_zotov();
    input.kinematics = Kinematics::series;
    input.angular_speed = speed;
    return input;
}

/// With a counterweight on the rod that (10) is solved for.
Input with_counterweight(double speed, double distance) {
    Input input = paper_input(speed);
    input.rod_counterweight.emplace();
    input.rod_counterweight->distance = distance;
    return input;
}

/// The integral over one turn, and that of the size, by the trapezoid rule (exact to rounding for
/// these smooth periodic curves).
struct TurnIntegral {
    double value = 0.0;
    double size = 0.0;

    explicit TurnIntegral(const std::vector<double>& samples) {
        const std::size_t steps = samples.size() - 1;  // the last sample repeats the first
        for (std::size_t i = 0; i < steps; ++i) {
            value += samples[i];
            size += std::abs(samples[i]);
        }
        value *= two_pi / static_cast<double>(steps);
        size *= two_pi / static_cast<double>(steps);
    }
};

void zero_integral(PaperRows& rows, Message place, Message quantity,
                   const std::vector<double>& samples, Text reason) {
    constexpr double rounding = 1e-9;
    const TurnIntegral integral(samples);
    rows.at(std::move(place));
    rows.reproduced(std::move(quantity), "J", "0", integral.value, reason,
                    rounding * integral.size);
}

void rod_hinge_integral(PaperRows& rows) {
    rows.at(in_text(after_equation(4)));
    for (const double speed : {100.0, 300.0, 500.0}) {
        const Result result = elastic_hinge::solve(paper_input(speed));
        const TurnIntegral integral(result.curves.rod_hinge_moment);
        rows.reproduced({Text::tr("∮ M₁₂ dφ at ω = %1 s⁻¹"), speed}, "J", "9.469", integral.value,
                        Text::tr("With the paper's series for cos ψ; the inertia part is odd in φ "
                                 "and cancels at every speed."));
    }
}

void vanishing_integrals(PaperRows& rows) {
    const Result plain = elastic_hinge::solve(paper_input(100.0));
    const Result weighted = elastic_hinge::solve(with_counterweight(100.0, 0.1));
    const Text rounding = Text::tr("To rounding, 1e-9 of the integral of its magnitude.");
    zero_integral(rows, in_text(Text::tr("introduction")), "∮ M dφ", plain.curves.crank_moment,
                  rounding);
    zero_integral(rows, equation(5), joined("∮ M₁₂ dφ", Text::tr("potential part")),
                  plain.curves.rod_hinge_moment_potential, rounding);
    zero_integral(rows, in_text(after_equation(8)), "∮ M₁ dφ",
                  plain.curves.crank_moment_with_rod_hinge,
                  Text::tr("To rounding, with M₁₂ correctly outside the factor 0.5 of (8)."));
    zero_integral(rows, equation(10), "∮ M₁₂* dφ", weighted.curves.rod_hinge_moment,
                  Text::tr("To rounding, with the counterweight of (10)."));
    zero_integral(rows, in_text(after_equation(11)), "∮ M₁* dφ",
                  weighted.curves.crank_moment_with_rod_hinge,
                  Text::tr("To rounding, with M₁₂* correctly outside the factor 0.5 of (11)."));
}

/// The factor of M₁₂ (1 + λ cos φ / cos ψ) in the crank's moment.
///
/// A hinge that puts the moment M₁₂ on the rod changes the side force R, and the moment balance
/// about the crank axis says that the crank's moment changes by x_B ΔR. Fitted over the turn.
double factor_of_rod_hinge(const Input& input) {
    const Mechanism<double> mechanism = elastic_hinge::mechanism_of(input);
    elastic_hinge::SolveOptions options;
    options.samples = 73;
    options.with_rod_guides = false;
    const Result result = elastic_hinge::solve(input, options);
    const auto grid = elastic_hinge::angle_grid(options.samples);
    double product = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < grid->size(); ++i) {
        const auto rod =
            elastic_hinge::rod_angle_exact(mechanism.lambda, grid->sin_phi[i], grid->cos_phi[i]);
        const double moment = result.curves.rod_hinge_moment[i];
        const double x_b =
            mechanism.crank_radius * grid->cos_phi[i] + mechanism.rod_length() * rod.cos_psi;
        const double change = x_b * moment / (mechanism.rod_length() * rod.cos_psi);
        const double printed_term = moment * (1.0 + rod.dpsi);
        product += change * printed_term;
        square += printed_term * printed_term;
    }
    return product / square;
}

void factor_in_crank_moment(PaperRows& rows) {
    const auto add = [&](Message place, const Input& input) {
        const double factor = factor_of_rod_hinge(input);
        rows.at(std::move(place));
        // The sum M + M₁₂ (…) has M = 0.5 (…): the bracket closes one term too late.
        rows.slip(Text::tr("factor of M₁₂ (1 + λ cos φ / cos ψ)"), "", "0.5", factor, 0.5 * factor,
                  Text::tr("The bracket of 0.5 closes after M₁₂ instead of before it; the moment "
                           "balance about the crank axis gives our value."));
    };
    add(equation(8), paper_input(300.0));
    add(equation(11), with_counterweight(300.0, 0.1));
}

void guide(PaperRows& rows) {
    Input input = elastic_hinge::preset_zotov();
    const double half = input.spring->free_length / 2.0;
    const auto largest_radius = [&](GuideSign sign) {
        input.guide_sign = sign;
        return half - elastic_hinge::solve(input).crank_guide.minimum_preload;
    };
    const double energy = largest_radius(GuideSign::energy);
    const double as_printed = largest_radius(GuideSign::as_printed);
    const Mechanism<double> m = elastic_hinge::mechanism_of(input);
    rows.at(equation(3));
    rows.reproduced(Text::tr("divisor of r² (P₁ + P₂) / g in Iₚᵣ(0)"), "", "3",
                    m.crank_radius * m.crank_radius * (m.crank_mass + m.rod_mass) /
                        elastic_hinge::reduced_inertia_at_zero(m),
                    Text::tr("From the mechanism's reduced inertia."), 1e-9);
    rows.at(in_text(after_equation(3)));
    constexpr double tolerance = 1e-5;  // m
    rows.slip(Text::tr("ρ₀ of guides 1, ℓ₀/2: maximum with a guide"), "m", "0.1", energy,
              as_printed,
              Text::tr("To 0.01 mm, and only with the sign of (1), by which spring and mechanism "
                       "absorb energy together. For constant ω the spring must release it."),
              tolerance);
}

void counterweight(PaperRows& rows) {
    const auto weight = [](double distance) {
        const Result result = elastic_hinge::solve(with_counterweight(100.0, distance));
        return result.design->mechanism().balancing_mass() * elastic_hinge::preset_zotov().gravity;
    };
    const Text reason = Text::tr("P₄ ℓ₂ = (P₃ + P₂/2) ℓ, at any speed.");
    rows.at(in_text(after_equation(10)));
    rows.reproduced({Text::tr("P₄ at ℓ₂ = %1 m"), 0.05}, "N", "30.833", weight(0.05), reason);
    rows.reproduced({Text::tr("P₄ at ℓ₂ = %1 m"), 0.1}, "N", "15.4167", weight(0.1), reason);
    rows.reproduced({Text::tr("P₄ at ℓ₂ = %1 m"), 0.15}, "N", "10.278", weight(0.15), reason);
    rows.at(in_text(figure(6)));
    rows.reproduced(joined(Message{Text::tr("P₄ at ℓ₂ = %1 m"), 0.1}, Text::tr("Fig. 6a")), "N",
                    "15.4167", weight(0.1), reason);
    rows.slip(joined(Message{Text::tr("P₄ at ℓ₂ = %1 m"), 0.05}, Text::tr("Fig. 6b")), "N",
              "30.8330", weight(0.05), rounded_to_decimals(weight(0.05), 3),
              Text::tr("The value rounded to three decimals, with a zero added."));
    rows.reproduced(joined(Message{Text::tr("P₄ at ℓ₂ = %1 m"), 0.1}, Text::tr("Fig. 6c")), "N",
                    "15.4167", weight(0.1), reason);
}

void stated(PaperRows& rows) {
    const Input input = elastic_hinge::preset_zotov();
    const double g = input.gravity;
    rows.at(in_text(after_equation(3)));
    rows.given("c", "N/m", "20000000", input.spring->stiffness);
    rows.given("r", "m", "0.05", input.crank_radius);
    rows.given("ℓ₀", "m", "0.2", input.spring->free_length);
    rows.given("P₁", "N", "5", input.crank_mass * g);
    rows.given("P₂", "N", "6.5", input.rod_mass * g);
    rows.given("P₃", "N", "6", input.slider_mass * g);
    rows.given("λ", "", "0.3", input.lambda);
    rows.given("ω", Text::tr("s⁻¹").english, "100", input.angular_speed);
    rows.given("g", "m/s²", "9.82", g);
    rows.given(Text::tr("guides 2: ρ₀"), "m", "0.09", input.spring->guide_radius_at_zero);
    const Text chosen = Text::tr("The paper chooses it as an example.");
    for (const int number : {4, 6}) {
        rows.at(figure(number));
        for (const char* speed : {"100", "300", "500"}) {
            rows.given({Text{"ω = %1"}, speed}, Text::tr("s⁻¹").english, speed, std::nullopt,
                       chosen);
        }
    }
    rows.at(figure(4));
    for (const char* lambda : {"0.3", "0.4", "0.6", "0.8", "1"}) {
        rows.given({Text{"λ = %1"}, lambda}, "", lambda, std::nullopt, chosen);
    }
    rows.at(in_text(after_equation(10)));
    for (const char* distance : {"0.05", "0.1", "0.15"}) {
        rows.given({Text{"ℓ₂ = %1"}, distance}, "m", distance, std::nullopt, chosen);
    }
}

}  // namespace

std::vector<ValidationRow> validate_zotov_sviridov() {
    PaperRows rows("elastic-hinge");
    rows.at(in_text(Text::tr("introduction")));
    rows.not_derivable(Text::tr("flywheel's share of an engine's inertia"), "%", "80",
                       Text::tr("Quoted from another paper."));
    guide(rows);
    rod_hinge_integral(rows);
    vanishing_integrals(rows);
    factor_in_crank_moment(rows);
    counterweight(rows);
    stated(rows);
    return rows.take();
}

}  // namespace ravnoves::methods
