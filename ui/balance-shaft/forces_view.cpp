#include "balance-shaft/forces_view.h"

#include <QGridLayout>

#include "balance-shaft/model/forces_model.h"
#include "plot/plot_view.h"
#include "theme/theme.h"
#include "widgets/field_slider.h"
#include "widgets/form.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"

namespace ravnoves {

ForcesView::ForcesView(BalanceShaftModel* model, QWidget* parent) : QWidget(parent), model_(model) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, Theme::space, 0, 0);
    grid->setSpacing(Theme::space);
    constexpr int tablesWidth = 560;  ///< designed pixels of both beside each other
    auto* tables = new FoldingRow(tablesWidth, this);
    grid->addWidget(tables, 2, 0, 1, 2);

    // Without a shaft.
    auto* crank = new Form(model_, this);
    share_ = new FieldSlider(model_, "/crank_share", {0.0, 1.0, 0.01, 0.1, 2}, crank);
    FormSection* balanced = crank->section(tr("Balanced on the crank alone"));
    balanced->addWide(share_);
    static_cast<QVBoxLayout*>(crank->layout())->addStretch();
    grid->addWidget(inPanel(crank), 0, 0);
    locus_ = new PlotView(tr("Force on the engine"), this);
    locus_->setEqualScale(true);
    locus_->setXAxis({tr("across, kN"), -1.0, 1.0});
    locus_->setYAxis(PlotView::Side::Left, {tr("along, kN")});
    both_ = locus_->addCurve({.name = tr("crank only, 1st + 2nd"),
                              .colour = 4,
                              .pen = Qt::DashLine,
                              .toolTip = tr("First and second order without a shaft"),
                              .turn = 360.0});
    first_ = locus_->addCurve({.name = tr("crank only, 1st"),
                               .colour = 1,
                               .width = 2.0,
                               .toolTip = tr("First order without a shaft: an ellipse"),
                               .turn = 360.0});
    shaft_ = locus_->addCurve({.name = tr("with shaft"),
                               .colour = 2,
                               .width = 2.0,
                               .toolTip = tr("With the shaft the first order is a point; the "
                                             "second order along the cylinder stays"),
                               .turn = 360.0});
    grid->addWidget(locus_, 1, 0);
    forceTable_ = addTable(tables, tr("Forces with and without a shaft"),
                           {tr("Force"), tr("Value"), tr("Unit")});

    // Gears.
    auto* gears = new Form(model_, this);
    gears->section(tr("Gears"));
    for (const char* place : {"/gears/teeth", "/gears/shifted_teeth", "/gears/backlash_mm"}) {
        gears->number(place);
    }
    grid->addWidget(inPanel(gears), 0, 1);
    gears_ = new PlotView(tr("Mᵤₚₛ with gear error"), this);
    gears_->setXAxis({tr("φ, °"), 0.0, model_->cycleDeg(), true});
    gears_->setYAxis(PlotView::Side::Left, {tr("N·m")});
    low_ = gears_->addCurve({.name = tr("play, low"),
                             .colour = 3,
                             .width = 1.0,
                             .pen = Qt::DotLine,
                             .inLegend = false});
    high_ = gears_->addCurve({.name = tr("play"),
                              .colour = 3,
                              .width = 1.0,
                              .pen = Qt::DotLine,
                              .toolTip = tr("Band that the play of the gears leaves")});
    right_ = gears_->addCurve({.name = tr("right"),
                               .colour = 0,
                               .width = 2.4,
                               .toolTip = tr("Shaft in its right place")});
    wrong_ = gears_->addCurve({.name = tr("k teeth out"),
                               .colour = 7,
                               .width = 1.6,
                               .pen = Qt::DashLine,
                               .toolTip = tr("Shaft k teeth out")});
    grid->addWidget(gears_, 1, 1);
    gearTable_ = addTable(tables, tr("Effect of gear error and play"),
                          {tr("Gears"), tr("Value"), tr("Unit")});
    grid->setRowStretch(1, 1);
    constexpr int chartHeight = 230;  ///< designed pixels with which their curves are read
    grid->setRowMinimumHeight(1, Theme::withText(chartHeight));
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);

    connect(model_, &SceneModel::changed, this, [this] {
        if (isVisible()) {
            showLocus();
        }
    });
    connect(model_, &BalanceShaftModel::shaftMoved, this, [this] {
        if (isVisible()) {
            showGears();
        }
    });
}

QWidget* ForcesView::inPanel(QWidget* widget) {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, -1);
    column->addWidget(widget);
    return panel;
}

ResultTable* ForcesView::addTable(FoldingRow* row, const QString& name,
                                  const ResultColumns& columns) {
    auto* table = new ResultTable(name, this);
    table->setColumns(columns);
    QWidget* panel = inPanel(table);
    panel->layout()->setContentsMargins(tableMargins);
    static_cast<QVBoxLayout*>(panel->layout())->addStretch();
    row->add(panel);
    return table;
}

void ForcesView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showLocus();
    showGears();
}

void ForcesView::showLocus() {
    const ForcesModel forces(model_);
    const ForcesModel::Loci loci = forces.loci();
    locus_->setXAxis({tr("across, kN"), -loci.across, loci.across});
    locus_->setYRange(PlotView::Side::Left, loci.lowest, loci.highest);
    locus_->setCurve(first_, loci.first.x, loci.first.y);
    locus_->setCurve(both_, loci.both.x, loci.both.y);
    locus_->setCurve(shaft_, loci.withShaft.x, loci.withShaft.y);
    forceTable_->setRows(forces.forceRows());
}

void ForcesView::showGears() {
    const balance_shaft::GearError error = ForcesModel(model_).gearError();
    const balance_shaft::Result& result = model_->result();
    gears_->setYRange(PlotView::Side::Left, result.M_up.min - result.moment_amplitude,
                      result.M_up.max + result.moment_amplitude);
    if (gears_->xInterval().second != model_->cycleDeg() && !gears_->isZoomed()) {
        gears_->setXAxis({tr("φ, °"), 0.0, model_->cycleDeg(), true});
    }
    gears_->setCurve(right_, result.curves.crank_angle_deg, result.curves.M_ups);
    gears_->setCurve(wrong_, error.crank_angle_deg, error.M_ups);
    const bool play = error.play > 0.0;
    gears_->setCurve(low_, error.crank_angle_deg, play ? error.M_ups_low : std::vector<double>());
    gears_->setCurve(high_, error.crank_angle_deg, play ? error.M_ups_high : std::vector<double>());
    gearTable_->setRows(ForcesModel::gearRows(error));
}

}  // namespace ravnoves
