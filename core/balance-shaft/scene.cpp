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
    using Kind = TorqueSource::Kind;
    const TorqueSource& source = input.torque;
    Json torque = Json::object();
    const auto keep = [&](Kind kind) {
        Input other = input;
        other.torque.kind = kind;
        torque.update(write_input(other).at("torque"));
    };
    if (source.is_computed() && !source.csv.name.empty()) {
        keep(Kind::csv);
    } else if (source.is_computed() && source.table.size() > 0) {
        keep(Kind::table);
    }
    if (source.kind != Kind::pressure && !source.trace_file.name.empty()) {
        keep(Kind::pressure);
    }
    if (source.kind != Kind::cycle && (source.cycle.heat || source.cycle.imep)) {
        keep(Kind::cycle);
    }
    return torque.empty() ? Json() : Json{{"torque", torque}};
}

namespace {

/// One kept source, read as if it were in use; files are not read.
TorqueSource read_kept_source(const Input& input, const Json& torque) {
    Json json = write_input(input);
    json["torque"] = torque;
    try {
        TorqueSource source = read_fields<Input>(json).torque;
        if (source.kind == TorqueSource::Kind::table) {
            check_torque_table(source.table, "/input/torque/torque_Nm");
        }
        return source;
    } catch (const InputError& error) {
        std::string place = error.where();
        const std::string root = "/input";
        if (place.starts_with(root)) {
            place.replace(0, root.size(), "/kept");
        }
        throw InputError(place, error.allowed_message(), error.found_message());
    }
}

}  // namespace

void read_kept(const Json& kept, const CaseContext& context, Input& input) {
    using Kind = TorqueSource::Kind;
    if (kept.is_null()) {
        return;
    }
    ObjectReader reader(kept, "/kept");
    if (!reader.has("torque")) {
        reader.finish();
        return;
    }
    const auto keys = reader.object("torque").keys();
    reader.finish();
    TorqueSource& source = input.torque;
    const auto take = [&](const Json& torque) {
        const TorqueSource other = read_kept_source(input, torque);
        // Of the source in use the input's own numbers hold.
        if (other.is_computed() ? other.kind == source.kind : !source.is_computed()) {
            return;
        }
        if (other.is_computed() && !source.is_computed()) {
            source.crankcase_pressure = other.crankcase_pressure;
        }
        // A file that is not there may come back; until then its numbers are missing.
        try {
            if (other.kind == Kind::csv) {
                source.csv = other.csv;
            } else if (other.kind == Kind::pressure) {
                source.trace_file = other.trace_file;
                source.trace_shift = other.trace_shift;
            } else if (other.kind == Kind::table) {
                source.table = other.table;
            } else {
                source.cycle = other.cycle;
            }
            read_file(source, other.kind, "/kept", context, input.strokes);
        } catch (const InputError&) {
            // It is named still.
        }
    };
    Json table = Json::object();
    Json file = Json::object();
    for (const std::string& key : keys) {
        const Json& value = kept.at("torque").at(key);
        if (key == field::pressure.key || key == field::cycle.key) {
            take({{key, value}});
        } else {
            const bool is_of_table =
                key == field::table_angle.key || key == field::table_torque.key;
            (is_of_table ? table : file)[key] = value;
        }
    }
    if (!file.empty()) {
        take(file);
    }
    if (!table.empty()) {
        take(table);
    }
}

}  // namespace ravnoves::balance_shaft
