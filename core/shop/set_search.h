#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ravnoves::shop {

/// One kind of sets that change places among themselves.
struct SetKind {
    /// Share of set s in place p, one number for each dimension of the search, at
    /// (s · places + p) · dimensions.
    std::vector<double> adds;
    std::vector<int> group;  ///< by place: sets change places within a group alone

    friend bool operator==(const SetKind&, const SetKind&) = default;
};

/// Which of two kinds of sets belongs where, to minimise the size of their sum.
struct SetSearch {
    enum class Size {
        spread,  ///< largest number less smallest
        norm     ///< root of the sum of squares
    };
    std::size_t places = 0;
    std::size_t dimensions = 0;
    std::array<SetKind, 2> kinds;
    std::vector<double> fixed;  ///< is added to what the sets add up to
    Size size = Size::spread;
    double enough = 0.0;      ///< smaller is no better
    double rounding = 1e-14;  ///< sizes that differ by less are the same

    friend bool operator==(const SetSearch&, const SetSearch&) = default;
};

struct SetsFound {
    std::array<std::vector<int>, 2> from;  ///< by place: the set that moves there
    bool proven = false;                   ///< nothing is better
    int moved = 0;                         ///< sets that change their place
};

/// By place of both kinds, where every set stays.
std::array<std::vector<int>, 2> unmoved_sets(std::size_t places);
/// What a placing adds up to.
std::vector<double> sum_of(const SetSearch& search, const std::array<std::vector<int>, 2>& from);
double size_of(const SetSearch& search, const std::array<std::vector<int>, 2>& from);

/// The smallest size; among those that are enough, or the same but for rounding, the fewest sets
/// moved; among these again the smallest.
///
/// Exchanges of two sets from the present placing and from random ones, as long as they help. Where
/// each kind has no more placings than 8! (eight places; five and five in two groups) all pairs of
/// placings are compared after that, but for those that the bounds of several show to be worse. The
/// thread's last search is kept: most edits of a case do not affect it.
SetsFound best_placing(const SetSearch& search);

}  // namespace ravnoves::shop
