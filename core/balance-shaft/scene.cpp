#include "balance-shaft/scene.h"

#include <filesystem>
#include <utility>

#include "balance-shaft/engine_torque.h"
#include "balance-shaft/fields.h"
#include "case-file/field_reader.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"
#include "case-file/object_reader.h"
#include "case-file/sha256.h"
#include "case-file/text_file.h"

namespace ravnoves::balance_shaft {

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
