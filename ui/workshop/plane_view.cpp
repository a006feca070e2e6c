#include "workshop/plane_view.h"

#include <QPainter>

#include "model/reference_case.h"
#include "widgets/panel.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plane_drawing.h"

namespace ravnoves {

using namespace bob_weights;

PlaneView::PlaneView(WorkshopModel* model, std::size_t plane, QWidget* parent)
    : ComparedFigure(parent), model_(model), plane_(plane) {
    setObjectName(QStringLiteral("plane_%1").arg(plane + 1));
    const auto repaint = [this] {
        setAccessibleName(model_->planeName(plane_));
        setAccessibleDescription(caption());
        update();
    };
    for (const auto signal : {&SceneModel::changed, &SceneModel::shownChanged}) {
        connect(model_, signal, this, repaint);
    }
    connect(&Theme::instance(), &Theme::changed, this, repaint);
    followReference(model_);
    setToolTip(
        tr("Arrow: reading; dashed circle: limit; dot: residual; rim: holes and slugs, existing "
           "holes dimmed. Front view, angles as on the machine."));
    repaint();
}

QString PlaneView::caption() const {
    const auto& correction = model_->shown().solution().correction;
    if (!correction) {
        return tr("no correction yet");
    }
    const Words words;
    return tr("%1 at %2")
        .arg(words.number((*correction)[plane_].unbalance, units::gram_mm, 0),
             words.number((*correction)[plane_].angle, units::degree, 1));
}

void PlaneView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const Theme& theme = Theme::instance();
    const QRect title = paintPanel(painter, rect(), model_->planeName(plane_));
    paintReference(painter, title);
    const QFont small = Theme::font(Theme::smallSize);
    painter.setFont(small);
    const QFontMetrics smallMetrics(small);

    painter.setPen(theme.mutedText());
    painter.drawText(QRect(Theme::margin, height() - Theme::space - smallMetrics.height(),
                           width() - 2 * Theme::margin, smallMetrics.height()),
                     Qt::AlignHCenter | Qt::AlignVCenter, caption());

    const QRectF target(
        Theme::margin, title.bottom() + Theme::gap, width() - 2.0 * Theme::margin,
        height() - title.bottom() - Theme::gap - Theme::space - smallMetrics.height());
    const WorkshopModel& shown = model_->shown();
    const WorkshopModel* other = referenceOf(model_);
    const Result* reference = other != nullptr ? &other->solution() : nullptr;
    drawPlane(painter, target, {shown.input(), shown.solution(), plane_, reference},
              {.line = theme.text(),
               .thin = theme.grid(),
               .text = theme.mutedText(),
               .hole = theme.warning(),
               .slug = theme.colour(Role::CrankWeight),
               .reading = theme.accent(),
               .limit = theme.good(),
               .fits = theme.good(),
               .exceeds = theme.error(),
               .font = small,
               .lineWidth = 1.4});
}

}  // namespace ravnoves
