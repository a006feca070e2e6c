#include "balance-shaft/envelope_view.h"

#include <algorithm>
#include <cmath>

#include "balance-shaft/model/buildable_bands.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "plot/plot_view.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/layouts.h"

namespace ravnoves {

EnvelopeView::EnvelopeView(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    QVBoxLayout* column = columnIn(this, Theme::space, tabMargins);
    sizes_ = new PlotView(tr("Overall size over α"), this);
    sizes_->setXAxis({tr("α, °"), 0.0, 360.0, true});
    sizes_->setYAxis(PlotView::Side::Left, {tr("mm")});
    sizes_->setPickable(true);
    width_ = sizes_->addCurve({.name = tr("width"), .colour = 2, .width = 1.8});
    height_ = sizes_->addCurve({.name = tr("height"), .colour = 1, .width = 1.8});
    connect(sizes_, &PlotView::picked, model_, &BalanceShaftModel::pickShaftAngleDeg);
    column->addWidget(sizes_, 2);

    pareto_ = new PlotView(tr("Range against overall size, α along the curve"), this);
    pareto_->setYAxis(PlotView::Side::Left, {tr("ΔMᵤₚₛ, N·m")});
    pareto_->setPickable(true);
    all_ =
        pareto_->addCurve({.name = tr("every α"), .colour = 0, .width = 1.0, .pen = Qt::DotLine});
    built_ = pareto_->addCurve({.name = tr("can be built"),
                                .colour = 0,
                                .width = 1.8,
                                .toolTip = tr("The shaft clears cylinder, crank and rod"),
                                .gaps = true});
    efficient_ = pareto_->addCurve({.name = tr("nothing better"),
                                    .colour = 3,
                                    .shape = PlotView::Shape::Points,
                                    .toolTip = tr("Can be built, and no other α that can has both "
                                                  "a smaller box and a smaller range")});
    present_ =
        pareto_->addCurve({.name = tr("present α"), .colour = 7, .shape = PlotView::Shape::Points});
    connect(pareto_, &PlotView::pickedAt, this, [this](double area, double range) {
        // The angle whose point lies nearest on the screen.
        const QPointF clicked = pareto_->toPixel(area, range);
        double nearest = 1e300;
        double angle = 0.0;
        for (std::size_t i = 0; i + 1 < shown_.area.size(); ++i) {
            const QPointF d = pareto_->toPixel(shown_.area[i], shown_.range[i]) - clicked;
            const double distance = d.x() * d.x() + d.y() * d.y();
            if (distance < nearest) {
                nearest = distance;
                angle = shown_.angle[i];
            }
        }
        model_->setShaftAngleDeg(angle);
    });
    column->addWidget(pareto_, 3);
    column->addWidget(captionLabel(
        tr("The box around cylinder, crank circle, shaft circle and gears, with the wall, in the "
           "front view. Where the shaft's circle meets cylinder, crank or rod, α cannot be built. "
           "The sizes are on the Inputs tab. Click either chart to set α."),
        this));

    connect(model_, &SceneModel::changed, this, [this] {
        stale_ = true;
        if (isVisible()) {
            solve();
        }
    });
    connect(&Theme::instance(), &Theme::changed, this,
            [this] { sizes_->setBands(unbuildableBands(model_->result().buildable)); });
    connect(model_, &BalanceShaftModel::shaftMoved, this, [this] {
        if (isVisible()) {
            showPresent();
        }
    });
}

void EnvelopeView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (stale_) {
        solve();
    }
    showPresent();
}

void EnvelopeView::solve() {
    stale_ = false;
    shown_ = shownSizes(model_->envelopeStudy());
    sizes_->setCurve(width_, shown_.angle, shown_.width);
    sizes_->setCurve(height_, shown_.angle, shown_.height);
    sizes_->setBands(unbuildableBands(model_->result().buildable));
    const auto [least, most] = std::minmax_element(shown_.area.begin(), shown_.area.end());
    const double pad = std::max(0.04 * (*most - *least), 1e-6);
    pareto_->setXAxis({tr("width × height, cm²"), *least - pad, *most + pad});
    pareto_->setCurve(all_, shown_.area, shown_.range);
    pareto_->setCurve(built_, shown_.area, shown_.builtRange);
    std::vector<double> area;
    std::vector<double> range;
    for (const ShownSizes::Point& point : shown_.efficient) {
        area.push_back(point.area);
        range.push_back(point.range);
    }
    pareto_->setCurve(efficient_, std::move(area), std::move(range));
    std::vector<PlotView::Mark> marks;
    for (const ShownSizes::Point& point : shown_.marked) {
        // A ring: the present α is seen in it.
        marks.push_back({.x = point.area,
                         .y = point.range,
                         .text = fixedNumber(point.angle, 0, QLocale()) + QStringLiteral("°"),
                         .colour = 3,
                         .ring = true});
    }
    pareto_->setMarks(marks);
    showPresent();
}

void EnvelopeView::showPresent() {
    sizes_->setPresentX(model_->shaftAngleDeg());
    pareto_->setCurve(present_, {boxArea(model_->result().envelope)},
                      {model_->result().M_ups.range});
}

}  // namespace ravnoves
