#include "workshop/scene.h"

#include <array>
#include <string>
#include <utility>

#include "bob-weights/scene.h"
#include "bob-weights/solver.h"
#include "case-file/field_writer.h"
#include "case-file/json.h"
#include "case-file/result_json.h"
#include "v8-plugs/scene.h"
#include "workshop/results.h"

namespace ravnoves::workshop {

Input as_job(v8_plugs::Input plugs) {
    Input job;
    job.engine.bank_angle = 90.0 * degree;
    job.job = std::exchange(plugs.job, {});
    if (plugs.weigh_in) {
        job.weigh_in = *std::exchange(plugs.weigh_in, std::nullopt);
    }
    if (const auto sheet = std::exchange(plugs.balancing, std::nullopt)) {
        bob_weights::Tolerance& tolerance = job.tolerance.emplace();
        tolerance.grade = sheet->grade;
        tolerance.rotor_mass = sheet->rotor_mass;
        tolerance.service_speed = sheet->service_speed;
        tolerance.front_share = sheet->front_share;
        const auto& [front, rear] = sheet->readings;
        if (front.unbalance || rear.unbalance) {
            bob_weights::Correction& correction = job.correction.emplace();
            correction.planes.clear();
            correction.readings = {{{}, front.unbalance, {}, front.bob_weight, front.shaft},
                                   {{}, rear.unbalance, {}, rear.bob_weight, rear.shaft}};
        }
    }
    job.plugs = std::move(plugs);
    return job;
}

Input as_job(bob_weights::Input shaft) {
    if (shaft.correction) {
        bob_weights::Correction& correction = *shaft.correction;
        const bob_weights::Result solved = bob_weights::solve(shaft, false);
        // The format plans what no record tells of; a job knows of the holes that are there alone.
        for (std::size_t run = 0; run < correction.earlier_runs.size(); ++run) {
            auto& drilled = correction.earlier_runs[run].drilled;
            if (!drilled && run < solved.runs.size()) {
                drilled = bob_weights::drilled_holes(solved.runs[run]);
            }
        }
        correction.aim = bob_weights::Aim::tolerance;
        correction.smallest_depth = 0.0;
        if (correction.slug) {
            correction.slug->direction = bob_weights::SlugDirection::radial;
        }
    }
    return {std::move(shaft), std::nullopt, {}};
}

std::optional<Input> read_as_job(std::string_view scene, const Json& input,
                                 Completeness completeness) {
    if (scene == "v8-plugs") {
        return as_job(v8_plugs::read_input(input, completeness));
    }
    if (scene == "bob-weights") {
        return as_job(bob_weights::read_input(input, completeness));
    }
    return std::nullopt;
}

namespace {

using Renamed = std::pair<std::string_view, std::string_view>;

/// Where a job has what v8-plugs has elsewhere; the first that begins a pointer counts.
constexpr std::array<Renamed, 6> input_places{{
    {"/weigh_in", "/weigh_in"},
    {"/job", "/job"},
    {"/balancing/front_reading_g_mm", "/correction/readings/0/unbalance_g_mm"},
    {"/balancing/rear_reading_g_mm", "/correction/readings/1/unbalance_g_mm"},
    {"/balancing", "/tolerance"},
    {"", "/plugs"},
}};

std::string place_of_job(const std::string& pointer) {
    for (const auto& [from, to] : input_places) {
        if (pointer.starts_with(from)) {
            return std::string(to) + pointer.substr(from.size());
        }
    }
    return pointer;
}

/// The same spreads and watched values under the pointers of a job.
Json study_of_job(const Json& study) {
    Json moved = study;
    if (study.is_object() && study.contains("vary") && study["vary"].is_object()) {
        moved["vary"] = Json::object();
        for (const auto& [pointer, spread] : study["vary"].items()) {
            moved["vary"][place_of_job(pointer)] = spread;
        }
    }
    if (study.is_object() && study.contains("watch") && study["watch"].is_object()) {
        moved["watch"] = Json::object();
        for (const auto& [pointer, limits] : study["watch"].items()) {
            moved["watch"]["/plugs" + pointer] = limits;
        }
    }
    return moved;
}

}  // namespace

CaseFile as_job(CaseFile file) {
    const std::string scene = file.scene;
    auto input = read_as_job(scene, file.input, Completeness::as_is);
    if (!input) {
        return file;
    }
    file.scene = "workshop";
    file.input = write_input(*input);
    for (CaseVariant& variant : file.variants) {
        variant.input = write_input(*read_as_job(scene, variant.input, Completeness::as_is));
    }
    if (scene == "v8-plugs") {
        file.study = study_of_job(file.study);
    }
    return file;
}

Input read_input(const Json& json, Completeness completeness) {
    Input input = read_fields<Input>(json, completeness);
    if (completeness == Completeness::required) {
        check_input(input);
    } else {
        bob_weights::fit_weigh_in(input);
    }
    return input;
}

Json write_input(const Input& input) {
    Input whole = input;
    bob_weights::fit_weigh_in(whole);
    return write_fields(whole);
}

Json solve_scene(const Json& json, const CaseContext& /*context*/, const Wanted& wanted) {
    return result_json(wanted, read_input(json));
}

}  // namespace ravnoves::workshop
