#pragma once

#include <QWidget>

#include "page/compared_figure.h"

class QLabel;
class QPushButton;

namespace ravnoves {

class BalanceShaftModel;
class Form;

/// Section and side view of a shaft with a relieved middle, to scale, with its main sizes; dashed,
/// the reference's.
class RelievedShaftDrawing : public ComparedFigure {
    Q_OBJECT

  public:
    explicit RelievedShaftDrawing(BalanceShaftModel* model, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {600, 220}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void follow();

    BalanceShaftModel* model_;
};

/// The balance shaft as a round bar with a segment milled away (the paper's Fig. 5) for the
/// unbalance m₁ ρ₁ of the page: its sizes, of which one is found, the answer and the drawing.
class RelievedShaftView : public QWidget {
    Q_OBJECT

  public:
    explicit RelievedShaftView(BalanceShaftModel* model, QWidget* parent = nullptr);

  private:
    QWidget* buildForm();
    void addSizes(Form* form);
    void showFeasible();
    void chooseFile();

    BalanceShaftModel* model_;
    QLabel* verdict_;
    QPushButton* export_;
};

}  // namespace ravnoves
