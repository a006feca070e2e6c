#pragma once

#include <memory>

#include "balance-shaft/envelope.h"
#include "balance-shaft/input.h"
#include "balance-shaft/moments.h"
#include "balance-shaft/result.h"

namespace ravnoves::balance_shaft {

/// Prepares all that does not depend on α once (curve of M_up, its exact integrals, its first
/// order, the sweep over α, the best α), so that moving the shaft costs about a microsecond.
///
/// Copyable and cheap to copy (the prepared part is shared and constant); const member functions
/// may run in several threads.
class Solver {
  public:
    /// @throws InputError as check_input()
    explicit Solver(const Input& input);

    const Input& input() const;
    /// The whole result at the input's α.
    Result result() const;
    /// Sets α in a result of this solver and updates all that follows it; allocates nothing
    /// for tables of up to 1000 different angles modulo 360°.
    /// @param shaft_angle  rad, any finite angle
    void move_shaft(double shaft_angle, Result& result) const;

    double M_up(double crank_angle) const;                     ///< N·m; angle in rad, any
    double M_s(double crank_angle, double shaft_angle) const;  ///< N·m, equation (4)
    const Moments& moments() const;
    const BuildableAngles& buildable() const;
    /// ΔM_ups of the continuous cycle at α, N·m.
    double range(double shaft_angle) const;
    /// RMS of M_ups about its mean at α, N·m.
    double rms(double shaft_angle) const;
    const FrontView& front_view() const;

    struct Prepared;

  private:
    std::shared_ptr<const Prepared> prepared_;
};

/// Solver(input).result().
/// @throws InputError as check_input()
Result solve(const Input& input);

}  // namespace ravnoves::balance_shaft
