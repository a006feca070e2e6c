#include "shell/scene_page.h"

#include <algorithm>

#include "widgets/background_job.h"

namespace ravnoves {

bool ScenePage::isBusy() const {
    const auto jobs = findChildren<BackgroundJob*>();
    return std::any_of(jobs.begin(), jobs.end(),
                       [](const BackgroundJob* job) { return job->isRunning(); });
}

}  // namespace ravnoves
