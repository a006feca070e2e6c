#pragma once

#include "bob-weights/model/bob_weights_model.h"
#include "workshop/sheet_form.h"

class QComboBox;
class QGridLayout;

namespace ravnoves {

/// A sheet of the page of bob weights.
class BobSheet : public SheetForm {
    Q_OBJECT

  public:
    explicit BobSheet(BobWeightsModel* model, QWidget* parent = nullptr)
        : SheetForm(model, parent), model_(model) {}

  protected:
    BobWeightsModel* model_;
};

/// Sheet 1: whose job it is, which engine, which factor.
class BobJobSheet : public BobSheet {
    Q_OBJECT

  public:
    explicit BobJobSheet(BobWeightsModel* model, QWidget* parent = nullptr);
};

/// Sheet 2: the parts on the scale.
class BobPartsSheet : public BobSheet {
    Q_OBJECT

  public:
    explicit BobPartsSheet(BobWeightsModel* model, QWidget* parent = nullptr);
};

/// Sheet 3: every part of every cylinder on the scale. What is weighed whole goes before sheet 2.
class BobWeighInSheet : public BobSheet {
    Q_OBJECT

  public:
    static constexpr int mostRows = 16;  ///< further cylinders stand in the case file alone

    explicit BobWeighInSheet(BobWeightsModel* model, QWidget* parent = nullptr);

  private:
    void addColumn(QGridLayout* grid, int column, TroubleLine* trouble);
    NumberField* addCell(const QString& name, workshop::Part part, int cylinder, QWidget* holder);
};

/// Sheet 4: what the machine reads in which planes, and what may remain.
class BobMachineSheet : public BobSheet {
    Q_OBJECT

  public:
    explicit BobMachineSheet(BobWeightsModel* model, QWidget* parent = nullptr);

  private:
    void buildPlanes();
    void buildTolerance();
    void showGrade();

    QComboBox* grades_ = nullptr;
};

/// Sheet 5: drills and slugs at hand.
class BobDrillsSheet : public BobSheet {
    Q_OBJECT

  public:
    explicit BobDrillsSheet(BobWeightsModel* model, QWidget* parent = nullptr);
};

}  // namespace ravnoves
