#include "studies/model/part_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/scene_model.h"
#include "studies/sampler.h"

namespace ravnoves {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Of numbers, relative: what is less is no spread. Samples are kept as float.
constexpr double rounding = 1e-11;

bool isLine(const Figure::Curve& curve) {
    return curve.style.shape == plot::Shape::Line ||
           curve.style.shape == plot::Shape::LineAndPoints;
}

bool isAscending(const std::vector<double>& x) {
    return !x.empty() && std::is_sorted(x.begin(), x.end()) && x.back() > x.front();
}

/// A curve's values at places that may be those of another; not a number where it has none: a curve
/// that a case does not have may still have its places.
void appendValues(const std::vector<double>& places, const Figure::Curve* curve,
                  std::vector<double>& values) {
    if (curve == nullptr || curve->x.size() != curve->y.size()) {
        values.resize(values.size() + places.size(), none);
        return;
    }
    if (curve->x == places) {
        values.insert(values.end(), curve->y.begin(), curve->y.end());
        return;
    }
    const bool isRead = isLine(*curve) && isAscending(curve->x);
    for (const double x : places) {
        if (!isRead || x < curve->x.front() || x > curve->x.back()) {
            values.push_back(none);
            continue;
        }
        const auto next =
            std::max(std::lower_bound(curve->x.begin(), curve->x.end(), x), curve->x.begin() + 1);
        const auto i = static_cast<std::size_t>(next - curve->x.begin());
        const double stretch = curve->x[i] - curve->x[i - 1];
        const double part = stretch > 0.0 ? (x - curve->x[i - 1]) / stretch : 1.0;
        values.push_back(std::lerp(curve->y[i - 1], curve->y[i], part));
    }
}

/// Calls with place and number of each cell that has a number.
template <typename Use>
void eachNumber(const Results& results, const Use& use) {
    for (int row = 0; row < results.rows.size(); ++row) {
        for (int column = 1; column < results.rows[row].size(); ++column) {
            if (const ResultNumber* number = results.rows[row][column].number()) {
                use(row, column, *number);
            }
        }
    }
}

/// The numbers of a part at the places that it has in the case; not a number where it has none.
std::vector<double> numbersOf(const Content& ofCase, const Content& content) {
    std::vector<double> values;
    if (const auto* places = std::get_if<Figure>(&ofCase)) {
        const auto* figure = std::get_if<Figure>(&content);
        for (const Figure::Curve& curve : places->curves) {
            appendValues(curve.x, figure != nullptr ? figure->find(curve.id) : nullptr, values);
        }
    } else if (const auto* cells = std::get_if<Results>(&ofCase)) {
        const auto* results = std::get_if<Results>(&content);
        eachNumber(*cells, [&](int row, int column, const ResultNumber& /*number*/) {
            const bool isThere = results != nullptr && row < results->rows.size() &&
                                 results->rows[row].key() == cells->rows[row].key();
            const ResultCell cell = isThere ? results->rows[row].value(column) : ResultCell();
            values.push_back(cell.number() != nullptr ? cell.number()->value : none);
        });
    }
    return values;
}

}  // namespace

double percentileOf(const std::vector<double>& ascending, double share) {
    const double rank = share * static_cast<double>(ascending.size() - 1);
    const auto below = static_cast<std::size_t>(rank);
    return std::lerp(ascending[below], ascending[std::min(below + 1, ascending.size() - 1)],
                     rank - std::floor(rank));
}

std::vector<std::vector<double>> samplesOf(const std::vector<studies::Law>& laws,
                                           studies::Method method, std::uint64_t seed) {
    studies::Sampler sampler(method, seed, laws.size());
    std::vector<std::vector<double>> samples(scatteredSamples, std::vector<double>(laws.size()));
    for (std::uint64_t i = 0; i < samples.size(); ++i) {
        sampler.point(studies::replicates * i, samples[i]);  // of one replicate
        for (std::size_t j = 0; j < laws.size(); ++j) {
            samples[i][j] = laws[j].at(samples[i][j]);
        }
    }
    return samples;
}

