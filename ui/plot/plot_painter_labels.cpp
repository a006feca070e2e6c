// What stands over the curves of a plot: lines, marks, their labels, and what the cursor reads.

#include <QLineF>
#include <QPainter>
#include <algorithm>

#include "plot/model/label_places.h"
#include "plot/plot_painter.h"
#include "text/number_text.h"
#include "theme/theme.h"

namespace ravnoves {

using namespace painter_parts;
using plot::Shape;

namespace {

struct Row {
    QString text;
    QColor colour;
};

QLineF strokeOf(const PlotData& data, const plot::Line& line) {
    const QRectF& area = data.area;
    if (line.orientation == Qt::Horizontal) {
        const double y = data.toPixel(data.x.low, line.at).y();
        return {area.left(), y, area.right(), y};
    }
    const double x = data.across(line.at);
    return {x, area.top(), x, area.bottom()};
}

void paintStraightLines(QPainter& painter, const PlotData& data) {
    for (const plot::Line& line : data.lines) {
        painter.setPen(
            QPen(Theme::instance().colour(line.role), strokeScale() * 1.2, lookOf(line.role).pen));
        painter.drawLine(strokeOf(data, line));
    }
}

double radiusOf(const plot::Mark& mark) {
    return strokeScale() * (mark.ring ? 7.0 : 3.6);
}

bool isSeen(const PlotData& data, const plot::Mark& mark) {
    const auto curve = mark.curve.empty() ? std::nullopt : data.find(mark.curve);
    return (!curve || data.curves[*curve].shown) &&
           data.area.adjusted(-1, -1, 1, 1).contains(data.toPixel(mark.x, mark.y));
}

LabelPlaces drawnPlaces(const PlotData& data) {
    LabelPlaces places(data.area);
    for (const PlotCurve& curve : data.curves) {
        if (!curve.shown) {
            continue;
        }
        for (const QPolygonF& stretch : curve.stretches) {
            places.addLine(stretch);
        }
        const auto add = [&](double lowX, double lowY, double highX, double highY, double room) {
            places.addShape(QRectF(data.toPixel(lowX, lowY), data.toPixel(highX, highY))
                                .normalized()
                                .adjusted(-room, -room, room, room));
        };
        const double radius = pointRadius(curve.style.shape) + 0.4;
        for (std::size_t i = 0; curve.style.shape != Shape::Line && i < curve.x.size(); ++i) {
            if (curve.style.shape == Shape::Bars) {
                const double middle = curve.x[i] + curve.style.barShift;
                const double half = 0.5 * curve.style.barWidth;
                add(middle - half, std::max(0.0, data.left.low), middle + half, curve.y[i], 0.0);
            } else {
                add(curve.x[i], curve.y[i], curve.x[i], curve.y[i], radius);
            }
        }
    }
    for (const plot::Line& line : data.lines) {
        places.addLine({strokeOf(data, line).p1(), strokeOf(data, line).p2()});
    }
    if (data.presentX) {
        const double x = data.across(*data.presentX);
        places.addLine({{x, data.area.top()}, {x, data.area.bottom()}});
    }
    for (const plot::Mark& mark : data.marks) {
        const QPointF at = data.toPixel(mark.x, mark.y);
        const QPointF corner(radiusOf(mark), radiusOf(mark));
        places.addShape(QRectF(at - corner, at + corner));
    }
    return places;
}

void paintMarks(QPainter& painter, const PlotData& data) {
    const Theme& theme = Theme::instance();
    for (const plot::Mark& mark : data.marks) {
        if (isSeen(data, mark)) {
            const QColor colour = theme.colour(mark.role);
            dot(painter, data.toPixel(mark.x, mark.y), radiusOf(mark),
                QPen(mark.ring ? colour : theme.panel(), strokeScale() * (mark.ring ? 2.0 : 1.2)),
                mark.ring ? QBrush() : QBrush(colour));
        }
    }
}

QRectF placeMark(QPainter& painter, const PlotData& data, const plot::Mark& mark,
                 LabelPlaces& places) {
    if (mark.text.isEmpty() || !isSeen(data, mark)) {
        return {};
    }
    const QPointF at = data.toPixel(mark.x, mark.y);
    const QFont font = Theme::font(Theme::smallSize);
    const QSizeF size = labelSize(font, mark.text);
    // Right, left, above, below and between, and farther off where something is near.
    std::vector<QRectF> candidates;
    for (const double farther : {0.0, 0.8, 1.8, 3.0}) {
        const double away = radiusOf(mark) + 3.0 + farther * size.height();
        const double left = -away - size.width();
        const double above = -away - size.height();
        const double slant = 0.7 * away;
        for (const QPointF& corner :
             {QPointF(away, -size.height() / 2), QPointF(left, -size.height() / 2),
              QPointF(-size.width() / 2, above), QPointF(-size.width() / 2, away),
              QPointF(slant, -slant - size.height()), QPointF(slant, slant),
              QPointF(-slant - size.width(), -slant - size.height()),
              QPointF(-slant - size.width(), slant), QPointF(2.0 * away, -slant - size.height()),
              QPointF(2.0 * away, slant), QPointF(left - away, -slant - size.height()),
              QPointF(left - away, slant)}) {
            candidates.emplace_back(at + corner, size);
        }
    }
    const QRectF box = places.place(candidates);
    const QColor colour = Theme::instance().colour(mark.role);
    // A line to the point that it is far from.
    const QPointF edge(std::clamp(at.x(), box.left(), box.right()),
                       std::clamp(at.y(), box.top(), box.bottom()));
    const QLineF leader(at, edge);
    constexpr double close = 8.0;
    if (leader.length() > radiusOf(mark) + close) {
        painter.setPen(QPen(veil(colour, 0.6F), 1.0));
        painter.drawLine(leader.pointAt(radiusOf(mark) / leader.length()), edge);
    }
    return box;
}

void labelLine(QPainter& painter, const PlotData& data, const plot::Line& line,
               LabelPlaces& places) {
    const QRectF& area = data.area;
    const QFont font = Theme::font(Theme::smallSize);
    const bool flat = line.orientation == Qt::Horizontal;
    const PlotScale& scale = flat ? data.left : data.x;
    const double place = scale.fraction(line.at);
    constexpr double rounding = 1e-3;
    const int beyond = place < -rounding ? -1 : place > 1.0 + rounding ? 1 : 0;
    if (line.text.isEmpty() || (beyond != 0 && !line.keptAtEdge)) {
        return;
    }
    QPointF stroke = strokeOf(data, line).p1();
    QString text = line.text;
    if (beyond != 0) {
        stroke = {std::clamp(stroke.x(), area.left(), area.right()),
                  std::clamp(stroke.y(), area.top(), area.bottom())};
        text += QLatin1Char(' ') + scale.readout(line.at, data.locale) + QChar::Nbsp +
                QChar(flat ? (beyond > 0 ? 0x2191 : 0x2193) : (beyond > 0 ? 0x2192 : 0x2190));
    }
    text = QFontMetricsF(font).elidedText(text, Qt::ElideRight, area.width() - 2.0 * labelGap());
    const QSizeF size = labelSize(font, text);
    constexpr int steps = 16;
    constexpr double away = 2.0;
    const QRectF above(QPointF(stroke.x() + away, stroke.y() - away - size.height()), size);
    const QRectF below(QPointF(stroke.x() - away - size.width(), stroke.y() + away), size);
    const QRectF starts = area.adjusted(away, away, -away - size.width(), -away - size.height());
    std::vector<QRectF> candidates;
    for (int i = 0; i <= steps; ++i) {
        const double part = static_cast<double>(i) / steps;
        for (QRectF box : {above, below}) {
            flat ? box.moveLeft(starts.left() + part * std::max(0.0, starts.width()))
                 : box.moveTop(starts.top() + part * std::max(0.0, starts.height()));
            candidates.push_back(box);
        }
    }
    const QRectF box = places.place(candidates);
    painter.setFont(font);
    drawLabel(painter, box, Theme::instance().readable(Theme::instance().colour(line.role)), text);
}

void paintBandWords(QPainter& painter, const PlotData& data, const plot::Band& band,
                    LabelPlaces& places) {
    const QRectF shade = shadeOf(data, band);
    const QFont font = Theme::font(Theme::smallSize);
    painter.setFont(font);
    double widest = 0.0;
    for (const QString& word : band.text.split(QLatin1Char(' '))) {
        widest = std::max(widest, textWidth(font, word));
    }
    if (widest == 0.0 || shade.width() <= widest + 8.0) {
        return;
    }
    constexpr int flags = Qt::AlignTop | Qt::AlignHCenter | Qt::TextWordWrap;
    const QRectF room = shade.adjusted(4, 2, -4, -2);
    QRectF used(room.topLeft(), labelSize(font, band.text));
    used.moveLeft(room.center().x() - used.width() / 2.0);
    if (used.width() > room.width()) {
        used =
            painter.boundingRect(room, flags, band.text).adjusted(-besideLabel, 0, besideLabel, 0);
    }
    // At the top, or where nothing passes; the curves and values of a full one say more.
    constexpr int heights = 16;
    const double down = std::max(0.0, room.height() - used.height());
    const double aside = std::max(0.0, room.width() - used.width()) / 2.0;
    for (int i = 0; i <= heights; ++i) {
        for (const double across : {0.0, -aside, aside}) {
            const QRectF box = used.translated(across, down * i / heights);
            if (places.covered(box) == 0) {
                places.addLabel(box);
                drawLabel(painter, box, Theme::instance().mutedText(), band.text, flags);
                return;
            }
        }
    }
}

void paintLabels(QPainter& painter, const PlotData& data) {
    const auto hasText = [](const auto& each) { return !each.text.isEmpty(); };
    paintMarks(painter, data);
    if (std::none_of(data.marks.begin(), data.marks.end(), hasText) &&
        std::none_of(data.lines.begin(), data.lines.end(), hasText) &&
        std::none_of(data.bands.begin(), data.bands.end(), hasText)) {
        return;
    }
    // What belongs to a point chooses first.
    LabelPlaces places = drawnPlaces(data);
    std::vector<QRectF> boxes;
    for (const plot::Mark& mark : data.marks) {
        boxes.push_back(
            placeMark(painter, data, mark, places));  // with its leader, below all labels
    }
    painter.setFont(Theme::font(Theme::smallSize));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!boxes[i].isEmpty()) {
            const plot::Mark& mark = data.marks[i];
            drawLabel(painter, boxes[i],
                      Theme::instance().readable(Theme::instance().colour(mark.role)), mark.text);
        }
    }
    for (const plot::Line& line : data.lines) {
        labelLine(painter, data, line, places);
    }
    for (const plot::Band& band : data.bands) {
        paintBandWords(painter, data, band, places);
    }
}

