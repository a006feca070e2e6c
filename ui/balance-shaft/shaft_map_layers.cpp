#include "balance-shaft/shaft_map_layers.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <utility>

#include "balance-shaft/place_scale.h"
#include "balance-shaft/shaft_map_signs.h"
#include "pictures/model/stroke.h"
#include "plot/plot_painter.h"
#include "theme/theme.h"

namespace ravnoves {

void drawBlocked(QPainter& painter, const std::vector<QPolygonF>& blocked, const PlaceScale& scale,
                 const QRectF& area) {
    const Theme& theme = Theme::instance();
    QPainterPath path;
    LinesOfPen edges{QPen(faint(theme.text(), 0.7), 1.0), {}};
    for (const QPolygonF& line : blocked) {
        QPolygonF edge = scale.line(line);
        path.addPolygon(edge);
        path.closeSubpath();
        // Round its corners, the first of them, too.
        edge << edge.value(0) << edge.value(1);
        edges.lines.push_back(std::move(edge));
    }
    if (path.isEmpty()) {
        return;
    }
    fillHatched(painter, path, area, faint(theme.panel(), 0.38));
    painter.setBrush(Qt::NoBrush);
    paintLines(painter, {edges});
}

void drawReference(QPainter& painter, const ShaftMapModel& other, PlaceCriterion::Kind criterion,
                   const PlaceScale& scale) {
    if (other.map() == nullptr) {
        return;
    }
    // Wide and pale, as ghosts of curves are.
    const Theme& theme = Theme::instance();
    const auto wide = [&](double alpha, double width) {
        return QPen(faint(theme.text(), alpha), strokeScale() * width, Qt::SolidLine, Qt::FlatCap,
                    Qt::BevelJoin);
    };
    painter.setBrush(Qt::NoBrush);
    painter.setPen(wide(0.18, 4.0));
    for (const QPolygonF& line : other.map()->blocked) {
        painter.drawPolygon(scale.line(line));
    }
    painter.setPen(wide(0.34, 6.0));
    for (const ShaftMapModel::Contour& contour : other.contours()) {
        for (const QPolygonF& line : contour.lines) {
            if (contour.level == 0.0) {
                painter.drawPolyline(scale.line(line));
            }
        }
    }
    for (const ShaftMapModel::Marker& marker : other.markers()) {
        if (marker.criterion == criterion) {
            const QPainterPath shape =
                glyph(scale.at(marker.position), marker, 1.25 * glyphRadius());
            painter.setPen(wide(0.34, 4.0));
            painter.drawPath(shape);
            painter.setPen(QPen(theme.panel(), 1.4 * strokeScale()));
            painter.drawPath(shape);
        }
    }
}

std::vector<QPolygonF> drawContours(QPainter& painter,
                                    const std::vector<ShaftMapModel::Contour>& contours,
                                    const PlaceScale& scale) {
    const Theme& theme = Theme::instance();
    std::vector<QPolygonF> longest(contours.size());
    std::vector<LinesOfPen> all;
    for (std::size_t i = 0; i < contours.size(); ++i) {
        const bool zero = contours[i].level == 0.0;
        std::vector<QPolygonF> lines;
        lines.reserve(contours[i].lines.size());
        for (const QPolygonF& metres : contours[i].lines) {
            lines.push_back(scale.line(metres));
            if (lines.back().size() > longest[i].size()) {
                longest[i] = lines.back();
            }
        }
        all.push_back({zero ? QPen(theme.text(), 2.4) : QPen(faint(theme.text(), 0.38), 1.0),
                       std::move(lines)});
    }
    painter.setBrush(Qt::NoBrush);
    paintLines(painter, all);
    return longest;
}

void drawMarkers(QPainter& painter, const ShaftMapModel& map, const PlaceScale& scale) {
    // Those of the criterion shown lie on top.
    for (const bool shown : {false, true}) {
        for (const ShaftMapModel::Marker& marker : map.markers()) {
            if ((marker.criterion == map.criterion()) == shown) {
                drawGlyph(painter, scale.at(marker.position), marker);
            }
        }
    }
}

}  // namespace ravnoves
