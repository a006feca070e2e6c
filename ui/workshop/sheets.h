#pragma once

#include "shop/matching_sheet.h"
#include "workshop/model/workshop_model.h"

class QComboBox;
class QGridLayout;
class QPushButton;

namespace ravnoves {

/// A sheet of the workshop's form.
class WorkshopSheet : public SheetForm {
    Q_OBJECT

  public:
    explicit WorkshopSheet(WorkshopModel* model, QWidget* parent = nullptr)
        : SheetForm(model, parent), model_(model) {}

  protected:
    /// The section that is begun is there with plugs alone, or without them alone.
    void withPlugs(bool there);
    /// A line of buttons.
    QPushButton* button(const char* name, const QString& label, const QString& tip,
                        std::function<void()> press);
    /// A grid over the whole width with its headings, and the line for what is refused in it.
    std::pair<QGridLayout*, TroubleLine*> grid(const QStringList& headings);
    NumberField* cell(const Field& field, const QString& name, const QString& spoken);
    /// How the balancing machine is set up.
    void addMachine();

    WorkshopModel* model_;
};

/// Sheet 1: whose job it is, which engine, whether it has plugs.
class JobSheet : public WorkshopSheet {
    Q_OBJECT

  public:
    explicit JobSheet(WorkshopModel* model, QWidget* parent = nullptr);

  private:
    void buildEngine();
    void buildPlugs();
    void showEngines();

    QComboBox* engine_ = nullptr;  ///< whose plugs
};

/// Sheet 2: the parts of one cylinder, or what plugs ask of them.
class PartsSheet : public WorkshopSheet {
    Q_OBJECT

  public:
    explicit PartsSheet(WorkshopModel* model, QWidget* parent = nullptr);

  private:
    void buildParts();
    void buildChanges();
};

/// Sheet 3: every part of every cylinder on the scale. What is weighed whole goes before sheet 2.
class WeighInSheet : public MatchingSheet {
    Q_OBJECT

  public:
    static constexpr int mostRows = 16;  ///< further cylinders come by pasting a column

    explicit WeighInSheet(WorkshopModel* model, QWidget* parent = nullptr);
};

/// Sheet 4: the plugs of a V-8.
class PlugsSheet : public WorkshopSheet {
    Q_OBJECT

  public:
    explicit PlugsSheet(WorkshopModel* model, QWidget* parent = nullptr);

  Q_SIGNALS:
    void status(const QString& text);

  private:
    void addValues(v8_plugs::EngineGroup group);
    void addPlugs(const QString& label, const QString& name, const QString& hint,
                  v8_plugs::EngineGroup group, bool v8_plugs::Engine::*member);
    void addThread();
    void addOwnEngineButtons();
    /// Name of the present engine where it is one of the user's own.
    QString presentName() const;
    QString askName(const QString& title, const QString& suggestion);
    void report(const QString& title, const QString& trouble, const QString& done);
    void saveEngine();
    void renameEngine();
    void removeEngine();

    QPushButton* rename_ = nullptr;
    QPushButton* remove_ = nullptr;
};

/// Sheet 5: how the machine is set up, what it reads in which planes, and what may remain.
class MachineSheet : public WorkshopSheet {
    Q_OBJECT

  public:
    explicit MachineSheet(WorkshopModel* model, QWidget* parent = nullptr);

    /// Where one goes on: the first reading of the run that is not read yet; null where there is
    /// none.
    QWidget* nextReading() const;

  private:
    void buildRuns();
    void buildPlanes();
    void buildTolerance();
    void followNames(QGridLayout* grid, const std::vector<std::pair<int, int>>& columns,
                     const QStringList& units);

    QList<NumberField*> readings_;  ///< run by run
    QComboBox* grades_ = nullptr;
};

/// The machine that new jobs begin with, in the settings of the program.
class MachineSettings : public WorkshopSheet {
    Q_OBJECT

  public:
    explicit MachineSettings(QWidget* parent = nullptr);
};

/// Sheet 6: drills and slugs at hand, and what was really drilled.
class CorrectionSheet : public WorkshopSheet {
    Q_OBJECT

  public:
    explicit CorrectionSheet(WorkshopModel* model, QWidget* parent = nullptr);

    /// The first hole of what was drilled last; null where there is none.
    QWidget* lastDrilled() const;

  private:
    void buildDrills();
    void buildSlugs();
    void buildWhatIf();
    void showWhatIf();
    void buildDrilled();
    void addHoleRow();
    /// As many rows as there are holes.
    void growRows();
    void addEarlierHole();

    /// Of no case: a hole that is thought of.
    struct WhatIf {
        int plane = 0;
        std::optional<double> diameter;
        std::optional<double> depth;
        std::optional<double> angle;
    };
    WhatIf whatIf_;
    QLabel* whatIfLine_ = nullptr;
    QGridLayout* holes_ = nullptr;
    TroubleLine* trouble_ = nullptr;
    QList<QList<QWidget*>> rows_;
};

}  // namespace ravnoves
