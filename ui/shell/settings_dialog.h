#pragma once

#include <QDialog>

class QComboBox;
class QFormLayout;

namespace ravnoves {

/// Theme, size of the text, language, digits, units. A choice applies at once, here as well, and is
/// kept for the next start.
class SettingsDialog : public QDialog {
    Q_OBJECT

  public:
    explicit SettingsDialog(QWidget* parent = nullptr);

  private:
    void build();
    void addUnits();
    /// A row with a choice; `take` gets the data of what the user chose.
    template <typename Take>
    QComboBox* addChoice(const char* name, const QString& label, const QString& hint,
                         const QList<std::pair<QString, QVariant>>& choices,
                         const QVariant& present, Take take);

    QWidget* content_ = nullptr;
    QFormLayout* rows_ = nullptr;
};

}  // namespace ravnoves
