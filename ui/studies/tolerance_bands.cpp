#include "studies/tolerance_bands.h"

#include <QEvent>
#include <QPointer>
#include <QShowEvent>
#include <QTabWidget>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/background_job.h"
#include "plot/plot_view.h"
#include "shell/scene_list.h"
#include "shell/scene_page.h"
#include "studies/law.h"
#include "studies/study.h"
#include "studies/tolerance_switch.h"
#include "text/all_digits.h"
#include "text/difference_text.h"
#include "widgets/page_columns.h"
#include "widgets/result_table.h"

namespace ravnoves {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// 95 % point of the normal distribution.
constexpr double point95 = 1.6448536269514722;

/// The page's plots, or its tables, in the order in which they were made.
template <typename Part>
QList<Part*> inOrder(const ScenePage& page) {
    QList<Part*> parts = page.findChildren<Part*>();
    std::sort(parts.begin(), parts.end(),
              [](const Part* a, const Part* b) { return a->number() < b->number(); });
    return parts;
}

/// Those of the page that are seen, with their counterparts.
template <typename Part>
std::vector<std::pair<QPointer<Part>, QPointer<Part>>> seen(const ScenePage& page,
                                                            const ScenePage& twin) {
    const QList<Part*> parts = inOrder<Part>(page);
    const QList<Part*> others = inOrder<Part>(twin);
    std::vector<std::pair<QPointer<Part>, QPointer<Part>>> pairs;
    for (qsizetype i = 0; i < std::min(parts.size(), others.size()); ++i) {
        if (parts[i]->isVisible()) {
            pairs.emplace_back(parts[i], others[i]);
        }
    }
    return pairs;
}

/// A result with both sides of a standard deviation, as far as there are.
double moved(double nominal, double plus, double minus, double period = 0.0) {
    const auto apart = [&](double from, double to) {
        return period > 0.0 ? std::remainder(to - from, period) : to - from;
    };
    if (std::isfinite(plus) && std::isfinite(minus)) {
        return 0.5 * apart(minus, plus);
    }
    return std::isfinite(plus) ? apart(nominal, plus) : apart(minus, nominal);
}

}  // namespace

struct ToleranceBands::Snapshot {
    /// By plot and curve, at the x of the nominal curve; empty where it has no band.
    std::vector<std::vector<std::vector<double>>> curves;
    /// By table, row by row.
    std::vector<std::vector<double>> cells;
};

/// One input after the other.
struct ToleranceBands::Run {
    struct Source {
        Json::json_pointer place;
        double mean = 0.0;
        double deviation = 0.0;
        bool isCentred = true;  ///< its mean is its nominal value
    };
    struct Sum {
        double variance = 0.0;
        double shift = 0.0;  ///< of the mean

        void add(double nominal, double plus, double minus, const Source& source, double period) {
            const double by = moved(nominal, plus, minus, period);
            if (!std::isfinite(by)) {
                return;
            }
            variance += by * by;
            if (!source.isCentred && std::isfinite(plus) && std::isfinite(minus)) {
                shift += 0.5 * (plus + minus) - nominal;
            }
        }
        double half() const { return point95 * std::sqrt(variance); }
    };

    Json input;
    std::vector<Source> sources;
    std::vector<std::pair<QPointer<PlotView>, QPointer<PlotView>>> plots;  ///< page's and twin's
    std::vector<std::pair<QPointer<ResultTable>, QPointer<ResultTable>>> tables;
    std::set<QWidget*> shown;  ///< what of the twin fills itself when it is shown
    std::vector<std::vector<std::vector<double>>> x;  ///< by plot and curve
    std::vector<std::vector<double>> periods;         ///< of cells that are angles; else 0
    Snapshot nominal;
    std::optional<Snapshot> plus;
    std::size_t next = 0;  ///< solution: up and down for each source
    std::vector<std::vector<std::vector<Sum>>> curveSums;
    std::vector<std::vector<Sum>> cellSums;

