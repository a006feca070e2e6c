#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace ravnoves {

class BackgroundJob;
class BalanceShaftModel;
class FieldSlider;
class Form;
class PlotView;
class SpeedMapPlot;
class SpeedStudyModel;

/// Shows SpeedStudyModel: best α over speed, the map, the least bad α; sliders for speed and load.
class SpeedView : public QWidget {
    Q_OBJECT

  public:
    explicit SpeedView(BalanceShaftModel* model, QWidget* parent = nullptr);

    BackgroundJob* job() const;
    PlotView* anglePlot() const { return angles_; }
    SpeedMapPlot* mapPlot() const { return map_; }
    QComboBox* criterionChoice() const { return criterion_; }
    QString answer() const;

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    QWidget* buildSliders();
    QWidget* buildProgress();
    Form* buildForm();
    void showInput();
    void showStudy();
    void showMap();
    /// Why there is nothing to show stands over what it would be set by.
    void showWordsFirst(bool first);

    BalanceShaftModel* model_;
    SpeedStudyModel* study_;
    FieldSlider* load_;
    QComboBox* criterion_;
    QPushButton* rebuild_;
    QString mapTitle_;  ///< of an empty map
    QPushButton* goLeastBad_;
    QLabel* answer_;
    QWidget* words_;
    QWidget* charts_;
    PlotView* angles_;
    SpeedMapPlot* map_;
    int rangeAngle_ = 0;
    int rmsAngle_ = 0;
    int bestLine_ = 0;
};

}  // namespace ravnoves
