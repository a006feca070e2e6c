#pragma once

#include <QWidget>

class QPushButton;

namespace ravnoves {

class BalanceShaftModel;
class Form;
class SpeedStudyModel;

/// Shows SpeedStudyModel: the band, the best compromise α, best α over speed, the map.
class SpeedView : public QWidget {
    Q_OBJECT

  public:
    explicit SpeedView(BalanceShaftModel* model, QWidget* parent = nullptr);

  private:
    QWidget* buildProgress();
    Form* buildForm();
    QWidget* buildWords();
    void showStudy();

    BalanceShaftModel* model_;
    SpeedStudyModel* study_;
    QPushButton* rebuild_;
    QPushButton* applyBestCompromise_;
    QWidget* charts_;
};

}  // namespace ravnoves
