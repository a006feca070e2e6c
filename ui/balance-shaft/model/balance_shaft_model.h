#pragma once

#include <optional>
#include <utility>

#include "balance-shaft/dead_centre.h"
#include "balance-shaft/gear_error.h"
#include "balance-shaft/input.h"
#include "balance-shaft/position_study.h"
#include "balance-shaft/presets.h"
#include "balance-shaft/results.h"
#include "balance-shaft/solver.h"
#include "balance-shaft/speed_study.h"
#include "model/case_model.h"
#include "model/crank_angle.h"
#include "text/result_row.h"

namespace ravnoves {

class BackgroundJob;
class ShaftMapModel;
class SpeedStudyModel;

/// What CaseModel knows of the scene.
struct BalanceShaftScene {
    using Input = balance_shaft::Input;
    struct Solved {
        balance_shaft::Solver solver;
        balance_shaft::Result result;
        mutable std::optional<balance_shaft::EnvelopeStudy> envelopes;
        mutable std::optional<balance_shaft::GearError> gears;  ///< at the present α
    };
    static Input defaultInput() { return balance_shaft::preset_tmz_650d(); }
    static QString defaultTitle();
    static constexpr auto read = &balance_shaft::read_input;
    static constexpr auto write = &balance_shaft::write_input;
    static constexpr auto kept = &balance_shaft::write_kept;
    static void keep(Input& input, const Json& json, const CaseContext& context) {
        balance_shaft::read_kept(json, context, input);
    }
    /// Its shaft may be elsewhere.
    static bool isSameEngine(Input a, const Input& b) {
        a.shaft_angle = b.shaft_angle;
        return a == b;
    }
    Solved solve(const Input& input) const {
        balance_shaft::Solver solver(input);
        balance_shaft::Result result = solver.result();
        return {std::move(solver), std::move(result), {}, {}};
    }
};

/// The state of the balance-shaft page: input, the solver's result, the crank angle of the picture.
///
/// Moving the shaft costs about a microsecond (Solver::move_shaft), any other change a new Solver.
class BalanceShaftModel : public CaseModel<BalanceShaftScene> {
    Q_OBJECT

  public:
    explicit BalanceShaftModel(QObject* parent = nullptr);

    QString sceneName() const override { return QStringLiteral("balance-shaft"); }
    std::span<const PagePart> parts() const override;
    Content part(std::string_view id) const override;
    std::unique_ptr<SceneModel> another(bool /*runsJobs*/) const override {
        return std::make_unique<BalanceShaftModel>();  // its jobs run where someone looks
    }
    void needPart(std::string_view id) override;
    Json resultJson() const override;
    std::vector<std::string> replacedInputs() const override;
    bool setViewOption(const QString& key, const QString& value) override;
    void takeView(const SceneModel& other) override;

    const balance_shaft::Result& result() const { return solved().result; }
    const balance_shaft::Solver& solver() const { return solved().solver; }

    /// The source of the torque; a first use starts with values from the present input (rod length,
    /// bore, the table's mean torque). Returns as edit().
    QString setTorqueKind(balance_shaft::TorqueSource::Kind kind);
    /// Makes a table of the present torque, at the angles of the curves. Returns as edit().
    QString tabulateTorque();
    /// The table's inertia torque contradicts the masses and speed entered.
    bool canRebuildTorque() const;
    /// Puts the inertia torque of the masses and speed into the table. Returns as edit().
    QString rebuildTorque();
    /// What counts from the firing top dead centre counts from the other one, or back.
    void moveTraceByTurn();
    /// Gives heat or mean effective pressure of a computed cycle; the other one follows from it.
    QString setLoad(std::optional<double> balance_shaft::GasCycle::*given, double value);

    double shaftAngleDeg() const;  ///< α
    /// Moves the shaft and the result in place: shownChanged(), not changed().
    void setShaftAngleDeg(double angle);
    /// By a hand in a picture: to a tenth of a degree.
    void pickShaftAngleDeg(double angle);

    double cycleDeg() const { return input().cycle_deg(); }  ///< 360 or 720

    CrankAngle* crank() { return &crank_; }
    const CrankAngle* crank() const { return &crank_; }

    /// By range or by RMS.
    using Criterion = balance_shaft::SpeedStudy::Criterion;
    /// What both maps show, of places and over α and speed, and judge by.
    Criterion criterion() const { return criterion_; }
    bool byRange() const { return criterion_ == Criterion::range; }
    void setCriterion(Criterion criterion);

    // What takes longer than a frame, computed while someone looks; made when first asked for.
    ShaftMapModel* shaftMap();
    SpeedStudyModel* speedStudy();
    const ShaftMapModel* shaftMap() const { return shaftMap_; }        ///< null: not asked for
    const SpeedStudyModel* speedStudy() const { return speedStudy_; }  ///< likewise

    /// The best of the feasible angles; of all where none is.
    const balance_shaft::Optimum& best(Criterion criterion) const;
    void goToBest(Criterion criterion);

    /// Gives J or δ of the flywheel, so that the other one follows from it; or nothing.
    QString setFlywheel(std::optional<double> balance_shaft::FlywheelTarget::*given,
                        std::optional<double> value);

    /// Sets ω, rad/s; the case file then gives it in min⁻¹.
    void setSpeed(double angularSpeed);

    // What views show beside the result; found when first asked for.
    const balance_shaft::EnvelopeStudy& envelopeStudy() const;
    const balance_shaft::GearError& gearError() const;

    /// The mass of a named part, kg; 0 without one.
    double mass(const std::string& name) const;
    /// What the parts of field::mass_parts lack of the reciprocating mass, kg.
    double otherMasses() const;

    // What the page's tables show: text in the user's locale, the first column the row's name.
    Results criteria() const;
    Results quantities() const;
    /// Work, pressures and power of a computed torque; without rows for a table.
    Results cycle() const;
    /// Excess work, fluctuation and moment of inertia.
    Results flywheel() const;
    /// Best α as sentences: the feasible one, and the gain of another.
    QString bestText(Criterion criterion) const;
    /// Notes on the result; empty without any.
    QString notesText() const;
    Verdict verdict() const { return balance_shaft::verdict(result()); }
    std::optional<Verdict> verdictShown() const override { return verdict(); }
    std::vector<const char*> designInputs() const override {
        return {"/shaft_angle_deg", "/centre_distance_mm", "/counterweight_radius_mm"};
    }
    std::vector<std::string> usualObjects() const override { return {"/envelope"}; }

  private:
    void taken() override { crank_.setCycle(cycleDeg()); }
    void applyShaftAngle(double radians);
    void needDeadCentre();

    CrankAngle crank_{60.0, input().cycle_deg()};
    Criterion criterion_ = {};
    ShaftMapModel* shaftMap_ = nullptr;
    SpeedStudyModel* speedStudy_ = nullptr;
    BackgroundJob* centreJob_;
    balance_shaft::Input soughtIn_;  ///< whose trace's dead centre is found, or will be
    std::optional<balance_shaft::DeadCentre> centre_;
};

extern template class CaseModel<BalanceShaftScene>;

}  // namespace ravnoves
