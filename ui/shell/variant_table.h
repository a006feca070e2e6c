#pragma once

#include <QDialog>
#include <QTimer>

class QLabel;

namespace ravnoves {

class ResultTable;
class ScenePage;

/// The results of the present input and of all its variants, side by side, in a window of its own
/// that follows them.
class VariantTable : public QDialog {
    Q_OBJECT

  public:
    VariantTable(ScenePage* page, QWidget* parent);

    const ResultTable* table() const { return table_; }
    /// @return why it cannot be written; else empty
    QString exportTo(const QString& path) const;

  private:
    void showVariants();
    void saveWithDialog();

    ScenePage* page_;
    QTimer rest_;
    QLabel* verdicts_;
    QLabel* words_;
    QLabel* star_;  ///< its meaning, where there is one
    ResultTable* table_;
};

}  // namespace ravnoves
