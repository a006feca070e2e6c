#pragma once

#include <QDialog>
#include <functional>
#include <vector>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
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
    /// @param words  of the entries
    /// @param read, decide  the place of the one that applies, and of one that is chosen
    QComboBox* addChoice(FormSection* section, const char* name, const QString& label,
                         const QString& hint, const std::function<QStringList()>& words,
                         const std::function<int()>& read, const std::function<void(int)>& decide);
    /// What the columns of the file are called.
    QStringList columns() const;
    void showFile();
    void showLines();

    ImportModel* model_;
    QTableWidget* preview_ = nullptr;
    std::vector<std::function<void()>> settings_;  ///< each shows what applies
    QLabel* understood_ = nullptr;
    QLabel* doubts_ = nullptr;
    QCheckBox* shift_ = nullptr;
    QPushButton* import_ = nullptr;
};

}  // namespace ravnoves
