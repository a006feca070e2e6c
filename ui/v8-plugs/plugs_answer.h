#pragma once

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace ravnoves {

class PartPlot;
class PartTable;
class V8PlugsModel;

/// What follows from the job: the advice in words, the options, the bob weight line by line,
/// the plug and the plots.
class PlugsAnswer : public QWidget {
    Q_OBJECT

  public:
    explicit PlugsAnswer(V8PlugsModel* model, QWidget* parent = nullptr);

    /// Entries that the form refuses now: the answer is that of the values before them.
    void setRefused(const QStringList& refused);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QWidget* buildAdvice();
    QWidget* buildBobWeights();
    QWidget* buildPlots();
    void showAnswer();
    void showAdvice();
    void showBobWeights();

    V8PlugsModel* model_;
    bool isNarrow_ = false;
    QLabel* excess_ = nullptr;
    QLabel* advice_ = nullptr;
    QLabel* refused_ = nullptr;
    QLabel* boring_ = nullptr;
    QLabel* hang_ = nullptr;
    QLabel* plugs_ = nullptr;
    QLabel* troubles_ = nullptr;
    PartTable* options_ = nullptr;
    PartTable* bobWeights_ = nullptr;
    QLabel* check_ = nullptr;
    QLabel* weighing_ = nullptr;
    QLabel* shiftNote_ = nullptr;
    PartPlot* compensation_ = nullptr;
    PartPlot* shift_ = nullptr;
};

}  // namespace ravnoves
