#pragma once

#include <QWidget>
#include <array>

class QTabWidget;

namespace ravnoves {

class InertiaMomentsModel;
class PartPlot;

/// The moments of orders 1 and 2 over φ, and below them, or beside them as tabs: hodographs,
/// orders, roll moment, shafts, counterweights, firing order, forces and moments of all orders over
/// φ.
class InertiaMomentsCharts : public QWidget {
    Q_OBJECT

  public:
    InertiaMomentsCharts(InertiaMomentsModel* model, QWidget* parent);

    QTabWidget* tabs() const { return tabs_; }
    QSize minimumSizeHint() const override;

  protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// Where the window is too low for both, the orders' moments are one more tab.
    void foldWhereNeeded();
    void foldMoments(bool folded);
    /// What the folded plots show.
    void tellOrders();
    int heightOfBoth() const;
    void addOrders();
    /// Two beside each other, or below one another.
    std::array<PartPlot*, 2> addPair(const char* left, const char* right, const QString& title);
    void addBars();
    PartPlot* addAnglePlot(const char* part, QWidget* parent);
    /// Where the vectors are now, on their hodographs.
    void showCursor();

    InertiaMomentsModel* model_;
    QWidget* orders_;  ///< both plots of orders
    bool isForce_ = false;
    QSize foldedAt_;
    int foldings_ = 0;  ///< at that size, as the curves are named now
    QTabWidget* tabs_;
    std::array<PartPlot*, 2> hodographs_{};  ///< forces, moments
};

}  // namespace ravnoves
