#pragma once

#include <QWidget>

class QComboBox;
class QPushButton;

namespace ravnoves {

class BalanceShaftModel;
class FieldSlider;
class Form;
class SpeedStudyModel;

/// Shows SpeedStudyModel: best α over speed, the map, the least bad α; sliders for speed and load.
class SpeedView : public QWidget {
    Q_OBJECT

  public:
    explicit SpeedView(BalanceShaftModel* model, QWidget* parent = nullptr);

    QComboBox* criterionChoice() const { return criterion_; }

  private:
    QWidget* buildSliders();
    QWidget* buildProgress();
    Form* buildForm();
    QWidget* buildWords();
    void showStudy();
    /// Why there is nothing to show stands over what it would be set by.
    void showWordsFirst(bool first);

    BalanceShaftModel* model_;
    SpeedStudyModel* study_;
    FieldSlider* load_;
    QComboBox* criterion_;
    QPushButton* rebuild_;
    QPushButton* goLeastBad_;
    QWidget* words_;
    QWidget* charts_;
};

}  // namespace ravnoves
