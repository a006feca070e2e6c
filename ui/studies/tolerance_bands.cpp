#include "studies/tolerance_bands.h"

#include <QEvent>
#include <QPointer>
#include <QTabWidget>
#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <mutex>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/background_job.h"
#include "model/input_differences.h"
#include "plot/plot_view.h"
#include "shell/scene_list.h"
#include "shell/scene_page.h"
#include "studies/band_run.h"
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

bool isEmpty(const PlotView& plot) {
    const auto& curves = plot.data().curves;
    return std::all_of(curves.begin(), curves.end(),
                       [](const PlotCurve& curve) { return curve.x.empty(); });
}

bool isEmpty(const ResultTable& table) {
    return table.rowCount() == 0;
}

/// Those of the page that are seen, or all of them, with their counterparts.
template <typename Part>
std::vector<std::pair<QPointer<Part>, QPointer<Part>>> seen(const ScenePage& page,
                                                            const ScenePage& twin, bool orNot) {
    const QList<Part*> parts = inOrder<Part>(page);
    const QList<Part*> others = inOrder<Part>(twin);
    std::vector<std::pair<QPointer<Part>, QPointer<Part>>> pairs;
    for (qsizetype i = 0; i < std::min(parts.size(), others.size()); ++i) {
        if (parts[i]->isVisible() || (orNot && !isEmpty(*parts[i]))) {
            pairs.emplace_back(parts[i], others[i]);
        }
    }
    return pairs;
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

ToleranceBands::ToleranceBands(ScenePage* page)
    : QObject(page), page_(page), job_(new BackgroundJob(this)) {
    later_.setSingleShot(true);
    connect(&later_, &QTimer::timeout, this, &ToleranceBands::step);
    rest_.setSingleShot(true);
    rest_.setInterval(handRestsMs);
    connect(&rest_, &QTimer::timeout, this, &ToleranceBands::beginSamples);
    const SceneModel* model = page->model();
    connect(model, &SceneModel::changed, this, [this, model] {
        // A title, or a variant that is kept, is another case but no other result.
        const bool isSolved = std::exchange(solutions_, model->solutions()) != model->solutions();
        if (isAnother() || isSolved || outdated_) {
            outdate(true);
        }
    });
    connect(model, &SceneModel::viewChanged, this, [this] { outdate(true); });
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

void ToleranceBands::setOfAll(bool ofAll) {
    isOfAll_ = ofAll;
    if (ofAll) {
        outdate(false);
    }
}

void ToleranceBands::hold(bool held) {
    isHeld_ = held;
    if (held) {
        isInterrupted_ = isInterrupted_ || isBusy();
        later_.stop();
        rest_.stop();
        job_->cancel();
        run_.reset();
    } else if (std::exchange(isInterrupted_, false)) {
        outdate(true);
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
    if (isHeld_) {
        return;
    }
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
                const auto solutions = 2 * static_cast<qint64>(run_->sources.size());
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

std::unique_ptr<BandRun> ToleranceBands::begin() {
    SceneModel& model = *page_->model();
    auto run = std::make_unique<BandRun>();
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
    run->plots = seen<PlotView>(*page_, *twin_, isOfAll_);
    run->tables = seen<ResultTable>(*page_, *twin_, isOfAll_);
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

bool ToleranceBands::load(const BandRun& run, std::size_t input, double by) {
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

void ToleranceBands::fill(const BandRun& run) {
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
    BandRun::Shown shown = run_->slopes();
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
    auto slow = std::make_unique<BandRun>();
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
    BandRun::Shown shown = run_->slopes();
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
