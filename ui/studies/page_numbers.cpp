#include "studies/page_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "page/scene_page.h"

namespace ravnoves {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Of numbers, relative: what is less is no spread. Samples are kept as float.
constexpr double rounding = 1e-11;

/// The page's plots, or its tables, in the order in which they were made.
template <typename Part>
QList<Part*> inOrder(const ScenePage& page) {
    QList<Part*> parts = page.findChildren<Part*>();
    std::sort(parts.begin(), parts.end(),
              [](const Part* a, const Part* b) { return a->number() < b->number(); });
    return parts;
}

QString rowName(const ResultTable& table, int row) {
    const QTableWidgetItem* name = table.item(row, 0);
    return name != nullptr ? name->text() : QString();
}

/// A curve's values at places that may be those of another.
std::vector<double> valuesAt(const std::vector<double>& places, const PlotData& data,
                             std::size_t number) {
    if (number < data.curves.size()) {
        const PlotCurve& curve = data.curves[number];
        if (curve.x == places) {
            return curve.y;
        }
        if (curve.isLine() && curve.ascending) {
            std::vector<double> values;
            for (const double x : places) {
                values.push_back(data.valueAt(curve, x).value_or(none));
            }
            return values;
        }
    }
    return std::vector<double>(places.size(), none);
}

}  // namespace

PageNumbers::PageNumbers(const ScenePage& page, const ScenePage& twin, bool ofAll) {
    const auto addAll = [&]<typename Part>(const QList<Part*>& own, const QList<Part*>& twins) {
        for (qsizetype i = 0; i < std::min(own.size(), twins.size()); ++i) {
            if (ofAll || own[i]->isVisible()) {
                add(own[i], twins[i]);
            }
        }
    };
    addAll(inOrder<PlotView>(page), inOrder<PlotView>(twin));
    addAll(inOrder<ResultTable>(page), inOrder<ResultTable>(twin));
}

void PageNumbers::add(PlotView* own, PlotView* twin) {
    Plot plot{own, twin, {}};
    for (const PlotCurve& curve : own->data().curves) {
        plot.curves.push_back({nominal_.size(), curve.x});
        nominal_.insert(nominal_.end(), curve.y.begin(), curve.y.end());
    }
    if (periods_.size() < nominal_.size()) {
        periods_.resize(nominal_.size());
        plots_.push_back(std::move(plot));
    }
}

void PageNumbers::add(ResultTable* own, ResultTable* twin) {
    Table table{own, twin, nominal_.size(), {}};
    for (int row = 0; row < own->rowCount(); ++row) {
        for (int column = 0; column < own->columnCount(); ++column) {
            if (const ResultNumber* number = own->numberAt(row, column)) {
                table.cells.push_back({row, column, rowName(*own, row)});
                nominal_.push_back(number->value);
                periods_.push_back(number->kind == ResultNumber::Kind::Direction ? 360.0 : 0.0);
            }
        }
    }
    if (!table.cells.empty()) {
        tables_.push_back(std::move(table));
    }
}

bool PageNumbers::isWhole() const {
    const auto isThere = [](const auto& part) { return part.own && part.twin; };
    return std::all_of(plots_.begin(), plots_.end(), isThere) &&
           std::all_of(tables_.begin(), tables_.end(), isThere);
}

QList<QWidget*> PageNumbers::twins() const {
    QList<QWidget*> twins;
    for (const Plot& plot : plots_) {
        twins << plot.twin;
    }
    for (const Table& table : tables_) {
        twins << table.twin;
    }
    return twins;
}

std::vector<double> PageNumbers::ofTwin() const {
    std::vector<double> found;
    found.reserve(nominal_.size());
    for (const Plot& plot : plots_) {
        for (std::size_t c = 0; c < plot.curves.size(); ++c) {
            const auto values = valuesAt(plot.curves[c].x, plot.twin->data(), c);
            found.insert(found.end(), values.begin(), values.end());
        }
    }
    for (const Table& table : tables_) {
        for (const Cell& cell : table.cells) {
            const ResultNumber* number = rowName(*table.twin, cell.row) == cell.name
                                             ? table.twin->numberAt(cell.row, cell.column)
                                             : nullptr;
            found.push_back(number != nullptr ? number->value : none);
        }
    }
    return found;
}

void PageNumbers::show(const BandSamples::Sides& sides, const QString& how) const {
    for (const Plot& plot : plots_) {
        showPlot(plot, sides);
    }
    for (const Table& table : tables_) {
        showTable(table, sides, how);
    }
}

void PageNumbers::showPlot(const Plot& plot, const BandSamples::Sides& sides) const {
    for (std::size_t c = 0; c < plot.curves.size(); ++c) {
        const auto& [from, x] = plot.curves[c];
        const PlotCurve& curve = plot.own->data().curves[c];
        std::vector<double> below;
        std::vector<double> above;
        double most = 0.0;
        double largest = 0.0;
        for (std::size_t i = from; i < from + x.size(); ++i) {
            const bool isKnown = std::isfinite(sides.below[i]);
            below.push_back(isKnown ? sides.below[i] : 0.0);
            above.push_back(isKnown ? sides.above[i] : 0.0);
            most = std::max(most, std::abs(nominal_[i]));
            largest = std::max(largest, 0.5 * (below.back() + above.back()));
        }
        // A line that goes up and down, or to and fro, has no width along y.
        const bool isOverX = curve.ascending && !x.empty() && x.back() > x.front();
        const bool hasBand = largest > rounding * most && (isOverX || !curve.isLine());
        plot.own->setSpread(static_cast<int>(c), hasBand ? below : std::vector<double>(),
                            hasBand ? above : std::vector<double>());
    }
}

void PageNumbers::showTable(const Table& table, const BandSamples::Sides& sides,
                            const QString& how) const {
    double size = 0.0;
    for (std::size_t i = 0; i < table.cells.size(); ++i) {
        size = std::max(size, std::abs(nominal_[table.from + i]));
    }
    std::vector<ResultTable::Spread> spreads;
    for (std::size_t i = 0; i < table.cells.size(); ++i) {
        const std::size_t at = table.from + i;
        const double half = 0.5 * (sides.below[at] + sides.above[at]);
        // What is left of two that cancel is rounding, too.
        constexpr double cancelled = 1e-14;
        if (half > rounding * std::abs(nominal_[at]) && half > cancelled * size) {
            const Cell& cell = table.cells[i];
            spreads.push_back({cell.row, cell.column, cell.name, sides.below[at], sides.above[at]});
        }
    }
    table.own->setSpreads(std::move(spreads), how);
}

}  // namespace ravnoves
