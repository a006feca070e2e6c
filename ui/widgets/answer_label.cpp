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
    laidOut_.setTextFormat(Qt::PlainText);
    auto* copy = new QAction(tr("Copy text"), this);
    connect(copy, &QAction::triggered, this, [this] {
        QString lines = text();
        QGuiApplication::clipboard()->setText(lines.remove(QChar(0x2060)));  // holds units together
    });
    addAction(copy);
    setContextMenuPolicy(Qt::ActionsContextMenu);
}

const QStaticText& AnswerLabel::laidOut(int width) const {
    QString lines = text();
    lines.replace(QLatin1Char('\n'), QChar::LineSeparator);
    if (laidOut_.text() != lines || laidOut_.textWidth() != width || font_ != font()) {
        laidOut_.setText(lines);
        laidOut_.setTextWidth(width);
        font_ = font();
        laidOut_.prepare({}, font_);
    }
    return laidOut_;
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
