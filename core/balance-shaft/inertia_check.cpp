#include "balance-shaft/inertia_check.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "balance-shaft/input.h"
#include "balance-shaft/result.h"
#include "case-file/decimal.h"
#include "numerics/angle.h"
#include "numerics/slider_crank.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr double from_deg = 15.0;  ///< nearer to the dead centres the gas still works
constexpr double to_deg = 165.0;
constexpr std::size_t fewest_rows = 5;
constexpr double min_lambda = 0.02;
constexpr double largest_lambda = 0.6;

/// On a crank of radius 1 whose cylinder is offset by K, at an angle φ from top dead centre.
PistonMotion<double> unit_motion(double lambda, double relative_offset, double angle) {
    const SliderCrank<double> crank{1.0, 1.0 / lambda, relative_offset};
    return crank.at(angle + crank.top_dead_centre());
}

/// Where the rod is not known, λ is searched up to what lets the crank turn round.
double max_lambda(double relative_offset) {
    return std::min(largest_lambda, 0.999 / (1.0 + std::abs(relative_offset)));
}

struct Row {
    double angle;  ///< of the crank from the dead centre that begins the stroke, rad
    double torque;
    double weight;
};

struct Fit {
    double scale = 0.0;  ///< C, N·m; 0 or less where nothing is found
    double lambda = 0.0;
    double residual = 0.0;  ///< weighted RMS, N·m
    bool at_bound = false;  ///< λ ends on a bound of its search

    /// How much it leaves, as a part of what it found.
    double badness() const {
        return scale > 0.0 ? residual / scale : std::numeric_limits<double>::infinity();
    }
};

/// Without the rows on the line between their neighbours: a table tells the same however finely its
/// lines are sampled.
TorqueTable corners_of(const TorqueTable& table) {
    double largest = 0.0;
    for (const double torque : table.torque) {
        largest = std::max(largest, std::abs(torque));
    }
    const std::vector<double>& angle = table.crank_angle_deg;
    TorqueTable corners;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const bool is_end = i == 0 || i + 1 == table.size();
        const double part =
            is_end ? 0.0 : (angle[i] - angle[i - 1]) / (angle[i + 1] - angle[i - 1]);
        if (is_end || std::abs(std::lerp(table.torque[i - 1], table.torque[i + 1], part) -
                               table.torque[i]) > 1e-9 * largest) {
            corners.crank_angle_deg.push_back(angle[i]);
            corners.torque.push_back(table.torque[i]);
        }
    }
    return corners;
}

/// Rows between begin + 15° and begin + 165° with the weights of the trapezoidal rule.
std::vector<Row> rows_of_stroke(const TorqueTable& table, double begin_deg) {
    std::vector<Row> rows;
    const std::size_t count = table.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        const double period = 180.0 * strokes_of(table.crank_angle_deg);
        const double angle = wrap(table.crank_angle_deg[i] - begin_deg, period);
        if (angle < from_deg - 1e-9 || angle > to_deg + 1e-9) {
            continue;
        }
        const double before = i == 0
                                  ? table.crank_angle_deg[count] - table.crank_angle_deg[count - 1]
                                  : table.crank_angle_deg[i] - table.crank_angle_deg[i - 1];
        const double after = table.crank_angle_deg[i + 1] - table.crank_angle_deg[i];
        rows.push_back({angle * degree, table.torque[i], before + after});
    }
    return rows;
}

