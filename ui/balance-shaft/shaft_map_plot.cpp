#include "balance-shaft/shaft_map_plot.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <QTransform>
#include <algorithm>
#include <cmath>
#include <utility>

#include "balance-shaft/solver.h"
#include "numerics/constants.h"
#include "numerics/units.h"
#include "pictures/figure.h"
#include "pictures/model/pixel.h"
#include "pictures/model/shape.h"
#include "pictures/model/stroke.h"
#include "plot/plot_painter.h"
#include "theme/theme.h"

namespace ravnoves {

using painter_parts::veil;

namespace {

constexpr double handleRadius = 6.5;  ///< of the shaft's axis, by which it is dragged; pixels

/// A circle that may be far larger than the map: a disc would measure every pixel inside.
void drawCircle(QPainter& painter, const QPointF& middle, double radius) {
    constexpr int chords = 720;
    QPolygonF circle;
    circle.reserve(chords + 1);
    for (int i = 0; i <= chords; ++i) {
        const double angle = two_pi * i / chords;
        circle << middle + radius * QPointF(std::cos(angle), std::sin(angle));
    }
    paintLine(painter, circle);
}

}  // namespace

ShaftMapPlot::ShaftMapPlot(BalanceShaftModel* model, QWidget* parent)
    : ChangeMapPlot(model, "places", Theme::margin, parent),
      model_(model),
      map_(model->shaftMap()) {
    setObjectName(QStringLiteral("shaft_map"));
    setToolTip(
        tr("Front view to scale; thick line: no change; hatched: does not fit. Drag the shaft, or "
           "double-click its new place (0.5 mm, 0.5°)."));
    setStatusTip(
        tr("Drag the shaft, or double-click its new place. The sliders of l and α move it "
           "by keys."));
    connect(map_, &ShaftMapModel::mapChanged, this, &ShaftMapPlot::showField);
    connect(map_, &ShaftMapModel::staleChanged, this, [this] {
        overCurvesChanged();
        setFaded(map_->isStale());
    });
    connect(map_, &ShaftMapModel::moved, this, qOverload<>(&QWidget::update));
    connect(model_->crank(), &CrankAngle::changed, this, &ShaftMapPlot::overCurvesChanged);
    setFaded(map_->isStale());
    showField();
}

QPointF ShaftMapPlot::pixelOf(const ShaftMapModel::Position& position) const {
    return frame().at(position);
}

ShaftMapModel::Position ShaftMapPlot::placeAt(const QPointF& pixel) const {
    return {xAt(pixel.x()) * units::mm, yAt(pixel.y()) * units::mm};
}

QString ShaftMapPlot::csv(const CsvFormat& format) const {
    return map_->fieldCsv(format);
}

// What rests.

void ShaftMapPlot::paintOnField(QPainter& painter) {
    if (map_->map() != nullptr) {
        paintBlocked(painter);
        paintLimits(painter);
    }
}

void ShaftMapPlot::paintOverCurves(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(plotArea());
    paintEngine(painter);
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
    paintShaft(painter);
    painter.restore();
}

drawing::Frame ShaftMapPlot::frame() const {
    const QPointF origin = toPixel(0.0, 0.0);
    return {origin, (toPixel(1.0, 0.0).x() - origin.x()) / units::mm.to_si};
}

void ShaftMapPlot::paintBlocked(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const drawing::Frame to = frame();
    const double k = to.pixelsPerUnit;
    const QTransform inPixels(k, 0.0, 0.0, -k, to.origin.x(), to.origin.y());
    QPainterPath path;
    LinesOfPen edges{QPen(veil(theme.text(), 0.7F), 1.0), {}};
    for (const QPolygonF& line : map_->map()->blocked) {
        QPolygonF edge = inPixels.map(line);
        path.addPolygon(edge);
        path.closeSubpath();
        // Round its corners, the first of them, too.
        edge << edge.value(0) << edge.value(1);
        edges.lines.push_back(std::move(edge));
    }
    if (path.isEmpty()) {
        return;
    }
    constexpr double apart = 7.0;  // lines of the hatch, pixels
    painter.fillPath(path, veil(theme.panel(), 0.38F));
    // Lines at 45° need no smoothing, which takes most of a turn of the wheel.
    const bool onPixels = paintsPixels(painter);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, !onPixels);
    painter.setPen(QPen(veil(theme.text(), 0.3F), onPixels ? 0.0 : 1.0));
    for (const QPolygonF& line : hatchLines(path, plotArea(), apart, 1.0)) {
        painter.drawPolyline(line);
    }
    painter.restore();
    paintLines(painter, {edges});
}

