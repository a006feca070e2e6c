#include "v8-plugs/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"
#include "numerics/constants.h"
#include "v8-plugs/presets.h"
#include "v8-plugs/solver.h"

namespace ravnoves::v8_plugs {

namespace {

constexpr double gram = 1e-3;
constexpr double millimetre = 1e-3;
constexpr double gram_millimetre = 1e-6;

template <typename Sheet>
struct SheetField {
    FieldSpec spec;
    std::optional<double> Sheet::*member;
    bool required;
};

constexpr std::array<SheetField<PlugSheet>, 6> plug_fields{{
    {plug_height_field, &PlugSheet::height, true},
    {bore_diameter_field, &PlugSheet::bore_diameter, false},
    {bore_depth_field, &PlugSheet::bore_depth, false},
    {cutter_diameter_field, &PlugSheet::cutter_diameter, false},
    {minimum_wall_field, &PlugSheet::minimum_wall, false},
    {minimum_bottom_field, &PlugSheet::minimum_bottom, false},
}};

constexpr std::array<SheetField<BalancingSheet>, 5> balancing_fields{{
    {grade_field, &BalancingSheet::grade, true},
    {rotor_mass_field, &BalancingSheet::rotor_mass, true},
    {service_speed_field, &BalancingSheet::service_speed, true},
    {front_reading_field, &BalancingSheet::front_reading, false},
    {rear_reading_field, &BalancingSheet::rear_reading, false},
}};

struct JobField {
    std::string_view key;
    std::string JobHeader::*member;
};
constexpr std::array<JobField, 6> job_fields{{{"engine_number", &JobHeader::engine_number},
                                              {"crankshaft_number", &JobHeader::crankshaft_number},
                                              {"customer", &JobHeader::customer},
                                              {"date", &JobHeader::date},
                                              {"technician", &JobHeader::technician},
                                              {"notes", &JobHeader::notes}}};

void set_group(Engine& engine, EngineGroup group, bool present) {
    if (group == EngineGroup::aluminium_plug) {
        engine.has_aluminium_plug = present;
    } else {
        engine.has_new_plug = present;
    }
    if (!present) {
        for (const EngineField& field : engine_fields()) {
            if (field.group == group) {
                (engine.*field.member).reset();
            }
        }
    }
}

/// Reads the engine's values into `engine`. In the groups of plugs that an engine may lack, null
/// says that there is no such plug.
void read_engine_values(ObjectReader& reader, Engine& engine) {
    for (const EngineGroup group : {EngineGroup::aluminium_plug, EngineGroup::new_plug}) {
        std::string_view null_key;
        for (const EngineField& field : engine_fields()) {
            if (field.group == group && reader.has(field.spec.key) &&
                reader.raw(field.spec.key).is_null()) {
                null_key = field.spec.key;
            }
        }
        if (null_key.empty()) {
            continue;
        }
        for (const EngineField& field : engine_fields()) {
            if (field.group == group && reader.has(field.spec.key) &&
                !reader.raw(field.spec.key).is_null()) {
                throw InputError(
                    reader.pointer_to(field.spec.key),
                    "must be null or left out where " + std::string(null_key) + " is null",
                    show(reader.raw(field.spec.key)));
            }
        }
        set_group(engine, group, false);
    }
    for (const EngineField& field : engine_fields()) {
        if (!is_inapplicable(engine, field.group) && reader.has(field.spec.key)) {
            engine.*field.member = reader.si(field.spec);
        }
    }
}

void check_engine(const Engine& engine, const std::string& pointer, const std::string& preset,
                  Completeness completeness) {
    if (completeness == Completeness::required) {
        const auto missing = missing_fields(engine, true);
        if (!missing.empty()) {
            throw InputError(pointer + "/" + std::string(missing.front()->spec.key),
                             preset.empty() ? "is required and missing"
                                            : "is required and missing: the preset \"" + preset +
                                                  "\" does not give it");
        }
    }
    if (completeness == Completeness::as_is) {
        return;
    }
    for (const EngineConflict& conflict : engine_conflicts(engine)) {
        throw InputError(pointer + "/" + std::string(conflict.key), conflict.allowed,
                         format_number(conflict.found));
    }
}

void read_engine(ObjectReader& reader, Input& input, Completeness completeness) {
    const Json& value = reader.raw("engine");
    if (value.is_string()) {
        const auto& name = value.get_ref<const std::string&>();
        const Engine* preset = find_preset(name);
        if (preset == nullptr) {
            std::string allowed = "must be an engine object or one of";
            for (const Engine& engine : engine_presets()) {
                allowed += (allowed.back() == 'f' ? " \"" : ", \"") + engine.name + "\"";
            }
            throw InputError(reader.pointer_to("engine"), allowed, show(value));
        }
        input.preset = preset->name;
        input.engine = *preset;
        if (reader.has("engine_overrides")) {
            ObjectReader overrides = reader.object("engine_overrides");
            read_engine_values(overrides, input.engine);
            overrides.finish();
        }
        check_engine(input.engine, reader.pointer_to("engine_overrides"), input.preset,
                     completeness);
        return;
    }
    if (reader.has("engine_overrides")) {
        throw InputError(reader.pointer_to("engine_overrides"),
                         "is allowed only where engine is the name of a preset");
    }
    ObjectReader object = reader.object("engine");
    input.engine.name = object.text("name", "");
    read_engine_values(object, input.engine);
    object.finish();
    check_engine(input.engine, object.pointer(), "", completeness);
}

WeighIn read_weigh_in(ObjectReader reader, Completeness completeness) {
    WeighIn sheet;
    if (reader.choice("cylinder_numbering", {"bank-by-bank", "alternating"}, "bank-by-bank") ==
        "alternating") {
        sheet.numbering = CylinderNumbering::alternating;
    }
    for (const Part part : all_parts) {
        if (!reader.has(part_key(part))) {
            continue;
        }
        PartColumn& column = sheet[part];
        ObjectReader object = reader.object(part_key(part));
        const FieldSpec nominal{"nominal_g", "g", part_mass_field.range, 1e-3};
        if (object.has(nominal.key) || completeness == Completeness::required) {
            column.nominal = object.si(nominal);
        }
        column.permitted_spread = object.optional_si(permitted_spread_field);
        const Json none = Json::array();
        const Json& masses =
            object.has(part_mass_field.key) || completeness == Completeness::required
                ? object.raw(part_mass_field.key)
                : none;
        const std::string pointer = object.pointer_to(part_mass_field.key);
        const bool eight = masses.is_array() && masses.size() == cylinder_count;
        if (!eight && &masses != &none) {
            throw InputError(pointer, "must be a list of 8 masses, one for each cylinder",
                             show(masses));
        }
        for (std::size_t i = 0; i < masses.size(); ++i) {
            const Json& mass = masses.at(i);
            const std::string at = pointer + "/" + std::to_string(i);
            if (mass.is_null() && completeness == Completeness::as_is) {
                continue;
            }
            if (!mass.is_number()) {
                throw InputError(at, "must be a number", show(mass));
            }
            if (!part_mass_field.range.contains(mass.get<double>())) {
                throw InputError(at, part_mass_field.range.describe(),
                                 format_number(mass.get<double>()));
            }
            column.mass[i] = mass.get<double>() * part_mass_field.to_si;
        }
        object.finish();
    }
    reader.finish();
    return sheet;
}

template <typename Sheet, std::size_t N>
void read_fields(ObjectReader& reader, const std::array<SheetField<Sheet>, N>& fields, Sheet& sheet,
                 Completeness completeness) {
    for (const SheetField<Sheet>& field : fields) {
        if (reader.has(field.spec.key) ||
            (field.required && completeness == Completeness::required)) {
            sheet.*field.member = reader.si(field.spec);
        }
    }
}

PlugSheet read_plug(ObjectReader reader, Completeness completeness) {
    PlugSheet sheet;
    if (reader.has("thread") || completeness == Completeness::required) {
        sheet.thread = parse_thread(reader.text("thread"), reader.pointer_to("thread"));
    }
    read_fields(reader, plug_fields, sheet, completeness);
    sheet.steel_density = reader.si(steel_density_field, steel_density);
    sheet.aluminium_density = reader.si(aluminium_density_field, aluminium_density);
    reader.finish();
    if (completeness == Completeness::required &&
        sheet.bore_diameter.has_value() != sheet.bore_depth.has_value()) {
        throw InputError(
            reader.pointer_to(sheet.bore_diameter ? bore_depth_field.key : bore_diameter_field.key),
            "is required where the bore's other size is given");
    }
    if (const auto geometry = sheet.geometry();
        geometry && completeness == Completeness::required) {
        if (const auto fault = geometry_fault(*geometry)) {
            throw InputError(reader.pointer(), "must be a plug that can exist: " + *fault);
        }
    }
    return sheet;
}

BalancingSheet read_balancing(ObjectReader reader, Completeness completeness) {
    BalancingSheet sheet;
    read_fields(reader, balancing_fields, sheet, completeness);
    sheet.front_share = reader.si(front_share_field, 0.5);
    reader.finish();
    return sheet;
}

JobHeader read_job(ObjectReader reader) {
    JobHeader job;
    for (const JobField& field : job_fields) {
        job.*field.member = reader.text(field.key, "");
    }
    reader.finish();
    return job;
}

template <typename Sheet, std::size_t N>
void write_fields(Json& json, const std::array<SheetField<Sheet>, N>& fields, const Sheet& sheet) {
    for (const SheetField<Sheet>& field : fields) {
        if (sheet.*field.member) {
            json[std::string(field.spec.key)] = in_unit(*(sheet.*field.member), field.spec);
        }
    }
}

Json write_engine_values(const Engine& engine, const Engine& unless_equal) {
    Json json = Json::object();
    for (const EngineField& field : engine_fields()) {
        const std::string key(field.spec.key);
        if (is_inapplicable(engine, field.group)) {
            if (!is_inapplicable(unless_equal, field.group)) {
                json[key] = nullptr;
            }
        } else if ((engine.*field.member) && engine.*field.member != unless_equal.*field.member) {
            json[key] = in_unit(*(engine.*field.member), field.spec);
        }
    }
    return json;
}

/// True where the preset with overrides can say what the engine is: an override can replace a
/// value but not remove one.
bool overrides_suffice(const Engine& engine, const Engine& preset) {
    return std::all_of(engine_fields().begin(), engine_fields().end(), [&](const EngineField& f) {
        return (engine.*f.member) || !(preset.*f.member) || is_inapplicable(engine, f.group);
    });
}

Json write_weigh_in(const WeighIn& sheet) {
    Json json = Json::object();
    json["cylinder_numbering"] =
        sheet.numbering == CylinderNumbering::alternating ? "alternating" : "bank-by-bank";
    for (const Part part : all_parts) {
        const PartColumn& column = sheet[part];
        if (column == PartColumn{}) {
            continue;
        }
        Json object = Json::object();
        if (column.nominal) {
            object["nominal_g"] = in_unit(*column.nominal, part_mass_field);
        }
        if (column.permitted_spread) {
            object[std::string(permitted_spread_field.key)] =
                in_unit(*column.permitted_spread, permitted_spread_field);
        }
        if (!column.is_empty()) {
            Json masses = Json::array();
            for (const auto& mass : column.mass) {
                masses.push_back(mass ? Json(in_unit(*mass, part_mass_field)) : Json());
            }
            object[std::string(part_mass_field.key)] = std::move(masses);
        }
        json[std::string(part_key(part))] = std::move(object);
    }
    return json;
}

Json write_plug(const PlugSheet& sheet) {
    Json json = Json::object();
    if (sheet.thread) {
        json["thread"] = thread_name(*sheet.thread);
    }
    write_fields(json, plug_fields, sheet);
    if (sheet.steel_density != steel_density) {
        json[std::string(steel_density_field.key)] = sheet.steel_density;
    }
    if (sheet.aluminium_density != aluminium_density) {
        json[std::string(aluminium_density_field.key)] = sheet.aluminium_density;
    }
    return json;
}

Json write_balancing(const BalancingSheet& sheet) {
    Json json = Json::object();
    write_fields(json, balancing_fields, sheet);
    if (sheet.front_share != 0.5) {
        json[std::string(front_share_field.key)] = sheet.front_share;
    }
    return json;
}

Json bob_weight_json(const BobWeight& weight) {
    Json lines = Json::array();
    for (const BobWeightLine& line : weight.lines) {
        lines.push_back({{"part", part_name(line.part)},
                         {"factor", line.factor},
                         {"mass_g", line.mass / gram},
                         {"product_g", line.product() / gram}});
    }
    return {{"sum_g", weight.sum() / gram}, {"lines", std::move(lines)}};
}

std::string_view limit_name(Boring::Limit limit) {
    switch (limit) {
        case Boring::Limit::none:
            return "none";
        case Boring::Limit::wall:
            return "wall";
        case Boring::Limit::bottom:
            return "bottom";
    }
    return "";
}

Json shift_json(double plug_mass, double shift, double crank_radius) {
    return {{"shift_mm", shift / millimetre},
            {"coefficient", shift_coefficient(shift, crank_radius)},
            {"unbalance_g_mm", shift_unbalance(plug_mass, shift) / gram_millimetre}};
}

Json boring_json(const Boring& boring, double plug_mass) {
    Json json{{"possible", boring.limit == Boring::Limit::none},
              {"limited_by", limit_name(boring.limit)},
              {"depth_mm", boring.depth / millimetre},
              {"deeper_by_mm", boring.deeper / millimetre},
              {"wall_mm", boring.wall / millimetre},
              {"bottom_mm", boring.bottom / millimetre},
              {"maximum_reduction_g", boring.max_reduction / gram}};
    if (boring.limit == Boring::Limit::none) {
        json["shift_mm"] = boring.shift / millimetre;
        json["shift_unbalance_g_mm"] = shift_unbalance(plug_mass, boring.shift) / gram_millimetre;
    }
    return json;
}

Json option_json(const Result& result, OptionId id, double crank_radius, double tolerance) {
    const auto& found = result.option(id);
    if (!found) {
        Json json = Json::object();
        for (const char* key :
             {"constant_g", "slope", "maximum_g", "required_reduction_g", "reduction_g"}) {
            json[key] = nullptr;
        }
        json["feasible"] = false;
        for (const char* key : {"residual_mass_g", "residual_unbalance_g_mm", "bobweight_g"}) {
            json[key] = nullptr;
        }
        json["reason"] = "the engine has no such plug";
        return json;
    }
    const Option& option = *found;
    const OptionBobWeight& weights = result.bob_weights[index(id)].value();
    const double plug = option.plug_mass_unmachined - option.reduction;
    Json json{{"constant_g", option.constant / gram},
              {"slope", option.slope},
              {"maximum_g", option.maximum / gram},
              {"required_reduction_g", option.required_reduction / gram},
              {"reduction_g", option.reduction / gram},
              {"feasible", option.feasible},
              {"residual_mass_g", option.residual_mass / gram},
              {"residual_unbalance_g_mm", option.residual_unbalance / gram_millimetre},
              {"bobweight_g", weights.after.sum() / gram},
              {"nominal_bobweight_g", weights.nominal.sum() / gram},
              {"plug_mass_g", plug / gram}};
    if (!option.feasible) {
        json["reason"] = describe_failure(option, tolerance);
    }
    json["bobweight"] = bob_weight_json(weights.after);
    json["centre_of_mass_shift"] = Json::array({shift_json(plug, smallest_shift, crank_radius),
                                                shift_json(plug, largest_shift, crank_radius)});
    if (const auto& boring = result.boring[index(id)]) {
        json["boring"] = boring_json(*boring, plug);
    }
    return json;
}

Json crankpin_json(const std::array<double, crankpin_count>& excess, double crank_radius) {
    const double mean = std::accumulate(excess.begin(), excess.end(), 0.0) / crankpin_count;
    Json grams = Json::array();
    Json unbalance = Json::array();
    for (const double mass : excess) {
        grams.push_back(mass / gram);
        unbalance.push_back((mass - mean) * crank_radius / gram_millimetre);
    }
    const auto [least, most] = std::minmax_element(excess.begin(), excess.end());
    return {{"unbalanced_mass_g", std::move(grams)},
            {"spread_g", (*most - *least) / gram},
            {"deviation_g_mm", std::move(unbalance)}};
}

Json weigh_in_json(const Input& input, const Result& result, double crank_radius) {
    Json json = Json::object();
    for (const Part part : all_parts) {
        const PartColumn& column = input.weigh_in.value()[part];
        if (const auto s = statistics(column)) {
            Json entry{{"mean_g", s->mean / gram},
                       {"spread_g", s->spread / gram},
                       {"heaviest_cylinder", s->heaviest + 1},
                       {"lightest_cylinder", s->lightest + 1},
                       {"within_permitted_spread", s->within_permitted}};
            if (column.nominal) {
                entry["mean_deviation_g"] = (s->mean - *column.nominal) / gram;
            }
            json[std::string(part_key(part))] = std::move(entry);
        }
    }
    if (result.assignment) {
        const auto cylinders = [](const std::vector<int>& from) {
            Json list = Json::array();
            for (const int cylinder : from) {
                list.push_back(cylinder + 1);
            }
            return list;
        };
        json["crankpins"] = crankpin_json(*result.crankpin_excess, crank_radius);
        json["assignment"] = {{"pistons_from_cylinder", cylinders(result.assignment->pistons)},
                              {"rods_from_cylinder", cylinders(result.assignment->rods)},
                              {"sets_moved", result.assignment->moved},
                              {"crankpins", crankpin_json(*result.assigned_excess, crank_radius)}};
    }
    return json;
}

Json plug_mass_json(const PlugMass& mass) {
    return {{"geometry_mass_g", mass.geometry / gram},
            {"entered_mass_g", mass.typed / gram},
            {"fits", mass.fits}};
}

Json plane_json(const PlaneVerdict& plane) {
    Json json{{"permissible_g_mm", plane.permissible / gram_millimetre}};
    if (plane.reading) {
        json["reading_g_mm"] = *plane.reading / gram_millimetre;
        json["passes"] = plane.passes.value();
    }
    return json;
}

}  // namespace

Input read_input(const Json& json, Completeness completeness) {
    ObjectReader reader(json, "/input");
    Input input;
    read_engine(reader, input, completeness);
    input.process = reader.choice("process", {"manufacture", "repair"}) == "manufacture"
                        ? Process::manufacture
                        : Process::repair;
    if (reader.choice("crankshaft", {"standard", "new-plugs"}, "standard") == "new-plugs") {
        input.crankshaft = Crankshaft::new_plugs;
        if (!input.engine.has_new_plug) {
            throw InputError(reader.pointer_to("crankshaft"),
                             "must be \"standard\" where the engine has no plug of the new design",
                             "\"new-plugs\"");
        }
    }
    const bool typed = reader.has("mass_changes_g");
    if (typed) {
        ObjectReader changes = reader.object("mass_changes_g");
        for (const MassChangeField& field : mass_change_fields()) {
            input.typed_changes.*field.member = changes.si(field.spec, 0.0);
        }
        changes.finish();
    }
    if (reader.has("weigh_in")) {
        input.weigh_in = read_weigh_in(reader.object("weigh_in"), completeness);
    }
    input.changes_from_weigh_in =
        reader.choice("mass_changes_from", {"typed", "weigh-in"},
                      input.weigh_in && !typed ? "weigh-in" : "typed") == "weigh-in";
    if (input.changes_from_weigh_in && !input.weigh_in) {
        throw InputError(reader.pointer_to("weigh_in"),
                         "is required where mass_changes_from is \"weigh-in\"");
    }
    input.tolerance = reader.si(tolerance_field, default_tolerance);
    if (reader.has("plug")) {
        input.plug = read_plug(reader.object("plug"), completeness);
    }
    if (reader.has("balancing")) {
        input.balancing = read_balancing(reader.object("balancing"), completeness);
    }
    if (reader.has("job")) {
        input.job = read_job(reader.object("job"));
    }
    reader.finish();
    return input;
}

Json write_input(const Input& input) {
    Json json = Json::object();
    const Engine* preset = find_preset(input.preset);
    if (preset != nullptr && overrides_suffice(input.engine, *preset)) {
        json["engine"] = preset->name;
        Json overrides = write_engine_values(input.engine, *preset);
        if (!overrides.empty()) {
            json["engine_overrides"] = std::move(overrides);
        }
    } else {
        Json engine = Json::object();
        if (!input.engine.name.empty()) {
            engine["name"] = input.engine.name;
        }
        engine.update(write_engine_values(input.engine, Engine{}));
        json["engine"] = std::move(engine);
    }
    json["process"] = input.process == Process::manufacture ? "manufacture" : "repair";
    if (input.crankshaft == Crankshaft::new_plugs) {
        json["crankshaft"] = "new-plugs";
    }
    Json changes = Json::object();
    for (const MassChangeField& field : mass_change_fields()) {
        changes[std::string(field.spec.key)] =
            in_unit(input.typed_changes.*field.member, field.spec);
    }
    json["mass_changes_g"] = std::move(changes);
    if (input.weigh_in) {
        json["mass_changes_from"] = input.changes_from_weigh_in ? "weigh-in" : "typed";
        json["weigh_in"] = write_weigh_in(*input.weigh_in);
    }
    json["tolerance_g_mm"] = in_unit(input.tolerance, tolerance_field);
    if (input.plug) {
        json["plug"] = write_plug(*input.plug);
    }
    if (input.balancing) {
        json["balancing"] = write_balancing(*input.balancing);
    }
    if (input.job != JobHeader{}) {
        Json job = Json::object();
        for (const JobField& field : job_fields) {
            if (!(input.job.*field.member).empty()) {
                job[std::string(field.key)] = input.job.*field.member;
            }
        }
        json["job"] = std::move(job);
    }
    return json;
}

Json write_result(const Input& input, const Result& result) {
    const PlugSet& plugs = result.plugs.value();
    const double excess = result.unbalanced_mass.value();
    const Coefficients coefficients = plugs.coefficients();
    const Advice& advice = result.advice.value();

    Json json{{"unbalanced_mass_g", excess / gram},
              {"unbalance_g_mm", excess * plugs.crank_radius / gram_millimetre},
              {"k_p", coefficients.k_p},
              {"k_y", coefficients.k_y},
              {"k_y_new", coefficients.k_y_new ? Json(*coefficients.k_y_new) : Json()},
              {"slope_angle_deg", std::atan(coefficients.k_y) / degree}};
    Json changes = Json::object();
    for (const MassChangeField& field : mass_change_fields()) {
        if (!field.repair_only || input.process == Process::repair) {
            changes[std::string(field.spec.key)] = result.changes.*field.member / gram;
        }
    }
    json["mass_changes_g"] = std::move(changes);
    Json options = Json::object();
    for (const OptionId id : all_options) {
        options[std::string(option_name(id))] =
            option_json(result, id, plugs.crank_radius, input.tolerance);
    }
    json["options"] = std::move(options);
    if (advice.kind == Advice::Kind::none_needed) {
        json["recommended"] = "none-needed";
    } else if (advice.kind == Advice::Kind::option) {
        json["recommended"] = option_name(advice.option.value().id);
    } else {
        json["recommended"] = nullptr;
    }
    std::string reason = describe(advice, excess, plugs.crank_radius, input.tolerance);
    if (advice.kind == Advice::Kind::option && input.plug) {
        const auto& boring = result.boring[index(advice.option.value().id)];
        if (boring && boring->cuts) {
            reason += ' ';
            reason += describe(*boring, input.plug->limits().value());
        }
    }
    json["reason"] = std::move(reason);
    if (result.nominal && result.before) {
        json["bobweight"] = {{"nominal", bob_weight_json(*result.nominal)},
                             {"before", bob_weight_json(*result.before)}};
    }
    if (input.weigh_in) {
        json["weigh_in"] = weigh_in_json(input, result, plugs.crank_radius);
    }
    if (result.steel_plug) {
        Json plug{{"steel", plug_mass_json(*result.steel_plug)}};
        if (result.aluminium_plug) {
            plug["aluminium"] = plug_mass_json(*result.aluminium_plug);
        }
        json["plug"] = std::move(plug);
    }
    if (result.balancing) {
        json["balancing"] = {{"permissible_g_mm", result.balancing->permissible / gram_millimetre},
                             {"front", plane_json(result.balancing->front)},
                             {"rear", plane_json(result.balancing->rear)}};
    }
    return json;
}

Json solve_scene(const Json& json, const CaseContext& /*context*/) {
    const Input input = read_input(json);
    return write_result(input, solve(input));
}

}  // namespace ravnoves::v8_plugs
