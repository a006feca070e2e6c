#include <QChart>
#include <QGraphicsScene>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QSvgGenerator>
#include <algorithm>
#include <array>
#include <cmath>

#include "plot/plot_view_parts.h"
#include "plot/ticks.h"
#include "theme/theme.h"

namespace ravnoves {

using plot::columnPerTick;
using plot::labelGap;
using plot::rowPerTick;

void PlotView::paintTitle(QPainter& painter) {
    painter.setFont(Theme::font(Theme::baseSize, true));
    painter.setPen(Theme::instance().text());
    const double row = std::ceil(painter.fontMetrics().height()) + Theme::gap;
    const double room = width() - 2.0 * Theme::margin;
    painter.drawText(
        QRectF(Theme::margin, Theme::gap, room, row), Qt::AlignLeft | Qt::AlignVCenter,
        painter.fontMetrics().elidedText(title_, Qt::ElideRight, static_cast<int>(room)));
}

void PlotView::renderAxes(QPainter& painter) {
    const QRectF area = plotArea();
    painter.setRenderHint(QPainter::Antialiasing);
    paintTitle(painter);
    if (!image_.isNull()) {
        painter.save();
        painter.setClipRect(area);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(QRectF(toPixel(imageValues_.left(), imageValues_.bottom()),
                                 toPixel(imageValues_.right(), imageValues_.top()))
                              .normalized(),
                          image_);
        painter.restore();
    }
    for (const Band& band : bands_) {
        const bool alongX = band.orientation == Qt::Horizontal;
        const QPointF from = alongX ? QPointF(toPixel(band.from, left_->low).x(), area.top())
                                    : QPointF(area.left(), toPixel(x_->low, band.from).y());
        const QPointF to = alongX ? QPointF(toPixel(band.to, left_->low).x(), area.bottom())
                                  : QPointF(area.right(), toPixel(x_->low, band.to).y());
        const QRectF shade = QRectF(from, to).normalized().intersected(area);
        painter.fillRect(shade, band.colour);
        painter.setFont(Theme::font(Theme::smallSize));
        double widest = 0.0;
        for (const QString& word : band.text.split(QLatin1Char(' '))) {
            widest = std::max<double>(widest, painter.fontMetrics().horizontalAdvance(word));
        }
        if (widest > 0.0 && shade.width() > widest + 8.0) {
            painter.setPen(Theme::instance().mutedText());
            painter.drawText(shade.adjusted(4, 2, -4, -2),
                             Qt::AlignTop | Qt::AlignHCenter | Qt::TextWordWrap, band.text);
        }
    }
    if (x_->isOwn()) {
        renderOwnAxis(painter, *x_, Qt::BottomEdge);
    }
    if (left_->isOwn()) {
        renderOwnAxis(painter, *left_, Qt::LeftEdge);
    }
    if (right_->isOwn() && sideUsed(Side::Right)) {
        renderOwnAxis(painter, *right_, Qt::RightEdge);
    }
    const QRectF whole(0, 0, width(), height());
    scene_->render(&painter, whole, whole);
}

void PlotView::renderOwnAxis(QPainter& painter, const AxisState& state, Qt::Edge edge) {
    const Theme& theme = Theme::instance();
    const QRectF area = plotArea();
    const bool across = edge == Qt::BottomEdge;
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    const double side = edge == Qt::RightEdge ? area.right() : area.left();
    painter.setFont(font);
    const std::vector<double> ticks =
        state.ownTicks(across ? area.width() : area.height(), across ? columnPerTick : rowPerTick);
    std::vector<QRectF> taken;
    for (const double tick : ticks) {
        const QString text = state.ownLabel(tick, locale());
        const double wide = metrics.horizontalAdvance(text) + 2.0;
        QRectF box(0, 0, wide, metrics.height());
        painter.setPen(QPen(theme.grid(), 1));
        if (across) {
            const double x = area.left() + state.fraction(tick) * area.width();
            painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
            box.moveTop(area.bottom() + labelGap);
            box.moveLeft(std::min(x - wide / 2.0, width() - wide));
        } else {
            const double y = area.bottom() - state.fraction(tick) * area.height();
            if (edge == Qt::LeftEdge) {
                painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
            }
            box.moveTop(y - metrics.height() / 2.0);
            box.moveLeft(edge == Qt::LeftEdge ? side - labelGap - wide : side + labelGap);
        }
        // Of labels that would touch the first counts; a scale of its own has the weightiest first.
        const QRectF room = box.adjusted(-3.0, 0.0, 3.0, 0.0);
        if (std::any_of(taken.begin(), taken.end(),
                        [&](const QRectF& other) { return other.intersects(room); })) {
            continue;
        }
        taken.push_back(room);
        painter.setPen(theme.mutedText());
        painter.drawText(box, Qt::AlignCenter, text);
    }
    painter.setPen(QPen(theme.border(), 1));
    if (across) {
        painter.drawLine(area.bottomLeft(), area.bottomRight());
    } else {
        painter.drawLine(QPointF(side, area.top()), QPointF(side, area.bottom()));
    }
    if (state.spec.title.isEmpty()) {
        return;
    }
    painter.setPen(theme.mutedText());
    if (across) {
        painter.drawText(QRectF(area.left(), area.bottom() + 1.5 * labelGap + metrics.height(),
                                area.width(), metrics.height()),
                         Qt::AlignCenter, state.spec.title);
        return;
    }
    painter.save();
    painter.translate(edge == Qt::LeftEdge ? labelGap : width() - labelGap - metrics.height(),
                      area.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-area.height() / 2.0, 0.0, area.height(), metrics.height()),
                     Qt::AlignCenter,
                     metrics.elidedText(state.spec.title, Qt::ElideRight, area.height()));
    painter.restore();
}

