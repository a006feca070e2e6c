#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <map>
#include <string>

#include "model/part.h"
#include "studies/study.h"

namespace ravnoves {

class BackgroundJob;
class ScenePage;

/// The effect of the tolerances on the page, and of the phase that a pressure trace leaves open: a
/// band of 5…95 % about each curve, a ± beside each number of its tables.
///
/// After a pause, a worker solves samples of the case with a model of its own, which makes the
/// parts of each. So no scene needs a line for it. Parts that take longer than a frame have no
/// bands.
class ToleranceBands : public QObject {
    Q_OBJECT

  public:
    /// Belongs to the page and follows its model.
    explicit ToleranceBands(ScenePage* page);
    ~ToleranceBands() override;

    /// Whether pages show them: one choice for the program, kept for the next start.
    static bool areShown();
    static void setShown(bool shown);

    /// True until the visible parts have their bands.
    bool isBusy() const;
    /// Solves the samples; with progress.
    BackgroundJob* job() const { return job_; }
    /// Begins the bands of all parts of the page, also of hidden ones, until something changes.
    void findAll();
    /// The spread of a part; null without one.
    const PartSpread* spreadOf(std::string_view part) const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// The content has changed.
    void outdate();
    /// The bands of the visible parts, after a pause.
    void beginLater();
    void begin();
    void clear(bool othersFollow);
    /// Whether there are tolerances to be shown.
    bool isWanted() const;
    /// The tolerances of the case as far as bands depend on them.
    studies::Study readStudy() const;

    ScenePage* page_;
    BackgroundJob* job_;
    std::map<std::string, PartSpread, std::less<>> spreads_;
    studies::Study study_;
    QTimer rest_;
    int solutions_ = -1;
    bool isOfAll_ = false;
    bool isAwaited_ = false;  ///< tables show "± …"
};

}  // namespace ravnoves
