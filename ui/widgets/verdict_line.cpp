#include "widgets/verdict_line.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSvgRenderer>
#include <algorithm>
#include <array>

#include "text/message_text.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/answer_label.h"
#include "widgets/layouts.h"

namespace ravnoves {

namespace {

constexpr int signSize = 18;

/// A severity as it is shown.
struct Look {
    QColor (Theme::*colour)() const;
    const char* word;
};

const Look& lookOf(Severity severity) {
    static constexpr std::array looks{
        Look{&Theme::good, QT_TRANSLATE_NOOP("ravnoves::VerdictLine", "OK")},
        Look{&Theme::accent, QT_TRANSLATE_NOOP("ravnoves::VerdictLine", "Note")},
        Look{&Theme::warning, QT_TRANSLATE_NOOP("ravnoves::VerdictLine", "Warning")},
        Look{&Theme::error, QT_TRANSLATE_NOOP("ravnoves::VerdictLine", "Problem")},
    };
    return looks.at(static_cast<std::size_t>(severity));
}

}  // namespace

QString severityName(Severity severity) {
    return VerdictLine::tr(lookOf(severity).word);
}

VerdictLine::VerdictLine(QWidget* parent)
    : QWidget(parent),
      line_(rowIn(this, Theme::space, {Theme::space, Theme::gap, Theme::space, 0})),
      row_(new QHBoxLayout),
      sign_(new QLabel(this)),
      word_(new QLabel(this)),
      text_(new AnswerLabel(this)),
      act_(new QPushButton(this)) {
    auto* head = new QHBoxLayout;
    QFont bold = word_->font();
    bold.setBold(true);
    word_->setFont(bold);
    text_->setObjectName(QStringLiteral("verdict"));
    act_->setObjectName(QStringLiteral("verdict_act"));
    head->addWidget(sign_);
    head->addWidget(word_, 1);
    row_->addLayout(head);
    row_->addWidget(new Apart(text_, this), 1);
    text_->setAlignment(Qt::AlignVCenter | Qt::AlignLeft);
    line_->addLayout(row_, 1);
    line_->addWidget(act_, 0, Qt::AlignLeft);
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
    const int head = sign_->sizeHint().width() + word_->sizeHint().width() + 4 * Theme::space;
    const auto stack = [this](QBoxLayout* layout, int taken) {
        const bool isStacked = width() - taken < Theme::withText(narrow);
        layout->setDirection(isStacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    };
    stack(row_, head);
    stack(line_, head + (act_->isVisibleTo(this) ? act_->sizeHint().width() + Theme::space : 0));
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
    const QString picture = QStringLiteral(":/icons/verdict-%1.svg");
    QSvgRenderer(
        themedSvg(picture.arg(QString::fromStdString(std::string(severity_word(severity_))))))
        .render(&painter, QRectF(0.5, 0.5, size - 1.0, size - 1.0));
    painter.end();
    sign_->setPixmap(sign);
    QPalette colours = word_->palette();
    const Theme& theme = Theme::instance();
    colours.setColor(QPalette::WindowText, theme.readable((theme.*lookOf(severity_).colour)()));
    word_->setPalette(colours);
}

}  // namespace ravnoves
