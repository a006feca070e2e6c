#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <map>
#include <string>

#include "model/part.h"
#include "studies/model/part_numbers.h"
#include "studies/study.h"

namespace ravnoves {

class BackgroundJob;
class ScenePage;

/// What the tolerances of a page's case do to what it shows: a band of 5…95 % about each curve, a ±
/// beside each number of its tables.
///
/// When the hand rests, a worker solves samples of the case with a model of its own, which makes
/// the parts of each. So no scene needs a line for it. What takes longer than a frame has no bands.
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
    /// Begins those of all that the page has, also of what is not seen, until something changes.
    void findAll();
    /// What was found of a part; null where there is nothing.
    const PartSpread* spreadOf(std::string_view part) const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// What is shown is another.
    void outdate();
    /// Those of what is seen now, when the hand rests.
    void beginLater();
    void begin();
    void clear(bool othersFollow);
    void findOf(ScatteredInputs inputs);
    void showSpreads();
    static QString howText(std::size_t count);
    /// Whether there are tolerances to be shown.
    bool isWanted() const;
    /// The tolerances of the case as far as bands depend on them.
    studies::Study readStudy() const;

    ScenePage* page_;
    BackgroundJob* job_;
    std::map<std::string, PartSpread, std::less<>> spreads_;
    studies::Study study_;
    QTimer rest_;
    int run_ = 0;  ///< whose samples count
    int solutions_ = -1;
    bool isOfAll_ = false;
    bool isAwaited_ = false;  ///< tables show "± …"
};

}  // namespace ravnoves
