#pragma once

#include <QWidget>

#include "text/result_row.h"

namespace ravnoves {

class BalanceShaftModel;
class FoldingRow;
class PlotView;
class ResultTable;
class ValueSlider;

/// Shows ForcesModel: the forces with a share κ balanced on the crank alone beside those with the
/// shaft, and gears fitted some teeth out.
class ForcesView : public QWidget {
    Q_OBJECT

  public:
    explicit ForcesView(BalanceShaftModel* model, QWidget* parent = nullptr);

    ValueSlider* shareSlider() const { return share_; }
    PlotView* gearPlot() const { return gears_; }

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    QWidget* inPanel(QWidget* widget);
    ResultTable* addTable(FoldingRow* row, const QString& name, const ResultColumns& columns);
    void showLocus();
    void showGears();

    BalanceShaftModel* model_;
    ValueSlider* share_;
    PlotView* locus_;
    PlotView* gears_;
    ResultTable* forceTable_;
    ResultTable* gearTable_;
    int first_ = 0;
    int both_ = 0;
    int shaft_ = 0;
    int right_ = 0;
    int wrong_ = 0;
    int low_ = 0;
    int high_ = 0;
};

}  // namespace ravnoves
