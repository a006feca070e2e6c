#include "balance-shaft/balance_shaft_page.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QTabWidget>

#include "balance-shaft/cycle_view.h"
#include "balance-shaft/envelope_view.h"
#include "balance-shaft/flywheel_view.h"
#include "balance-shaft/forces_view.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/buildable_bands.h"
#include "balance-shaft/orders_view.h"
#include "balance-shaft/relieved_shaft_view.h"
#include "balance-shaft/shaft_map_view.h"
#include "balance-shaft/speed_view.h"
#include "page/mechanism_picture.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"

namespace ravnoves {

using balance_shaft::MomentMetrics;
using balance_shaft::Result;

namespace {

constexpr int chartPair = 420;  ///< designed pixels of two charts beside each other

}  // namespace

QWidget* BalanceShaftPage::buildPlots() {
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder);

    auto* bar = new Panel(holder);
    QHBoxLayout* barRow = rowIn(bar, Theme::margin, barMargins);
    angle_ = new FieldSlider(
        model_, "/shaft_angle_deg", {0.0, 360.0, 0.1, 10.0, 2}, bar,
        {.label = tr("Shaft angle &α"),
         .hint = tr("Angle from the cylinder axis to the line of centres, in the direction of "
                    "rotation; 90° is beside the crank. 0 to 360°, steps of 0.1°."),
         .read = [this] { return model_->shaftAngleDeg(); },
         .write = [this](double angle) { model_->setShaftAngleDeg(angle); }});
    angle_->slider()->setObjectName(QStringLiteral("shaft_angle_slider"));
    barRow->addWidget(angle_, 1);
    auto* meansLabel = new QLabel(tr("Mea&ns"), bar);
    meansChoice_ = new QComboBox(bar);
    meansChoice_->addItems({tr("both"), tr("cycle integral"), tr("paper's nodes")});
    meansChoice_->setAccessibleName(tr("Which means the plots show"));
    meansChoice_->setToolTip(
        tr("The mean of Mₛ over a cycle is 0 at every α. The paper averages 25 nodes and counts "
           "the end of the cycle twice; that alone makes its mean differ from 0."));
    meansLabel->setBuddy(meansChoice_);
    barRow->addWidget(meansLabel);
    barRow->addWidget(meansChoice_);
    connect(meansChoice_, &QComboBox::activated, this,
            [this](int index) { model_->setMeans(static_cast<BalanceShaftModel::Means>(index)); });
    column->addWidget(bar);

    views_ = new FittedTabs(holder);
    views_->setDocumentMode(true);
    column->addWidget(views_, 1);
    cycle_ = new CycleView(model_, views_);
    const auto addView = [this](QWidget* view, const char* name, const QString& title) {
        addScrolledTab(views_, view, QString::fromLatin1(name), title);
    };
    addView(buildMoments(), "moments", tr("Moments"));
    addView(new ShaftMapView(model_, views_), "map", tr("Map"));
    addView(cycle_, "cycle", tr("Cycle"));
    addView(new SpeedView(model_, views_), "speed", tr("Speed"));
    addView(new EnvelopeView(model_, views_), "envelope", tr("Size"));
    addView(new OrdersView(model_, views_), "orders", tr("Orders"));
    addView(new FlywheelView(model_, views_), "flywheel", tr("Flywheel"));
    addView(new ForcesView(model_, views_), "forces", tr("Forces"));
    addView(new RelievedShaftView(model_, views_), "relieved", tr("Relief"));
    return holder;
}

