#pragma once

#include <algorithm>
#include <functional>

#include "case-file/verdict.h"
#include "model/scene_model.h"
#include "widgets/verdict_line.h"

namespace ravnoves {

/// Says that results are of the values before rejected entries; empty without any.
inline Message rejectedNote(const SceneModel& model) {
    return model.hasRejected() && model.isOutdated()
               ? Text::tr("Results use the previous value of each red field.")
               : Message();
}

/// The verdict of a page, with that note.
inline Verdict withRejected(Verdict verdict, const SceneModel& model) {
    if (const Message note = rejectedNote(model); !note.empty()) {
        verdict.severity = std::max(verdict.severity, Severity::warning);
        verdict.text = Message(Text{"%1 %2"}, note, verdict.text);
    }
    return verdict;
}

/// Keeps a line at the verdict of a model.
/// @param act  what its button says
inline void showVerdict(
    VerdictLine* line, SceneModel* model,
    const std::function<QString(const Verdict&)>& act = [](const Verdict&) { return QString(); }) {
    const auto show = [=] {
        const Verdict verdict = withRejected(model->verdictShown().value(), *model);
        line->show(verdict, act(verdict));
    };
    for (const auto signal :
         {&SceneModel::changed, &SceneModel::shownChanged, &SceneModel::rejectedInChanged}) {
        QObject::connect(model, signal, line, show);
    }
    show();
}

}  // namespace ravnoves
