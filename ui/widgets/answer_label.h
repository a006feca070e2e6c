#pragma once

#include <QLabel>
#include <QMap>
#include <QStaticText>

namespace ravnoves {

/// Plain lines that may change at every step of a drag: they are laid out once, to be measured and
/// painted; Qt lays out a label whose text can be selected five times. Its menu copies them.
class AnswerLabel : public QLabel {
    Q_OBJECT

  public:
    explicit AnswerLabel(QWidget* parent = nullptr);

    int heightForWidth(int width) const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    const QStaticText& laidOut(int width) const;

    mutable QMap<int, QStaticText> laidOut_;  ///< by width
    mutable QString text_;                    ///< of the lines as they were laid out
    mutable QFont font_;
};

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
