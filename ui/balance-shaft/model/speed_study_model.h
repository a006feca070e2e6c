#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/change_contours.h"
#include "balance-shaft/speed_study.h"

namespace ravnoves {

class BackgroundJob;

/// The shaft over a band of speeds, solved off the GUI thread: best α over speed, a map of the
/// criterion over (α, speed) and the α that is the best compromise over the band.
class SpeedStudyModel : public QObject {
    Q_OBJECT

  public:
    using Criterion = balance_shaft::SpeedStudy::Criterion;
    /// Change of the criterion against the engine without a shaft at the same speed, or the high
    /// speeds would drown the rest: over α in ° and the speed in min⁻¹; empty before it is solved.
    const ChangeContours& map() const { return map_; }
    /// Between the neighbours in proportion.
    double changeAt(double angleDeg, double speed) const;

    /// Belongs to the model.
    explicit SpeedStudyModel(BalanceShaftModel* model);

    BackgroundJob* job() const { return job_; }
    /// Of the input; without one from idling to a little above the speed entered.
    static balance_shaft::SpeedBand bandOf(const balance_shaft::Input& input);
    balance_shaft::SpeedBand band() const { return bandOf(model_->input()); }
    /// @param end  one of the band's two ends; the speed is in rad/s
    void setBand(double balance_shaft::SpeedBand::*end, double speed);
    /// The model's criterion is another.
    void showCriterion();

    /// Begins to solve where its inputs have changed since.
    void need();
    void cancel();
    /// False before the first study, and where none can be made of this input.
    bool isSolved() const { return !map_.levels.empty(); }
    /// None can be made of this input; answer() says why.
    bool isRejected() const { return study_.study != nullptr && !isSolved(); }

    // Of the solved study.
    const balance_shaft::BuildableAngles& buildable() const { return study_.study->buildable(); }
    const std::vector<balance_shaft::SpeedStudy::Point>& points() const {
        return study_.study->points();
    }
    /// α that is the best compromise by the criterion, °.
    double bestCompromiseDeg() const { return among(study_.best).shaft_angle / degree; }
    void goToBestCompromise();

    /// The best compromise α in a sentence, or the reason for none.
    QString answer() const;

    /// A place of the map: α, and of a torque that follows it the speed, min⁻¹.
    void pick(double angleDeg, double speed);
    /// What the study takes for the gas torque, as a sentence.
    QString gasAtEverySpeed() const;

  Q_SIGNALS:
    /// The map is another, or none.
    void mapChanged();

  private:
    using BestCompromise = balance_shaft::SpeedStudy::BestCompromise;
    using Best = std::array<BestCompromise, 2>;  ///< by range and by RMS
    struct Study {
        std::shared_ptr<const balance_shaft::SpeedStudy> study;
        std::optional<balance_shaft::SpeedStudy::Map> map;
        Best best;  ///< of the feasible angles, of all where none is
        Best ofAll;
    };

    static Study studyOf(const balance_shaft::Input& input, const balance_shaft::SpeedBand& band,
                         const std::function<bool(double)>& progress);
    const BestCompromise& among(const Best& best) const { return best[model_->byRange() ? 0 : 1]; }
    void take(Study study, const QString& trouble);
    ChangeContours mapOf(const balance_shaft::SpeedStudy::Map& studied) const;

    BalanceShaftModel* model_;
    BackgroundJob* job_;
    Study study_;
    ChangeContours map_;                          ///< by the criterion
    QString trouble_;                             ///< why the last run gave nothing
    int seen_ = -1;                               ///< solution of the model
    std::optional<balance_shaft::Input> wanted_;  ///< the solved input, or the next one
};

}  // namespace ravnoves
