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

    /// Writes to a file, DXF or CSV by its ending, as the form is set.
    /// @return an empty string, or the fault
    QString exportTo(const QString& path);

  Q_SIGNALS:
    /// A line for the status bar.
    void status(const QString& text);

  private:
    void showGuide();
    QComboBox* addChoice(const char* name, const QString& label, const QStringList& words,
                         const QString& hint);
    void ask(const QString& suffix);

    ElasticHingeModel* model_;
    QComboBox* hinge_;
    QComboBox* branch_;
    QComboBox* turns_;
    QLabel* note_;
    QPushButton* dxf_;
    QPushButton* csv_;
};

}  // namespace ravnoves
