#pragma once

#include <QCoreApplication>
#include <span>
#include <string_view>

#include "model/part.h"

namespace ravnoves {

class ElasticHingeModel;

/// The words of the plots.
struct HingePlots {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::HingePlots)
};

/// What the page of the elastic hinges shows.
std::span<const PagePart> hingeParts();
Content hingePart(const ElasticHingeModel& model, std::string_view id);

}  // namespace ravnoves
