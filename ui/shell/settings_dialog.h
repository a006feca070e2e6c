#pragma once

#include <QDialog>

namespace ravnoves {

/// Theme, size of the text, language, digits, units. What is chosen applies once it is accepted,
/// and is kept for the next start.
class SettingsDialog : public QDialog {
    Q_OBJECT

  public:
    explicit SettingsDialog(QWidget* parent = nullptr);
};

}  // namespace ravnoves