void PlotView::renderCurves(QPainter& painter) {
    const QRectF area = plotArea();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(area);
    painter.setBrush(Qt::NoBrush);
    for (const auto& curve : curves_) {
        if (curve->shown && !curve->stretches.empty()) {
            // Round caps and joins are arcs to the stroker: three times the cost, and no pixel of
            // a smooth curve.
            painter.setPen(QPen(Theme::instance().curve(curve->style.colour), curve->style.width,
                                curve->style.pen, Qt::FlatCap, Qt::BevelJoin));
            for (const QPolygonF& stretch : curve->stretches) {
                painter.drawPolyline(stretch);
            }
        }
    }
    painter.restore();
    painter.save();
    painter.setClipRect(area.adjusted(-4, -4, 4, 4));
    for (const auto& curve : curves_) {
        if (!curve->shown) {
            continue;
        }
        const QColor colour = Theme::instance().curve(curve->style.colour);
        renderErrorBars(painter, *curve);
        if (curve->style.shape == Shape::Bars) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(colour);
            const double foot = axis(curve->style.side).spec.logarithmic
                                    ? area.bottom()
                                    : toPixel(0.0, 0.0, curve->style.side).y();
            for (std::size_t i = 0; i < curve->x.size(); ++i) {
                const double middle = curve->x[i] + curve->style.barShift;
                const double half = 0.5 * curve->style.barWidth;
                const QPointF left = toPixel(middle - half, curve->y[i], curve->style.side);
                const QPointF right = toPixel(middle + half, curve->y[i], curve->style.side);
                painter.drawRect(
                    QRectF(QPointF(left.x(), std::clamp(left.y(), area.top(), area.bottom())),
                           QPointF(right.x(), std::clamp(foot, area.top(), area.bottom())))
                        .normalized());
            }
        } else if (curve->style.shape != Shape::Line) {
            const bool hollow = curve->style.shape == Shape::Rings;
            painter.setPen(QPen(hollow ? colour : Theme::instance().panel(), hollow ? 1.6 : 1.0));
            painter.setBrush(hollow ? Theme::instance().panel() : colour);
            for (std::size_t i = 0; i < curve->x.size(); ++i) {
                painter.drawEllipse(toPixel(curve->x[i], curve->y[i], curve->style.side), 3.6, 3.6);
            }
        }
    }
    painter.restore();
}

