#include "workshop/card_page.h"

#include <QFontMetricsF>
#include <QTextLayout>
#include <QTextOption>
#include <algorithm>
#include <cmath>

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
    painter_.setPen(QPen(colour, thickness * unit_));
    painter_.drawLine(rect(x1, y1, 0, 0).topLeft(), rect(x2, y2, 0, 0).topLeft());
}

void CardPage::box(double x, double y, double w, double h, const QColor& fill, const QColor& border,
                   double thickness) {
    painter_.setPen(border.isValid() ? QPen(border, thickness * unit_) : QPen(Qt::NoPen));
    painter_.setBrush(fill.isValid() ? QBrush(fill) : QBrush(Qt::NoBrush));
    painter_.drawRect(rect(x, y, w, h));
    painter_.setBrush(Qt::NoBrush);
}

void CardPage::text(double x, double y, double w, const QString& text, double points,
                    Qt::Alignment align, bool bold, const QColor& colour) {
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

std::vector<QString> CardPage::wrappedRows(const QString& text, const QFont& face, double w,
                                           int lines) const {
    QTextLayout layout(text, face);
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    std::vector<QString> rows;
    layout.beginLayout();
    for (;;) {
        QTextLine row = layout.createLine();
        if (!row.isValid()) {
            break;
        }
        row.setLineWidth(w * unit_);
        if (static_cast<int>(rows.size()) + 1 == lines) {
            rows.push_back(QFontMetricsF(face).elidedText(text.mid(row.textStart()).simplified(),
                                                          Qt::ElideRight, w * unit_ + 0.5));
            break;
        }
        rows.push_back(text.mid(row.textStart(), row.textLength()).trimmed());
    }
    layout.endLayout();
    return rows;
}

double CardPage::heightOf(const QString& text, double points, double w) const {
    constexpr int any = 100;
    return text.isEmpty()
               ? 0.0
               : static_cast<double>(wrappedRows(text, font(points, false), w, any).size()) *
                     lineHeight(points);
}

double CardPage::paragraph(double x, double y, double w, const QString& text, double points,
                           int lines, bool bold, const QColor& colour) {
    if (text.isEmpty()) {
        return 0.0;
    }
    const QFont face = font(points, bold);
    const std::vector<QString> rows = wrappedRows(text, face, w, lines);
    painter_.setFont(face);
    painter_.setPen(colour);
    double at = y;
    for (const QString& row : rows) {
        if (!measuring_) {
            painter_.drawText(rect(x, at, w, lineHeight(points)),
                              Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, row);
        }
        at += lineHeight(points);
    }
    return at - y;
}

void CardPage::heading(double x, double y, double w, const QString& title) {
    text(x, y, w, title, 9.5, Qt::AlignLeft, true);
    line(x, y + 4.6, x + w, y + 4.6, 0.3, ink);
}

void CardPage::blank(double x, double y, double w, const QString& caption, const QString& value) {
    text(x, y, w - 2, caption, 7, Qt::AlignLeft, false, grey);
    if (textWidth(value, smallestType, true) <= w - 2) {
        text(x, y + 3.2, w - 2, value, 10, Qt::AlignLeft, true);
    } else {
        paragraph(x, y + 2.8, w - 2, value, smallestType, 2);
    }
    line(x, y + 8.2, x + w - 3, y + 8.2, 0.15, hair);
}

double CardTable::tableWidth() const {
    double sum = 0.0;
    for (const Column& column : columns_) {
        sum += column.width;
    }
    return sum;
}

double CardTable::draw(CardPage& page, double x, double y) const {
    double at = y;
    const double width = tableWidth();
    if (!head_.isEmpty()) {
        drawCells(page, x, at, head_, false, true);
        at += rowHeight_;
        page.line(x, at, x + width, at, 0.2, CardPage::ink);
    }
    for (const Row& row : rows_) {
        if (row.shaded) {
            page.box(x, at, width, rowHeight_, CardPage::shade, QColor());
        }
        drawCells(page, x, at, row.cells, row.bold, false);
        at += rowHeight_;
        page.line(x, at, x + width, at, 0.1, CardPage::hair);
    }
    return at - y;
}

void CardTable::drawCells(CardPage& page, double x, double y, const QStringList& texts, bool bold,
                          bool caption) const {
    const double inset = (rowHeight_ - page.lineHeight(points_)) / 2.0;
    for (std::size_t i = 0; i < columns_.size() && i < static_cast<std::size_t>(texts.size());
         ++i) {
        page.text(x + 0.6, y + inset, columns_[i].width - 1.2, texts.at(static_cast<qsizetype>(i)),
                  caption ? points_ - 0.7 : points_, columns_[i].align, bold,
                  caption ? CardPage::grey : CardPage::ink);
        x += columns_[i].width;
    }
}

}  // namespace ravnoves
