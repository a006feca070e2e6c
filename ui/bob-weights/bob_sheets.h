#pragma once

#include "bob-weights/model/bob_weights_model.h"
#include "workshop/matching_sheet.h"

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
class BobWeighInSheet : public MatchingSheet {
    Q_OBJECT

  public:
    static constexpr int mostRows = 16;  ///< further cylinders come by pasting a column

    explicit BobWeighInSheet(BobWeightsModel* model, QWidget* parent = nullptr);
};

/// Sheet 4: what the machine reads in which planes, and what may remain.
class BobMachineSheet : public BobSheet {
    Q_OBJECT

  public:
    explicit BobMachineSheet(BobWeightsModel* model, QWidget* parent = nullptr);

  private:
    /// A grid over the whole width with its headings, and the line for what is refused in it.
    std::pair<QGridLayout*, TroubleLine*> grid(const QStringList& headings);
    NumberField* cell(const Field& field, const QString& name, const QString& spoken);
    void buildPlanes();
    void buildRuns();
    void buildTolerance();

    QList<NumberField*> readings_;  ///< run by run
    QComboBox* grades_ = nullptr;
};

/// Sheet 5: drills and slugs at hand.
class BobDrillsSheet : public BobSheet {
    Q_OBJECT

  public:
    explicit BobDrillsSheet(BobWeightsModel* model, QWidget* parent = nullptr);
};

}  // namespace ravnoves
