#include "widgets/answer_label.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QPainter>
#include <QtMath>
#include <algorithm>

namespace ravnoves {

AnswerLabel::AnswerLabel(QWidget* parent) : QLabel(parent) {
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    auto* copy = new QAction(tr("Copy text"), this);
    connect(copy, &QAction::triggered, this, [this] {
        QString lines = text();
        QGuiApplication::clipboard()->setText(lines.remove(QChar(0x2060)));  // holds units together
    });
    addAction(copy);
    setContextMenuPolicy(Qt::ActionsContextMenu);
}

const QStaticText& AnswerLabel::laidOut(int width) const {
    constexpr int maximum = 16;  // widths; a layout asks for some at every step of a window's edge
    if (text_ != text() || font_ != font() || laidOut_.size() > maximum) {
        laidOut_.clear();
        text_ = text();
        font_ = font();
    }
    QStaticText& lines = laidOut_[width];
    if (lines.text().isEmpty()) {
        lines.setTextFormat(Qt::PlainText);
        lines.setText(QString(text_).replace(QLatin1Char('\n'), QChar::LineSeparator));
        lines.setTextWidth(width);
        lines.prepare({}, font_);
    }
    return lines;
}

int AnswerLabel::heightForWidth(int width) const {
    return qCeil(laidOut(width).size().height());
}

void AnswerLabel::paintEvent(QPaintEvent* /*event*/) {
    const QStaticText& lines = laidOut(width());
    const int spare = std::max(0, height() - qCeil(lines.size().height()));
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    painter.drawStaticText(0, alignment().testFlag(Qt::AlignVCenter) ? spare / 2 : 0, lines);
}

}  // namespace ravnoves
