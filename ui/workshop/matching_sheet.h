#pragma once

#include "text/result_row.h"
#include "workshop/matching_rules.h"
#include "workshop/sheet_form.h"

class QGridLayout;

namespace ravnoves {

class ResultTable;

/// A sheet on which parts are weighed and matched: what may move, what they are placed for, and
/// what comes out.
class MatchingSheet : public SheetForm {
    Q_OBJECT

  public:
    using Rules = workshop::MatchingRules;

    /// @param isMoved  whether parts are elsewhere than they were weighed
    MatchingSheet(SceneModel* model, std::function<Rules()> rules,
                  std::function<void(const QString& name, const std::function<void(Rules&)>&)> edit,
                  std::function<bool()> isMoved, QWidget* parent = nullptr);

  protected:
    /// What is shown below the weights.
    struct Findings {
        QString summary;
        bool isAmber = false;
        bool canMove = false;
        bool isSearching = false;
        ResultRows effects;
        ResultRows assignment;
        ResultRows takeOff;
        std::size_t cylinders = 0;
    };

    /// A row of the grid of weights, a control in the column of each part: where it may go.
    void addMoves(QGridLayout* grid, int row);
    /// What the parts are placed for, with what that needs.
    void addGoal(bool asksRadius);
    /// What comes out, and the buttons that move the weights on the sheet and back.
    void addFindings(std::function<Findings()> findings, std::function<void()> move,
                     std::function<void()> moveBack);

  private:
    void addAngles();
    ResultTable* addTable(const QString& name);

    std::function<Rules()> rules_;
    std::function<void(const QString&, const std::function<void(Rules&)>&)> edit_;
    std::function<bool()> isMoved_;
};

}  // namespace ravnoves
