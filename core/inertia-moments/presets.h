#pragma once

#include <array>
#include <utility>
#include <vector>

#include "case-file/preset.h"
#include "inertia-moments/input.h"

namespace ravnoves::inertia_moments {

/// The Volkswagen VR5 of the paper: γ 15°, e 12.5 mm (K = 0.278 as printed), λ 0.265, R 45 mm,
/// m_j 0.622 kg, a 63 mm, 6200 min⁻¹, order 1-2-4-5-3, the centre of mass 15.8 mm from crankpin 4.
/// The rotating mass (0.8 kg) and the places of the counterweights are not in the paper; the four
/// shafts of its Figs. 7 and 8 are there, switched off.
Input preset_vw_vr5();

/// The numbers of cylinders of the radials below.
inline constexpr std::array radial_counts{3, 5, 7, 9};

/// A radial with articulated rods hung on the rod of cylinder 1, λ 0.25, firing every other
/// cylinder (1-3-5-7-9-2-4-6-8). Sizes and masses are usual ones of such engines; nine cylinders
/// have the size of many aircraft engines (stroke 174.6 mm, knuckle pins 67 mm from the crankpin).
/// Its end webs balance the rotating masses and the first order; one shaft each way of the second
/// order is included, switched off.
/// @param cylinders  one of radial_counts
Input preset_radial(int cylinders);
/// The cylinders of that radial, its knuckles scaled to the crank of this engine, which keeps its
/// crank radius, λ, speed and masses.
void make_radial(Input& input, int cylinders);

/// The engine of the paper and the radials.
std::vector<Preset<Input>> presets();

/// Lowest and highest axial position.
std::pair<double, double> extent(const std::vector<Cylinder>& cylinders);

/// End webs half a spacing beyond the outer crankpins of these cylinders, at the crank's radius.
EndWebs usual_end_webs(const std::vector<Cylinder>& cylinders, double crank_radius);

/// The four shafts against the moments of orders 1 and 2, switched off, their weights as far apart
/// as the cylinders.
std::vector<Shaft> usual_shafts(const std::vector<Cylinder>& cylinders, double crank_radius);

/// After a change of a layout or of the crank radius: anything at its usual place
/// before (end webs, weights of the shafts) moves to the new place.
void follow_sizes(Input& input, const Input& before);

}  // namespace ravnoves::inertia_moments