QWidget* BalanceShaftPage::buildMoments() {
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder, Theme::space, tabMargins);
    const QString crankAxis = tr("φ, °");
    const QString angleAxis = tr("α, °");
    const QString newtonMetre = tr("N·m");

    moments_ = new PlotView(tr("Moments over the cycle"), holder);
    moments_->setXAxis({crankAxis, 0.0, model_->cycleDeg(), true});
    moments_->setYAxis(PlotView::Side::Left, {newtonMetre});
    up_ = moments_->addCurve({.name = QStringLiteral("Mᵤₚ"),
                              .colour = 0,
                              .width = 1.4,
                              .toolTip = tr("Tipping moment: the reaction to the engine torque")});
    s_ = moments_->addCurve({.name = QStringLiteral("Mₛ"),
                             .colour = 1,
                             .width = 1.4,
                             .toolTip = tr("Moment of the balance shaft, P₁ l sin(α + φ), (4)")});
    ups_ = moments_->addCurve({.name = QStringLiteral("Mᵤₚₛ"),
                               .colour = 2,
                               .width = 2.0,
                               .toolTip = tr("Moment on the mounts, Mᵤₚ + Mₛ, (5)")});
    showCrankAngle(moments_, model_->crank());
    connect(moments_, &PlotView::curveToggled, this, &BalanceShaftPage::showShaft);
    column->addWidget(moments_, 5);

    auto* lower = new FoldingRow(chartPair, holder);
    range_ = new PlotView(tr("Range and RMS over α"), holder);
    range_->setXAxis({angleAxis, 0.0, 360.0, true});
    range_->setYAxis(PlotView::Side::Left, {newtonMetre});
    range_->setYAxis(PlotView::Side::Right, {tr("mean Mₛ, N·m")});
    range_->setPickable(true);
    rangeCurve_ = range_->addCurve({.name = QStringLiteral("ΔMᵤₚₛ"),
                                    .colour = 2,
                                    .width = 1.8,
                                    .toolTip = tr("Range of Mᵤₚₛ, max − min")});
    rmsCurve_ = range_->addCurve(
        {.name = tr("RMS"), .colour = 3, .toolTip = tr("RMS of Mᵤₚₛ about its mean")});
    meanSTrue_ = range_->addCurve({.name = tr("Mₛ mean"),
                                   .colour = 1,
                                   .side = PlotView::Side::Right,
                                   .toolTip = tr("Cycle mean of Mₛ: 0 at every α")});
    meanSPrinted_ = range_->addCurve({.name = tr("Mₛ mean (paper)"),
                                      .colour = 4,
                                      .side = PlotView::Side::Right,
                                      .pen = Qt::DashLine,
                                      .toolTip = tr("Mean of 25 nodes, the end counted twice")});
    means_ = new PlotView(tr("Means over α"), holder);
    means_->setXAxis({angleAxis, 0.0, 360.0, true});
    means_->setYAxis(PlotView::Side::Left, {newtonMetre});
    means_->setPickable(true);
    mSTrue_ = means_->addCurve(
        {.name = tr("Mₛₘ"), .colour = 1, .width = 1.8, .toolTip = tr("Cycle mean of Mₛ")});
    mUpsTrue_ = means_->addCurve(
        {.name = tr("Mᵤₚₛₘ"), .colour = 2, .width = 1.8, .toolTip = tr("Cycle mean of Mᵤₚₛ")});
    mSPrinted_ = means_->addCurve({.name = tr("Mₛₘ (paper)"),
                                   .colour = 4,
                                   .pen = Qt::DashLine,
                                   .toolTip = tr("Mean of 25 nodes, the end counted twice")});
    mUpsPrinted_ = means_->addCurve({.name = tr("Mᵤₚₛₘ (paper)"),
                                     .colour = 5,
                                     .pen = Qt::DashLine,
                                     .toolTip = tr("Node mean of Mᵤₚ plus that of Mₛ")});
    for (PlotView* plot : {range_, means_}) {
        lower->add(plot);
        connect(plot, &PlotView::picked, model_, &BalanceShaftModel::pickShaftAngleDeg);
    }
    column->addWidget(lower, 4);
    return holder;
}

