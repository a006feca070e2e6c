#include "studies/tolerance_bands.h"

#include <QElapsedTimer>
#include <QEvent>
#include <QPointer>
#include <QTabWidget>
#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/background_job.h"
#include "model/input_differences.h"
#include "plot/legend_item.h"
#include "plot/plot_view.h"
#include "shell/scene_list.h"
#include "shell/scene_page.h"
#include "studies/law.h"
#include "studies/model/band_samples.h"
#include "studies/model/result_words.h"
#include "studies/study.h"
#include "studies/tolerance_switch.h"
#include "text/capital.h"
#include "text/message_text.h"
#include "widgets/page_columns.h"
#include "widgets/result_table.h"

namespace ravnoves {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// 95 % point of the normal distribution.
constexpr double point95 = 1.6448536269514722;
constexpr int handRestsMs = 250;
constexpr int lookAgainMs = 20;

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
double moved(double nominal, double plus, double minus, double period) {
    const auto apart = [&](double from, double to) {
        return period > 0.0 ? std::remainder(to - from, period) : to - from;
    };
    if (std::isfinite(plus) && std::isfinite(minus)) {
        return 0.5 * apart(minus, plus);
    }
    return std::isfinite(plus) ? apart(nominal, plus) : apart(minus, nominal);
}

bool isEmpty(const PlotView& plot) {
    const auto& curves = plot.data().curves;
    return std::all_of(curves.begin(), curves.end(),
                       [](const PlotCurve& curve) { return curve.x.empty(); });
}

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

/// Numbers that the worker waits for.
class AwaitedNumbers {
  public:
    using Numbers = std::optional<std::vector<double>>;
    void give(Numbers numbers) {
        const std::lock_guard lock(guard_);
        numbers_ = std::move(numbers);
        isThere_ = true;
        there_.notify_one();
    }
    Numbers wait(const std::function<bool()>& goesOn) {
        std::unique_lock lock(guard_);
        while (!isThere_) {
            there_.wait_for(lock, std::chrono::milliseconds(10));
            if (!isThere_ && !goesOn()) {
                return std::nullopt;
            }
        }
        return std::move(numbers_);
    }

  private:
    std::mutex guard_;
    std::condition_variable there_;
    Numbers numbers_;
    bool isThere_ = false;
};

}  // namespace

/// One input after the other.
struct ToleranceBands::Run {
    /// Numbers that stand together.
    struct Stretch {
        std::size_t from = 0;
        std::size_t count = 0;
    };

    Json input;
    studies::Study study;
    std::vector<BandTask::Source> sources;
    std::vector<std::pair<QPointer<PlotView>, QPointer<PlotView>>> plots;  ///< page's and twin's
    std::vector<std::pair<QPointer<ResultTable>, QPointer<ResultTable>>> tables;
    /// Plots of what the twin computes in the background.
    std::vector<std::pair<QPointer<PlotView>, QPointer<PlotView>>> slow;
    QList<QWidget*> shown;  ///< the plots and tables of the twin

    std::vector<std::vector<std::vector<double>>> x;  ///< by plot and curve
    std::vector<std::vector<Stretch>> curves;         ///< likewise
    std::vector<Stretch> cells;                       ///< by table, row by row
    std::vector<double> periods;                      ///< of numbers that are angles; else 0
    std::vector<double> nominal;
    std::vector<double> variance;
    std::vector<double> shift;  ///< of the mean

    bool isLaidOut = false;
    bool waits = false;     ///< for what the twin computes in the background
    bool isLoaded = false;  ///< it computes
    QElapsedTimer clock;
    std::size_t next = 0;  ///< solution: up and down for each source
    std::optional<std::vector<double>> plus;

    bool isWhole() const {
        return std::all_of(plots.begin(), plots.end(),
                           [](const auto& each) { return each.first && each.second; }) &&
               std::all_of(tables.begin(), tables.end(),
                           [](const auto& each) { return each.first && each.second; });
    }
    bool isDone() const { return isLaidOut && next == 2 * sources.size(); }
    std::size_t source() const { return next / 2; }
    bool isUp() const { return next % 2 == 0; }

