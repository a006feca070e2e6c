#include "report/figure_drawings.h"

#include <QApplication>
#include <QPicture>
#include <QPointer>
#include <QResizeEvent>
#include <QStackedWidget>
#include <algorithm>

#include "pictures/figure.h"
#include "plot/plot_view.h"
#include "report/report_words.h"

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

/// The picture laid out at a size and drawn at another, as large as its shape allows, in the
/// middle.
Drawing drawn(QWidget* picture, const QSize& laidOut, const QSize& size) {
    return {picture->accessibleName(), picture->accessibleDescription(), size,
            [picture = QPointer(picture), laidOut, size](QPainter& painter) {
                if (picture) {
                    drawAt(picture, laidOut, [&] {
                        QRectF room(QPointF(),
                                    QSizeF(picture->size()).scaled(size, Qt::KeepAspectRatio));
                        room.moveCenter(QRectF(QPointF(), size).center());
                        drawFigure(picture, painter, room);
                    });
                }
            }};
}

}  // namespace

Drawing drawingOf(PlotView* plot) {
    // As high as it is on the page, within reason.
    const double shape = static_cast<double>(plot->height()) / std::max(plot->width(), 1);
    constexpr double narrow = 0.62;  // on the page it shares its row
    const int width = shape < narrow ? figureWidth : narrowWidth;
    const QSize size(width, std::clamp(static_cast<int>(width * shape), 270, 430));
    return {plot->isZoomed() ? ReportWords::tr("A section: the plot is zoomed.") : QString(),
            plot->accessibleDescription().isEmpty() ? plot->title() : plot->accessibleDescription(),
            size, [plot = QPointer(plot), size](QPainter& painter) {
                if (plot) {
                    drawAt(plot, size,
                           [&] { plot->renderTo(painter, QRectF(QPointF(), QSizeF(size))); });
                }
            }};
}

Drawing drawingOf(const std::shared_ptr<PlotView>& plot) {
    const QSize size = plot->size();
    return {{},
            plot->accessibleDescription().isEmpty() ? plot->title() : plot->accessibleDescription(),
            size,
            [plot, size](QPainter& painter) {
                plot->renderTo(painter, QRectF(QPointF(), QSizeF(size)));
            }};
}

Drawing drawingOf(QWidget* picture) {
    if (!picture->isVisible()) {
        layOut(picture);
    }
    // Its letters are those of a window: of 11 pixels, on paper at least 6 pt and at most 12.
    constexpr double smaller = 0.73;
    constexpr double larger = 1.4;
    const QSize own = picture->size();
    const QSize laidOut = own.scaled((maxOfPicture / smaller).boundedTo(own), Qt::KeepAspectRatio);
    return drawn(picture, laidOut,
                 laidOut.scaled(maxOfPicture.boundedTo(larger * laidOut), Qt::KeepAspectRatio));
}

Drawing drawingOf(QWidget* picture, const QSize& size) {
    return drawn(picture, size, size);
}

}  // namespace ravnoves
