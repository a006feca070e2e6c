#pragma once

#include <QDoubleSpinBox>

namespace ravnoves {

/// A QDoubleSpinBox that takes decimal comma and point in every locale and the units that a field
/// takes (its own is its suffix), and passes a typed value on when it is finished (not at each key,
/// which would jump while "120" is typed). Undo and redo are the text's while it is not the value,
/// else the document's.
class DecimalSpinBox : public QDoubleSpinBox {
    Q_OBJECT

  public:
    explicit DecimalSpinBox(QWidget* parent = nullptr) : QDoubleSpinBox(parent) {
        setKeyboardTracking(false);
        setAlignment(Qt::AlignRight);
    }

    bool event(QEvent* event) override;
    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;
    /// What was typed is no value of the range: the value from before comes back, and refused()
    /// says so.
    void fixup(QString& text) const override;

  Q_SIGNALS:
    void refused(const QString& text) const;

  private:
    QString bare(const QString& text) const;
};

}  // namespace ravnoves
