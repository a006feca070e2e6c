#include "studies/model/result_words.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>
#include <QStringList>
#include <array>
#include <utility>

#include "text/key_words.h"
#include "text/number_text.h"

namespace ravnoves {

namespace {

struct ResultWords {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ResultWords)

  public:
    /// Keys of results as a person says them, where they are no keys of inputs that say the same;
    /// an empty one is left out.
    static constexpr std::pair<const char*, const char*> all[]{
        {"metrics", ""},
        {"M_s", QT_TR_NOOP("Mₛ")},
        {"M_up", QT_TR_NOOP("Mᵤₚ")},
        {"M_ups", QT_TR_NOOP("Mᵤₚₛ")},
        {"M_s_25_nodes", QT_TR_NOOP("Mₛ, 25 nodes")},
        {"M_up_nodes", QT_TR_NOOP("Mᵤₚ, nodes")},
        {"M_ups_nodes", QT_TR_NOOP("Mᵤₚₛ, nodes")},
        {"across", QT_TR_NOOP("across the shaft")},
        {"across_cylinder", QT_TR_NOOP("across the cylinder")},
        {"along_cylinder", QT_TR_NOOP("along the cylinder")},
        {"amplification", QT_TR_NOOP("amplification of errors")},
        {"amplitude", QT_TR_NOOP("amplitude")},
        {"angular_speed", QT_TR_NOOP("angular speed ω")},
        {"at_crank_angle", QT_TR_NOOP("at φ")},
        {"backward", QT_TR_NOOP("backward")},
        {"balancing_weight", QT_TR_NOOP("balancing weight")},
        {"before", QT_TR_NOOP("before")},
        {"best_position", QT_TR_NOOP("best place")},
        {"best_position_buildable", QT_TR_NOOP("best place that can be built")},
        {"bobweight", QT_TR_NOOP("bob weight")},
        {"bobweight_with_plugs_in", QT_TR_NOOP("bob weight with plugs in")},
        {"bobweights", QT_TR_NOOP("bob weights")},
        {"centre_distance", QT_TR_NOOP("centre distance l")},
        {"change_without_shaft", QT_TR_NOOP("change against no shaft")},
        {"clearances", QT_TR_NOOP("clearance")},
        {"compressed", QT_TR_NOOP("spring compressed")},
        {"constant", QT_TR_NOOP("constant")},
        {"cos", QT_TR_NOOP("cosine")},
        {"counterweight_force", QT_TR_NOOP("force of the counterweights")},
        {"counterweight_force_lag", QT_TR_NOOP("lag of the counterweights' force")},
        {"counterweight_lag", QT_TR_NOOP("lag of the counterweight")},
        {"counterweight_mass", QT_TR_NOOP("mass of the counterweight")},
        {"counterweight_moment", QT_TR_NOOP("moment of the counterweight")},
        {"counterweight_moment_lag", QT_TR_NOOP("lag of the counterweights' moment")},
        {"counterweight_weight", QT_TR_NOOP("weight of the counterweight")},
        {"crank", QT_TR_NOOP("crank")},
        {"crank_only", QT_TR_NOOP("without a shaft")},
        {"crank_swing_radius", QT_TR_NOOP("swing radius of the crank")},
        {"cylinder", QT_TR_NOOP("cylinder")},
        {"cylinder_bore", QT_TR_NOOP("bore of the cylinder")},
        {"cylinder_bottom", QT_TR_NOOP("bottom of the cylinder")},
        {"cylinder_top", QT_TR_NOOP("top of the cylinder")},
        {"cylinder_wall", QT_TR_NOOP("wall of the cylinder")},
        {"dead_centre", QT_TR_NOOP("dead centre")},
        {"difference", QT_TR_NOOP("difference of the two-term formulas")},
        {"energy", QT_TR_NOOP("energy")},
        {"entered_m_r2_w2", QT_TR_NOOP("m r² ω² entered")},
        {"exact", QT_TR_NOOP("exact")},
        {"excess_work", QT_TR_NOOP("excess work")},
        {"firing_cycle", QT_TR_NOOP("cycle of the firing")},
        {"first_order", QT_TR_NOOP("first order")},
        {"fitted_lambda", QT_TR_NOOP("λ fitted")},
        {"fitted_m_r2_w2", QT_TR_NOOP("m r² ω² fitted")},
        {"force", QT_TR_NOOP("force")},
        {"force_angle", QT_TR_NOOP("angle of the force")},
        {"force_factor", QT_TR_NOOP("factor of the force")},
        {"forward", QT_TR_NOOP("forward")},
        {"front_gap", QT_TR_NOOP("gap in front")},
        {"gap", QT_TR_NOOP("clearance")},
        {"gear_error", QT_TR_NOOP("gears")},
        {"gear_tip_radius", QT_TR_NOOP("tip radius of the gear")},
        {"guide", QT_TR_NOOP("crank guide")},
        {"guide_beside_rod_hinge", QT_TR_NOOP("crank guide beside the rod hinge")},
        {"height", QT_TR_NOOP("height")},
        {"horizontal", QT_TR_NOOP("horizontal")},
        {"inertia", QT_TR_NOOP("of offsets and rods")},
        {"inertia_check", QT_TR_NOOP("check of the inertia torque")},
        {"inertia_force_1_max", QT_TR_NOOP("inertia force Pⱼ₁, max")},
        {"k_p", QT_TR_NOOP("kₚ")},
        {"k_y", QT_TR_NOOP("kᵧ")},
        {"k_y_new", QT_TR_NOOP("kᵧ, new crankshaft")},
        {"largest", QT_TR_NOOP("largest")},
        {"largest_by_newton_euler", QT_TR_NOOP("largest, by Newton and Euler")},
        {"largest_cos_psi_error", QT_TR_NOOP("largest error of cos ψ")},
        {"largest_moment", QT_TR_NOOP("largest moment")},
        {"largest_rod_hinge_moment_error", QT_TR_NOOP("largest error of the rod hinge's moment")},
        {"largest_roller_radius", QT_TR_NOOP("largest radius of a roller")},
        {"largest_spring_force", QT_TR_NOOP("largest force of the spring")},
        {"largest_with_hinge", QT_TR_NOOP("largest with the hinge")},
        {"largest_without_hinge", QT_TR_NOOP("largest without the hinge")},
        {"least_allowed", QT_TR_NOOP("least allowed")},
        {"mass_changes", QT_TR_NOOP("change of mass")},
        {"matching_mass", QT_TR_NOOP("mass that fits")},
        {"matching_speed", QT_TR_NOOP("speed that fits")},
        {"max", QT_TR_NOOP("max")},
        {"max_crank_angle", QT_TR_NOOP("φ of the max")},
        {"max_energy", QT_TR_NOOP("largest energy")},
        {"max_pressure_angle", QT_TR_NOOP("largest pressure angle")},
        {"max_radius", QT_TR_NOOP("largest ρ")},
        {"maximum", QT_TR_NOOP("most")},
        {"mean", QT_TR_NOOP("mean")},
        {"min", QT_TR_NOOP("min")},
        {"min_crank_angle", QT_TR_NOOP("φ of the min")},
        {"min_energy", QT_TR_NOOP("least energy")},
        {"min_radius", QT_TR_NOOP("least ρ")},
        {"minimum_preload", QT_TR_NOOP("least preload")},
        {"minimum_stiffness", QT_TR_NOOP("least stiffness")},
        {"moment", QT_TR_NOOP("moment")},
        {"moment_amplitude", QT_TR_NOOP("amplitude of Mₛ")},
        {"moment_angle", QT_TR_NOOP("angle of the moment")},
        {"moment_factor", QT_TR_NOOP("factor of the moment")},
        {"new-steel-machined", QT_TR_NOOP("new crankshaft, its own plugs")},
        {"new-steel-to-aluminium", QT_TR_NOOP("new crankshaft, aluminium plugs")},
        {"new-steel-to-steel", QT_TR_NOOP("new crankshaft, today's steel plugs")},
        {"nominal_bobweight", QT_TR_NOOP("nominal bob weight")},
        {"optimum", QT_TR_NOOP("best α")},
        {"optimum_buildable", QT_TR_NOOP("best α that can be built")},
        {"options", ""},
        {"permissible_rotor", QT_TR_NOOP("permissible for a rotor")},
        {"phase", QT_TR_NOOP("phase")},
        {"phase_error", QT_TR_NOOP("error of phase")},
        {"play", QT_TR_NOOP("play")},
        {"play_force", QT_TR_NOOP("force by the play")},
        {"play_range_high", QT_TR_NOOP("largest range by the play")},
        {"play_range_low", QT_TR_NOOP("least range by the play")},
        {"plug_mass", QT_TR_NOOP("mass of a plug")},
        {"preload", QT_TR_NOOP("preload")},
        {"printed_mean", QT_TR_NOOP("mean as the paper has it")},
        {"profile_error", QT_TR_NOOP("error of the guide")},
        {"profile_max_radius", QT_TR_NOOP("largest radius of the profile")},
        {"profile_min_radius", QT_TR_NOOP("least radius of the profile")},
        {"range", QT_TR_NOOP("range")},
        {"reaction_torque", QT_TR_NOOP("reaction torque")},
        {"read_with_bobweight", QT_TR_NOOP("bob weight at the readings")},
        {"reciprocating", QT_TR_NOOP("reciprocating")},
        {"reduction", QT_TR_NOOP("lightening of a plug")},
        {"reduction_factor", QT_TR_NOOP("times less")},
        {"relative_torque", QT_TR_NOOP("relative torque")},
        {"relief", QT_TR_NOOP("relief")},
        {"remaining", QT_TR_NOOP("left")},
        {"repair_bearing", QT_TR_NOOP("repair shells")},
        {"repair_piston_and_rings", QT_TR_NOOP("repair piston and rings")},
        {"required_reduction", QT_TR_NOOP("lightening needed")},
        {"residual_force", QT_TR_NOOP("force left")},
        {"residual_mass", QT_TR_NOOP("mass left")},
        {"residual_rms", QT_TR_NOOP("RMS left")},
        {"residual_unbalance", QT_TR_NOOP("unbalance left")},
        {"rms", QT_TR_NOOP("RMS")},
        {"rod_big_end", QT_TR_NOOP("rod, big end")},
        {"rod_hinge_guide", QT_TR_NOOP("guide of the rod hinge")},
        {"rod_hinge_moment_integral", QT_TR_NOOP("integral of the rod hinge's moment")},
        {"rod_width", QT_TR_NOOP("width of the rod")},
        {"roll_moment", QT_TR_NOOP("roll moment")},
        {"rotating", QT_TR_NOOP("rotating masses")},
        {"second_order", QT_TR_NOOP("second order")},
        {"series", QT_TR_NOOP("series against exact")},
        {"shaft_angle", QT_TR_NOOP("α")},
        {"shaft_swing_radius", QT_TR_NOOP("swing radius of the shaft")},
        {"share", QT_TR_NOOP("share")},
        {"share_of_variance", QT_TR_NOOP("share of the variance")},
        {"shift_effect", QT_TR_NOOP("with the shifted rod")},
        {"side_force", QT_TR_NOOP("side force")},
        {"sin", QT_TR_NOOP("sine")},
        {"slope", QT_TR_NOOP("slope")},
        {"slope_angle", QT_TR_NOOP("angle of the slope")},
        {"smallest_curvature_radius", QT_TR_NOOP("least radius of curvature")},
        {"smallest_spring_force", QT_TR_NOOP("least force of the spring")},
        {"spring_travel", QT_TR_NOOP("travel of the spring")},
        {"steel-machined", QT_TR_NOOP("today's steel plugs machined")},
        {"steel-to-aluminium", QT_TR_NOOP("aluminium plugs")},
        {"step", QT_TR_NOOP("step of the curves")},
        {"stretched", QT_TR_NOOP("spring stretched")},
        {"sum", QT_TR_NOOP("sum")},
        {"tdc_angle", QT_TR_NOOP("φ at TDC")},
        {"theory", QT_TR_NOOP("theory")},
        {"total", QT_TR_NOOP("sum")},
        {"two_term", QT_TR_NOOP("two-term")},
        {"unbalanced_mass", QT_TR_NOOP("unbalanced mass")},
        {"upright", QT_TR_NOOP("along the crank")},
        {"vertical", QT_TR_NOOP("vertical")},
        {"waves", QT_TR_NOOP("waves")},
        {"width", QT_TR_NOOP("width")},
        {"with_shaft", QT_TR_NOOP("with the shaft")},
        {"worst_crank_angle", QT_TR_NOOP("φ of the largest")},
    };
};

QString wordOf(const QString& key) {
    static const QHash<QString, const char*> known = [] {
        QHash<QString, const char*> all;
        for (const auto& [name, text] : ResultWords::all) {
            all.insert(QString::fromLatin1(name), text);
        }
        return all;
    }();
    static const QRegularExpression order(QStringLiteral("^order_(\\d+)$"));
    if (const auto match = order.match(key); match.hasMatch()) {
        return ResultWords::tr("order %1").arg(match.captured(1));
    }
    if (const auto found = known.constFind(key); found != known.constEnd()) {
        return **found == '\0' ? QString() : ResultWords::tr(*found);
    }
    bool isPlace = false;
    if (const int place = key.toInt(&isPlace); isPlace) {
        return QString::number(place + 1);  // of a list, from 1
    }
    // M_x stays; other keys are words.
    const bool isSymbol = key.size() > 1 && key.at(1) == QLatin1Char('_');
    const QString name = QString(key).replace(QStringLiteral("~1"), QStringLiteral("/"));
    return isSymbol ? name : keyInWords(name.toStdString());
}

}  // namespace

ResultName resultName(const std::string& pointer) {
    ResultName name;
    QStringList parts;
    for (QString key :
         QString::fromStdString(pointer).split(QLatin1Char('/'), Qt::SkipEmptyParts)) {
        if (const Unit unit = takeUnit(key); unit != units::none) {
            name.unit = unitText(unit.name);  // that of the last key that has one
        }
        const QString word = wordOf(key);
        if (!word.isEmpty() && (parts.isEmpty() || parts.last() != word)) {
            parts << word;
        }
    }
    name.text = parts.join(QStringLiteral(", "));
    return name;
}

}  // namespace ravnoves
