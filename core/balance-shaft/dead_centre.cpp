#include "balance-shaft/dead_centre.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <vector>

#include "balance-shaft/engine_torque.h"
#include "balance-shaft/input.h"
#include "balance-shaft/torque_table.h"
#include "case-file/decimal.h"
#include "numerics/constants.h"
#include "numerics/units.h"

namespace ravnoves::balance_shaft {

namespace {

/// Mean of the rows of about a degree.
struct Bin {
    double angle_deg;
    double pressure;
    double sigma;  ///< Pa, with what the model leaves of any engine
};

/// Noise of the rows, Pa: third differences are free of what is smooth.
double noise_of(const std::vector<double>& pressure) {
    std::vector<double> thirds;
    for (std::size_t i = 3; i < pressure.size(); ++i) {
        thirds.push_back(std::abs(pressure[i] - 3.0 * pressure[i - 1] + 3.0 * pressure[i - 2] -
                                  pressure[i - 3]));
    }
    const auto middle = thirds.begin() + static_cast<std::ptrdiff_t>(thirds.size() / 2);
    std::nth_element(thirds.begin(), middle, thirds.end());
    constexpr double median_of_normal = 0.6745;
    return *middle / (median_of_normal * std::sqrt(20.0));
}

/// Rows of the trace over two cycles from its start, so that any window is in one piece.
std::vector<Bin> bins_of(const PressureTrace& trace) {
    const std::size_t rows = trace.crank_angle_deg.size() - 1;
    const double period = trace.crank_angle_deg.back() - trace.crank_angle_deg.front();
    constexpr double floor = 50.0;         // Pa
    constexpr double model_error = 0.001;  // of the pressure
    const double noise = noise_of(trace.pressure);
    std::vector<Bin> bins;
    double angle = 0.0;
    double pressure = 0.0;
    int count = 0;
    double begin = trace.crank_angle_deg.front();
    for (std::size_t i = 0; i < 2 * rows; ++i) {
        const double here = trace.crank_angle_deg[i % rows] + (i >= rows ? period : 0.0);
        if (count > 0 && here >= begin + 1.0 - 1e-6) {
            const double mean = pressure / count;
            bins.push_back({angle / count, mean,
                            std::sqrt(noise * noise / count + floor * floor +
                                      model_error * model_error * mean * mean)});
            angle = pressure = 0.0;
            count = 0;
            begin = here;
        }
        angle += here;
        pressure += trace.pressure[i % rows];
        ++count;
    }
    return bins;
}

constexpr int parameters = 5;  ///< k, n, b, c, p₀
using Vector = Eigen::Matrix<double, parameters, 1>;
using Matrix = Eigen::Matrix<double, parameters, parameters>;

struct Prior {
    double mean;
    double spread;
};

class CompressionLine {
  public:
    CompressionLine(const SliderCrank<double>& crank, std::vector<Bin> bins)
        : crank_(crank),
          top_(crank.top_dead_centre()),
          longest_(crank.at(top_).s),
          stroke_(crank.stroke()),
          bins_(std::move(bins)) {}

    struct Fit {
        double centre_deg = 0.0;
        double spread_deg = 0.0;  ///< one standard deviation
        double cost = 0.0;        ///< χ², with the priors'
        std::size_t rows = 0;
    };

    std::size_t rows(double from_deg, double to_deg) const {
        return static_cast<std::size_t>(std::count_if(bins_.begin(), bins_.end(), [&](auto& bin) {
            return bin.angle_deg >= from_deg && bin.angle_deg <= to_deg;
        }));
    }

    /// @param centre_deg  about where the dead centre is, to so many degrees
    Fit fit(double from_deg, double to_deg, double centre_deg, double reach_deg) {
        used_.clear();
        for (const Bin& bin : bins_) {
            if (bin.angle_deg >= from_deg && bin.angle_deg <= to_deg) {
                used_.push_back(bin);
            }
        }
        Fit fit;
        fit.rows = used_.size();
        double best = cost_at(centre_deg);
        double near = centre_deg;
        for (double away = 1.0; away <= reach_deg; away += 1.0) {
            for (const double centre : {centre_deg - away, centre_deg + away}) {
                if (const double cost = cost_at(centre); cost < best) {
                    best = cost;
                    near = centre;
                }
            }
        }
        constexpr int bits = 20;
        const auto [centre, cost] = boost::math::tools::brent_find_minima(
            [&](double at) { return cost_at(at); }, near - 1.0, near + 1.0, bits);
        fit.centre_deg = centre;
        fit.cost = cost;
        constexpr double step = 0.2;
        const double curvature =
            (cost_at(centre + step) + cost_at(centre - step) - 2.0 * cost) / (step * step);
        constexpr double unknown = 90.0;
        fit.spread_deg = curvature > 0.0 ? std::sqrt(2.0 / curvature) : unknown;
        return fit;
    }

