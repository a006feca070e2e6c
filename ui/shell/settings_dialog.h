#pragma once

#include <QDialog>

namespace ravnoves {

/// Theme, size of the text, language, digits, units. They apply once the dialog is accepted, and
/// are kept for the next start.
class SettingsDialog : public QDialog {
    Q_OBJECT

  public:
    explicit SettingsDialog(QWidget* parent = nullptr);
};

}  // namespace ravnoves
