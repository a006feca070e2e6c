#include "balance-shaft/shaft_map_key.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "balance-shaft/change_colours.h"
#include "balance-shaft/shaft_map_drawing.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

constexpr double swatch = 20.0;

}  // namespace

bool ShaftMapKey::isLow() const {
    constexpr int enough = 290;  // pixels for the key beside the map
    return size_.height() < Theme::withText(enough);
}

std::vector<ShaftMapKey::Entry> ShaftMapKey::entries() const {
    std::vector<Entry> shown;
    if (isLow()) {
        return shown;  // the map needs the room: its tip says it
    }
    const Theme& theme = Theme::instance();
    if (!map_.levels().empty()) {
        shown.push_back({tr("0 %: no change"), [&theme](QPainter& painter, const QPointF& middle) {
                             painter.setPen(QPen(theme.text(), 2.4));
                             painter.drawLine(middle - QPointF(9, 0), middle + QPointF(9, 0));
                         }});
    }
    shown.push_back({tr("shaft, and its l"), [&theme](QPainter& painter, const QPointF& middle) {
                         painter.setPen(QPen(theme.accent(), 1.4, Qt::DashLine));
                         painter.drawLine(middle - QPointF(9, 0), middle + QPointF(9, 0));
                         painter.setPen(QPen(theme.panel(), 1.0));
                         painter.setBrush(theme.accent());
                         painter.drawEllipse(middle, 4.0, 4.0);
                     }});
    if (map_.map() != nullptr && !map_.map()->blocked.empty()) {
        shown.push_back({tr("does not fit"), [&theme](QPainter& painter, const QPointF& middle) {
                             const QRectF box(middle - QPointF(8, 5), QSizeF(16, 10));
                             QPainterPath path;
                             path.addRect(box);
                             fillHatched(painter, path, Qt::transparent);
                             painter.setPen(QPen(faint(theme.text(), 0.6), 1.0));
                             painter.setBrush(Qt::NoBrush);
                             painter.drawRect(box);
                         }});
    }
    // One sign for each criterion, and one for what cannot be built.
    const auto& markers = map_.markers();
    const auto addSign = [&](const QString& text, const ShaftMapModel::Marker& marker) {
        shown.push_back({text, [marker](QPainter& painter, const QPointF& middle) {
                             drawGlyph(painter, middle, marker);
                         }});
    };
    const ShaftMapModel::Marker* hollow = nullptr;
    for (auto marker = markers.begin(); marker != markers.end(); ++marker) {
        if (marker == markers.begin() || std::prev(marker)->criterion != marker->criterion) {
            addSign(marker->name(), *marker);
        } else if (hollow == nullptr) {
            hollow = &*marker;
        }
    }
    if (hollow != nullptr) {
        addSign(tr("ignoring clearance"), *hollow);
    }
    const QFontMetricsF metrics(Theme::font(Theme::smallSize));
    const double row = std::ceil(metrics.height()) + 3.0;
    double x = Theme::margin;
    double y = map_.levels().empty() ? 0.0 : colourBarHeight() + row + 2.0;
    for (Entry& entry : shown) {
        const double wide = swatch + 4.0 + metrics.horizontalAdvance(entry.text) + 12.0;
        if (x + wide > size_.width() - Theme::space && x > Theme::margin) {
            x = Theme::margin;
            y += row;
        }
        entry.rect = QRectF(x, y, wide, row);
        x += wide;
    }
    return shown;
}

double ShaftMapKey::height() const {
    const std::vector<Entry> shown = entries();
    const double bar =
        map_.levels().empty()
            ? 0.0
            : colourBarHeight() + QFontMetricsF(Theme::font(Theme::smallSize)).height() + 4.0;
    return shown.empty() ? bar : shown.back().rect.bottom() + 2.0;
}

QString ShaftMapKey::signsInWords() const {
    QStringList signs;
    for (const ShaftMapModel::Marker& marker : map_.markers()) {
        const QString name =
            (marker.criterion == ShaftMapModel::Criterion::Range ? QStringLiteral("◆ ")
             : marker.criterion == ShaftMapModel::Criterion::Rms ? QStringLiteral("● ")
                                                                 : QStringLiteral("▲ ")) +
            marker.name();
        if (marker.isBuildable && !signs.contains(name)) {
            signs << name;
        }
    }
    return signs.join(QStringLiteral(", "));
}

void ShaftMapKey::paint(QPainter& painter, double top) const {
    painter.setFont(Theme::font(Theme::smallSize));
    if (!map_.levels().empty()) {
        paintColours(painter, top);
    }
    for (const Entry& entry : entries()) {
        const QRectF rect = entry.rect.translated(0.0, top);
        entry.draw(painter, QPointF(rect.left() + swatch / 2.0, rect.center().y()));
        painter.setPen(Theme::instance().text());
        painter.drawText(rect.adjusted(swatch + 4.0, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         entry.text);
    }
}

void ShaftMapKey::paintColours(QPainter& painter, double top) const {
    const std::vector<double>& levels = map_.levels();
    const std::vector<QRgb> colours = bandColours(levels);
    const double whole = std::min(size_.width() - 2.0 * Theme::margin, longestColourBar());
    const double each = whole / static_cast<double>(colours.size());
    const QRectF bar(Theme::margin, top, whole, colourBarHeight());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        painter.fillRect(
            QRectF(bar.left() + each * static_cast<double>(i), top, each + 0.5, colourBarHeight()),
            QColor(colours[i]));
    }
    // No change first: its number is in any case.
    std::vector<BarNumber> numbers;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const bool isNoChange = levels[i] == 0.0;
        numbers.insert(isNoChange ? numbers.begin() : numbers.end(),
                       {static_cast<double>(i + 1) / static_cast<double>(colours.size()),
                        levelText(levels[i]), isNoChange});
    }
    paintBarNumbers(painter, bar, numbers);
}

}  // namespace ravnoves