  private:
    /// The smallest χ² at a dead centre, over the compression ratio.
    double cost_at(double centre_deg) {
        stroke_part_.clear();
        for (const Bin& bin : used_) {
            const double theta = top_ + (bin.angle_deg - centre_deg) * degree;
            stroke_part_.push_back((longest_ - crank_.at(theta).s) / stroke_);
        }
        constexpr int bits = 12;
        return boost::math::tools::brent_find_minima(
                   [&](double log_ratio) { return cost_of(log_ratio); },
                   log_ratio_.mean - 3.0 * log_ratio_.spread,
                   log_ratio_.mean + 3.0 * log_ratio_.spread, bits)
            .second;
    }

    double cost_of(double log_ratio) {
        constexpr std::array<Prior, parameters> priors{
            {{0.0, 1e9}, {1.34, 0.04}, {0.01, 0.02}, {0.3, 0.4}, {0.0, 5e3}}};
        const double clearance = 1.0 / (std::exp(log_ratio) - 1.0);  // strokes
        const double loss_unit = loss_of_a_degree(clearance);
        Matrix normal = Matrix::Zero();
        Vector right = Vector::Zero();
        double squares = 0.0;
        double loss = 0.0;
        double before = 0.0;
        const double reference = used_.front().pressure * (clearance + stroke_part_.front());
        for (std::size_t i = 0; i < used_.size(); ++i) {
            const Bin& bin = used_[i];
            const double volume = clearance + stroke_part_[i];
            const double log_volume = std::log(volume);
            const double rate =
                wall_loss(bin.pressure, start_temperature * bin.pressure * volume / reference);
            if (i > 0) {
                loss += 0.5 * (rate + before) * (bin.angle_deg - used_[i - 1].angle_deg);
            }
            before = rate;
            Vector row;
            row << 1.0, -log_volume, -0.5 * log_volume * log_volume, -loss * loss_unit,
                1.0 / bin.pressure;
            const double weight = bin.pressure / bin.sigma;
            row *= weight;
            const double wanted = weight * std::log(bin.pressure);
            normal.noalias() += row * row.transpose();
            right += row * wanted;
            squares += wanted * wanted;
        }
        for (int k = 0; k < parameters; ++k) {
            const Prior& prior = priors[static_cast<std::size_t>(k)];
            const double weight = 1.0 / (prior.spread * prior.spread);
            normal(k, k) += weight;
            right(k) += weight * prior.mean;
            squares += weight * prior.mean * prior.mean;
        }
        const double cost = squares - right.dot(normal.ldlt().solve(right));
        const double ratio = (log_ratio - log_ratio_.mean) / log_ratio_.spread;
        return cost + ratio * ratio;
    }

    static constexpr double start_temperature = 340.0;  ///< K

    /// Of the form of Woschni's heat transfer, of the gas's own energy.
    static double wall_loss(double pressure, double temperature) {
        constexpr double wall = 420.0;
        const double gas = std::max(temperature, 250.0);
        return std::pow(pressure / 1e6, 0.8) * std::pow(gas / 800.0, -0.53) *
               std::max(0.0, 1.0 - wall / gas);
    }

    /// What a loss of 1 makes of the rate at the dead centre that puts the peak a degree before it.
    double loss_of_a_degree(double clearance) const {
        constexpr double exponent = 1.33;
        const double after = (longest_ - crank_.at(top_ + degree).s) / stroke_;
        const double rate = exponent * 2.0 * after / clearance;  // −d ln p of the first degree
        const double squeezed = std::pow((1.0 + clearance) / clearance, exponent);
        const double temperature = start_temperature * squeezed * clearance / (1.0 + clearance);
        constexpr double minimum = 0.05;
        return rate / std::max(wall_loss(1e5 * squeezed, temperature), minimum);
    }

