#pragma once

#include <array>

#include "widgets/page_columns.h"

namespace ravnoves {

class InertiaMomentsModel;
class PartPlot;

/// The tabs of plots, and of the pictures of firing order, shafts and counterweights.
class InertiaMomentsCharts : public FittedTabs {
    Q_OBJECT

  public:
    InertiaMomentsCharts(InertiaMomentsModel* model, QWidget* parent);

  private:
    /// @param name  of the tab for pictures
    void add(QWidget* view, const char* name, const QString& title);
    void addOrders();
    /// Two beside each other, or below one another.
    std::array<PartPlot*, 2> addPair(const char* left, const char* right, const char* name,
                                     const QString& title);
    /// Where the vectors are now, on their hodographs.
    void showCursor();

    InertiaMomentsModel* model_;
    std::array<PartPlot*, 2> hodographs_{};  ///< forces, moments
};

}  // namespace ravnoves
