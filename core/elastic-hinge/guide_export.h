#pragma once

#include <string>

#include "elastic-hinge/guide.h"

namespace ravnoves::elastic_hinge {

/// How a guide is drawn for the machine shop.
struct GuideDrawing {
    Branch branch = Branch::compressed;
    double roller_radius = 0.0;     ///< m, ≥ 0; the profile is the path offset by it
    double chord_tolerance = 1e-6;  ///< m: the polyline leaves the curve by no more
    /// The paper's arrangement: the guide turns with the crank and the spring is fixed, so that in
    /// the guide's own axes the roller runs backwards, at the polar angle −φ. False: the spring
    /// turns and the guide is fixed, at +φ.
    bool guide_turns = true;
    std::string title;  ///< for the drawing's note; other than ASCII is left out
};

/// The drawing as a DXF text (AutoCAD 2000), real size, mm: closed polylines on the layers PROFILE
/// and ROLLER_PATH, the axis cross on AXIS, name and tolerance on NOTE.
/// @throws InputError where the guide or the branch does not exist, where the roller undercuts the
///         profile, and for a tolerance out of range; std::runtime_error where no temporary file
///         can be made
std::string guide_dxf(const Guide& guide, const GuideDrawing& drawing);

/// The guide as a table: crank angle and polar angle (°), radius, x, y of the roller's centre and
/// x, y of the profile (mm), with a header line; decimal point, commas.
/// @param step_deg  step of the crank angle, as field::table_step allows; the turn's end is left
/// out
/// @throws InputError as guide_dxf()
std::string guide_csv(const Guide& guide, const GuideDrawing& drawing, double step_deg);

}  // namespace ravnoves::elastic_hinge
