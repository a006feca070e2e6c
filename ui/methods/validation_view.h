#pragma once

#include <QWidget>
#include <array>

#include "methods/model/validation_model.h"

class QComboBox;
class QLabel;
class QTableView;

namespace ravnoves {

/// The validation report: counts, filters, the table, and why the chosen row has its verdict.
class ValidationView : public QWidget {
    Q_OBJECT

  public:
    explicit ValidationView(QWidget* parent = nullptr);

    ValidationModel* viewModel() { return model_; }
    /// Has the report computed when it is first seen.
    void load() { model_->load(); }
    QString asText() const;
    QString asCsv() const { return model_->asCsv(); }
    QTableView* table() const { return table_; }

  Q_SIGNALS:
    /// A line for the status bar.
    void status(const QString& text);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* buildFilters();
    QWidget* buildTable();
    void copySelection();
    void showReport();
    void showReason();
    /// What the columns would need; measured once for the rows shown.
    void measure();
    /// Shares the width: what is too long for it goes on a second line, and where that is not
    /// enough, columns whose contents the tips and the reason say are left out.
    void fitColumns();

    ValidationModel* model_;
    QComboBox* papers_ = nullptr;
    QComboBox* verdicts_ = nullptr;
    QLabel* counts_ = nullptr;
    QTableView* table_ = nullptr;
    QLabel* reason_ = nullptr;
    std::array<int, ValidationModel::Columns> wanted_{};
};

}  // namespace ravnoves
