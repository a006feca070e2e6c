#pragma once

#include <QStringList>
#include <optional>
#include <utility>

#include "inertia-moments/input.h"
#include "inertia-moments/presets.h"
#include "inertia-moments/result.h"
#include "inertia-moments/results.h"
#include "model/case_model.h"
#include "model/crank_angle.h"
#include "text/result_row.h"

namespace ravnoves {

/// What CaseModel knows of the scene.
struct InertiaMomentsScene {
    using Input = inertia_moments::Input;
    using Solved = inertia_moments::Result;
    static Input defaultInput() { return inertia_moments::preset_vw_vr5(); }
    static QString defaultTitle() { return QStringLiteral("Volkswagen VR5"); }
    static Input read(const Json& input, const CaseContext& /*context*/) {
        return inertia_moments::read_input(input);
    }
    static constexpr auto write = &inertia_moments::write_input;
    static Solved solve(const Input& input) { return inertia_moments::solve(input); }
};

/// The state of the inertia-moments page: input, the solver's result, the crank angle of the
/// picture. What changes the input returns as edit().
///
/// A change costs one solve (some tens of microseconds), so every slider changes the input itself.
class InertiaMomentsModel : public CaseModel<InertiaMomentsScene> {
    Q_OBJECT

  public:
    explicit InertiaMomentsModel(QObject* parent = nullptr);

    QString sceneName() const override { return QStringLiteral("inertia-moments"); }
    Json resultJson() const override;
    /// Anything at its usual place follows another spacing or crank radius.
    QString editField(const std::string& pointer, const FieldValue& value,
                      const QString& name) override;
    bool setViewOption(const QString& key, const QString& value) override;

    const inertia_moments::Result& result() const { return solved(); }

    std::span<const PagePart> parts() const override;
    Content part(std::string_view id) const override;
    std::unique_ptr<SceneModel> another(bool /*runsJobs*/) const override {
        return std::make_unique<InertiaMomentsModel>();
    }

    // ---------------------------------------------------------------- layout

    /// What the list of layouts offers: "vw-vr5" (the paper's engine), "radial-3" to "radial-9"
    /// (with articulated rods), the library, "table".
    static QStringList layoutNames();
    /// A layout's name as text; "vr" with another number of cylinders has its own.
    QString layoutTitle(const QString& name) const;
    /// The entry of layoutNames() that the input is now; "vr" for a VR of another size.
    QString layoutName() const;
    void chooseLayout(const QString& name);
    /// Turns a layout into the table of its cylinders, which can then be edited one by one.
    void makeTable();
    /// Sets the crankpins of the table for even firing in its firing order.
    QString setEvenFiring();
    bool hasArticulatedRods() const;
    /// Hangs the rods of each crankpin on the rod of its first cylinder, with the usual knuckle
    /// radius, or returns them to their crankpins.
    QString setArticulatedRods(bool on);
    /// The input's editable table: its layout's, where it has one.
    std::vector<inertia_moments::Cylinder>& tableOf(Input& input) const;
    /// Something beside the input is rejected; with nothing, that is over.
    void showTrouble(const QString& why) { setRejection(why); }
    const std::vector<int>& firingOrder() const;
    /// "1-3-4-2" and the like.
    static QString orderText(const std::vector<int>& order);
    QString firingOrderText() const { return orderText(firingOrder()); }
    /// Why this cannot be the firing order; empty where it can. A table may have none.
    QString orderTrouble(const std::vector<int>& order) const;
    QString setFiringOrder(const std::vector<int>& order);

    // --------------------------------------------------------------- throws

    /// True where rods share a crankpin: the masses of a throw and of a cylinder differ.
    bool hasSharedPins() const;
    /// Gives the rotating mass for a throw or for a cylinder; the engine is unchanged.
    QString setRotatingMassOfThrow(bool ofThrow);
    /// "1.6 kg, rods: 2", from the lightest to the heaviest throw where they differ.
    QString throwMassText() const;

    // --------------------------------------------------- the sliders, in their units

    double bankAngleDeg() const;      ///< between the outermost banks
    bool canChangeBankAngle() const;  ///< in a layout of banks; a table is edited cell by cell
    bool canBeStaggered() const;      ///< in a layout whose banks share throws
    double offsetMm() const;          ///< of a table: the largest
    /// Offsets at which the mechanism does not lock, rounded inwards to 0.1 mm.
    std::pair<double, double> offsetLimitsMm() const;
    std::pair<double, double> referenceLimitsMm() const;

    /// λ or the rod's length (m) is given, the other one follows; with nothing it is the other way
    /// round.
    QString setRodRatio(std::optional<double> ratio);
    QString setRodLength(std::optional<double> length);

    // ---------------------------------------------------------------- shafts

    void addShaft();
    void removeShaft(int index);
    void setShaftEnabled(int index, bool enabled);
    /// "M₂ +2ω": order, task and direction in short.
    QString shaftTitle(const inertia_moments::Shaft& shaft) const;

    // ---------------------------------------------------------------- view

    /// True where the charts of the orders show forces, since no moment is left. A comparison shows
    /// the same of the other engine.
    bool showsForces() const;
    /// Force or moment of an order at the present crank angle; 0 where it is mere rounding.
    inertia_moments::Complex vectorNow(int order, bool force) const;
    void takeView(const SceneModel& other) override;
    CrankAngle* crank() { return &crank_; }

    // What the page's tables show: text in the user's locale.
    Results orderResults() const;
    Results rotatingResults() const;
    Results shaftResults() const;
    Results weightResults() const;
    Results remainingResults() const;
    Verdict verdict() const { return inertia_moments::verdict(input(), result()); }
    std::optional<Verdict> verdictShown() const override { return verdict(); }
    QString layoutText() const override;
    std::vector<const char*> designInputs() const override {
        return {"/crank_radius_mm", "/speed_rpm"};
    }

  private:
    CrankAngle crank_{40.0, 720.0};
    std::optional<bool> forces_;  ///< taken from another
};

extern template class CaseModel<InertiaMomentsScene>;

}  // namespace ravnoves