void PlotView::renderErrorBars(QPainter& painter, const Curve& curve) {
    if (curve.low.size() != curve.x.size() || curve.high.size() != curve.x.size()) {
        return;
    }
    painter.setPen(QPen(Theme::instance().curve(curve.style.colour), 1.0));
    const bool upright = curve.bars == Qt::Vertical;
    const QPointF cap = upright ? QPointF(3, 0) : QPointF(0, 3);
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const auto end = [&](double value) {
            return upright ? toPixel(curve.x[i], value, curve.style.side)
                           : toPixel(value, curve.y[i], curve.style.side);
        };
        const QPointF low = end(curve.low[i]);
        const QPointF high = end(curve.high[i]);
        painter.drawLine(low, high);
        for (const QPointF& tip : {low, high}) {
            painter.drawLine(tip - cap, tip + cap);
        }
    }
}

void PlotView::paintEvent(QPaintEvent* /*event*/) {
    if (pictureStale_) {
        layoutChart();
        const qreal ratio = devicePixelRatioF();
        const QSize pixels = (QSizeF(size()) * ratio).toSize();
        if (picture_.size() != pixels || picture_.devicePixelRatio() != ratio) {
            for (QPixmap* layer : {&axesPicture_, &picture_}) {
                *layer = QPixmap(pixels);
                layer->setDevicePixelRatio(ratio);
            }
            axesStale_ = true;
        }
        if (axesStale_) {
            axesPicture_.fill(Theme::instance().panel());
            QPainter painter(&axesPicture_);
            renderAxes(painter);
            axesStale_ = false;
        }
        QPainter painter(&picture_);
        painter.drawPixmap(0, 0, axesPicture_);
        renderCurves(painter);
        pictureStale_ = false;
    }
    QPainter painter(this);
    painter.drawPixmap(0, 0, picture_);
    paintOverlay(painter);
    if (hasFocus()) {
        painter.setPen(QPen(Theme::instance().accent(), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void PlotView::paintOverlay(QPainter& painter) {
    const Theme& theme = Theme::instance();
    const QRectF area = plotArea();
    painter.setRenderHint(QPainter::Antialiasing);
    if (faded_) {
        QColor veil = theme.panel();
        veil.setAlphaF(0.62F);
        painter.fillRect(QRectF(0.0, headerHeight_, width(), height() - headerHeight_), veil);
    }
    painter.save();
    painter.setClipRect(area);
    paintLines(painter, area);
    if (presentX_) {
        const double px = toPixel(*presentX_, left_->low).x();
        painter.setPen(QPen(theme.accent(), 1.4));
        painter.drawLine(QPointF(px, area.top()), QPointF(px, area.bottom()));
        for (std::size_t i = 0; i < curves_.size(); ++i) {
            const Curve& curve = *curves_[i];
            const auto y = curve.shown ? valueAt(static_cast<int>(i), *presentX_) : std::nullopt;
            if (y) {
                painter.setPen(QPen(theme.panel(), 1.5));
                painter.setBrush(theme.curve(curve.style.colour));
                painter.drawEllipse(toPixel(*presentX_, *y, curve.style.side), 4.5, 4.5);
            }
        }
    }
    painter.restore();
    paintMarks(painter, area);
    if (faded_ && !fadedText_.isEmpty()) {
        painter.setFont(Theme::font(Theme::baseSize));
        painter.setPen(theme.mutedText());
        painter.drawText(area, Qt::AlignCenter, fadedText_);
    }
    if (pointRead_) {
        paintPointReadout(painter, area);
    } else if (cursorX_) {
        paintReadout(painter, area);
    }
}

void PlotView::paintLines(QPainter& painter, const QRectF& area) {
    const Theme& theme = Theme::instance();
    painter.setFont(Theme::font(Theme::smallSize));
    for (const Line& line : lines_) {
        const bool muted = line.colour == Line::muted;
        painter.setPen(QPen(muted ? theme.mutedText() : theme.curve(line.colour), 1.2,
                            muted ? Qt::DotLine : Qt::DashLine));
        if (line.orientation == Qt::Horizontal) {
            const double y = toPixel(x_->low, line.at, line.side).y();
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
            painter.drawText(QPointF(area.left() + labelGap, y - 4), line.text);
            continue;
        }
        const double x = toPixel(line.at, left_->low).x();
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        const double wide = painter.fontMetrics().horizontalAdvance(line.text);
        const bool fits = x + 4.0 + wide <= area.right();
        painter.drawText(QPointF(fits ? x + 4.0 : x - 4.0 - wide, area.top() + 14), line.text);
    }
}

void PlotView::paintMarks(QPainter& painter, const QRectF& area) {
    const Theme& theme = Theme::instance();
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    painter.setFont(font);
    std::vector<QRectF> taken;
    for (const Mark& mark : marks_) {
        const QPointF at = toPixel(mark.x, mark.y, mark.side);
        if (!area.adjusted(-1, -1, 1, 1).contains(at)) {
            continue;
        }
        const QColor colour = theme.curve(mark.colour);
        painter.setPen(QPen(mark.ring ? colour : theme.panel(), mark.ring ? 2.0 : 1.2));
        painter.setBrush(mark.ring ? QBrush(Qt::NoBrush) : QBrush(colour));
        const double radius = mark.ring ? 7.0 : 3.6;
        painter.drawEllipse(at, radius, radius);
        if (mark.text.isEmpty()) {
            continue;
        }
        // The label goes where it fits: right, left, above, below, and clear of earlier labels.
        const QSizeF size(metrics.horizontalAdvance(mark.text) + 6, metrics.height() + 1);
        const double away = radius + 3.0;
        const std::array<QPointF, 6> corners{at + QPointF(away, -size.height() / 2),
                                             at + QPointF(-away - size.width(), -size.height() / 2),
                                             at + QPointF(-size.width() / 2, -away - size.height()),
                                             at + QPointF(-size.width() / 2, away),
                                             at + QPointF(away, -away - size.height()),
                                             at + QPointF(away, away)};
        QRectF box(corners[0], size);
        for (const QPointF& corner : corners) {
            const QRectF candidate(corner, size);
            const bool free = std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) {
                return other.intersects(candidate);
            });
            if (area.contains(candidate) && free) {
                box = candidate;
                break;
            }
        }
        box.moveLeft(
            std::clamp(box.left(), area.left(), std::max(area.left(), area.right() - box.width())));
        box.moveTop(
            std::clamp(box.top(), area.top(), std::max(area.top(), area.bottom() - box.height())));
        taken.push_back(box);
        QColor back = theme.panel();
        back.setAlphaF(0.82F);
        painter.setPen(Qt::NoPen);
        painter.setBrush(back);
        painter.drawRoundedRect(box, 3, 3);
        painter.setPen(colour);
        painter.drawText(box, Qt::AlignCenter, mark.text);
    }
}

void PlotView::paintReadout(QPainter& painter, const QRectF& area) {
    const Theme& theme = Theme::instance();
    const double x = *cursorX_;
    const double px = toPixel(x, left_->low).x();
    if (px < area.left() - 0.5 || px > area.right() + 0.5) {
        return;
    }
    painter.setPen(QPen(theme.mutedText(), 1.0, Qt::DotLine));
    painter.drawLine(QPointF(px, area.top()), QPointF(px, area.bottom()));

    struct Row {
        QString text;
        QColor colour;
    };
    const QString xName = x_->spec.title.section(QLatin1Char(','), 0, 0);
    std::vector<Row> rows{{(xName.isEmpty() ? QStringLiteral("x") : xName) + QStringLiteral(" = ") +
                               readoutNumber(x, *x_),
                           theme.text()}};
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        const Curve& curve = *curves_[i];
        if (!curve.shown) {
            continue;
        }
        const auto y = valueAt(static_cast<int>(i), x);
        if (!y) {
            continue;
        }
        const AxisState& state = axis(curve.style.side);
        const QColor colour = theme.curve(curve.style.colour);
        rows.push_back(
            {curve.style.name + QStringLiteral(" = ") + readoutNumber(*y, state), colour});
        const QPointF at = toPixel(x, *y, curve.style.side);
        if (area.contains(at)) {
            painter.setPen(QPen(theme.panel(), 1.2));
            painter.setBrush(colour);
            painter.drawEllipse(at, 3.4, 3.4);
        }
    }
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    double width = 0.0;
    for (const Row& row : rows) {
        width = std::max(width, metrics.horizontalAdvance(row.text));
    }
    const double rowHeight = metrics.height() + 2;
    QRectF box(px + 10, area.top() + 6, width + 14,
               rowHeight * static_cast<double>(rows.size()) + 8);
    if (box.right() > area.right()) {
        box.moveRight(px - 10);
    }
    box.moveLeft(std::max(box.left(), area.left()));
    painter.setPen(QPen(theme.border(), 1.0));
    QColor back = theme.panel();
    back.setAlphaF(0.93F);
    painter.setBrush(back);
    painter.drawRoundedRect(box, 4, 4);
    painter.setFont(font);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        painter.setPen(rows[i].colour);
        painter.drawText(QRectF(box.left() + 7, box.top() + 4 + rowHeight * static_cast<double>(i),
                                width + 2, rowHeight),
                         Qt::AlignVCenter | Qt::AlignLeft, rows[i].text);
    }
}

