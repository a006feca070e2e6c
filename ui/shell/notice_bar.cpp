#include "shell/notice_bar.h"

#include <QLabel>
#include <QPushButton>

#include "theme/theme.h"
#include "widgets/layouts.h"

namespace ravnoves {

NoticeBar::NoticeBar(const QString& name, QWidget* parent)
    : Panel(parent), text_(new QLabel(this)) {
    setObjectName(name);
    QHBoxLayout* row = rowIn(this, Theme::space, barMargins);
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
