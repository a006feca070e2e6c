#pragma once

#include <QtGlobal>
#include <exception>
#include <functional>
#include <limits>
#include <utility>

namespace ravnoves {

/// A report that was cancelled.
class ReportCancelled : public std::exception {
  public:
    const char* what() const noexcept override { return "cancelled"; }
};

/// Keeps the program alive while a report waits for computations.
class Patience {
  public:
    /// @param isCancelled  of a visible dialog that blocks the rest of the program; without it no
    ///                     input is handled, for it would change the report
    explicit Patience(std::function<bool()> isCancelled = {})
        : isCancelled_(std::move(isCancelled)) {}

    /// Handles pending events.
    /// @throws ReportCancelled
    void wait() const;
    /// The same while something is busy, ms at most.
    void waitWhile(const std::function<bool()>& isBusy,
                   qint64 longest = std::numeric_limits<qint64>::max()) const;

  private:
    std::function<bool()> isCancelled_;
};

}  // namespace ravnoves
