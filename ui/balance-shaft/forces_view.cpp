#include "balance-shaft/forces_view.h"

#include <QGridLayout>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "balance-shaft/crank_balance.h"
#include "balance-shaft/fields.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "plot/plot_view.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using balance_shaft::Input;
namespace field = balance_shaft::field;

namespace {

std::vector<double> kilonewtons(std::vector<double> newtons) {
    for (double& value : newtons) {
        value = value / units::kN;
    }
    return newtons;
}

}  // namespace

ForcesView::ForcesView(BalanceShaftModel* model, QWidget* parent) : QWidget(parent), model_(model) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, Theme::space, 0, 0);
    grid->setSpacing(Theme::space);

    // Without a shaft.
    auto* shareBar = new Panel(this);
    auto* shareRow = new QHBoxLayout(shareBar);
    shareRow->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    share_ =
        new ValueSlider(shownText(field::crank_share.label), 0.0, 1.0, 0.01, 0.1, 2, {}, shareBar);
    share_->setHint(shownText(field::crank_share.hint));
    connect(share_, &ValueSlider::valueEdited, this, [this](double value) {
        model_->drag(fieldName(field::crank_share),
                     [value](Input& input) { input.crank_share = value; });
    });
    connect(share_, &ValueSlider::released, model_, &SceneModel::finishDrag);
    shareRow->addWidget(share_);
    grid->addWidget(shareBar, 0, 0);
    locus_ = new PlotView(tr("Force on the engine"), this);
    locus_->setEqualScale(true);
    locus_->setXAxis({tr("across, kN"), -1.0, 1.0});
    locus_->setYAxis(PlotView::Side::Left, {tr("along the cylinder, kN")});
    both_ = locus_->addCurve({.name = tr("crank only, 1st + 2nd"),
                              .colour = 4,
                              .pen = Qt::DashLine,
                              .toolTip = tr("First and second order without a shaft")});
    first_ = locus_->addCurve({.name = tr("crank only, 1st"),
                               .colour = 1,
                               .width = 2.0,
                               .toolTip = tr("First order without a shaft: an ellipse")});
    shaft_ = locus_->addCurve({.name = tr("with shaft"),
                               .colour = 2,
                               .width = 2.0,
                               .toolTip = tr("With the shaft the first order is a point; the "
                                             "second order along the cylinder stays")});
    grid->addWidget(locus_, 1, 0);
    auto* forcePanel = new Panel(this);
    auto* forceColumn = new QVBoxLayout(forcePanel);
    forceColumn->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    forceTable_ = new ResultTable(forcePanel);
    forceTable_->setAccessibleName(tr("Forces with and without a shaft"));
    forceTable_->setColumns({tr("Force"), tr("Value"), tr("Unit")});
    forceColumn->addWidget(forceTable_);
    forceColumn->addStretch();
    grid->addWidget(forcePanel, 2, 0);

    // Gears.
    auto* gearBar = new Panel(this);
    auto* gearRow = new QHBoxLayout(gearBar);
    gearRow->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    gearRow->setSpacing(Theme::space);
    teeth_ = new QSpinBox(gearBar);
    teeth_->setRange(static_cast<int>(field::teeth.range.min),
                     static_cast<int>(field::teeth.range.max));
    teeth_->setKeyboardTracking(false);
    teeth_->setAccessibleName(tr("Teeth z of each gear"));
    teeth_->setToolTip(shownText(field::teeth.hint));
    shifted_ = new QSpinBox(gearBar);
    shifted_->setKeyboardTracking(false);
    shifted_->setAccessibleName(tr("Teeth k by which the shaft is out"));
    shifted_->setToolTip(shownText(field::shifted_teeth.hint));
    backlash_ = new NumberField(field::backlash, gearBar);
    backlash_->setAccessibleName(tr("Backlash, mm"));
    backlash_->setHint(shownText(field::backlash.hint));
    backlash_->setMaximumWidth(70);
    const auto addLabelled = [&](const QString& text, QWidget* widget) {
        auto* label = new QLabel(text, gearBar);
        label->setBuddy(widget);
        gearRow->addWidget(label);
        gearRow->addWidget(widget);
    };
    addLabelled(tr("&z"), teeth_);
    addLabelled(tr("&k"), shifted_);
    addLabelled(tr("play, &mm"), backlash_);
    gearRow->addStretch();
    connect(teeth_, &QSpinBox::valueChanged, this, [this](int value) {
        model_->edit(tr("Teeth"), [&](Input& input) {
            input.gears.teeth = value;
            input.gears.shifted_teeth = std::clamp(input.gears.shifted_teeth, 1 - value, value - 1);
        });
    });
    connect(shifted_, &QSpinBox::valueChanged, this, [this](int value) {
        model_->editField("/gears/shifted_teeth", value, tr("Shifted teeth"));
    });
    backlash_->setModel(model_);
    auto* trouble = new TroubleLine(gearBar);
    trouble->watch(backlash_);
    gearRow->addWidget(trouble, 1);
    connect(backlash_, &NumberField::valueEdited, this, [this](std::optional<double> value) {
        model_->editField("/gears/backlash_mm", *value, tr("Backlash"));
    });
    grid->addWidget(gearBar, 0, 1);
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
                               .width = 1.4,
                               .toolTip = tr("Shaft in its right place")});
    wrong_ = gears_->addCurve(
        {.name = tr("k teeth out"), .colour = 7, .width = 2.0, .toolTip = tr("Shaft k teeth out")});
    grid->addWidget(gears_, 1, 1);
    auto* gearPanel = new Panel(this);
    auto* gearColumn = new QVBoxLayout(gearPanel);
    gearColumn->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    gearTable_ = new ResultTable(gearPanel);
    gearTable_->setAccessibleName(tr("Effect of gear error and play"));
    gearTable_->setColumns({tr("Gears"), tr("Value"), tr("Unit")});
    gearColumn->addWidget(gearTable_);
    gearColumn->addStretch();
    grid->addWidget(gearPanel, 2, 1);
    grid->setRowStretch(1, 1);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);

    connect(model_, &SceneModel::changed, this, [this] {
        if (isVisible()) {
            showInput();
            showLocus();
        }
    });
    connect(model_, &BalanceShaftModel::shaftMoved, this, [this] {
        if (isVisible()) {
            showGears();
        }
    });
}

