#pragma once

#include <functional>

namespace ravnoves::methods {

/// Thrown out of a measurement that was cancelled.
struct Cancelled {};

/// While it lives, long runs in its thread can be cancelled: check_cancelled() asks `goes_on`, but
/// no more often than every 20 ms, so that asking costs a run nothing.
class CancelScope {
  public:
    /// @param goes_on  false cancels; empty: never asked
    explicit CancelScope(std::function<bool()> goes_on);
    ~CancelScope();
    CancelScope(const CancelScope&) = delete;
    CancelScope& operator=(const CancelScope&) = delete;
};

/// For runs that may last longer than a moment, at every thousandth step or so.
/// @throws Cancelled where the CancelScope of this thread says so
void check_cancelled();

}  // namespace ravnoves::methods