void paintRows(QPainter& painter, const PlotData& data, const std::vector<Row>& rows,
               const QPointF& at, const QPointF& away, float opacity) {
    const Theme& theme = Theme::instance();
    const QRectF& area = data.area;
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    constexpr double around = 7.0;  // a row, at both sides
    constexpr double edge = 2.0;    // from the box to the plot's
    // What a row says beside its value goes below where the plot is too narrow.
    const double room = data.size.width() - 2.0 * (edge + around);
    std::vector<Row> lines;
    double wide = 0.0;
    for (const Row& row : rows) {
        QString text = row.text;
        const qsizetype beside = text.indexOf(QStringLiteral("  "));
        if (beside > 0 && metrics.horizontalAdvance(text) > room) {
            lines.push_back({text.left(beside), row.colour});
            text = text.mid(beside);
        }
        lines.push_back({metrics.elidedText(text, Qt::ElideRight, room), row.colour});
    }
    for (const Row& line : lines) {
        wide = std::max(wide, metrics.horizontalAdvance(line.text));
    }
    const double rowHeight = metrics.height() + 2.0;
    QRectF box(at + away,
               QSizeF(wide + 2.0 * around, rowHeight * static_cast<double>(lines.size()) + 8.0));
    if (box.right() > area.right()) {
        box.moveRight(at.x() - away.x());
    }
    box.moveLeft(std::max(box.left(), area.left()));
    box.moveRight(std::min(box.right(), data.size.width() - edge));  // over the axis at most
    box.moveLeft(std::max(box.left(), edge));
    if (box.bottom() > area.bottom() && at.y() > area.top()) {
        box.moveBottom(at.y() - away.y());
    }
    box.moveBottom(std::min(box.bottom(), data.size.height() - edge));
    box.moveTop(std::max(box.top(), edge));
    painter.setPen(QPen(theme.border(), 1.0));
    painter.setBrush(veil(theme.panel(), opacity));
    painter.drawRoundedRect(box, 4, 4);
    painter.setFont(font);
    QRectF place(box.left() + around, box.top() + 4.0, wide + 2.0, rowHeight);
    for (const Row& line : lines) {
        painter.setPen(line.colour);
        painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft, line.text);
        place.translate(0.0, rowHeight);
    }
}

