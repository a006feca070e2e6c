#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "plot/plot_view_parts.h"

namespace ravnoves {

using plot::zoomPerStep;

void PlotView::mousePressEvent(QMouseEvent* event) {
    const bool inside = plotArea().contains(event->position());
    if (inside && pickable_ && event->button() == Qt::LeftButton &&
        !event->modifiers().testFlag(Qt::ShiftModifier)) {
        picking_ = true;
        pick(event->position());
    } else if (inside &&
               (event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton)) {
        panFrom_ = event->position();
    }
    event->accept();
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    if (picking_) {
        pick(event->position());
        return;
    }
    if (panFrom_) {
        const QPointF moved = event->position() - *panFrom_;
        if (zoomed_ || moved.manhattanLength() > QApplication::startDragDistance()) {
            pan(moved);
            panFrom_ = event->position();
        }
        return;
    }
    moveCursor(event->position());
}

void PlotView::mouseReleaseEvent(QMouseEvent* /*event*/) {
    picking_ = false;
    panFrom_.reset();
}

void PlotView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (pickable_) {
        mousePressEvent(event);
    } else {
        resetZoom();
    }
}

void PlotView::pick(const QPointF& position) {
    const double x = std::clamp(xAt(position.x()), x_->low, x_->high);
    Q_EMIT picked(x);
    Q_EMIT pickedAt(x, std::clamp(yAt(position.y()), left_->low, left_->high));
}

bool PlotView::readsPoints() const {
    return std::any_of(curves_.begin(), curves_.end(),
                       [](const auto& curve) { return !curve->texts.isEmpty(); });
}

void PlotView::readPointNear(const QPointF& position) {
    constexpr double reach = 14.0;
    std::optional<std::pair<std::size_t, std::size_t>> nearest;
    double least = reach;
    for (std::size_t c = 0; c < curves_.size(); ++c) {
        const Curve& curve = *curves_[c];
        const bool readable =
            curve.shown && curve.texts.size() == static_cast<qsizetype>(curve.x.size());
        for (std::size_t i = 0; readable && i < curve.x.size(); ++i) {
            const QPointF away = toPixel(curve.x[i], curve.y[i], curve.style.side) - position;
            const double distance = std::hypot(away.x(), away.y());
            if (distance < least) {
                least = distance;
                nearest = std::pair(c, i);
            }
        }
    }
    if (nearest != pointRead_) {
        pointRead_ = nearest;
        update();
    }
}

void PlotView::stepPoint(int by) {
    std::vector<std::pair<std::size_t, std::size_t>> points;
    for (std::size_t c = 0; c < curves_.size(); ++c) {
        const Curve& curve = *curves_[c];
        if (curve.shown && curve.texts.size() == static_cast<qsizetype>(curve.x.size())) {
            for (std::size_t i = 0; i < curve.x.size(); ++i) {
                points.emplace_back(c, i);
            }
        }
    }
    if (points.empty()) {
        return;
    }
    const auto count = static_cast<std::ptrdiff_t>(points.size());
    std::ptrdiff_t next = by > 0 ? 0 : count - 1;
    if (pointRead_) {
        const auto found = std::find(points.begin(), points.end(), *pointRead_);
        next = (found - points.begin() + by + count) % count;
    }
    pointRead_ = points[static_cast<std::size_t>(next)];
    update();
}

void PlotView::moveCursor(const QPointF& position) {
    if (readsPoints()) {
        readPointNear(position);
        return;
    }
    if (!plotArea().contains(position)) {
        if (cursorX_) {
            setCursorX(std::nullopt);
            Q_EMIT cursorLeft();
        }
        return;
    }
    const double x = xAt(position.x());
    setCursorX(x);
    Q_EMIT cursorMoved(x);
}

void PlotView::leaveEvent(QEvent* /*event*/) {
    if (pointRead_) {
        pointRead_.reset();
        update();
    }
    if (cursorX_) {
        setCursorX(std::nullopt);
        Q_EMIT cursorLeft();
    }
}

void PlotView::wheelEvent(QWheelEvent* event) {
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
    const QRectF area = plotArea();
    if (area.isEmpty()) {
        return;
    }
    if (equalScale_) {
        factorY = factorX = factorX == 1.0 ? factorY : factorX;
    }
    const auto scale = [](AxisState& state, double factor, double fraction) {
        constexpr double narrowest = 1e-9;
        const double low = state.value(fraction * (1.0 - factor));
        const double high = state.value(fraction + (1.0 - fraction) * factor);
        const double size = std::max({std::abs(low), std::abs(high), 1e-12});
        if (std::isfinite(low) && std::isfinite(high) && high - low > narrowest * size &&
            std::abs(high) < 1e15 && std::abs(low) < 1e15) {
            state.low = low;
            state.high = high;
        }
    };
    const double fx = std::clamp((about.x() - area.left()) / area.width(), 0.0, 1.0);
    const double fy = std::clamp((area.bottom() - about.y()) / area.height(), 0.0, 1.0);
    zoomed_ = true;
    scale(*x_, factorX, fx);
    scale(*left_, factorY, fy);
    scale(*right_, factorY, fy);
    seriesStale_ = true;
    chartChanged();
}

void PlotView::pan(const QPointF& pixels) {
    const QRectF area = plotArea();
    const auto shift = [](AxisState& state, double fraction) {
        const double low = state.value(fraction);
        const double high = state.value(1.0 + fraction);
        state.low = low;
        state.high = high;
    };
    zoomed_ = true;
    shift(*x_, -pixels.x() / area.width());
    shift(*left_, pixels.y() / area.height());
    shift(*right_, pixels.y() / area.height());
    seriesStale_ = true;
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
            if (readsPoints()) {
                stepPoint(by);
                return;
            }
            const double from = cursorX_.value_or(presentX_.value_or(x_->value(0.5)));
            const double to = x_->value(std::clamp(x_->fraction(from) + 0.01 * by, 0.0, 1.0));
            setCursorX(to);
            Q_EMIT cursorMoved(to);
            return;
        }
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (pickable_ && cursorX_) {
                Q_EMIT picked(*cursorX_);
                return;
            }
            break;
        default:
            break;
    }
    QWidget::keyPressEvent(event);
}

void PlotView::contextMenuEvent(QContextMenuEvent* event) {
    QMenu menu(this);
    menu.addAction(tr("Reset zoom"), this, &PlotView::resetZoom);
    menu.addSeparator();
    menu.addAction(tr("Copy data as CSV"), this,
                   [this] { QApplication::clipboard()->setText(dataAsCsv()); });
    menu.addAction(tr("Copy picture"), this, [this] {
        QImage image(size() * 2, QImage::Format_RGB32);
        QPainter painter(&image);
        renderTo(painter, QRectF(QPointF(), QSizeF(image.size())));
        painter.end();
        QApplication::clipboard()->setImage(image);
    });
    menu.addAction(tr("Save picture…"), this, [this] {
        const QString path = QFileDialog::getSaveFileName(
            this, tr("Save picture"), QString(), tr("PNG picture (*.png);;SVG drawing (*.svg)"));
        if (path.isEmpty()) {
            return;
        }
        const QString trouble = exportPicture(path);
        if (!trouble.isEmpty()) {
            QMessageBox::warning(this, tr("Save picture"), trouble);
        }
    });
    menu.exec(event->globalPos());
}

}  // namespace ravnoves
