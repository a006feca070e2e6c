#include "widgets/changing_label.h"

#include <QPaintEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace ravnoves {

namespace {

/// Not rounded, as in QPainter.
double bottomOf(const QTextLine& line) {
    return line.y() + line.ascent() + line.descent();
}

}  // namespace

ChangingLabel::ChangingLabel(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    setWordWrap(true);
}

void ChangingLabel::setText(const QString& text) {
    if (text == QLabel::text()) {
        return;
    }
    if (!isVisible() || !updatesEnabled() || !isPlain() || paragraphs_.empty()) {
        QLabel::setText(text);
        return;
    }
    struct Line {
        double y = 0.0;
        double height = 0.0;
        QString text;
        bool operator==(const Line&) const = default;
    };
    const auto lines = [this] {
        std::vector<Line> all;
        for (const Paragraph& paragraph : paragraphs_) {
            for (int i = 0; i < paragraph.layout->lineCount(); ++i) {
                const QTextLine line = paragraph.layout->lineAt(i);
                all.push_back({offset() + paragraph.top + line.y(), line.height(),
                               paragraph.text.mid(line.textStart(), line.textLength())});
            }
        }
        return all;
    };
    const std::vector<Line> before = lines();
    setAttribute(Qt::WA_UpdatesDisabled);  // not all of it
    QLabel::setText(text);
    setAttribute(Qt::WA_UpdatesDisabled, false);
    layOut();
    const std::vector<Line> after = lines();
    // Lines that are the same from the top, and those from the bottom, stay.
    const auto firsts = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
    const auto lasts = std::mismatch(before.rbegin(), std::reverse_iterator(firsts.first),
                                     after.rbegin(), std::reverse_iterator(firsts.second));
    double top = height();
    double bottom = 0.0;
    const auto add = [&](const Line& line) {
        top = std::min(top, line.y);
        bottom = std::max(bottom, line.y + line.height);
    };
    std::for_each(firsts.first, lasts.first.base(), add);
    std::for_each(firsts.second, lasts.second.base(), add);
    // A glyph may reach a pixel beyond its line.
    if (top < bottom) {
        update(0, static_cast<int>(std::floor(top)) - 1, width(),
               static_cast<int>(std::ceil(bottom - std::floor(top))) + 2);
    }
}

void ChangingLabel::layOut() {
    if (const int width = contentsRect().width(); width != width_ || font() != font_) {
        paragraphs_.clear();
        width_ = width;
        font_ = font();
    }
    QTextOption option;
    option.setWrapMode(QTextOption::WordWrap);
    option.setTextDirection(layoutDirection());
    const QStringList texts = text().split(QLatin1Char('\n'));
    const auto wanted = static_cast<std::size_t>(texts.size());
    const double leading = QFontMetricsF(font_).leading();
    paragraphs_.resize(wanted);
    double top = 0.0;
    for (std::size_t i = 0; i < wanted; ++i) {
        Paragraph& paragraph = paragraphs_[i];
        const QString& text = texts[static_cast<qsizetype>(i)];
        if (paragraph.layout == nullptr || paragraph.text != text) {
            paragraph.text = text;
            paragraph.layout = std::make_unique<QTextLayout>(text, font_);
            paragraph.layout->setTextOption(option);
            paragraph.layout->setCacheEnabled(true);
            paragraph.layout->beginLayout();
            paragraph.height = 0.0;
            for (QTextLine line = paragraph.layout->createLine(); line.isValid();
                 line = paragraph.layout->createLine()) {
                line.setLineWidth(std::max(0, width_));
                // As QPainter does it.
                const double y =
                    paragraph.height == 0.0 ? 0.0 : std::ceil(paragraph.height + leading);
                line.setPosition({0.0, y});
                paragraph.height = bottomOf(line);
            }
            paragraph.layout->endLayout();
        }
        paragraph.top = i == 0 ? 0.0 : std::ceil(top + leading);
        top = paragraph.top + paragraph.height;
    }
}

double ChangingLabel::bottom() const {
    const double room = contentsRect().height();
    for (const Paragraph& paragraph : paragraphs_) {
        for (int i = 0; i < paragraph.layout->lineCount(); ++i) {
            if (const double bottom = paragraph.top + bottomOf(paragraph.layout->lineAt(i));
                bottom >= room) {
                return bottom;
            }
        }
    }
    return paragraphs_.back().top + paragraphs_.back().height;
}

double ChangingLabel::offset() const {
    const double free = contentsRect().height() - bottom();
    const double down = alignment() & Qt::AlignVCenter  ? free / 2.0
                        : alignment() & Qt::AlignBottom ? free
                                                        : 0.0;
    return contentsRect().top() + down;
}

bool ChangingLabel::isPlain() const {
    return textInteractionFlags() == Qt::NoTextInteraction && isEnabled() && margin() == 0 &&
           (alignment() & (Qt::AlignRight | Qt::AlignHCenter)) == 0;
}

void ChangingLabel::paintEvent(QPaintEvent* event) {
    if (!isPlain() || text().isEmpty()) {
        paragraphs_.clear();
        QLabel::paintEvent(event);
        return;
    }
    layOut();
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    const QPointF place(contentsRect().left(), offset());
    // A text that has too little room goes to its end.
    painter.setClipRect(contentsRect());
    const double end = place.y() + bottom();
    const QRectF wanted = event->rect();
    for (const Paragraph& paragraph : paragraphs_) {
        const QPointF at = place + QPointF(0.0, paragraph.top);
        for (int i = 0; i < paragraph.layout->lineCount(); ++i) {
            const QTextLine line = paragraph.layout->lineAt(i);
            const double top = at.y() + line.y();
            if (top < end && top + line.height() + 1.0 >= wanted.top() &&
                top - 1.0 <= wanted.bottom()) {
                line.draw(&painter, at);
            }
        }
    }
}

}  // namespace ravnoves
