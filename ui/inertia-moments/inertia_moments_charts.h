#pragma once

#include <QWidget>
#include <array>

#include "inertia-moments/model/engine_curves.h"

class QTabWidget;

namespace ravnoves {

class InertiaMomentsModel;
class OrderBars;
class PlotView;
class ShaftView;

/// The moments of orders 1 and 2 over φ, and below them, or beside them as tabs: hodographs,
/// orders, roll moment, shafts, counterweights, firing order, forces and moments of all orders over
/// φ.
class InertiaMomentsCharts : public QWidget {
    Q_OBJECT

  public:
    InertiaMomentsCharts(InertiaMomentsModel* model, QWidget* parent);

    PlotView* moment(int order) const { return moments_.at(static_cast<std::size_t>(order - 1)); }
    PlotView* hodograph(bool force) const { return hodographs_[force ? 0 : 1].plot; }
    PlotView* roll() const { return roll_; }
    /// Force or moment of all orders over φ.
    PlotView* course(bool force) const { return courses_[force ? 0 : 1]; }
    OrderBars* bars() const { return bars_; }
    ShaftView* shaftView() const { return shaftView_; }
    QTabWidget* tabs() const { return tabs_; }
    QSize minimumSizeHint() const override;

  protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    struct Hodograph {
        PlotView* plot = nullptr;
        engine_curves::Interval x;  ///< that its axes were given
        engine_curves::Interval y;
    };

    /// Where the window is too low for both, the orders' moments are one more tab.
    void foldWhereNeeded();
    void foldMoments(bool folded);
    /// What the folded plots show.
    void tellOrders();
    int heightOfBoth() const;
    void addMoments();
    void addHodographs();
    void addBars();
    void addRoll();
    void addCourses();
    void showCourse(bool force);
    void showMoments();
    void nameMoments(bool force);
    void showFront();
    void showHodograph(Hodograph& hodograph, bool force);
    void showCursor(double crankAngle);

    InertiaMomentsModel* model_;
    std::array<PlotView*, 2> moments_{};  ///< of forces where there are no moments
    QWidget* orders_;                     ///< both
    bool isForce_ = false;
    QSize foldedAt_;
    int foldings_ = 0;  ///< at that size, as the curves are named now
    QTabWidget* tabs_;
    std::array<Hodograph, 2> hodographs_;  ///< forces, moments
    OrderBars* bars_ = nullptr;
    PlotView* roll_ = nullptr;
    std::array<PlotView*, 2> courses_{};  ///< forces, moments
    ShaftView* shaftView_ = nullptr;
};

}  // namespace ravnoves
