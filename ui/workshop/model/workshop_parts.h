#pragma once

#include <QCoreApplication>
#include <span>
#include <string_view>

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
struct ShiftPlot {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ShiftPlot)
};

/// What the page shows in plots and tables.
std::span<const PagePart> workshopParts();
Content workshopPart(const WorkshopModel& model, std::string_view id);
/// What the last digit of the scale leaves uncertain; empty where that is not known.
QString weighingNote(const WorkshopModel& model);

}  // namespace ravnoves
