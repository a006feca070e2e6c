#include "studies/taylor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ravnoves::studies {

namespace {

double square_of(double x) {
    return x * x;
}

/// Of angles the short way round.
double less(double a, double b, double period) {
    return period == 0.0 ? a - b : std::remainder(a - b, period);
}

constexpr std::size_t levels = 7;

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

}  // namespace

std::optional<Taylor::Propagated> Taylor::propagated(std::span<const Law> laws, bool second) const {
    if (!value) {
        return std::nullopt;
    }
    const std::size_t n = laws.size();
    Propagated found{
        .mean = *value, .first_order = std::vector<double>(n), .total = std::vector<double>(n)};
    double variance = 0.0;
    double variance_error = 0.0;
    for (std::size_t j = 0; j < n; ++j) {
        if (!slopes[j]) {
            return std::nullopt;
        }
        const double v = square_of(laws[j].deviation);
        double own = square_of(slopes[j]->value) * v;
        variance_error += square_of(2.0 * slopes[j]->value * slopes[j]->error * v);
        if (second) {
            found.mean += 0.5 * curvatures[j] * v;
            own += 0.25 * square_of(curvatures[j]) * (laws[j].fourth_moment - v * v);
        }
        found.first_order[j] = own;
        found.total[j] += own;
        variance += own;
        for (std::size_t k = 0; second && k < j; ++k) {
            const double shared = square_of(crossed[j * n + k]) * v * square_of(laws[k].deviation);
            found.total[j] += shared;
            found.total[k] += shared;
            variance += shared;
        }
    }
    found.deviation = std::sqrt(variance);
    if (variance > 0.0) {
        found.deviation_error = std::sqrt(variance_error) / (2.0 * found.deviation);
        for (std::size_t j = 0; j < n; ++j) {
            found.first_order[j] /= variance;
            found.total[j] /= variance;
        }
    }
    return found;
}

double Taylor::at(std::span<const Law> laws, std::span<const double> x) const {
    const std::size_t n = laws.size();
    double sum = *value;
    for (std::size_t j = 0; j < n; ++j) {
        const double d = x[j] - laws[j].mean;
        sum += slopes[j]->value * d;
        if (!curvatures.empty()) {
            sum += 0.5 * curvatures[j] * d * d;
            for (std::size_t k = 0; k < j; ++k) {
                sum += crossed[j * n + k] * d * (x[k] - laws[k].mean);
            }
        }
    }
    return sum;
}

Differences::Differences(Response& response, std::span<const Law> laws, std::size_t watched)
    : response_(response), laws_(laws), watched_(watched) {
    for (const Law& law : laws) {
        means_.push_back(law.mean);
    }
}

Differences::Values Differences::at(std::span<const double> x) {
    std::vector<double> y(watched_);
    return response_.evaluate(x, y) ? Values(std::move(y)) : std::nullopt;
}

Differences::Values Differences::moved(std::size_t input, double step) {
    std::vector<double> x = means_;
    x[input] += step;
    return at(x);
}

Differences::Values Differences::moved(std::size_t one, double step, std::size_t other,
                                       double other_step) {
    std::vector<double> x = means_;
    x[one] += step;
    x[other] += other_step;
    return at(x);
}

void Differences::set_slopes(std::size_t input, std::span<const double> periods,
                             std::vector<Taylor>& all) {
    if (laws_[input].deviation == 0.0) {
        for (Taylor& each : all) {
            each.slopes[input].emplace();
        }
        return;
    }
    // The sides that exist within the scatter; nearer where they do not reach so far.
    double step = laws_[input].deviation;
    bool up = false;
    bool down = false;
    constexpr int tries = 4;
    for (int i = 0; i < tries && !up && !down; ++i) {
        step = i == 0 ? step : step / 16.0;
        up = moved(input, step).has_value();
        down = moved(input, -step).has_value();
    }
    if (!up && !down) {
        return;
    }
    std::vector<std::array<double, levels>> differences(watched_);
    std::vector<double> size(watched_);
    double h = step;
    for (std::size_t level = 0; level < levels; ++level, h /= 2.0) {
        // The step that the sum really makes.
        const double high = up ? (means_[input] + h) - means_[input] : 0.0;
        const double low = down ? means_[input] - (means_[input] - h) : 0.0;
        const Values above = up ? moved(input, h) : middle_;
        const Values below = down ? moved(input, -h) : middle_;
        if (!above || !below || !(high + low > 0.0)) {
            return;
        }
        for (std::size_t w = 0; w < watched_; ++w) {
            differences[w][level] = less((*above)[w], (*below)[w], periods[w]) / (high + low);
            size[w] = std::max({size[w], std::abs((*above)[w]), std::abs((*below)[w])});
        }
    }
    for (std::size_t w = 0; w < watched_; ++w) {
        const double rounding = 2.0 * std::numeric_limits<double>::epsilon() * size[w] /
                                (up && down ? 2.0 * step : step);
        all[w].slopes[input] = extrapolate(differences[w], up && down ? 2 : 1, rounding);
    }
}

