#pragma once

#include "elastic-hinge/model/elastic_hinge_model.h"
#include "widgets/form.h"

class QPushButton;

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
    template <typename Object>
    void addObjectBox(const Field& field, std::optional<Object> Input::*object, const char* name,
                      std::function<Object(const Input&)> usual);
    /// Shows the section of the following rows only while the input needs it.
    void showSectionWhile(std::function<bool(const Input&)> wanted);
    /// A number that an emptied field does not take back to its default.
    void addFilled(const char* pointer) { number(pointer)->setOptional(false); }

    ElasticHingeModel* model_;
};

/// Search for a spring whose guide has a wanted relief within a wanted size.
class GuideSearchForm : public Form {
    Q_OBJECT

  public:
    explicit GuideSearchForm(ElasticHingeModel* model, QWidget* parent = nullptr);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    std::function<void()> showAnswer_;
};

/// Export of a guide for the machine shop.
class GuideExportForm : public Form {
    Q_OBJECT

  public:
    explicit GuideExportForm(ElasticHingeModel* model, QWidget* parent = nullptr);

  Q_SIGNALS:
    /// A line for the status bar.
    void status(const QString& text);

  private:
    void showGuide();
    void ask(const QString& suffix);

    ElasticHingeModel* model_;
    QLabel* note_;
    QPushButton* dxf_;
    QPushButton* csv_;
};

}  // namespace ravnoves
