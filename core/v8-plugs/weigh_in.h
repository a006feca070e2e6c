#pragma once

#include <optional>

#include "shop/matching.h"
#include "v8-plugs/compensation.h"

namespace ravnoves::v8_plugs {

// The weigh-in sheet: every part of every cylinder on the scale. Masses in kg.

using shop::all_parts;
using shop::CylinderNumbering;
using shop::Part;
using shop::part_word;
using shop::PartColumn;
using shop::WeighIn;

/// The nominal masses of one cylinder that follow from its parts, kg: piston, pin, rings and small
/// end move with the piston, big end and shells turn with the crankpin. Nothing while the nominal
/// mass of one of them is missing.
std::optional<double> nominal_reciprocating(const WeighIn& sheet);
std::optional<double> nominal_rotating(const WeighIn& sheet);

/// The mass changes of the method from the sheet: means over the cylinders against nominal.
///
/// In repair the piston with its rings is Δm_рп, pin and small end (which move with the piston) are
/// Δm_п, the shells of both rods of a crankpin Δm_шр. In manufacture piston, pin, rings and small
/// end are Δm_п; weighed shells are Δm_шр there too. Incomplete columns count as nominal; a change
/// without a complete column keeps its typed value.
MassChanges mass_changes(const WeighIn& sheet, Process process, const MassChanges& typed = {});
/// The change of the method that the part belongs to.
double MassChanges::*change_of(Part part, Process process);
/// True where the sheet says the change: a column of its parts is complete.
bool is_weighed(const WeighIn& sheet, Process process, double MassChanges::*change);

/// How often the parts of complete columns add to the excess of their crankpin; others count as
/// nominal.
shop::PartFactors excess_factors(const WeighIn& sheet, double rod_coefficient);

}  // namespace ravnoves::v8_plugs
