#pragma once

#include <functional>
#include <vector>

#include "shop/matching_rules.h"
#include "shop/model/weigh_in_table.h"
#include "shop/sheet_form.h"
#include "text/result_row.h"

class QGridLayout;

namespace ravnoves {

/// A sheet on which parts are weighed and matched: a column for each kind of part, a row for each
/// cylinder; what may move, what they are placed for, and what comes out. Enter goes down the
/// columns, as one weighs; a block of a spreadsheet is pasted from the cell that has
/// the focus.
class MatchingSheet : public SheetForm {
    Q_OBJECT

  public:
    using Rules = shop::MatchingRules;

    /// @param model  a WorkshopModel with a weigh-in sheet
    template <typename Model>
    explicit MatchingSheet(Model* model, QWidget* parent = nullptr)
        : SheetForm(model, parent),
          rules_([model] {
              const auto& sheet = model->input().weigh_in;
              return sheet ? sheet->matching : Rules();
          }),
          edit_([model](const QString& name, const std::function<void(Rules&)>& change) {
              model->editWeights(name, [&](auto& sheet) { change(sheet.matching); });
          }),
          isMoved_([model] { return model->canMoveBack(); }),
          move_([model] { model->moveParts(); }),
          moveBack_([model] { model->moveBack(); }),
          find_([model] { return findingsOf(*model); }) {}

  protected:
    using Note = std::function<WeighedColumn(shop::Part)>;
    /// The grid of weights, with what stands below its columns and where their parts may go.
    /// @param mostRows  further cylinders come by pasting a column
    void addWeights(WeighInTable* table, int mostRows, const Note& note);
    /// What the parts are placed for, with what that needs.
    void addGoal(bool asksRadius);
    /// What comes out, and the buttons that move the weights on the sheet and back.
    /// @param notCounted  of the weights: it is said first
    void addFindings(std::function<QStringList()> notCounted = {});
    /// A table that is there while it has rows.
    void addTable(std::string_view part, const QString& name);

    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// What is shown below the weights.
    struct Findings {
        QStringList summary;
        bool isAmber = false;
        bool canMove = false;
    };
    template <typename Model>
    static Findings findingsOf(const Model& model) {
        const auto shown = model.matchingShown();
        return {QStringList(model.assignmentText()) + model.assignmentRemarks(),
                shown ? !shown->matched.remark.empty() : !model.weighAgain().isEmpty(),
                shown && shown->matched.moved > 0};
    }

    QLabel* put(int row, int column, const QString& text, int size, bool bold = false);
    void addColumn(int column, const Note& note);
    NumberField* addCell(int row, int column);
    /// A row of the grid, a control in the column of each part: where it may go.
    void addMoves(int row);
    /// @return true where the clipboard has several numbers
    bool pasteBlock(int row, int column);
    void addAngles();

    std::function<Rules()> rules_;
    std::function<void(const QString&, const std::function<void(Rules&)>&)> edit_;
    std::function<bool()> isMoved_;  ///< parts can go back to where they were weighed
    std::function<void()> move_;
    std::function<void()> moveBack_;
    std::function<Findings()> find_;
    WeighInTable* table_ = nullptr;
    QGridLayout* grid_ = nullptr;
    int rows_ = 0;                     ///< that have cells
    std::vector<NumberField*> cells_;  ///< column by column
    TroubleLine* trouble_ = nullptr;
    QComboBox* goal_ = nullptr;  ///< what the parts are placed for
};

}  // namespace ravnoves
