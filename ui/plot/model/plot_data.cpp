#include "plot/model/plot_data.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "pictures/model/stroke.h"
#include "plot/model/figure.h"
#include "text/csv_format.h"
#include "text/shown_units.h"

namespace ravnoves {

using plot::CurveStyle;
using plot::Shape;

bool PlotCurve::set(std::vector<double> newX, std::vector<double> newY, const PlotScale& xScale,
                    const PlotScale& yScale) {
    const std::size_t count = std::min(newX.size(), newY.size());
    std::size_t finite = 0;
    std::vector<std::size_t> newStarts;
    std::vector<std::size_t> newPlaces;
    bool left = false;  // the point before this one was left out
    for (std::size_t i = 0; i < count; ++i) {
        const bool there = xScale.holds(newX[i]) && yScale.holds(newY[i]);
        if (there) {
            if (left && style.gaps && finite > 0) {
                newStarts.push_back(finite);
            }
            newX[finite] = newX[i];
            newY[finite] = newY[i];
            if (text) {
                newPlaces.push_back(i);
            }
            ++finite;
        }
        left = !there;
    }
    newX.resize(finite);
    newY.resize(finite);
    places = std::move(newPlaces);
    if (newX == x && newY == y && newStarts == starts) {
        return false;
    }
    x = std::move(newX);
    y = std::move(newY);
    starts = std::move(newStarts);
    ascending = std::is_sorted(x.begin(), x.end());
    stale = true;
    return true;
}

namespace {

/// Under a hand that drags, an interval that still holds what is there, and not much more, rests.
bool rests(const std::pair<double, double>& shown, const std::pair<double, double>& wanted) {
    constexpr double enough = 0.6;
    return PlotData::steady && shown.first <= wanted.first && wanted.second <= shown.second &&
           wanted.second - wanted.first > enough * (shown.second - shown.first);
}

}  // namespace

bool PlotData::showX(const plot::Axis& axis) {
    const PlotScale before = x;
    if (!x.setSpec(axis)) {
        return false;
    }
    const bool isOther = before.spec.title != x.spec.title;
    if (!isOther && rests({before.spec.min, before.spec.max}, {axis.min, axis.max})) {
        x = before;
        return false;
    }
    if (zoomed && !isOther) {
        return false;  // it is to be gone back to
    }
    x.low = axis.min;
    x.high = axis.max;
    zoomed = false;
    makeStale();
    return true;
}

bool PlotData::showY(const plot::Axis& axis,
                     const std::optional<std::pair<double, double>>& range) {
    const bool isOther = left.setSpec(axis);
    if (isOther && axis.logarithmic) {
        makeStale();
        if (!(left.low > 0.0)) {
            left.low = 0.1;
            left.high = 1.0;
        }
    }
    const bool isFixed =
        range
            ? (!left.fixed || !rests(*left.fixed, *range)) && left.fix(range->first, range->second)
            : std::exchange(left.fixed, std::nullopt).has_value();  // it follows its data again
    return isOther || isFixed;
}

PlotData::Change PlotData::show(const Figure& figure) {
    bool isOther = std::exchange(title, figure.title) != figure.title;
    bool isMoved = false;
    bool isTop = cursorX || pointRead;  // what is read there may be another
    isOther |= showX(figure.x);
    isOther |= showY(figure.left, figure.leftRange);
    isOther |= std::exchange(equalScale, figure.equalScale) != figure.equalScale;
    const auto showPoints = [&](PlotCurve& drawn, const std::vector<double>& xs,
                                const std::vector<double>& ys) {
        const bool wasEmpty = drawn.x.empty();
        if (drawn.set(xs, ys, x, left)) {
            pointRead.reset();
            isMoved = true;
            isOther |= wasEmpty != drawn.x.empty();
        }
    };
    for (PlotCurve& drawn : curves) {
        const bool isIn = figure.find(drawn.id) != nullptr;
        isOther |= std::exchange(drawn.inFigure, isIn) != isIn;
        if (!isIn) {
            showPoints(drawn, {}, {});
        }
    }
    for (const Figure::Curve& curve : figure.curves) {
        const auto known = find(curve.id);
        PlotCurve& drawn = known ? curves[*known] : curves.emplace_back();
        if (!known) {
            drawn.id = curve.id;
            drawn.shown = curve.style.shown;
        }
        if (!known || drawn.style != curve.style) {
            drawn.style = curve.style;
            drawn.stale = isOther = true;
        }
        drawn.trueX = curve.trueX;
        drawn.trueY = curve.trueY;
        if (curve.text || drawn.text) {
            pointRead.reset();
            drawn.text = curve.text;
        }
        showPoints(drawn, curve.x, curve.y);
    }
    isOther |= std::exchange(bands, figure.bands) != figure.bands;
    isTop |= std::exchange(lines, figure.lines) != figure.lines;
    isTop |= figure.marks && std::exchange(marks, *figure.marks) != *figure.marks;
    isTop |= figure.presentX && std::exchange(presentX, figure.presentX) != figure.presentX;
    return isOther ? Change::Chart : isMoved ? Change::Curves : isTop ? Change::Top : Change::None;
}

QPointF PlotData::toPixel(double valueX, double valueY) const {
    return {area.left() + x.fraction(valueX) * area.width(),
            area.bottom() - left.fraction(valueY) * area.height()};
}

double PlotData::xAt(double pixelX) const {
    return x.value((pixelX - area.left()) / std::max(1.0, area.width()));
}

double PlotData::yAt(double pixelY) const {
    return left.value((area.bottom() - pixelY) / std::max(1.0, area.height()));
}

std::optional<std::size_t> PlotData::find(std::string_view id) const {
    const auto found = std::find_if(curves.begin(), curves.end(),
                                    [&](const PlotCurve& curve) { return curve.id == id; });
    return found != curves.end() ? std::optional(static_cast<std::size_t>(found - curves.begin()))
                                 : std::nullopt;
}

const PlotCurve* PlotData::curveOfReference(const PlotCurve& curve) const {
    const auto number = reference != nullptr ? reference->find(curve.id) : std::nullopt;
    const PlotCurve* found = number ? &reference->curves[*number] : nullptr;
    return found != nullptr && !found->x.empty() ? found : nullptr;
}

const PlotCurve* PlotData::ghostOf(const PlotCurve& curve) const {
    const PlotCurve* ghost = referenceShown && curve.shown ? curveOfReference(curve) : nullptr;
    // Another quantity has no place on this axis.
    return ghost != nullptr && reference->left.spec.title == left.spec.title ? ghost : nullptr;
}

bool PlotData::hasGhosts() const {
    return reference != nullptr &&
           std::any_of(reference->curves.begin(), reference->curves.end(),
                       [](const PlotCurve& curve) { return !curve.x.empty(); });
}

bool PlotData::hasSpread() const {
    return std::any_of(curves.begin(), curves.end(),
                       [](const PlotCurve& curve) { return curve.hasSpread(); });
}

std::pair<double, double> PlotData::spreadAt(const PlotCurve& curve, std::size_t point) const {
    const auto held = [&](double value) { return left.holds(value) ? value : left.low; };
    return {held(curve.y[point] - curve.below[point]), held(curve.y[point] + curve.above[point])};
}

std::optional<std::pair<double, double>> PlotData::spreadAt(const PlotCurve& curve,
                                                            double at) const {
    const auto middle = valueAt(curve, at);
    if (!middle || !showsSpread(curve) || curve.style.shape == Shape::Bars) {
        return std::nullopt;
    }
    const auto upper = std::upper_bound(curve.x.begin(), curve.x.end(), at);
    const auto next =
        std::min(static_cast<std::size_t>(upper - curve.x.begin()), curve.x.size() - 1);
    const std::size_t before = next > 0 ? next - 1 : 0;
    const double stretch = curve.x[next] - curve.x[before];
    const double part = stretch > 0.0 ? (at - curve.x[before]) / stretch : 0.0;
    return std::pair(*middle - std::lerp(curve.below[before], curve.below[next], part),
                     *middle + std::lerp(curve.above[before], curve.above[next], part));
}

bool PlotData::liesOnAnother(const PlotCurve& curve) const {
    if (curve.pen() != Qt::DashLine) {
        return false;
    }
    constexpr double wider = 1.25;
    for (const PlotCurve& other : curves) {
        if (&other == &curve) {
            break;  // what comes later lies over it
        }
        if (other.shown && !other.stretches.empty() && other.pen() == Qt::SolidLine &&
            other.style.width > wider * curve.style.width) {
            return true;
        }
    }
    return false;
}

void PlotData::fitScales() {
    if (zoomed) {
        return;
    }
    x.low = x.spec.min;
    x.high = x.spec.max;
    const bool both = hasGhosts() && referenceShown;
    if (both) {
        x.low = std::min(x.low, reference->x.spec.min);
        x.high = std::max(x.high, reference->x.spec.max);
    }
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -minimum;
    for (const PlotCurve& curve : curves) {
        for (const PlotCurve* each : {&curve, ghostOf(curve)}) {
            if (each != nullptr && curve.shown && !each->y.empty() &&
                !(left.fixed && each == &curve)) {
                const auto [low, high] = std::minmax_element(each->y.begin(), each->y.end());
                const bool fromZero =
                    curve.style.shape == Shape::Bars && !left.fixed && !left.spec.logarithmic;
                minimum = std::min({minimum, *low, fromZero ? 0.0 : *low});
                maximum = std::max({maximum, *high, fromZero ? 0.0 : *high});
            }
        }
        for (std::size_t i = 0; !left.fixed && showsSpread(curve) && i < curve.x.size(); ++i) {
            const double low = curve.y[i] - curve.below[i];
            const double high = curve.y[i] + curve.above[i];
            minimum = left.holds(low) ? std::min(minimum, low) : minimum;
            maximum = left.holds(high) ? std::max(maximum, high) : maximum;
        }
    }
    left.fit(minimum, maximum, steady);
    if (both && left.fixed) {
        // It holds the reference, too, with a little room.
        const auto [low, high] = *left.fixed;
        const auto [from, to] = reference->left.fixed.value_or(std::pair(minimum, maximum));
        left.low = std::min(low, from);
        left.high = std::max(high, to);
        const bool hasRoom = reference->left.fixed || left.spec.logarithmic;
        const double pad = hasRoom ? 0.0 : 0.04 * (left.high - left.low);
        left.low -= left.low < low ? pad : 0.0;
        left.high += left.high > high ? pad : 0.0;
    }
}

void PlotData::endWithData() {
    const auto span = [this](const PlotScale& scale) {
        const auto [low, high] = zoomed ? scale.home : scale.interval();
        return high - low;
    };
    const QSizeF first(span(x), span(left));
    const QSizeF all = image.isNull() ? first : imageValues.size();
    constexpr double ticks = 100.0;  // pixels that they need, also beside a straight motion
    const auto within = [ticks](double size, double room) {
        return std::min(room, std::max(size, ticks));
    };
    area.setSize({within(area.height() * all.width() / first.height(), area.width()),
                  within(area.width() * all.height() / first.width(), area.height())});
}

void PlotData::equalise() {
    for (PlotScale* scale : {&x, &left}) {
        std::tie(scale->low, scale->high) = zoomed ? scale->section : scale->interval();
    }
    const double perX = (x.high - x.low) / area.width();
    const double perY = (left.high - left.low) / area.height();
    if (perX > perY * (1 + 1e-9)) {
        left.widen(perX * area.height());
    } else if (perY > perX * (1 + 1e-9)) {
        x.widen(perY * area.width());
    }
}

void PlotData::keepHome() {
    if (!zoomed) {
        for (PlotScale* scale : {&x, &left}) {
            scale->home = scale->interval();
        }
    }
}

void PlotData::zoom(double factorX, double factorY, const QPointF& about) {
    if (area.isEmpty()) {
        return;
    }
    if (equalScale) {
        factorY = factorX = factorX == 1.0 ? factorY : factorX;
    }
    keepHome();
    x.zoom(factorX, std::clamp((about.x() - area.left()) / area.width(), 0.0, 1.0));
    left.zoom(factorY, std::clamp((area.bottom() - about.y()) / area.height(), 0.0, 1.0));
    zoomed = !(x.isHome() && left.isHome());
}

void PlotData::pan(const QPointF& pixels) {
    keepHome();
    zoomed = true;
    x.shift(-pixels.x() / area.width());
    left.shift(pixels.y() / area.height());
}

void PlotData::makeStale() {
    for (PlotCurve& curve : curves) {
        curve.stale = true;
    }
}

void PlotData::thinCurves() {
    for (PlotCurve& curve : curves) {
        if (!curve.stale) {
            continue;
        }
        curve.stale = false;
        curve.stretches.clear();
        curve.shades.clear();
        if (curve.shown) {
            curve.stretches = stretchesOf(curve);
        }
        if (showsSpread(curve)) {
            curve.shades = shadesOf(curve);
        }
    }
}

std::vector<QPolygonF> PlotData::shadesOf(const PlotCurve& curve) const {
    PlotCurve low = curve;
    PlotCurve high = curve;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        std::tie(low.y[i], high.y[i]) = spreadAt(curve, i);
    }
    std::vector<QPolygonF> shades = stretchesOf(high);
    const std::vector<QPolygonF> feet = stretchesOf(low);
    for (std::size_t i = 0; i < shades.size(); ++i) {
        std::copy(feet[i].rbegin(), feet[i].rend(), std::back_inserter(shades[i]));
    }
    return shades;
}

