#include "shell/scene_page.h"

#include <QGuiApplication>
#include <QTabWidget>
#include <QTimer>
#include <algorithm>

#include "model/background_job.h"
#include "plot/plot_view.h"
#include "shell/comparison.h"
#include "studies/tolerance_bands.h"
#include "widgets/mechanism_picture.h"
#include "widgets/mnemonics.h"
#include "widgets/wheel_guard.h"

namespace ravnoves {

ScenePage::ScenePage(QWidget* parent) : QWidget(parent) {
    guardWheel();
}

ScenePage::~ScenePage() {
    // A window that is destroyed takes the focus from its field, which would report to what is
    // already gone of the page.
    for (QObject* each : findChildren<QObject*>()) {
        each->blockSignals(true);
    }
}

void ScenePage::followDrags(SceneModel* model) {
    // Keys end no drag: they pause.
    constexpr int pauseMs = 400;
    auto* pause = new QTimer(this);
    pause->setSingleShot(true);
    pause->setInterval(pauseMs);
    connect(pause, &QTimer::timeout, model, [model, pause] {
        QGuiApplication::mouseButtons() == Qt::NoButton ? model->rest() : pause->start();
    });
    connect(model, &SceneModel::changed, this, [model, pause] {
        PlotView::setSteady(model->isMoved());
        if (model->isMoved()) {
            pause->start();
        }
    });
    connect(model, &SceneModel::rested, this, [this] {
        PlotView::setSteady(false);
        for (PlotView* plot : findChildren<PlotView*>()) {
            plot->fitAxes();
        }
    });
}

void ScenePage::setActive(bool active) {
    if (!active) {
        for (MechanismPicture* picture : findChildren<MechanismPicture*>()) {
            picture->setPlaying(false);
        }
    }
}

const QList<QTabWidget*>& ScenePage::tabWidgets() {
    if (tabWidgets_.isEmpty()) {
        tabWidgets_ = findChildren<QTabWidget*>();
    }
    return tabWidgets_;
}

bool ScenePage::event(QEvent* event) {
    if (event->type() == QEvent::Polish) {
        tabWidgets();
        separateMnemonics(this);
    }
    return QWidget::event(event);
}

ScenePage::Left ScenePage::giveWay() {
    Left left{model(), {}, {}};
    for (const MechanismPicture* picture : findChildren<MechanismPicture*>()) {
        left.playing.push_back(picture->isPlaying());
    }
    setActive(false);
    if (QWidget* field = focusWidget()) {
        field->clearFocus();
    }
    if (model()->isEditing()) {
        model()->endEditing();
    }
    for (const QTabWidget* tabs : tabWidgets()) {
        left.tabs.push_back(tabs->currentIndex());
    }
    left.model->setParent(nullptr);
    return left;
}

void ScenePage::resume(const Left& left) {
    const auto& tabs = tabWidgets();
    const auto count = std::min(tabs.size(), static_cast<qsizetype>(left.tabs.size()));
    for (qsizetype i = 0; i < count; ++i) {
        tabs[i]->setCurrentIndex(left.tabs[static_cast<std::size_t>(i)]);
    }
    const auto pictures = findChildren<MechanismPicture*>();
    const auto shown = std::min(pictures.size(), static_cast<qsizetype>(left.playing.size()));
    for (qsizetype i = 0; i < shown; ++i) {
        pictures[i]->setPlaying(left.playing[static_cast<std::size_t>(i)]);
    }
}

void ScenePage::resetZoom() {
    resetAllZoom(this);
}

bool ScenePage::isBusy() const {
    const auto* bands = findChild<ToleranceBands*>(QString(), Qt::FindDirectChildrenOnly);
    if (bands != nullptr && bands->isBusy()) {
        return true;
    }
    const auto* comparison = findChild<Comparison*>(QString(), Qt::FindDirectChildrenOnly);
    if (comparison != nullptr && comparison->twin() != nullptr && comparison->twin()->isBusy()) {
        return true;
    }
    const auto jobs = findChildren<BackgroundJob*>();
    return std::any_of(jobs.begin(), jobs.end(),
                       [](const BackgroundJob* job) { return job->isRunning(); });
}

}  // namespace ravnoves