    bool isWhole() const {
        return std::all_of(plots.begin(), plots.end(),
                           [](const auto& each) { return each.first && each.second; }) &&
               std::all_of(tables.begin(), tables.end(),
                           [](const auto& each) { return each.first && each.second; });
    }
    /// Of the twin as it stands.
    Snapshot snapshot() const {
        Snapshot taken;
        for (std::size_t p = 0; p < plots.size(); ++p) {
            const PlotData& data = plots[p].second->data();
            auto& curves = taken.curves.emplace_back();
            for (std::size_t c = 0; c < data.curves.size(); ++c) {
                curves.push_back(at(p < x.size() && c < x[p].size() ? x[p][c] : data.curves[c].x,
                                    data, data.curves[c]));
            }
        }
        for (const auto& [table, twin] : tables) {
            auto& cells = taken.cells.emplace_back();
            for (int row = 0; row < twin->rowCount(); ++row) {
                for (int column = 0; column < twin->columnCount(); ++column) {
                    const QTableWidgetItem* cell = twin->item(row, column);
                    const auto number = cell != nullptr && column > 0
                                            ? readShownNumber(cell->text())
                                            : std::nullopt;
                    cells.push_back(number ? number->value : none);
                }
            }
        }
        return taken;
    }
    /// A curve's values at places that may be those of another.
    static std::vector<double> at(const std::vector<double>& places, const PlotData& data,
                                  const PlotCurve& curve) {
        if (curve.x == places) {
            return curve.y;
        }
        std::vector<double> values;
        const bool goesOn = curve.isLine() && curve.ascending;
        for (std::size_t i = 0; goesOn && i < places.size(); ++i) {
            values.push_back(data.valueAt(curve, places[i]).value_or(none));
        }
        return values;
    }
    void begin() {
        nominal = snapshot();
        for (const auto& [plot, twin] : plots) {
            auto& curves = x.emplace_back();
            for (const PlotCurve& curve : twin->data().curves) {
                curves.push_back(curve.x);
            }
        }
        for (const auto& curves : nominal.curves) {
            auto& sums = curveSums.emplace_back();
            for (const auto& values : curves) {
                sums.emplace_back(values.size());
            }
        }
        for (std::size_t t = 0; t < tables.size(); ++t) {
            cellSums.emplace_back(nominal.cells[t].size());
            auto& angles = periods.emplace_back();
            const ResultTable& twin = *tables[t].second;
            for (int row = 0; row < twin.rowCount(); ++row) {
                for (int column = 0; column < twin.columnCount(); ++column) {
                    const QTableWidgetItem* cell = twin.item(row, column);
                    const QTableWidgetItem* heading = twin.horizontalHeaderItem(column);
                    const bool isAngle =
                        (cell != nullptr && cell->text().endsWith(QChar(0x00B0))) ||
                        (heading != nullptr && heading->text().endsWith(QChar(0x00B0)));
                    angles.push_back(isAngle ? 360.0 : 0.0);
                }
            }
        }
    }
    void add(const std::optional<Snapshot>& up, const std::optional<Snapshot>& down,
             const Source& source) {
        const auto value = [](const std::vector<double>* values, std::size_t i) {
            return values != nullptr && i < values->size() ? (*values)[i] : none;
        };
        for (std::size_t p = 0; p < curveSums.size(); ++p) {
            for (std::size_t c = 0; c < curveSums[p].size(); ++c) {
                const auto* above = up ? &up->curves[p][c] : nullptr;
                const auto* under = down ? &down->curves[p][c] : nullptr;
                for (std::size_t i = 0; i < curveSums[p][c].size(); ++i) {
                    curveSums[p][c][i].add(nominal.curves[p][c][i], value(above, i),
                                           value(under, i), source, 0.0);
                }
            }
        }
        for (std::size_t t = 0; t < cellSums.size(); ++t) {
            // Another number of rows: other rows.
            const std::size_t count = cellSums[t].size();
            const auto* above = up && up->cells[t].size() == count ? &up->cells[t] : nullptr;
            const auto* under = down && down->cells[t].size() == count ? &down->cells[t] : nullptr;
            for (std::size_t i = 0; i < count; ++i) {
                cellSums[t][i].add(nominal.cells[t][i], value(above, i), value(under, i), source,
                                   periods[t][i]);
            }
        }
    }
};

