#include "balance-shaft/inertia_check.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <vector>

#include "balance-shaft/input.h"
#include "case-file/range.h"
#include "numerics/slider_crank.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr double from_deg = 15.0;  ///< nearer to the dead centres the gas still works
constexpr double to_deg = 165.0;
constexpr std::size_t fewest_rows = 5;
constexpr double least_lambda = 0.02;
constexpr double largest_lambda = 0.6;
/// A fit that leaves more than this of the torque's RMS has not found an inertia torque.
constexpr double largest_residual = 0.4;

/// Inertia torque for m_j r² ω² = 1: −s′ s″/r².
double unit_torque(double lambda, double sine, double cosine) {
    const PistonMotion<double> motion = SliderCrank<double>{1.0, 1.0 / lambda}.at(sine, cosine);
    return -motion.ds * motion.d2s;
}

struct Row {
    double sine;  ///< of the crank angle from the dead centre that begins the stroke
    double cosine;
    double torque;
    double weight;
};

struct Fit {
    double scale = 0.0;  ///< C, N·m
    double lambda = 0.0;
    double gas = 0.0;       ///< d, N·m
    double residual = 0.0;  ///< weighted RMS, N·m
    double size = 0.0;      ///< weighted RMS of the torque, N·m
    double begin_deg = 0.0;
    bool found = false;
};

/// Rows between begin + 15° and begin + 165° with the weights of the trapezoidal rule, so that
/// rows put in on a line change little.
std::vector<Row> rows_of_stroke(const TorqueTable& table, double begin_deg) {
    std::vector<Row> rows;
    const std::size_t count = table.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        double angle = std::fmod(table.crank_angle_deg[i] - begin_deg, 720.0);
        if (angle < 0.0) {
            angle += 720.0;
        }
        if (angle < from_deg - 1e-9 || angle > to_deg + 1e-9) {
            continue;
        }
        const double before = i == 0
                                  ? table.crank_angle_deg[count] - table.crank_angle_deg[count - 1]
                                  : table.crank_angle_deg[i] - table.crank_angle_deg[i - 1];
        const double after = table.crank_angle_deg[i + 1] - table.crank_angle_deg[i];
        rows.push_back(
            {std::sin(angle * degree), std::cos(angle * degree), table.torque[i], before + after});
    }
    return rows;
}

Fit fit_stroke(const TorqueTable& table, double begin_deg) {
    const std::vector<Row> rows = rows_of_stroke(table, begin_deg);
    Fit fit;
    fit.begin_deg = begin_deg;
    if (rows.size() < fewest_rows) {
        return fit;
    }
    double weights = 0.0;
    double squares = 0.0;
    for (const Row& row : rows) {
        weights += row.weight;
        squares += row.weight * row.torque * row.torque;
    }
    fit.size = std::sqrt(squares / weights);
    if (!(fit.size > 0.0)) {
        return fit;
    }
    // For each λ the other two are linear: C g(θ; λ) + d sin θ by the normal equations.
    struct Linear {
        double scale;
        double gas;
        double residual;
    };
    const auto solve_at = [&](double lambda) -> Linear {
        double gg = 0.0;
        double gs = 0.0;
        double ss = 0.0;
        double gt = 0.0;
        double st = 0.0;
        for (const Row& row : rows) {
            const double g = unit_torque(lambda, row.sine, row.cosine);
            const double s = row.sine;
            gg += row.weight * g * g;
            gs += row.weight * g * s;
            ss += row.weight * s * s;
            gt += row.weight * g * row.torque;
            st += row.weight * s * row.torque;
        }
        const double determinant = gg * ss - gs * gs;
        const double scale = (ss * gt - gs * st) / determinant;
        const double gas = (gg * st - gs * gt) / determinant;
        const double square = squares - scale * gt - gas * st;
        return {scale, gas, std::sqrt(std::max(square, 0.0) / weights)};
    };
    const auto residual_at = [&](double lambda) { return solve_at(lambda).residual; };
    // A scan first: the residual may have more than one minimum over λ.
    constexpr int scans = 16;
    const double step = (largest_lambda - least_lambda) / scans;
    int best = 0;
    double least = residual_at(least_lambda);
    for (int i = 1; i <= scans; ++i) {
        const double residual = residual_at(least_lambda + i * step);
        if (residual < least) {
            least = residual;
            best = i;
        }
    }
    const auto [lambda, residual] = boost::math::tools::brent_find_minima(
        residual_at, std::max(least_lambda, least_lambda + (best - 1) * step),
        std::min(largest_lambda, least_lambda + (best + 1) * step), 30);
    fit.lambda = lambda;
    fit.residual = residual;
    fit.scale = solve_at(lambda).scale;
    fit.gas = solve_at(lambda).gas;
    fit.found = fit.scale > 0.0 && residual <= largest_residual * fit.size;
    return fit;
}

}  // namespace

