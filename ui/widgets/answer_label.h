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

}  // namespace ravnoves
