#include "bob-weights/input.h"

#include <algorithm>

#include "bob-weights/factor_theory.h"
#include "bob-weights/fields.h"
#include "case-file/input_error.h"
#include "shop/sentences.h"

namespace ravnoves::bob_weights {

namespace {

void check_engine(const Engine& engine) {
    const std::string place = "/input/engine/";
    if (engine.type == EngineType::v && !engine.bank_angle) {
        throw InputError(place + std::string(field::bank_angle.key),
                         Text::tr("is required and missing"));
    }
    if (engine.cylinders % engine.rods_per_pin != 0) {
        throw InputError(place + std::string(field::cylinders.key),
                         Text::tr("must be even if two rods share a bob weight"),
                         Number{1.0 * engine.cylinders});
    }
    if (engine.type == EngineType::in_line && engine.rods_per_pin != 1) {
        throw InputError(place + std::string(field::rods_per_pin.key),
                         Text::tr("must be 1 for cylinders in line"),
                         Number{1.0 * engine.rods_per_pin});
    }
    if (engine.type != EngineType::v && engine.pin_split != 0.0) {
        throw InputError(place + std::string(field::pin_split.key),
                         Text::tr("must be 0 except for a V"),
                         Number{from_si(field::pin_split, engine.pin_split)});
    }
}

}  // namespace

std::vector<Reading> at_places_of(const std::vector<Reading>& others,
                                  std::vector<Reading> readings) {
    for (std::size_t i = 0; i < readings.size(); ++i) {
        readings[i].position = i < others.size() ? others[i].position : std::nullopt;
    }
    return readings;
}

void fit_weigh_in(Input& input) {
    if (input.weigh_in) {
        input.weigh_in->fit(static_cast<std::size_t>(input.engine.cylinders));
    }
}

Input fitted(const Input& input) {
    Input whole = input;
    fit_weigh_in(whole);
    return whole;
}

std::optional<double> service_speed(const Input& input) {
    return input.tolerance && input.tolerance->by_grade ? input.tolerance->service_speed
                                                        : std::nullopt;
}

std::optional<std::array<double, 2>> plane_positions(const Input& input) {
    if (!input.correction || input.correction->planes.size() != 2 ||
        !input.correction->planes[0].position || !input.correction->planes[1].position) {
        return std::nullopt;
    }
    return {{*input.correction->planes[0].position, *input.correction->planes[1].position}};
}

BearingPlaces places_of_bearings(const Input& input) {
    const auto planes = plane_positions(input);
    if (!planes || !input.tolerance) {
        return BearingPlaces::plausible;  // a sheet may be saved half filled
    }
    const auto& [front, rear] = *planes;
    const auto& first = input.tolerance->front_bearing;
    const auto& second = input.tolerance->rear_bearing;
    if (first && second && (*second - *first) * (rear - front) < 0.0) {
        return BearingPlaces::reversed;
    }
    const auto [minimum, maximum] = std::minmax({first.value_or(front), second.value_or(rear)});
    const double centre = input.tolerance->centre_of_mass.value_or(minimum);
    return centre < minimum || centre > maximum ? BearingPlaces::centre_beyond
                                                : BearingPlaces::plausible;
}

namespace {

/// As many rows as the engine has cylinders.
std::optional<shop::PartColumn> weighed_column(const Input& input, const PartField& part) {
    if (!input.weigh_in || !part.column) {
        return std::nullopt;
    }
    auto column = (*input.weigh_in)[*part.column];
    column.mass.resize(static_cast<std::size_t>(input.engine.cylinders));
    return column.is_weighed() ? std::optional(column) : std::nullopt;
}

}  // namespace

bool is_weighed(const Input& input, const PartField& part) {
    return weighed_column(input, part).has_value();
}

std::optional<double> mass_of(const Input& input, const PartField& part) {
    const auto column = weighed_column(input, part);
    return column ? shop::statistics(*column)->mean : input.parts.*part.member;
}

std::vector<Message> replaced(const Input& input) {
    std::vector<Message> list;
    for (const PartField& part : part_fields()) {
        const auto& typed = input.parts.*part.member;
        if (typed && part.column && is_weighed(input, part)) {
            list.emplace_back(Text::tr("%1: the weighed masses replace the typed %2."),
                              shop::part_word(*part.column).label, shop::in_grams(*typed));
        }
    }
    return list;
}

std::vector<Message> not_counted(const Input& input) {
    std::vector<Message> list;
    for (const PartField& part : part_fields()) {
        if (!input.weigh_in || !part.column || is_weighed(input, part)) {
            continue;
        }
        if (const auto weighed = shop::statistics((*input.weigh_in)[*part.column])) {
            list.emplace_back(
                input.parts.*part.member
                    ? Text::tr(
                          "%1: %2 of %3 weighed; the typed mass is used until all are weighed.")
                    : Text::tr("%1: %2 of %3 weighed; not used until all are weighed."),
                shop::part_word(*part.column).label, weighed->count, input.engine.cylinders);
        }
    }
    return list;
}

void check_bob_weight(const Input& input) {
    check_engine(input.engine);
    const double factor = input.factor.reciprocating.value_or(theory_factor(input.engine));
    if (factor + input.factor.overbalance < 0.0) {
        throw InputError("/input/factor/" + std::string(field::overbalance_percent.key),
                         Text::tr("must leave a factor of 0 or more"),
                         Number{from_si(field::overbalance_percent, input.factor.overbalance)});
    }
}

}  // namespace ravnoves::bob_weights