InertiaCheck check_inertia(const TorqueTable& table, const Input& input) {
    InertiaCheck check;
    const double speed = input.angular_speed;
    const double mass = input.reciprocating_mass();
    check.entered = mass * input.crank_radius * input.crank_radius * speed * speed;
    const Fit first = fit_stroke(table, 0.0);
    const Fit second = fit_stroke(table, 360.0);
    const bool take_second = second.found && (!first.found || second.residual * first.size <
                                                                  first.residual * second.size);
    const Fit& fit = take_second ? second : first;
    if (!fit.found || !(check.entered > 0.0)) {
        check.text = CORE_TEXT(
            "balance-shaft",
            "The torque on the gas-exchange strokes does not look like the inertia torque "
            "of a slider-crank, so it cannot be compared with the masses and the speed "
            "entered.");
        return check;
    }
    check.fitted = fit.scale;
    check.fitted_lambda = fit.lambda;
    check.gas_exchange = fit.gas;
    check.residual_rms = fit.residual;
    check.stroke_begin_deg = fit.begin_deg;
    const double ratio = fit.scale / check.entered;
    check.consistent = std::abs(ratio - 1.0) <= InertiaCheck::tolerance;
    check.matching_speed = speed * std::sqrt(ratio);
    check.matching_mass = mass * ratio;
    const auto number = [](double value, int digits = 3) {
        return Number{rounded_to(value, digits)};
    };
    check.text =
        *check.consistent
            ? Message(CORE_TEXT("balance-shaft",
                                "The torque on the gas-exchange stroke holds an inertia torque of "
                                "m_j r² ω² = %1 N·m (r/L = %2); the masses and the speed entered "
                                "give %3 N·m. They belong together."),
                      number(fit.scale), number(fit.lambda), number(check.entered))
            : Message(CORE_TEXT("balance-shaft",
                                "The torque on the gas-exchange stroke holds an inertia torque of "
                                "m_j r² ω² = %1 N·m (r/L = %2); the masses and the speed entered "
                                "give %3 N·m. They do not belong together: the torque fits these "
                                "masses at %4 min⁻¹, or %5 kg at this speed. The best angle found "
                                "below is that of no real engine until they agree."),
                      number(fit.scale), number(fit.lambda), number(check.entered),
                      number(check.matching_speed / units::rpm, 4), number(check.matching_mass));
    return check;
}

Input with_matching_speed(const Input& input, const InertiaCheck& check) {
    Input changed = input;
    if (check.fitted) {
        changed.angular_speed = check.matching_speed;
    }
    return changed;
}

Input with_rebuilt_torque(const Input& input, const InertiaCheck& check) {
    Input changed = input;
    if (!check.fitted || input.torque.is_computed()) {
        return changed;
    }
    const double lambda =
        input.rod_length ? input.crank_radius / *input.rod_length : check.fitted_lambda;
    TorqueTable& table = changed.torque.table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double sine = std::sin(table.crank_angle_deg[i] * degree);
        const double cosine = std::cos(table.crank_angle_deg[i] * degree);
        table.torque[i] += check.entered * unit_torque(lambda, sine, cosine) -
                           *check.fitted * unit_torque(check.fitted_lambda, sine, cosine);
    }
    table.torque.back() = table.torque.front();
    changed.torque.kind = TorqueSource::Kind::table;
    changed.torque.csv.clear();
    return changed;
}

}  // namespace ravnoves::balance_shaft
