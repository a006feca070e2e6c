#pragma once

#include <QDialog>
#include <QPageSize>

namespace ravnoves {

/// What a report has beside the answer, which is on its first page: as the user chose last.
struct ReportChoice {
    ReportChoice();

    bool inputs;
    bool plots;
    bool formulas;                ///< and what the model leaves out
    QPageSize::PageSizeId paper;  ///< of a PDF: A4 or Letter; at first by the locale
};

/// Sets a ReportChoice, which the settings keep.
class ReportDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ReportDialog(QWidget* parent = nullptr);
};

}  // namespace ravnoves
