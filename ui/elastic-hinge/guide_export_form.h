#pragma once

#include <QWidget>

#include "elastic-hinge/model/elastic_hinge_model.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace ravnoves {

class NumberField;

/// Export of a guide for the machine shop.
class GuideExportForm : public QWidget {
    Q_OBJECT

  public:
    explicit GuideExportForm(ElasticHingeModel* model, QWidget* parent = nullptr);

    /// Writes to a file, DXF or CSV by its ending, as the form is set.
    /// @return an empty string, or what is wrong
    QString exportTo(const QString& path);

  Q_SIGNALS:
    /// A line for the status bar.
    void status(const QString& text);

  private:
    void show();
    void ask(const QString& filter, const QString& ending);
    elastic_hinge::Hinge hinge() const;

    ElasticHingeModel* model_;
    QComboBox* hinge_;
    QComboBox* branch_;
    QComboBox* turns_;
    NumberField* tolerance_;
    NumberField* step_;
    QLabel* note_;
    QPushButton* dxf_;
    QPushButton* csv_;
    double toleranceMm_ = 0.001;
    double stepDeg_ = 0.5;
    bool branchChosen_ = false;
};

}  // namespace ravnoves
