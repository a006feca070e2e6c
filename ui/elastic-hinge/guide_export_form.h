#pragma once

#include "elastic-hinge/model/elastic_hinge_model.h"
#include "widgets/form.h"

class QPushButton;

namespace ravnoves {

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
