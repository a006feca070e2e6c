#include "balance-shaft/shaft_map_plot.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "balance-shaft/change_colours.h"
#include "balance-shaft/shaft_map_drawing.h"
#include "model/reference_case.h"
#include "numerics/units.h"
#include "pictures/figure.h"
#include "plot/plot_painter.h"
#include "text/number_text.h"
#include "theme/theme.h"

namespace ravnoves {

ShaftMapPlot::ShaftMapPlot(BalanceShaftModel* model, QWidget* parent)
    : PartPlot(model, "places", parent), model_(model), map_(model->shaftMap()) {
    setObjectName(QStringLiteral("shaft_map"));
    setToolTip(
        tr("Front view to scale; thick line: no change; hatched: does not fit. Drag the shaft, or "
           "double-click its new place (0.5 mm, 0.5°)."));
    setStatusTip(
        tr("Drag the shaft, or double-click its new place. The sliders of l and α move it "
           "by keys."));
    setPaintsGhosts();
    connect(map_, &ShaftMapModel::mapChanged, this, &ShaftMapPlot::showImage);
    connect(map_, &ShaftMapModel::staleChanged, this, [this] {
        overCurvesChanged();
        setFaded(map_->isStale());
    });
    connect(map_, &ShaftMapModel::moved, this, qOverload<>(&QWidget::update));
    connect(model_->crank(), &CrankAngle::changed, this, &ShaftMapPlot::overCurvesChanged);
    connect(&Theme::instance(), &Theme::changed, this, &ShaftMapPlot::showImage);
    setFaded(map_->isStale());
    showImage();
}

QPointF ShaftMapPlot::pixelOf(const ShaftMapModel::Position& position) const {
    return frameOf(*this).at(position);
}

ShaftMapModel::Position ShaftMapPlot::placeAt(const QPointF& pixel) const {
    return {xAt(pixel.x()) * units::mm, yAt(pixel.y()) * units::mm};
}

QString ShaftMapPlot::csv(const CsvFormat& format) const {
    return map_->fieldCsv(format);
}

void ShaftMapPlot::showImage() {
    const ChangeContours& field = map_->field();
    setImage(field.changes.empty() ? QImage() : changeImage(field), field.where);
}

// The reference.

const ShaftMapModel* ShaftMapPlot::referenceMap() const {
    const BalanceShaftModel* other = referenceOf(model_);
    return other != nullptr && data().referenceShown ? other->shaftMap() : nullptr;
}

double ShaftMapPlot::keyHeight() const {
    return map_->field().levels.empty() ? 0.0 : changeKeyHeight();
}

// What rests.

void ShaftMapPlot::paintGround(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    if (!map_->field().levels.empty()) {
        paintChangeKey(painter, map_->field().levels, QPointF(Theme::margin, keyTop()),
                       width() - 2.0 * Theme::margin);
    }
    if (map_->map() == nullptr) {
        return;
    }
    painter.save();
    painter.setClipRect(plotArea());
    drawBlocked(painter, map_->map()->blocked, *this);
    drawLimits(painter, model_->input().place_limits, *this);
    if (const ShaftMapModel* other = referenceMap()) {
        drawReference(painter, *other, *this);
    }
    drawContours(painter, map_->field(), *this);
    painter.restore();
}

void ShaftMapPlot::paintOverCurves(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(plotArea());
    drawEngine(painter, *model_, *this);
    if (isFaded()) {
        // The numbers are old; that newer ones come stands where they do not meet the drawing.
        painter.setFont(Theme::font(Theme::baseSize));
        painter.setPen(Theme::instance().text());
        painter.drawText(plotArea().adjusted(Theme::space, Theme::space, -Theme::space, 0),
                         Qt::AlignTop | Qt::AlignRight, tr("computing…"));
    }
    painter.restore();
}

// What moves.

void ShaftMapPlot::paintTop(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(plotArea());
    drawShaft(painter, *model_, *map_, referenceMap(), *this);
    if (dragging_) {
        paintChange(painter);
    }
    painter.restore();
}

void ShaftMapPlot::paintChange(QPainter& painter) const {
    const ShaftMap* map = map_->map();
    const auto change =
        map != nullptr ? map_->change(map->study.at(map_->present())) : std::nullopt;
    if (!change) {
        return;
    }
    const Theme& theme = Theme::instance();
    painter.setFont(Theme::font(Theme::smallSize, true));
    const QPointF axis = pixelOf(map_->present());
    const QString text = signedPercentText(*change, 2);
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(text) + 12.0, metrics.height() + 4.0);
    QRectF box(axis + QPointF(12.0, -8.0 - size.height()), size);
    if (box.right() > plotArea().right()) {
        box.moveRight(axis.x() - 12.0);
    }
    box.moveTop(std::max(box.top(), plotArea().top() + 2.0));
    painter.setPen(QPen(theme.border(), 1.0));
    painter.setBrush(faint(theme.panel(), 0.93));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(theme.text());
    painter.drawText(box, Qt::AlignCenter, text);
}

// Mouse and keys.

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
    Q_EMIT hovered(!inside             ? QString()
                   : marker != nullptr ? map_->placeText(marker->position)
                                       : map_->placeText(placeAt(event->position()), 1));
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
    if (event->key() == Qt::Key_Escape && dragging_) {
        model_->takeBack();
        endDrag();
        Q_EMIT hovered(map_->placeText(map_->present()));
        return;
    }
    PlotView::keyPressEvent(event);
}

bool ShaftMapPlot::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const QPointF at = help->pos();
        if (plotArea().contains(at)) {
            // Over the map only what there is to say of the place: how to use it is beside.
            QToolTip::showText(help->globalPos(), map_->reasonAt(placeAt(at)), this);
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
    PlotView::focusOutEvent(event);
}

void ShaftMapPlot::hideEvent(QHideEvent* event) {
    endDrag();
    PlotView::hideEvent(event);
}

}  // namespace ravnoves