    SliderCrank<double> crank_;
    double top_;
    double longest_;
    double stroke_;
    std::vector<Bin> bins_;
    Prior log_ratio_{std::log(13.0), 0.35};
    std::vector<Bin> used_;
    std::vector<double> stroke_part_;
};

}  // namespace

double DeadCentre::proposed_shift() const {
    const double rest = std::remainder(shift, two_pi);
    return std::abs(rest) <= uncertainty ? shift - rest : shift;
}

Message DeadCentre::describe() const {
    const auto degrees = [](double angle, int digits) {
        return Number{rounded_to_decimals(angle / degree, digits), units::degree};
    };
    return {is_certain()
                ? Text::tr("The dead centre is at %1 ± %2 of the trace: shift the angles by %3.")
                : Text::tr("The dead centre may be at %1 ± %2 of the trace, a shift of %3; the "
                           "compression line is not more precise."),
            degrees(angle, 2), degrees(uncertainty, 2), degrees(proposed_shift(), 2)};
}

std::optional<DeadCentre> find_dead_centre(const SliderCrank<double>& crank,
                                           const PressureTrace& trace) {
    constexpr std::size_t fewest_rows = 90;
    if (trace.pressure.size() < fewest_rows) {
        return std::nullopt;
    }
    std::vector<Bin> bins = bins_of(trace);
    // The peak of the second cycle or of the end of the first has a whole compression before it.
    const double period = trace.crank_angle_deg.back() - trace.crank_angle_deg.front();
    const double half = trace.crank_angle_deg.front() + period / 2.0;
    const Bin* highest = nullptr;
    for (const Bin& bin : bins) {
        const bool is_inside = bin.angle_deg >= half && bin.angle_deg < half + period;
        if (is_inside && (highest == nullptr || bin.pressure > highest->pressure)) {
            highest = &bin;
        }
    }
    if (highest == nullptr) {
        return std::nullopt;  // no degree of that cycle has rows
    }
    const double peak_deg = highest->angle_deg;
    const double peak = highest->pressure;
    constexpr double line_begin = 105.0;  // before the peak, at most
    constexpr double beyond = 30.0;       // the peak, of a motored engine
    const auto is_outside = [&](const Bin& bin) {
        return bin.angle_deg < peak_deg - line_begin - 1.0 ||
               bin.angle_deg > peak_deg + beyond + 3.0;
    };
    std::erase_if(bins, is_outside);
    const bool is_positive = std::ranges::all_of(bins, [](auto& bin) { return bin.pressure > 0; });
    constexpr double min_rise = 3.0;
    constexpr std::size_t fewest_bins = 30;
    if (!is_positive || bins.size() < fewest_bins || !(peak > min_rise * bins.front().pressure)) {
        return std::nullopt;
    }
    CompressionLine line(crank, std::move(bins));

    constexpr double first_end = 50.0;
    constexpr double usual_lateness = 8.0;  // of the peak
    constexpr double latest = 78.0;
    constexpr std::size_t fewest_of_line = 6;
    if (line.rows(peak_deg - latest, peak_deg - first_end) < fewest_of_line) {
        return std::nullopt;
    }
    double from = 0.0;
    CompressionLine::Fit fit;
    for (const double begin : {line_begin, 90.0, latest}) {  // later, where the intake shuts late
        from = peak_deg - begin;
        fit = line.fit(from, peak_deg - first_end, peak_deg - usual_lateness, 20.0);
        if (fit.cost < 2.0 * static_cast<double>(fit.rows)) {
            break;
        }
    }

    // On, as long as what is added fits: χ² grows by one a row.
    constexpr double step = 2.0;
    constexpr double surprise = 10.0;  // a row: combustion, so the end is the last clean one
    constexpr double clean = 1.75;
    CompressionLine::Fit last = fit;
    bool is_motored = true;
    for (double to = peak_deg - first_end + step; is_motored && to <= peak_deg + beyond;
         to += step) {
        if (line.rows(from, to) == last.rows) {
            continue;
        }
        const auto next = line.fit(from, to, last.centre_deg, 4.0);
        const double added = (next.cost - last.cost) / static_cast<double>(next.rows - last.rows);
        is_motored = added <= surprise;
        if (is_motored) {
            last = next;
            fit = added <= clean ? next : fit;
        }
    }
    fit = is_motored ? last : fit;

    DeadCentre centre;
    constexpr double model_spread = 0.1;  // °
    centre.uncertainty = 2.0 * std::hypot(fit.spread_deg, model_spread) * degree;
    const double firing = strokes_of(trace.crank_angle_deg) == 4 ? turn_deg : 0.0;
    centre.shift = std::remainder(firing - fit.centre_deg, period) * degree;
    centre.angle = firing * degree - centre.shift;
    return centre;
}

std::optional<DeadCentre> find_dead_centre(const Input& input) {
    return input.torque.kind == TorqueSource::Kind::pressure
               ? find_dead_centre(slider_crank(input), input.torque.trace)
               : std::nullopt;
}

Message dead_centre_note(const Input& input, const std::optional<DeadCentre>& centre) {
    const double period = input.cycle_deg() * degree;
    return centre && std::abs(std::remainder(centre->shift - input.torque.trace_shift, period)) >
                         centre->uncertainty
               ? centre->describe()
               : Message();
}

}  // namespace ravnoves::balance_shaft
