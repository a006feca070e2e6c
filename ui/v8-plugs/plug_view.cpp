#include "v8-plugs/plug_view.h"

#include <QPainter>

#include "theme/theme.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/plug_drawing.h"
#include "widgets/figure.h"
#include "widgets/panel.h"

namespace ravnoves {

using namespace v8_plugs;

PlugView::PlugView(V8PlugsModel* model, QWidget* parent) : QWidget(parent), model_(model) {
    setAccessibleName(tr("Plug in section"));
    makeFigure(this);
    setToolTip(
        tr("The plug of sheet 4 to scale, in section, with its sizes; those without a unit are in "
           "millimetres."));
    const auto repaint = [this] { update(); };
    connect(model_, &SceneModel::changed, this, repaint);
    connect(&Theme::instance(), &Theme::changed, this, repaint);
}

void PlugView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const Theme& theme = Theme::instance();
    const QRect title = paintPanel(painter, rect(), tr("Plug"));
    const DrawingStyle style{theme.text(),    theme.mutedText(), theme.text(),
                             theme.warning(), Theme::font(),     1.6};
    const QRectF target(Theme::margin, title.bottom() + Theme::gap, width() - 2 * Theme::margin,
                        height() - title.bottom() - 2 * Theme::gap);
    const Words words;
    const auto drawing = plannedPlug(model_->input(), model_->solution());
    if (!drawing) {
        painter.setFont(Theme::font(Theme::smallSize));
        painter.setPen(theme.mutedText());
        painter.drawText(title, Qt::AlignRight | Qt::AlignVCenter,
                         tr("not to scale: sizes on the sheet “Plug”"));
    }
    drawPlug(painter, target, drawing, style, words);
}

}  // namespace ravnoves
