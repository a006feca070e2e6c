#pragma once

#include "balance-shaft/position_study.h"

namespace ravnoves {

/// What a place of the shaft's axis is judged by: range, RMS or a weighted sum of both, against the
/// engine without a shaft. The less, the better.
struct PlaceCriterion {
    using Position = balance_shaft::ShaftPosition;
    using Criteria = balance_shaft::PositionCriteria;
    using Study = balance_shaft::PositionStudy;

    enum class Kind { Range, Rms, Both };

    Kind kind = Kind::Range;
    double weight = 0.5;  ///< share of the range in the weighted sum, 0…1; the RMS has the rest

    bool operator==(const PlaceCriterion&) const = default;

    /// The value of a kind, of one for each.
    template <typename Value>
    static Value of(Kind kind, const Value& range, const Value& rms, const Value& both) {
        return kind == Kind::Range ? range : kind == Kind::Rms ? rms : both;
    }

    /// Whether the engine without a shaft has anything to be judged against.
    static bool judges(const Study& study);
    /// Change against the engine without a shaft as a fraction: −0.1 is 10 % less; where it
    /// judges().
    double change(const Study& study, double range, double rms) const;
    /// The range's weight in the sum in N·m, whose parts are not relative to the engine without a
    /// shaft.
    double rangeWeight(const Study& study) const;
    /// The best of the places nearby whose l and α are whole 0.01 mm and 0.01° and that are as
    /// feasible as the place itself; else the place.
    Position shortened(const Study& study, const Position& exact) const;

  private:
    double rangeShare() const;
    double valueOf(const Study& study, const Criteria& criteria) const;
};

}  // namespace ravnoves