void paintReadout(QPainter& painter, const PlotData& data) {
    const Theme& theme = Theme::instance();
    const QRectF& area = data.area;
    const double at = *data.readX();
    const double x = data.across(at);
    if (x < area.left() - 0.5 || x > area.right() + 0.5) {
        return;
    }
    const QString equals = QStringLiteral(" = ");
    const QString& title = data.x.spec.title.isEmpty() ? data.xName : data.x.spec.title;
    const QString name = title.section(QLatin1Char(','), 0, 0);
    std::vector<Row> rows{
        {(name.isEmpty() ? QStringLiteral("x") : name) + equals + data.x.readout(at, data.locale),
         theme.text()}};
    for (const PlotCurve& curve : data.curves) {
        const auto y = curve.shown ? data.valueAt(curve, at) : std::nullopt;
        if (!y) {
            continue;
        }
        const QColor colour = theme.colour(curve.style.role);
        const auto shown = [&](double value) { return data.left.readout(value, data.locale); };
        const PlotCurve* ghost = data.ghostOf(curve);
        const auto was = ghost != nullptr ? data.valueAt(*ghost, at) : std::nullopt;
        const auto spread = data.spreadAt(curve, at);
        rows.push_back({curve.style.name + equals + shown(*y) +
                            (spread ? QStringLiteral("  [%1 … %2]")
                                          .arg(shown(spread->first), shown(spread->second))
                                    : QString()) +
                            (was ? QStringLiteral("  (%1: %2)").arg(data.referenceName, shown(*was))
                                 : QString()),
                        theme.readable(colour)});
        const bool isBar = curve.style.shape == Shape::Bars;
        const QPointF point = data.toPixel(at + (isBar ? curve.style.barShift : 0.0), *y);
        if (area.contains(point)) {
            dot(painter, point, strokeScale() * 3.4, QPen(theme.panel(), 1.2), colour);
        }
    }
    const auto folds = [](const PlotCurve& curve) {
        return !curve.shown || !curve.isLine() || !curve.ascending;
    };
    if (rows.size() == 1 && std::all_of(data.curves.begin(), data.curves.end(), folds)) {
        return;  // of a curve that folds back x alone says nothing
    }
    paintRows(painter, data, rows, QPointF(x, area.top()), QPointF(10, 6), 0.93F);
}

