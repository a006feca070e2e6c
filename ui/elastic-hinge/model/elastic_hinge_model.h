#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "case-file/field.h"
#include "elastic-hinge/guide_export.h"
#include "elastic-hinge/input.h"
#include "elastic-hinge/model/hinge_motions.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/result.h"
#include "elastic-hinge/results.h"
#include "model/case_model.h"
#include "model/crank_angle.h"
#include "text/result_row.h"

namespace ravnoves {

/// What CaseModel knows of the scene.
struct ElasticHingeScene {
    using Input = elastic_hinge::Input;
    struct Solved {
        std::shared_ptr<const elastic_hinge::Result> result;
        mutable std::optional<elastic_hinge::GuideProposal> proposal;  ///< once it was asked for
    };
    static Input defaultInput() { return elastic_hinge::preset_zotov(); }
    static QString defaultTitle();
    static Input read(const Json& input, const CaseContext& /*context*/) {
        return elastic_hinge::read_input(input);
    }
    static constexpr auto write = &elastic_hinge::write_input;
    /// Without the search for a guide.
    static Solved solve(Input input);
};

/// The state of the elastic-hinge page: input, the solver's result, the motions (computed in a
/// worker thread), and what the pictures show.
class ElasticHingeModel : public CaseModel<ElasticHingeScene> {
    Q_OBJECT

  public:
    /// Which motion the picture plays.
    enum class Animated { WithoutHinge, CrankHinge, BothHinges, OffDesign };
    Q_ENUM(Animated)

    /// @param runsJobs  computes motions in the background
    explicit ElasticHingeModel(QObject* parent = nullptr, bool runsJobs = true);

    QString sceneName() const override { return QStringLiteral("elastic-hinge"); }
    std::span<const PagePart> parts() const override;
    Content part(std::string_view id) const override;
    std::unique_ptr<SceneModel> another(bool runsJobs) const override {
        return std::make_unique<ElasticHingeModel>(nullptr, runsJobs);
    }
    Json resultJson() const override;
    bool setViewOption(const QString& key, const QString& value) override;
    void takeView(const SceneModel& other) override;

    const elastic_hinge::Result& result() const { return *solved().result; }
    /// The newest motions that are there; null before the first.
    const HingeMotions* motions() const { return motions_.get(); }
    BackgroundJob* runner() { return &runner_; }

    CrankAngle* crank() { return &crank_; }
    /// Time within the motion that the picture plays, s; nothing where the crank was turned since.
    std::optional<double> motionTime() const { return motionTime_; }
    void setMotionTime(double seconds);
    Animated animated() const { return animated_; }
    void setAnimated(Animated animated);
    /// The motion that the picture plays; null without one.
    const elastic_hinge::Motion* animatedMotion() const;
    /// Speed of the crank in the picture, rad/s.
    double shownSpeed() const;

    /// The guides as the verdict names them, with the moment of their hinge, in the order of Hinge.
    static QStringList hingeNames();
    static QString hingeMoment(elastic_hinge::Hinge hinge);
    elastic_hinge::Hinge shownHinge() const { return shownHinge_; }
    QString shownHingeName() const { return hingeMoment(shownHinge_); }
    void setShownHinge(elastic_hinge::Hinge hinge);
    const elastic_hinge::Guide& shownGuide() const { return guideOf(shownHinge_); }
    const elastic_hinge::Guide& guideOf(elastic_hinge::Hinge hinge) const;
    static constexpr Field exaggerationField{.key = "exaggeration",
                                             .range = Range::between(1, 1e5)};
    /// Factor by which the pictures enlarge the guide's relief; 1 is to scale.
    double exaggeration() const;
    /// Nothing: chosen from the relief.
    void setExaggeration(std::optional<double> factor);
    bool hasAutomaticExaggeration() const { return !exaggeration_; }

    /// Sets gravity, m/s². Where the case gives weights they stay, and the masses follow.
    void setGravity(double gravity);

    /// What the search for a guide finds now (computed when first asked).
    const elastic_hinge::GuideProposal& proposal() const;
    /// The found spring, and the present design beside it.
    QString proposalText() const;
    /// Whether the present guide has the required relief and fits, too.
    bool meetsWish() const;
    void takeProposal();
    /// Gives the crank's guide the preload that it needs.
    void takeMinimumPreload();

    Verdict verdict() const { return elastic_hinge::verdict(input(), result()); }
    std::optional<Verdict> verdictShown() const override { return verdict(); }
    std::vector<const char*> designInputs() const override {
        return {"/crank_radius_mm", "/lambda", "/angular_speed_rad_s"};
    }
    /// How guides are exported.
    struct GuideExport {
        elastic_hinge::Hinge hinge = elastic_hinge::Hinge::crank;
        std::optional<elastic_hinge::Branch> branch;  ///< none: the guide's
        elastic_hinge::GuideDrawing drawing;
        double stepDeg = 0.5;
    };
    GuideExport& guideExport() { return guideExport_; }
    elastic_hinge::Branch exportedBranch() const {
        return guideExport_.branch.value_or(guideOf(guideExport_.hinge).branch);
    }

    // What the page's tables show: text in the user's locale, the first column the row's name.
    Results quantities() const;
    /// How the motions went, one line each.
    QString motionsText() const;

    /// Writes that guide as DXF or CSV, by the file's ending.
    /// @return an empty string, or the fault
    QString exportGuide(const QString& path) const;

  private:
    void taken() override;
    void leaveMotion();
    void showMotions(std::shared_ptr<const HingeMotions> motions);

    bool runsJobs_;
    /// Of the motions: they take as long as a hundred frames of a drag.
    BackgroundJob runner_{this};
    std::shared_ptr<const HingeMotions> motions_;
    CrankAngle crank_{60.0, 360.0};
    bool isPlayed_ = false;  ///< the motion turns the crank
    std::optional<double> motionTime_;
    /// Where the crank was left in the motion, rad; a motion that stops before has no time for it.
    std::optional<double> motionAngle_;
    Animated animated_ = Animated::CrankHinge;
    elastic_hinge::Hinge shownHinge_ = elastic_hinge::Hinge::crank;
    std::optional<double> exaggeration_;
    GuideExport guideExport_;
};

extern template class CaseModel<ElasticHingeScene>;

}  // namespace ravnoves
