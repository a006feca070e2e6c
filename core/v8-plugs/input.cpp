#include "v8-plugs/input.h"

#include <array>

#include "case-file/input_error.h"
#include "v8-plugs/fields.h"

namespace ravnoves::v8_plugs {

namespace {

constexpr Field change(std::string_view key, Text label, Text hint) {
    return {.key = key,
            .unit = units::gram,
            .range = Range::between(-100'000, 100'000),
            .label = label,
            .hint = hint,
            .placeholder = {"?"}};
}

constexpr std::array<MassChangeField, 4> change_fields{{
    {change("piston", Text::tr("One improved piston Δmₚᵢ"),
            Text::tr("Δmₚᵢ: one piston minus nominal.")),
     &MassChanges::piston, false},
    {change("rod_big_end", Text::tr("Big end of one rod"), Text::tr("One big end minus nominal.")),
     &MassChanges::rod_big_end, false},
    {change("repair_piston_and_rings", Text::tr("One repair piston with rings Δmᵣₚ"),
            Text::tr("Δmᵣₚ: one repair piston with rings minus nominal.")),
     &MassChanges::repair_piston_and_rings, true},
    {change("repair_bearing", Text::tr("Repair shells of one crankpin Δmₛₕ"),
            Text::tr("Δmₛₕ: repair shells of one crankpin minus nominal.")),
     &MassChanges::repair_bearing, true},
}};

void check_engine(const Input& input, const std::string& at) {
    const std::string place = at + (input.preset.empty() ? "engine/" : "engine_overrides/");
    const auto missing = missing_fields(input.engine, true);
    if (!missing.empty()) {
        throw InputError(
            place + std::string(missing.front()->field.key),
            input.preset.empty()
                ? Message(Text::tr("is required and missing"))
                : Message(Text::tr("is required and missing: the preset %1 does not give it"),
                          quoted_list({input.preset})));
    }
    for (const auto& [reduction, plug_mass] : engine_conflicts(input.engine)) {
        const Field& field = reduction->field;
        throw InputError(
            place + std::string(field.key),
            {Text::tr("must be less than the plug's mass %1"), from_si(field, plug_mass)},
            Number{from_si(field, *(input.engine.*reduction->member))});
    }
}

void check_plug(const PlugSheet& sheet, const std::string& place) {
    if (sheet.bore_diameter.has_value() != sheet.bore_depth.has_value()) {
        throw InputError(
            place + "/" +
                std::string((sheet.bore_diameter ? field::bore_depth : field::bore_diameter).key),
            Text::tr("is required where the bore's other size is given"));
    }
    if (const auto geometry = sheet.geometry()) {
        if (const auto fault = geometry_fault(*geometry)) {
            throw InputError(place, {Text::tr("must be a possible plug: %1"), *fault});
        }
    }
}

}  // namespace

std::span<const MassChangeField> mass_change_fields() {
    return change_fields;
}

std::optional<PlugGeometry> PlugSheet::geometry() const {
    if (!thread || !height) {
        return std::nullopt;
    }
    PlugGeometry plug{*thread, *height};
    if (bore_diameter && bore_depth) {
        plug.bore_diameter = *bore_diameter;
        plug.bore_depth = *bore_depth;
    }
    return plug;
}

std::optional<BoreLimits> PlugSheet::limits() const {
    if (!cutter_diameter) {
        return std::nullopt;
    }
    return BoreLimits{*cutter_diameter, minimum_wall.value_or(0.0), minimum_bottom.value_or(0.0)};
}

MassChanges Input::changes() const {
    MassChanges typed = typed_changes;
    if (process == Process::manufacture) {
        typed.repair_piston_and_rings = typed.repair_bearing = 0.0;
    }
    return changes_from_weigh_in && weigh_in ? mass_changes(*weigh_in, process, typed) : typed;
}

bool Input::takes_typed(double MassChanges::*change) const {
    return !changes_from_weigh_in || !weigh_in || !is_weighed(*weigh_in, process, change);
}

std::optional<double> Input::rod_coefficient() const {
    const bool weighed =
        changes_from_weigh_in && weigh_in && (*weigh_in)[Part::rod_small_end].is_complete();
    return weighed && engine.rod_coefficient ? 0.0 : engine.rod_coefficient;
}

double rounding_squares(const Input& input) {
    double sum = 0.0;
    if (input.changes_from_weigh_in && input.weigh_in) {
        for (const double factor :
             excess_factors(*input.weigh_in, input.rod_coefficient().value())) {
            sum += 4.0 * factor * factor / cylinder_count;  // two of them are on a crankpin
        }
    }
    return sum;
}

std::vector<Message> replaced(const Input& input) {
    std::vector<Message> list;
    for (const MassChangeField& each : mass_change_fields()) {
        const double typed = input.typed_changes.*each.member;
        if (typed != 0.0 && !input.takes_typed(each.member)) {
            list.emplace_back(Text::tr("%1: the weighed masses replace the typed %2."),
                              each.field.label, shop::in_grams(typed));
        }
    }
    return list;
}

std::vector<Message> not_counted(const Input& input) {
    std::vector<Message> list;
    const bool weighs = input.changes_from_weigh_in && input.weigh_in;
    for (const MassChangeField& each : mass_change_fields()) {
        const double typed = input.typed_changes.*each.member;
        if (typed == 0.0 || !input.takes_typed(each.member)) {
            continue;
        }
        const Number grams = shop::in_grams(typed);
        if (each.repair_only && input.process == Process::manufacture) {
            list.emplace_back(Text::tr("%1: the typed %2 is not used in manufacture."),
                              each.field.label, grams);
        } else if (weighs && !input.weigh_in->is_empty()) {
            list.emplace_back(
                input.changes_known()
                    ? Text::tr("%1: the typed %2 is used with the weighed masses.")
                    : Text::tr("%1: the typed %2 is not used. Weighed masses are selected, but no "
                               "column is complete."),
                each.field.label, grams);
        }
    }
    if (!input.weigh_in || input.weigh_in->is_empty()) {
        return list;
    }
    if (!weighs) {
        list.emplace_back(Text::tr("Weighed masses are not used: the typed changes are selected."));
        return list;
    }
    for (const Part part : all_parts) {
        const PartColumn& column = (*input.weigh_in)[part];
        if (column.is_complete() || column.is_empty()) {
            continue;
        }
        if (!column.nominal) {
            list.emplace_back(Text::tr("%1: weighed masses need a nominal mass."),
                              part_word(part).label);
            continue;
        }
        const auto change = change_of(part, input.process);
        const bool typed =
            input.changes_known() && input.changes().*change != 0.0 && input.takes_typed(change);
        list.emplace_back(
            typed ? Text::tr("%1: %2 of 8 weighed; the typed change is used until all are weighed.")
                  : Text::tr("%1: %2 of 8 weighed; nominal is used until all are weighed."),
            part_word(part).label, statistics(column)->count);
    }
    return list;
}

/// What no form lets happen, half filled or not.
void check_choices(const Input& input, const std::string& place) {
    if (input.crankshaft == Crankshaft::new_plugs && !input.engine.has_new_plug) {
        throw InputError(
            place + std::string(field::crankshaft.key),
            Text::tr("must be \"standard\" where the engine has no plug of the new design"),
            "\"new-plugs\"");
    }
    if (input.changes_from_weigh_in && !input.weigh_in) {
        throw InputError("/input/weigh_in", {Text::tr("is required where %1 is \"weigh-in\""),
                                             field::changes_source.key});
    }
}

void check_method(const Input& input, const std::string& place) {
    check_choices(input, place);
    check_engine(input, place);
    if (input.plug) {
        check_plug(*input.plug, place + std::string(field::plug.key));
    }
}

}  // namespace ravnoves::v8_plugs
