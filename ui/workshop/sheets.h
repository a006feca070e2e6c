#pragma once

#include "bob-weights/solver.h"
#include "workshop/workshop_sheet.h"

class QComboBox;
class QGridLayout;
class QPushButton;

namespace ravnoves {

/// Sheet 1: whose job it is, which engine, whether it has plugs.
class JobSheet : public WorkshopSheet {
    Q_OBJECT

  public:
    explicit JobSheet(WorkshopModel* model, QWidget* parent = nullptr);
};

/// Sheet 2: the parts of one cylinder, or what plugs ask of them.
class PartsSheet : public WorkshopSheet {
    Q_OBJECT

  public:
    explicit PartsSheet(WorkshopModel* model, QWidget* parent = nullptr);
};

/// Sheet 3: every part of every cylinder on the scale, a column for each kind of part and a row for
/// each cylinder; which parts may move, the goal of their placing, and the result. Columns weighed
/// whole precede sheet 2. Enter moves down the columns, in the order of weighing; a block of a
/// spreadsheet is pasted from the cell that has the focus.
class WeighInSheet : public WorkshopSheet {
    Q_OBJECT

  public:
    explicit WeighInSheet(WorkshopModel* model, QWidget* parent = nullptr);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void addSource();
    void addWeights();
    QLabel* put(int row, int column, int size);
    NumberField* addCell(int row, int column);
    void addMoves();
    void addGoal();
    void addFindings();
    void addTable(std::string_view part, const QString& name);
    shop::MatchingRules rules() const;

    QGridLayout* grid_ = nullptr;
    TroubleLine* trouble_ = nullptr;
    QComboBox* goal_ = nullptr;  ///< what the parts are placed for
};

/// Sheet 4: the plugs of a V-8.
class PlugsSheet : public WorkshopSheet {
    Q_OBJECT

  public:
    explicit PlugsSheet(WorkshopModel* model, QWidget* parent = nullptr);

  private:
    void addName();
    void addPlugs(const QString& label, const QString& name, const QString& hint,
                  v8_plugs::EngineGroup group, bool v8_plugs::Engine::*member);
    void addThread();
};

/// Sheet 5: the machine's set-up, its readings in their planes, and the limits.
class MachineSheet : public WorkshopSheet {
    Q_OBJECT

  public:
    explicit MachineSheet(WorkshopModel* model, QWidget* parent = nullptr);

    /// The next reading: the first of the run that is not read yet; else the first one.
    QWidget* nextReading() const;
    bool isDoubtful() const override;

  private:
    void addHold();
    void buildRuns();
    void buildPlanes();
    void buildTolerance();
    void buildMachine();
    void followNames(QGridLayout* grid, const QStringList& units);

    QList<NumberField*> readings_;  ///< run by run
    QPushButton* hold_ = nullptr;
};

/// Sheet 6: drills and slugs at hand, and the holes really drilled.
class CorrectionSheet : public WorkshopSheet {
    Q_OBJECT

  public:
    explicit CorrectionSheet(WorkshopModel* model, QWidget* parent = nullptr);

    /// What became of a hole of the record; null without one.
    QWidget* drilled(const std::optional<bob_weights::Hole::Place>& hole) const;

  private:
    void buildWhatIf();
    void showWhatIf();
    /// What the hole would leave; its values are whole.
    std::optional<bob_weights::Remaining> tried() const;
    void buildDrilled();
    void addHoleRow();
    void followPlanes(QComboBox* box);
    /// As many rows as there are holes.
    void growRows();
    /// @param isBefore  it was there before the first reading, else before the last one
    void addHole(bool isBefore);

    /// Of no case: a hole that is thought of, or is to be added.
    struct WhatIf {
        int plane = 0;
        std::optional<double> diameter;
        std::optional<double> depth;
        std::optional<double> angle;
    };
    WhatIf whatIf_;
    QList<NumberField*> whatIfFields_;
    QLabel* whatIfLine_ = nullptr;
    QPushButton* addHole_ = nullptr;
    QPushButton* addLateHole_ = nullptr;
    QGridLayout* holes_ = nullptr;
    TroubleLine* trouble_ = nullptr;
    QList<QList<QWidget*>> rows_;
};

}  // namespace ravnoves
