// What stands over the curves of a plot: lines, marks, their labels, and what the cursor reads.

#include <QPainter>
#include <algorithm>

#include "plot/model/label_places.h"
#include "plot/plot_painter.h"
#include "text/number_text.h"
#include "theme/theme.h"

namespace ravnoves {

using namespace painter_parts;
using plot::Shape;

void PlotPainter::paintOverlay(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    painter.setRenderHint(QPainter::Antialiasing);
    if (data_.faded) {
        // In strips: for a high rectangle that lets through Qt wakes threads and waits for them.
        constexpr int strip = 32;
        QRect rest =
            QRectF(QPointF(0.0, data_.headerHeight), size_ - QSizeF(0.0, data_.headerHeight))
                .toAlignedRect();
        for (; rest.height() > 0; rest.setTop(rest.top() + strip)) {
            painter.fillRect(rest.left(), rest.top(), rest.width(), std::min(strip, rest.height()),
                             veil(theme.panel(), 0.62F));
        }
    }
    painter.save();
    painter.setClipRect(area);
    paintLines(painter);
    if (data_.presentX) {
        const double x = across(*data_.presentX);
        painter.setPen(QPen(theme.accent(), strokeScale() * 1.4));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        for (const PlotCurve& curve : data_.curves) {
            const auto y = curve.shown ? data_.valueAt(curve, *data_.presentX) : std::nullopt;
            if (y) {
                dot(painter, data_.toPixel(*data_.presentX, *y), strokeScale() * 4.5,
                    QPen(theme.panel(), strokeScale() * 1.5), theme.colour(curve.style.role));
            }
        }
    }
    const bool readsCurves = data_.cursorX && !data_.pointRead;
    if (readsCurves) {
        painter.setPen(QPen(theme.mutedText(), 1.0, Qt::DotLine));
        const double x = across(*data_.readX());
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
    painter.restore();
    paintLabels(painter);
    if (data_.faded && !data_.fadedText.isEmpty()) {
        painter.setFont(Theme::font(Theme::baseSize));
        painter.setPen(theme.mutedText());
        painter.drawText(area, Qt::AlignCenter, data_.fadedText);
    }
    if (data_.pointRead) {
        paintPointReadout(painter);
    } else if (readsCurves) {
        paintReadout(painter);
    }
}

void PlotPainter::paintLines(QPainter& painter) const {
    for (const plot::Line& line : data_.lines) {
        painter.setPen(
            QPen(Theme::instance().colour(line.role), strokeScale() * 1.2, lookOf(line.role).pen));
        painter.drawLine(strokeOf(line));
    }
}

QLineF PlotPainter::strokeOf(const plot::Line& line) const {
    const QRectF& area = data_.area;
    if (line.orientation == Qt::Horizontal) {
        const double y = data_.toPixel(data_.x.low, line.at).y();
        return {area.left(), y, area.right(), y};
    }
    const double x = across(line.at);
    return {x, area.top(), x, area.bottom()};
}

LabelPlaces PlotPainter::drawnPlaces() const {
    LabelPlaces places(data_.area);
    for (const PlotCurve& curve : data_.curves) {
        if (!curve.shown) {
            continue;
        }
        for (const QPolygonF& stretch : curve.stretches) {
            places.addLine(stretch);
        }
        const auto add = [&](double lowX, double lowY, double highX, double highY, double room) {
            places.addShape(QRectF(data_.toPixel(lowX, lowY), data_.toPixel(highX, highY))
                                .normalized()
                                .adjusted(-room, -room, room, room));
        };
        const double radius = pointRadius(curve.style.shape) + 0.4;
        for (std::size_t i = 0; curve.style.shape != Shape::Line && i < curve.x.size(); ++i) {
            if (curve.style.shape == Shape::Bars) {
                const double middle = curve.x[i] + curve.style.barShift;
                const double half = 0.5 * curve.style.barWidth;
                add(middle - half, std::max(0.0, data_.left.low), middle + half, curve.y[i], 0.0);
            } else {
                add(curve.x[i], curve.y[i], curve.x[i], curve.y[i], radius);
            }
        }
    }
    for (const plot::Line& line : data_.lines) {
        places.addLine({strokeOf(line).p1(), strokeOf(line).p2()});
    }
    if (data_.presentX) {
        const double x = across(*data_.presentX);
        places.addLine({{x, data_.area.top()}, {x, data_.area.bottom()}});
    }
    for (const plot::Mark& mark : data_.marks) {
        const QPointF at = data_.toPixel(mark.x, mark.y);
        const QPointF corner(radiusOf(mark), radiusOf(mark));
        places.addShape(QRectF(at - corner, at + corner));
    }
    return places;
}

void PlotPainter::paintLabels(QPainter& painter) const {
    const auto hasText = [](const auto& each) { return !each.text.isEmpty(); };
    paintMarks(painter);
    if (std::none_of(data_.marks.begin(), data_.marks.end(), hasText) &&
        std::none_of(data_.lines.begin(), data_.lines.end(), hasText) &&
        std::none_of(data_.bands.begin(), data_.bands.end(), hasText)) {
        return;
    }
    // What belongs to a point chooses first.
    LabelPlaces places = drawnPlaces();
    std::vector<QRectF> boxes;
    for (const plot::Mark& mark : data_.marks) {
        boxes.push_back(placeMark(painter, mark, places));  // with its leader, below all labels
    }
    painter.setFont(Theme::font(Theme::smallSize));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!boxes[i].isEmpty()) {
            const plot::Mark& mark = data_.marks[i];
            drawLabel(painter, boxes[i],
                      Theme::instance().readable(Theme::instance().colour(mark.role)), mark.text);
        }
    }
    for (const plot::Line& line : data_.lines) {
        labelLine(painter, line, places);
    }
    for (const plot::Band& band : data_.bands) {
        paintBandWords(painter, band, places);
    }
}

