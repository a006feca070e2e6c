#include "shop/weigh_in.h"

#include <limits>
#include <numeric>

#include "case-file/field_visitor.h"
#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/object_reader.h"

namespace ravnoves::shop {

std::optional<ColumnStatistics> statistics(std::span<const Weighed> masses,
                                           const std::optional<double>& permitted_spread) {
    ColumnStatistics result{0, 0.0, 0.0, -1, -1, true};
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -minimum;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        if (!masses[i]) {
            continue;
        }
        const double mass = *masses[i];
        ++result.count;
        result.mean += mass;
        if (mass > maximum) {
            maximum = mass;
            result.heaviest = static_cast<int>(i);
        }
        if (mass < minimum) {
            minimum = mass;
            result.lightest = static_cast<int>(i);
        }
    }
    if (result.count == 0) {
        return std::nullopt;
    }
    result.mean /= result.count;
    result.spread = maximum - minimum;
    // A scale reads to hundredths of a gram: a microgram of rounding is no violation.
    constexpr double rounding = 1e-9;
    result.within_permitted = !permitted_spread || result.spread <= *permitted_spread + rounding;
    return result;
}

std::optional<ColumnStatistics> statistics(const PartColumn& column) {
    return statistics(column.mass, column.permitted_spread);
}

namespace {

SetNumbers as_weighed(std::size_t cylinders) {
    SetNumbers numbers(cylinders);
    std::iota(numbers.begin(), numbers.end(), 1);
    return numbers;
}

struct SetNumberList final : FieldVisitor::Custom {
    SetNumberList(SetNumbers& it, std::size_t count) : numbers(it), cylinders(count) {}

    void read(const Json& list, const std::string& pointer) override {
        const SetNumbers usual = as_weighed(cylinders);
        SetNumbers found;
        if (list.is_array()) {
            for (const Json& number : list) {
                found.push_back(number.is_number_integer() ? number.get<int>() : 0);
            }
        }
        if (found.size() != cylinders ||
            !std::is_permutation(found.begin(), found.end(), usual.begin())) {
            throw InputError(pointer,
                             {Text::tr("must be the numbers 1 to %1, each once"), cylinders},
                             show(list));
        }
        numbers = found == usual ? SetNumbers() : found;
    }
    Json write() override { return numbers.empty() ? Json() : Json(numbers); }

    SetNumbers& numbers;
    std::size_t cylinders;
};

/// The weights of a column in a case file; null for what is not weighed yet.
struct WeightList final : FieldVisitor::Custom {
    explicit WeightList(std::span<Weighed> list) : weights(list) {}

    void read(const Json& masses, const std::string& pointer) override {
        if (!masses.is_array() || masses.size() != weights.size()) {
            throw InputError(
                pointer,
                {Text::tr("must be a list of %1 masses, one for each cylinder"), weights.size()},
                show(masses));
        }
        for (std::size_t i = 0; i < masses.size(); ++i) {
            const Json& each = masses.at(i);
            if (!each.is_null() && !each.is_number()) {
                throw InputError(pointer + "/" + std::to_string(i), Text::tr("must be a number"),
                                 show(each));
            }
            weights[i] =
                each.is_null() ? std::nullopt : std::optional(each.get<double>() * mass.unit);
        }
        check(pointer);
    }
    Json write() override {
        if (std::none_of(weights.begin(), weights.end(), [](const Weighed& m) { return m; })) {
            return {};
        }
        Json masses = Json::array();
        for (const Weighed& each : weights) {
            masses.push_back(each ? Json(from_si(mass, *each)) : Json());
        }
        return masses;
    }
    void check(const std::string& pointer) override {
        for (std::size_t i = 0; i < weights.size(); ++i) {
            if (weights[i]) {
                check_range(mass, from_si(mass, *weights[i]), pointer + "/" + std::to_string(i));
            }
        }
    }

