#pragma once

#include <QWidget>
#include <map>
#include <string_view>

#include "widgets/form_section.h"

class QVBoxLayout;

namespace ravnoves {

class PartTable;
class WorkshopModel;

/// What follows from the job: the bob weight, the planes with their holes, what to do with the
/// plugs, the bob weight line by line; behind "Details" the plots that teach the method.
class WorkshopAnswer : public QWidget {
    Q_OBJECT

  public:
    explicit WorkshopAnswer(WorkshopModel* model, QWidget* parent = nullptr);

    /// Beside the sheets of machine and correction their answer is the first, and the bob weight's
    /// is left out.
    void setOfMachine(bool isOfMachine);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// A line of answerLines().
    QLabel* say(QVBoxLayout* column, const char* id, int pixelSize, Ink ink = &Theme::text,
                bool isBold = false);
    QWidget* buildHead();
    QWidget* buildPlugs();
    QWidget* buildCorrection();
    QWidget* buildLines();
    QWidget* buildDetails();
    void showAnswer();

    WorkshopModel* model_;
    std::map<std::string_view, QLabel*> said_;
    QWidget* plugs_ = nullptr;
    PartTable* options_ = nullptr;
    QWidget* pictures_ = nullptr;
    PartTable* runs_ = nullptr;
    PartTable* planes_ = nullptr;
    PartTable* drilled_ = nullptr;
    QLabel* drilledHeading_ = nullptr;
    QWidget* weight_ = nullptr;  ///< what the bob weight is made of
    QWidget* lines_ = nullptr;
    bool isOfMachine_ = false;
    QString verdict_;  ///< shown last
};

}  // namespace ravnoves
