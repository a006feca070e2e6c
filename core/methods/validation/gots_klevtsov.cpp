/// The numbers of [gots-klevtsov].

#include <algorithm>
#include <cmath>
#include <numeric>

#include "balance-shaft/presets.h"
#include "balance-shaft/solver.h"
#include "methods/validation/gots_klevtsov_tables.h"
#include "methods/validation/rows.h"
#include "numerics/constants.h"
#include "numerics/units.h"

namespace ravnoves::methods {

namespace {

using balance_shaft::Result;
using balance_shaft::Solver;

constexpr double cycle_deg = 720.0;

/// The mean of a moment over nodes of the cycle with both ends, as the paper averages.
template <typename Moment>
double node_mean(const Moment& moment, double step_deg) {
    const auto steps = static_cast<int>(std::round(cycle_deg / step_deg));
    double sum = 0.0;
    for (int i = 0; i <= steps; ++i) {
        sum += moment(step_deg * i * degree);
    }
    return sum / (steps + 1);
}

/// All that the rows are taken from.
struct Engine {
    Solver solver{balance_shaft::preset_tmz_650d()};
    Result result = solver.result();

    double M_s(double phi_deg, double alpha_deg) const {
        return solver.M_s(phi_deg * degree, alpha_deg * degree);
    }
    double M_up(double phi_deg) const { return solver.M_up(phi_deg * degree); }
    double range(double alpha_deg) const { return solver.range(alpha_deg * degree); }
    /// M_sm: of nodes, the cycle's end counted twice.
    double mean_of_nodes(double alpha_deg, double step_deg) const {
        return node_mean([&](double phi) { return solver.M_s(phi, alpha_deg * degree); }, step_deg);
    }
    /// Whether nodes of that step give the largest mean that Table 3 prints, that of α = 90°.
    bool has_printed_mean(double step_deg) const {
        const Printed printed = read_printed(gots_klevtsov::table_3_means[3]);
        return std::abs(mean_of_nodes(90.0, step_deg) - printed.value) <= 0.5 * printed.last_digit;
    }
    /// By how much a shaft lowers the node mean of the moment on the mounts, %.
    double cut_of_node_mean(double alpha_deg) const {
        return -100.0 * mean_of_nodes(alpha_deg, gots_klevtsov::table_2_step) /
               result.printed_mean_M_up;
    }
    /// The true cut, %.
    double cut_of_mean() const { return 100.0 * (1.0 - result.M_ups.mean / result.M_up.mean); }
};

void masses(const Engine& engine, PaperRows& rows) {
    const auto& input = engine.solver.input();
    const auto part = [&](std::size_t i) { return input.reciprocating_masses.at(i).mass; };
    const Text unused = Text::tr("Stated by the paper; not used in any computation.");
    rows.at(table(1));
    rows.given(Text::tr("piston mₚ"), "kg", "0.645", part(0));
    rows.given(Text::tr("piston mₚ, in brackets"), "kg", "0.640", std::nullopt, unused);
    rows.given(Text::tr("piston pin mₚₚ"), "kg", "0.241", part(1));
    rows.given(Text::tr("piston rings mₚᵣ"), "kg", "0.1", part(2));
    rows.given(Text::tr("connecting rod mₛₕ"), "kg", "0.950", input.rod_mass);
    rows.given(Text::tr("connecting rod mₛₕ, ±"), "kg", "0.015", std::nullopt, unused);
    rows.given(Text::tr("rod's part at the pin m₁"), "kg", "0.33", part(3));
}

void first_order_forces(const Engine& engine, PaperRows& rows) {
    const Result& r = engine.result;
    const auto& input = engine.solver.input();
    constexpr double rounded_pi = 3.14;
    const Printed speed = read_printed("3600");  // min⁻¹
    const Printed stroke = read_printed("9.2");  // cm, of the type 1Ch9.55/9.2
    rows.at(in_text(Text::tr("dynamic calculation")));
    rows.given(Text::tr("bore in the engine's type"), Text::tr("cm").english, "9.55",
               *input.cylinder.bore * 100.0);
    rows.given(Text::tr("stroke in the engine's type"), Text::tr("cm").english, "9.2",
               2.0 * input.crank_radius * 100.0);
    rows.given(Text::tr("counterweight's radius ρ₁"), "m", "0.046", input.counterweight_radius);
    rows.slip({Text::tr("angular speed ω at %1 min⁻¹"), 3600}, "rad/s", "376.8",
              speed.value * units::rpm, speed.value * rounded_pi / 30.0,
              Text::tr("π is rounded to 3.14."));
    rows.reproduced(Text::tr("crank radius r"), "m", "0.046", stroke.value / 200.0,
                    Text::tr("Half the stroke of 9.2 cm in the engine's type."));
    rows.reproduced(Text::tr("reciprocating mass mⱼ"), "kg", "1.316", r.reciprocating_mass,
                    Text::tr("The sum of Table 1 with the heavier piston."));
    rows.reproduced(Text::tr("first-order inertia force Pⱼ₁ max"), "N", "8594.8",
                    r.inertia_force_1_max, Text::tr("mⱼ r ω² at the printed 376.8 rad/s."));
    rows.reproduced(
        Text::tr("counterweight m₁"), "kg", "0.658",
        input.reciprocating_mass() * input.crank_radius / (2.0 * input.counterweight_radius),
        Text::tr("Equation (1)."));
    rows.reproduced(Text::tr("counterweight's force P₁"), "N", "4297.4", r.counterweight_force,
                    Text::tr("m₁ ρ₁ ω²."));
    rows.not_derivable(Text::tr("rated power"), "kW", "12",
                       Text::tr("Friction losses are not printed; our value is the indicated "
                                "power of Table 2 at the printed speed."),
                       r.M_up.mean * -r.angular_speed / units::kW);
    rows.not_derivable(Text::tr("speed of Table 2"), "min⁻¹", "3600",
                       Text::tr("The program of Table 2 is not published; our value is the speed "
                                "at which its inertia torque matches the masses of Table 1."),
                       r.inertia_check.matching_speed / units::rpm);
}

void table_2(const Engine& engine, PaperRows& rows) {
    rows.at(table(2));
    double phi = 0.0;
    for (std::size_t i = 0; i < gots_klevtsov::table_2.size(); ++i) {
        rows.given({Text{"Mᵢ(φ = %1°)"}, phi}, "N·m",
                   gots_klevtsov::opposite(gots_klevtsov::table_2[i]),
                   engine.solver.input().torque.table.torque.at(i));
        rows.given({Text{"Mᵤₚ(φ = %1°)"}, phi}, "N·m", gots_klevtsov::table_2[i], engine.M_up(phi),
                   Text::tr("Mᵤₚ = −Mᵢ, the program's input."));
        phi += gots_klevtsov::table_2_step;
    }
    const Text reason = Text::tr(
        "The mean of the 49 rows counts the end of the cycle, 720° = 0°, "
        "twice; our value is the cycle integral.");
    const double mean = engine.result.M_up.mean;
    const double of_rows = engine.result.printed_mean_M_up;
    rows.artefact(Text::tr("mean of Mᵢ"), "N·m", "37.9", -mean, -of_rows, reason);
    rows.artefact(Text::tr("mean of Mᵤₚ"), "N·m", "-37.9", mean, of_rows, reason);
}

void table_3(const Engine& engine, PaperRows& rows) {
    using gots_klevtsov::table_3_columns;
    using gots_klevtsov::table_3_step;
    constexpr double scatter = 0.01;
    rows.at(table(3));
    rows.reproduced(Text::tr("counterweight m₁"), "kg", "0.658", engine.result.counterweight_mass,
                    Text::tr("Equation (1)."));
    rows.given(Text::tr("step of Table 3"), "°", "30", table_3_step);
    const Text reason = Text::tr(
        "To 0.01 N·m: l is not printed. Our value follows from the largest entry, "
        "rounded to 0.01 mm; equal printed entries differ by 0.01.");
    for (std::size_t i = 0; i < gots_klevtsov::table_3_rows; ++i) {
        const double phi = table_3_step * static_cast<double>(i);
        rows.at(table(3));
        for (std::size_t k = 0; k < table_3_columns; ++k) {
            const double alpha = table_3_step * static_cast<double>(k);
            const std::string printed = gots_klevtsov::table_3(i, k);
            if (k + 1 < table_3_columns) {
                rows.reproduced({Text{"Mₛ(φ = %1°, α = %2°)"}, phi, alpha}, "N·m", printed,
                                engine.M_s(phi, alpha), reason, scatter);
            } else {
                rows.slip(joined(Text::tr("last column"), Message{Text{"Mᵤₚ(φ = %1°)"}, phi}),
                          "N·m", printed, engine.M_up(phi), engine.M_s(phi, alpha),
                          Text::tr("The column is headed Mᵤₚ but contains Mₛ of α = 330°."),
                          scatter);
            }
        }
    }
    for (std::size_t k = 0; k + 1 < table_3_columns; ++k) {
        const double alpha = table_3_step * static_cast<double>(k);
        rows.artefact({Text::tr("mean Mₛₘ(α = %1°)"), alpha}, "N·m",
                      gots_klevtsov::table_3_means[k], 0.0,
                      engine.mean_of_nodes(alpha, table_3_step),
                      Text::tr("The mean of the 25 rows counts the end of the cycle twice; the "
                               "cycle mean of a sine is 0 for every α."));
    }
    rows.artefact(Text::tr("mean under the last column"), "N·m",
                  gots_klevtsov::table_3_means.back(), engine.result.M_up.mean,
                  engine.result.printed_mean_M_up,
                  Text::tr("The mean of the 49 rows of Table 2, not of the 25 values above it; "
                           "the end of the cycle is counted twice."));
}

/// The coarsest step whose node mean of M_s is the printed one; 0 where none is.
double step_of_printed_means(const Engine& engine) {
    constexpr double steps[] = {30.0, 15.0, 10.0, 5.0};
    const auto* const found = std::find_if(std::begin(steps), std::end(steps), [&](double step) {
        return engine.has_printed_mean(step);
    });
    return found == std::end(steps) ? 0.0 : *found;
}

/// The last α from which on, up to a whole turn, M_sm of the nodes stays below zero.
double begin_of_negative_means(const Engine& engine) {
    const auto& sweep = engine.result.sweep;
    constexpr double rounding = 1e-9;
    std::size_t begin = sweep.shaft_angle_deg.size() - 1;
    while (begin > 0 && sweep.printed_mean_M_s[begin - 1] < rounding) {
        --begin;
    }
    return sweep.shaft_angle_deg[begin];
}

/// The α from which on, up to those of negative means, M_sm of the nodes stays above zero.
double begin_of_positive_means(const Engine& engine) {
    const auto& sweep = engine.result.sweep;
    constexpr double rounding = 1e-9;
    const auto largest =
        std::max_element(sweep.printed_mean_M_s.begin(), sweep.printed_mean_M_s.end());
    auto begin = static_cast<std::size_t>(largest - sweep.printed_mean_M_s.begin());
    while (begin > 0 && sweep.printed_mean_M_s[begin] > rounding) {
        --begin;
    }
    return sweep.shaft_angle_deg[begin];
}

/// The α at which M_s is largest at a crank angle: at 0° where it is a cosine, as the paper says of
/// α = 180°, at 90° where it is a sine.
double angle_of_peak(const Engine& engine, double phi_deg) {
    const auto& angles = engine.result.sweep.shaft_angle_deg;
    return *std::max_element(angles.begin(), angles.end(), [&](double a, double b) {
        return engine.M_s(phi_deg, a) < engine.M_s(phi_deg, b);
    });
}

void means_over_the_angle(const Engine& engine, PaperRows& rows) {
    const double negative_from = begin_of_negative_means(engine);
    const double turn = engine.result.sweep.shaft_angle_deg.back();
    rows.at(in_text(Message{Text::tr("before Table %1"), 3}));
    const double step = step_of_printed_means(engine);
    // No number but a comparison shows it.
    const bool is_shown = engine.has_printed_mean(step) && !engine.has_printed_mean(5.0);
    rows.slip(Text::tr("step of the means Mₛₘ in Table 3"), "°", "5", step,
              is_shown ? 5.0 : std::nan(""),
              Text::tr("Only the 25 printed rows give the printed means; rows every 5° "
                       "would give a sixth of them."));
    rows.at(in_text(Text::tr("results")));
    rows.reproduced(Text::tr("α at which Mₛ is a sine"), "°", "0", angle_of_peak(engine, 90.0),
                    Text::tr("There Mₛ is P₁ l sin φ."));
    rows.slip(Text::tr("α at which Mₛ is a cosine"), "°", "180", angle_of_peak(engine, 0.0),
              negative_from,
              Text::tr("At 180° the mean of the nodes is 0 too, but Mₛ is a sine there; Mₛ is a "
                       "cosine at 90°."));
    const Text positive = Text::tr(
        "The mean of the nodes is positive up to there; the cycle mean "
        "of Mₛ is 0 for every α.");
    rows.artefact(Text::tr("lower end of the α that lower the mean"), "°", "0", std::nullopt,
                  begin_of_positive_means(engine),
                  Text::tr("The mean of the nodes is positive from there; the cycle mean of Mₛ "
                           "is 0 for every α."));
    rows.artefact(Text::tr("upper end of the α that lower the mean"), "°", "180", std::nullopt,
                  negative_from, positive);
    rows.artefact(Text::tr("lower end of the α with Mₛₘ < 0"), "°", "180", std::nullopt,
                  negative_from,
                  Text::tr("The nodes agree; the cycle mean of Mₛ is 0 for every α."));
    rows.slip(
        Text::tr("upper end of the α with Mₛₘ < 0"), "°", "60", turn, std::fmod(turn, 100.0),
        Text::tr("360 without its first digit: Mₛₘ of the nodes is negative from 180° to 360°."));
    rows.artefact(Text::tr("α from which Mₛₘ changes its sign"), "°", "180", std::nullopt,
                  negative_from,
                  Text::tr("The nodes agree; the cycle mean of Mₛ is 0 for every α."));
    rows.artefact(Text::tr("α from which Mₛₘ is negative"), "°", "180", std::nullopt, negative_from,
                  Text::tr("The nodes agree; the cycle mean of Mₛ is 0 for every α."));
    rows.given({Text::tr("α of Fig. %1"), 2}, "°", "45",
               engine.solver.input().shaft_angle / degree);
    // The cut of the node mean is proportional to sin α.
    const auto angle_of_cut = [&](double percent) {
        return Number{std::asin(percent / engine.cut_of_node_mean(90.0)) / degree, units::none, 3};
    };
    const Message reason{
        Text::tr("The paper names no α. The mean of the 49 rows (end counted twice) falls by 12 % "
                 "at α from %1 to %2° and by 16 % from %3 to %4°. We use 30° (start of the "
                 "paper's range) and 45° (Fig. 2); no shaft changes the cycle mean."),
        angle_of_cut(11.5), angle_of_cut(12.5), angle_of_cut(15.5), angle_of_cut(16.5)};
    rows.at(Text::tr("abstract"));
    const auto cut = [&](const char* printed, double alpha) {
        rows.artefact({Text::tr("cut of the mean moment, by our choice at α = %1°"), alpha}, "%",
                      printed, engine.cut_of_mean(), engine.cut_of_node_mean(alpha), reason);
    };
    cut("12", 30.0);
    cut("16", 45.0);
}

/// Where the range equals that of the engine without a shaft, going from the best α outwards.
double end_of_gain(const Engine& engine, double direction) {
    const double without = engine.result.M_up.range;
    const double best = *engine.result.best_range.shaft_angle / degree;
    double inside = best;
    double outside = best + 90.0 * direction;
    for (int i = 0; i < 60; ++i) {
        const double middle = std::midpoint(inside, outside);
        (engine.range(middle) < without ? inside : outside) = middle;
    }
    return inside;
}

void ranges(const Engine& engine, PaperRows& rows) {
    const auto& sweep = engine.result.sweep;
    const auto worst = std::max_element(sweep.range.begin(), sweep.range.end());
    const double worst_angle =
        sweep.shaft_angle_deg[static_cast<std::size_t>(worst - sweep.range.begin())];
    rows.at(in_text(Text::tr("results")));
    rows.reproduced(Text::tr("α of the maximum ΔMᵤₚₛ"), "°", "240", worst_angle,
                    Text::tr("Maximum over all α."));
    rows.not_derivable(
        Text::tr("maximum ΔMᵤₚₛ"), "N·m", "1802",
        Text::tr("From a torque table of 5° that is not printed; our value uses the 15° table."),
        engine.range(240.0));
    // Both ends by one standard: the paper prints none, and ours tells what the range does there.
    const auto ends = [&](Text quantity) {
        const Text reason = Text::tr(
            "No criterion is printed; our ends enclose the α with a "
            "smaller range than without a shaft.");
        rows.not_derivable(lower_end(quantity), "°", "30", reason, end_of_gain(engine, -1.0));
        rows.not_derivable(upper_end(quantity), "°", "90", reason, end_of_gain(engine, 1.0));
    };
    ends(Text::tr("rational α"));
    rows.not_derivable(Text::tr("α below which the overall size shrinks"), "°", "180",
                       Text::tr("No sizes of the engine are printed."));
    rows.at(Text::tr("abstract"));
    rows.not_derivable(Text::tr("maximum α advised"), "°", "90",
                       Text::tr("No criterion is printed; our value is where the range becomes as "
                                "large as without a shaft."),
                       end_of_gain(engine, 1.0));
    rows.at(Text::tr("conclusions"));
    ends(Text::tr("advised α"));
}

}  // namespace

std::vector<ValidationRow> validate_gots_klevtsov() {
    const Engine engine;
    PaperRows rows("balance-shaft");
    masses(engine, rows);
    first_order_forces(engine, rows);
    table_2(engine, rows);
    table_3(engine, rows);
    means_over_the_angle(engine, rows);
    ranges(engine, rows);
    return rows.take();
}

}  // namespace ravnoves::methods