void ScatteredNumber::add(double value) {
    const double difference = value - nominal;
    if (std::isfinite(difference)) {
        off.push_back(
            static_cast<float>(period > 0.0 ? std::remainder(difference, period) : difference));
    }
}

std::optional<std::pair<double, double>> ScatteredNumber::sides(std::size_t samples) const {
    constexpr double enough = 0.9;
    if (off.empty() || static_cast<double>(off.size()) < enough * static_cast<double>(samples)) {
        return std::nullopt;
    }
    std::vector<double> ascending(off.begin(), off.end());
    std::sort(ascending.begin(), ascending.end());
    return std::pair(-percentileOf(ascending, 0.05), percentileOf(ascending, 0.95));
}

PartNumbers::PartNumbers(const SceneModel& model, const std::vector<std::string_view>& ids) {
    for (const PagePart& part : model.parts()) {
        if (!part.hasBand || std::find(ids.begin(), ids.end(), part.id) == ids.end()) {
            continue;
        }
        Part& kept = parts_.emplace_back(Part{part.id, model.part(part.id), {}});
        for (const double value : numbersOf(kept.ofCase, kept.ofCase)) {
            kept.numbers.push_back({.nominal = value});
        }
        if (const auto* results = std::get_if<Results>(&kept.ofCase)) {
            auto next = kept.numbers.begin();
            eachNumber(*results, [&](int /*row*/, int /*column*/, const ResultNumber& number) {
                const bool turns = number.kind == ResultNumber::Kind::Direction;
                (next++)->period = turns ? 360.0 : 0.0;
            });
        }
    }
}

void PartNumbers::add(const SceneModel& sample) {
    for (Part& part : parts_) {
        const std::vector<double> values = numbersOf(part.ofCase, sample.part(part.id));
        for (std::size_t i = 0; i < values.size(); ++i) {
            part.numbers[i].add(values[i]);
        }
    }
    ++samples_;
}

std::map<std::string, PartSpread, std::less<>> PartNumbers::spreads(const QString& how) const {
    std::map<std::string, PartSpread, std::less<>> found;
    for (const Part& part : parts_) {
        PartSpread& spread = found[std::string(part.id)];
        spread.how = how;
        auto number = part.numbers.begin();
        const auto sides = [&] { return number->sides(samples_).value_or(std::pair(0.0, 0.0)); };
        if (const auto* figure = std::get_if<Figure>(&part.ofCase)) {
            for (const Figure::Curve& curve : figure->curves) {
                plot::Spread width;
                double maximum = 0.0;
                double largest = 0.0;
                for (const double x : curve.x) {
                    if (std::isfinite(x) && std::isfinite(number->nominal)) {  // else not drawn
                        const auto [below, above] = sides();
                        width.below.push_back(below);
                        width.above.push_back(above);
                        maximum = std::max(maximum, std::abs(number->nominal));
                        largest = std::max(largest, 0.5 * (below + above));
                    }
                    ++number;
                }
                // A line that goes up and down, or to and fro, has no width along y.
                if (largest > rounding * maximum && (isAscending(curve.x) || !isLine(curve))) {
                    spread.curves.emplace(curve.id, std::move(width));
                }
            }
        } else if (const auto* results = std::get_if<Results>(&part.ofCase)) {
            double maximum = 0.0;
            for (const ScatteredNumber& each : part.numbers) {
                maximum = std::max(maximum, std::abs(each.nominal));
            }
            eachNumber(*results, [&](int row, int column, const ResultNumber& /*number*/) {
                const auto [below, above] = sides();
                const double half = 0.5 * (below + above);
                // What is left of two that cancel is rounding, too.
                constexpr double cancelled = 1e-14;
                if (half > rounding * std::abs(number->nominal) && half > cancelled * maximum) {
                    spread.cells.push_back({row, column, results->rows[row].key(), below, above});
                }
                ++number;
            });
        }
    }
    return found;
}

}  // namespace ravnoves
