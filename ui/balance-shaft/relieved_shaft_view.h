#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace ravnoves {

class BalanceShaftModel;
class Form;

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

    BalanceShaftModel* model_;
    QLabel* verdict_;
    QPushButton* export_;
};

}  // namespace ravnoves
