#include "studies/band_run.h"

#include <algorithm>
#include <cmath>

#include "plot/legend_item.h"
#include "studies/tolerance_bands.h"

namespace ravnoves {

namespace {

/// Of numbers, relative: what is less is no spread.
constexpr double rounding = 1e-11;

/// What the entry of the bands in a plot's legend says; where slopes fail it is marked.
void sayOfBands(PlotView& plot, bool isMarked, const QString& tip) {
    auto* entry = plot.findChild<LegendItem*>(QStringLiteral("spread"), Qt::FindDirectChildrenOnly);
    if (entry == nullptr) {
        return;
    }
    entry->setToolTip(tip);
    const QString mark = QStringLiteral(" ⚠");
    QString text = entry->text();
    if (text.endsWith(mark) != isMarked) {
        isMarked ? void(text += mark) : text.chop(mark.size());
        entry->setText(text);
        plot.setCurveStyle(0, plot.data().curve(0).style);  // it takes another room
    }
}

/// Other numbers than there were: of other rows, or a curve that does not go on there.
void append(std::vector<double>& all, const std::vector<double>& values, std::size_t count) {
    if (values.size() == count) {
        all.insert(all.end(), values.begin(), values.end());
    } else {
        all.resize(all.size() + count, BandSlopes::none);
    }
}

std::vector<double> cellsOf(const ResultTable& table) {
    std::vector<double> found;
    for (int row = 0; row < table.rowCount(); ++row) {
        for (int column = 0; column < table.columnCount(); ++column) {
            const ResultNumber* number = table.numberAt(row, column);
            found.push_back(number != nullptr ? number->value : BandSlopes::none);
        }
    }
    return found;
}

/// A curve's values at places that may be those of another.
std::vector<double> valuesAt(const std::vector<double>& places, const PlotData& data,
                             const PlotCurve& curve) {
    if (curve.x == places) {
        return curve.y;
    }
    std::vector<double> values;
    const bool goesOn = curve.isLine() && curve.ascending;
    for (std::size_t i = 0; goesOn && i < places.size(); ++i) {
        values.push_back(data.valueAt(curve, places[i]).value_or(BandSlopes::none));
    }
    return values;
}

}  // namespace

std::vector<double> BandRun::numbers() const {
    std::vector<double> found;
    found.reserve(nominal.size());
    for (std::size_t p = 0; p < plots.size(); ++p) {
        const PlotData& data = plots[p].second->data();
        for (std::size_t c = 0; c < curves[p].size(); ++c) {
            const std::vector<double> values = c < data.curves.size()
                                                   ? valuesAt(x[p][c], data, data.curves[c])
                                                   : std::vector<double>();
            append(found, values, curves[p][c].count);
        }
    }
    for (std::size_t t = 0; t < tables.size(); ++t) {
        append(found, cellsOf(*tables[t].second), cells[t].count);
    }
    return found;
}

void BandRun::layOut() {
    std::size_t size = 0;
    for (const auto& [plot, twin] : plots) {
        auto& places = x.emplace_back();
        auto& stretches = curves.emplace_back();
        for (const PlotCurve& curve : twin->data().curves) {
            places.push_back(curve.x);
            stretches.push_back({size, curve.x.size()});
            size += curve.x.size();
        }
    }
    periods.assign(size, 0.0);
    for (const auto& [table, twin] : tables) {
        cells.push_back({size, cellsOf(*twin).size()});
        size += cells.back().count;
        for (int row = 0; row < twin->rowCount(); ++row) {
            for (int column = 0; column < twin->columnCount(); ++column) {
                const ResultNumber* number = twin->numberAt(row, column);
                const bool isDirection =
                    number != nullptr && number->kind == ResultNumber::Kind::Direction;
                periods.push_back(isDirection ? 360.0 : 0.0);
            }
        }
    }
    nominal = numbers();
    variance.resize(nominal.size());
    shift.resize(nominal.size());
    for (BandTask::Source& each : sources) {
        each.slopes.resize(nominal.size());
    }
    isLaidOut = true;
}

void BandRun::take(std::optional<std::vector<double>> found) {
    if (isUp()) {
        plus = std::move(found);
    } else {
        BandTask::Source& moved = sources[source()];
        const bool isCentred = moved.law.mean == input.at(moved.place).get<double>();
        moved.slopes = add(plus, found, isCentred);
    }
    ++next;
}

std::vector<BandTask::Group> BandRun::groups() const {
    std::vector<BandTask::Group> all;
    const auto add = [&](std::size_t from, std::size_t count, const QString& name) {
        all.push_back({from, count, QStringLiteral("“%1”").arg(name).toStdString()});
    };
    for (std::size_t p = 0; p < plots.size(); ++p) {
        for (std::size_t c = 0; c < curves[p].size(); ++c) {
            const QString name = plots[p].second->curveName(static_cast<int>(c));
            add(curves[p][c].from, curves[p][c].count,
                name.isEmpty() ? plots[p].second->title() : name);
        }
    }
    for (std::size_t t = 0; t < tables.size(); ++t) {
        const ResultTable& table = *tables[t].first;
        const auto columns = static_cast<std::size_t>(tables[t].second->columnCount());
        for (std::size_t i = 0; i < cells[t].count; ++i) {
            if (!std::isfinite(nominal[cells[t].from + i])) {
                continue;
            }
            const int row = static_cast<int>(i / columns);
            const int column = static_cast<int>(i % columns);
            const QTableWidgetItem* name = table.item(row, 0);
            const QTableWidgetItem* heading = table.horizontalHeaderItem(column);
            QString text = name != nullptr ? name->text() : QString();
            if (columns > 2 && heading != nullptr) {
                text += QStringLiteral(", ") + heading->text();
            }
            add(cells[t].from + i, 1, text);
        }
    }
    return all;
}

BandRun::Shown BandRun::slopes() const {
    Shown found;
    found.below = below();
    found.above = above();
    found.howCurves = ToleranceBands::tr(
        "Where the tolerances let the curves lie: ± 1.645 σ, by slopes; 5 % below the band and "
        "5 % above it where the results go straight with the inputs");
    found.howNumbers = ToleranceBands::tr(
        "What the tolerances make of it: 1.645 σ, by slopes, half of the range from 5 % to 95 "
        "% where it goes straight with the inputs");
    return found;
}

void BandRun::show(const Shown& shown) const {
    std::map<std::size_t, QString> fails;
    for (const auto& [group, why] : shown.fails) {
        fails.emplace(group.from, why);
    }
    for (std::size_t p = 0; p < plots.size(); ++p) {
        showPlot(p, shown, fails);
    }
    for (std::size_t t = 0; t < tables.size(); ++t) {
        showTable(t, shown, fails);
    }
}

void BandRun::showPlot(std::size_t p, const Shown& shown,
                       const std::map<std::size_t, QString>& fails) const {
    PlotView& plot = *plots[p].first;
    if (std::any_of(slow.begin(), slow.end(),
                    [&](const auto& each) { return each.first == &plot; })) {
        return;
    }
    plot.setSpreadStale(shown.isStale);
    QStringList why;
    const std::size_t count =
        std::min(curves[p].size(), static_cast<std::size_t>(plot.curveCount()));
    for (std::size_t c = 0; c < count; ++c) {
        const std::size_t from = curves[p][c].from;
        const std::size_t size = curves[p][c].count;
        const auto part = [&](const std::vector<double>& all) {
            return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(from),
                                       all.begin() + static_cast<std::ptrdiff_t>(from + size));
        };
        double most = 0.0;
        double largest = 0.0;
        for (std::size_t i = from; i < from + size; ++i) {
            most = std::max(most, std::abs(nominal[i]));
            largest = std::max(largest, 0.5 * (shown.below[i] + shown.above[i]));
        }
        const PlotCurve& curve = plots[p].second->data().curves[c];
        // A line that goes up and down, or to and fro, has no width along y.
        const bool isOverX =
            curve.ascending && !curve.x.empty() && curve.x.back() > curve.x.front();
        const bool hasBand = largest > rounding * most && (isOverX || !curve.isLine());
        plot.setSpread(static_cast<int>(c), hasBand ? part(shown.below) : std::vector<double>(),
                       hasBand ? part(shown.above) : std::vector<double>());
        if (const auto found = fails.find(from); hasBand && found != fails.end()) {
            why << found->second;
        }
    }
    sayOfBands(plot, !why.isEmpty(), (QStringList{shown.howCurves} + why).join(QLatin1Char('\n')));
}

void BandRun::showTable(std::size_t t, const Shown& shown,
                        const std::map<std::size_t, QString>& fails) const {
    ResultTable& table = *tables[t].first;
    const int columns = tables[t].second->columnCount();
    const auto [from, count] = cells[t];
    std::vector<ResultTable::Spread> spreads;
    double size = 0.0;
    for (std::size_t i = from; i < from + count; ++i) {
        size = std::isfinite(nominal[i]) ? std::max(size, std::abs(nominal[i])) : size;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = from + i;
        const int row = static_cast<int>(i) / columns;
        const double half = 0.5 * (shown.below[at] + shown.above[at]);
        const QTableWidgetItem* name = table.item(row, 0);
        // What is left of two that cancel is rounding, too.
        constexpr double cancelled = 1e-14;
        if (name != nullptr && half > rounding * std::abs(nominal[at]) && half > cancelled * size) {
            const auto why = fails.find(at);
            spreads.push_back({row, static_cast<int>(i) % columns, name->text(), shown.below[at],
                               shown.above[at], why != fails.end() ? why->second : QString()});
        }
    }
    table.setSpreads(std::move(spreads), shown.howNumbers);
}

}  // namespace ravnoves
