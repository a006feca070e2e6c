#include "balance-shaft/fields.h"

#include <algorithm>
#include <charconv>
#include <functional>

#include "balance-shaft/input.h"
#include "case-file/field_visitor.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"

namespace ravnoves::balance_shaft {

namespace {

NamedMass& named(std::vector<NamedMass>& masses, const std::string& name) {
    const auto found = std::find_if(masses.begin(), masses.end(),
                                    [&](const NamedMass& part) { return part.name == name; });
    if (found != masses.end()) {
        return *found;
    }
    // A case that gave only the sum: it stays as one part beside the named ones.
    for (NamedMass& part : masses) {
        part.name = part.name.empty() ? "other" : part.name;
    }
    return masses.emplace_back(NamedMass{name, 0.0});
}

Field field_of(const NamedMass& part) {
    for (const Field& listed : field::mass_parts) {
        if (listed.key == part.name) {
            return listed;
        }
    }
    Field other = field::mass_parts[0];
    other.key = part.name;
    other.label = other.hint = {};
    return other;
}

void visit_masses(FieldVisitor& visitor, Input& input) {
    std::vector<NamedMass>& masses = input.reciprocating_masses;
    const bool sum_alone = masses.size() == 1 && masses[0].name.empty();
    const int which =
        visitor.one_of({field::reciprocating_masses.key, field::reciprocating_mass.key}, sum_alone);
    const bool all = which < 0;
    if (which != 0) {
        double sum = input.reciprocating_mass();
        visitor.number(field::reciprocating_mass, sum);
        if (visitor.is_reading() || (sum_alone && sum != masses[0].mass)) {
            masses = {{"", sum}};
        }
    }
    if (which != 1 || visitor.creates_objects()) {
        visitor.object_of(field::reciprocating_masses, true, true, [&] {
            std::vector<std::string> names;
            names.reserve(masses.size());
            for (const NamedMass& part : masses) {
                names.push_back(part.name);
            }
            if (all) {
                for (const Field& listed : field::mass_parts) {
                    names.emplace_back(listed.key);
                }
            }
            for (const std::string& name : visitor.names(std::move(names))) {
                NamedMass& part = named(masses, name);
                visitor.number(field_of(part), part.mass);
            }
        });
    }
}

void visit_cycle(FieldVisitor& visitor, GasCycle& cycle) {
    constexpr GasCycle usual;
    visitor.number(field::compression_ratio, cycle.compression_ratio);
    visitor.number(field::intake_pressure, cycle.intake_pressure, usual.intake_pressure);
    visitor.number(field::exhaust_pressure, cycle.exhaust_pressure, usual.exhaust_pressure);
    visitor.number(field::polytropic_compression, cycle.polytropic_compression,
                   usual.polytropic_compression);
    visitor.number(field::polytropic_expansion, cycle.polytropic_expansion,
                   usual.polytropic_expansion);
    visitor.number(field::heat, cycle.heat);
    visitor.number(field::imep, cycle.imep);
    visitor.number(field::combustion_start, cycle.combustion_start);
    visitor.number(field::combustion_duration, cycle.combustion_duration);
    visitor.number(field::wiebe_m, cycle.wiebe_m, usual.wiebe_m);
    visitor.number(field::ports_open, cycle.ports_open, usual.ports_open);
}

/// Two numbers from 1 or two headings.
struct ColumnsValue final : FieldVisitor::Custom {
    explicit ColumnsValue(TableReading& it) : reading(it) {}
    void read(const Json& value, const std::string& pointer) override {
        constexpr Text rule = Text::tr(
            "must be two numbers from 1 or two headings: of the crank "
            "angle and of the value");
        if (!value.is_array() || value.size() != reading.columns.size()) {
            throw InputError(pointer, rule, show(value));
        }
        for (std::size_t i = 0; i < value.size(); ++i) {
            const int number = value[i].is_number_integer() ? value[i].get<int>() : -1;
            const bool is_number = number >= static_cast<int>(i) && number <= 1000;
            const bool is_heading =
                value[i].is_string() && !value[i].get_ref<const std::string&>().empty();
            if (!is_number && !is_heading) {
                throw InputError(pointer + "/" + std::to_string(i), rule, show(value[i]));
            }
            reading.columns[i] = is_number ? value[i].dump() : value[i].get<std::string>();
        }
    }
    Json write() override {
        if (reading.columns[0].empty()) {
            return {};
        }
        Json list = Json::array();
        for (const std::string& column : reading.columns) {
            int number = 0;
            const char* const end = column.data() + column.size();
            const auto [stop, fault] = std::from_chars(column.data(), end, number);
            list.push_back(fault == std::errc{} && stop == end ? Json(number) : Json(column));
        }
        return list;
    }
    TableReading& reading;
};

/// As who has no dot on the keyboard writes it: "kNm" for kN·m.
std::string without_dots(std::string_view unit) {
    constexpr std::string_view dot = "·";
    std::string text(unit);
    for (std::size_t at = text.find(dot); at != std::string::npos; at = text.find(dot, at)) {
        text.erase(at, dot.size());
    }
    return text;
}

/// The unit alone; what else may be in a heading is none.
struct UnitValue final : FieldVisitor::Custom {
    UnitValue(TableReading& it, Measured what) : reading(it), measured(what) {}
    void read(const Json& value, const std::string& pointer) override {
        const std::vector<Unit> units = units_of(measured);
        const auto is_it = [&](const Unit& unit) {
            return value.is_string() &&
                   without_dots(value.get_ref<const std::string&>()) == without_dots(unit.name);
        };
        const auto found = std::find_if(units.begin(), units.end(), is_it);
        if (found == units.end()) {
            std::vector<std::string> names;
            for (const Unit& unit : units) {
                names.emplace_back(unit.name);
            }
            throw InputError(pointer, {Text::tr("must be one of %1"), quoted_list(names)},
                             show(value));
        }
        reading.unit = *found;
    }
    Json write() override { return reading.unit ? Json(std::string(reading.unit->name)) : Json(); }
    TableReading& reading;
    Measured measured;
};

struct GaugeValue final : FieldVisitor::Custom {
    explicit GaugeValue(TableReading& it) : reading(it) {}
    void read(const Json& value, const std::string& pointer) override {
        if (!value.is_boolean()) {
            throw InputError(pointer, Text::tr("must be true or false"), show(value));
        }
        reading.gauge = value.get<bool>();
    }
    Json write() override { return reading.gauge ? Json(*reading.gauge) : Json(); }
    TableReading& reading;
};

void visit_file(FieldVisitor& visitor, DataFile& file, Measured what) {
    visitor.text(field::csv, file.name);
    visitor.optional_text(field::csv_sum, file.sum_then);
    ColumnsValue columns(file.reading);
    visitor.custom(field::csv_columns, false, columns);
    UnitValue unit(file.reading, what);
    visitor.custom(field::csv_unit, false, unit);
    if (what == Measured::pressure) {
        GaugeValue gauge(file.reading);
        visitor.custom(field::csv_gauge, false, gauge);
    }
}

/// @param several   whether the object may have more than one
/// @param is_there  of a kind, for other visitors than the reader
/// @return how many it has
int visit_sources(FieldVisitor& visitor, TorqueSource& source, bool several,
                  const std::function<bool(TorqueSource::Kind)>& is_there) {
    using Kind = TorqueSource::Kind;
    const auto visit_crankcase = [&] {
        visitor.number(field::crankcase_pressure, source.crankcase_pressure,
                       TorqueSource{}.crankcase_pressure);
    };
    const auto has = [&](const Field& field, Kind kind) {
        return visitor.has(field.key, is_there(kind));
    };
    const bool angles = has(field::table_angle, Kind::table);
    const bool table = has(field::table_torque, Kind::table) || angles;
    const bool csv = has(field::csv, Kind::csv);
    const bool pressure = has(field::pressure, Kind::pressure);
    const bool cycle = has(field::cycle, Kind::cycle);
    const int given = table + csv + pressure + cycle;
    if (visitor.is_reading() && !several) {
        if (given != 1) {
            return given;  // a misspelt key is named first
        }
        source.kind = csv        ? Kind::csv
                      : pressure ? Kind::pressure
                      : cycle    ? Kind::cycle
                                 : Kind::table;
    }
    if (table) {
        visitor.numbers(field::table_angle, source.table.crank_angle_deg);
        visitor.numbers(field::table_torque, source.table.torque);
    }
    if (csv) {
        visit_file(visitor, source.csv, Measured::torque);
    }
    if (pressure) {
        visitor.object_of(field::pressure, true, true, [&] {
            visit_file(visitor, source.trace_file, Measured::pressure);
            visitor.number(field::trace_shift, source.trace_shift, 0.0);
            visit_crankcase();
        });
    }
    if (cycle) {
        visitor.object_of(field::cycle, true, true, [&] {
            visit_crankcase();
            visit_cycle(visitor, source.cycle);
        });
    }
    return given;
}

void visit_torque(FieldVisitor& visitor, TorqueSource& source) {
    int given = 0;
    visitor.object_of(field::torque, true, true, [&] {
        given = visit_sources(visitor, source, false,
                              [&](TorqueSource::Kind kind) { return source.kind == kind; });
    });
    if (visitor.is_reading() && given != 1) {
        throw InputError(
            "/input/torque",
            {Text::tr("must have one of: %1 with %2, %3, %4, %5"), field::table_angle.key,
             field::table_torque.key, field::csv.key, field::pressure.key, field::cycle.key},
            given == 0 ? Text::tr("none of them") : Text::tr("more than one of them"));
    }
}

}  // namespace

bool TorqueSource::keeps(Kind other) const {
    const bool has_file = !csv.name.empty();
    switch (other) {
        case Kind::csv:
            return is_computed() && has_file;
        case Kind::table:
            return is_computed() && !has_file && table.size() > 0;
        case Kind::pressure:
            return kind != other && !trace_file.name.empty();
        case Kind::cycle:
            return kind != other && (cycle.heat || cycle.imep);
    }
    return false;
}

void visit_kept(FieldVisitor& visitor, TorqueSource& source) {
    using Kind = TorqueSource::Kind;
    const auto is_kept = [&](Kind kind) { return source.keeps(kind); };
    const bool any = std::ranges::any_of(
        std::array{Kind::table, Kind::csv, Kind::pressure, Kind::cycle}, is_kept);
    visitor.object_of(field::torque, false, any,
                      [&] { visit_sources(visitor, source, true, is_kept); });
}

void visit_fields(FieldVisitor& visitor, CylinderSizes& sizes) {
    visitor.number(field::bore, sizes.bore);
    visitor.number(field::rod_length, sizes.rod_length);
    visitor.number(field::offset, sizes.offset, CylinderSizes{}.offset,
                   FieldVisitor::Written::always);
}

void visit_fields(FieldVisitor& visitor, EnvelopeSizes& sizes) {
    visitor.number(field::cylinder_top, sizes.cylinder_top);
    visitor.number(field::cylinder_bottom, sizes.cylinder_bottom);
    visitor.number(field::cylinder_wall, sizes.cylinder_wall);
    visitor.number(field::rod_width, sizes.rod_width);
    visitor.number(field::crank_swing_radius, sizes.crank_swing_radius);
    visitor.number(field::shaft_swing_radius, sizes.shaft_swing_radius);
    visitor.number(field::gear_tip_radius, sizes.gear_tip_radius);
    visitor.number(field::clearance, sizes.clearance, EnvelopeSizes{}.clearance);
    visitor.number(field::wall, sizes.wall, 0.0);
}

void visit_fields(FieldVisitor& visitor, PlaceLimits& limits) {
    visitor.number(field::centre_distance_min, limits.centre_distance_min);
    visitor.number(field::centre_distance_max, limits.centre_distance_max);
    visitor.number(field::shaft_angle_from, limits.shaft_angle_from);
    visitor.number(field::shaft_angle_to, limits.shaft_angle_to);
    visitor.number(field::place_left, limits.left);
    visitor.number(field::place_right, limits.right);
    visitor.number(field::place_bottom, limits.bottom);
    visitor.number(field::place_top, limits.top);
}

void visit_fields(FieldVisitor& visitor, GearPair& gears) {
    constexpr GearPair usual;
    visitor.integer(field::teeth, gears.teeth, usual.teeth);
    visitor.integer(field::shifted_teeth, gears.shifted_teeth, usual.shifted_teeth);
    visitor.number(field::backlash, gears.backlash, usual.backlash);
}

void visit_fields(FieldVisitor& visitor, FlywheelTarget& flywheel) {
    visitor.number(field::flywheel_inertia, flywheel.inertia);
    visitor.number(field::fluctuation, flywheel.fluctuation);
}

void visit_fields(FieldVisitor& visitor, SpeedBand& band) {
    visitor.number(field::band_from, band.from);
    visitor.number(field::band_to, band.to);
    visitor.integer(field::band_speeds, band.speeds, SpeedBand{}.speeds);
    visitor.flag(field::band_map, band.map, false);
}

void visit_fields(FieldVisitor& visitor, RelievedShaftSizes& sizes) {
    visitor.number(field::bar_diameter, sizes.diameter);
    visitor.number(field::relief_depth, sizes.depth);
    visitor.number(field::relief_length, sizes.length);
    visitor.number(field::density, sizes.density, RelievedShaftSizes{}.density);
    if (visitor.is_reading()) {
        for (const std::string_view key : field::bending_keys) {
            sizes.had_bending = visitor.has(key, false) || sizes.had_bending;
        }
    }
}

void visit_fields(FieldVisitor& visitor, Input& input) {
    using Written = FieldVisitor::Written;
    const int speed =
        visitor.one_of({field::speed.key, field::angular_speed.key}, input.speed_in_rpm ? 0 : 1);
    if (speed != 1) {
        visitor.number(field::speed, input.angular_speed);
    }
    if (speed != 0) {
        visitor.number(field::angular_speed, input.angular_speed);
    }
    if (visitor.is_reading()) {
        input.speed_in_rpm = speed == 0;
    }
    visitor.number(field::crank_radius, input.crank_radius);
    visitor.object_of(field::cylinder, false, true, [&] { visit_fields(visitor, input.cylinder); });
    visit_masses(visitor, input);
    visitor.number(field::counterweight_radius, input.counterweight_radius);
    visitor.number(field::counterweight_mass, input.counterweight_mass);
    visitor.number(field::centre_distance, input.centre_distance);
    visitor.number(field::shaft_angle, input.shaft_angle);
    visitor.integer(field::strokes, input.strokes, 4);
    visit_torque(visitor, input.torque);
    visitor.choice(field::interpolation, input.interpolation, Interpolation::linear,
                   Written::always);
    visitor.number(field::step, input.step_deg, 1.0, Written::always);
    visitor.number(field::rod_mass, input.rod_mass);
    visitor.number(field::crank_share, input.crank_share, 0.5);
    visitor.object_with_defaults(field::gears, input.gears);
    visitor.object_with_defaults(field::envelope, input.envelope);
    visitor.object_with_defaults(field::place_limits, input.place_limits);
    visitor.object(field::relieved_shaft, input.relieved_shaft);
    visitor.object(field::flywheel, input.flywheel);
    visitor.object(field::speed_band, input.speed_band);
}

}  // namespace ravnoves::balance_shaft
