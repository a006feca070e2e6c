#include "studies/model/part_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/scene_model.h"

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

/// A curve that a case does not have may still have its places.
bool isWhole(const Figure::Curve& curve) {
    return curve.x.size() == curve.y.size();
}

/// A curve's values at places that may be those of another; not a number where it has none.
void appendValues(const std::vector<double>& places, const Figure::Curve* curve,
                  std::vector<double>& values) {
    if (curve == nullptr || !isWhole(*curve)) {
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

/// Calls for each cell of a table that holds one number.
template <typename Look>
void eachNumber(const Results& results, const Look& look) {
    for (int row = 0; row < results.rows.size(); ++row) {
        for (int column = 1; column < results.rows[row].size(); ++column) {
            if (const ResultNumber* number = results.rows[row][column].number()) {
                look(row, column, *number);
            }
        }
    }
}

}  // namespace

PartNumbers::PartNumbers(const SceneModel& model, const std::vector<std::string_view>& ids) {
    for (const PagePart& part : model.parts()) {
        if (!part.hasBand || std::find(ids.begin(), ids.end(), part.id) == ids.end()) {
            continue;
        }
        Shown& shown =
            parts_.emplace_back(Shown{std::string(part.id), nominal_.size(), model.part(part.id)});
        if (const auto* figure = std::get_if<Figure>(&shown.content)) {
            add(*figure);
        } else if (const auto* results = std::get_if<Results>(&shown.content)) {
            add(*results);
        }
    }
}

void PartNumbers::add(const Figure& figure) {
    for (const Figure::Curve& curve : figure.curves) {
        appendValues(curve.x, &curve, nominal_);
    }
    periods_.resize(nominal_.size());
}

void PartNumbers::add(const Results& results) {
    eachNumber(results, [&](int /*row*/, int /*column*/, const ResultNumber& number) {
        nominal_.push_back(number.value);
        periods_.push_back(number.kind == ResultNumber::Kind::Direction ? 360.0 : 0.0);
    });
}

std::vector<double> PartNumbers::of(const SceneModel& sample) const {
    std::vector<double> found;
    found.reserve(nominal_.size());
    for (const Shown& part : parts_) {
        const Content content = sample.part(part.id);
        if (const auto* own = std::get_if<Figure>(&part.content)) {
            const auto* figure = std::get_if<Figure>(&content);
            for (const Figure::Curve& curve : own->curves) {
                const Figure::Curve* same = nullptr;
                if (figure != nullptr) {
                    const auto at = std::find_if(
                        figure->curves.begin(), figure->curves.end(),
                        [&](const Figure::Curve& each) { return each.id == curve.id; });
                    same = at != figure->curves.end() ? &*at : nullptr;
                }
                appendValues(curve.x, same, found);
            }
        } else if (const auto* rows = std::get_if<Results>(&part.content)) {
            const auto* results = std::get_if<Results>(&content);
            eachNumber(*rows, [&](int row, int column, const ResultNumber& /*number*/) {
                const ResultNumber* number = nullptr;
                if (results != nullptr && row < results->rows.size() &&
                    results->rows[row].key() == rows->rows[row].key()) {
                    number = results->rows[row].value(column).number();
                }
                found.push_back(number != nullptr ? number->value : none);
            });
        }
    }
    return found;
}

std::map<std::string, PartSpread, std::less<>> PartNumbers::spreads(const BandSamples::Sides& sides,
                                                                    const QString& how) const {
    std::map<std::string, PartSpread, std::less<>> found;
    for (const Shown& part : parts_) {
        PartSpread spread;
        if (const auto* figure = std::get_if<Figure>(&part.content)) {
            spread = spreadOf(*figure, part.from, sides);
        } else if (const auto* results = std::get_if<Results>(&part.content)) {
            spread = spreadOf(*results, part.from, sides);
        }
        spread.how = how;
        found.emplace(part.id, std::move(spread));
    }
    return found;
}

PartSpread PartNumbers::spreadOf(const Figure& figure, std::size_t from,
                                 const BandSamples::Sides& sides) const {
    PartSpread spread;
    std::size_t at = from;
    for (const Figure::Curve& curve : figure.curves) {
        plot::Spread found;
        double maximum = 0.0;
        double largest = 0.0;
        for (std::size_t i = 0; i < curve.x.size(); ++i, ++at) {
            if (!std::isfinite(curve.x[i]) || !std::isfinite(nominal_[at])) {
                continue;  // it is not drawn
            }
            const bool isKnown = std::isfinite(sides.below[at]);
            found.below.push_back(isKnown ? sides.below[at] : 0.0);
            found.above.push_back(isKnown ? sides.above[at] : 0.0);
            maximum = std::max(maximum, std::abs(nominal_[at]));
            largest = std::max(largest, 0.5 * (found.below.back() + found.above.back()));
        }
        // A line that goes up and down, or to and fro, has no width along y.
        if (largest > rounding * maximum && (isAscending(curve.x) || !isLine(curve))) {
            spread.curves.emplace(curve.id, std::move(found));
        }
    }
    return spread;
}

PartSpread PartNumbers::spreadOf(const Results& results, std::size_t from,
                                 const BandSamples::Sides& sides) const {
    double size = 0.0;
    eachNumber(results, [&](int /*row*/, int /*column*/, const ResultNumber& number) {
        size = std::max(size, std::abs(number.value));
    });
    PartSpread spread;
    std::size_t at = from;
    eachNumber(results, [&](int row, int column, const ResultNumber& number) {
        const double half = 0.5 * (sides.below[at] + sides.above[at]);
        // What is left of two that cancel is rounding, too.
        constexpr double cancelled = 1e-14;
        if (half > rounding * std::abs(number.value) && half > cancelled * size) {
            spread.cells.push_back(
                {row, column, results.rows[row].key(), sides.below[at], sides.above[at]});
        }
        ++at;
    });
    return spread;
}

}  // namespace ravnoves
