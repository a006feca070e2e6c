#pragma once

#include <QCoreApplication>
#include <span>
#include <string_view>

#include "balance-shaft/clearance.h"
#include "balance-shaft/model/place_criterion.h"
#include "model/part.h"

namespace ravnoves {

class BalanceShaftModel;

/// What the page of the balance shaft shows.
std::span<const PagePart> shaftParts();
Content shaftPart(const BalanceShaftModel& model, std::string_view id);

/// Shades the infeasible angles of the shaft, 0 to 360°.
/// @param orientation  Qt::Horizontal where α runs along x
std::vector<plot::Band> unbuildableBands(const balance_shaft::BuildableAngles& buildable,
                                         Qt::Orientation orientation = Qt::Horizontal);
/// Of a figure whose curves follow the crank.
Figure overCycle(const BalanceShaftModel& model, const QString& title, const QString& unit);
/// A figure over α, with the infeasible angles and the shaft's.
Figure overAngle(const BalanceShaftModel& model, const QString& title, const QString& unit);

/// Of a map of changes, in percent.
QString changeTitle(PlaceCriterion::Kind criterion);

// The words of the tabs, by which translations know them.
struct MomentWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::BalanceShaftPage)
};
struct CycleWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::CycleView)
};
struct SizeWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::EnvelopeView)
};
struct OrderWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::OrdersView)
};
struct FlywheelWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::FlywheelView)
};
struct ForceWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ForcesView)
};
struct MapWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ShaftMapView)
};
struct PlacesWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ShaftMapPlot)
};
struct SpeedWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::SpeedView)
};

// What makes them, by tab, in the order of the page.
using ShaftPartMakers = std::span<const PartMaker<BalanceShaftModel>>;
ShaftPartMakers momentParts();  ///< of the figures beside the tabs
ShaftPartMakers mapParts();
ShaftPartMakers cycleParts();
ShaftPartMakers speedParts();
ShaftPartMakers sizeParts();
ShaftPartMakers orderParts();  ///< and the flywheel's
ShaftPartMakers forceParts();  ///< and the relieved shaft's

}  // namespace ravnoves
