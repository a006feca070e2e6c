#include "plot/chart_frame.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QPainter>
#include <QValueAxis>
#include <utility>

#include "pictures/model/pixel.h"
#include "theme/theme.h"

namespace ravnoves {

ChartFrame& ChartFrame::instance(bool hasRight) {
    // Never destroyed: what their items need is gone before.
    if (hasRight) {
        static auto& three = *new ChartFrame(true);
        return three;
    }
    static auto& two = *new ChartFrame(false);
    return two;
}

ChartFrame::ChartFrame(bool hasRight) : scene_(new QGraphicsScene), chart_(new QChart) {
    scene_->addItem(chart_);
    chart_->setBackgroundVisible(false);
    chart_->legend()->hide();
    chart_->setAnimationOptions(QChart::NoAnimation);
    chart_->layout()->setContentsMargins(0, 0, 0, 0);
    chart_->setMargins(QMargins());
    const auto add = [this](Qt::Alignment edge) {
        auto* axis = new QValueAxis;
        chart_->addAxis(axis, edge);
        axis->setTickCount(2);
        axis->setRange(0.0, 1.0);
        axis->setLabelFormat(QStringLiteral(" "));
        axis->setLabelsVisible(false);
        axis->setTitleVisible(false);
        axis->setGridLineVisible(false);
        axes_ << axis;
    };
    add(Qt::AlignBottom);
    add(Qt::AlignLeft);
    if (hasRight) {
        add(Qt::AlignRight);
    }
}

void ChartFrame::layOut(const Layout& layout) {
    if (layout == layout_) {
        return;
    }
    layout_ = layout;
    for (QValueAxis* axis : std::as_const(axes_)) {
        axis->setLinePen(layout.pen);
    }
    // A new plot area alone does not lay out anything; in this order it is done once.
    scene_->setSceneRect(QRectF(QPointF(), layout.size));
    chart_->layout()->invalidate();
    chart_->setPlotArea(layout.area);
    chart_->resize(layout.size);
    chart_->layout()->activate();
}

void ChartFrame::paint(QPainter& painter, const QSizeF& size, const QRectF& area) {
    const QRectF whole(QPointF(), size);
    QPen pen(Theme::instance().border(), 1);
    painter.save();
    // The lines whole, without the chart's own ticks.
    painter.setClipRect(area.adjusted(-0.5, -0.5, 0.5, 0.5));
    if (paintsPixels(painter)) {
        // A chart of one size, stretched to the area: to lay it out again would take as long as all
        // that is painted of it. The lines are as wide as they would be unstretched.
        constexpr double side = 1000.0;
        constexpr double margin = 100.0;
        constexpr double beyond = 2.0;  // pixels, of the lines outside the area
        pen.setWidthF(painter.deviceTransform().m11());
        pen.setCosmetic(true);
        layOut({{side + 2.0 * margin, side + 2.0 * margin}, {margin, margin, side, side}, pen});
        const double x = beyond * side / area.width();
        const double y = beyond * side / area.height();
        scene_->render(&painter, area.adjusted(-beyond, -beyond, beyond, beyond),
                       layout_.area.adjusted(-x, -y, x, y), Qt::IgnoreAspectRatio);
    } else {
        layOut({size, area, pen});
        scene_->render(&painter, whole, whole);
    }
    painter.restore();
}

}  // namespace ravnoves
