#include "workshop/input.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "bob-weights/matching.h"
#include "bob-weights/solver.h"
#include "case-file/field_visitor.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "numerics/constants.h"
#include "v8-plugs/engine.h"
#include "workshop/fields.h"

namespace ravnoves::workshop {

namespace {

using bob_weights::Correction;
using bob_weights::EngineType;
using v8_plugs::cylinder_count;

/// Two names.
struct PlaneNames final : FieldVisitor::Custom {
    explicit PlaneNames(std::array<std::string, 2>& it) : names(it) {}

    void read(const Json& list, const std::string& pointer) override {
        if (!list.is_array() || list.size() != 2 || !list[0].is_string() || !list[1].is_string()) {
            throw InputError(pointer, Text::tr("must be a list of two names"), show(list));
        }
        names = {list[0].get<std::string>(), list[1].get<std::string>()};
    }
    Json write() override {
        return names[0].empty() && names[1].empty() ? Json() : Json{names[0], names[1]};
    }

    std::array<std::string, 2>& names;
};

[[noreturn]] void missing(const std::string& where) {
    throw InputError(where, Text::tr("is required and missing"));
}

void need(const std::string& place, const Field& field, const std::optional<double>& value) {
    if (!value) {
        missing(place + std::string(field.key));
    }
}

void check_two(std::size_t count, const std::string& place) {
    if (count != 2) {
        throw InputError(place, Text::tr("must be a list of two"),
                         Number{static_cast<double>(count)});
    }
}

void check_weigh_in(const Input& input) {
    if (input.weigh_in) {
        shop::check_weighed(*bob_weights::fitted(input).weigh_in, input.plugs.has_value());
        shop::check_matching(input.weigh_in->matching, crank_of(input).angle_count());
    }
}

void check_plugs(const Input& input, const std::string& place) {
    if (!may_have_plugs(input.engine)) {
        throw InputError("/input/plugs",
                         Text::tr("is allowed only for a V of 8 cylinders at 90° with two rods on "
                                  "a crankpin and no split"));
    }
    const auto reject = [](const Field& field) {
        throw InputError("/input/" + std::string(field.key),
                         Text::tr("must be left out with plugs"));
    };
    if (!(input.parts == bob_weights::Parts{})) {
        reject(field::parts);
    }
    if (!(input.factor == bob_weights::Factor{})) {
        reject(field::factor);
    }
    v8_plugs::check_method(*whole_plugs(input), place);
}

void check_parts(const Input& input) {
    for (const bob_weights::PartField& each : bob_weights::part_fields()) {
        if (each.is_needed()) {
            need("/input/parts_g/", each.field, mass_of(input, each));
        }
    }
}

constexpr const char* correction_place = "/input/correction/";

void check_planned(const Correction& correction) {
    const std::string place = correction_place;
    check_two(correction.planes.size(), place + "planes");
    check_two(correction.readings.size(), place + "readings");
    for (std::size_t i = 0; i < 2; ++i) {
        const bob_weights::Plane& plane = correction.planes[i];
        const std::string at = place + "planes/" + std::to_string(i) + "/";
        need(at, field::plane_position, plane.position);
        need(at, field::plane_radius, plane.radius);
        if (plane.from_angle || plane.to_angle) {
            need(at, field::from_angle, plane.from_angle);
            need(at, field::to_angle, plane.to_angle);
        }
        const bob_weights::Reading& reading = correction.readings[i];
        const std::string reading_at = place + "readings/" + std::to_string(i) + "/";
        need(reading_at, field::unbalance, reading.unbalance);
        if (!is_read(reading)) {
            need(reading_at, field::angle, reading.angle);
        }
    }
    const auto apart = [&](const char* list, const Field& field, double first, double second) {
        if (first == second) {
            throw InputError(place + list + "/1/" + std::string(field.key),
                             Text::tr("must differ from the first"),
                             Number{from_si(field, second)});
        }
    };
    const auto read_at = [&](std::size_t i) {
        return correction.readings[i].position.value_or(*correction.planes[i].position);
    };
    apart("planes", field::plane_position, *correction.planes[0].position,
          *correction.planes[1].position);
    apart("readings", field::reading_position, read_at(0), read_at(1));
    if (correction.drill.diameters_mm.empty()) {
        missing(place + "drill/" + std::string(field::diameters.key));
    }
    need(place + "drill/", field::maximum_depth, correction.drill.maximum_depth);
    if (correction.slug) {
        const bob_weights::Slug& slug = *correction.slug;
        need(place + "slug/", field::slug_diameter, slug.diameter);
        need(place + "slug/", field::slug_density, slug.density);
        if (*slug.density <= correction.drill.density) {
            throw InputError(place + "slug/" + std::string(field::slug_density.key),
                             {Text::tr("must be greater than the crankshaft's %1"),
                              from_si(field::density, correction.drill.density)},
                             Number{from_si(field::slug_density, *slug.density)});
        }
    }
}

void check_drilled(const bob_weights::DrillingRecord& record, const std::string& at) {
    for (std::size_t i = 0; record.drilled && i < record.drilled->size(); ++i) {
        const bob_weights::DrilledHole& hole = (*record.drilled)[i];
        if (!hole.depths_agree()) {
            throw InputError(at + std::string(field::drilled.key) + "/" + std::to_string(i) + "/" +
                                 std::string(field::drilled_from_depth.key),
                             {Text::tr("must be less than the depth, %1"),
                              from_si(field::drilled_depth, hole.depth)},
                             Number{from_si(field::drilled_from_depth, hole.from_depth)});
        }
    }
}

void check_runs(const Correction& correction, bool is_older) {
    const auto& runs = correction.earlier_runs;
    const std::string place = correction_place + std::string(field::earlier_runs.key);
    if (runs.size() >= bob_weights::max_runs) {
        throw InputError(place,
                         {Text::tr("must be a list of at most %1"), bob_weights::max_runs - 1},
                         Number{static_cast<double>(runs.size())});
    }
    check_drilled(correction.record, correction_place);
    for (std::size_t run = 0; run < runs.size(); ++run) {
        const auto& readings = runs[run].readings;
        const std::string of_run = place + "/" + std::to_string(run) + "/";
        const std::string at = of_run + std::string(field::readings.key);
        check_drilled(runs[run], of_run);
        if (!readings.empty()) {
            check_two(readings.size(), at);
        }
        for (std::size_t i = 0; i < readings.size(); ++i) {
            need(at + "/" + std::to_string(i) + "/", field::unbalance, readings[i].unbalance);
            if (is_older && !is_read(readings[i])) {
                missing(at + "/" + std::to_string(i) + "/" + std::string(field::angle.key));
            }
        }
    }
}

void check_correction(const Correction& correction, bool is_older) {
    const auto check_count = [&](const Field& field, std::size_t count) {
        if (count != 0) {
            check_two(count, correction_place + std::string(field.key));
        }
    };
    check_count(field::planes, correction.planes.size());
    check_count(field::readings, correction.readings.size());
    const bool is_drilled = std::ranges::any_of(correction.earlier_runs, [](const auto& run) {
        return run.drilled && !run.drilled->empty();
    });
    if (is_older || is_planned(correction)) {
        check_planned(correction);
    } else if (is_drilled && correction.planes.empty()) {
        missing(correction_place + std::string(field::planes.key));
    }
    check_runs(correction, is_older);
}

void check_tolerance(const bob_weights::Tolerance& tolerance) {
    const std::string place = "/input/tolerance/";
    if (tolerance.by_grade) {
        need(place, field::grade, tolerance.grade);
        need(place, field::rotor_mass, tolerance.rotor_mass);
        need(place, field::service_speed, tolerance.service_speed);
    } else {
        need(place, field::plane_tolerance, tolerance.plane);
    }
    if (tolerance.front_bearing || tolerance.rear_bearing) {
        need(place, field::front_bearing, tolerance.front_bearing);
        need(place, field::rear_bearing, tolerance.rear_bearing);
    }
    if (tolerance.front_bearing && *tolerance.front_bearing == *tolerance.rear_bearing) {
        throw InputError(place + std::string(field::rear_bearing.key),
                         Text::tr("must differ from the first"),
                         Number{from_si(field::rear_bearing, *tolerance.rear_bearing)});
    }
    if (tolerance.front_share != 0.5 && (tolerance.centre_of_mass || tolerance.front_bearing)) {
        throw InputError(place + std::string(field::front_share.key),
                         Text::tr("must be left out if centre of mass or bearings are given"),
                         Number{tolerance.front_share});
    }
}

}  // namespace

void visit_fields(FieldVisitor& visitor, Machine& machine) {
    PlaneNames names(machine.planes);
    visitor.custom(field::plane_names, false, names);
    visitor.choice(field::counts, machine.counts, Machine::Counts::counter_clockwise);
    visitor.choice(field::shows, machine.shows, Machine::Shows::heavy);
    visitor.optional_text(field::zero, machine.zero);
}

void visit_fields(FieldVisitor& visitor, Input& input) {
    bob_weights::visit_fields(visitor, input);
    const bool weighed = visitor.has(field::weigh_in.key, input.weigh_in.has_value());
    visitor.object(field::plugs, input.plugs,
                   [&](v8_plugs::Input& plugs) { v8_plugs::visit_plugs(visitor, plugs, weighed); });
    visitor.object_with_defaults(field::machine, input.machine);
}

bool may_have_plugs(const bob_weights::Engine& engine) {
    constexpr double rounding = 1e-9;
    return engine.type == EngineType::v && engine.cylinders == cylinder_count &&
           engine.bank_angle && std::abs(*engine.bank_angle - 0.5 * pi) < rounding &&
           engine.rods_per_pin == 2 && engine.pin_split == 0.0;
}

std::optional<v8_plugs::Input> whole_plugs(const Input& input) {
    if (!input.plugs) {
        return std::nullopt;
    }
    v8_plugs::Input whole = *input.plugs;
    if (input.weigh_in) {
        whole.weigh_in = bob_weights::fitted(input).weigh_in;
        whole.weigh_in->fit(cylinder_count);
    }
    return whole;
}

Input with_heavy_spots(Input input) {
    if (input.machine.shows == Machine::Shows::heavy || !input.correction) {
        return input;
    }
    const auto turn = [](auto& readings) {
        for (auto& reading : readings) {
            if (reading.angle) {
                *reading.angle += pi;
            }
        }
    };
    turn(input.correction->readings);
    for (auto& run : input.correction->earlier_runs) {
        turn(run.readings);
    }
    return input;
}

void note_counts_changed(Correction& correction) {
    const auto note = [](bob_weights::DrillingRecord& record) {
        if (record.drilled && !record.drilled->empty()) {
            record.counted_otherwise = !record.counted_otherwise;
        }
    };
    note(correction.record);
    for (auto& run : correction.earlier_runs) {
        note(run);
    }
}

bool is_planned(const Correction& correction) {
    const auto& readings = correction.readings;
    return readings.size() == 2 && bob_weights::is_read(readings[0]) &&
           bob_weights::is_read(readings[1]) &&
           (readings[0].angle || readings[1].angle || !correction.planes.empty());
}

Input read_input(const Json& json, Completeness completeness) {
    Input input = read_fields<Input>(json, completeness);
    if (completeness == Completeness::required) {
        check_input(input);
    }
    return input;
}

Json write_input(const Input& input) {
    Input whole = input;
    bob_weights::fit_weigh_in(whole);
    return write_fields(whole);
}

void check_input(const Input& input) {
    check_fields(input);
    check_rules(input);
}

void check_rules(const Input& input, bool is_older, const std::string& plugs) {
    bob_weights::check_bob_weight(input);
    check_weigh_in(input);
    if (input.plugs) {
        check_plugs(input, plugs);
    } else {
        check_parts(input);
    }
    if (input.correction) {
        check_correction(*input.correction, is_older);
    }
    if (input.tolerance) {
        check_tolerance(*input.tolerance);
    }
}

}  // namespace ravnoves::workshop
