#pragma once

#include <QStringList>
#include <QVector>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "case-file/json.h"
#include "elastic-hinge/guide_export.h"
#include "elastic-hinge/motion_runner.h"
#include "elastic-hinge/solver.h"
#include "shell/scene_view_model.h"

namespace ravnoves {

/// The state of the elastic-hinge page: input, the solver's result, the motions (computed in a
/// worker thread), and what the pictures show.
class ElasticHingeViewModel : public SceneViewModel {
    Q_OBJECT

  public:
    /// Which motion the picture plays.
    enum class Animated { WithoutHinge, CrankHinge, BothHinges, OffDesign };
    Q_ENUM(Animated)

    /// One sentence on the design, and how good the news is.
    struct Verdict {
        enum class Level { Good, Warning, Bad };
        Level level = Level::Good;
        QString text;
    };

    explicit ElasticHingeViewModel(QObject* parent = nullptr);

    QString sceneName() const override { return QStringLiteral("elastic-hinge"); }
    Json inputJson() const override;
    void loadInput(const Json& input, const CaseContext& context) override;
    Json resultJson() const override;
    void loadDefault() override;
    bool setViewOption(const QString& key, const QString& value) override;

    const elastic_hinge::Input& input() const { return input_; }
    const elastic_hinge::Result& result() const { return *result_; }
    /// The newest motions that are there; null before the first.
    const HingeMotions* motions() const { return motions_.get(); }
    MotionRunner* runner() { return &runner_; }

    /// Changes the input by `mutate` as one step of the history; changes with the same name that
    /// follow each other become one step.
    /// @return an empty string, or what is wrong with it; the old input holds then
    QString edit(const QString& name, const std::function<void(elastic_hinge::Input&)>& mutate);
    /// The next change is a step of its own in the history.
    void finishDrag() {
        ++mergeNumber_;
        lastEdit_.clear();
    }

    double crankAngleDeg() const { return crankAngle_; }  ///< φ of the picture, 0…360
    void setCrankAngleDeg(double angle);
    /// Time within the motion that the picture plays, s; nothing while it is turned by hand.
    std::optional<double> motionTime() const { return motionTime_; }
    void setMotionTime(std::optional<double> seconds);
    Animated animated() const { return animated_; }
    void setAnimated(Animated animated);
    /// The motion that the picture plays; null where there is none.
    const elastic_hinge::Motion* animatedMotion() const;
    /// Speed of the crank in the picture, rad/s.
    double shownSpeed() const;

    elastic_hinge::Hinge shownHinge() const { return shownHinge_; }
    void setShownHinge(elastic_hinge::Hinge hinge);
    const elastic_hinge::Guide& shownGuide() const { return guideOf(shownHinge_); }
    const elastic_hinge::Guide& guideOf(elastic_hinge::Hinge hinge) const;
    /// Factor by which the pictures enlarge the guide's relief; 1 is to scale.
    double exaggeration() const;
    /// Nothing: chosen from the relief.
    void setExaggeration(std::optional<double> factor);
    bool hasAutomaticExaggeration() const { return !exaggeration_; }

    const std::vector<double>& compareSpeeds() const { return options_.speeds; }
    const std::vector<double>& compareLambdas() const { return options_.lambdas; }
    void setCompareSpeeds(const std::vector<double>& speeds);
    void setCompareLambdas(const std::vector<double>& lambdas);

    /// What the search is asked for, and what it finds now (computed when first asked).
    elastic_hinge::GuideWish wish() const;
    const elastic_hinge::GuideProposal& proposal() const;
    QString proposalText() const;
    void takeProposal();
    /// Give the crank's guide what it needs.
    void takeMinimumPreload();
    void takeMinimumStiffness();

    Verdict verdict() const;
    // What the page's tables show: text in the user's locale, the first column the row's name.
    QStringList quantityColumns() const;
    QVector<QStringList> quantityRows() const;
    /// What the user should know about the result; empty where there is nothing.
    QString notesText() const;
    /// How the motions went, one line each.
    QString motionsText() const;

    /// Writes a guide as DXF or CSV, by the file's ending.
    /// @return an empty string, or what is wrong
    QString exportGuide(const QString& path, elastic_hinge::Hinge hinge,
                        elastic_hinge::GuideDrawing drawing, double stepDeg) const;

  Q_SIGNALS:
    void crankAngleChanged(double degrees);
    /// Which guide is shown, exaggeration, animated motion.
    void viewChanged();
    void motionsChanged();
    /// A change was refused.
    void refused(const QString& why);

  private:
    void apply(const elastic_hinge::Input& input);
    std::shared_ptr<const elastic_hinge::Result> solved(elastic_hinge::Input input) const;

    elastic_hinge::Input input_;
    elastic_hinge::SolveOptions options_;
    std::shared_ptr<const elastic_hinge::Result> result_;
    /// What edit() has solved and apply() is about to take over.
    std::shared_ptr<const elastic_hinge::Result> prepared_;
    elastic_hinge::Input preparedInput_;
    mutable std::optional<elastic_hinge::GuideProposal> proposal_;
    MotionRunner runner_{this};
    std::shared_ptr<const HingeMotions> motions_;
    double crankAngle_ = 60.0;
    std::optional<double> motionTime_;
    Animated animated_ = Animated::CrankHinge;
    elastic_hinge::Hinge shownHinge_ = elastic_hinge::Hinge::crank;
    std::optional<double> exaggeration_;
    int mergeNumber_ = 0;
    QString lastEdit_;
};

}  // namespace ravnoves