std::vector<QPolygonF> PlotData::stretchesOf(const PlotCurve& curve) const {
    std::vector<QPolygonF> stretches;
    const bool isThere = curve.isLine() && !curve.x.empty();
    std::size_t from = 0;
    for (std::size_t next = 0; isThere && next <= curve.starts.size(); ++next) {
        const std::size_t to = next < curve.starts.size() ? curve.starts[next] : curve.x.size();
        std::vector<QPointF> pixels;
        pixels.reserve(to - from);
        for (; from < to; ++from) {
            pixels.push_back(pixelOf(curve, from));
        }
        stretches.push_back(thinPolyline(pixels));
    }
    return stretches;
}

namespace {

/// The bar that is at x, with those beside it in its group; -1: none.
std::ptrdiff_t barOf(const PlotCurve& curve, double at) {
    const auto nearest =
        std::ranges::min_element(curve.x, {}, [at](double x) { return std::abs(x - at); });
    const double reach = std::abs(curve.style.barShift) + 0.5 * curve.style.barWidth;
    const bool isThere =
        nearest != curve.x.end() && std::abs(*nearest - at) <= reach * (1.0 + 1e-9);
    return isThere ? nearest - curve.x.begin() : -1;
}

}  // namespace

std::optional<double> PlotData::barsAt(double at) const {
    std::optional<double> middle;
    for (const PlotCurve& curve : curves) {
        if (!curve.shown || curve.x.empty()) {
            continue;
        }
        if (curve.style.shape != Shape::Bars) {
            return std::nullopt;
        }
        if (const std::ptrdiff_t bar = barOf(curve, at); bar >= 0 && !middle) {
            middle = curve.x[static_cast<std::size_t>(bar)];
        }
    }
    return middle;
}

