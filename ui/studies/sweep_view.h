#pragma once

#include <QWidget>
#include <string>

class QComboBox;
class QLabel;
class QPushButton;

namespace ravnoves {

class NumberField;
class PlotView;
class StudyModel;
class SweepModel;

/// Sweeps one input while the others scatter: how a result follows it.
class SweepView : public QWidget {
    Q_OBJECT

  public:
    explicit SweepView(StudyModel* study, QWidget* parent = nullptr);

    SweepModel* model() const { return model_; }
    PlotView* plot() const { return plot_; }
    /// Sweeps to this result, by its pointer.
    void chooseResult(const std::string& result);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void fillChoices();
    void showEnds();
    /// What the user chose is kept while the case is open.
    void keepChoice();
    void showSweep();

    StudyModel* study_;
    SweepModel* model_;
    QComboBox* input_;
    NumberField* from_;
    NumberField* to_;
    QComboBox* result_;
    QLabel* words_;
    QPushButton* take_;
    PlotView* plot_;
    PlotView* share_;  ///< of feasible samples, where those are not all
};

}  // namespace ravnoves
