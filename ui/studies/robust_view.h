#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace ravnoves {

class ResultTable;
class RobustModel;
class StudyModel;

/// The angle whose 95 % point is least, beside the one that is best of the inputs as they are.
class RobustView : public QWidget {
    Q_OBJECT

  public:
    explicit RobustView(StudyModel* study, QWidget* parent = nullptr);

    RobustModel* model() const { return model_; }
    const ResultTable* table() const { return table_; }

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void showBest();
    void showStop();

    RobustModel* model_;
    ResultTable* table_;
    QLabel* words_;
    QProgressBar* progress_;
    QPushButton* stop_;
    QPushButton* take_;
};

}  // namespace ravnoves
