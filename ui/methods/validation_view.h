#pragma once

#include <QWidget>

#include "methods/model/validation_model.h"

class QLabel;

namespace ravnoves {

class ResultTable;

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
    ResultTable* table() const { return table_; }

  Q_SIGNALS:
    /// A line for the status bar.
    void status(const QString& text);

  private:
    QWidget* buildFilters();
    QWidget* buildTable();
    void showReport();
    void showReason();

    ValidationModel* model_;
    QLabel* counts_ = nullptr;
    ResultTable* table_ = nullptr;
    QLabel* reason_ = nullptr;
};

}  // namespace ravnoves
