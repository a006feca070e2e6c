#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace ravnoves {

/// The numbers of a page, and what inputs that scatter make of each of them by its slopes.
struct BandSlopes {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    std::vector<double> nominal;   ///< not a number where there is none
    std::vector<double> periods;   ///< of numbers that are angles; else 0
    std::vector<double> variance;  ///< as many as there are nominal ones, as is the shift
    std::vector<double> shift;     ///< of the mean

    /// The numbers with one input a standard deviation up and down; nothing where it is refused.
    /// @param isCentred  the input is the mean of its law
    /// @return what each number moves per standard deviation
    std::vector<float> add(const std::optional<std::vector<double>>& up,
                           const std::optional<std::vector<double>>& down, bool isCentred);
    /// From the 5 % point to the number, and from it to the 95 % point.
    std::vector<double> below() const { return side(-1.0); }
    std::vector<double> above() const { return side(1.0); }

  private:
    std::vector<double> side(double sign) const;
};

}  // namespace ravnoves
