#pragma once

#include "elastic-hinge/model/elastic_hinge_model.h"
#include "widgets/form.h"

namespace ravnoves {

/// The form with the inputs that have no slider.
class HingeInputs : public Form {
    Q_OBJECT

  public:
    explicit HingeInputs(ElasticHingeModel* model, QWidget* parent = nullptr);

  private:
    using Input = elastic_hinge::Input;

    void addMechanism();
    void addMasses(bool weights);
    void addSprings();
    void addCounterweight();
    void addMotion();
    /// A box to tick for an object that the input may have.
    void addObjectBox(const Field& field, const QString& name,
                      std::function<bool(const Input&)> has, std::function<void(Input&, bool)> set);
    /// Shows the section of the following rows only while the input needs it.
    void showSectionWhile(std::function<bool(const Input&)> wanted);
    /// A number that an emptied field does not take back to its default.
    void addFilled(const char* pointer) { number(pointer)->setOptional(false); }

    ElasticHingeModel* model_;
};

}  // namespace ravnoves
