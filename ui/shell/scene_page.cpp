#include "shell/scene_page.h"

#include <algorithm>

#include "plot/plot_view.h"
#include "model/background_job.h"
#include "widgets/mechanism_picture.h"
#include "widgets/wheel_guard.h"

namespace ravnoves {

/// Every plot below a page shows all it has.
void resetAllZoom(QWidget* page) {
    for (PlotView* plot : page->findChildren<PlotView*>()) {
        plot->resetZoom();
    }
}

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

void ScenePage::setActive(bool active) {
    if (!active) {
        for (MechanismPicture* picture : findChildren<MechanismPicture*>()) {
            picture->setPlaying(false);
        }
    }
}

void ScenePage::resetZoom() {
    resetAllZoom(this);
}

bool ScenePage::isBusy() const {
    const auto jobs = findChildren<BackgroundJob*>();
    return std::any_of(jobs.begin(), jobs.end(),
                       [](const BackgroundJob* job) { return job->isRunning(); });
}

}  // namespace ravnoves
