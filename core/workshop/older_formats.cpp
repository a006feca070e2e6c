#include "workshop/older_formats.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "bob-weights/fields.h"
#include "bob-weights/results.h"
#include "bob-weights/solver.h"
#include "case-file/field_writer.h"
#include "case-file/json.h"
#include "shop/results.h"
#include "v8-plugs/results.h"
#include "workshop/input.h"
#include "workshop/results.h"
#include "workshop/solver.h"

namespace ravnoves::workshop {

namespace {

using bob_weights::Correction;

// What v8-plugs has elsewhere than a job.
inline constexpr Field balancing{.key = "balancing",
                                 .hint = Text::tr("Limits and readings of the balancing machine.")};
inline constexpr Field front_reading{.key = "front_reading_g_mm",
                                     .range = Range::between(0, 1e9),
                                     .label = Text::tr("&Front plane (pulley)"),
                                     .hint = Text::tr("Residual unbalance after correction.")};
inline constexpr Field rear_reading{.key = "rear_reading_g_mm",
                                    .range = Range::between(0, 1e9),
                                    .label = Text::tr("&Rear plane (flywheel)"),
                                    .hint = Text::tr("Residual unbalance after correction.")};

inline constexpr Field front_bob_weight{.key = "front_bobweight_g",
                                        .range = shop::field::bob_weight_then.range,
                                        .label = Text::tr("Bob weight of the reading, front"),
                                        .hint = shop::field::bob_weight_then.hint};
inline constexpr Field rear_bob_weight{.key = "rear_bobweight_g",
                                       .range = shop::field::bob_weight_then.range,
                                       .label = Text::tr("Bob weight of the reading, rear"),
                                       .hint = shop::field::bob_weight_then.hint};

inline constexpr Field front_shaft{.key = "front_read_of", .hint = shop::field::read_shaft.hint};
inline constexpr Field rear_shaft{.key = "rear_read_of", .hint = shop::field::read_shaft.hint};

void visit_reading(FieldVisitor& visitor, bob_weights::Reading& reading, const Field& unbalance,
                   const Field& bob_weight, const Field& shaft) {
    visitor.number(unbalance, reading.unbalance);
    visitor.number(bob_weight, reading.bob_weight);
    visitor.object_with_defaults(shaft, reading.shaft);
}

/// Readings alone: the planes are the machine's.
Correction readings_alone() {
    Correction correction;
    correction.planes.clear();
    return correction;
}

}  // namespace

PlugsCase::PlugsCase() {
    engine.bank_angle = 90.0 * degree;
    plugs.emplace();
}

void visit_fields(FieldVisitor& visitor, BobWeightsCase& input) {
    bob_weights::visit_fields(visitor, input);
}

void visit_fields(FieldVisitor& visitor, PlugsCase& input) {
    v8_plugs::visit_plugs(visitor, *input.plugs,
                          visitor.has(shop::field::weigh_in.key, input.weigh_in.has_value()));
    visitor.object(shop::field::weigh_in, input.weigh_in, [&](shop::WeighIn& sheet) {
        sheet.fit(v8_plugs::cylinder_count);
        shop::visit_sheet(visitor, sheet, true);
    });
    visitor.object(balancing, input.tolerance, [&](bob_weights::Tolerance& tolerance) {
        Correction absent = readings_alone();
        if (!input.correction && (visitor.is_reading() || visitor.creates_objects())) {
            input.correction = absent;
        }
        auto& readings = (input.correction ? *input.correction : absent).readings;
        visitor.required(shop::field::grade, tolerance.grade);
        visitor.required(shop::field::rotor_mass, tolerance.rotor_mass);
        visitor.required(shop::field::service_speed, tolerance.service_speed);
        visit_reading(visitor, readings[0], front_reading, front_bob_weight, front_shaft);
        visit_reading(visitor, readings[1], rear_reading, rear_bob_weight, rear_shaft);
        visitor.number(bob_weights::field::front_share, tolerance.front_share, 0.5);
        if (input.correction == readings_alone()) {
            input.correction.reset();
        }
    });
    visitor.object_with_defaults(shop::field::job, input.job);
}

void check_bob_weights_case(const BobWeightsCase& input) {
    check_fields(input);
    check_rules(input, true);
}

void check_plugs_case(const PlugsCase& input) {
    check_fields(input);
    check_rules(input, false, "/input/");
}

BobWeightsCase read_bob_weights_case(const Json& json, Completeness completeness) {
    Json whole = json;
    if (whole.is_object() && whole.contains("correction") && whole["correction"].is_object()) {
        Json& correction = whole["correction"];
        correction.emplace(bob_weights::field::aim.key, "tolerance");
        correction.emplace(bob_weights::field::smallest_depth.key, 0.0);
        if (correction.contains("slug") && correction["slug"].is_object()) {
            correction["slug"].emplace(bob_weights::field::slug_direction.key, "radial");
        }
    }
    auto input = read_fields<BobWeightsCase>(whole, completeness);
    if (completeness == Completeness::required) {
        check_bob_weights_case(input);
    }
    if (input.correction) {
        input.correction->deepens = false;
        record_plans(input, 0, [](const Input& then) { return bob_weights::solve(then, false); });
    }
    return input;
}

PlugsCase read_plugs_case(const Json& json, Completeness completeness) {
    auto input = read_fields<PlugsCase>(json, completeness);
    if (completeness == Completeness::required) {
        check_plugs_case(input);
    } else {
        v8_plugs::check_choices(*whole_plugs(input), "/input/");
    }
    return input;
}

Json write_input(const BobWeightsCase& input) {
    BobWeightsCase whole = input;
    bob_weights::fit_weigh_in(whole);
    return write_fields(whole);
}

Json write_input(const PlugsCase& input) {
    return write_fields(input);
}

void visit_results(ResultVisitor& visitor, const BobWeightsCase& input) {
    bob_weights::Result result =
        bob_weights::solve(input, visitor.wants(shop::result_field::weigh_in.key));
    visit_verdict(visitor, [&] { return bob_weights::verdict(input, result); });
    // That format begins with the rings.
    std::stable_partition(result.lines.begin(), result.lines.end(),
                          [](const auto& line) { return line.part->column == shop::Part::rings; });
    bob_weights::visit_job(visitor, input, result);
}

void visit_results(ResultVisitor& visitor, const PlugsCase& input) {
    const Result result =
        solve_undoubted(input, true, visitor.wants(shop::result_field::weigh_in.key));
    visit_verdict(visitor, [&] {
        const v8_plugs::Input& plugs = *result.plugs_input;
        Verdict verdict = v8_plugs::verdict_of_plugs(plugs, *result.plugs);
        if (const v8_plugs::ShiftEffect* shift = result.plugs->shift_that_matters()) {
            verdict.warn(describe(*shift, plugs.tolerance));
        }
        verdict.warn(v8_plugs::plug_doubt(plugs, *result.plugs).text);
        const bob_weights::RunResult* newest = result.shaft.newest();
        if (!result.shaft.holds()) {
            verdict.warn(
                shop::other_readings(newest->read_with, newest->read_on, result.shaft.bob_weight));
        } else if (newest != nullptr) {
            shop::add_machine_verdict(verdict, newest->unbalances(), result.shaft.permissible);
        }
        return verdict;
    });
    visit_plugs(visitor, input, result);
}

std::optional<Input> read_as_job(std::string_view scene, const Json& input,
                                 Completeness completeness) {
    if (scene == "v8-plugs") {
        PlugsCase job = read_plugs_case(input, completeness);
        // What a shaft on the machine has not changed by is 0, as that format says.
        job.plugs->changes_given = job.plugs->changes_given || job.correction;
        return job;
    }
    if (scene == "bob-weights") {
        Input job = read_bob_weights_case(input, completeness);
        if (job.correction) {
            job.correction->deepens = true;
        }
        return job;
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
    const auto move = [&](const char* key, const auto& place) {
        if (study.is_object() && study.contains(key) && study[key].is_object()) {
            moved[key] = Json::object();
            for (const auto& [pointer, value] : study[key].items()) {
                moved[key][place(pointer)] = value;
            }
        }
    };
    move("vary", place_of_job);
    move("watch", [](const std::string& pointer) { return "/plugs" + pointer; });
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

}  // namespace ravnoves::workshop
