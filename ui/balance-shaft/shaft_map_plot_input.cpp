// Mouse and keys of the map of places.

#include <QHelpEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "balance-shaft/model/shaft_map_text.h"
#include "balance-shaft/shaft_map_plot.h"
#include "numerics/units.h"

namespace ravnoves {

namespace {

constexpr double reach = 13.0;  ///< of the pointer, pixels

}  // namespace

bool ShaftMapPlot::isHandle(const QPointF& pixel) const {
    const QPointF away = pixel - pixelOf(map_->present());
    return std::hypot(away.x(), away.y()) <= reach;
}

const ShaftMapModel::Marker* ShaftMapPlot::markerAt(const QPointF& pixel) const {
    const ShaftMapModel::Marker* found = nullptr;
    double nearest = reach;
    for (const ShaftMapModel::Marker& marker : map_->markers()) {
        const QPointF away = pixel - pixelOf(marker.position);
        if (const double distance = std::hypot(away.x(), away.y()); distance < nearest) {
            nearest = distance;
            found = &marker;
        }
    }
    return found;
}

void ShaftMapPlot::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && isHandle(event->position())) {
        dragging_ = gripped_ = true;
        map_->setHeld(true);
        grip_ = pixelOf(map_->present()) - event->position();
        setCursor(Qt::ClosedHandCursor);
        model_->beginEditing();
        update();
        event->accept();
        return;
    }
    PlotView::mousePressEvent(event);
}

void ShaftMapPlot::mouseMoveEvent(QMouseEvent* event) {
    if (dragging_) {
        const QRectF area = plotArea();
        const QPointF to = event->position() + grip_;
        map_->moveTo(placeAt({std::clamp(to.x(), area.left(), area.right()),
                              std::clamp(to.y(), area.top(), area.bottom())}),
                     ShaftMapModel::Snapped);
        return;
    }
    gripped_ = gripped_ && event->buttons() != Qt::NoButton;
    if (gripped_) {
        return;  // taken back: the hand has not let go yet
    }
    if (event->buttons() != Qt::NoButton) {
        PlotView::mouseMoveEvent(event);
        return;
    }
    QToolTip::hideText();  // of the place before
    setCursor(isHandle(event->position()) ? Qt::OpenHandCursor : Qt::ArrowCursor);
    const bool inside = plotArea().contains(event->position());
    const ShaftMapModel::Marker* marker = inside ? markerAt(event->position()) : nullptr;
    Q_EMIT hovered(!inside ? QString()
                   : marker != nullptr
                       ? shaft_map_text::place(*map_, marker->position)
                       : shaft_map_text::place(*map_, placeAt(event->position()), 1));
}

void ShaftMapPlot::mouseReleaseEvent(QMouseEvent* event) {
    endDrag();
    gripped_ = false;
    PlotView::mouseReleaseEvent(event);
}

void ShaftMapPlot::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !plotArea().contains(event->position())) {
        return;
    }
    endDrag();
    const ShaftMapModel::Marker* marker = markerAt(event->position());
    if (marker != nullptr) {
        map_->goTo(marker->position);
    } else {
        map_->goTo(placeAt(event->position()), ShaftMapModel::Snapped);
    }
}

void ShaftMapPlot::endDrag() {
    if (dragging_) {
        dragging_ = false;
        setCursor(Qt::OpenHandCursor);
        model_->endEditing();
        map_->setHeld(false);
        update();
    }
}

void ShaftMapPlot::keyPressEvent(QKeyEvent* event) {
    const double step =
        (event->modifiers().testFlag(Qt::ShiftModifier) ? 1.0 : 0.1) * units::mm.to_si;
    const auto move = [&](double x, double y) {
        const auto present = map_->present();
        map_->moveTo({present.x + x * step, present.y + y * step}, ShaftMapModel::Keyed);
        Q_EMIT hovered(shaft_map_text::place(*map_, map_->present()));
    };
    const auto choose = [&](std::size_t by) {
        const std::size_t count = map_->markers().size();
        if (count > 0) {
            chosen_ = chosen_ ? (*chosen_ + by) % count : (by == 1 ? 0 : count - 1);
            Q_EMIT hovered(shaft_map_text::place(*map_, map_->markers()[*chosen_].position));
            update();
        }
    };
    switch (event->key()) {
        case Qt::Key_Left:
            move(-1.0, 0.0);
            return;
        case Qt::Key_Right:
            move(1.0, 0.0);
            return;
        case Qt::Key_Up:
            move(0.0, 1.0);
            return;
        case Qt::Key_Down:
            move(0.0, -1.0);
            return;
        case Qt::Key_PageDown:
            choose(1);
            return;
        case Qt::Key_PageUp:
            choose(std::max<std::size_t>(map_->markers().size(), 1) - 1);
            return;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (chosen_ && *chosen_ < map_->markers().size()) {
                map_->goTo(map_->markers()[*chosen_].position);
            }
            return;
        case Qt::Key_Escape:
            if (dragging_) {
                model_->takeBack();
                endDrag();
                Q_EMIT hovered(shaft_map_text::place(*map_, map_->present()));
                return;
            }
            if (chosen_) {
                chosen_.reset();
                Q_EMIT hovered({});
                update();
                return;
            }
            break;
        default:
            break;
    }
    PlotView::keyPressEvent(event);
}

bool ShaftMapPlot::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const QPointF at = help->pos();
        if (plotArea().contains(at)) {
            // Over the map only what there is to say of the place: how to use it is beside.
            QToolTip::showText(help->globalPos(), shaft_map_text::reason(*map_, placeAt(at)), this);
            return true;
        }
    }
    return PlotView::event(event);
}

void ShaftMapPlot::stopReading() {
    Q_EMIT hovered({});
    PlotView::stopReading();
}

void ShaftMapPlot::focusOutEvent(QFocusEvent* event) {
    endDrag();
    model_->finishDrag();
    PlotView::focusOutEvent(event);
}

void ShaftMapPlot::hideEvent(QHideEvent* event) {
    endDrag();
    PlotView::hideEvent(event);
}

}  // namespace ravnoves
