#pragma once

#include <QWidget>

class QPushButton;

namespace ravnoves {

class BalanceShaftModel;
class FieldSlider;
class Form;
class SpeedStudyModel;

/// Shows SpeedStudyModel: the best compromise α, best α over speed, the map; sliders for speed and
/// load.
class SpeedView : public QWidget {
    Q_OBJECT

  public:
    explicit SpeedView(BalanceShaftModel* model, QWidget* parent = nullptr);

  private:
    QWidget* buildSliders();
    QWidget* buildProgress();
    Form* buildForm();
    QWidget* buildWords();
    void showStudy();

    BalanceShaftModel* model_;
    SpeedStudyModel* study_;
    FieldSlider* load_;
    QPushButton* rebuild_;
    QPushButton* applyBestCompromise_;
    QWidget* charts_;
};

}  // namespace ravnoves
