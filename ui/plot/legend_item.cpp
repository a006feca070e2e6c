#include "plot/legend_item.h"

#include <QPainter>
#include <cmath>
#include <numeric>
#include <utility>

#include "plot/plot_painter.h"
#include "text/text_width.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

constexpr double inset = 5.0;

constexpr double strokeWidth = 2.6;
double strokeLength() {
    return 18.0 * strokeScale();
}
constexpr int wrapped = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap;

/// A stroke whose dashes fill the short sample evenly; Qt's own end in a sliver.
QPen samplePen(const QColor& colour, Qt::PenStyle style) {
    QPen pen(colour, strokeWidth * strokeScale(), style, Qt::FlatCap);
    if (style != Qt::SolidLine) {
        QList<qreal> dashes = pen.dashPattern();
        const double period = std::accumulate(dashes.begin(), dashes.end(), 0.0);
        const double whole = dashes.front() + period * std::ceil(6.0 / period);
        for (qreal& each : dashes) {
            each *= strokeLength() / (whole * pen.widthF());
        }
        pen.setDashPattern(dashes);
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
    setAttribute(Qt::WA_Hover);  // painted anew as the pointer comes and goes
}

void LegendItem::setName(const QString& name) {
    if (std::exchange(name_, name) != name) {
        updateGeometry();
        update();
    }
}

void LegendItem::setSwatch(std::optional<Role> role, plot::Shape shape) {
    role_ = role;
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

void LegendItem::draw(QPainter& painter, const QRectF& rect) const {
    // In the first line of several.
    const bool isWrapped = rect.width() < sizeHint().width();
    const double middle = isWrapped
                              ? rect.top() + 0.5 * (Theme::gap + QFontMetricsF(itemFont()).height())
                              : rect.center().y();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setOpacity(!isChecked() ? 0.35 : role_ ? 1.0 : 0.4);
    const RoleLook look = lookOf(role_.value_or(Role::Limit));
    const QColor colour = Theme::instance().colour(look.role);
    const QPointF left(rect.left() + inset, middle);
    const QPointF centre = left + QPointF(strokeLength() / 2.0, 0.0);
    if (shape_ == plot::Shape::Line || shape_ == plot::Shape::LineAndPoints) {
        painter.setPen(samplePen(colour, role_ ? look.pen : Qt::SolidLine));
        painter.drawLine(left, left + QPointF(strokeLength(), 0.0));
    }
    if (shape_ == plot::Shape::Bars) {
        const painter_parts::BarFill fill(look.role);
        painter.setPen(role_ ? fill.edge : Qt::NoPen);
        painter.setBrush(role_ ? fill.inside : colour);
        painter.drawRect(QRectF(left - QPointF(0.0, 0.275 * strokeLength()),
                                QSizeF(strokeLength(), 0.55 * strokeLength())));
    } else if (shape_ != plot::Shape::Line) {
        const bool hollow = shape_ == plot::Shape::Rings;
        painter_parts::paintMarker(painter, look.marker, centre,
                                   strokeScale() * (hollow ? 4.6 : 3.6),
                                   hollow ? QPen(colour, 1.6 * strokeScale()) : QPen(Qt::NoPen),
                                   hollow ? QBrush(Qt::NoBrush) : QBrush(colour));
    }
    painter.setOpacity(1.0);
    QFont font = itemFont();
    font.setStrikeOut(!isChecked());
    painter.setFont(font);
    painter.setPen(isChecked() ? Theme::instance().text() : Theme::instance().mutedText());
    const QRectF room = rect.adjusted(2 * inset + strokeLength(), 0, 0, 0);
    painter.drawText(room, isWrapped ? wrapped : Qt::AlignLeft | Qt::AlignVCenter, name_);
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

}  // namespace ravnoves
