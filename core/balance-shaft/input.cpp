#include "balance-shaft/input.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include "balance-shaft/engine_torque.h"
#include "balance-shaft/fields.h"
#include "case-file/decimal.h"
#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"
#include "case-file/object_reader.h"
#include "case-file/text_file.h"

namespace ravnoves::balance_shaft {

namespace {

std::string pointer(const Field& field, const std::string& parent = "/input") {
    return parent + "/" + std::string(field.key);
}

Number shown(const Field& field, double si) {
    return {rounded_to_digits(from_si(field, si), 12), field.unit};
}

Number shown_bound(const Field& field, double limit, double found) {
    return bound(from_si(field, limit), from_si(field, found), field.unit);
}

void check_masses(const Input& input) {
    const double sum = input.reciprocating_mass();
    if (!(sum > 0.0) || !std::isfinite(sum)) {
        throw InputError(pointer(field::reciprocating_masses),
                         Text::tr("must add up to more than 0 and to a finite mass"), Number{sum});
    }
    for (const NamedMass& part : input.reciprocating_masses) {
        if (part.name == "rod_small_end" && input.rod_mass && part.mass > *input.rod_mass) {
            throw InputError(
                pointer(field::reciprocating_masses) + "/" + part.name,
                {Text::tr("must be at most the mass of the whole rod, %1"), *input.rod_mass},
                Number{part.mass});
        }
    }
}

/// The ports of a two-stroke engine: closed while it burns, open at the bottom dead centre.
void check_ports(const GasCycle& cycle, double bottom, const std::string& parent) {
    const auto angle = [](double radians) {
        return Number{radians / units::degree, units::degree, 6};
    };
    if (!(cycle.ports_open < bottom)) {
        throw InputError(
            pointer(field::ports_open, parent),
            {Text::tr("must be less than the angle of the bottom dead centre, %1"), angle(bottom)},
            angle(cycle.ports_open));
    }
    const double end = cycle.combustion_start + cycle.combustion_duration;
    const double opening = two_pi + cycle.ports_open;
    if (end > opening) {
        throw InputError(
            pointer(field::combustion_duration, parent),
            {Text::tr("must end the combustion before the ports open at %1"), angle(opening)},
            angle(end));
    }
    // As far before the dead centre as they open after it, but for the offset of the cylinder.
    const double closing = 2.0 * bottom - cycle.ports_open;
    if (cycle.combustion_start < closing) {
        throw InputError(pointer(field::combustion_start, parent),
                         {Text::tr("must be after the ports have closed, %1"), angle(closing)},
                         angle(cycle.combustion_start));
    }
}

void check_cycle(const GasCycle& cycle, const SliderCrank<double>& crank, int strokes,
                 const std::string& parent) {
    if (cycle.heat.has_value() == cycle.imep.has_value()) {
        throw InputError(parent,
                         {Text::tr("must have either %1 or %2"), field::heat.key, field::imep.key},
                         cycle.heat ? Text::tr("both") : Text::tr("neither"));
    }
    const double end = cycle.combustion_start + cycle.combustion_duration;
    const double bottom = two_pi + crank.bottom_dead_centre() - crank.top_dead_centre();
    if (strokes == 2) {
        check_ports(cycle, bottom - two_pi, parent);
    } else if (end > bottom) {
        throw InputError(pointer(field::combustion_duration, parent),
                         {Text::tr("must end the combustion before the bottom dead centre at %1"),
                          Number{bottom / units::degree, units::degree, 6}},
                         Number{end / units::degree, units::degree, 6});
    }
}

/// The rows of a table or trace must span the cycle that the strokes give.
void check_strokes(const Input& input) {
    const int wanted = input.strokes_of_torque();
    if (wanted != input.strokes) {
        throw InputError(pointer(field::strokes),
                         {input.torque.kind == TorqueSource::Kind::pressure
                              ? Text::tr("must be %1, since the pressure trace spans %2")
                              : Text::tr("must be %1, since the torque table spans %2"),
                          wanted, Number{180.0 * wanted, units::degree}},
                         Number{1.0 * input.strokes});
    }
}

/// The crank must turn round.
void check_rod(const Input& input) {
    const std::string parent = pointer(field::cylinder);
    const double offset = input.cylinder.offset;
    const double minimum = input.crank_radius + std::abs(offset);
    if (!(input.effective_rod_length() > minimum * (1.0 + 1e-9))) {
        if (!input.cylinder.rod_length) {
            throw InputError(
                pointer(field::offset, parent),
                {Text::tr("must be less than %1 in magnitude, the rod length minus crank radius"),
                 shown_bound(field::offset, input.effective_rod_length() - input.crank_radius,
                             offset)},
                shown(field::offset, offset));
        }
        throw InputError(pointer(field::rod_length, parent),
                         {Text::tr("must be greater than the crank radius plus the offset, %1"),
                          shown_bound(field::rod_length, minimum, input.effective_rod_length())},
                         shown(field::rod_length, input.effective_rod_length()));
    }
}

void check_torque(const Input& input) {
    const TorqueSource& source = input.torque;
    if (!source.is_computed()) {
        check_torque_table(source.table, pointer(field::torque));
        check_strokes(input);
        return;
    }
    const std::string cylinder = pointer(field::cylinder);
    for (const auto& [field, size] : {std::pair(&field::bore, input.cylinder.bore),
                                      std::pair(&field::rod_length, input.cylinder.rod_length)}) {
        if (!size) {
            throw InputError(pointer(*field, cylinder),
                             {Text::tr("is required with a pressure trace or a computed cycle, "
                                       "and missing")});
        }
    }
    // Beyond these no cylinder exists, and pressures and powers of volumes leave double's range.
    constexpr Range displacement_range = Range::between(1e-12, 1e3);
    const SliderCrank<double> crank = slider_crank(input);
    const double bore = *input.cylinder.bore;
    const double displacement = pi / 4.0 * bore * bore * crank.stroke();
    if (!displacement_range.contains(displacement)) {
        throw InputError(pointer(field::bore, cylinder),
                         Text::tr("must give a displacement from 1e-6 cm³ to 1e9 cm³"),
                         Number{displacement / units::cm3, units::cm3, 6});
    }
    if (source.kind == TorqueSource::Kind::pressure) {
        check_pressure_trace(source.trace,
                             pointer(field::csv, pointer(field::pressure, pointer(field::torque))));
        check_strokes(input);
    } else {
        check_cycle(source.cycle, crank, input.strokes,
                    pointer(field::cycle, pointer(field::torque)));
    }
}

}  // namespace

double Input::reciprocating_mass() const {
    double sum = 0.0;
    for (const NamedMass& part : reciprocating_masses) {
        sum += part.mass;
    }
    return sum;
}

double Input::counterweight() const {
    return counterweight_mass.value_or(reciprocating_mass() * crank_radius /
                                       (2.0 * counterweight_radius));
}

int Input::strokes_of_torque() const {
    return torque.kind == TorqueSource::Kind::cycle ? strokes
           : torque.is_computed()                   ? strokes_of(torque.trace.crank_angle_deg)
                                                    : strokes_of(torque.table.crank_angle_deg);
}

double Input::effective_bore() const {
    return cylinder.bore.value_or(2.0 * crank_radius);
}

double Input::effective_rod_length() const {
    return cylinder.rod_length.value_or(crank_radius / default_lambda);
}

void check_speed_band(const SpeedBand& band) {
    const std::string parent = pointer(field::speed_band);
    check_fields(band, parent.c_str());
    if (band.to < band.from) {
        throw InputError(pointer(field::band_to, parent),
                         {Text::tr("must be at least the minimum speed of the band, %1"),
                          shown(field::band_from, band.from)},
                         shown(field::band_to, band.to));
    }
}

void check_input(const Input& input) {
    check_fields(input);
    check_joined(input);
}

void check_joined(const Input& input) {
    check_masses(input);
    check_rod(input);
    check_torque(input);
    if (input.flywheel &&
        input.flywheel->inertia.has_value() == input.flywheel->fluctuation.has_value()) {
        throw InputError(pointer(field::flywheel),
                         {Text::tr("must have either %1 or %2"), field::flywheel_inertia.key,
                          field::fluctuation.key},
                         input.flywheel->inertia ? Text::tr("both") : Text::tr("neither"));
    }
    const GearPair& gears = input.gears;
    if (std::abs(gears.shifted_teeth) >= gears.teeth) {
        throw InputError(pointer(field::shifted_teeth, pointer(field::gears)),
                         {Text::tr("must be less than the teeth, which must be from %1 to %2"),
                          field::teeth.range.min, field::teeth.range.max},
                         Number{1.0 * gears.shifted_teeth});
    }
    if (input.speed_band) {
        check_speed_band(*input.speed_band);
    }
    if (input.relieved_shaft) {
        check_relieved_shaft(*input.relieved_shaft);
    }
}

namespace {

/// Reads and parses a file that the case names, and takes its sum; a case without one is made with
/// the file as it is now. The strokes say how long a cycle of a file with more than one is.
ParsedCycle read_beside(Measured what, DataFile& file, const std::string& place,
                        const CaseContext& context, int strokes) {
    if (file.name.find('\0') != std::string::npos || file.name.empty()) {
        throw InputError(place, Text::tr("must be a file name"), show(Json(file.name)));
    }
    if (!context.may_read(file.name)) {
        throw InputError(place,
                         Text::tr("must be a file in the folder of the case, unless "
                                  "--allow-files is given"),
                         show(Json(file.name)));
    }
    try {
        const std::string text = read_text_file(context.directory / file.name);
        file.sum_now = sha256(text);
        if (file.sum_then.empty()) {
            file.sum_then = file.sum_now;
        }
        TableReading reading = file.reading;
        reading.strokes = strokes;
        return parse_cycle(what, text, reading);
    } catch (const InputError& error) {
        throw InputError::in_file(place, printable(file.name), error);
    }
}

/// Reads the file of a source.
void read_file(TorqueSource& source, TorqueSource::Kind kind, const std::string& root,
               const CaseContext& context, int strokes) {
    if (kind == TorqueSource::Kind::csv) {
        source.table =
            read_beside(Measured::torque, source.csv, root + "/torque/csv", context, strokes).table;
    } else if (kind == TorqueSource::Kind::pressure) {
        source.trace = read_beside(Measured::pressure, source.trace_file,
                                   root + "/torque/pressure/csv", context, strokes)
                           .trace;
    }
}

}  // namespace

Input read_input(const Json& json, const CaseContext& context) {
    Input input = read_fields<Input>(json);
    read_file(input.torque, input.torque.kind, "/input", context, input.strokes);
    check_input(input);
    return input;
}

Json write_input(const Input& input) {
    return write_fields(input);
}

Json write_kept(const Input& input) {
    TorqueSource source = input.torque;
    const VisitFields visit = [&](FieldVisitor& visitor) { visit_kept(visitor, source); };
    Json kept = write_fields(visit);
    return kept.empty() ? Json() : kept;
}

void read_kept(const Json& kept, const CaseContext& context, Input& input) {
    using Kind = TorqueSource::Kind;
    if (kept.is_null()) {
        return;
    }
    TorqueSource other;
    try {
        read_fields(kept, Completeness::required,
                    [&](FieldVisitor& visitor) { visit_kept(visitor, other); });
    } catch (const InputError& error) {
        constexpr std::string_view root = "/input";
        throw InputError(error.where().replace(0, root.size(), "/kept"), error.allowed_message(),
                         error.found_message());
    }
    TorqueSource& source = input.torque;
    // A file that is not there may come back: it stays named, its numbers are missing.
    const auto take_file = [&](DataFile TorqueSource::*file, Kind kind) {
        source.*file = other.*file;
        try {
            read_file(source, kind, "/kept", context, input.strokes);
        } catch (const InputError&) {
        }
    };
    // Of the source in use the input's own numbers are right.
    if (!source.is_computed()) {
        source.crankcase_pressure = other.crankcase_pressure;
    } else if (!other.csv.name.empty()) {
        take_file(&TorqueSource::csv, Kind::csv);
    }
    if (!other.table.torque.empty()) {
        check_torque_table(other.table, "/kept/torque");
        source.table = source.is_computed() ? other.table : source.table;
    }
    if (source.kind != Kind::pressure && !other.trace_file.name.empty()) {
        source.trace_shift = other.trace_shift;
        take_file(&TorqueSource::trace_file, Kind::pressure);
    }
    if (source.kind != Kind::cycle && (other.cycle.heat || other.cycle.imep)) {
        source.cycle = other.cycle;
    }
}

}  // namespace ravnoves::balance_shaft
