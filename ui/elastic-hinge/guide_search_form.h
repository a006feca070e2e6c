#pragma once

#include <QWidget>

#include "elastic-hinge/model/elastic_hinge_model.h"

class QLabel;
class QPushButton;

namespace ravnoves {

class NumberField;

/// Search for a spring whose guide has a wanted relief within a wanted size.
class GuideSearchForm : public QWidget {
    Q_OBJECT

  public:
    explicit GuideSearchForm(ElasticHingeModel* model, QWidget* parent = nullptr);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void show();

    ElasticHingeModel* model_;
    NumberField* relief_;
    NumberField* diameter_;
    NumberField* shortest_;
    QLabel* answer_;
    QPushButton* take_;
};

}  // namespace ravnoves