/// @param lambda_given  r/L where it is known
Fit fit_stroke(const TorqueTable& table, double relative_offset, double begin_deg,
               std::optional<double> lambda_given) {
    const std::vector<Row> rows = rows_of_stroke(table, begin_deg);
    if (rows.size() < fewest_rows) {
        return {};
    }
    double weights = 0.0;
    double squares = 0.0;
    for (const Row& row : rows) {
        weights += row.weight;
        squares += row.weight * row.torque * row.torque;
    }
    if (!(squares > 0.0)) {
        return {};
    }
    // For each λ the other two are linear: C g(θ; λ) − d s′(θ; λ) by the normal equations.
    const auto fit_at = [&](double lambda) -> Fit {
        Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
        Eigen::Vector2d right = Eigen::Vector2d::Zero();
        for (const Row& row : rows) {
            const PistonMotion<double> motion = unit_motion(lambda, relative_offset, row.angle);
            const Eigen::Vector2d basis(-motion.ds * motion.d2s, -motion.ds);
            normal += row.weight * basis * basis.transpose();
            right += row.weight * row.torque * basis;
        }
        const Eigen::Vector2d found = normal.inverse() * right;
        return {.scale = found.x(),
                .lambda = lambda,
                .residual = std::sqrt(std::max(squares - found.dot(right), 0.0) / weights)};
    };
    if (lambda_given) {
        return fit_at(*lambda_given);
    }
    // A scan first: the residual may have more than one minimum over λ.
    const auto residual_at = [&](double lambda) { return fit_at(lambda).residual; };
    constexpr int scans = 16;
    const double maximum = max_lambda(relative_offset);
    const double step = (maximum - min_lambda) / scans;
    int best = 0;
    double minimum = residual_at(min_lambda);
    for (int i = 1; i <= scans; ++i) {
        const double residual = residual_at(min_lambda + i * step);
        if (residual < minimum) {
            minimum = residual;
            best = i;
        }
    }
    Fit fit = fit_at(boost::math::tools::brent_find_minima(
                         residual_at, std::max(min_lambda, min_lambda + (best - 1) * step),
                         std::min(maximum, min_lambda + (best + 1) * step), 30)
                         .first);
    constexpr double near_bound = 1e-3;
    fit.at_bound = fit.lambda < min_lambda + near_bound || fit.lambda > maximum - near_bound;
    return fit;
}

}  // namespace

double unit_inertia_torque(const Input& input, double lambda, double crank_angle_deg) {
    const PistonMotion<double> motion =
        unit_motion(lambda, input.cylinder.offset / input.crank_radius, crank_angle_deg * degree);
    return -motion.ds * motion.d2s;
}

