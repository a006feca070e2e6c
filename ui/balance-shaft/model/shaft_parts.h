#pragma once

#include <QCoreApplication>
#include <span>
#include <string_view>
#include <vector>

#include "balance-shaft/clearance.h"
#include "balance-shaft/speed_study.h"
#include "model/part.h"

namespace ravnoves {

class BalanceShaftModel;

/// The words of the parts.
struct ShaftParts {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ShaftParts)
};

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
std::vector<double> inUnit(std::vector<double> values, const Unit& unit);

/// Of a map of changes, in percent.
QString changeTitle(balance_shaft::SpeedStudy::Criterion criterion);

}  // namespace ravnoves

/// What makes the parts, by tab.
namespace ravnoves::shaft_parts {

Figure moments(const BalanceShaftModel& model);
Figure range(const BalanceShaftModel& model);
Figure means(const BalanceShaftModel& model);
Figure places(const BalanceShaftModel& model);
Figure front(const BalanceShaftModel& model);
Figure torque(const BalanceShaftModel& model);
Figure pressure(const BalanceShaftModel& model);
Figure indicator(const BalanceShaftModel& model);
Figure bestAngles(const BalanceShaftModel& model);
Figure speedMap(const BalanceShaftModel& model);
Figure sizes(const BalanceShaftModel& model);
Figure rangeOverSize(const BalanceShaftModel& model);
Figure orders(const BalanceShaftModel& model);
Results orderTable(const BalanceShaftModel& model);
Figure energy(const BalanceShaftModel& model);
Figure forceLocus(const BalanceShaftModel& model);
Figure gearMoment(const BalanceShaftModel& model);
Results forces(const BalanceShaftModel& model);
Results gears(const BalanceShaftModel& model);
Results relief(const BalanceShaftModel& model);
Notes reliefVerdict(const BalanceShaftModel& model);

}  // namespace ravnoves::shaft_parts
