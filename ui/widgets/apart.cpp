#include "widgets/apart.h"

#include <QEvent>
#include <algorithm>
#include <utility>

#include "plot/model/plot_data.h"

namespace ravnoves {

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