InertiaCheck check_inertia(const Input& input) {
    InertiaCheck check;
    const double speed = input.angular_speed;
    const double mass = input.reciprocating_mass();
    check.entered = mass * input.crank_radius * input.crank_radius * speed * speed;
    if (input.torque.is_computed()) {
        check.text = Text::tr(
            "The torque is computed from the masses and the speed: no check is "
            "necessary.");
        return check;
    }
    const TorqueTable table = corners_of(input.torque.table);
    const std::optional<double> lambda =
        input.cylinder.rod_length ? std::optional(input.crank_radius / *input.cylinder.rod_length)
                                  : std::nullopt;
    check.lambda_fitted = !lambda;
    const bool four_stroke = strokes_of(table.crank_angle_deg) == 4;
    const double offset = input.cylinder.offset / input.crank_radius;
    const auto best_fit = [&](const std::optional<double>& held) {
        const Fit first = fit_stroke(table, offset, 0.0, held);
        const Fit second = four_stroke ? fit_stroke(table, offset, 360.0, held) : Fit{};
        return second.badness() < first.badness() ? second : first;
    };
    const auto is_believed = [](const Fit& fit) {
        return fit.badness() <= InertiaCheck::largest_residual;
    };
    Fit fit = best_fit(lambda);
    if (lambda && !is_believed(fit)) {
        const Fit free = best_fit(std::nullopt);
        if (is_believed(free) && !free.at_bound) {
            fit = free;
            check.is_of_other_rod = check.lambda_fitted = true;
        }
    }
    const auto moment = [](double value) {
        return Number{rounded_to_digits(value, 3), units::N_m};
    };
    const auto number = [](double value) { return Number{rounded_to_digits(value, 3)}; };
    if (!is_believed(fit) || !(check.entered > 0.0)) {
        check.is_of_other_rod = false;
        check.lambda_fitted = !lambda;
        check.text = four_stroke
                         ? Text::tr(
                               "The torque during gas exchange does not resemble an inertia "
                               "torque, so masses and speed cannot be checked.")
                         : Text::tr(
                               "A two-stroke engine has no stroke with a small gas torque, "
                               "so masses and speed cannot be checked.");
        return check;
    }
    if (fit.at_bound) {
        check.text = {Text::tr("Masses and speed cannot be checked, because the fitted r/L = %1 is "
                               "at the limit of the search: enter the rod length."),
                      number(fit.lambda)};
        return check;
    }
    check.fitted = fit.scale;
    check.fitted_lambda = fit.lambda;
    check.residual_rms = fit.residual;
    const double ratio = fit.scale / check.entered;
    check.consistent = !check.is_of_other_rod && std::abs(ratio - 1.0) <= InertiaCheck::tolerance;
    check.matching_speed = speed * std::sqrt(ratio);
    check.matching_mass = mass * ratio;
    if (check.is_of_other_rod) {
        check.warning = Text::tr("Torque and rod do not match.");
        check.text = {
            Text::tr("Torque and rod do not match, so the best angles are not meaningful: r/L is "
                     "%1 in the torque, %2 by the input; the torque fits a rod length of %3."),
            number(fit.lambda), number(*lambda),
            Number{rounded_to_digits(input.crank_radius / fit.lambda / units::mm, 3), units::mm}};
        return check;
    }
    const Number fitting_speed{rounded_to_digits(check.matching_speed / units::rpm, 4), units::rpm};
    const Number fitting_mass{rounded_to_digits(check.matching_mass, 3), units::kg};
    const double difference = std::abs(ratio - 1.0);
    const double bore = input.effective_bore();
    const double doubt =
        InertiaCheck::masses_doubt +
        (InertiaCheck::pressure_doubt * pi / 4.0 * bore * bore * input.crank_radius +
         InertiaCheck::residual_doubt * fit.residual) /
            check.entered;
    if (!*check.consistent) {
        check.warning = {Text::tr("Torque and masses do not match: the torque fits %1 or %2."),
                         fitting_speed, fitting_mass};
    } else if (difference > doubt) {
        check.warning = {Text::tr("Torque and masses differ by %1: the torque fits %2 or %3."),
                         in_percent(difference), fitting_speed, fitting_mass};
    }
    const Message found =
        *check.consistent
            ? Message(Text::tr("Torque and masses differ by %1; the uncertainty of the check is "
                               "%2."),
                      in_percent(difference), in_percent(doubt))
            : Message(Text::tr("Torque and masses do not match, so the best angles are not "
                               "meaningful."));
    check.text = {Text{"%1 %2"}, found,
                  Message(Text::tr("mⱼ r² ω² is %1 in the torque (r/L = %2), %3 by the input; the "
                                   "torque fits %4 or %5."),
                          moment(fit.scale), number(fit.lambda), moment(check.entered),
                          fitting_speed, fitting_mass)};
    return check;
}

Input with_rebuilt_torque(const Input& input, const InertiaCheck& check) {
    Input changed = input;
    if (!check.fitted || input.torque.is_computed()) {
        return changed;
    }
    const double lambda = input.cylinder.rod_length
                              ? input.crank_radius / *input.cylinder.rod_length
                              : check.fitted_lambda;
    TorqueTable& table = changed.torque.table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double angle = table.crank_angle_deg[i];
        table.torque[i] += check.entered * unit_inertia_torque(input, lambda, angle) -
                           *check.fitted * unit_inertia_torque(input, check.fitted_lambda, angle);
        // What the sines leave at their zeros is no torque.
        if (std::abs(table.torque[i]) < 1e-12 * std::max(std::abs(check.entered), *check.fitted)) {
            table.torque[i] = 0.0;
        }
    }
    table.torque.back() = table.torque.front();
    changed.torque.kind = TorqueSource::Kind::table;
    changed.torque.csv.name.clear();
    return changed;
}

}  // namespace ravnoves::balance_shaft
