#pragma once

#include <QCoreApplication>
#include <span>
#include <string_view>

#include "model/part.h"

namespace ravnoves {

class BobWeightsModel;

/// The words of the plot.
struct ForcePlot {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ForcePlot)
};

/// What the page of bob weights shows in plots and tables.
std::span<const PagePart> bobParts();
Content bobPart(const BobWeightsModel& model, std::string_view id);

}  // namespace ravnoves
