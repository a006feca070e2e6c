#include "workshop/plugs/plug_view.h"

#include <QPainter>

#include "pictures/figure.h"
#include "text/text_width.h"
#include "theme/theme.h"
#include "widgets/panel.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plugs/plug_drawing.h"

namespace ravnoves {

using namespace v8_plugs;

PlugView::PlugView(WorkshopModel* model, QWidget* parent) : QWidget(parent), model_(model) {
    setAccessibleName(tr("Plug in section"));
    makeFigure(this);
    setToolTip(
        tr("Section of the plug of sheet 4, to scale; sizes without a unit are in millimetres."));
    const auto repaint = [this] { update(); };
    connect(model_, &SceneModel::changed, this, repaint);
    connect(&Theme::instance(), &Theme::changed, this, repaint);
}

void PlugView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const Theme& theme = Theme::instance();
    const QString name = tr("Plug");
    const QRect title = paintPanel(painter, rect(), name);
    const DrawingStyle style{theme.text(),    theme.mutedText(), theme.text(),
                             theme.warning(), Theme::font(),     1.6};
    QRectF target(Theme::margin, title.bottom() + Theme::gap, width() - 2 * Theme::margin,
                  height() - title.bottom() - 2 * Theme::gap);
    const Words words;
    const auto drawing = model_->plugs() != nullptr
                             ? plannedPlug(*model_->plugsInput(), *model_->plugs())
                             : std::nullopt;
    if (!drawing) {
        const QFont small = Theme::font(Theme::smallSize);
        const QString note = tr("not to scale: sizes on the sheet “Plug”");
        const double besideName =
            title.width() - textWidth(Theme::font(Theme::baseSize, true), name) - Theme::margin;
        painter.setFont(small);
        painter.setPen(theme.mutedText());
        if (textWidth(small, note) <= besideName) {
            painter.drawText(title, Qt::AlignRight | Qt::AlignVCenter, note);
        } else {  // below it, in as many lines as it takes
            QRectF taken;
            painter.drawText(target, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, note, &taken);
            target.setTop(taken.bottom() + Theme::gap);
        }
    }
    drawPlug(painter, target, drawing, style, words);
}

}  // namespace ravnoves
