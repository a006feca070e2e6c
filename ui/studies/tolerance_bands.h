#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

namespace ravnoves {

class ScenePage;

/// What the tolerances of a page's case do to what it shows: a band of 5…95 % about each curve, a ±
/// beside each number of its tables.
///
/// A second page of the same scene, which nobody sees, is solved with one input after the other a
/// standard deviation to either side. How far that moves a point of a curve or a number is what the
/// input does to it, and the squares add up: linear propagation by central differences. One
/// solution follows another when the window has nothing else to do; while a hand moves, the bands
/// made last go with their curves, pale. So no scene needs a line for it, and nothing is there
/// without tolerances. What a page computes in the background has no band.
class ToleranceBands : public QObject {
    Q_OBJECT

  public:
    /// Belongs to the page and follows its model.
    explicit ToleranceBands(ScenePage* page);
    ~ToleranceBands() override;

    /// True until what is seen has its bands.
    bool isBusy() const { return later_.isActive(); }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Parts;
    struct Snapshot;
    struct Run;

    /// @param isOther  what is shown is another, not only more or less of it
    void outdate(bool isOther);
    void step();
    std::unique_ptr<Run> begin();
    /// @return nothing where the input is refused
    std::optional<Snapshot> solved(const Run& run, std::size_t input, double by);
    void finish(const Run& run);
    void clear();
    void setStale();

    ScenePage* page_;
    std::unique_ptr<ScenePage> twin_;
    std::unique_ptr<Run> run_;
    QTimer later_;
    bool outdated_ = false;
    bool isOther_ = false;  ///< since the run began
    bool isClear_ = true;
};

}  // namespace ravnoves
