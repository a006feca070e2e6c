#pragma once

#include <functional>
#include <utility>

namespace ravnoves::methods {

/// Thrown out of a measurement that was cancelled.
struct Cancelled {};

/// While it lives, long runs in its thread can be cancelled.
class CancelScope {
  public:
    /// @param goes_on  false cancels; empty: never asked
    explicit CancelScope(std::function<bool()> goes_on) { asked() = std::move(goes_on); }
    ~CancelScope() { asked() = nullptr; }
    CancelScope(const CancelScope&) = delete;
    CancelScope& operator=(const CancelScope&) = delete;

    /// What is asked in this thread.
    static std::function<bool()>& asked() {
        static thread_local std::function<bool()> goes_on;
        return goes_on;
    }
};

/// For runs that may last longer than a moment, at every thousandth step or so.
/// @throws Cancelled where the CancelScope of this thread says so
inline void check_cancelled() {
    if (CancelScope::asked() && !CancelScope::asked()()) {
        throw Cancelled{};
    }
}

}  // namespace ravnoves::methods