void BalanceShaftPage::showSweep() {
    const Result& result = model_->result();
    const balance_shaft::AngleSweep& sweep = result.sweep;
    if (moments_->xInterval().second != model_->cycleDeg() && !moments_->isZoomed()) {
        moments_->setXAxis({tr("φ, °"), 0.0, model_->cycleDeg(), true});
    }
    moments_->setCurve(up_, result.curves.crank_angle_deg, result.curves.M_up);
    // Room for every α, so that the axis rests while the shaft moves.
    const double reach = result.moment_amplitude;
    moments_->setYRange(PlotView::Side::Left, result.M_up.min - reach, result.M_up.max + reach);
    range_->setCurve(rangeCurve_, sweep.shaft_angle_deg, sweep.range);
    range_->setCurve(rmsCurve_, sweep.shaft_angle_deg, sweep.rms);
    range_->setCurve(meanSTrue_, sweep.shaft_angle_deg, sweep.mean_M_s);
    range_->setCurve(meanSPrinted_, sweep.shaft_angle_deg, sweep.printed_mean_M_s);
    means_->setCurve(mSTrue_, sweep.shaft_angle_deg, sweep.mean_M_s);
    means_->setCurve(mSPrinted_, sweep.shaft_angle_deg, sweep.printed_mean_M_s);
    means_->setCurve(mUpsTrue_, sweep.shaft_angle_deg, sweep.mean_M_ups);
    means_->setCurve(mUpsPrinted_, sweep.shaft_angle_deg, sweep.printed_mean_M_ups);

    std::vector<PlotView::Mark> marks;
    const QLocale locale;
    const auto add = [&](const balance_shaft::Optimum& best, int colour) {
        if (best.shaft_angle) {
            const double at = *best.shaft_angle / degree;
            marks.push_back({at, best.value, fixedNumber(at, 2, locale) + QStringLiteral("°"),
                             colour, PlotView::Side::Left, true});
        }
    };
    add(model_->bestRange(), 2);
    add(model_->bestRms(), 3);
    range_->setMarks(marks);
    range_->setBands(unbuildableBands(result.buildable));
    means_->setBands(unbuildableBands(result.buildable));
    bestRange_->setText(model_->bestRangeText());
    bestRms_->setText(model_->bestRmsText());
    goRange_->setEnabled(model_->bestRange().shaft_angle.has_value());
    goRms_->setEnabled(model_->bestRms().shaft_angle.has_value());
    bestRangeAction_->setEnabled(goRange_->isEnabled());
    bestRmsAction_->setEnabled(goRms_->isEnabled());
    notes_->setText(model_->notesText());
}

void BalanceShaftPage::showShaft() {
    const Result& result = model_->result();
    const double alpha = model_->shaftAngleDeg();
    angle_->follow();
    showVerdict();
    moments_->setCurve(s_, result.curves.crank_angle_deg, result.curves.M_s);
    moments_->setCurve(ups_, result.curves.crank_angle_deg, result.curves.M_ups);
    const auto shown = [](double moment) { return shownDigits(moment, units::N_m, 0); };
    std::vector<PlotView::Mark> marks;
    const auto mark = [&](int curve, const MomentMetrics& metrics, int colour) {
        if (!moments_->isCurveShown(curve)) {
            return;
        }
        marks.push_back({metrics.max_angle / degree, metrics.max, shown(metrics.max), colour});
        marks.push_back({metrics.min_angle / degree, metrics.min, shown(metrics.min), colour});
    };
    mark(ups_, result.M_ups, 2);
    mark(up_, result.M_up, 0);
    mark(s_, result.M_s, 1);
    moments_->setMarks(std::move(marks));
    range_->setPresentX(alpha);
    means_->setPresentX(alpha);
    criteria_->setResults(model_->criteria());
    quantities_->setResults(model_->quantities());
}

void BalanceShaftPage::showMeans() {
    using Means = BalanceShaftModel::Means;
    const Means shown = model_->means();
    meansChoice_->setCurrentIndex(static_cast<int>(shown));
    const bool truth = shown != Means::PrintedNodes;
    const bool printed = shown != Means::CycleIntegral;
    range_->setCurveShown(meanSTrue_, truth);
    means_->setCurveShown(mSTrue_, truth);
    means_->setCurveShown(mUpsTrue_, truth);
    range_->setCurveShown(meanSPrinted_, printed);
    means_->setCurveShown(mSPrinted_, printed);
    means_->setCurveShown(mUpsPrinted_, printed);
}

}  // namespace ravnoves
