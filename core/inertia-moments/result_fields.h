#pragma once

#include <array>

#include "case-file/result_visitor.h"

/// The values of the inertia moments' result: keys, units, decimals, names and tips.
namespace ravnoves::inertia_moments::result_field {

// ------------------------------------------------------------------------------- the whole
inline constexpr ResultField crankpin_angles{"crankpin_angle_deg", units::degree, 1,
                                             CORE_TEXT("inertia-moments", "Crankpin angle")};
inline constexpr ResultField tdc_angle{
    "tdc_angle_deg", units::degree, 2, CORE_TEXT("inertia-moments", "Crank angle at TDC"),
    CORE_TEXT("inertia-moments", "From the cylinder's axis, without sign.")};
inline constexpr ResultField cylinder_tdc_angles{
    "cylinder_tdc_angle_deg", units::degree, 2,
    CORE_TEXT("inertia-moments", "Crank angle at TDC of each cylinder")};
inline constexpr ResultField cylinder_strokes{"cylinder_stroke_mm", units::mm, 2,
                                              CORE_TEXT("inertia-moments", "Stroke")};
inline constexpr ResultField articulated_rods{"articulated_rods", units::none, 3,
                                              CORE_TEXT("inertia-moments", "Articulated rods")};
inline constexpr ResultField two_term{"two_term", units::none, 3,
                                      CORE_TEXT("inertia-moments", "Two-term")};
inline constexpr ResultField exact{"exact", units::none, 3, CORE_TEXT("inertia-moments", "Exact")};
inline constexpr ResultField rotating{"rotating", units::none, 3,
                                      CORE_TEXT("inertia-moments", "Rotating masses")};
inline constexpr ResultField throws{"throws", units::none, 3,
                                    CORE_TEXT("inertia-moments", "Crank throws")};
inline constexpr ResultField difference{
    "difference", units::none, 3, CORE_TEXT("inertia-moments", "Difference of the two-term form")};
inline constexpr ResultField firing{"firing", units::none, 3,
                                    CORE_TEXT("inertia-moments", "Firing order")};
inline constexpr ResultField firing_cycle{"firing_cycle_deg", units::degree, 0,
                                          CORE_TEXT("inertia-moments", "Firing cycle")};
inline constexpr ResultField fires_evenly{"fires_evenly", units::none, 0,
                                          CORE_TEXT("inertia-moments", "Even firing")};
inline constexpr ResultField firing_reason{"firing_reason"};
inline constexpr ResultField balance_shafts{"balance_shafts", units::none, 3,
                                            CORE_TEXT("inertia-moments", "Balance shafts")};
inline constexpr ResultField counterweights{"counterweights", units::none, 3,
                                            CORE_TEXT("inertia-moments", "Counterweights")};
inline constexpr ResultField unbalanced{
    "unbalanced", units::none, 3, CORE_TEXT("inertia-moments", "Before balancing"),
    CORE_TEXT("inertia-moments", "Exact orders with the rotating masses.")};
inline constexpr ResultField remaining{"remaining", units::none, 3,
                                       CORE_TEXT("inertia-moments", "Residual")};
inline constexpr ResultField curves{"curves", units::none, 3,
                                    CORE_TEXT("inertia-moments", "Curves")};
inline constexpr ResultField unbalanced_curves{
    "unbalanced_curves", units::none, 3, CORE_TEXT("inertia-moments", "Curves before balancing")};
inline constexpr ResultField remaining_curves{"remaining_curves", units::none, 3,
                                              CORE_TEXT("inertia-moments", "Residual curves")};

// ---------------------------------------------------------------------------------- orders
/// [k − 1] is order k.
inline constexpr std::array<ResultField, 12> orders{
    {{"order_1", units::none, 3, CORE_TEXT("inertia-moments", "order 1")},
     {"order_2", units::none, 3, CORE_TEXT("inertia-moments", "order 2")},
     {"order_3", units::none, 3, CORE_TEXT("inertia-moments", "order 3")},
     {"order_4", units::none, 3, CORE_TEXT("inertia-moments", "order 4")},
     {"order_5", units::none, 3, CORE_TEXT("inertia-moments", "order 5")},
     {"order_6", units::none, 3, CORE_TEXT("inertia-moments", "order 6")},
     {"order_7", units::none, 3, CORE_TEXT("inertia-moments", "order 7")},
     {"order_8", units::none, 3, CORE_TEXT("inertia-moments", "order 8")},
     {"order_9", units::none, 3, CORE_TEXT("inertia-moments", "order 9")},
     {"order_10", units::none, 3, CORE_TEXT("inertia-moments", "order 10")},
     {"order_11", units::none, 3, CORE_TEXT("inertia-moments", "order 11")},
     {"order_12", units::none, 3, CORE_TEXT("inertia-moments", "order 12")}}};
inline constexpr ResultField order_force{"force_N", units::newton, 1,
                                         CORE_TEXT("inertia-moments", "force")};
inline constexpr ResultField order_moment{"moment_Nm", units::N_m, 2,
                                          CORE_TEXT("inertia-moments", "moment")};
inline constexpr ResultField roll_moment{"roll_moment_Nm", units::N_m, 2,
                                         CORE_TEXT("inertia-moments", "roll moment")};
inline constexpr ResultField horizontal{"horizontal", units::none, 3,
                                        CORE_TEXT("inertia-moments", "horizontal")};
inline constexpr ResultField vertical{"vertical", units::none, 3,
                                      CORE_TEXT("inertia-moments", "vertical")};
inline constexpr ResultField forward{"forward", units::none, 3,
                                     CORE_TEXT("inertia-moments", "forward")};
inline constexpr ResultField backward{"backward", units::none, 3,
                                      CORE_TEXT("inertia-moments", "backward")};
inline constexpr ResultField inertia{"inertia", units::none, 3,
                                     CORE_TEXT("inertia-moments", "from offsets and rods")};
inline constexpr ResultField reaction_torque{"reaction_torque", units::none, 3,
                                             CORE_TEXT("inertia-moments", "reaction torque")};
inline constexpr ResultField total{"total", units::none, 3, CORE_TEXT("inertia-moments", "sum")};
// In the unit of the object around them: N or N·m.
inline constexpr ResultField cosine{"cos", units::none, 2, CORE_TEXT("inertia-moments", "cosine")};
inline constexpr ResultField sine{"sin", units::none, 2, CORE_TEXT("inertia-moments", "sine")};
inline constexpr ResultField amplitude{"amplitude", units::none, 2,
                                       CORE_TEXT("inertia-moments", "amplitude")};
inline constexpr ResultField angle{"angle_deg", units::degree, 1,
                                   CORE_TEXT("inertia-moments", "angle")};
inline constexpr ResultField force_horizontal_percent{"horizontal_percent", units::percent, 1,
                                                      CORE_TEXT("inertia-moments", "horizontal")};
inline constexpr ResultField force_vertical_percent{"vertical_percent", units::percent, 1,
                                                    CORE_TEXT("inertia-moments", "vertical")};
inline constexpr ResultField difference_force{"force", units::none, 3,
                                              CORE_TEXT("inertia-moments", "force")};
inline constexpr ResultField difference_moment{"moment", units::none, 3,
                                               CORE_TEXT("inertia-moments", "moment")};
inline constexpr ResultField roll_moment_percent{"roll_moment_percent", units::percent, 1,
                                                 CORE_TEXT("inertia-moments", "roll moment")};
inline constexpr ResultField warnings{"warnings"};

// ---------------------------------------------------------------------------- rotating masses
inline constexpr ResultField force_factor{"force_factor", units::none, 3,
                                          CORE_TEXT("inertia-moments", "force factor")};
inline constexpr ResultField force_angle{"force_angle_deg", units::degree, 1,
                                         CORE_TEXT("inertia-moments", "angle of the force")};
inline constexpr ResultField moment_factor{
    "moment_factor_m", units::metre, 4, CORE_TEXT("inertia-moments", "moment factor"),
    CORE_TEXT("inertia-moments", "About the mean axial position of the crankpins.")};
inline constexpr ResultField moment_angle{"moment_angle_deg", units::degree, 1,
                                          CORE_TEXT("inertia-moments", "angle of the moment")};
inline constexpr ResultField rotating_force{"force_N", units::newton, 1,
                                            CORE_TEXT("inertia-moments", "force")};
inline constexpr ResultField rotating_moment{
    "moment_Nm", units::N_m, 2, CORE_TEXT("inertia-moments", "moment"),
    CORE_TEXT("inertia-moments", "About the mean axial position of the crankpins.")};
inline constexpr ResultField force_lag{
    "counterweight_force_lag_deg", units::degree, 1,
    CORE_TEXT("inertia-moments", "lag of the counterweight against the force")};
inline constexpr ResultField moment_lag{
    "counterweight_moment_lag_deg", units::degree, 1,
    CORE_TEXT("inertia-moments", "lag of the counterweights against the moment")};

// -------------------------------------------------------------------------- throws and rods
inline constexpr ResultField cylinders{"cylinders"};
inline constexpr ResultField axial_position{"axial_position_mm", units::mm, 1,
                                            CORE_TEXT("inertia-moments", "axial position")};
inline constexpr ResultField crankpin_angle{"crankpin_angle_deg", units::degree, 1,
                                            CORE_TEXT("inertia-moments", "crankpin angle")};
inline constexpr ResultField rotating_mass{"rotating_mass_kg", units::kg, 3,
                                           CORE_TEXT("inertia-moments", "rotating mass")};
inline constexpr ResultField cylinder{"cylinder", units::none, 0,
                                      CORE_TEXT("inertia-moments", "cylinder")};
inline constexpr ResultField master{"master", units::none, 0,
                                    CORE_TEXT("inertia-moments", "master cylinder")};
inline constexpr ResultField knuckle_radius{"knuckle_radius_mm", units::mm, 2,
                                            CORE_TEXT("inertia-moments", "knuckle radius")};
inline constexpr ResultField knuckle_angle{"knuckle_angle_deg", units::degree, 2,
                                           CORE_TEXT("inertia-moments", "knuckle angle")};
inline constexpr ResultField rod_length{"rod_length_mm", units::mm, 2,
                                        CORE_TEXT("inertia-moments", "rod length")};
inline constexpr ResultField crank_angle{"crank_angle_deg", units::degree, 1,
                                         CORE_TEXT("inertia-moments", "crank angle")};
inline constexpr ResultField interval{"interval_deg", units::degree, 1,
                                      CORE_TEXT("inertia-moments", "firing interval")};

// -------------------------------------------------------------------- shafts, counterweights
inline constexpr ResultField order{"order", units::none, 0, CORE_TEXT("inertia-moments", "order")};
inline constexpr ResultField direction{"direction"};
inline constexpr ResultField balances{"balances"};
inline constexpr ResultField unbalance{"unbalance_kg_m", units::kg_m, 5,
                                       CORE_TEXT("inertia-moments", "unbalance")};
inline constexpr ResultField mass{"mass_kg", units::kg, 3, CORE_TEXT("inertia-moments", "mass")};
inline constexpr ResultField phase{"phase_deg", units::degree, 1,
                                   CORE_TEXT("inertia-moments", "phase")};
inline constexpr ResultField cancels_force{"cancels_N", units::newton, 1,
                                           CORE_TEXT("inertia-moments", "cancels")};
inline constexpr ResultField cancels_moment{"cancels_Nm", units::N_m, 2,
                                            CORE_TEXT("inertia-moments", "cancels")};
inline constexpr ResultField before_force{"order_max_before_N", units::newton, 1,
                                          CORE_TEXT("inertia-moments", "maximum before")};
inline constexpr ResultField before_moment{"order_max_before_Nm", units::N_m, 2,
                                           CORE_TEXT("inertia-moments", "maximum before")};
inline constexpr ResultField remaining_force{"order_max_remaining_N", units::newton, 1,
                                             CORE_TEXT("inertia-moments", "maximum after")};
inline constexpr ResultField remaining_moment{"order_max_remaining_Nm", units::N_m, 2,
                                              CORE_TEXT("inertia-moments", "maximum after")};
inline constexpr ResultField front{"front", units::none, 3, CORE_TEXT("inertia-moments", "front")};
inline constexpr ResultField rear{"rear", units::none, 3, CORE_TEXT("inertia-moments", "rear")};
inline constexpr ResultField lag{"lag_deg", units::degree, 1, CORE_TEXT("inertia-moments", "lag")};
inline constexpr ResultField force_unbalance{
    "force_unbalance_kg_m", units::kg_m, 5,
    CORE_TEXT("inertia-moments", "unbalance against the force")};
inline constexpr ResultField moment_unbalance{
    "moment_unbalance_kg_m", units::kg_m, 5,
    CORE_TEXT("inertia-moments", "unbalance against the moment")};

// ---------------------------------------------------------------------------------- curves
inline constexpr ResultField force_x{"force_x_N", units::newton, 1,
                                     CORE_TEXT("inertia-moments", "horizontal force")};
inline constexpr ResultField force_y{"force_y_N", units::newton, 1,
                                     CORE_TEXT("inertia-moments", "vertical force")};
inline constexpr ResultField moment_x{"moment_x_Nm", units::N_m, 2,
                                      CORE_TEXT("inertia-moments", "moment about x")};
inline constexpr ResultField moment_y{"moment_y_Nm", units::N_m, 2,
                                      CORE_TEXT("inertia-moments", "moment about y")};
inline constexpr ResultField inertia_roll{
    "inertia_roll_Nm", units::N_m, 2,
    CORE_TEXT("inertia-moments", "roll moment from offsets and rods")};
inline constexpr ResultField reaction{"reaction_torque_Nm", units::N_m, 2,
                                      CORE_TEXT("inertia-moments", "reaction torque")};
inline constexpr ResultField roll{"roll_moment_Nm", units::N_m, 2,
                                  CORE_TEXT("inertia-moments", "roll moment")};

}  // namespace ravnoves::inertia_moments::result_field
