#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "bob-weights/drilling.h"
#include "bob-weights/factor_theory.h"
#include "bob-weights/input.h"
#include "shop/matching.h"

namespace ravnoves::bob_weights {

/// One line of the card.
struct Line : shop::WeightLine {
    const PartField* part = nullptr;  ///< null where the name alone is enough
};

/// Metal drilled from a plane and pressed into it.
struct Metal {
    std::vector<Hole> holes;
    std::vector<Hole> slugs;

    bool empty() const { return holes.empty() && slugs.empty(); }
};

/// The metal drilled after one run, where the next run shows another effect: also a change where
/// nothing was drilled.
struct OtherEffect {
    double expected;         ///< unbalance that it was to leave, kg·m
    double expected_angle;   ///< rad, 0…2π
    std::size_t since;       ///< the run that it was drilled after
    bool is_drilled;         ///< false: the record has no metal
    bool is_large;           ///< so that no plan can rest on it
    bool is_opposite;        ///< it acted the other way: the unbalance grew
    bool is_at_light_spot;   ///< it acted the other way: the unbalance was to grow, and fell
    bool is_in_other_plane;  ///< each plane changed as the other one was to
};

/// A run of the machine.
struct RunResult {
    struct InPlane {
        double unbalance;                      ///< kg·m
        std::optional<double> angle;           ///< rad, 0…2π
        std::optional<bool> within_tolerance;  ///< as measured
    };
    /// Both readings taken to the correction planes; else, of readings without direction or without
    /// planes, what each plane reads, without an angle.
    std::array<std::optional<InPlane>, 2> planes;

    /// The bob weight that it was read with where it is not the one there is now, kg, and the
    /// crankshaft where it is another: it says nothing of this one then.
    std::optional<double> read_with;
    std::optional<shop::OtherShaft> read_on;

    /// After it, by the record; of the newest run only where a further one was emptied again.
    std::array<Metal, 2> drilled;
    bool is_recorded = false;  ///< false where the record is unknown, or of another crankshaft

    /// In each plane, for the metal drilled since the run that was read whole before it.
    std::array<std::optional<OtherEffect>, 2> other_effect;

    bool is_read() const { return planes[0] || planes[1]; }
    bool has_vectors() const { return planes[0] && planes[0]->angle; }
    /// kg·m; nothing where a plane was not read.
    std::array<std::optional<double>, 2> unbalances() const;
    /// As measured, of a plane; nothing without reading or limit, and no pass of half a run.
    std::optional<bool> within(std::size_t plane) const;
    /// No plan rests on what the metal drilled before did in a plane.
    bool contradicts(std::size_t plane) const {
        return other_effect[plane] && other_effect[plane]->is_large;
    }
    bool acted_as_meant() const { return !contradicts(0) && !contradicts(1); }

    bool is_drilled() const { return !drilled[0].empty() || !drilled[1].empty(); }
    bool holds() const { return !read_with && !read_on; }
    /// As measured; nothing without readings or limits.
    std::optional<bool> passes() const;
};

/// The correction of one plane.
struct PlaneResult {
    double unbalance;                      ///< of the readings taken to the plane, kg·m
    double angle;                          ///< rad, 0…2π
    std::vector<Hole> holes;               ///< at the heavy spot
    std::vector<Hole> slugs;               ///< opposite it
    double beyond_sector;                  ///< of their edges, edge_beyond() at its most, m
    double remaining;                      ///< kg·m
    double remaining_angle;                ///< rad
    std::optional<bool> within_tolerance;  ///< after the correction
    Message reason;                        ///< why more remains than may; empty where all is well

    bool is_planned() const { return !holes.empty() || !slugs.empty(); }
};

/// Everything the page, the card and the result file show. What needs values that are not there yet
/// is empty.
struct Result {
    double theory_factor = 0.5;
    double factor = 0.5;  ///< in use, without the overbalance
    std::vector<Line> lines;
    std::optional<double> reciprocating;  ///< of one cylinder, kg
    std::optional<double> rotating;       ///< of one cylinder, kg
    std::optional<double> bob_weight;     ///< kg
    std::optional<FirstOrder> first_order;
    std::optional<FirstOrder> first_order_bare;  ///< without counterweights
    std::vector<double> crankpins;         ///< each one's own bob weight, of the parts weighed; kg
    std::optional<shop::Matched> placing;  ///< which set belongs to which cylinder
    std::vector<double> placed_crankpins;  ///< then; kg
    std::optional<double> permissible_whole;           ///< U_per of the rotor, kg·m
    std::optional<std::array<double, 2>> permissible;  ///< of each plane, kg·m
    std::vector<RunResult> runs;  ///< from the first; the last is the one that is corrected
    /// How many times as large an error of both readings may be in a plane: 1 where the machine
    /// reads in the planes or between them.
    std::optional<double> amplification;
    std::optional<std::array<PlaneResult, 2>> correction;
    /// The run that is corrected; null without one.
    const RunResult* newest() const { return runs.empty() ? nullptr : &runs.back(); }
    /// False where its readings are of another bob weight or crankshaft.
    bool holds() const { return newest() == nullptr || newest()->holds(); }
    std::vector<const PartField*> not_given;  ///< parts that count as 0
    /// Masses that were typed in kilograms, as it seems; kg.
    std::vector<std::pair<const PartField*, double>> in_kilograms;

    /// Of the correction: whether both planes are within their limits after it; nothing where the
    /// drilling before it acted otherwise than meant, for the plan rests on that.
    std::optional<bool> passes_after() const;
    /// Something is to be drilled or pressed in.
    bool is_planned() const {
        return correction && ((*correction)[0].is_planned() || (*correction)[1].is_planned());
    }
};

/// What of the bob weight is missing, by its fields; empty where it is known.
std::vector<const Field*> missing_for_bob_weight(const Input& input);

}  // namespace ravnoves::bob_weights
