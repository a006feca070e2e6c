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
/// the file as it is now.
template <typename Parse>
auto read_beside(const std::string& name, const std::string& place, const CaseContext& context,
                 FileSum& sum, Parse parse) {
    if (name.find('\0') != std::string::npos || name.empty()) {
        throw InputError(place, CORE_TEXT("core", "must be a file name"), show(Json(name)));
    }
    if (!context.may_read(name)) {
        throw InputError(place,
                         CORE_TEXT("core",
                                   "must be a file in the folder of the case, unless "
                                   "--allow-files is given"),
                         show(Json(name)));
    }
    try {
        const std::string text = read_text_file(context.directory / name);
        sum.now = sha256(text);
        if (sum.then.empty()) {
            sum.then = sum.now;
        }
        return parse(text);
    } catch (const InputError& error) {
        throw InputError::in_file(place, printable(name), error);
    }
}

/// The strokes say how long a cycle of a file with more than one is.
TableReading with_strokes(TableReading reading, int strokes) {
    reading.strokes = strokes;
    return reading;
}

void read_table(TorqueSource& source, const std::string& place, const CaseContext& context,
                int strokes) {
    source.table =
        read_beside(source.csv, place, context, source.csv_sum, [&](const std::string& text) {
            return parse_torque_table(text, with_strokes(source.csv_reading, strokes)).table;
        });
}

void read_trace(TorqueSource& source, const std::string& place, const CaseContext& context,
                int strokes) {
    source.trace = read_beside(
        source.trace_csv, place, context, source.trace_sum, [&](const std::string& text) {
            return parse_pressure_trace(text, with_strokes(source.trace_reading, strokes)).trace;
        });
}

}  // namespace

Input read_input(const Json& json, const CaseContext& context) {
    Input input = read_fields<Input>(json);
    TorqueSource& source = input.torque;
    if (source.kind == TorqueSource::Kind::csv) {
        read_table(source, "/input/torque/csv", context, input.strokes);
    } else if (source.kind == TorqueSource::Kind::pressure) {
        read_trace(source, "/input/torque/pressure/csv", context, input.strokes);
    }
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
    if (source.is_computed() && !source.csv.empty()) {
        keep(Kind::csv);
    } else if (source.is_computed() && source.table.size() > 0) {
        keep(Kind::table);
    }
    if (source.kind != Kind::pressure && !source.trace_csv.empty()) {
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
                source.csv_sum = other.csv_sum;
                source.csv_reading = other.csv_reading;
                read_table(source, "/kept/torque/csv", context, input.strokes);
            } else if (other.kind == Kind::pressure) {
                source.trace_csv = other.trace_csv;
                source.trace_sum = other.trace_sum;
                source.trace_reading = other.trace_reading;
                source.trace_shift = other.trace_shift;
                read_trace(source, "/kept/torque/pressure/csv", context, input.strokes);
            } else if (other.kind == Kind::table) {
                source.table = other.table;
            } else {
                source.cycle = other.cycle;
            }
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
