#include "studies/model/result_words.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>
#include <QStringList>
#include <array>
#include <utility>

#include "text/number_text.h"

namespace ravnoves {

namespace {

/// Keys of results as a person says them; an empty one is left out.
constexpr std::pair<const char*, const char*> words[]{
    {"metrics", ""},
    {"M_s", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "Mₛ")},
    {"M_up", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "Mᵤₚ")},
    {"M_ups", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "Mᵤₚₛ")},
    {"M_s_25_nodes", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "Mₛ, 25 nodes")},
    {"M_up_nodes", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "Mᵤₚ, nodes")},
    {"M_ups_nodes", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "Mᵤₚₛ, nodes")},
    {"across", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "across the shaft")},
    {"across_cylinder", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "across the cylinder")},
    {"along_cylinder", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "along the cylinder")},
    {"amplification", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "amplification of errors")},
    {"amplitude", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "amplitude")},
    {"angle", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "angle")},
    {"angular_speed", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "angular speed ω")},
    {"at_crank_angle", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "at φ")},
    {"backward", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "backward")},
    {"balancing_weight", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "balancing weight")},
    {"before", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "before")},
    {"best_position", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "best place")},
    {"best_position_buildable",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "best place that can be built")},
    {"bobweight", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "bob weight")},
    {"bobweight_with_plugs_in",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "bob weight with plugs in")},
    {"bobweights", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "bob weights")},
    {"centre_distance", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "centre distance l")},
    {"change_without_shaft",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "change without the shaft")},
    {"clearances", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "clearance")},
    {"compressed", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "spring compressed")},
    {"constant", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "constant")},
    {"correction", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "correction")},
    {"cos", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "cosine")},
    {"counterweight_force",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "force of the counterweights")},
    {"counterweight_force_lag",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "lag of the counterweights' force")},
    {"counterweight_lag", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "lag of the counterweight")},
    {"counterweight_mass", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "mass of the counterweight")},
    {"counterweight_moment",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "moment of the counterweight")},
    {"counterweight_moment_lag",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "lag of the counterweights' moment")},
    {"counterweight_weight",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "weight of the counterweight")},
    {"crank", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "crank")},
    {"crank_only", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "without a shaft")},
    {"crank_swing_radius", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "swing radius of the crank")},
    {"cylinder", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "cylinder")},
    {"cylinder_bore", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "bore of the cylinder")},
    {"cylinder_bottom", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "bottom of the cylinder")},
    {"cylinder_top", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "top of the cylinder")},
    {"cylinder_wall", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "wall of the cylinder")},
    {"cylinders", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "cylinders")},
    {"dead_centre", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "dead centre")},
    {"difference",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "difference of the two-term formulas")},
    {"energy", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "energy")},
    {"entered_m_r2_w2", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "m r² ω² entered")},
    {"envelope", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "envelope")},
    {"exact", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "exact")},
    {"excess_work", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "excess work")},
    {"firing_cycle", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "cycle of the firing")},
    {"first_order", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "first order")},
    {"fitted_lambda", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "λ fitted")},
    {"fitted_m_r2_w2", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "m r² ω² fitted")},
    {"flywheel", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "flywheel")},
    {"force", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "force")},
    {"force_angle", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "angle of the force")},
    {"force_factor", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "factor of the force")},
    {"forward", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "forward")},
    {"front_gap", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "gap in front")},
    {"gap", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "clearance")},
    {"gear_error", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "gears")},
    {"gear_tip_radius", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "tip radius of the gear")},
    {"guide", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "crank guide")},
    {"guide_beside_rod_hinge",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "crank guide beside the rod hinge")},
    {"height", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "height")},
    {"horizontal", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "horizontal")},
    {"inertia", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "of offsets and rods")},
    {"inertia_check", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "check of the inertia torque")},
    {"inertia_force_1_max", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "inertia force Pⱼ₁, max")},
    {"k_p", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "kₚ")},
    {"k_y", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "kᵧ")},
    {"k_y_new", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "kᵧ, new crankshaft")},
    {"largest", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest")},
    {"largest_by_newton_euler",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest, by Newton and Euler")},
    {"largest_cos_psi_error", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest error of cos ψ")},
    {"largest_moment", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest moment")},
    {"largest_rod_hinge_moment_error",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest error of the rod hinge's moment")},
    {"largest_roller_radius",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest radius of a roller")},
    {"largest_spring_force",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest force of the spring")},
    {"largest_with_hinge", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest with the hinge")},
    {"largest_without_hinge",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest without the hinge")},
    {"least_allowed", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "least allowed")},
    {"mass_changes", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "change of mass")},
    {"matching_mass", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "mass that fits")},
    {"matching_speed", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "speed that fits")},
    {"max", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "max")},
    {"max_crank_angle", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "φ of the max")},
    {"max_energy", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest energy")},
    {"max_pressure_angle", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest pressure angle")},
    {"max_radius", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest ρ")},
    {"maximum", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "most")},
    {"mean", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "mean")},
    {"min", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "min")},
    {"min_crank_angle", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "φ of the min")},
    {"min_energy", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "least energy")},
    {"min_radius", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "least ρ")},
    {"minimum_preload", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "least preload")},
    {"minimum_stiffness", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "least stiffness")},
    {"moment", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "moment")},
    {"moment_amplitude", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "amplitude of Mₛ")},
    {"moment_angle", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "angle of the moment")},
    {"moment_factor", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "factor of the moment")},
    {"new-steel-machined",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "new crankshaft, its own plugs")},
    {"new-steel-to-aluminium",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "new crankshaft, aluminium plugs")},
    {"new-steel-to-steel",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "new crankshaft, today's steel plugs")},
    {"nominal", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "nominal")},
    {"nominal_bobweight", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "nominal bob weight")},
    {"optimum", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "best α")},
    {"optimum_buildable", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "best α that can be built")},
    {"options", ""},
    {"permissible_rotor", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "permissible for a rotor")},
    {"phase", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "phase")},
    {"phase_error", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "error of phase")},
    {"piston", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "piston")},
    {"play", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "play")},
    {"play_force", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "force by the play")},
    {"play_range_high", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest range by the play")},
    {"play_range_low", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "least range by the play")},
    {"plug_mass", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "mass of a plug")},
    {"preload", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "preload")},
    {"printed_mean", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "mean as the paper has it")},
    {"profile_error", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "error of the guide")},
    {"profile_max_radius",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "largest radius of the profile")},
    {"profile_min_radius",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "least radius of the profile")},
    {"range", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "range")},
    {"reaction_torque", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "reaction torque")},
    {"read_with_bobweight",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "bob weight at the readings")},
    {"reciprocating", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "reciprocating")},
    {"reciprocating_mass", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "reciprocating mass")},
    {"reduction", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "lightening of a plug")},
    {"reduction_factor", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "times less")},
    {"relative_torque", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "relative torque")},
    {"relief", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "relief")},
    {"remaining", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "left")},
    {"repair_bearing", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "repair shells")},
    {"repair_piston_and_rings",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "repair piston and rings")},
    {"required_reduction", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "lightening needed")},
    {"residual_force", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "force left")},
    {"residual_mass", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "mass left")},
    {"residual_rms", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "RMS left")},
    {"residual_unbalance", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "unbalance left")},
    {"rms", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "RMS")},
    {"rod", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "rod")},
    {"rod_big_end", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "rod, big end")},
    {"rod_hinge_guide", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "guide of the rod hinge")},
    {"rod_hinge_moment_integral",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "integral of the rod hinge's moment")},
    {"rod_width", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "width of the rod")},
    {"roll_moment", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "roll moment")},
    {"rotating", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "rotating masses")},
    {"second_order", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "second order")},
    {"series", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "series against exact")},
    {"shaft_angle", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "α")},
    {"shaft_swing_radius", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "swing radius of the shaft")},
    {"share", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "share")},
    {"share_of_variance", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "share of the variance")},
    {"shift_effect", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "with the shifted rod")},
    {"side_force", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "side force")},
    {"sin", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "sine")},
    {"slope", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "slope")},
    {"slope_angle", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "angle of the slope")},
    {"smallest_curvature_radius",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "least radius of curvature")},
    {"smallest_spring_force",
     QT_TRANSLATE_NOOP("ravnoves::ResultWords", "least force of the spring")},
    {"spring_travel", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "travel of the spring")},
    {"steel-machined", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "today's steel plugs machined")},
    {"steel-to-aluminium", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "aluminium plugs")},
    {"step", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "step of the curves")},
    {"stretched", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "spring stretched")},
    {"sum", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "sum")},
    {"tdc_angle", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "φ at TDC")},
    {"theory", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "theory")},
    {"torque", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "torque")},
    {"total", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "sum")},
    {"two_term", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "two-term")},
    {"unbalance", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "unbalance")},
    {"unbalanced_mass", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "unbalanced mass")},
    {"upright", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "along the crank")},
    {"vertical", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "vertical")},
    {"waves", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "waves")},
    {"width", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "width")},
    {"with_shaft", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "with the shaft")},
    {"worst_crank_angle", QT_TRANSLATE_NOOP("ravnoves::ResultWords", "φ of the largest")},
};

