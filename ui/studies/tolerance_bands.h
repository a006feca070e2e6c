#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ravnoves {

class BackgroundJob;
class SceneModel;
class ScenePage;
struct BandAnswer;
struct BandRun;

/// What the tolerances of a page's case do to what it shows: a band of 5…95 % about each curve, a ±
/// beside each number of its tables.
///
/// A second page of the same scene, which nobody sees, is solved with one input after the other a
/// standard deviation to either side. How far that moves a point of a curve or a number is what the
/// input does to it, and the squares add up: linear propagation by central differences. One
/// solution follows another when the window has nothing else to do; while a hand moves, the bands
/// made last go with their curves, pale. So no scene needs a line for it, and nothing is there
/// without tolerances.
///
/// When the hand rests, a worker solves samples of the study, which the second page lays out, and
/// their percentiles take the place of what slopes say, batch after batch; where slopes fail, curve
/// and number are marked and say why. Of a linear study slopes stay, tried by 64 samples. What a
/// page computes in the background itself comes last, by slopes, as it takes its time.
class ToleranceBands : public QObject {
    Q_OBJECT

  public:
    /// Belongs to the page and follows its model.
    explicit ToleranceBands(ScenePage* page);
    ~ToleranceBands() override;

    /// True until what is seen has its bands.
    bool isBusy() const;
    /// Solves the samples; with progress.
    BackgroundJob* job() const { return job_; }
    SceneModel* model() const;
    /// There are tolerances, but no bands: solving the input as often takes too long.
    bool isTooLarge() const;
    /// No more samples, until something changes: what there is stays, and the tables say so.
    void stop(const QString& why);
    /// Of all that the page has, also of what is not seen, in one run: each sample is solved once.
    /// What has never been shown is empty. Back to what is seen, the bands that there are stay.
    void setOfAll(bool ofAll);
    /// Nothing is begun meanwhile; bands that there are stay, and what was under way begins again.
    void hold(bool held);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// @param isOther  what is shown is another, not only more or less of it
    void outdate(bool isOther);
    /// Input and tolerances are not those that were there when it was asked before.
    bool isAnother();
    void step();
    std::unique_ptr<BandRun> begin();
    /// Shows the second page another input. @return false where it is refused
    bool load(const BandRun& run, std::size_t input, double by);
    void fill(const BandRun& run);
    /// What the twin computes in the background is not needed now.
    void cancelTwin();
    void finishSlopes();
    void beginSamples();
    void endSamples();
    /// Numbers of the second page, for the worker. @return nothing where they are of no use any
    /// more
    std::optional<std::vector<double>> read(int run, const std::function<void()>& take);
    void showSamples(int run, const BandAnswer& answer);
    void clear();
    void setStale();

    ScenePage* page_;
    BackgroundJob* job_;
    std::unique_ptr<ScenePage> twin_;
    std::unique_ptr<BandRun> run_;
    QTimer later_;
    QTimer rest_;
    std::string seen_;
    int number_ = 0;  ///< of the run whose samples count
    bool outdated_ = false;
    bool isOther_ = false;  ///< since the run began
    bool isClear_ = true;
    bool isHeld_ = false;
    bool isInterrupted_ = false;  ///< it was busy when it was held
    bool isOfAll_ = false;
    int solutions_ = -1;  ///< of the model, at the last look
};

}  // namespace ravnoves