std::vector<Row> rowsOfPath(const PlotData& data, const PlotCurve& curve, std::size_t point) {
    const Theme& theme = Theme::instance();
    const PlotCurve* ghost = data.ghostOf(curve);
    const bool both = ghost != nullptr && ghost->x.size() == curve.x.size();
    const auto line = [&](const PlotScale& scale, double value, double was) {
        const QString old = both ? QStringLiteral("  (%1: %2)")
                                       .arg(data.referenceName, scale.readout(was, data.locale))
                                 : QString();
        return Row{scale.spec.title.section(QLatin1Char(','), 0, 0) + QStringLiteral(" = ") +
                       scale.readout(value, data.locale) + old,
                   theme.text()};
    };
    const PlotCurve& other = both ? *ghost : curve;
    return {{curve.style.name, theme.readable(theme.colour(curve.style.role))},
            {QStringLiteral("φ = %1°").arg(fixedNumber(curve.angleOf(point), 1, data.locale)),
             theme.text()},
            line(data.x, curve.x[point], other.x[point]),
            line(data.left, curve.y[point], other.y[point])};
}

void paintPointReadout(QPainter& painter, const PlotData& data) {
    const Theme& theme = Theme::instance();
    const PlotCurve& curve = data.curves[data.pointRead->first];
    const QPointF at = data.pixelOf(curve, data.pointRead->second);
    if (!data.area.adjusted(-1, -1, 1, 1).contains(at)) {
        return;
    }
    dot(painter, at, strokeScale() * 5.0, QPen(theme.text(), 1.6), theme.colour(curve.style.role));
    std::vector<Row> rows;
    if (curve.style.turn > 0.0) {
        rows = rowsOfPath(data, curve, data.pointRead->second);
    } else {
        const QString read = curve.text(curve.places[data.pointRead->second]);
        for (const QString& text : read.split(QLatin1Char('\n'))) {
            rows.push_back({text, theme.text()});
        }
    }
    paintRows(painter, data, rows, at, QPointF(12, 8), 0.95F);
}

}  // namespace

