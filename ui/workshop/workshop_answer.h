#pragma once

#include <QWidget>
#include <functional>
#include <utility>
#include <vector>

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

    /// Entries that the form rejects now: the answer is that of the values before them.
    void setRefused(const QStringList& refused);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QLabel* say(QVBoxLayout* column, const char* name, int pixelSize, std::function<QString()> text,
                Ink ink = &Theme::text, bool isBold = false);
    QWidget* buildHead();
    QWidget* buildPlugs();
    QWidget* buildCorrection();
    QWidget* buildLines();
    QWidget* buildDetails();
    void showAnswer();

    WorkshopModel* model_;
    QString refused_;
    /// The sentences that follow the model, with what makes them.
    std::vector<std::pair<QLabel*, std::function<QString()>>> said_;
    QLabel* headline_ = nullptr;
    QWidget* plugs_ = nullptr;
    QLabel* advice_ = nullptr;
    PartTable* options_ = nullptr;
    QWidget* pictures_ = nullptr;
    PartTable* runs_ = nullptr;
    PartTable* planes_ = nullptr;
    PartTable* drilled_ = nullptr;
    QLabel* drilledHeading_ = nullptr;
    QWidget* lines_ = nullptr;
    QWidget* force_ = nullptr;
    QWidget* plugPlots_ = nullptr;
};

}  // namespace ravnoves
