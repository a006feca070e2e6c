#pragma once

#include <QCoreApplication>
#include <QStringList>
#include <span>
#include <string_view>
#include <vector>

#include "model/part.h"

namespace ravnoves {

class WorkshopModel;

// The words of the plots.
struct ForcePlot {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ForcePlot)
};
struct CompensationPlot {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::CompensationPlot)
};

/// What the page shows in plots and tables.
std::span<const PagePart> workshopParts();
Content workshopPart(const WorkshopModel& model, std::string_view id);

/// A text of the answer, a sentence or more: a line of the page, and of the part's notes.
struct AnswerLine {
    std::string_view id;
    Severity severity;
    QStringList texts;
    std::string_view part = "notes";  ///< empty: of none
};
std::vector<AnswerLine> answerLines(const WorkshopModel& model);

}  // namespace ravnoves
