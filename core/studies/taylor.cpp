#include "studies/taylor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ravnoves::studies {

namespace {

constexpr std::size_t levels = 7;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Neville's scheme for differences of steps h, h/2, h/4 …
/// @param power  2 where the error is of even powers of the step alone, else 1
/// @param rounding  of a difference with the first step
Taylor::Slope extrapolate(const std::array<double, levels>& differences, int power,
                          double rounding) {
    std::array<std::array<double, levels>, levels> table{};
    Taylor::Slope best{differences[0], std::numeric_limits<double>::infinity()};
    const double ratio = power == 2 ? 4.0 : 2.0;
    double growing = rounding;
    for (std::size_t i = 0; i < levels; ++i, growing *= 2.0) {
        table[i][0] = differences[i];
        double factor = ratio;
        for (std::size_t j = 1; j <= i; ++j, factor *= ratio) {
            const double finer = table[i][j - 1];
            table[i][j] = finer + (finer - table[i - 1][j - 1]) / (factor - 1.0);
            const double error = std::max(std::abs(table[i][j] - finer),
                                          std::abs(table[i][j] - table[i - 1][j - 1])) +
                                 growing;
            if (error < best.error) {
                best = {table[i][j], error};
            }
        }
    }
    return best;
}

/// Sets the slopes by one input where they exist.
/// @param moved  the watched values with that input moved from the means by a step; nothing where
///               they are rejected
template <typename Moved>
void set_slopes(const Moved& moved, const Law& law, const Response& response, std::size_t input,
                std::vector<Taylor>& all) {
    const std::size_t watched = all.size();
    // The sides that exist within the scatter; nearer where they do not reach so far.
    double step = law.deviation;
    bool up = false;
    bool down = false;
    constexpr int tries = 4;
    for (int i = 0; i < tries && !up && !down; ++i) {
        step = i == 0 ? step : step / 16.0;
        up = moved(step).has_value();
        down = moved(-step).has_value();
    }
    std::vector<std::array<double, levels>> differences(watched);
    std::vector<double> size(watched);
    double h = step;
    for (std::size_t level = 0; level < levels; ++level, h /= 2.0) {
        // The step that the sum really makes.
        const double high = up ? (law.mean + h) - law.mean : 0.0;
        const double low = down ? law.mean - (law.mean - h) : 0.0;
        const auto above = moved(high);
        const auto below = moved(-low);
        if (!above || !below || !(high + low > 0.0)) {
            return;
        }
        for (std::size_t w = 0; w < watched; ++w) {
            differences[w][level] =
                difference((*above)[w], (*below)[w], response.period(w)) / (high + low);
            size[w] = std::max({size[w], std::abs((*above)[w]), std::abs((*below)[w])});
        }
    }
    for (std::size_t w = 0; w < watched; ++w) {
        const double rounding = 2.0 * epsilon * size[w] / (up && down ? 2.0 * step : step);
        all[w].slopes[input] = extrapolate(differences[w], up && down ? 2 : 1, rounding);
    }
}

}  // namespace

double difference(double a, double b, double period) {
    return period == 0.0 ? a - b : std::remainder(a - b, period);
}

bool scatters(const Law& law) {
    constexpr double steps = 1 << levels;  // the finest of the differences still moves it
    return law.deviation > steps * epsilon * std::abs(law.mean);
}

std::optional<Taylor::Propagated> Taylor::propagated(std::span<const Law> laws) const {
    if (!value) {
        return std::nullopt;
    }
    Propagated found{.shares = std::vector<double>(laws.size())};
    double variance = 0.0;
    double variance_error = 0.0;
    for (std::size_t j = 0; j < laws.size(); ++j) {
        if (!scatters(laws[j])) {
            continue;
        }
        if (!slopes[j]) {
            return std::nullopt;
        }
        const double v = std::pow(laws[j].deviation, 2);
        found.shares[j] = std::pow(slopes[j]->value, 2) * v;
        variance += found.shares[j];
        variance_error += std::pow(2.0 * slopes[j]->value * slopes[j]->error * v, 2);
    }
    found.deviation = std::sqrt(variance);
    if (variance > 0.0) {
        found.deviation_error = std::sqrt(variance_error) / (2.0 * found.deviation);
        for (double& share : found.shares) {
            share /= variance;
        }
    }
    return found;
}

double Taylor::at(std::span<const Law> laws, std::span<const double> x) const {
    double sum = value.value_or(0.0);
    for (std::size_t j = 0; j < laws.size(); ++j) {
        sum += slopes[j] ? slopes[j]->value * (x[j] - laws[j].mean) : 0.0;
    }
    return sum;
}

std::vector<Taylor> expand(Response& response, std::span<const Law> laws, std::size_t watched) {
    std::vector<double> x;
    for (const Law& law : laws) {
        x.push_back(law.mean);
    }
    const auto values = [&]() -> std::optional<std::vector<double>> {
        std::vector<double> y(watched);
        return response.evaluate(x, y) ? std::optional(std::move(y)) : std::nullopt;
    };
    std::vector<Taylor> all(watched);
    for (Taylor& each : all) {
        each.slopes.resize(laws.size());
    }
    const auto middle = values();
    for (std::size_t j = 0; j < laws.size() && middle; ++j) {
        if (!scatters(laws[j])) {
            continue;
        }
        const auto moved = [&](double step) {
            if (step == 0.0) {
                return middle;
            }
            x[j] = laws[j].mean + step;
            auto found = values();
            x[j] = laws[j].mean;
            return found;
        };
        set_slopes(moved, laws[j], response, j, all);
    }
    for (std::size_t w = 0; w < all.size() && middle; ++w) {
        all[w].value = (*middle)[w];
    }
    return all;
}

}  // namespace ravnoves::studies
