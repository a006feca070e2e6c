#include "balance-shaft/shaft_map_plot.h"

#include <QPainter>
#include <algorithm>

#include "balance-shaft/change_colours.h"
#include "balance-shaft/model/shaft_map_text.h"
#include "balance-shaft/shaft_map_drawing.h"
#include "model/reference_case.h"
#include "numerics/units.h"
#include "pictures/picture_file.h"
#include "plot/plot_painter.h"
#include "text/number_text.h"
#include "theme/theme.h"

namespace ravnoves {

ShaftMapPlot::ShaftMapPlot(BalanceShaftModel* model, QWidget* parent)
    : PartPlot(model, "places", parent), model_(model), map_(model->shaftMap()) {
    setObjectName(QStringLiteral("shaft_map"));
    setToolTip(
        tr("Front view to scale; thick line: no change; hatched: does not fit. Drag the shaft (0.5 "
           "mm, 0.5°) or use arrow "
           "keys (0.1 mm, Shift 1 mm); double-click or select a marker (Page Up, Page Down) and "
           "press Enter to move."));
    setStatusTip(
        tr("Drag the shaft, or double-click its new place. Arrow keys: 0.1 mm, with Shift 1 mm."));
    setPaintsGhosts();
    connect(map_, &ShaftMapModel::mapChanged, this, [this] {
        chosen_.reset();
        showImage();
    });
    connect(map_, &ShaftMapModel::staleChanged, this, [this] {
        overCurvesChanged();
        setFaded(map_->isStale());
    });
    connect(map_, &ShaftMapModel::moved, this, &ShaftMapPlot::showShaft);
    connect(model_, &SceneModel::rested, this, &ShaftMapPlot::showShaft);
    connect(model_->crank(), &CrankAngle::changed, this, &ShaftMapPlot::overCurvesChanged);
    connect(&Theme::instance(), &Theme::changed, this, &ShaftMapPlot::showImage);
    setFaded(map_->isStale());
    showImage();
}

void ShaftMapPlot::showShaft() {
    // Numbers give way to a shaft that rests.
    if (!model_->isMoved() && !(map_->present() == freeFor_)) {
        groundChanged();
    }
    update();
}

QPointF ShaftMapPlot::pixelOf(const ShaftMapModel::Position& position) const {
    return PlaceScale(*this).at(position);
}

ShaftMapModel::Position ShaftMapPlot::placeAt(const QPointF& pixel) const {
    return {xAt(pixel.x()) * units::mm, yAt(pixel.y()) * units::mm};
}

QString ShaftMapPlot::csv(const CsvFormat& format) const {
    return shaft_map_text::fieldCsv(*map_, format);
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
    labels_.clear(plotArea());
    if (map_->map() == nullptr) {
        return;
    }
    const PlaceScale scale(*this);
    painter.save();
    painter.setClipRect(plotArea());
    drawBlocked(painter, map_->map()->blocked, scale);
    drawLimits(painter, model_->input().place_limits, scale, plotArea());
    if (const ShaftMapModel* other = referenceMap()) {
        drawReference(painter, *other, scale);
    }
    labelMarkers();  // first: the contours' numbers give way to theirs
    const ShaftMapModel::Marker* best = nullptr;
    for (const ShaftMapModel::Marker& marker : map_->markers()) {
        if (marker.criterion == map_->criterion()) {
            best = &marker;  // the last is the one of all places
        }
    }
    labels_.addContours(map_->field(), drawContours(painter, map_->field(), *this),
                        best != nullptr ? scale.at(best->position) : plotArea().center());
    painter.restore();
}

void ShaftMapPlot::labelMarkers() {
    for (const ShaftMapModel::Marker& marker : map_->markers()) {
        labels_.keepFree(pixelOf(marker.position), markerRadius());
    }
    // No number under the handle, as it is now.
    freeFor_ = map_->present();
    labels_.keepFree(pixelOf(freeFor_), shaftHandleRadius + 2.0);
    const PlaceScale scale(*this);
    labels_.keepFreeCircle(scale.at(0.0, 0.0), freeFor_.centre_distance() * scale.perMetre());
    labels_.keepFreeCircle(scale.at(freeFor_),
                           model_->solver().front_view().shaft_swing_radius * scale.perMetre());
    labels_.addMarkers(*map_, scale);
}

void ShaftMapPlot::paintOverCurves(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(plotArea());
    drawEngine(painter, *model_, PlaceScale(*this));
    if (isFaded()) {
        // The numbers are old; that newer ones come stands where they do not meet the drawing.
        painter.setFont(Theme::font(Theme::baseSize));
        painter.setPen(Theme::instance().text());
        painter.drawText(plotArea().adjusted(Theme::space, Theme::space, -Theme::space, 0),
                         Qt::AlignTop | Qt::AlignRight, tr("computing…"));
    } else {
        labels_.paint(painter);
    }
    painter.restore();
}

// What moves.

void ShaftMapPlot::paintTop(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(plotArea());
    drawShaft(painter, *model_, *map_, referenceMap(), PlaceScale(*this));
    if (dragging_) {
        paintChange(painter);
    }
    if (chosen_ && *chosen_ < map_->markers().size()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(Theme::instance().accent(), 2.0));
        painter.drawEllipse(pixelOf(map_->markers()[*chosen_].position), 12.0 * strokeScale(),
                            12.0 * strokeScale());
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

}  // namespace ravnoves
