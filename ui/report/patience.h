#pragma once

#include <exception>
#include <functional>

namespace ravnoves {

/// A report that nobody waits for any more.
class ReportCancelled : public std::exception {
  public:
    const char* what() const noexcept override { return "cancelled"; }
};

/// While a report waits for what is computed, the program goes on.
class Patience {
  public:
    /// Whether the user waits in a dialog that blocks the rest of the program: only then is input
    /// handled, which would change what is reported.
    using InDialog = std::function<bool()>;

    explicit Patience(InDialog inDialog = {}, std::function<bool()> isCancelled = {});

    /// Handles what there is to handle.
    /// @throws ReportCancelled
    void turn() const;
    /// The same, and where there is nothing waits so long for it, ms.
    void wait(int longest) const;

  private:
    InDialog inDialog_;
    std::function<bool()> isCancelled_;
};

}  // namespace ravnoves
