#pragma once

#include <QWidget>

class QLabel;

namespace ravnoves {

class PartTable;
class WorkshopModel;

/// What follows from the job: the bob weight, the planes with their holes, what to do with the
/// plugs, the bob weight line by line; behind "Details" the plots that teach the method.
class WorkshopAnswer : public QWidget {
    Q_OBJECT

  public:
    explicit WorkshopAnswer(WorkshopModel* model, QWidget* parent = nullptr);

    /// Entries that the form rejects now: the answer is that of the values before them.
    void setRefused(const QStringList& refused);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QWidget* buildHead();
    QWidget* buildPlugs();
    QWidget* buildCorrection();
    QWidget* buildLines();
    QWidget* buildDetails();
    void showAnswer();

    WorkshopModel* model_;
    QLabel* headline_ = nullptr;
    QLabel* doubtful_ = nullptr;
    QLabel* refused_ = nullptr;
    QLabel* hang_ = nullptr;
    QLabel* factor_ = nullptr;
    QLabel* limits_ = nullptr;
    QLabel* troubles_ = nullptr;
    QWidget* plugs_ = nullptr;
    QLabel* advice_ = nullptr;
    QLabel* boring_ = nullptr;
    QLabel* excess_ = nullptr;
    PartTable* options_ = nullptr;
    QLabel* check_ = nullptr;
    QWidget* pictures_ = nullptr;
    QLabel* asReadNote_ = nullptr;
    PartTable* runs_ = nullptr;
    PartTable* planes_ = nullptr;
    PartTable* holes_ = nullptr;
    QLabel* holeNote_ = nullptr;
    PartTable* drilled_ = nullptr;
    QLabel* drilledHeading_ = nullptr;
    QWidget* lines_ = nullptr;
    QWidget* force_ = nullptr;
    QWidget* plugPlots_ = nullptr;
};

}  // namespace ravnoves
