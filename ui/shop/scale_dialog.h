#pragma once

#include <QDialog>

class QComboBox;
class QLabel;
class QPlainTextEdit;

namespace ravnoves {

namespace shop {
struct ScaleLine;
}
class FormSection;
class NumberField;
class ScaleReader;
struct ScaleSettings;

/// The settings of the scale, which apply at once, and beside them its raw lines with their
/// readings.
class ScaleDialog : public QDialog {
    Q_OBJECT

  public:
    ScaleDialog(ScaleReader* reader, QWidget* parent);

  private:
    void buildRows(FormSection* rows);
    QComboBox* addChoice(FormSection* rows, const char* name, const QString& label,
                         const QString& hint, const QStringList& choices, int present);
    void fillPorts();
    ScaleSettings chosen() const;
    void apply();
    void showConnection();
    void showLine(const QByteArray& raw, const shop::ScaleLine& line);

    ScaleReader* reader_;
    QComboBox* port_ = nullptr;
    QComboBox* baud_ = nullptr;
    QComboBox* parity_ = nullptr;
    QComboBox* unit_ = nullptr;
    QComboBox* taking_ = nullptr;
    NumberField* resolution_ = nullptr;
    QLabel* state_ = nullptr;
    QPlainTextEdit* lines_ = nullptr;
};

}  // namespace ravnoves
