#pragma once

#include <QLabel>

namespace ravnoves {

/// Contains a label whose text changes at every step of a drag, outside of the page's layout: the
/// page is laid out again only where the text has another height, and during a drag only where it
/// has more.
class Apart : public QWidget {
    Q_OBJECT

  public:
    explicit Apart(QLabel* held, QWidget* parent = nullptr);

    QSize sizeHint() const override { return held_->sizeHint(); }
    QSize minimumSizeHint() const override { return held_->minimumSizeHint(); }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

  protected:
    bool event(QEvent* event) override;

  private:
    QLabel* held_;
    int height_ = 0;  ///< what the text takes at the present width
};

}  // namespace ravnoves
