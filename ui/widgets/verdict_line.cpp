#include "widgets/verdict_line.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <cmath>

#include "text/message_text.h"
#include "theme/theme.h"
#include "widgets/answer_label.h"
#include "widgets/apart.h"
#include "widgets/layouts.h"

namespace ravnoves {

namespace {

constexpr int signSize = 18;

/// A severity as it is shown; the strokes are those of its sign, in sixteenths of it.
struct Look {
    QColor (Theme::*colour)() const;
    const char* word;
    QList<QLineF> strokes;
};

const Look& lookOf(Severity severity) {
    static const std::array<Look, 4> looks{
        Look{&Theme::good,
             QT_TRANSLATE_NOOP("ravnoves::VerdictLine", "OK"),
             {{-3.5, 0.5, -1.0, 3.0}, {-1.0, 3.0, 3.5, -2.5}}},
        Look{&Theme::accent,
             QT_TRANSLATE_NOOP("ravnoves::VerdictLine", "Note"),
             {{0.0, -0.5, 0.0, 4.0}, {0.0, -4.0, 0.0, -4.0}}},
        Look{&Theme::warning,
             QT_TRANSLATE_NOOP("ravnoves::VerdictLine", "Warning"),
             {{0.0, -2.5, 0.0, 2.5}, {0.0, 5.8, 0.0, 5.8}}},
        Look{&Theme::error,
             QT_TRANSLATE_NOOP("ravnoves::VerdictLine", "Problem"),
             {{-2.8, -2.8, 2.8, 2.8}, {-2.8, 2.8, 2.8, -2.8}}},
    };
    return looks.at(static_cast<std::size_t>(severity));
}

QColor colourOf(Severity severity) {
    return (Theme::instance().*lookOf(severity).colour)();
}

QPainterPath outlineOf(const QRectF& square, Severity severity) {
    QPainterPath outline;
    if (severity == Severity::warning) {
        const QPointF top(square.center().x(), square.top());
        outline.addPolygon(QPolygonF{top, square.bottomRight(), square.bottomLeft(), top});
    } else if (severity == Severity::error) {
        QPolygonF octagon;
        for (int i = 0; i < 8; ++i) {
            const double angle = (i + 0.5) * M_PI_4;
            octagon << square.center() +
                           0.5 * square.width() * QPointF(std::cos(angle), std::sin(angle));
        }
        outline.addPolygon(octagon);
    } else {
        outline.addEllipse(square);
    }
    return outline;
}

}  // namespace

QString severityName(Severity severity) {
    return VerdictLine::tr(lookOf(severity).word);
}

void paintSeverity(QPainter& painter, const QRectF& square, Severity severity) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(outlineOf(square, severity), colourOf(severity));
    const double unit = square.width() / 16.0;
    const QPointF middle = square.center();
    painter.setPen(QPen(Theme::instance().panel(), 2.0 * unit, Qt::SolidLine, Qt::RoundCap));
    for (const QLineF& stroke : lookOf(severity).strokes) {
        painter.drawLine(middle + unit * stroke.p1(), middle + unit * stroke.p2());
    }
}

VerdictLine::VerdictLine(QWidget* parent)
    : QWidget(parent),
      sign_(new QLabel(this)),
      word_(new QLabel(this)),
      text_(new AnswerLabel(this)),
      act_(new QPushButton(this)) {
    QHBoxLayout* line = rowIn(this, Theme::space, {Theme::space, Theme::gap, Theme::space, 0});
    auto* row = new QHBoxLayout;
    QFont bold = word_->font();
    bold.setBold(true);
    word_->setFont(bold);
    text_->setObjectName(QStringLiteral("verdict"));
    act_->setObjectName(QStringLiteral("verdict_act"));
    row->addWidget(sign_);
    row->addWidget(word_);
    row->addWidget(new Apart(text_, this), 1);
    text_->setAlignment(Qt::AlignVCenter | Qt::AlignLeft);
    line->addLayout(row, 1);
    line->addWidget(act_, 0, Qt::AlignLeft);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    connect(act_, &QPushButton::clicked, this, &VerdictLine::acted);
    connect(&Theme::instance(), &Theme::changed, this, &VerdictLine::dress);
    dress();
}

void VerdictLine::show(const Verdict& verdict, const QString& act) {
    const bool isOther = verdict.severity != severity_ || word_->text().isEmpty();
    severity_ = verdict.severity;
    word_->setText(severityName(severity_));
    text_->setText(messageText(verdict.text));
    act_->setText(act);
    act_->setVisible(!act.isEmpty());
    setAccessibleName(text());
    if (isOther) {
        dress();
    }
    arrange();
}

void VerdictLine::arrange() {
    constexpr int narrow = 300;
    const int taken = sign_->sizeHint().width() + word_->sizeHint().width() +
                      act_->sizeHint().width() + 5 * Theme::space;
    const bool isBelow = act_->isVisibleTo(this) && width() - taken < Theme::withText(narrow);
    static_cast<QBoxLayout*>(layout())->setDirection(isBelow ? QBoxLayout::TopToBottom
                                                             : QBoxLayout::LeftToRight);
}

void VerdictLine::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

QString VerdictLine::text() const {
    return word_->text() + QStringLiteral(": ") + text_->text();
}

void VerdictLine::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        dress();
    }
}

void VerdictLine::dress() {
    // Nothing moves where the button comes, or a second line.
    setMinimumHeight(Theme::gap +
                     std::max(act_->sizeHint().height(), 2 * text_->fontMetrics().lineSpacing()));
    const int size = Theme::withText(signSize);
    QPixmap sign(QSize(size, size) * devicePixelRatioF());
    sign.setDevicePixelRatio(devicePixelRatioF());
    sign.fill(Qt::transparent);
    QPainter painter(&sign);
    paintSeverity(painter, QRectF(0.5, 0.5, size - 1.0, size - 1.0), severity_);
    painter.end();
    sign_->setPixmap(sign);
    QPalette colours = word_->palette();
    colours.setColor(QPalette::WindowText, Theme::instance().readable(colourOf(severity_)));
    word_->setPalette(colours);
}

}  // namespace ravnoves