std::optional<double> PlotData::valueAt(const PlotCurve& curve, double at) const {
    if (curve.style.shape == Shape::Bars) {
        const std::ptrdiff_t bar = barOf(curve, at);
        return bar < 0 ? std::nullopt : std::optional(curve.y[static_cast<std::size_t>(bar)]);
    }
    if (curve.x.empty() || !curve.ascending || !(at >= curve.x.front() && at <= curve.x.back()) ||
        !curve.isLine()) {
        return std::nullopt;
    }
    const auto upper = std::upper_bound(curve.x.begin(), curve.x.end(), at);
    const auto i = static_cast<std::size_t>(upper - curve.x.begin());
    if (at == curve.x[i - 1]) {
        return curve.y[i - 1];
    }
    if (std::binary_search(curve.starts.begin(), curve.starts.end(), i)) {
        return std::nullopt;  // in a gap
    }
    // Along the straight line that is drawn between the points, on whatever scale.
    const double from = x.scaled(curve.x[i - 1]);
    const double fraction = (x.scaled(at) - from) / (x.scaled(curve.x[i]) - from);
    return left.unscaled(std::lerp(left.scaled(curve.y[i - 1]), left.scaled(curve.y[i]), fraction));
}

bool PlotData::readsPoints() const {
    return std::any_of(curves.begin(), curves.end(),
                       [](const PlotCurve& curve) { return curve.style.turn > 0.0 || curve.text; });
}

