#include "shell/scene_page.h"

#include <algorithm>

#include "model/background_job.h"
#include "plot/plot_view.h"
#include "widgets/mechanism_picture.h"
#include "widgets/mnemonics.h"
#include "widgets/wheel_guard.h"

namespace ravnoves {

ScenePage::ScenePage(QWidget* parent) : QWidget(parent) {
    guardWheel();
    keepMnemonicsApart(this);
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
