#include "balance-shaft/flywheel_view.h"

#include "balance-shaft/fields.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "page/mechanism_picture.h"
#include "plot/plot_view.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"

namespace ravnoves {

using balance_shaft::FlywheelTarget;
namespace field = balance_shaft::field;

FlywheelView::FlywheelView(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    QVBoxLayout* column = columnIn(this, Theme::space, tabMargins);
    plot_ = new PlotView(tr("Excess energy over the cycle"), this);
    plot_->setXAxis({tr("φ, °"), 0.0, model_->cycleDeg(), true});
    plot_->setYAxis(PlotView::Side::Left, {tr("J")});
    energy_ = plot_->addCurve({.name = tr("E"),
                               .colour = 2,
                               .width = 1.8,
                               .inLegend = false,
                               .toolTip = tr("Work of the engine torque less that of its mean")});
    showCrankAngle(plot_, model_->crank());
    column->addWidget(plot_, 3);

    constexpr int pairWidth = 600;
    auto* lower = new FoldingRow(pairWidth, this);
    auto* formPanel = new Panel(this);
    columnIn(formPanel)->addWidget(buildForm());
    lower->add(formPanel);
    auto* answerPanel = new Panel(this);
    QVBoxLayout* answerColumn = columnIn(answerPanel, -1, tableMargins);
    table_ = new ResultTable(tr("Excess work, fluctuation and moment of inertia"), answerPanel);
    table_->setColumns({tr("Flywheel"), tr("Value"), tr("Unit")});
    answerColumn->addWidget(table_);
    answerColumn->addStretch();
    lower->add(answerPanel);
    column->addWidget(lower, 2);

    connect(model_, &SceneModel::changed, this, [this] {
        if (isVisible()) {
            showResult();
        }
    });
}

QWidget* FlywheelView::buildForm() {
    auto* form = new Form(model_, this);
    FormSection* section = form->section(tr("Flywheel"));
    for (const auto& [given, value] :
         {std::pair(&field::flywheel_inertia, &FlywheelTarget::inertia),
          std::pair(&field::fluctuation, &FlywheelTarget::fluctuation)}) {
        NumberField* number = form->number(
            *given,
            [this, value = value] {
                return model_->input().flywheel.value_or(FlywheelTarget{}).*value;
            },
            [this, value = value](std::optional<double> typed) {
                model_->setFlywheel(value, typed);
            });
        number->setOptional(true);
        number->setDigits(6);
    }
    section->addWide(
        captionLabel(tr("The load takes the mean torque. The inertia of piston and rod is in the "
                        "torque already and is not a part of J."),
                     form));
    form->column()->addStretch();
    return form;
}

void FlywheelView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showResult();
}

void FlywheelView::showResult() {
    const balance_shaft::Result& result = model_->result();
    const balance_shaft::Flywheel& wheel = result.flywheel;
    if (plot_->xInterval().second != model_->cycleDeg() && !plot_->isZoomed()) {
        plot_->setXAxis({tr("φ, °"), 0.0, model_->cycleDeg(), true});
    }
    plot_->setCurve(energy_, result.curves.crank_angle_deg, wheel.energy);
    const QLocale locale;
    plot_->setMarks({{wheel.max_angle / degree, wheel.max_energy,
                      tr("fastest, %1 J").arg(fixedNumber(wheel.max_energy, 0, locale)), 2},
                     {wheel.min_angle / degree, wheel.min_energy,
                      tr("slowest, %1 J").arg(fixedNumber(wheel.min_energy, 0, locale)), 2}});
    table_->setRows(model_->flywheelRows());
}

}  // namespace ravnoves
