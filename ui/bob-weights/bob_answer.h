#pragma once

#include <QWidget>

class QLabel;

namespace ravnoves {

class BobWeightsModel;
class Panel;
class PartTable;

/// What follows from the job: the bob weight in large type, its lines as on a trade card, the two
/// planes, the holes.
class BobAnswer : public QWidget {
    Q_OBJECT

  public:
    explicit BobAnswer(BobWeightsModel* model, QWidget* parent = nullptr);

    /// Entries that the form refuses now: the answer is that of the values before them.
    void setRefused(const QStringList& refused);

  private:
    QWidget* buildHead();
    QWidget* buildLines();
    QWidget* buildCorrection();
    void showAnswer();

    BobWeightsModel* model_;
    QLabel* headline_ = nullptr;
    QLabel* hang_ = nullptr;
    QLabel* factor_ = nullptr;
    QLabel* limits_ = nullptr;
    QLabel* verdict_ = nullptr;
    QLabel* refused_ = nullptr;
    QLabel* troubles_ = nullptr;
    QWidget* linesAndForce_ = nullptr;
    PartTable* lines_ = nullptr;
    PartTable* runs_ = nullptr;
    PartTable* planes_ = nullptr;
    PartTable* holes_ = nullptr;
    QLabel* asReadNote_ = nullptr;
    QLabel* holeNote_ = nullptr;
    QLabel* drilledHeading_ = nullptr;
    PartTable* drilled_ = nullptr;
    QLabel* drilledNote_ = nullptr;
};

}  // namespace ravnoves
