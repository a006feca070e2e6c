#pragma once

#include <QComboBox>

namespace ravnoves {

/// A list to pick from again and again, whose permanent first entry names the purpose. A pick adds
/// something somewhere, so nothing picks by accident: a key opens the list, the wheel scrolls the
/// page below.
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
