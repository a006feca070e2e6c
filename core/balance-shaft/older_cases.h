#pragma once

#include "case-file/case_file.h"

namespace ravnoves::balance_shaft {

/// Cases of before have the cylinder's sizes in the object of their torque and in the envelope:
/// moves them to "cylinder", and what a study varies there. The bore of a kept torque that is
/// another than the cylinder's is left out, which CaseFile::changes says.
/// @throws InputError that names both places where two sizes differ
void gather_cylinder(CaseFile& file);

}  // namespace ravnoves::balance_shaft
