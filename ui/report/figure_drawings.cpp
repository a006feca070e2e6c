#include "report/figure_drawings.h"

#include <QApplication>
#include <QPicture>
#include <QPointer>
#include <QResizeEvent>
#include <QStackedWidget>
#include <algorithm>

#include "pictures/figure.h"
#include "plot/plot_view.h"
#include "report/sections.h"

namespace ravnoves {

using namespace paper;

namespace {

constexpr int figureWidth = 660;  ///< pixels, of a plot
constexpr int narrowWidth = 480;  ///< of one that is high
constexpr QSize maxOfPicture(660, 230);

/// Draws with the widget at another size, then gives it back its own. A hidden widget hears of a
/// size only when it is shown: it is told.
template <typename Draw>
void drawAt(QWidget* widget, const QSize& size, Draw&& draw) {
    const auto resize = [widget](const QSize& to) {
        const QSize from = widget->size();
        if (from != to) {
            widget->resize(to);
            if (!widget->isVisible()) {
                QResizeEvent event(to, from);
                QCoreApplication::sendEvent(widget, &event);
            }
        }
    };
    const QSize own = widget->size();
    resize(size);
    draw();
    resize(own);
}

/// A picture that is not seen has its place only now; a page behind another one has no size.
void layOut(QWidget* picture) {
    QWidgetList pages;
    for (QWidget* each = picture; each->parentWidget() != nullptr; each = each->parentWidget()) {
        if (qobject_cast<QStackedWidget*>(each->parentWidget()) != nullptr) {
            pages.prepend(each);
        }
    }
    constexpr int rounds = 4;  // what scrolls, or is as high as its width asks for, follows later
    for (int round = 0; round < rounds; ++round) {
        for (QWidget* page : pages) {
            page->resize(page->parentWidget()->size());
        }
        QPicture nothing;
        picture->render(&nothing);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    }
}

QString descriptionOf(const QWidget& figure) {
    const QString description = figure.accessibleDescription();
    return description.isEmpty() ? figure.accessibleName() : description;
}

void drawInto(QWidget* figure, QPainter& painter, const QRectF& room) {
    if (auto* plot = qobject_cast<PlotView*>(figure)) {
        plot->renderTo(painter, room);
    } else {
        drawFigure(figure, painter, room);
    }
}

/// The figure laid out at a size and drawn at another, as large as its shape allows, in the middle.
Drawing drawn(QWidget* figure, const QSize& laidOut, const QSize& size) {
    const auto* plot = qobject_cast<const PlotView*>(figure);
    const QString caption = plot == nullptr    ? figure->accessibleName()
                            : plot->isZoomed() ? ReportWords::tr("A section: the plot is zoomed.")
                                               : QString();
    return {caption, descriptionOf(*figure), size,
            [figure = QPointer(figure), laidOut, size](QPainter& painter) {
                if (figure) {
                    drawAt(figure, laidOut, [&] {
                        QRectF room(QPointF(),
                                    QSizeF(figure->size()).scaled(size, Qt::KeepAspectRatio));
                        room.moveCenter(QRectF(QPointF(), size).center());
                        drawInto(figure, painter, room);
                    });
                }
            }};
}

}  // namespace

Drawing drawingOf(const std::shared_ptr<QWidget>& figure) {
    return {{}, descriptionOf(*figure), figure->size(), [figure](QPainter& painter) {
                drawInto(figure.get(), painter, QRectF(QPointF(), figure->size()));
            }};
}

Drawing drawingOf(QWidget* figure) {
    if (qobject_cast<PlotView*>(figure) != nullptr) {
        // As high as it is on the page, within reason.
        const double shape = static_cast<double>(figure->height()) / std::max(figure->width(), 1);
        constexpr double narrow = 0.62;  // on the page it shares its row
        const int width = shape < narrow ? figureWidth : narrowWidth;
        const QSize size(width, std::clamp(static_cast<int>(width * shape), 270, 430));
        return drawn(figure, size, size);
    }
    if (!figure->isVisible()) {
        layOut(figure);
    }
    // Its letters are those of a window: of 11 pixels, on paper at least 6 pt and at most 12.
    constexpr double smaller = 0.73;
    constexpr double larger = 1.4;
    const QSize own = figure->size();
    const QSize laidOut = own.scaled((maxOfPicture / smaller).boundedTo(own), Qt::KeepAspectRatio);
    return drawn(figure, laidOut,
                 laidOut.scaled(maxOfPicture.boundedTo(larger * laidOut), Qt::KeepAspectRatio));
}

}  // namespace ravnoves
