#pragma once

#include <QCoreApplication>
#include <span>
#include <string_view>

#include "model/part.h"

namespace ravnoves {

class V8PlugsModel;

// The words of the plots.
struct CompensationPlot {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::CompensationPlot)
};
struct ShiftPlot {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ShiftPlot)
};

/// What the V-8 page shows in plots and tables.
std::span<const PagePart> plugsParts();
Content plugsPart(const V8PlugsModel& model, std::string_view id);

}  // namespace ravnoves
