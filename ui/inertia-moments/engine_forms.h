#pragma once

#include "widgets/form.h"
#include "widgets/panel.h"

class QComboBox;

namespace ravnoves {

class InertiaMomentsModel;
class ValueSlider;

/// Layout, crank gear and rod.
class EngineForm : public Form {
    Q_OBJECT

  public:
    explicit EngineForm(InertiaMomentsModel* model);

    QComboBox* layoutChoice() const { return layout_; }

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

    ValueSlider* bank() const { return bank_; }
    ValueSlider* offset() const { return offset_; }
    ValueSlider* speed() const { return speed_; }
    ValueSlider* reference() const { return reference_; }

  private:
    ValueSlider* bank_;
    ValueSlider* offset_;
    ValueSlider* speed_;
    ValueSlider* reference_;
};

}  // namespace ravnoves