void Differences::set_curvatures(std::span<const double> periods, std::vector<Taylor>& all) {
    const std::size_t n = laws_.size();
    // Error of the fourth order in the step, by one extrapolation.
    const auto extrapolated = [&](const auto& difference, const auto& put) {
        const auto wide = difference(1.0);
        const auto near = difference(0.5);
        for (std::size_t w = 0; w < watched_ && !wide.empty() && !near.empty(); ++w) {
            put(w, (4.0 * near[w] - wide[w]) / 3.0);
        }
    };
    for (Taylor& each : all) {
        each.curvatures.assign(n, 0.0);
        each.crossed.assign(n * n, 0.0);
    }
    const auto scatters = [&](std::size_t j) { return laws_[j].deviation != 0.0; };
    for (std::size_t j = 0; j < n; ++j) {
        if (!scatters(j)) {
            continue;
        }
        extrapolated(
            [&](double part) {
                const double h = part * laws_[j].deviation;
                const Values above = moved(j, h);
                const Values below = moved(j, -h);
                std::vector<double> found;
                for (std::size_t w = 0; w < watched_ && above && below; ++w) {
                    found.push_back((less((*above)[w], (*middle_)[w], periods[w]) +
                                     less((*below)[w], (*middle_)[w], periods[w])) /
                                    (h * h));
                }
                return found;
            },
            [&](std::size_t w, double value) { all[w].curvatures[j] = value; });
        for (std::size_t k = 0; k < j; ++k) {
            if (!scatters(k)) {
                continue;
            }
            extrapolated(
                [&](double part) {
                    const double h = part * laws_[j].deviation;
                    const double g = part * laws_[k].deviation;
                    const Values a = moved(j, h, k, g);
                    const Values b = moved(j, h, k, -g);
                    const Values c = moved(j, -h, k, g);
                    const Values d = moved(j, -h, k, -g);
                    std::vector<double> found;
                    for (std::size_t w = 0; w < watched_ && a && b && c && d; ++w) {
                        found.push_back((less((*a)[w], (*b)[w], periods[w]) -
                                         less((*c)[w], (*d)[w], periods[w])) /
                                        (4.0 * h * g));
                    }
                    return found;
                },
                [&](std::size_t w, double value) {
                    all[w].crossed[j * n + k] = all[w].crossed[k * n + j] = value;
                });
        }
    }
}

std::vector<Taylor> Differences::expand(std::span<const double> periods, bool second) {
    std::vector<Taylor> all(watched_);
    for (Taylor& each : all) {
        each.slopes.resize(laws_.size());
    }
    middle_ = at(means_);
    if (!middle_) {
        return all;
    }
    for (std::size_t w = 0; w < watched_; ++w) {
        all[w].value = (*middle_)[w];
    }
    for (std::size_t j = 0; j < laws_.size(); ++j) {
        set_slopes(j, periods, all);
    }
    if (second) {
        set_curvatures(periods, all);
    }
    return all;
}

namespace {

constexpr std::size_t places = 33;

/// One input's line through the means.
struct Line {
    std::array<double, places> x{};
    std::array<std::optional<double>, places> departure{};  ///< of one value from its expansion
};

/// The place of the means.
constexpr std::size_t middle_place = places / 2;

/// What stands out along the line; nothing where the value keeps to its expansion.
std::optional<Departure> judge_line(const Line& line, std::size_t input) {
    double largest = 0.0;
    std::size_t where = 0;
    std::size_t missing = places;
    const auto off_middle = [](std::size_t i) {
        return i > middle_place ? i - middle_place : middle_place - i;
    };
    for (std::size_t i = 0; i < places; ++i) {
        if (!line.departure[i]) {
            missing = missing == places || off_middle(i) < off_middle(missing) ? i : missing;
        } else if (std::abs(*line.departure[i]) > largest) {
            largest = std::abs(*line.departure[i]);
            where = i;
        }
    }
    if (missing != places) {
        return Departure{Departure::Kind::refused, input, line.x[missing],
                         std::numeric_limits<double>::infinity()};
    }
    std::array<double, places - 1> steps{};
    std::array<double, places - 2> bends{};
    for (std::size_t i = 0; i + 1 < places; ++i) {
        steps[i] = *line.departure[i + 1] - *line.departure[i];
    }
    for (std::size_t i = 0; i + 2 < places; ++i) {
        bends[i] = std::abs(steps[i + 1] - steps[i]);
    }
    Departure found{Departure::Kind::curved, input, line.x[where], largest};
    const auto bend = std::max_element(bends.begin(), bends.end());
    double all = 0.0;
    for (const double each : bends) {
        all += each;
    }
    // A jump bends twice, back and forth; a corner once; a curve everywhere a little.
    const auto at = static_cast<std::size_t>(bend - bends.begin());
    if (*bend > 0.25 * all) {
        const std::size_t step = std::abs(steps[at]) > std::abs(steps[at + 1]) ? at : at + 1;
        found.kind = Departure::Kind::corner;
        found.at = line.x[at + 1];
        if (std::abs(steps[step]) > 0.5 * largest) {
            found.kind = Departure::Kind::jump;
            found.at = 0.5 * (line.x[step] + line.x[step + 1]);
        }
    }
    return largest > 0.0 ? std::optional(found) : std::nullopt;
}

/// Closes in on the first place that is refused, from the one before it towards the means.
/// @param evaluate  whether the input can be solved
void close_in_on_refusal(const std::function<bool(double)>& evaluate, double width, double mean,
                         Departure& found) {
    double there = found.at + (found.at > mean ? -width : width);
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * there + 0.5 * found.at;
        (evaluate(middle) ? there : found.at) = middle;
    }
}

