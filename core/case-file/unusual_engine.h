#pragma once

#include <vector>

#include "case-file/message.h"

namespace ravnoves {

/// Sizes that notes about an engine need; SI units.
struct EngineSizes {
    double angular_speed = 0.0;  ///< of the crank
    double crank_radius = 0.0;
    double rod_length = 0.0;     ///< 0: not known
    std::vector<double> masses;  ///< of pistons, rods and weights, each by itself
};

/// Sizes of no engine, though valid in mechanics: a slip of the keys or of the unit rather than a
/// design. The rules admit every engine from a model to a ship: - Masses grow with the cube of the
/// crank radius: m / r³ is 1 000 to 60 000 kg/m³ of motors (the
///   most oversquare racing ones), and 400 000 of the pistons of large low-pressure compressors.
///   Grams typed for kilograms make it 1 000 times that, so above 10⁶ it is doubted.
/// - r / L is 0.08 (locomotives) to 0.5 (ships). Below 0.06 centimetres may have been typed for
/// millimetres.
std::vector<Message> unusual_engine_notes(const EngineSizes& engine);

}  // namespace ravnoves
