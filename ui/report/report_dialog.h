#pragma once

#include <QDialog>

#include "report/report_choice.h"

class QCheckBox;
class QComboBox;

namespace ravnoves {

/// What a report has beside the answer, and its paper.
class ReportDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ReportDialog(QWidget* parent = nullptr);

    ReportChoice choice() const;

  private:
    QCheckBox* add(const char* name, const QString& text, const QString& hint, bool isOn);

    QCheckBox* inputs_;
    QCheckBox* plots_;
    QCheckBox* formulas_;
    QCheckBox* validation_;
    QComboBox* paper_;
};

}  // namespace ravnoves
