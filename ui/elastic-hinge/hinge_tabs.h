#pragma once

#include <QTabWidget>

#include "elastic-hinge/model/elastic_hinge_model.h"

class QCheckBox;
class QComboBox;
class QHBoxLayout;
class QVBoxLayout;

namespace ravnoves {

class PartPlot;
class ValueSlider;

/// The plots of the elastic-hinge page, by tabs.
class HingeTabs : public QTabWidget {
    Q_OBJECT

  public:
    explicit HingeTabs(ElasticHingeModel* model, QWidget* parent = nullptr);

  private:
    QVBoxLayout* addTab(const char* name, const QString& title);
    QHBoxLayout* addBar(QVBoxLayout* column);
    PartPlot* addPlot(QVBoxLayout* column, std::string_view part, int share = 1);
    /// Two over φ, whose cursor turns the crank.
    void addAnglePlots(QVBoxLayout* column, std::initializer_list<std::string_view> parts);
    PartPlot* addAnglePlot(QVBoxLayout* column, std::string_view part, int share = 1);
    void addGuides();
    void buildGuideBar(QHBoxLayout* bar);
    void addMotion();
    void addProgress(QHBoxLayout* bar);
    void showView();
    void showAngle();

    ElasticHingeModel* model_;
    PartPlot* guides_ = nullptr;
    PartPlot* speed_ = nullptr;
    QComboBox* hingeChoice_ = nullptr;
    QCheckBox* automatic_ = nullptr;
    ValueSlider* exaggeration_ = nullptr;
};

}  // namespace ravnoves
