#include "widgets/apart.h"

#include <QEvent>
#include <algorithm>

#include "plot/plot_view.h"

namespace ravnoves {

Apart::Apart(QLabel* held, QWidget* parent)
    : QWidget(parent), held_(held), interaction_(held->textInteractionFlags()) {
    held_->setParent(this);
    held_->setTextInteractionFlags(Qt::NoTextInteraction);
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    constexpr int restMs = 100;
    rest_.setSingleShot(true);
    rest_.setInterval(restMs);
    connect(&rest_, &QTimer::timeout, this, &Apart::fit);
}

QSize Apart::sizeHint() const {
    return held_->sizeHint();
}

QSize Apart::minimumSizeHint() const {
    return held_->minimumSizeHint();
}

int Apart::heightForWidth(int width) const {
    // Whatever the page is laid out anew for, in a drag no room is given back.
    return PlotView::isSteady() && width == this->width() ? std::max(height_, needed(width))
                                                          : needed(width);
}

int Apart::needed(int width) const {
    if (!held_->hasHeightForWidth()) {
        return held_->sizeHint().height();
    }
    return heights_.of(*held_, width, [this](int at) { return held_->heightForWidth(at); });
}

bool Apart::event(QEvent* event) {
    // The label has another text or another font.
    if (event->type() == QEvent::LayoutRequest) {
        if (hasGivenRoom()) {
            return true;
        }
        held_->text().size() == length_ ? rest_.start() : fit();
        return true;
    }
    return QWidget::event(event);
}

bool Apart::hasGivenRoom() const {
    return minimumHeight() == maximumHeight();
}

void Apart::fit() {
    rest_.stop();
    length_ = held_->text().size();
    const int height = needed(width());
    if (height < height_ && PlotView::isSteady()) {
        rest_.start();
        return;
    }
    if (height != height_) {
        height_ = height;
        updateGeometry();
    }
}

void Apart::enterEvent(QEnterEvent* event) {
    QWidget::enterEvent(event);
    held_->setTextInteractionFlags(interaction_);
}

void Apart::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    if (!held_->hasSelectedText()) {
        held_->setTextInteractionFlags(Qt::NoTextInteraction);
    }
}

void Apart::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    held_->setGeometry(rect());
    height_ = needed(width());
    length_ = held_->text().size();
    if (height_ > height() && !hasGivenRoom()) {
        updateGeometry();  // another width was asked about
    }
}

void Apart::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    // While neither is seen, the label tells nobody of another text or another font.
    if (!hasGivenRoom()) {
        fit();
    }
}

}  // namespace ravnoves
