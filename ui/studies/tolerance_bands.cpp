#include "studies/tolerance_bands.h"

#include <QApplication>
#include <QEvent>
#include <QSettings>
#include <QTabWidget>
#include <QThread>

#include "case-file/case_file.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "model/background_job.h"
#include "page/part_views.h"
#include "page/scene_page.h"
#include "scenes/scenes.h"
#include "studies/model/part_numbers.h"
#include "studies/model/study_model.h"
#include "studies/study_run.h"
#include "text/preferences.h"

namespace ravnoves {

namespace {

constexpr int handRestsMs = 250;
const QString shownKey = QStringLiteral("tolerances/shown");

}  // namespace

ToleranceBands::ToleranceBands(ScenePage* page)
    : QObject(page), page_(page), job_(new BackgroundJob(this)) {
    page->addBusy([this] { return isBusy(); });
    rest_.setSingleShot(true);
    rest_.setInterval(handRestsMs);
    connect(&rest_, &QTimer::timeout, this, &ToleranceBands::begin);
    const SceneModel* model = page->model();
    // A title, or a variant that is kept, is another case but no other result.
    for (const auto signal : {&SceneModel::changed, &SceneModel::historyChanged}) {
        connect(model, signal, this, [this, model] {
            if (std::exchange(solutions_, model->solutions()) != model->solutions()) {
                outdate();
            }
        });
    }
    connect(model, &SceneModel::viewChanged, this, &ToleranceBands::outdate);
    connect(model, &SceneModel::studyChanged, this, [this] {
        if (studies::Study now = readStudy(); now != study_) {
            study_ = std::move(now);
            outdate();
        }
    });
    for (const QTabWidget* tabs : page->findChildren<QTabWidget*>()) {
        connect(tabs, &QTabWidget::currentChanged, this, &ToleranceBands::beginLater);
    }
    // The parts of a sample are written as the user wants them; the page is made again then.
    connect(&Preferences::instance(), &Preferences::aboutToChange, job_, &BackgroundJob::stop);
    connect(job_, &BackgroundJob::failed, this, [this] { clear(false); });
    study_ = readStudy();
    page->installEventFilter(this);
}

ToleranceBands::~ToleranceBands() {
    delete job_;  // before what its work asks for
}

bool ToleranceBands::areShown() {
    return QSettings().value(shownKey, true).toBool();
}

void ToleranceBands::setShown(bool shown) {
    QSettings().setValue(shownKey, shown);
    for (const QWidget* window : QApplication::topLevelWidgets()) {
        for (ToleranceBands* bands : window->findChildren<ToleranceBands*>()) {
            bands->outdate();
        }
    }
}

bool ToleranceBands::isBusy() const {
    return rest_.isActive() || job_->isRunning();
}

void ToleranceBands::findAll() {
    isOfAll_ = true;
    begin();
}

bool ToleranceBands::eventFilter(QObject* watched, QEvent* event) {
    if (watched == page_ && event->type() == QEvent::Show) {
        isOfAll_ = false;
        beginLater();
    }
    return QObject::eventFilter(watched, event);
}

bool ToleranceBands::isWanted() const {
    // Of a trace the dead centre is uncertain by itself.
    return (!study_.vary.empty() || !page_->model()->fields(open_input).empty()) &&
           study_.method != studies::Method::grid && areShown();
}

studies::Study ToleranceBands::readStudy() const {
    studies::Study study;
    try {
        if (!page_->model()->study().empty()) {
            study = readStudyText(page_->model()->study());
        }
    } catch (const InputError&) {
        return {};  // the window of the tolerances says why
    }
    study.watch.clear();
    study.samples = {};
    return study;
}

void ToleranceBands::outdate() {
    isOfAll_ = false;
    job_->cancel();
    if (!spreads_.empty() || (isAwaited_ && !isWanted())) {
        clear(isWanted());
    }
    if (!isWanted()) {
        rest_.stop();
    }
    beginLater();
}

void ToleranceBands::beginLater() {
    if (!isOfAll_ && isWanted() && page_->isVisible()) {
        job_->cancel();
        rest_.start();
    }
}

void ToleranceBands::clear(bool othersFollow) {
    spreads_.clear();
    isAwaited_ = othersFollow;
    for (PartView* view : PartView::below(*page_, false)) {
        view->clearSpread(othersFollow);
    }
}

void ToleranceBands::begin() {
    rest_.stop();
    if (!isWanted() || !page_->isVisible()) {
        isOfAll_ = false;
        return;
    }
    const SceneModel& model = *page_->model();
    CaseFile file = model.caseFile();  // with defaults
    std::vector<std::string_view> ids;
    if (isOfAll_) {
        for (const PagePart& part : model.parts()) {
            ids.push_back(part.id);
        }
    } else {
        for (const PartView* view : PartView::below(*page_, true)) {
            ids.push_back(view->id());
        }
    }
    auto sample = std::shared_ptr<SceneModel>(model.another(false));
    sample->history()->setUndoLimit(1);
    try {
        sample->loadCase(model.inputJson(), model.context(), model.title());
    } catch (const InputError&) {
        clear(false);  // its file is gone
        return;
    }
    sample->takeView(model);
    sample->moveToThread(nullptr);
    auto numbers = std::make_shared<PartNumbers>(model, ids);
    job_->start([this, file = std::move(file), context = model.context(), study = study_, numbers,
                 sample = std::move(sample)](
                    const BackgroundJob::Progress& progress) mutable -> std::function<void()> {
        const std::shared_ptr<SceneModel> own = std::move(sample);
        own->moveToThread(QThread::currentThread());
        Json& input = file.input;
        std::vector<Json::json_pointer> places;
        std::vector<studies::Law> laws;
        for (const studies::Varied& varied : study.vary) {
            const Json::json_pointer place(varied.pointer);
            if (!input.contains(place) || !input.at(place).is_number()) {
                continue;  // the case has it no more
            }
            const studies::Law law = studies::law_of(varied, input.at(place).get<double>());
            if (law.deviation > 0.0) {
                places.push_back(place);
                laws.push_back(law);
            }
        }
        const bool isTyped = !laws.empty();
        const auto phase = studies::open_input(file, context, study.vary);
        if (phase) {
            places.emplace_back(phase->pointer);
            laws.push_back(studies::law_of(*phase, 0.0));
        }
        if (laws.empty()) {
            return [this] { clear(false); };
        }
        const auto samples = samplesOf(laws, study.method, study.seed);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (!progress(static_cast<double>(i) / static_cast<double>(samples.size()))) {
                return {};
            }
            for (std::size_t j = 0; j < places.size(); ++j) {
                input[places[j]] = samples[i][j];
            }
            try {
                own->showInput(input);
            } catch (const InputError&) {
                continue;  // it has no numbers
            }
            numbers->add(*own);
        }
        QString how = (isTyped ? tr("Half of the range from 5 % to 95 % of %1 samples of the "
                                    "tolerances; both sides where they differ.")
                               : tr("Half of the range from 5 % to 95 % of %1 samples of the "
                                    "uncertain dead centre of the trace; both sides where they "
                                    "differ."))
                          .arg(numbers->samples());
        if (phase && isTyped) {
            how += QLatin1Char(' ') + tr("Includes the uncertain dead centre of the trace.");
        }
        return [this, solved = numbers->samples(), spreads = numbers->spreads(how)] {
            if (solved == 0) {
                clear(false);  // no sample can be solved
                return;
            }
            spreads_ = spreads;
            for (PartView* view : PartView::below(*page_, false)) {
                if (const PartSpread* spread = spreadOf(view->id())) {
                    view->make();  // seen or not
                    view->showSpread(*spread);
                }
            }
        };
    });
}

const PartSpread* ToleranceBands::spreadOf(std::string_view part) const {
    const auto found = spreads_.find(part);
    return found != spreads_.end() ? &found->second : nullptr;
}

}  // namespace ravnoves
