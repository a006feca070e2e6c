#include "widgets/cell_delegate.h"

#include <QApplication>
#include <QPainter>
#include <QStyle>
#include <QtMath>

#include "text/text_width.h"

namespace ravnoves {

namespace {

QRect roomFor(const QStyleOptionViewItem& option) {
    const QStyle& style = option.widget != nullptr ? *option.widget->style() : *qApp->style();
    const int margin = style.pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, option.widget) + 1;
    return option.rect.adjusted(margin, 0, -margin, 0);
}

bool goesOnBelow(const QStyleOptionViewItem& option) {
    return option.rect.height() >= 2 * option.fontMetrics.lineSpacing();
}

/// What of a text has room in one line: its end is the unit that it has.
QString shortened(const QStyleOptionViewItem& option, const QString& text, int room) {
    constexpr qsizetype longestUnit = 10;
    const qsizetype comma = text.lastIndexOf(QLatin1String(", "));
    if (comma > 0 && text.size() - comma <= longestUnit) {
        const QString unit = text.mid(comma);
        const int left = room - qCeil(textWidth(option.font, unit));
        if (3 * left > room) {
            return option.fontMetrics.elidedText(text.left(comma), Qt::ElideRight, left) + unit;
        }
    }
    return option.fontMetrics.elidedText(text, option.textElideMode, room);
}

}  // namespace

void CellDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    const int room = roomFor(*option).width();
    if (room > 0 && option->textElideMode == Qt::ElideRight && !goesOnBelow(*option) &&
        textWidth(option->font, option->text) > room) {
        option->text = shortened(*option, option->text, room);
    }
}

void CellDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
    constexpr QStyle::State marked =
        QStyle::State_Selected | QStyle::State_HasFocus | QStyle::State_MouseOver;
    const auto has = [&index](Qt::ItemDataRole role) { return index.data(role).isValid(); };
    const QString text = index.data(Qt::DisplayRole).toString();
    if ((option.state & marked) != 0 || has(Qt::DecorationRole) || has(Qt::CheckStateRole) ||
        has(Qt::BackgroundRole) || has(Qt::FontRole) || text.contains(QLatin1Char('\n')) ||
        text.isRightToLeft()) {
        QStyledItemDelegate::paint(painter, option, index);
        return;
    }
    const QRect room = roomFor(option);
    QString shown = text;
    double width = textWidth(option.font, text);
    if (width > room.width() && goesOnBelow(option)) {
        QStyledItemDelegate::paint(painter, option, index);  // it goes on in a second line
        return;
    }
    if (width > room.width()) {
        shown = shortened(option, text, room.width());
        width = textWidth(option.font, shown);
    }
    const QVariant asked = index.data(Qt::TextAlignmentRole);
    const Qt::Alignment side =
        asked.isValid() ? Qt::Alignment(asked.toInt()) : option.displayAlignment;
    const double free = room.width() - width;
    const double x = side.testFlag(Qt::AlignRight)     ? free
                     : side.testFlag(Qt::AlignHCenter) ? 0.5 * free
                                                       : 0.0;
    // Rows are of whole pixels, as the style has them.
    const QFontMetricsF metrics(option.font);
    const QRect line = QStyle::alignedRect(option.direction, side,
                                           QSize(room.width(), qCeil(metrics.height())), room);
    const QVariant ink = index.data(Qt::ForegroundRole);
    const QPalette::ColorGroup group =
        (option.state & QStyle::State_Enabled) == 0  ? QPalette::Disabled
        : (option.state & QStyle::State_Active) != 0 ? QPalette::Active
                                                     : QPalette::Inactive;
    painter->setFont(option.font);
    painter->setPen(ink.isValid() ? qvariant_cast<QBrush>(ink).color()
                                  : option.palette.color(group, QPalette::Text));
    painter->drawText(QPointF(room.left() + x, line.top() + metrics.ascent()), shown);
}

}  // namespace ravnoves
