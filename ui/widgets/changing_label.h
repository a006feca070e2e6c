#pragma once

#include <QLabel>
#include <QTextLayout>
#include <memory>
#include <vector>

namespace ravnoves {

/// A label of plain text that changes at every step of a drag, painted as a QLabel paints it: a
/// paragraph that is the same is not laid out again, nor a line that is the same painted. It can be
/// selected, and stands in an Apart, where it is a plain one while no pointer is on it.
class ChangingLabel : public QLabel {
    Q_OBJECT

  public:
    explicit ChangingLabel(QWidget* parent = nullptr);

    /// To be called in place of QLabel's.
    void setText(const QString& text);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    /// Lines up to an end of line in the text.
    struct Paragraph {
        QString text;
        std::unique_ptr<QTextLayout> layout;
        double top = 0.0;     ///< of its first line, from that of the text, pixels
        double height = 0.0;  ///< pixels
    };

    /// Lays out what is not yet; where width or font are others, all.
    void layOut();
    /// Of the text, from its top: the last line is the first that reaches the end of the room.
    double bottom() const;
    /// From the label's top to that of the text, pixels.
    double offset() const;
    /// The text is shown as a QLabel shows plain text that cannot be selected.
    bool isPlain() const;

    std::vector<Paragraph> paragraphs_;
    QFont font_;      ///< that they are laid out in
    int width_ = -1;  ///< likewise, pixels
};

}  // namespace ravnoves
