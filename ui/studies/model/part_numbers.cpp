#include "studies/model/part_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/scene_model.h"
#include "numerics/demand.h"
#include "studies/model/scattered_inputs.h"

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

}  // namespace

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
        parts_.push_back(part.id);
        const Content content = model.part(part.id);
        std::vector<double> values;
        if (const auto* figure = std::get_if<Figure>(&content)) {
            for (const Figure::Curve& curve : figure->curves) {
                // A line that goes up and down, or to and fro, has no width along y.
                places_.push_back({.part = part.id,
                                   .curve = curve.id,
                                   .x = curve.x,
                                   .hasWidth = isAscending(curve.x) || !isLine(curve)});
                append(places_.back(), content, values);
            }
            for (const double value : values) {
                numbers_.push_back({.nominal = value});
            }
        } else if (const auto* results = std::get_if<Results>(&content)) {
            const std::size_t first = places_.size();
            double maximum = 0.0;
            for (int row = 0; row < results->rows.size(); ++row) {
                for (int column = 1; column < results->rows[row].size(); ++column) {
                    const ResultNumber* number = results->rows[row][column].number();
                    if (number == nullptr) {
                        continue;
                    }
                    places_.push_back({.part = part.id,
                                       .row = row,
                                       .column = column,
                                       .key = results->rows[row].key()});
                    const bool turns = number->kind == ResultNumber::Kind::Direction;
                    numbers_.push_back({.nominal = number->value, .period = turns ? 360.0 : 0.0});
                    maximum = std::max(maximum, std::abs(number->value));
                }
            }
            for (std::size_t i = first; i < places_.size(); ++i) {
                places_[i].maximum = maximum;
            }
        }
    }
}

void PartNumbers::append(const Place& place, const Content& content, std::vector<double>& values) {
    if (!place.curve.empty()) {
        const auto* figure = std::get_if<Figure>(&content);
        appendValues(place.x, figure != nullptr ? figure->find(place.curve) : nullptr, values);
        return;
    }
    const auto* results = std::get_if<Results>(&content);
    const bool isThere = results != nullptr && place.row < results->rows.size() &&
                         results->rows[place.row].key() == place.key;
    const ResultNumber* number =
        isThere ? results->rows[place.row].value(place.column).number() : nullptr;
    values.push_back(number != nullptr ? number->value : none);
}

void PartNumbers::add(const SceneModel& sample) {
    std::vector<double> values;
    values.reserve(numbers_.size());
    Content content;
    std::string_view part;
    for (const Place& place : places_) {
        if (part != place.part) {
            part = place.part;
            content = sample.part(part);
        }
        append(place, content, values);
    }
    RAVNOVES_DEMAND(values.size() == numbers_.size(), "a sample has the numbers of the case");
    for (std::size_t i = 0; i < values.size(); ++i) {
        numbers_[i].add(values[i]);
    }
    ++samples_;
}

std::map<std::string, PartSpread, std::less<>> PartNumbers::spreads(const QString& how) const {
    std::map<std::string, PartSpread, std::less<>> found;
    for (const std::string_view part : parts_) {
        found[std::string(part)].how = how;
    }
    auto number = numbers_.begin();
    for (const Place& place : places_) {
        PartSpread& spread = found.find(place.part)->second;
        if (place.curve.empty()) {
            const auto [below, above] = number->sides(samples_).value_or(std::pair(0.0, 0.0));
            const double half = 0.5 * (below + above);
            // What is left of two that cancel is rounding, too.
            constexpr double cancelled = 1e-14;
            if (half > rounding * std::abs(number->nominal) && half > cancelled * place.maximum) {
                spread.cells.push_back({place.row, place.column, place.key, below, above});
            }
            ++number;
            continue;
        }
        plot::Spread curve;
        double maximum = 0.0;
        double largest = 0.0;
        for (const double x : place.x) {
            if (std::isfinite(x) && std::isfinite(number->nominal)) {  // else it is not drawn
                const auto [below, above] = number->sides(samples_).value_or(std::pair(0.0, 0.0));
                curve.below.push_back(below);
                curve.above.push_back(above);
                maximum = std::max(maximum, std::abs(number->nominal));
                largest = std::max(largest, 0.5 * (below + above));
            }
            ++number;
        }
        if (largest > rounding * maximum && place.hasWidth) {
            spread.curves.emplace(place.curve, std::move(curve));
        }
    }
    return found;
}

}  // namespace ravnoves
