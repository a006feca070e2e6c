#include "shell/notice_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "theme/theme.h"

namespace ravnoves {

NoticeBar::NoticeBar(const QString& name, QWidget* parent)
    : Panel(parent), text_(new QLabel(this)) {
    setObjectName(name);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    row->setSpacing(Theme::space);
    text_->setWordWrap(true);
    row->addWidget(text_, 1);
    hide();
}

QPushButton* NoticeBar::addButton(const QString& name, const QString& text, const QString& tip) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(tip);
    layout()->addWidget(button);
    return button;
}

}  // namespace ravnoves
