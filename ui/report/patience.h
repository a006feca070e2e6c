#pragma once

#include <QString>
#include <exception>
#include <functional>

namespace ravnoves {

/// A report that was cancelled.
class ReportCancelled : public std::exception {
  public:
    const char* what() const noexcept override { return "cancelled"; }
};

/// While a report waits for what is computed, the program continues.
class Patience {
  public:
    /// @param isCancelled  of a dialog that is shown and blocks the rest of the program; without it
    ///                     no input is handled, for it would change what is reported
    /// @param tell         sees what is being made and how much of all is, 0…1
    explicit Patience(std::function<bool()> isCancelled = {},
                      std::function<void(const QString& stage, double part)> tell = {});

    void tell(const QString& stage, double part) const;
    /// For a part of all work: its progress is between these two.
    Patience of(double from, double to) const;

    /// Handles what there is to handle; where there is nothing, waits so long for it, ms.
    /// @throws ReportCancelled
    void wait(int longest = 0) const;

  private:
    std::function<bool()> isCancelled_;
    std::function<void(const QString&, double)> tell_;
};

}  // namespace ravnoves
