#include "v8-plugs/fields.h"

#include <algorithm>

#include "case-file/field_visitor.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "v8-plugs/presets.h"

namespace ravnoves::v8_plugs {

namespace {

/// The engine's values of an object. In the groups of plugs that an engine may lack, null says that
/// there is no such plug.
void read_engine_values(ObjectReader& reader, Engine& engine) {
    const auto is_null = [&](const EngineField& each) {
        return reader.has(each.field.key) && reader.raw(each.field.key).is_null();
    };
    for (const EngineGroup group : {EngineGroup::aluminium_plug, EngineGroup::new_plug}) {
        std::string_view null_key;
        std::string_view given;
        for (const EngineField& each : engine_fields()) {
            if (each.group == group && is_null(each)) {
                null_key = each.field.key;
            } else if (each.group == group && reader.has(each.field.key) && given.empty()) {
                given = each.field.key;
            }
        }
        if (!null_key.empty() && !given.empty()) {
            throw InputError(reader.pointer_to(given),
                             {Text::tr("must be null or left out where %1 is null"), null_key},
                             show(reader.raw(given)));
        }
        if (!null_key.empty()) {
            set_plugs(engine, group, false);
        }
    }
    for (const EngineField& each : engine_fields()) {
        if (!is_inapplicable(engine, each.group) && reader.has(each.field.key)) {
            engine.*each.member = reader.si(each.field);
        }
    }
}

Json write_engine_values(const Engine& engine, const Engine& unless_equal) {
    Json json = Json::object();
    for (const auto& [field, member, group] : engine_fields()) {
        const std::string key(field.key);
        if (is_inapplicable(engine, group)) {
            if (!is_inapplicable(unless_equal, group)) {
                json[key] = nullptr;
            }
        } else if (engine.*member && engine.*member != unless_equal.*member) {
            json[key] = from_si(field, *(engine.*member));
        }
    }
    return json;
}

/// The preset that the engine is written as, with overrides; null where it is written out: an
/// override can replace a value but not remove one.
const Engine* written_preset(const Input& input) {
    const Engine* preset = find_preset(input.preset);
    const auto can_say = [&](const EngineField& each) {
        return input.engine.*each.member || !(preset->*each.member) ||
               is_inapplicable(input.engine, each.group);
    };
    const auto fields = engine_fields();
    return preset != nullptr && std::all_of(fields.begin(), fields.end(), can_say) ? preset
                                                                                   : nullptr;
}

/// "engine": the name of a preset, or an object with the values.
struct EngineValue final : FieldVisitor::Custom {
    explicit EngineValue(Input& it) : input(it) {}

    void read(const Json& value, const std::string& pointer) override {
        if (!value.is_string()) {
            ObjectReader object(value, pointer);
            input.engine.name = object.text("name", "");
            read_engine_values(object, input.engine);
            object.finish();
            return;
        }
        const Engine* preset = find_preset(value.get_ref<const std::string&>());
        if (preset == nullptr) {
            std::vector<std::string> names;
            for (const Engine& engine : engine_presets()) {
                names.push_back(engine.name);
            }
            throw InputError(
                pointer, {Text::tr("must be an engine object or one of %1"), quoted_list(names)},
                show(value));
        }
        input.preset = preset->name;
        input.engine = *preset;
    }
    Json write() override {
        if (const Engine* preset = written_preset(input)) {
            return preset->name;
        }
        Json engine = Json::object();
        if (!input.engine.name.empty()) {
            engine["name"] = input.engine.name;
        }
        engine.update(write_engine_values(input.engine, Engine{}));
        return engine;
    }

    Input& input;
};

/// "engine_overrides": values that differ from the preset's.
struct EngineOverrides final : FieldVisitor::Custom {
    explicit EngineOverrides(Input& it) : input(it) {}

    void read(const Json& value, const std::string& pointer) override {
        if (input.preset.empty()) {
            throw InputError(pointer,
                             Text::tr("is allowed only where engine is the name of a preset"));
        }
        ObjectReader overrides(value, pointer);
        read_engine_values(overrides, input.engine);
        overrides.finish();
    }
    Json write() override {
        const Engine* preset = written_preset(input);
        Json values = preset != nullptr ? write_engine_values(input.engine, *preset) : Json();
        return values.empty() ? Json() : values;
    }

    Input& input;
};

/// A thread by its name.
struct ThreadValue final : FieldVisitor::Custom {
    explicit ThreadValue(std::optional<Thread>& it) : thread(it) {}

    void read(const Json& value, const std::string& pointer) override {
        if (!value.is_string()) {
            throw InputError(pointer, Text::tr("must be a text"), show(value));
        }
        thread = parse_thread(value.get_ref<const std::string&>(), pointer);
    }
    Json write() override { return thread ? Json(thread_name(*thread)) : Json(); }

    std::optional<Thread>& thread;
};

}  // namespace

void visit_fields(FieldVisitor& visitor, PlugSheet& sheet) {
    ThreadValue thread(sheet.thread);
    visitor.custom(field::thread, true, thread);
    visitor.required(field::plug_height, sheet.height);
    visitor.number(field::bore_diameter, sheet.bore_diameter);
    visitor.number(field::bore_depth, sheet.bore_depth);
    visitor.number(field::cutter_diameter, sheet.cutter_diameter);
    visitor.number(field::minimum_wall, sheet.minimum_wall);
    visitor.number(field::minimum_bottom, sheet.minimum_bottom);
    visitor.number(field::steel_density, sheet.steel_density, steel_density);
    visitor.number(field::aluminium_density, sheet.aluminium_density, aluminium_density);
}

void visit_plugs(FieldVisitor& visitor, Input& input, bool weighed) {
    if (!visitor.is_reading()) {
        // Forms and checks see the engine's values, wherever they come from. The file may have its
        // name instead: what follows is written over them.
        visitor.object_of(field::engine, true, true, [&] {
            for (const EngineField& each : engine_fields()) {
                if (!is_inapplicable(input.engine, each.group)) {
                    visitor.required(each.field, input.engine.*each.member);
                }
            }
        });
    }
    EngineValue engine(input);
    visitor.custom(field::engine, true, engine);
    if (!visitor.is_reading() && visitor.has(field::engine_overrides.key, false)) {
        // A list of all that a case may have.
        visitor.object_of(field::engine_overrides, false, false, [&] {
            for (const EngineField& each : engine_fields()) {
                visitor.number(each.field, input.engine.*each.member);
            }
        });
    }
    EngineOverrides overrides(input);
    visitor.custom(field::engine_overrides, false, overrides);
    visitor.choice(field::process, input.process);
    visitor.choice(field::crankshaft, input.crankshaft, Crankshaft::standard);
    const bool typed = visitor.has(field::mass_changes.key, input.has_typed_changes());
    if (visitor.is_reading()) {
        input.changes_given = typed;
    }
    visitor.object_of(field::mass_changes, false, typed, [&] {
        for (const MassChangeField& each : mass_change_fields()) {
            visitor.number(each.field, input.typed_changes.*each.member, 0.0,
                           FieldVisitor::Written::always);
        }
    });
    if (visitor.is_reading() || weighed) {
        visitor.choice(field::changes_source, input.changes_from_weigh_in, weighed && !typed,
                       FieldVisitor::Written::always);
    }
    visitor.number(field::tolerance, input.tolerance, default_tolerance,
                   FieldVisitor::Written::always);
    visitor.object(field::plug, input.plug);
}

}  // namespace ravnoves::v8_plugs
