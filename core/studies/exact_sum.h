#pragma once

#include <array>
#include <cstdint>

#include "case-file/json_fwd.h"

namespace ravnoves::studies {

/// The exact sum of any finite doubles: the same whatever their order, and however they are shared
/// out among threads and machines. A fixed-point number as wide as all doubles (Kulisch), in limbs
/// of 32 bits.
class ExactSum {
  public:
    void add(double x);  ///< finite
    void add(const ExactSum& other);
    double value() const;  ///< to half a unit of its last place, up to rounding twice
    bool operator==(const ExactSum& other) const;

    Json write() const;
    /// @throws InputError
    static ExactSum read(const Json& json, const std::string& pointer);

  private:
    static constexpr int limbs = 74;
    static constexpr int offset = 1152;  ///< bits: limb i weighs 2^(32 i − offset)
    using Limbs = std::array<std::int64_t, limbs>;

    /// All but the last in [0, 2³²).
    static void carry(Limbs& limbs);

    Limbs limbs_{};
    std::int64_t pending_ = 0;  ///< additions since the last carry
};

}  // namespace ravnoves::studies
