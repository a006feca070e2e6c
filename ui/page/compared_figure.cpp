#include "page/compared_figure.h"

#include <QPainter>

#include "model/reference_case.h"
#include "model/scene_model.h"
#include "pictures/figure.h"
#include "theme/theme.h"

namespace ravnoves {

ComparedFigure::ComparedFigure(QWidget* parent) : QWidget(parent) {
    makeFigure(this);
}

void ComparedFigure::followReference(SceneModel* model) {
    const ReferenceCase& reference = model->referenceCase();
    const auto show = [this, &reference] {
        referenceName_ = reference.model() != nullptr ? reference.name() : QString();
        update();
    };
    connect(&reference, &ReferenceCase::changed, this, show);
    show();
}

QPen ComparedFigure::ghostPen(QColor colour, double width) {
    colour.setAlphaF(0.34F);
    return QPen(colour, width, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin);
}

void ComparedFigure::paintReference(QPainter& painter, const QRectF& corner) const {
    if (referenceName_.isEmpty()) {
        return;
    }
    const Theme& theme = Theme::instance();
    painter.setFont(Theme::font(Theme::smallSize));
    const QFontMetricsF metrics(painter.font());
    constexpr double swatch = 20.0;
    const QString name = metrics.elidedText(referenceName_, Qt::ElideRight,
                                            0.5 * corner.width() - swatch - Theme::gap);
    const double left = corner.right() - metrics.horizontalAdvance(name) - 1.0;
    const double middle = corner.top() + 0.5 * metrics.height();
    painter.setPen(ghostPen(theme.text(), 4.0));
    painter.drawLine(QPointF(left - Theme::gap - swatch, middle),
                     QPointF(left - Theme::gap, middle));
    painter.setPen(theme.text());
    painter.drawText(QRectF(left, corner.top(), corner.right() - left, metrics.height()),
                     Qt::AlignVCenter | Qt::AlignLeft, name);
}

}  // namespace ravnoves
