#pragma once

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace ravnoves {

class FormSection;
class ImportModel;

/// How a file of measured values is read: its first lines with the proposed columns marked, the
/// settings, and live below them the reading or its faults.
class ImportDialog : public QDialog {
    Q_OBJECT

  public:
    /// @param model  of a file that is being read; used while the dialog is open
    ImportDialog(ImportModel* model, const QString& title, QWidget* parent);

    /// Saves the cycle beside, where the case has no place for the settings.
    void accept() override;

  private:
    QWidget* buildSettings();
    QComboBox* addChoice(FormSection* section, const char* name, const QString& label,
                         const QString& hint, const QStringList& choices);
    void connectSettings();
    void showFile();
    void showLines();
    void showSettings();

    ImportModel* model_;
    QTableWidget* preview_ = nullptr;
    QComboBox* separator_ = nullptr;
    QComboBox* decimal_ = nullptr;
    QSpinBox* header_ = nullptr;
    QComboBox* cycle_ = nullptr;
    QComboBox* angle_ = nullptr;
    QComboBox* angleUnit_ = nullptr;
    QComboBox* value_ = nullptr;
    QComboBox* unit_ = nullptr;
    QComboBox* gauge_ = nullptr;  ///< null for torque
    QLabel* understood_ = nullptr;
    QLabel* doubts_ = nullptr;
    QCheckBox* shift_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QPushButton* import_ = nullptr;
};

}  // namespace ravnoves