ToleranceBands::ToleranceBands(ScenePage* page) : QObject(page), page_(page) {
    later_.setSingleShot(true);
    later_.setInterval(0);
    connect(&later_, &QTimer::timeout, this, &ToleranceBands::step);
    const SceneModel* model = page->model();
    for (const auto signal : {&SceneModel::changed, &SceneModel::viewChanged,
                              &SceneModel::historyChanged, &SceneModel::studyChanged}) {
        connect(model, signal, this, [this] { outdate(true); });
    }
    for (const QTabWidget* tabs : page->findChildren<QTabWidget*>()) {
        connect(tabs, &QTabWidget::currentChanged, this, [this] { outdate(false); });
    }
    connect(&ToleranceSwitch::instance(), &ToleranceSwitch::changed, this,
            [this] { outdate(true); });
    page->installEventFilter(this);
}

ToleranceBands::~ToleranceBands() = default;

bool ToleranceBands::eventFilter(QObject* watched, QEvent* event) {
    if (watched == page_ && event->type() == QEvent::Show) {
        outdate(false);
    }
    return QObject::eventFilter(watched, event);
}

void ToleranceBands::outdate(bool isOther) {
    if (page_->model()->study().empty() || !ToleranceSwitch::instance().isOn()) {
        clear();
        if (page_->model()->study().empty()) {
            twin_.reset();
        }
        return;
    }
    if (isOther) {
        isOther_ = true;
        setStale();
    }
    if (page_->isVisible()) {
        outdated_ = true;
        later_.start();
    }
}

void ToleranceBands::clear() {
    later_.stop();
    run_.reset();
    outdated_ = false;
    if (std::exchange(isClear_, true)) {
        return;
    }
    for (PlotView* plot : page_->findChildren<PlotView*>()) {
        for (int curve = 0; curve < plot->curveCount(); ++curve) {
            plot->setSpread(curve, {}, {});
        }
    }
    for (ResultTable* table : page_->findChildren<ResultTable*>()) {
        table->setSpreads({});
    }
}

void ToleranceBands::setStale() {
    for (PlotView* plot : page_->findChildren<PlotView*>()) {
        plot->setSpreadStale(true);
    }
}

void ToleranceBands::step() {
    if (!page_->isVisible()) {
        run_.reset();
        return;  // until it is seen again
    }
    if (run_ == nullptr || !run_->isWhole()) {
        outdated_ = false;
        isOther_ = false;
        run_ = begin();
        if (run_ == nullptr) {
            clear();
            return;
        }
    } else if (run_->next < 2 * run_->sources.size()) {
        const std::size_t source = run_->next / 2;
        const bool isUp = run_->next % 2 == 0;
        auto found = solved(*run_, source, isUp ? 1.0 : -1.0);
        if (isUp) {
            run_->plus = std::move(found);
        } else {
            run_->add(run_->plus, found, run_->sources[source]);
        }
        ++run_->next;
    }
    if (run_->next == 2 * run_->sources.size()) {
        finish(*run_);
        run_.reset();
    }
    if (run_ != nullptr || outdated_) {
        later_.start();
    }
}

std::unique_ptr<ToleranceBands::Run> ToleranceBands::begin() {
    SceneModel& model = *page_->model();
    auto run = std::make_unique<Run>();
    try {
        const studies::Study study = studies::read_study(Json::parse(model.study()), true);
        run->input = model.caseFile().input;
        for (const studies::Varied& varied : study.vary) {
            const Json::json_pointer place(varied.pointer);
            if (varied.spread == studies::Varied::Spread::grid || !run->input.contains(place) ||
                !run->input.at(place).is_number()) {
                continue;
            }
            const double nominal = run->input.at(place).get<double>();
            const studies::Law law = studies::law_of(varied, nominal);
            if (law.deviation > 0.0) {
                run->sources.push_back({place, law.mean, law.deviation, law.mean == nominal});
            }
        }
        if (run->sources.empty()) {
            return nullptr;
        }
        if (twin_ == nullptr) {
            for (const SceneInfo& info : sceneList()) {
                if (info.name == model.sceneName()) {
                    twin_.reset(info.make(nullptr, nullptr));
                }
            }
            twin_->model()->history()->setUndoLimit(1);
        }
        twin_->model()->loadCase(run->input, model.context(), model.title());
    } catch (const InputError&) {
        return nullptr;
    }
    run->plots = seen<PlotView>(*page_, *twin_);
    run->tables = seen<ResultTable>(*page_, *twin_);
    const auto show = [&](QWidget* part) {
        showTabOf(part);
        for (QWidget* around = part->parentWidget(); around != nullptr && around != twin_.get();
             around = around->parentWidget()) {
            if (QByteArray(around->metaObject()->className()).startsWith("ravnoves::")) {
                run->shown.insert(around);
            }
        }
    };
    for (const auto& [plot, twin] : run->plots) {
        show(twin);
    }
    for (const auto& [table, twin] : run->tables) {
        show(twin);
    }
    if (!solved(*run, 0, 0.0)) {
        return nullptr;
    }
    run->begin();
    return run;
}

