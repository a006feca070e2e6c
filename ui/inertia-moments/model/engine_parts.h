#pragma once

#include <QCoreApplication>
#include <span>
#include <string_view>

#include "inertia-moments/result.h"
#include "model/part.h"

namespace ravnoves {

class InertiaMomentsModel;

/// The words of the plots.
struct EnginePlots {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::InertiaMomentsCharts)
};

/// What the page of inertia forces and moments shows.
std::span<const PagePart> engineParts();
Content enginePart(const InertiaMomentsModel& model, std::string_view id);

/// True where the first two orders have no moment but a force: an engine in one plane.
bool hasForcesOnly(const inertia_moments::Result& result);

/// Force or moment of an order at kφ (rad); 0 where it is mere rounding.
inertia_moments::Complex vectorAt(const inertia_moments::EngineOrder& order, bool force,
                                  double angle);

}  // namespace ravnoves
