#include <QAbstractScrollArea>
#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScrollBar>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "pictures/wheel_guard.h"
#include "plot/plot_view.h"
#include "text/text_width.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

constexpr double zoomPerStep = 1.2;

}  // namespace

const PlotScale* PlotView::axisAt(const QPoint& at) const {
    const QRectF area = plotArea();
    return at.y() > area.bottom() ? &data_.x : at.x() < area.left() ? &data_.left : nullptr;
}

bool PlotView::event(QEvent* event) {
    // The title of an axis that has too little room is whole in its tip.
    const auto* asked =
        event->type() == QEvent::ToolTip ? static_cast<QHelpEvent*>(event) : nullptr;
    const PlotScale* axis = asked != nullptr ? axisAt(asked->pos()) : nullptr;
    if (axis != nullptr && textWidth(Theme::font(Theme::smallSize), axis->spec.title) >
                               (axis == &data_.x ? data_.flatRoom : data_.uprightRoom)) {
        QToolTip::showText(asked->globalPos(), axis->spec.title, this);
        return true;
    }
    return QWidget::event(event);
}

void PlotView::mousePressEvent(QMouseEvent* event) {
    const bool inside = plotArea().contains(event->position());
    if (inside && pickable_ && event->button() == Qt::LeftButton &&
        !event->modifiers().testFlag(Qt::ShiftModifier)) {
        picking_ = true;
        pickedFrom_ = data_.presentX;
        pick(event->position());
    } else if (inside &&
               (event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton)) {
        panFrom_ = event->position();
    }
    event->accept();
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    QToolTip::hideText();  // it would lie over what is read now
    if (picking_) {
        pick(event->position());
        moveCursor(event->position());  // what is read goes with the hand
        return;
    }
    if (panFrom_) {
        const QPointF moved = event->position() - *panFrom_;
        if (data_.zoomed || moved.manhattanLength() > QApplication::startDragDistance()) {
            data_.pan(moved);
            readPoint(std::nullopt);
            setCursorX({});
            chartChanged();
            panFrom_ = event->position();
        }
        return;
    }
    moveCursor(event->position());
}

void PlotView::mouseReleaseEvent(QMouseEvent* event) {
    picking_ = false;
    panFrom_.reset();
    moveCursor(event->position());
}

void PlotView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (pickable_ && !data_.zoomed) {
        mousePressEvent(event);
        return;
    }
    if (pickable_ && pickedFrom_) {
        Q_EMIT picked(*pickedFrom_);  // the first of the two clicks was not meant to choose
    }
    resetZoom();
}

void PlotView::pick(const QPointF& position) {
    const double x = std::clamp(xAt(position.x()), data_.x.low, data_.x.high);
    Q_EMIT picked(x);
    Q_EMIT pickedAt(x, std::clamp(yAt(position.y()), data_.left.low, data_.left.high));
}

void PlotView::readPoint(const std::optional<PlotData::Point>& point) {
    overlay(data_.pointRead, point, data_.pointRead != point);
}

void PlotView::moveCursor(const QPointF& position) {
    if (!readsUnderPointer()) {
        return;
    }
    if (data_.readsPoints()) {
        readPoint(data_.nearestPoint(position));
    } else if (plotArea().contains(position)) {
        moveCursorTo(xAt(position.x()));
    } else {
        setCursorX({});
    }
}

void PlotView::moveCursorTo(double x) {
    setCursorX(x);
    Q_EMIT cursorMoved(x);
}

void PlotView::stopReading() {
    readPoint(std::nullopt);
    setCursorX({});
}

void PlotView::leaveEvent(QEvent* /*event*/) {
    stopReading();
}

bool PlotView::scrollsWithin() const {
    for (const QWidget* above = parentWidget(); above != nullptr; above = above->parentWidget()) {
        const auto* area = qobject_cast<const QAbstractScrollArea*>(above);
        if (area != nullptr && area->verticalScrollBar()->maximum() > 0) {
            return true;
        }
    }
    return false;
}

void PlotView::wheelEvent(QWheelEvent* event) {
    // A page that is scrolled goes on where a plot comes under the pointer.
    if (event->modifiers() == Qt::NoModifier && !isWheelOf(this) && scrollsWithin()) {
        stopReading();  // the plot goes away from under the pointer
        event->ignore();
        return;
    }
    // Alt and some desktops turn the wheel sideways: either axis counts.
    const double turned =
        event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
    const double factor = std::pow(zoomPerStep, -turned / 120.0);
    const bool onlyY = event->modifiers().testFlag(Qt::ShiftModifier);
    const bool onlyX = event->modifiers().testFlag(Qt::ControlModifier);
    zoom(onlyY ? 1.0 : factor, onlyX ? 1.0 : factor, event->position());
    event->accept();
}

void PlotView::zoom(double factorX, double factorY, const QPointF& about) {
    data_.zoom(factorX, factorY, about);
    chartChanged();
}

void PlotView::keyPressEvent(QKeyEvent* event) {
    const QPointF middle = plotArea().center();
    switch (event->key()) {
        case Qt::Key_Plus:
        case Qt::Key_Equal:
            zoom(1 / zoomPerStep, 1 / zoomPerStep, middle);
            return;
        case Qt::Key_Minus:
            zoom(zoomPerStep, zoomPerStep, middle);
            return;
        case Qt::Key_0:
        case Qt::Key_Home:
        case Qt::Key_Escape:
            resetZoom();
            return;
        case Qt::Key_Left:
        case Qt::Key_Right: {
            const int by = event->key() == Qt::Key_Left ? -1 : 1;
            const PlotScale& scale = data_.x;
            if (data_.readsPoints()) {
                readPoint(data_.nextPoint(by));
                return;
            }
            const double from = data_.cursorX.value_or(data_.presentX.value_or(scale.value(0.5)));
            moveCursorTo(scale.value(std::clamp(scale.fraction(from) + 0.01 * by, 0.0, 1.0)));
            return;
        }
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (pickable_ && data_.cursorX) {
                Q_EMIT picked(*data_.cursorX);
                return;
            }
            break;
        default:
            break;
    }
    QWidget::keyPressEvent(event);
}

}  // namespace ravnoves
