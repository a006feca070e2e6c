#pragma once

#include <array>
#include <optional>
#include <string>

#include "bob-weights/input.h"
#include "case-file/field_reader.h"
#include "v8-plugs/input.h"

/// One job of the shop: the parts on the scale, the plugs of a V-8 that has them, the bob weights,
/// the readings of the machine and the holes.
namespace ravnoves::workshop {

/// The balancing machine, as set up. Angles of readings are as it shows them; angles of holes are
/// in the metal, in the machine's sense of counting from its zero.
struct Machine {
    enum class Counts { clockwise, counter_clockwise };  ///< seen from the front
    enum class Shows { heavy, light };

    std::array<std::string, 2> planes;  ///< their names; empty: front and rear
    Counts counts = Counts::counter_clockwise;
    Shows shows = Shows::heavy;
    std::string zero;  ///< where 0° is

    /// The angle that it shows for a heavy spot, rad.
    double shown(double heavy_spot) const;

    friend bool operator==(const Machine&, const Machine&) = default;
};

struct Input : bob_weights::Input {
    /// Of a V-8 at 90° with plugs in its sludge traps, but for the weigh-in, which the job has.
    std::optional<v8_plugs::Input> plugs;
    Machine machine;

    friend bool operator==(const Input&, const Input&) = default;
};

void visit_fields(FieldVisitor& visitor, Machine& machine);
void visit_fields(FieldVisitor& visitor, Input& input);

/// Whether such an engine may have plugs: a V of 8 cylinders at 90°, two rods on a pin, no split.
bool may_have_plugs(const bob_weights::Engine& engine);

/// The plugs with the weigh-in of the job; nothing without plugs.
std::optional<v8_plugs::Input> whole_plugs(const Input& input);
/// The same job with the readings as heavy spots, whatever the machine shows.
Input with_heavy_spots(Input input);

/// Notes of the holes that are there that the machine counts the other way now.
void note_counts_changed(bob_weights::Correction& correction);

/// Whether the newest readings and their planes are to be made a plan of holes; else they have a
/// verdict alone.
bool is_planned(const bob_weights::Correction& correction);

/// Reads the case's "input" object. With Completeness::as_is, rules that join values are left to
/// the page.
/// @throws InputError
Input read_input(const Json& input, Completeness completeness = Completeness::required);
/// Writes an "input" object that read_input() turns into the same Input.
Json write_input(const Input& input);

/// Checks the ranges, that nothing which a result needs is missing, and the rules that join fields.
/// @throws InputError
void check_input(const Input& input);
/// The same but for the ranges.
/// @param is_older  of bob-weights: whatever is corrected is planned, and every reading has its
/// angle
/// @param plugs     where the case has their fields
void check_rules(const Input& input, bool is_older = false,
                 const std::string& plugs = "/input/plugs/");

}  // namespace ravnoves::workshop
