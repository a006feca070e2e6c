#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "elastic-hinge/model/elastic_hinge_model.h"

class QCheckBox;
class QComboBox;

namespace ravnoves {

class FormSection;
class NumberField;
class NumberListField;

/// The form with the inputs that have no slider.
class HingeInputs : public QWidget {
    Q_OBJECT

  public:
    explicit HingeInputs(ElasticHingeModel* model, QWidget* parent = nullptr);

  private:
    /// A field bound to one number of the input.
    struct Binding {
        NumberField* field;
        std::function<std::optional<double>()> read;
    };
    using Access = std::function<double*(elastic_hinge::Input&)>;

    void bind(NumberField* field, const QString& name, double unit, Access access);
    void bindOptional(NumberField* field, const QString& name,
                      std::function<std::optional<double>()> read,
                      std::function<void(elastic_hinge::Input&, std::optional<double>)> write);
    FormSection* massSection(bool weights);
    FormSection* hingeSection();
    FormSection* rodSpringSection();
    FormSection* counterweightSection();
    FormSection* counterweightFields(bool weights);
    FormSection* makingSection();
    FormSection* motionSection();
    FormSection* familySection();
    void show();

    ElasticHingeModel* model_;
    std::vector<Binding> bindings_;
    QComboBox* preset_ = nullptr;
    QComboBox* given_ = nullptr;
    FormSection* weights_ = nullptr;
    FormSection* masses_ = nullptr;
    QComboBox* kinematics_ = nullptr;
    QComboBox* sign_ = nullptr;
    QCheckBox* ownRodSpring_ = nullptr;
    FormSection* rodSpring_ = nullptr;
    QCheckBox* counterweight_ = nullptr;
    FormSection* counterweightAsWeight_ = nullptr;
    FormSection* counterweightAsMass_ = nullptr;
    std::vector<QComboBox*> inertias_;
    QCheckBox* withError_ = nullptr;
    NumberListField* speeds_ = nullptr;
    NumberListField* lambdas_ = nullptr;
};

}  // namespace ravnoves
