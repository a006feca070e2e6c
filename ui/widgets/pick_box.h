#pragma once

#include <QComboBox>

namespace ravnoves {

/// A list to pick from again and again, whose first entry says what for and is there always.
/// What is picked is added somewhere, so nothing picks by the way: a key opens the list, the wheel
/// is of what lies below.
class PickBox : public QComboBox {
    Q_OBJECT

  public:
    /// @param prompt  "Watch a result…"
    explicit PickBox(QString prompt, QWidget* parent = nullptr);

    /// The prompt alone.
    void clearEntries();

  Q_SIGNALS:
    /// The data of an entry.
    void picked(const QVariant& data);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    QString prompt_;
};

}  // namespace ravnoves