void paintPlotOverlay(QPainter& painter, const PlotData& data) {
    const Theme& theme = Theme::instance();
    const QRectF& area = data.area;
    painter.setRenderHint(QPainter::Antialiasing);
    if (data.faded) {
        // In strips: for a high rectangle that lets through Qt wakes threads and waits for them.
        constexpr int strip = 32;
        QRect rest =
            QRectF(QPointF(0.0, data.headerHeight), data.size - QSizeF(0.0, data.headerHeight))
                .toAlignedRect();
        for (; rest.height() > 0; rest.setTop(rest.top() + strip)) {
            painter.fillRect(rest.left(), rest.top(), rest.width(), std::min(strip, rest.height()),
                             veil(theme.panel(), 0.62F));
        }
    }
    painter.save();
    painter.setClipRect(area);
    paintStraightLines(painter, data);
    if (data.presentX) {
        const double x = data.across(*data.presentX);
        painter.setPen(QPen(theme.accent(), strokeScale() * 1.4));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        for (const PlotCurve& curve : data.curves) {
            const auto y = curve.shown ? data.valueAt(curve, *data.presentX) : std::nullopt;
            if (y) {
                dot(painter, data.toPixel(*data.presentX, *y), strokeScale() * 4.5,
                    QPen(theme.panel(), strokeScale() * 1.5), theme.colour(curve.style.role));
            }
        }
    }
    const bool readsCurves = data.cursorX && !data.pointRead;
    if (readsCurves) {
        painter.setPen(QPen(theme.mutedText(), 1.0, Qt::DotLine));
        const double x = data.across(*data.readX());
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
    painter.restore();
    paintLabels(painter, data);
    if (data.faded && !data.fadedText.isEmpty()) {
        painter.setFont(Theme::font(Theme::baseSize));
        painter.setPen(theme.mutedText());
        painter.drawText(area, Qt::AlignCenter, data.fadedText);
    }
    if (data.pointRead) {
        paintPointReadout(painter, data);
    } else if (readsCurves) {
        paintReadout(painter, data);
    }
}

}  // namespace ravnoves