void PlotView::paintPointReadout(QPainter& painter, const QRectF& area) {
    const Theme& theme = Theme::instance();
    const Curve& curve = *curves_[pointRead_->first];
    const std::size_t i = pointRead_->second;
    const QPointF at = toPixel(curve.x[i], curve.y[i], curve.style.side);
    if (!area.adjusted(-1, -1, 1, 1).contains(at)) {
        return;
    }
    painter.setPen(QPen(theme.text(), 1.6));
    painter.setBrush(theme.curve(curve.style.colour));
    painter.drawEllipse(at, 5.0, 5.0);
    const QStringList rows = curve.texts[static_cast<qsizetype>(i)].split(QLatin1Char('\n'));
    const QFont font = Theme::font(Theme::smallSize);
    const QFontMetricsF metrics(font);
    double wide = 0.0;
    for (const QString& row : rows) {
        wide = std::max(wide, metrics.horizontalAdvance(row));
    }
    const double rowHeight = metrics.height() + 2.0;
    QRectF box(at + QPointF(12.0, 8.0),
               QSizeF(wide + 14.0, rowHeight * static_cast<double>(rows.size()) + 8.0));
    if (box.right() > area.right()) {
        box.moveRight(at.x() - 12.0);
    }
    box.moveLeft(std::max(box.left(), area.left()));
    if (box.bottom() > area.bottom()) {
        box.moveBottom(at.y() - 8.0);
    }
    painter.setPen(QPen(theme.border(), 1.0));
    QColor back = theme.panel();
    back.setAlphaF(0.95F);
    painter.setBrush(back);
    painter.drawRoundedRect(box, 4, 4);
    painter.setFont(font);
    painter.setPen(theme.text());
    for (qsizetype row = 0; row < rows.size(); ++row) {
        painter.drawText(
            QRectF(box.left() + 7.0, box.top() + 4.0 + rowHeight * static_cast<double>(row),
                   wide + 2.0, rowHeight),
            Qt::AlignVCenter | Qt::AlignLeft, rows[row]);
    }
}

