#include "plot/legend_item.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <cmath>
#include <utility>

#include "plot/plot_painter.h"
#include "text/text_width.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

constexpr double inset = 5.0;

double strokeLength() {
    return 18.0 * strokeScale();
}
double strokeWidth() {
    return 2.6 * strokeScale();
}
constexpr int wrapped = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap;

/// A stroke whose dashes fill the short sample evenly; Qt's own end in a sliver.
QPen samplePen(const QColor& colour, Qt::PenStyle style) {
    QPen pen(colour, strokeWidth(), style, Qt::FlatCap);
    if (style == Qt::DashLine) {
        pen.setDashPattern({7.0 / 2.6, 4.0 / 2.6});  // 7 + 4 + 7 of 18
    } else if (style == Qt::DotLine) {
        pen.setDashPattern({2.4 / 2.6, 2.8 / 2.6});  // four dots
    }
    return pen;
}

QFont itemFont() {
    return Theme::font(Theme::smallSize + 1);
}

}  // namespace

LegendItem::LegendItem(QWidget* parent) : QAbstractButton(parent) {
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::ArrowCursor);
}

void LegendItem::setName(const QString& name) {
    if (std::exchange(name_, name) != name) {
        updateGeometry();
        update();
    }
}

void LegendItem::setSwatch(const QColor& colour, Qt::PenStyle pen, plot::Shape shape) {
    colour_ = colour;
    pen_ = pen;
    shape_ = shape;
    update();
}

QSize LegendItem::sizeHint() const {
    const QFontMetricsF metrics(itemFont());
    return {static_cast<int>(std::ceil(strokeLength() + 3 * inset + textWidth(itemFont(), name_))),
            static_cast<int>(std::ceil(metrics.height())) + Theme::gap};
}

int LegendItem::heightForWidth(int width) const {
    const QSize whole = sizeHint();
    if (width >= whole.width()) {
        return whole.height();
    }
    const QRectF room(0.0, 0.0, width - 2.0 * inset - strokeLength(), 1e4);
    return static_cast<int>(
               std::ceil(QFontMetricsF(itemFont()).boundingRect(room, wrapped, name_).height())) +
           Theme::gap;
}

bool LegendItem::isElided() const {
    return height() < heightForWidth(width()) ||
           (width() < sizeHint().width() &&
            QFontMetricsF(itemFont())
                    .boundingRect(QRectF(0.0, 0.0, width() - 2.0 * inset - strokeLength(), 1e4),
                                  wrapped, name_)
                    .width() > width() - 2.0 * inset - strokeLength());
}

void LegendItem::draw(QPainter& painter, const QRectF& rect) const {
    QColor stroke = colour_;
    if (!isChecked()) {
        stroke.setAlphaF(0.35F);
    }
    // In the first line of several.
    const double middle = rect.width() < sizeHint().width()
                              ? rect.top() + 0.5 * (Theme::gap + QFontMetricsF(itemFont()).height())
                              : rect.center().y();
    painter.setRenderHint(QPainter::Antialiasing);
    if (shape_ == plot::Shape::Points || shape_ == plot::Shape::Rings) {
        const bool hollow = shape_ == plot::Shape::Rings;
        painter.setPen(hollow ? QPen(stroke, 1.6 * strokeScale()) : QPen(Qt::NoPen));
        painter.setBrush(hollow ? QBrush(Qt::NoBrush) : QBrush(stroke));
        const double radius = strokeScale() * (hollow ? 4.6 : 3.6);
        painter.drawEllipse(QPointF(rect.left() + inset + strokeLength() / 2.0, middle), radius,
                            radius);
    } else if (pen_ == Qt::NoPen) {
        painter.fillRect(QRectF(rect.left() + inset, middle - 0.275 * strokeLength(),
                                strokeLength(), 0.55 * strokeLength()),
                         stroke);
    } else {
        painter.setPen(samplePen(stroke, pen_));
        painter.drawLine(QPointF(rect.left() + inset, middle),
                         QPointF(rect.left() + inset + strokeLength(), middle));
    }
    QFont font = itemFont();
    font.setStrikeOut(!isChecked());
    painter.setFont(font);
    painter.setPen(isChecked() ? Theme::instance().text() : Theme::instance().mutedText());
    const QRectF room = rect.adjusted(2 * inset + strokeLength(), 0, 0, 0);
    if (isElided()) {
        painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(name_, Qt::ElideMiddle,
                                                          static_cast<int>(room.width())));
    } else if (rect.width() < sizeHint().width()) {
        painter.drawText(room, wrapped, name_);
    } else {
        painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, name_);
    }
}

bool LegendItem::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip && isElided()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                           name_ + QLatin1Char('\n') + toolTip(), this);
        return true;
    }
    return QAbstractButton::event(event);
}

void LegendItem::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    if (underMouse() || hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(hasFocus() ? QPen(Theme::instance().accent(), 1.0) : QPen(Qt::NoPen));
        painter.setBrush(Theme::instance().grid());
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    }
    draw(painter, QRectF(rect()));
}

void LegendItem::enterEvent(QEnterEvent* /*event*/) {
    update();
}
void LegendItem::leaveEvent(QEvent* /*event*/) {
    update();
}

}  // namespace ravnoves
