#include "shop/card_page.h"

#include <QFontMetricsF>
#include <QTextLayout>
#include <QTextOption>
#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/units.h"

namespace ravnoves {

namespace {
constexpr double millimetresPerPoint = units::inch.to_si / units::mm / 72.0;
}  // namespace

const QColor CardPage::ink(0x11, 0x11, 0x11);
const QColor CardPage::grey(0x55, 0x55, 0x55);
const QColor CardPage::hair(0x99, 0x99, 0x99);
const QColor CardPage::shade(0xEE, 0xEE, 0xEE);
const QColor CardPage::amber(0x9A, 0x67, 0x00);
const QColor CardPage::red(0xB0, 0x20, 0x20);

CardPage::CardPage(QPainter& painter, const QRectF& page)
    : painter_(painter), page_(page), unit_(page.width() / width) {
    painter_.setRenderHint(QPainter::Antialiasing);
}

QFont CardPage::font(double points, bool bold) const {
    QFont font(QStringLiteral("DejaVu Sans Condensed"));
    font.setPixelSize(
        std::max(1, static_cast<int>(std::lround(points * millimetresPerPoint * unit_))));
    font.setBold(bold);
    font.setHintingPreference(QFont::PreferNoHinting);
    // Without ligatures, so that "fl" in the text of the PDF is found by a search for it.
    font.setStyleStrategy(QFont::PreferNoShaping);
    return font;
}

QRectF CardPage::rect(double x, double y, double w, double h) const {
    return {page_.x() + x * unit_, page_.y() + y * unit_, w * unit_, h * unit_};
}

double CardPage::lineHeight(double points) const {
    return points * millimetresPerPoint * 1.28;
}

double CardPage::textWidth(const QString& text, double points, bool bold) const {
    return QFontMetricsF(font(points, bold)).horizontalAdvance(text) / unit_;
}

void CardPage::line(double x1, double y1, double x2, double y2, double thickness,
                    const QColor& colour) {
    if (measuring_) {
        return;
    }
    painter_.setPen(QPen(colour, thickness * unit_));
    painter_.drawLine(rect(x1, y1, 0, 0).topLeft(), rect(x2, y2, 0, 0).topLeft());
}

void CardPage::box(double x, double y, double w, double h, const QColor& fill, const QColor& border,
                   double thickness) {
    if (measuring_) {
        return;
    }
    painter_.setPen(border.isValid() ? QPen(border, thickness * unit_) : QPen(Qt::NoPen));
    painter_.setBrush(fill.isValid() ? QBrush(fill) : QBrush(Qt::NoBrush));
    painter_.drawRect(rect(x, y, w, h));
    painter_.setBrush(Qt::NoBrush);
}

void CardPage::text(double x, double y, double w, const QString& text, double points,
                    Qt::Alignment align, bool bold, const QColor& colour) {
    if (measuring_) {
        return;
    }
    double size = points;
    while (size > smallestType && textWidth(text, size, bold) > w) {
        size = std::max(smallestType, size - 0.25);
    }
    const QFont face = font(size, bold);
    painter_.setFont(face);
    painter_.setPen(colour);
    const QString shown = QFontMetricsF(face).elidedText(text, Qt::ElideRight, w * unit_ + 0.5);
    painter_.drawText(rect(x, y, w, lineHeight(points)),
                      static_cast<int>(align) | Qt::AlignVCenter | Qt::TextSingleLine, shown);
}

std::vector<QString> CardPage::wrappedRows(const QString& text, const QFont& face, double width) {
    QTextLayout layout(text, face);
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    std::vector<QString> rows;
    layout.beginLayout();
    for (QTextLine row = layout.createLine(); row.isValid(); row = layout.createLine()) {
        row.setLineWidth(width);
        rows.push_back(text.mid(row.textStart(), row.textLength()).trimmed());
    }
    layout.endLayout();
    return rows;
}

double CardPage::heightOf(const QString& text, double points, double w, bool bold) const {
    return text.isEmpty()
               ? 0.0
               : static_cast<double>(wrappedRows(text, font(points, bold), w * unit_).size()) *
                     lineHeight(points);
}

double CardPage::paragraph(double x, double y, double w, const QString& text, double points,
                           bool bold, const QColor& colour, Qt::Alignment align) {
    if (text.isEmpty()) {
        return 0.0;
    }
    const QFont face = font(points, bold);
    double at = y;
    for (const QString& each : wrappedRows(text, face, w * unit_)) {
        if (!measuring_) {
            painter_.setFont(face);
            painter_.setPen(colour);
            painter_.drawText(rect(x, at, w, lineHeight(points)),
                              static_cast<int>(align) | Qt::AlignVCenter | Qt::TextSingleLine,
                              each);
        }
        at += lineHeight(points);
    }
    return at - y;
}

void CardPage::heading(double x, double y, double w, const QString& title) {
    text(x, y, w, title, 9.5, Qt::AlignLeft, true);
    line(x, y + 4.6, x + w, y + 4.6, 0.3, ink);
}

double CardPage::blank(double x, double y, double w, const QString& caption, const QString& value) {
    constexpr double height = 8.2;
    text(x, y, w - 2, caption, 7, Qt::AlignLeft, false, grey);
    double end = y + height;
    if (textWidth(value, smallestType, true) <= w - 2) {
        text(x, y + 3.2, w - 2, value, 10, Qt::AlignLeft, true);
    } else {
        end = std::max(end, y + 2.8 + paragraph(x, y + 2.8, w - 2, value, smallestType));
    }
    line(x, end, x + w - 3, end, 0.15, hair);
    return end - y;
}

void CardPage::setFoot(double y, std::function<void()> paint) {
    end_ = y;
    foot_ = std::move(paint);
}

void CardPage::finishSheet() {
    if (const auto paint = std::exchange(foot_, {})) {
        paint();
    }
}

double CardPage::nextSheet() {
    finishSheet();
    ++number_;
    end_ = bottom;
    return next_ ? next_() : top;
}

double CardPage::heightOf(const Section& section) {
    const bool before = std::exchange(measuring_, true);
    const double height = section(0.0);
    measuring_ = before;
    return height;
}

double CardPage::place(double y, const Section& section) {
    return section(y + heightOf(section) > end_ ? nextSheet() : y);
}

double CardPage::flow(double y, const QString& text, double points, const QColor& colour) {
    if (text.isEmpty()) {
        return y;
    }
    for (const QString& each : wrappedRows(text, font(points), full * unit_)) {
        y = place(y, [&](double at) {
            return at + paragraph(left, at, full, each, points, false, colour);
        });
    }
    return y;
}

double CardTable::tableWidth() const {
    double sum = 0.0;
    for (const Column& column : columns_) {
        sum += column.width;
    }
    return sum;
}

double CardTable::draw(CardPage& page, const Results& results, double x, double y) const {
    if (results.rows.isEmpty()) {
        return 0.0;
    }
    double at = y;
    const double width = tableWidth();
    QStringList head;
    for (const ResultColumn& column : results.columns) {
        head << column.heading;
    }
    if (!head.isEmpty()) {
        drawCells(page, x, at, head, false, true);
        at += heightOf(page, head, false);
        page.line(x, at, x + width, at, 0.2, CardPage::ink);
    }
    for (const ResultRow& row : results.rows) {
        const bool isLast = bold_ == Bold::Last && &row == &results.rows.constLast();
        const bool bold = isLast || bold_ == Bold::All;
        const double height = heightOf(page, row.texts(), bold);
        if (isLast) {
            page.box(x, at, width, height, CardPage::shade, QColor());
        }
        drawCells(page, x, at, row.texts(), bold, false);
        at += height;
        page.line(x, at, x + width, at, 0.1, CardPage::hair);
    }
    return at - y;
}

double CardTable::heightOf(const CardPage& page, const QStringList& texts, bool bold) const {
    double height = rowHeight_;
    for (std::size_t i = 0; i < columns_.size() && i < static_cast<std::size_t>(texts.size());
         ++i) {
        const QString& text = texts.at(static_cast<qsizetype>(i));
        const double room = columns_[i].width - 2.0 * inset;
        if (page.textWidth(text, wrappedType(), bold) > room) {
            height = std::max(height, page.heightOf(text, wrappedType(), room, bold) + inset);
        }
    }
    return height;
}

void CardTable::drawCells(CardPage& page, double x, double y, const QStringList& texts, bool bold,
                          bool caption) const {
    const double above = (rowHeight_ - page.lineHeight(points_)) / 2.0;
    const QColor& colour = caption ? CardPage::grey : CardPage::ink;
    for (std::size_t i = 0; i < columns_.size() && i < static_cast<std::size_t>(texts.size());
         ++i) {
        const QString& text = texts.at(static_cast<qsizetype>(i));
        const double room = columns_[i].width - 2.0 * inset;
        if (page.textWidth(text, wrappedType(), bold) > room) {
            page.paragraph(x + inset, y + 0.5 * inset, room, text, wrappedType(), bold, colour,
                           columns_[i].align);
        } else {
            page.text(x + inset, y + above, room, text, caption ? points_ - 0.7 : points_,
                      columns_[i].align, bold, colour);
        }
        x += columns_[i].width;
    }
}

}  // namespace ravnoves