void PlotPainter::labelLine(QPainter& painter, const plot::Line& line, LabelPlaces& places) const {
    const QRectF& area = data_.area;
    const QFont font = Theme::font(Theme::smallSize);
    const bool flat = line.orientation == Qt::Horizontal;
    const PlotScale& scale = flat ? data_.left : data_.x;
    const double place = scale.fraction(line.at);
    constexpr double rounding = 1e-3;
    const int beyond = place < -rounding ? -1 : place > 1.0 + rounding ? 1 : 0;
    if (line.text.isEmpty() || (beyond != 0 && !line.keptAtEdge)) {
        return;
    }
    QPointF stroke = strokeOf(line).p1();
    QString text = line.text;
    if (beyond != 0) {
        stroke = {std::clamp(stroke.x(), area.left(), area.right()),
                  std::clamp(stroke.y(), area.top(), area.bottom())};
        text += QLatin1Char(' ') + scale.readout(line.at, data_.locale) + QChar::Nbsp +
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

double PlotPainter::radiusOf(const plot::Mark& mark) {
    return strokeScale() * (mark.ring ? 7.0 : 3.6);
}

bool PlotPainter::isSeen(const plot::Mark& mark) const {
    const auto curve = mark.curve.empty() ? std::nullopt : data_.find(mark.curve);
    return (!curve || data_.curves[*curve].shown) &&
           data_.area.adjusted(-1, -1, 1, 1).contains(data_.toPixel(mark.x, mark.y));
}

void PlotPainter::paintMarks(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    for (const plot::Mark& mark : data_.marks) {
        if (isSeen(mark)) {
            const QColor colour = theme.colour(mark.role);
            dot(painter, data_.toPixel(mark.x, mark.y), radiusOf(mark),
                QPen(mark.ring ? colour : theme.panel(), strokeScale() * (mark.ring ? 2.0 : 1.2)),
                mark.ring ? QBrush() : QBrush(colour));
        }
    }
}

QRectF PlotPainter::placeMark(QPainter& painter, const plot::Mark& mark,
                              LabelPlaces& places) const {
    if (mark.text.isEmpty() || !isSeen(mark)) {
        return {};
    }
    const QPointF at = data_.toPixel(mark.x, mark.y);
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

void PlotPainter::paintReadout(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    const double at = *data_.readX();
    const double x = across(at);
    if (x < area.left() - 0.5 || x > area.right() + 0.5) {
        return;
    }
    const QString equals = QStringLiteral(" = ");
    const QString& title = data_.x.spec.title.isEmpty() ? data_.xName : data_.x.spec.title;
    const QString name = title.section(QLatin1Char(','), 0, 0);
    std::vector<Row> rows{
        {(name.isEmpty() ? QStringLiteral("x") : name) + equals + data_.x.readout(at, data_.locale),
         theme.text()}};
    for (const PlotCurve& curve : data_.curves) {
        const auto y = curve.shown ? data_.valueAt(curve, at) : std::nullopt;
        if (!y) {
            continue;
        }
        const QColor colour = theme.colour(curve.style.role);
        const auto shown = [&](double value) { return data_.left.readout(value, data_.locale); };
        const PlotCurve* ghost = data_.ghostOf(curve);
        const auto was = ghost != nullptr ? data_.valueAt(*ghost, at) : std::nullopt;
        const auto spread = data_.spreadAt(curve, at);
        rows.push_back(
            {curve.style.name + equals + shown(*y) +
                 (spread ? QStringLiteral("  [%1 … %2]")
                               .arg(shown(spread->first), shown(spread->second))
                         : QString()) +
                 (was ? QStringLiteral("  (%1: %2)").arg(data_.referenceName, shown(*was))
                      : QString()),
             theme.readable(colour)});
        const bool isBar = curve.style.shape == Shape::Bars;
        const QPointF point = data_.toPixel(at + (isBar ? curve.style.barShift : 0.0), *y);
        if (area.contains(point)) {
            dot(painter, point, strokeScale() * 3.4, QPen(theme.panel(), 1.2), colour);
        }
    }
    const auto folds = [](const PlotCurve& curve) {
        return !curve.shown || !curve.isLine() || !curve.ascending;
    };
    if (rows.size() == 1 && std::all_of(data_.curves.begin(), data_.curves.end(), folds)) {
        return;  // of a curve that folds back x alone says nothing
    }
    paintRows(painter, rows, QPointF(x, area.top()), QPointF(10, 6), 0.93F);
}

std::vector<PlotPainter::Row> PlotPainter::rowsOfPath(const PlotCurve& curve,
                                                      std::size_t point) const {
    const Theme& theme = Theme::instance();
    const PlotCurve* ghost = data_.ghostOf(curve);
    const bool both = ghost != nullptr && ghost->x.size() == curve.x.size();
    const auto line = [&](const PlotScale& scale, double value, double was) {
        const QString old = both ? QStringLiteral("  (%1: %2)")
                                       .arg(data_.referenceName, scale.readout(was, data_.locale))
                                 : QString();
        return Row{scale.spec.title.section(QLatin1Char(','), 0, 0) + QStringLiteral(" = ") +
                       scale.readout(value, data_.locale) + old,
                   theme.text()};
    };
    const PlotCurve& other = both ? *ghost : curve;
    return {{curve.style.name, theme.readable(theme.colour(curve.style.role))},
            {QStringLiteral("φ = %1°").arg(fixedNumber(curve.angleOf(point), 1, data_.locale)),
             theme.text()},
            line(data_.x, curve.x[point], other.x[point]),
            line(data_.left, curve.y[point], other.y[point])};
}

void PlotPainter::paintPointReadout(QPainter& painter) const {
    const Theme& theme = Theme::instance();
    const PlotCurve& curve = data_.curves[data_.pointRead->first];
    const QPointF at = pixel(curve, data_.pointRead->second);
    if (!data_.area.adjusted(-1, -1, 1, 1).contains(at)) {
        return;
    }
    dot(painter, at, strokeScale() * 5.0, QPen(theme.text(), 1.6), theme.colour(curve.style.role));
    std::vector<Row> rows;
    if (curve.style.turn > 0.0) {
        rows = rowsOfPath(curve, data_.pointRead->second);
    } else {
        const QString read = curve.text(curve.places[data_.pointRead->second]);
        for (const QString& text : read.split(QLatin1Char('\n'))) {
            rows.push_back({text, theme.text()});
        }
    }
    paintRows(painter, rows, at, QPointF(12, 8), 0.95F);
}

void PlotPainter::paintRows(QPainter& painter, const std::vector<Row>& rows, const QPointF& at,
                            const QPointF& away, float opacity) const {
    const Theme& theme = Theme::instance();
    const QRectF& area = data_.area;
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    constexpr double around = 7.0;  // a row, at both sides
    constexpr double edge = 2.0;    // from the box to the plot's
    // What a row says beside its value goes below where the plot is too narrow.
    const double room = size_.width() - 2.0 * (edge + around);
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
    box.moveRight(std::min(box.right(), size_.width() - edge));  // over the axis at most
    box.moveLeft(std::max(box.left(), edge));
    if (box.bottom() > area.bottom() && at.y() > area.top()) {
        box.moveBottom(at.y() - away.y());
    }
    box.moveBottom(std::min(box.bottom(), size_.height() - edge));
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

}  // namespace ravnoves