void ForcesView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showInput();
    showLocus();
    showGears();
}

void ForcesView::showInput() {
    const Input& input = model_->input();
    share_->setValue(input.crank_share);
    const QSignalBlocker quietTeeth(teeth_);
    const QSignalBlocker quietShifted(shifted_);
    teeth_->setValue(input.gears.teeth);
    shifted_->setRange(1 - input.gears.teeth, input.gears.teeth - 1);
    shifted_->setValue(input.gears.shifted_teeth);
    backlash_->setValue(input.gears.backlash / units::mm);
}

void ForcesView::showLocus() {
    const balance_shaft::CrankBalance balance = balance_shaft::crank_balance(model_->solver());
    const auto set = [this](int curve, balance_shaft::ForceLocus locus) {
        locus_->setCurve(curve, kilonewtons(std::move(locus.x)), kilonewtons(std::move(locus.y)));
    };
    const double reach = 1.15e-3 * std::max(balance.across, balance.along + balance.second_order);
    locus_->setXAxis({tr("across, kN"), -reach, reach});
    locus_->setYRange(PlotView::Side::Left, -reach, reach);
    set(first_, balance_shaft::crank_only_locus(balance));
    set(both_, balance_shaft::crank_only_locus_with_second_order(balance));
    set(shaft_, balance_shaft::shaft_locus(balance));
    const QLocale locale;
    const auto row = [&](const QString& name, double value) {
        return QStringList{name, fixedNumber(value, 0, locale), tr("N")};
    };
    forceTable_->setRows({
        row(tr("1st order, P"), balance.first_order),
        row(tr("along, (1 − κ) P"), balance.along),
        row(tr("across, κ P"), balance.across),
        row(tr("1st with shaft"), balance.with_shaft),
        row(tr("2nd order, λ mⱼ r ω²"), balance.second_order),
        {tr("on crank, κ mⱼ r"),
         fixedNumber(balance.counterweight_moment / units::gram_mm, 0, locale), tr("g·mm")},
    });
    const QStringList hints{tr("First-order inertia force, mⱼ r ω²"),
                            tr("Half-axis of the ellipse along the cylinder"),
                            tr("Half-axis of the ellipse across the cylinder"),
                            tr("First order that the shaft's two counterweights leave"),
                            tr("Second order along the cylinder; stays with and without a shaft"),
                            tr("Static moment of the counterweight on the crank")};
    for (int i = 0; i < hints.size(); ++i) {
        forceTable_->setCellToolTip(i, 0, hints[i]);
    }
}

void ForcesView::showGears() {
    const balance_shaft::GearError error =
        balance_shaft::gear_error(model_->solver(), model_->input().shaft_angle);
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
    const QLocale locale;
    const QString newtonMetre = tr("N·m");
    gearTable_->setRows({
        {tr("phase error"), fixedNumber(error.phase_error / degree, 2, locale),
         QStringLiteral("°")},
        {tr("force left"), fixedNumber(error.residual_force, 0, locale), tr("N")},
        {tr("range"),
         fixedNumber(error.right_range, 0, locale) + QStringLiteral(" → ") +
             fixedNumber(error.range, 0, locale),
         newtonMetre},
        {tr("RMS"),
         fixedNumber(error.right_rms, 1, locale) + QStringLiteral(" → ") +
             fixedNumber(error.rms, 1, locale),
         newtonMetre},
        {tr("play, ±"), fixedNumber(error.play / degree, 3, locale), QStringLiteral("°")},
        {tr("range in play"),
         fixedNumber(error.play_range_low, 0, locale) + QStringLiteral("…") +
             fixedNumber(error.play_range_high, 0, locale),
         newtonMetre},
    });
    const QStringList hints{tr("360° k / z"),
                            tr("Constant force that turns against the crank, 2 P₁ |sin(δ/2)|"),
                            tr("ΔMᵤₚₛ, shaft in its right place → k teeth out"),
                            tr("RMS of Mᵤₚₛ, shaft in its right place → k teeth out"),
                            tr("The shaft wanders this far to either side: play / l"),
                            tr("Least and largest ΔMᵤₚₛ while the shaft wanders")};
    for (int i = 0; i < hints.size(); ++i) {
        gearTable_->setCellToolTip(i, 0, hints[i]);
    }
}

}  // namespace ravnoves
