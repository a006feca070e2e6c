#pragma once

#include <QWidget>

#include "balance-shaft/relieved_shaft.h"
#include "page/compared_figure.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace ravnoves {

class BalanceShaftModel;
class RelievedShaftModel;
class ResultTable;

/// Section and side view of a shaft with a relieved middle, to scale, with its main sizes; dashed,
/// the reference's.
class RelievedShaftDrawing : public ComparedFigure {
    Q_OBJECT

  public:
    explicit RelievedShaftDrawing(QWidget* parent = nullptr);

    void setShaft(const balance_shaft::RelievedShaft& shaft);
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    balance_shaft::RelievedShaft shaft_;
};

/// The form, the answer and the drawing of RelievedShaftModel.
class RelievedShaftView : public QWidget {
    Q_OBJECT

  public:
    explicit RelievedShaftView(BalanceShaftModel* model, QWidget* parent = nullptr);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    QWidget* buildForm(BalanceShaftModel* model);
    void showShaft();
    void chooseFile();

    RelievedShaftModel* model_;
    ResultTable* table_;
    QLabel* verdict_;
    QPushButton* export_;
    RelievedShaftDrawing* drawing_;
};

}  // namespace ravnoves
