#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QProgressBar;
class QStackedWidget;

namespace ravnoves {

class FieldPlot;
class PlotView;
class StudyModel;
class SweepModel;

/// One input led through its range, or two: how a result goes with it, as a line or as a map.
class SweepView : public QWidget {
    Q_OBJECT

  public:
    explicit SweepView(StudyModel* study, QWidget* parent = nullptr);

    SweepModel* model() const { return model_; }
    const PlotView* line() const { return line_; }
    const FieldPlot* map() const { return map_; }

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void fillChoices();
    void choose();
    void showSweep();
    void showLine();
    void showMap();

    StudyModel* study_;
    SweepModel* model_;
    QComboBox* input_;
    QComboBox* other_;
    QComboBox* result_;
    QComboBox* reach_;
    QProgressBar* progress_;
    QLabel* words_;
    QStackedWidget* stack_;
    PlotView* line_;
    FieldPlot* map_;
    bool isChosen_ = false;  ///< by the user; before, what scatters first is swept
};

}  // namespace ravnoves