void PlotView::renderTo(QPainter& painter, const QRectF& target) {
    layoutChart();
    painter.save();
    painter.translate(target.topLeft());
    painter.scale(target.width() / width(), target.height() / height());
    painter.fillRect(QRectF(rect()), Theme::instance().panel());
    renderAxes(painter);
    renderCurves(painter);
    paintOverlay(painter);
    for (const auto& curve : curves_) {
        if (curve->button != nullptr && curve->shown && !curve->button->isHidden()) {
            curve->button->draw(painter, QRectF(curve->button->geometry()));
        }
    }
    painter.restore();
    pictureStale_ = true;
}

QString PlotView::exportPicture(const QString& path) {
    return writePicture(path, size(), title_, [this](QPainter& painter, double scale) {
        renderTo(painter, QRectF(QPointF(), QSizeF(size()) * scale));
    });
}

QString PlotView::writePicture(const QString& path, const QSize& size, const QString& title,
                               const std::function<void(QPainter&, double)>& draw) {
    if (path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)) {
        QSvgGenerator generator;
        generator.setFileName(path);
        generator.setResolution(96);  // or text comes out at three quarters of its size
        generator.setSize(size);
        generator.setViewBox(QRect(QPoint(), size));
        generator.setTitle(title);
        QPainter painter;
        if (!painter.begin(&generator)) {
            return tr("%1 cannot be written.").arg(path);
        }
        draw(painter, 1.0);
        return {};
    }
    constexpr int scale = 2;
    QImage image(size * scale, QImage::Format_RGB32);
    image.fill(Theme::instance().window());
    QPainter painter(&image);
    draw(painter, scale);
    painter.end();
    return image.save(path, "PNG") ? QString() : tr("%1 cannot be written.").arg(path);
}

}  // namespace ravnoves
