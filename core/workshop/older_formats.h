#pragma once

#include <optional>
#include <string_view>

#include "case-file/case_file.h"
#include "case-file/field_reader.h"
#include "case-file/json_fwd.h"
#include "case-file/result_visitor.h"
#include "workshop/input.h"

/// The formats v8-plugs and bob-weights, from before workshop: they are read into jobs, solved as
/// such, and answered with the values that they have always had.
namespace ravnoves::workshop {

/// Of bob-weights: without plugs and machine. Depths have no minimum, holes stop within the limit,
/// slugs are radial where the case does not say otherwise; holes that are there are not deepened,
/// and those that no record tells of are what the readings asked for.
struct BobWeightsCase : Input {};

/// Of v8-plugs: the keys of "plugs", and the limits and readings of the machine in "balancing".
struct PlugsCase : Input {
    PlugsCase();
};

void visit_fields(FieldVisitor& visitor, BobWeightsCase& input);
void visit_fields(FieldVisitor& visitor, PlugsCase& input);

/// @throws InputError
void check_bob_weights_case(const BobWeightsCase& input);
void check_plugs_case(const PlugsCase& input);

/// Reads the case's "input" object. With Completeness::as_is, rules that join values are left to
/// the page.
/// @throws InputError
BobWeightsCase read_bob_weights_case(const Json& input,
                                     Completeness completeness = Completeness::required);
PlugsCase read_plugs_case(const Json& input, Completeness completeness = Completeness::required);
/// Writes an "input" object that is read as the same case.
Json write_input(const BobWeightsCase& input);
Json write_input(const PlugsCase& input);

/// What an answer leads with, by pointers below "result".
inline constexpr std::string_view leading_of_bob_weights[] = {"/bobweight_g",
                                                              "/correction/planes/0/unbalance_g_mm",
                                                              "/correction/planes/1/unbalance_g_mm",
                                                              "/correction/planes/0/remaining_g_mm",
                                                              "/correction/planes/1/remaining_g_mm",
                                                              "/permissible_rotor_g_mm"};
inline constexpr std::string_view leading_of_plugs[] = {
    "/options/steel-machined/required_reduction_g", "/k_y"};

/// The values of the format's result. Nothing is doubted.
void visit_results(ResultVisitor& visitor, const BobWeightsCase& input);
void visit_results(ResultVisitor& visitor, const PlugsCase& input);

/// The input of a case of one of these formats as a job.
/// @return nothing for other scenes
/// @throws InputError as those formats
std::optional<Input> read_as_job(std::string_view scene, const Json& input,
                                 Completeness completeness = Completeness::required);

/// Turns a case of these formats into a job of workshop, half filled or not, with its variants, and
/// its study with the pointers of a job; returns others unchanged.
/// @throws InputError as those formats
CaseFile as_job(CaseFile file);

}  // namespace ravnoves::workshop
