#pragma once

#include <QDialog>

namespace ravnoves {

/// Theme, size of the text, language, digits, units. A choice applies at once, here as well, and is
/// kept for the next start.
class SettingsDialog : public QDialog {
    Q_OBJECT

  public:
    explicit SettingsDialog(QWidget* parent = nullptr);

  private:
    void build();

    QWidget* content_ = nullptr;
};

}  // namespace ravnoves
