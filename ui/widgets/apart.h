#pragma once

#include <QLabel>
#include <QTimer>
#include <QWidget>

#include "widgets/heights_by_width.h"

namespace ravnoves {

/// Holds a label whose text changes at every step of a drag. No layout stands between them: a new
/// text is laid out alone, and the whole page anew only where the text takes another height. A text
/// of the same length has other digits, which are of one width: its height is looked at only when
/// the hand rests, and only then room that is too large given back. A label whose text can be
/// selected is so while the pointer is on it: the document behind such a text takes longer than the
/// picture of an engine.
class Apart : public QWidget {
    Q_OBJECT

  public:
    explicit Apart(QLabel* held, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

  protected:
    bool event(QEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    int needed(int width) const;
    bool hasGivenRoom() const;
    void fit();

    QLabel* held_;
    Qt::TextInteractionFlags interaction_;
    QTimer rest_;
    int height_ = 0;        ///< what the text takes at the present width
    qsizetype length_ = 0;  ///< of the text that it was measured for
    mutable HeightsByWidth heights_;
};

}  // namespace ravnoves