/// How keys end, and the units that this means; the longer ones first.
constexpr std::pair<const char*, const char*> suffixes[]{
    {"_N_m", "N/m"},   {"_Nm", "N·m"},    {"_g_mm", "g·mm"},   {"_kg_m2", "kg·m²"},
    {"_kg_m", "kg·m"}, {"_mm_s", "mm/s"}, {"_rad_s", "rad/s"}, {"_kg", "kg"},
    {"_mm", "mm"},     {"_deg", "°"},     {"_rpm", "min⁻¹"},   {"_MPa", "MPa"},
    {"_cm2", "cm²"},   {"_um", "µm"},     {"_g", "g"},         {"_N", "N"},
    {"_J", "J"},       {"_percent", "%"}, {"_m", "m"}};

QString said(const char* text) {
    return QCoreApplication::translate("ravnoves::ResultWords", text);
}

QString wordOf(const QString& key) {
    static const QHash<QString, const char*> known = [] {
        QHash<QString, const char*> all;
        for (const auto& [name, text] : words) {
            all.insert(QString::fromLatin1(name), text);
        }
        return all;
    }();
    static const QRegularExpression order(QStringLiteral("^order_(\\d+)$"));
    if (const auto match = order.match(key); match.hasMatch()) {
        return said(QT_TRANSLATE_NOOP("ravnoves::ResultWords", "order %1")).arg(match.captured(1));
    }
    if (const auto found = known.constFind(key); found != known.constEnd()) {
        return **found == '\0' ? QString() : said(*found);
    }
    bool isPlace = false;
    if (const int place = key.toInt(&isPlace); isPlace) {
        return QString::number(place + 1);  // of a list, from 1
    }
    // M_x stays; other keys are words.
    const bool isSymbol = key.size() > 1 && key.at(1) == QLatin1Char('_');
    QString name = QString(key).replace(QStringLiteral("~1"), QStringLiteral("/"));
    return isSymbol ? name : name.replace(QLatin1Char('_'), QLatin1Char(' '));
}

}  // namespace

ResultName resultName(const std::string& pointer) {
    ResultName name;
    QStringList parts;
    for (QString key :
         QString::fromStdString(pointer).split(QLatin1Char('/'), Qt::SkipEmptyParts)) {
        for (const auto& [suffix, unit] : suffixes) {
            if (key.endsWith(QLatin1String(suffix)) && key.size() > qsizetype(qstrlen(suffix))) {
                key.chop(static_cast<qsizetype>(qstrlen(suffix)));
                name.unit = unitText(unit);  // that of the last key that has one
                break;
            }
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