void ShaftMapPlot::paintLimits(QPainter& painter) const {
    const balance_shaft::PlaceLimits& limits = model_->input().place_limits;
    const drawing::Frame frame = this->frame();
    const QRectF area = plotArea();
    QPen pen(Theme::instance().error(), 1.4);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen);
    for (const auto& x : {limits.left, limits.right}) {
        if (x) {
            const double at = frame.at(*x, 0.0).x();
            painter.drawLine(QPointF(at, area.top()), QPointF(at, area.bottom()));
        }
    }
    for (const auto& y : {limits.bottom, limits.top}) {
        if (y) {
            const double at = frame.at(0.0, *y).y();
            painter.drawLine(QPointF(area.left(), at), QPointF(area.right(), at));
        }
    }
    const QPointF crank = frame.at(0.0, 0.0);
    for (const auto& distance : {limits.centre_distance_min, limits.centre_distance_max}) {
        if (distance) {
            drawCircle(painter, crank, frame.length(*distance));
        }
    }
    pen.setStyle(Qt::DashLine);
    painter.setPen(pen);
    const double far = area.width() + area.height();
    for (const auto& angle : {limits.shaft_angle_from, limits.shaft_angle_to}) {
        if (angle) {
            painter.drawLine(crank, crank + far * QPointF(std::sin(*angle), -std::cos(*angle)));
        }
    }
}

void ShaftMapPlot::paintEngine(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const balance_shaft::FrontView& sizes = model_->solver().front_view();
    const auto pose = balance_shaft::mechanism_pose(
        model_->solver(), model_->crank()->degrees() * degree, model_->input().shaft_angle);
    const drawing::Frame frame = this->frame();
    const double k = frame.pixelsPerUnit;
    const QColor line = veil(theme.text(), 0.75F);
    const QColor metal = veil(drawing::metal(), 0.72F);
    const QPointF crank = frame.at(0, 0);
    const QPointF pin = frame.at(pose.crankpin);
    const QPointF piston = frame.at(pose.piston_pin);

    const double e = sizes.offset;
    const double bore = sizes.cylinder_bore;
    const double wall = std::max(sizes.cylinder_wall, 2.0 / k);
    painter.setPen(QPen(line, 1.1));
    painter.setBrush(metal);
    for (const double side : {-1.0, 1.0}) {
        paintBlock(painter,
                   QRectF(frame.at(e + side * bore / 2, sizes.cylinder_top),
                          frame.at(e + side * (bore / 2 + wall), sizes.cylinder_bottom)),
                   0.0);
    }
    const double height = 0.75 * bore;
    const double top = std::min(pose.piston_pin.y + 0.45 * height, sizes.cylinder_top);
    painter.setBrush(veil(drawing::brightMetal(), 0.72F));
    paintBlock(painter, QRectF(frame.at(e - bore / 2, top), frame.at(e + bore / 2, top - height)),
               3.0);
    painter.setPen(QPen(line, 1.0));
    painter.setBrush(Qt::NoBrush);
    drawCircle(painter, crank, frame.length(sizes.crank_swing_radius));
    const double thick = std::clamp(0.3 * sizes.crank_radius * k, 4.0, 14.0);
    drawing::drawRod(painter, pin, piston, 0.6 * thick, metal, line);
    drawing::drawRod(painter, crank, pin, thick, metal, line);
    painter.setPen(QPen(line, 1.1));
    painter.setBrush(theme.panel());
    for (const QPointF& joint : {crank, pin, piston}) {
        paintDisc(painter, joint, 0.24 * thick + 1.5);
    }
}

void ShaftMapPlot::paintShaft(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const balance_shaft::FrontView& sizes = model_->solver().front_view();
    const auto present = map_->present();
    const drawing::Frame frame = this->frame();
    const QPointF crank = frame.at(0.0, 0.0);
    const QPointF axis = frame.at(present);
    const bool canBeBuilt =
        map_->map() != nullptr ? map_->isBuildable(present) : model_->result().is_buildable;
    const QColor colour = canBeBuilt ? theme.accent() : theme.error();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.accent(), 1.4));
    drawCircle(painter, crank, frame.length(present.centre_distance()));
    painter.setPen(QPen(veil(theme.text(), 0.6F), 1.0, Qt::DashDotLine));
    painter.drawLine(crank, axis);
    const double swing = frame.length(sizes.shaft_swing_radius);
    painter.setPen(QPen(colour, 1.2));
    painter.setBrush(veil(colour, 0.1F));
    paintDisc(painter, axis, swing);
    painter.setPen(QPen(theme.panel(), 1.6));
    painter.setBrush(colour);
    paintDisc(painter, axis, handleRadius);
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