std::optional<PlotData::Point> PlotData::nearestPoint(const QPointF& pixel, double reach) const {
    std::optional<Point> nearest;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const PlotCurve& curve = curves[c];
        for (std::size_t i = 0; curve.isReadable() && i < curve.x.size(); ++i) {
            const QPointF away = pixelOf(curve, i) - pixel;
            const double distance = std::hypot(away.x(), away.y());
            if (distance < reach) {
                reach = distance;
                nearest = Point(c, i);
            }
        }
    }
    return nearest;
}

std::optional<PlotData::Point> PlotData::nextPoint(int by) const {
    std::vector<Point> points;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        for (std::size_t i = 0; curves[c].isReadable() && i < curves[c].x.size(); ++i) {
            points.emplace_back(c, i);
        }
    }
    if (points.empty()) {
        return pointRead;
    }
    const auto count = static_cast<std::ptrdiff_t>(points.size());
    std::ptrdiff_t next = by > 0 ? 0 : count - 1;
    if (pointRead) {
        const auto found = std::find(points.begin(), points.end(), *pointRead);
        next = (found - points.begin() + by + count) % count;
    }
    return points[static_cast<std::size_t>(next)];
}

QString PlotData::csv(const CsvFormat& format) const {
    const auto isAscending = [](const PlotCurve& curve) {
        return std::adjacent_find(curve.x.begin(), curve.x.end(), std::greater_equal<>()) ==
               curve.x.end();
    };
    // In their true places: curves, and below each that of the reference, named with it.
    std::vector<std::pair<QString, PlotCurve>> listed;
    std::vector<double> common;
    const auto list = [&](const QString& before, PlotCurve curve, const CurveStyle& style) {
        curve.style = style;
        if (!curve.trueX.empty()) {
            curve.set(curve.trueX, curve.trueY, x, left);
        }
        if (isAscending(curve)) {
            common.insert(common.end(), curve.x.begin(), curve.x.end());
        }
        listed.emplace_back(before, std::move(curve));
    };
    for (const PlotCurve& curve : curves) {
        if (curve.shown && !curve.x.empty()) {
            list({}, curve, curve.style);
        }
        if (const PlotCurve* ghost = ghostOf(curve)) {
            list(referenceName + QStringLiteral(": "), *ghost, curve.style);
        }
    }
    std::sort(common.begin(), common.end());
    common.erase(std::unique(common.begin(), common.end()), common.end());
    std::vector<QStringList> columns;  // each with its heading
    const auto addColumn = [&](QString heading, const std::vector<double>& values,
                               const PlotScale& scale, const std::vector<double>* places) {
        QStringList& cells = columns.emplace_back();
        cells << QLatin1Char('"') + heading.replace(QLatin1Char('"'), QLatin1String("\"\"")) +
                     QLatin1Char('"');
        for (std::size_t i = 0; i < values.size(); ++i) {
            while (places != nullptr &&
                   common[static_cast<std::size_t>(cells.size()) - 1] != (*places)[i]) {
                cells << QString();
            }
            cells << format.number(values[i] * scale.spec.factor);
        }
    };
    if (!common.empty()) {
        addColumn(x.spec.title, common, x, nullptr);
    }
    for (const auto& [before, curve] : listed) {
        const std::vector<double>* places = isAscending(curve) ? &curve.x : nullptr;
        const QString name = before + curve.style.name;
        if (places == nullptr) {
            addColumn(name + QStringLiteral(": ") + x.spec.title, curve.x, x, nullptr);
        }
        const QString heading = curve.style.name.isEmpty()
                                    ? before + left.spec.title
                                    : titleWithUnit(name, unitOfTitle(left.spec.title));
        addColumn(heading, curve.y, left, places);
        if (before.isEmpty() && showsSpread(curve)) {
            std::vector<double> low = curve.y;
            std::vector<double> high = curve.y;
            std::ranges::transform(low, curve.below, low.begin(), std::minus<>());
            std::ranges::transform(high, curve.above, high.begin(), std::plus<>());
            addColumn(heading + QStringLiteral(", 5 %"), low, left, places);
            addColumn(heading + QStringLiteral(", 95 %"), high, left, places);
        }
    }
    qsizetype rows = 0;
    for (const QStringList& column : columns) {
        rows = std::max(rows, column.size());
    }
    QString table;
    for (qsizetype row = 0; row < rows; ++row) {
        QStringList line;
        for (const QStringList& column : columns) {
            line << column.value(row);
        }
        table += line.join(format.separator) + QLatin1Char('\n');
    }
    return table;
}

}  // namespace ravnoves
