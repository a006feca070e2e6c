#pragma once

#include "elastic-hinge/model/elastic_hinge_model.h"
#include "widgets/form.h"

namespace ravnoves {

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

}  // namespace ravnoves
