#pragma once

#include "balance-shaft/clearance.h"
#include "widgets/page_columns.h"

class QPushButton;

namespace ravnoves {

class BalanceShaftModel;
class Form;
class PartPlot;
class PlotView;
class SpeedStudyModel;

/// The tabs of the balance-shaft page: design, analysis, and the shaft as a part.
class ShaftTabs : public FittedTabs {
    Q_OBJECT

  public:
    explicit ShaftTabs(BalanceShaftModel* model, QWidget* parent = nullptr);

  private:
    /// Over φ, whose cursor turns the crank.
    PartPlot* addCyclePlot(std::string_view part, QWidget* parent);
    /// Over α, where a click moves the shaft.
    PartPlot* addAnglePlot(std::string_view part, QWidget* parent);
    /// A panel with a table.
    QWidget* addTable(std::string_view part, const QString& name, QWidget* parent);
    QWidget* buildMoments();
    QWidget* buildCycle();
    QWidget* buildSize();
    QWidget* buildOrders();
    QWidget* buildFlywheel();
    Form* buildFlywheelForm(QWidget* parent);
    QWidget* buildForces();
    QWidget* buildMap();
    QWidget* buildSpeed();
    Form* buildBand(SpeedStudyModel* study);
    QWidget* buildRelief();
    void addReliefSizes(Form* form);

    BalanceShaftModel* model_;
};

/// A button that moves the shaft to an angle: disabled with the reason where none is feasible.
void enableWhereFeasible(QPushButton& button, const balance_shaft::BuildableAngles& angles);

/// The point of a curve that is drawn next to a place of the chart.
std::size_t nearestPoint(const PlotView& plot, std::string_view curve, double x, double y);

}  // namespace ravnoves