/// Closes in on a jump between two places. @return false where it is none
bool close_in(const std::function<std::optional<double>(double)>& departure, double width,
              Departure& found) {
    double low = found.at - 0.5 * width;
    double high = found.at + 0.5 * width;
    auto below = departure(low);
    auto above = departure(high);
    for (int i = 0; i < 40 && below && above; ++i) {
        const double middle = low + 0.5 * (high - low);
        const auto value = departure(middle);
        if (!value) {
            return false;
        }
        if (std::abs(*value - *below) > std::abs(*value - *above)) {
            high = middle;
            above = value;
        } else {
            low = middle;
            below = value;
        }
    }
    if (!below || !above || std::abs(*above - *below) < 0.2 * found.size) {
        return false;
    }
    found.at = high;
    found.size = std::abs(*above - *below);
    return true;
}

}  // namespace

std::vector<Departure> find_departures(Response& response, std::span<const Law> laws,
                                       std::span<const Taylor> expansions,
                                       std::span<const double> periods, double reach) {
    const std::size_t watched = expansions.size();
    std::vector<Departure> worst(watched);
    std::vector<double> x;
    for (const Law& law : laws) {
        x.push_back(law.mean);
    }
    std::vector<double> y(watched);
    for (std::size_t j = 0; j < laws.size(); ++j) {
        std::vector<Line> lines(watched);
        const Law& law = laws[j];
        if (law.deviation == 0.0) {
            continue;
        }
        const auto departure = [&](std::size_t w) {
            const Taylor& expansion = expansions[w];
            const double d = x[j] - law.mean;
            const double curvature = expansion.curvatures.empty() ? 0.0 : expansion.curvatures[j];
            return less(y[w], *expansion.value, periods[w]) -
                   d * (expansion.slopes[j]->value + 0.5 * curvature * d);
        };
        const double low = std::max(law.low, law.mean - reach * law.deviation);
        const double high = std::min(law.high, law.mean + reach * law.deviation);
        const double width = (high - low) / static_cast<double>(places - 1);
        for (std::size_t i = 0; i < places; ++i) {
            x[j] = i == middle_place ? law.mean : low + width * static_cast<double>(i);
            const bool there = response.evaluate(x, y);
            for (std::size_t w = 0; w < watched; ++w) {
                lines[w].x[i] = x[j];
                if (there && expansions[w].value && expansions[w].slopes[j]) {
                    lines[w].departure[i] = departure(w);
                }
            }
        }
        for (std::size_t w = 0; w < watched; ++w) {
            auto found = judge_line(lines[w], j);
            if (!found || found->size <= worst[w].size) {
                continue;
            }
            if (found->kind == Departure::Kind::jump) {
                const auto at = [&](double place) -> std::optional<double> {
                    x[j] = place;
                    return response.evaluate(x, y) ? std::optional(departure(w)) : std::nullopt;
                };
                if (!close_in(at, width, *found)) {
                    found->kind = Departure::Kind::corner;
                }
            } else if (found->kind == Departure::Kind::refused) {
                const auto solves = [&](double place) {
                    x[j] = place;
                    const bool there = response.evaluate(x, y);
                    found->reason = there ? found->reason : response.reason();
                    return there;
                };
                if (found->at != law.mean) {
                    close_in_on_refusal(solves, width, law.mean, *found);
                }
                solves(found->at);
            }
            worst[w] = *found;
        }
        x[j] = law.mean;
    }
    return worst;
}

}  // namespace ravnoves::studies