    /// Of the twin as it stands. @param found  its numbers, as many as the nominal ones
    std::vector<double> numbers() const {
        std::vector<double> found;
        found.reserve(nominal.size());
        for (std::size_t p = 0; p < plots.size(); ++p) {
            const PlotData& data = plots[p].second->data();
            for (std::size_t c = 0; c < curves[p].size(); ++c) {
                const std::vector<double> values = c < data.curves.size()
                                                       ? at(x[p][c], data, data.curves[c])
                                                       : std::vector<double>();
                append(found, values, curves[p][c].count);
            }
        }
        for (std::size_t t = 0; t < tables.size(); ++t) {
            append(found, cellsOf(*tables[t].second), cells[t].count);
        }
        return found;
    }
    /// Other numbers than there were: of other rows, or a curve that does not go on there.
    static void append(std::vector<double>& all, const std::vector<double>& values,
                       std::size_t count) {
        if (values.size() == count) {
            all.insert(all.end(), values.begin(), values.end());
        } else {
            all.resize(all.size() + count, none);
        }
    }
    static std::vector<double> cellsOf(const ResultTable& table) {
        std::vector<double> found;
        for (int row = 0; row < table.rowCount(); ++row) {
            for (int column = 0; column < table.columnCount(); ++column) {
                const ResultNumber* number = table.numberAt(row, column);
                found.push_back(number != nullptr ? number->value : none);
            }
        }
        return found;
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
    /// The twin shows what is nominal.
    void layOut() {
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
    /// One side of a source, or nothing where it is refused there.
    void take(std::optional<std::vector<double>> found) {
        if (isUp()) {
            plus = std::move(found);
        } else {
            add(plus, found, sources[source()]);
        }
        ++next;
    }
    void add(const std::optional<std::vector<double>>& up,
             const std::optional<std::vector<double>>& down, BandTask::Source& from) {
        const bool isCentred = from.law.mean == input.at(from.place).get<double>();
        for (std::size_t i = 0; i < nominal.size(); ++i) {
            const double above = up ? (*up)[i] : none;
            const double under = down ? (*down)[i] : none;
            const double by = moved(nominal[i], above, under, periods[i]);
            if (!std::isfinite(by)) {
                continue;
            }
            variance[i] += by * by;
            from.slopes[i] = static_cast<float>(by);
            if (!isCentred && std::isfinite(above) && std::isfinite(under)) {
                shift[i] += 0.5 * (above + under) - nominal[i];
            }
        }
    }
    /// Curves first, then the cells that hold a number.
    std::vector<BandTask::Group> groups() const {
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

    /// Bands and ± of the page.
    struct Shown {
        std::vector<double> below;
        std::vector<double> above;
        std::vector<std::pair<BandTask::Group, QString>> fails;
        QString howCurves;
        QString howNumbers;
        bool isStale = false;
    };
    Shown slopes() const {
        Shown found;
        for (std::size_t i = 0; i < nominal.size(); ++i) {
            const double half = point95 * std::sqrt(variance[i]);
            found.below.push_back(half - shift[i]);
            found.above.push_back(half + shift[i]);
        }
        found.howCurves = ToleranceBands::tr(
            "Where the tolerances let the curves lie: ± 1.645 σ, by slopes; 5 % below the band and "
            "5 % above it where the results go straight with the inputs");
        found.howNumbers = ToleranceBands::tr(
            "What the tolerances make of it: 1.645 σ, by slopes, half of the range from 5 % to 95 "
            "% where it goes straight with the inputs");
        return found;
    }
    void show(const Shown& shown) const {
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

  private:
    static constexpr double rounding = 1e-11;

    void showPlot(std::size_t p, const Shown& shown,
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
            const auto [from, size] = curves[p][c];
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
        sayOfBands(plot, !why.isEmpty(),
                   (QStringList{shown.howCurves} + why).join(QLatin1Char('\n')));
    }

    void showTable(std::size_t t, const Shown& shown,
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
            if (name != nullptr && half > rounding * std::abs(nominal[at]) &&
                half > cancelled * size) {
                const auto why = fails.find(at);
                spreads.push_back({row, static_cast<int>(i) % columns, name->text(),
                                   shown.below[at], shown.above[at],
                                   why != fails.end() ? why->second : QString()});
            }
        }
        table.setSpreads(std::move(spreads), shown.howNumbers);
    }
};

ToleranceBands::ToleranceBands(ScenePage* page)
    : QObject(page), page_(page), job_(new BackgroundJob(this)) {
    later_.setSingleShot(true);
    connect(&later_, &QTimer::timeout, this, &ToleranceBands::step);
    rest_.setSingleShot(true);
    rest_.setInterval(handRestsMs);
    connect(&rest_, &QTimer::timeout, this, &ToleranceBands::beginSamples);
    const SceneModel* model = page->model();
    for (const auto signal : {&SceneModel::changed, &SceneModel::viewChanged}) {
        connect(model, signal, this, [this] { outdate(true); });
    }
    for (const auto signal : {&SceneModel::historyChanged, &SceneModel::studyChanged}) {
        connect(model, signal, this, [this] {
            if (isAnother()) {
                outdate(true);
            }
        });
    }
    for (const QTabWidget* tabs : page->findChildren<QTabWidget*>()) {
        connect(tabs, &QTabWidget::currentChanged, this, [this] { outdate(false); });
    }
    connect(&ToleranceSwitch::instance(), &ToleranceSwitch::changed, this,
            [this] { outdate(true); });
    page->installEventFilter(this);
}

ToleranceBands::~ToleranceBands() {
    delete job_;  // before what its work asks for
}

bool ToleranceBands::isBusy() const {
    return later_.isActive() || rest_.isActive() || job_->isRunning();
}

void ToleranceBands::stop(const QString& why) {
    later_.stop();
    rest_.stop();
    job_->cancel();
    run_.reset();
    for (ResultTable* table : page_->findChildren<ResultTable*>()) {
        table->stopSpreads(why);
    }
}

bool ToleranceBands::eventFilter(QObject* watched, QEvent* event) {
    if (watched == page_ && event->type() == QEvent::Show) {
        outdate(false);
    }
    return QObject::eventFilter(watched, event);
}

bool ToleranceBands::isAnother() {
    const SceneModel& model = *page_->model();
    std::string now;
    if (!model.study().empty() && ToleranceSwitch::instance().isOn()) {
        Json study = Json::parse(model.study(), nullptr, false);
        if (study.is_object()) {
            study.erase("watch");  // what is watched, and its limits, has no band
        }
        now = study.dump() + model.inputJson().dump() + model.keptJson().dump();
    }
    const bool isSame = !now.empty() && now == seen_;
    seen_ = std::move(now);
    return !isSame;
}

void ToleranceBands::outdate(bool isOther) {
    ++number_;
    rest_.stop();
    job_->cancel();
    if (run_ != nullptr && (run_->isDone() || run_->waits)) {
        run_.reset();
    }
    if (page_->model()->study().empty() || !ToleranceSwitch::instance().isOn() || isTooLarge()) {
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
        later_.start(0);
    }
}

SceneModel* ToleranceBands::model() const {
    return page_->model();
}

bool ToleranceBands::isTooLarge() const {
    return !model()->study().empty() && ToleranceSwitch::instance().isOn() && model()->isLarge();
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
    if (page_->model()->isWaiting()) {
        return;  // what is waited for outdates this
    }
    if (run_ == nullptr || !run_->isWhole()) {
        outdated_ = false;
        isOther_ = false;
        run_ = begin();
        if (run_ == nullptr) {
            clear();
            return;
        }
    } else if (run_->waits) {
        if (!run_->isLoaded) {
            const bool there = run_->isLaidOut
                                   ? load(*run_, run_->source(), run_->isUp() ? 1.0 : -1.0)
                                   : load(*run_, 0, 0.0);
            if (there) {
                fill(*run_);
                run_->isLoaded = true;
            } else if (run_->isLaidOut) {
                run_->take(std::nullopt);
            } else {
                run_.reset();
                return;
            }
        } else if (!twin_->isBusy()) {
            run_->isLoaded = false;
            if (!run_->isLaidOut) {
                run_->layOut();
                // What takes longer than anyone waits is left.
                constexpr qint64 mostMs = 60'000;
                const auto solutions = static_cast<qint64>(2 * run_->sources.size());
                if (run_->clock.elapsed() * solutions > mostMs) {
                    run_.reset();
                    return;
                }
            } else {
                run_->take(run_->numbers());
            }
        }
    } else {
        if (load(*run_, run_->source(), run_->isUp() ? 1.0 : -1.0)) {
            fill(*run_);
            run_->take(run_->numbers());
        } else {
            run_->take(std::nullopt);
        }
        cancelTwin();
    }
    if (!run_->isDone()) {
        later_.start(run_->waits ? lookAgainMs : 0);
        return;
    }
    finishSlopes();
    if (run_->waits || outdated_) {
        run_.reset();
    }
    if (outdated_) {
        later_.start(0);
    } else if (run_ != nullptr) {
        rest_.start();
    }
}

std::unique_ptr<ToleranceBands::Run> ToleranceBands::begin() {
    SceneModel& model = *page_->model();
    auto run = std::make_unique<Run>();
    try {
        run->study = studies::read_study(Json::parse(model.study()), true);
        run->input = model.caseFile().input;
        const std::vector<InputNumber> named = inputNumbers(model);
        for (std::size_t j = 0; j < run->study.vary.size(); ++j) {
            const studies::Varied& varied = run->study.vary[j];
            const Json::json_pointer place(varied.pointer);
            if (varied.spread == studies::Varied::Spread::grid || !run->input.contains(place) ||
                !run->input.at(place).is_number()) {
                continue;
            }
            const auto number =
                std::find_if(named.begin(), named.end(), [&](const InputNumber& each) {
                    return each.pointer == varied.pointer && each.hasLabel;
                });
            const QString name =
                number != named.end() ? number->name : capitalised(resultName(varied.pointer).text);
            const studies::Law law = studies::law_of(varied, run->input.at(place).get<double>());
            if (law.deviation > 0.0) {
                run->sources.push_back(
                    {place, QStringLiteral("“%1”").arg(name).toStdString(), law, j, {}});
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
    for (const auto& [plot, twin] : run->plots) {
        run->shown.append(twin);
    }
    for (const auto& [table, twin] : run->tables) {
        run->shown.append(twin);
    }
    if (!load(*run, 0, 0.0)) {
        return nullptr;
    }
    fill(*run);
    for (const auto& [plot, twin] : run->plots) {
        if (twin->isFaded() || (isEmpty(*twin) && !isEmpty(*plot))) {
            run->slow.emplace_back(plot, twin);
        }
    }
    cancelTwin();
    run->layOut();
    return run;
}

bool ToleranceBands::load(const Run& run, std::size_t input, double by) {
    SceneModel& model = *twin_->model();
    try {
        Json changed = run.input;
        if (by != 0.0) {
            const BandTask::Source& source = run.sources[input];
            changed[source.place] = source.law.mean + by * source.law.deviation;
        }
        model.loadInput(changed, page_->model()->context());
    } catch (const InputError&) {
        return false;
    }
    return true;
}

void ToleranceBands::fill(const Run& run) {
    twin_->model()->takeView(*page_->model());
    fillUnseen(*twin_, run.shown);
}

void ToleranceBands::cancelTwin() {
    for (BackgroundJob* job : twin_->findChildren<BackgroundJob*>()) {
        job->cancel();
    }
}

void ToleranceBands::finishSlopes() {
    isClear_ = false;
    Run::Shown shown = run_->slopes();
    shown.isStale = isOther_;
    run_->show(shown);
}

void ToleranceBands::beginSamples() {
    if (run_ == nullptr || !run_->isDone() || !run_->isWhole() || !page_->isVisible()) {
        return;
    }
    const SceneModel::SolveApart solve = twin_->model()->solvesApart();
    if (!solve || run_->study.method == studies::Method::grid) {
        endSamples();
        return;
    }
    auto task = std::make_shared<BandTask>();
    task->input = run_->input;
    task->study = run_->study;
    task->sources = run_->sources;
    task->nominal = run_->nominal;
    task->shift.assign(run_->shift.begin(), run_->shift.end());
    task->periods = run_->periods;
    task->groups = run_->groups();
    job_->start([this, run = number_, task,
                 solve](const BackgroundJob::Progress& progress) -> std::function<void()> {
        double done = 0.0;
        const auto goesOn = [&] { return progress(done); };
        const BandValues values = [&](const Json& input) {
            std::function<void()> take = solve(input);
            auto awaited = std::make_shared<AwaitedNumbers>();
            job_->post(
                [this, run, take = std::move(take), awaited] { awaited->give(read(run, take)); });
            return awaited->wait(goesOn);
        };
        auto found = findBands(
            *task, values,
            [&](double part) {
                done = part;
                return goesOn();
            },
            [&](BandAnswer answer) {
                job_->post([this, run, answer = std::move(answer)] { showSamples(run, answer); });
            });
        if (!found) {
            return {};
        }
        return [this, run, answer = std::move(*found)] {
            showSamples(run, answer);
            endSamples();
        };
    });
}

void ToleranceBands::endSamples() {
    if (run_ == nullptr || run_->slow.empty()) {
        run_.reset();
        return;
    }
    auto slow = std::make_unique<Run>();
    slow->input = run_->input;
    slow->study = run_->study;
    slow->sources = run_->sources;
    slow->plots = run_->slow;
    slow->shown = run_->shown;
    slow->waits = true;
    slow->clock.start();
    run_ = std::move(slow);
    later_.start(0);
}

std::optional<std::vector<double>> ToleranceBands::read(int run,
                                                        const std::function<void()>& take) {
    if (run != number_ || run_ == nullptr || !run_->isWhole() || !page_->isVisible()) {
        return std::nullopt;
    }
    take();
    fill(*run_);
    cancelTwin();
    return run_->numbers();
}

void ToleranceBands::showSamples(int run, const BandAnswer& answer) {
    if (run != number_ || run_ == nullptr || !run_->isWhole()) {
        return;
    }
    if (answer.below.empty() && answer.fails.empty()) {
        return;  // slopes hold
    }
    Run::Shown shown = run_->slopes();
    if (!answer.below.empty()) {
        for (std::size_t i = 0; i < run_->nominal.size(); ++i) {
            if (std::isfinite(answer.below[i])) {
                shown.below[i] = answer.below[i];
                shown.above[i] = answer.above[i];
            }
        }
        const QString samples = QLocale().toString(static_cast<qulonglong>(answer.samples));
        shown.howCurves = tr("Where the tolerances let the curves lie: of %1 samples 5 % are below "
                             "the band and 5 % above it")
                              .arg(samples);
        shown.howNumbers =
            tr("What the tolerances make of it: the range from 5 % to 95 % of %1 samples")
                .arg(samples);
    }
    const std::vector<BandTask::Group> groups = run_->groups();
    for (const auto& [group, why] : answer.fails) {
        if (group < groups.size()) {
            shown.fails.emplace_back(groups[group], messageText(why));
        }
    }
    run_->show(shown);
}

}  // namespace ravnoves