    static constexpr const Field& mass = field::part_mass;
    std::span<Weighed> weights;
};

/// The object "matching", written where one of its fields is changed.
void visit_matching(FieldVisitor& visitor, MatchingRules& rules, bool asks_radius) {
    const MatchingRules usual;
    visitor.object_of(field::matching, false, !(rules == usual), [&] {
        visitor.choice(field::goal, rules.goal, usual.goal);
        visitor.choice(field::piston_moves, rules.pistons, usual.pistons);
        visitor.choice(field::pin_moves, rules.pins, usual.pins);
        visitor.choice(field::ring_moves, rules.rings, usual.rings);
        visitor.choice(field::rod_moves, rules.rods, usual.rods);
        visitor.choice(field::shell_moves, rules.shells, usual.shells);
        visitor.number(field::permitted_crankpin_spread, rules.permitted_spread);
        if (visitor.has(field::crankpin_angles.key, !rules.crankpin_angles_deg.empty())) {
            visitor.numbers(field::crankpin_angles, rules.crankpin_angles_deg);
        }
        visitor.number(field::cylinder_spacing, rules.cylinder_spacing);
        visitor.number(field::bank_offset, rules.bank_offset);
        if (asks_radius) {
            visitor.number(field::matching_crank_radius, rules.crank_radius);
        }
    });
}

}  // namespace

SetNumbers whole_numbers(const SetNumbers& numbers, std::size_t cylinders) {
    return numbers.size() == cylinders ? numbers : as_weighed(cylinders);
}

SetNumbers moved_numbers(const SetNumbers& numbers, const std::vector<int>& from) {
    const SetNumbers before = whole_numbers(numbers, from.size());
    SetNumbers after;
    for (const int cylinder : from) {
        after.push_back(before.at(static_cast<std::size_t>(cylinder)));
    }
    return after == as_weighed(from.size()) ? SetNumbers() : after;
}

void WeighIn::fit(std::size_t cylinders) {
    for (PartColumn& column : columns) {
        column.mass.resize(cylinders);
    }
    for (SetNumbers* sets : {&piston_sets, &rod_sets}) {
        if (sets->size() != cylinders) {
            sets->clear();
        }
    }
}

void visit_sheet(FieldVisitor& visitor, WeighIn& sheet, bool of_plugs) {
    visitor.choice(field::numbering, sheet.numbering, CylinderNumbering::bank_by_bank,
                   FieldVisitor::Written::always);
    const std::size_t cylinders = sheet.columns.front().mass.size();
    SetNumberList pistons(sheet.piston_sets, cylinders);
    visitor.custom(field::piston_sets, false, pistons);
    SetNumberList rods(sheet.rod_sets, cylinders);
    visitor.custom(field::rod_sets, false, rods);
    for (const Part part : all_parts) {
        PartColumn& column = sheet[part];
        visitor.object_of({.key = part_word(part).word, .label = part_word(part).label}, false,
                          column.is_begun(), [&] {
                              if (of_plugs) {
                                  visitor.required(field::nominal, column.nominal);
                              } else {
                                  visitor.number(field::nominal, column.nominal);
                              }
                              visitor.number(field::permitted_spread, column.permitted_spread);
                              WeightList weights(column.mass);
                              visitor.custom(field::part_mass, false, weights);
                          });
    }
    visit_matching(visitor, sheet.matching, !of_plugs);
}

void check_weighed(const WeighIn& sheet, bool nominal_needed) {
    for (const Part part : all_parts) {
        const PartColumn& column = sheet[part];
        if (column.is_empty()) {
            continue;
        }
        const std::string place = "/input/weigh_in/" + std::string(part_word(part).word) + "/";
        const auto gap = std::find(column.mass.begin(), column.mass.end(), std::nullopt);
        if (gap != column.mass.end()) {
            throw InputError(place + "mass_g/" + std::to_string(gap - column.mass.begin()),
                             Text::tr("must be a number"), "null");
        }
        if (nominal_needed && !column.nominal) {
            throw InputError(place + std::string(field::nominal.key),
                             Text::tr("is required and missing"));
        }
    }
}

}  // namespace ravnoves::shop
