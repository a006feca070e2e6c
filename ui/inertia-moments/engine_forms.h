#pragma once

#include "widgets/form.h"
#include "widgets/panel.h"

class QComboBox;

namespace ravnoves {

class InertiaMomentsModel;

/// Layout, crank gear and rod.
class EngineForm : public Form {
    Q_OBJECT

  public:
    explicit EngineForm(InertiaMomentsModel* model);

  private:
    void addRodLength();
    void addLayoutChoice();
    void addFiringOrder();
    void addRotatingMass();
    void addRod();
    void showLayout();

    InertiaMomentsModel* model_;
    QComboBox* layout_;
};

/// Balance shafts and counterweights.
class BalancingForm : public Form {
    Q_OBJECT

  public:
    explicit BalancingForm(InertiaMomentsModel* model);
};

/// The four values that move by sliders.
class EngineSliders : public Panel {
    Q_OBJECT

  public:
    EngineSliders(InertiaMomentsModel* model, QWidget* parent);
};

}  // namespace ravnoves