std::optional<ToleranceBands::Snapshot> ToleranceBands::solved(const Run& run, std::size_t input,
                                                               double by) {
    const AllDigits digits;
    SceneModel& model = *twin_->model();
    try {
        Json changed = run.input;
        if (by != 0.0) {
            const Run::Source& source = run.sources[input];
            changed[source.place] = source.mean + by * source.deviation;
        }
        model.loadInput(changed, page_->model()->context());
    } catch (const InputError&) {
        return std::nullopt;
    }
    model.takeView(*page_->model());
    for (QWidget* part : run.shown) {
        QShowEvent shown;
        QCoreApplication::sendEvent(part, &shown);
    }
    for (BackgroundJob* job : twin_->findChildren<BackgroundJob*>()) {
        job->cancel();
    }
    return run.snapshot();
}

void ToleranceBands::finish(const Run& run) {
    isClear_ = false;
    for (std::size_t p = 0; p < run.plots.size(); ++p) {
        PlotView& plot = *run.plots[p].first;
        plot.setSpreadStale(isOther_);
        const std::size_t count =
            std::min(run.curveSums[p].size(), static_cast<std::size_t>(plot.curveCount()));
        for (std::size_t c = 0; c < count; ++c) {
            std::vector<double> below;
            std::vector<double> above;
            double largest = 0.0;
            for (const Run::Sum& sum : run.curveSums[p][c]) {
                below.push_back(sum.half() - sum.shift);
                above.push_back(sum.half() + sum.shift);
                largest = std::max(largest, sum.half());
            }
            double size = 0.0;
            for (const double value : run.nominal.curves[p][c]) {
                size = std::max(size, std::abs(value));
            }
            constexpr double rounding = 1e-11;
            const PlotCurve& curve = run.plots[p].second->data().curves[c];
            // A line that goes up and down, or to and fro, has no width along y.
            const bool isOverX =
                curve.ascending && !curve.x.empty() && curve.x.back() > curve.x.front();
            const bool hasBand = largest > rounding * size && (isOverX || !curve.isLine());
            plot.setSpread(static_cast<int>(c), hasBand ? below : std::vector<double>(),
                           hasBand ? above : std::vector<double>());
        }
    }
    for (std::size_t t = 0; t < run.tables.size(); ++t) {
        ResultTable& table = *run.tables[t].first;
        const int columns = run.tables[t].second->columnCount();
        std::vector<ResultTable::Spread> spreads;
        double size = 0.0;
        for (const double value : run.nominal.cells[t]) {
            size = std::isfinite(value) ? std::max(size, std::abs(value)) : size;
        }
        for (std::size_t i = 0; i < run.cellSums[t].size(); ++i) {
            const int row = static_cast<int>(i) / columns;
            const double half = run.cellSums[t][i].half();
            constexpr double rounding = 1e-11;
            const QTableWidgetItem* name = table.item(row, 0);
            // What is left of two that cancel is rounding, too.
            constexpr double cancelled = 1e-14;
            if (name != nullptr && half > rounding * std::abs(run.nominal.cells[t][i]) &&
                half > cancelled * size) {
                spreads.push_back({row, static_cast<int>(i) % columns, name->text(), half});
            }
        }
        table.setSpreads(std::move(spreads));
    }
}

}  // namespace ravnoves
