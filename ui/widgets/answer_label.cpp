#include "widgets/answer_label.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QPainter>
#include <QtMath>
#include <algorithm>
#include <utility>

#include "plot/model/plot_data.h"

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

Apart::Apart(QLabel* held, QWidget* parent) : QWidget(parent), held_(held) {
    held_->setParent(this);
    held_->setAlignment(Qt::AlignTop | Qt::AlignLeft);  // in a drag it may have more room
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

int Apart::heightForWidth(int width) const {
    const int needed =
        held_->hasHeightForWidth() ? held_->heightForWidth(width) : held_->sizeHint().height();
    return PlotData::steady && width == this->width() ? std::max(height_, needed) : needed;
}

bool Apart::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize ||
        event->type() == QEvent::Show) {
        held_->setGeometry(rect());
        const int needed = heightForWidth(width());
        const bool isNew = std::exchange(height_, needed) != needed;
        if (isNew && minimumHeight() != maximumHeight()) {
            updateGeometry();
        }
        return true;
    }
    return QWidget::event(event);
}

}  // namespace ravnoves
