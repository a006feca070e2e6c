#include "page/scene_page.h"

#include <QGuiApplication>
#include <QTabWidget>
#include <QTimer>
#include <algorithm>

#include "model/background_job.h"
#include "model/reference_case.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "pictures/wheel_guard.h"
#include "plot/plot_view.h"
#include "widgets/mnemonics.h"

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
    connect(&model->referenceCase(), &ReferenceCase::said, this, &ScenePage::status);
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

QString ScenePage::resultsAsText() const {
    return answerOf(*this, false);
}

QString ScenePage::resultsAsCsv() const {
    return answerOf(*this, true);
}

void ScenePage::setActive(bool active) {
    if (!active) {
        for (MechanismPicture* picture : findChildren<MechanismPicture*>()) {
            picture->setPlaying(false);
        }
    }
}

bool ScenePage::event(QEvent* event) {
    if (event->type() == QEvent::Polish) {
        separateMnemonics(this);
    }
    return QWidget::event(event);
}

SceneModel* ScenePage::letGo() {
    setActive(false);
    if (QWidget* field = focusWidget()) {
        field->clearFocus();
    }
    if (model()->isEditing()) {
        model()->endEditing();
    }
    model()->setParent(nullptr);
    return model();
}

QStringList ScenePage::shownTabs() const {
    QStringList names;
    for (const QTabWidget* tabs : findChildren<QTabWidget*>()) {
        names << tabs->currentWidget()->objectName();
    }
    return names;
}

void ScenePage::showTabs(const QStringList& names) {
    for (QTabWidget* tabs : findChildren<QTabWidget*>()) {
        for (int i = 0; i < tabs->count(); ++i) {
            const QString name = tabs->widget(i)->objectName();
            if (!name.isEmpty() && names.contains(name)) {
                tabs->setCurrentIndex(i);
            }
        }
    }
}

void ScenePage::resetZoom() {
    resetAllZoom(this);
}

bool ScenePage::isBusy() const {
    if (std::any_of(busy_.begin(), busy_.end(), [](const auto& each) { return each(); })) {
        return true;
    }
    const auto works = [](const QObject& owner) {
        const auto jobs = owner.findChildren<BackgroundJob*>();
        return std::any_of(jobs.begin(), jobs.end(),
                           [](const BackgroundJob* job) { return job->isRunning(); });
    };
    const auto* reference = findChild<ReferenceCase*>();
    return works(*this) ||
           (reference != nullptr && reference->model() != nullptr && works(*reference->model()));
}

}  // namespace ravnoves
