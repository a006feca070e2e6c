#include "workshop/input.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "bob-weights/drilling.h"
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

double Machine::shown(double heavy_spot) const {
    return shows == Shows::light ? bob_weights::turn_of(heavy_spot + pi) : heavy_spot;
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
    note(correction.planned);
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
    bob_weights::check_parts(input, input.plugs.has_value());
    if (input.plugs) {
        check_plugs(input, plugs);
    }
    if (input.correction) {
        const Correction& correction = *input.correction;
        bob_weights::check_correction(correction, is_older || is_planned(correction), is_older);
    }
    if (input.tolerance) {
        bob_weights::check_tolerance(*input.tolerance);
    }
}

}  // namespace ravnoves::workshop
