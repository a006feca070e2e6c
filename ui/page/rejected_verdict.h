#pragma once

#include <algorithm>

#include "case-file/verdict.h"
#include "model/scene_model.h"

namespace ravnoves {

/// The verdict of a page; while an entry is rejected it says that it is of the value before.
inline Verdict withRejected(Verdict verdict, const SceneModel& model) {
    if (model.hasRejected()) {
        verdict.severity = std::max(verdict.severity, Severity::warning);
        verdict.text = Message(
            Text{"", "%1 %2"},
            CORE_TEXT("core", "Results use the previous value of the red field."), verdict.text);
    }
    return verdict;
}

}  // namespace ravnoves
