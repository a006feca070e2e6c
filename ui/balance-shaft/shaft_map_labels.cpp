#include "balance-shaft/shaft_map_labels.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "balance-shaft/change_colours.h"
#include "balance-shaft/shaft_map_drawing.h"
#include "numerics/constants.h"
#include "text/number_text.h"
#include "theme/theme.h"

namespace ravnoves {

void ShaftMapLabels::clear(const QRectF& area) {
    area_ = area;
    labels_.clear();
    circles_.clear();
}

void ShaftMapLabels::keepFree(const QPointF& middle, double half) {
    labels_.push_back({QRectF(middle - QPointF(half, half), 2.0 * QSizeF(half, half)), {}});
}

void ShaftMapLabels::keepFreeCircle(const QPointF& middle, double radius) {
    circles_.emplace_back(middle, radius);
}

void ShaftMapLabels::add(const std::vector<QRectF>& boxes, const QString& text, bool isBold,
                         bool overCircles) {
    const auto isOn = [](const QRectF& box, const std::pair<QPointF, double>& circle) {
        const auto& [middle, radius] = circle;
        const QPointF closest(std::clamp(middle.x(), box.left(), box.right()),
                              std::clamp(middle.y(), box.top(), box.bottom()));
        const QPointF farthest(std::abs(box.center().x() - middle.x()) + box.width() / 2.0,
                               std::abs(box.center().y() - middle.y()) + box.height() / 2.0);
        return QLineF(middle, closest).length() < radius &&
               radius < std::hypot(farthest.x(), farthest.y());
    };
    const auto fits = [&](const QRectF& box) {
        return area_.adjusted(2, 2, -2, -2).contains(box) &&
               std::ranges::none_of(labels_,
                                    [&](const Label& other) { return other.box.intersects(box); });
    };
    const auto isFree = [&](const QRectF& box) {
        return fits(box) && std::ranges::none_of(
                                circles_, [&](const auto& circle) { return isOn(box, circle); });
    };
    auto box = std::ranges::find_if(boxes, isFree);
    if (box == boxes.end() && overCircles) {
        box = std::ranges::find_if(boxes, fits);
    }
    if (box != boxes.end()) {
        labels_.push_back({*box, text, isBold});
    }
}

void ShaftMapLabels::addMarkers(const ShaftMapModel& map, const PlaceScale& scale) {
    const QFontMetricsF metrics(Theme::font(Theme::smallSize, true));
    for (const ShaftMapModel::Marker& marker : map.markers()) {
        const auto change = map.change(marker.criteria);
        if (!change || marker.criterion != map.criterion()) {
            continue;
        }
        const QPointF at = scale.at(marker.position);
        const QString text = signedPercentText(*change);
        const QSizeF size(metrics.horizontalAdvance(text) + 6.0, metrics.height());
        const double away = markerRadius() + 2.0;
        std::vector<QRectF> boxes;
        for (const QPointF& corner :
             {QPointF(away, -size.height() / 2), QPointF(-away - size.width(), -size.height() / 2),
              QPointF(-size.width() / 2, -away - size.height()), QPointF(-size.width() / 2, away),
              QPointF(away, -size.height() - 2), QPointF(away, 2)}) {
            boxes.emplace_back(at + corner, size);
        }
        add(boxes, text, true, true);
    }
}

void ShaftMapLabels::addContours(const ChangeContours& field, const std::vector<QPolygonF>& lines,
                                 const QPointF& centre) {
    const auto& contours = field.contours;
    const QFontMetricsF metrics(Theme::font(Theme::smallSize));
    constexpr std::array turns{90.0, 110.0, 70.0, 130.0, 150.0, 180.0,
                               50.0, 20.0,  0.0,  220.0, 320.0, 270.0};
    // In a small map every second or third line has its number, that of no change in any case.
    const double room =
        area_.width() * area_.height() / (Theme::withText(120) * Theme::withText(80));
    const auto maximum = static_cast<std::size_t>(std::max(3.0, room));
    const std::size_t each = std::max<std::size_t>(1, (contours.size() + maximum - 1) / maximum);
    const auto zero = static_cast<std::size_t>(
        std::find_if(contours.begin(), contours.end(),
                     [](const auto& contour) { return contour.level == 0.0; }) -
        contours.begin());
    for (std::size_t i = 0; i < contours.size(); ++i) {
        if (i % each != zero % each) {
            continue;
        }
        const QString text = withUnit(levelText(contours[i].level), unitText("%"));
        const QSizeF size(metrics.horizontalAdvance(text) + 6.0, metrics.height() - 1.0);
        const bool isZero = contours[i].level == 0.0;
        std::vector<QRectF> boxes;
        for (const double turn : turns) {
            const QPointF ray(std::cos(turn * degree), std::sin(turn * degree));
            double nearest = 0.98;  // cosine to the ray
            std::optional<QPointF> at;
            for (const QPointF& point : lines[i]) {
                const QPointF to = point - centre;
                const double along = QPointF::dotProduct(to, ray) / std::hypot(to.x(), to.y());
                if (along > nearest) {
                    nearest = along;
                    at = point;
                }
            }
            if (at) {
                boxes.emplace_back(*at - QPointF(size.width(), size.height()) / 2.0, size);
            }
        }
        add(boxes, text, isZero, isZero);
    }
}

void ShaftMapLabels::paint(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    for (const Label& label : labels_) {
        if (label.text.isEmpty()) {
            continue;  // a marker's own place
        }
        painter.setFont(Theme::font(Theme::smallSize, label.isBold));
        painter.setPen(Qt::NoPen);
        painter.setBrush(faint(theme.panel(), 0.8));
        painter.drawRoundedRect(label.box, 3, 3);
        painter.setPen(theme.text());
        painter.drawText(label.box, Qt::AlignCenter, label.text);
    }
}

}  // namespace ravnoves
