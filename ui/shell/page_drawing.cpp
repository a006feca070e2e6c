#include "shell/page_drawing.h"

#include <QPainter>
#include <QPicture>
#include <QTabBar>
#include <QTabWidget>

#include "plot/plot_view.h"

namespace ravnoves {

namespace {

/// What of a widget its parents up to the page leave to be seen, in the page.
QRect seenPart(const QWidget* widget, const QWidget* page) {
    QRect rect = widget->rect();
    for (const QWidget* each = widget; each != page; each = each->parentWidget()) {
        rect = rect.translated(each->pos()) & each->parentWidget()->rect();
    }
    return rect;
}

void drawAlone(QPainter& painter, QWidget* widget, QWidget::RenderFlags flags) {
    QPicture picture;
    widget->render(&picture, QPoint(), QRegion(), flags);
    painter.drawPicture(0, 0, picture);
}

void drawTree(QPainter& painter, QWidget* widget, QWidget* page) {
    const QRect seen = seenPart(widget, page);
    if (!widget->isVisible() || seen.isEmpty()) {
        return;
    }
    // A tab in front reaches below its bar, where the page of the tab covers it.
    QTabBar* bar = nullptr;
    if (auto* tabs = qobject_cast<QTabWidget*>(widget)) {
        bar = tabs->tabBar();
        drawTree(painter, bar, page);
    }
    painter.save();
    painter.setClipRect(seen);
    painter.translate(widget->mapTo(page, QPoint()));
    auto* plot = qobject_cast<PlotView*>(widget);
    if (plot != nullptr) {
        plot->renderTo(painter, QRectF(plot->rect()));
    } else {
        drawAlone(painter, widget,
                  widget == page ? QWidget::DrawWindowBackground : QWidget::RenderFlags());
    }
    painter.restore();
    for (QObject* child : plot != nullptr ? QObjectList() : widget->children()) {
        auto* inside = qobject_cast<QWidget*>(child);
        if (inside != nullptr && inside != bar && !inside->isWindow()) {
            drawTree(painter, inside, page);
        }
    }
}

}  // namespace

void drawPage(QPainter& painter, QWidget* page) {
    drawTree(painter, page, page);
}

}  // namespace ravnoves
