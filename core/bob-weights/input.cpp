#include "bob-weights/input.h"

#include <algorithm>

#include "bob-weights/factor_theory.h"
#include "bob-weights/fields.h"
#include "bob-weights/matching.h"
#include "case-file/input_error.h"
#include "shop/sentences.h"

namespace ravnoves::bob_weights {

namespace {

[[noreturn]] void missing(const std::string& where) {
    throw InputError(where, CORE_TEXT("core", "is required and missing"));
}

void check_engine(const Engine& engine) {
    const std::string place = "/input/engine/";
    if (engine.type == EngineType::v && !engine.bank_angle) {
        missing(place + std::string(field::bank_angle.key));
    }
    if (engine.cylinders % engine.rods_per_pin != 0) {
        throw InputError(place + std::string(field::cylinders.key),
                         CORE_TEXT("bob-weights", "must be even if two rods share a bob weight"),
                         Number{1.0 * engine.cylinders});
    }
    if (engine.type == EngineType::in_line && engine.rods_per_pin != 1) {
        throw InputError(place + std::string(field::rods_per_pin.key),
                         CORE_TEXT("bob-weights", "must be 1 for cylinders in line"),
                         Number{1.0 * engine.rods_per_pin});
    }
    if (engine.type != EngineType::v && engine.pin_split != 0.0) {
        throw InputError(place + std::string(field::pin_split.key),
                         CORE_TEXT("bob-weights", "must be 0 except for a V"),
                         Number{from_si(field::pin_split, engine.pin_split)});
    }
}

void check_two(std::size_t count, const std::string& place) {
    if (count != 2) {
        throw InputError(place, CORE_TEXT("bob-weights", "must be a list of two"),
                         Number{static_cast<double>(count)});
    }
}

constexpr const char* correction_place = "/input/correction/";

}  // namespace

void check_correction(const Correction& correction) {
    const std::string place = correction_place;
    check_two(correction.planes.size(), place + "planes");
    check_two(correction.readings.size(), place + "readings");
    for (std::size_t i = 0; i < 2; ++i) {
        const Plane& plane = correction.planes[i];
        const std::string at = place + "planes/" + std::to_string(i) + "/";
        if (!plane.position || !plane.radius) {
            missing(at + std::string(
                             (plane.position ? field::plane_radius : field::plane_position).key));
        }
        if (plane.from_angle.has_value() != plane.to_angle.has_value()) {
            missing(at + std::string((plane.from_angle ? field::to_angle : field::from_angle).key));
        }
        const Reading& reading = correction.readings[i];
        if (!is_read(reading)) {
            missing(place + "readings/" + std::to_string(i) + "/" +
                    std::string((reading.unbalance ? field::angle : field::unbalance).key));
        }
    }
    const auto apart = [&](const char* list, const Field& field, double first, double second) {
        if (first == second) {
            throw InputError(place + list + "/1/" + std::string(field.key),
                             CORE_TEXT("bob-weights", "must differ from the first"),
                             Number{from_si(field, second)});
        }
    };
    const auto read_at = [&](std::size_t i) {
        return correction.readings[i].position.value_or(*correction.planes[i].position);
    };
    apart("planes", field::plane_position, *correction.planes[0].position,
          *correction.planes[1].position);
    apart("readings", field::reading_position, read_at(0), read_at(1));
    if (correction.drill.diameters_mm.empty()) {
        missing(place + "drill/" + std::string(field::diameters.key));
    }
    if (!correction.drill.maximum_depth) {
        missing(place + "drill/" + std::string(field::maximum_depth.key));
    }
    if (correction.slug) {
        const Slug& slug = *correction.slug;
        if (!slug.diameter || !slug.density) {
            missing(place + "slug/" +
                    std::string((slug.diameter ? field::slug_density : field::slug_diameter).key));
        }
        if (*slug.density <= correction.drill.density) {
            throw InputError(place + "slug/" + std::string(field::slug_density.key),
                             {CORE_TEXT("bob-weights", "must be greater than the crankshaft's %1"),
                              from_si(field::density, correction.drill.density)},
                             Number{from_si(field::slug_density, *slug.density)});
        }
    }
}

namespace {

void check_drilled(const std::optional<std::vector<DrilledHole>>& drilled, const std::string& at) {
    for (std::size_t i = 0; drilled && i < drilled->size(); ++i) {
        const DrilledHole& hole = (*drilled)[i];
        if (!hole.depths_agree()) {
            throw InputError(at + std::string(field::drilled.key) + "/" + std::to_string(i) + "/" +
                                 std::string(field::drilled_from_depth.key),
                             {CORE_TEXT("bob-weights", "must be less than the depth, %1"),
                              from_si(field::drilled_depth, hole.depth)},
                             Number{from_si(field::drilled_from_depth, hole.from_depth)});
        }
    }
}

}  // namespace

void check_runs(const Correction& correction) {
    const std::string place = correction_place;
    if (correction.earlier_runs.size() >= max_runs) {
        throw InputError(place + std::string(field::earlier_runs.key),
                         {CORE_TEXT("bob-weights", "must be a list of at most %1"), max_runs - 1},
                         Number{static_cast<double>(correction.earlier_runs.size())});
    }
    check_drilled(correction.record.drilled, place);
    for (std::size_t run = 0; run < correction.earlier_runs.size(); ++run) {
        const EarlierRun& earlier = correction.earlier_runs[run];
        const auto& readings = earlier.readings;
        const std::string of_run =
            place + std::string(field::earlier_runs.key) + "/" + std::to_string(run) + "/";
        const std::string at = of_run + std::string(field::readings.key);
        check_drilled(earlier.drilled, of_run);
        if (readings.empty()) {
            continue;
        }
        check_two(readings.size(), at);
        for (std::size_t i = 0; i < 2; ++i) {
            if (!readings[i].unbalance) {
                missing(at + "/" + std::to_string(i) + "/" + std::string(field::unbalance.key));
            }
        }
    }
}

void check_tolerance(const Tolerance& tolerance) {
    const std::string place = "/input/tolerance/";
    const std::pair<const Field&, const std::optional<double>&> graded[] = {
        {field::grade, tolerance.grade},
        {field::rotor_mass, tolerance.rotor_mass},
        {field::service_speed, tolerance.service_speed}};
    if (tolerance.by_grade) {
        for (const auto& [field, value] : graded) {
            if (!value) {
                missing(place + std::string(field.key));
            }
        }
    } else if (!tolerance.plane) {
        missing(place + std::string(field::plane_tolerance.key));
    }
    if (tolerance.front_bearing.has_value() != tolerance.rear_bearing.has_value()) {
        missing(place +
                std::string(
                    (tolerance.front_bearing ? field::rear_bearing : field::front_bearing).key));
    }
    if (tolerance.front_bearing && *tolerance.front_bearing == *tolerance.rear_bearing) {
        throw InputError(place + std::string(field::rear_bearing.key),
                         CORE_TEXT("bob-weights", "must differ from the first"),
                         Number{from_si(field::rear_bearing, *tolerance.rear_bearing)});
    }
    if (tolerance.front_share != 0.5 && (tolerance.centre_of_mass || tolerance.front_bearing)) {
        throw InputError(
            place + std::string(field::front_share.key),
            CORE_TEXT("bob-weights", "must be left out if centre of mass or bearings are given"),
            Number{tolerance.front_share});
    }
}

std::vector<Reading> at_places_of(const std::vector<Reading>& others,
                                  std::vector<Reading> readings) {
    for (std::size_t i = 0; i < readings.size(); ++i) {
        readings[i].position = i < others.size() ? others[i].position : std::nullopt;
    }
    return readings;
}

void fit_weigh_in(Input& input) {
    if (input.weigh_in) {
        for (auto& column : input.weigh_in->columns) {
            column.mass.resize(static_cast<std::size_t>(input.engine.cylinders));
        }
        for (shop::SetNumbers* sets : {&input.weigh_in->piston_sets, &input.weigh_in->rod_sets}) {
            if (sets->size() != static_cast<std::size_t>(input.engine.cylinders)) {
                sets->clear();
            }
        }
    }
}

Input fitted(Input input) {
    fit_weigh_in(input);
    return input;
}

std::optional<double> service_speed(const Input& input) {
    return input.tolerance && input.tolerance->by_grade ? input.tolerance->service_speed
                                                        : std::nullopt;
}

BearingPlaces places_of_bearings(const Input& input) {
    if (!input.correction || input.correction->planes.size() != 2 || !input.tolerance) {
        return BearingPlaces::plausible;  // a sheet may be saved half filled
    }
    const auto& front = input.correction->planes.at(0).position;
    const auto& rear = input.correction->planes.at(1).position;
    const Tolerance& tolerance = *input.tolerance;
    if (!front || !rear) {
        return BearingPlaces::plausible;
    }
    const auto& first = tolerance.front_bearing;
    const auto& second = tolerance.rear_bearing;
    if (first && second && (*second - *first) * (*rear - *front) < 0.0) {
        return BearingPlaces::reversed;
    }
    if (const auto& centre = tolerance.centre_of_mass) {
        const auto [minimum, maximum] =
            std::minmax({first.value_or(*front), second.value_or(*rear)});
        return *centre < minimum || *centre > maximum ? BearingPlaces::centre_beyond
                                                      : BearingPlaces::plausible;
    }
    return BearingPlaces::plausible;
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
            list.emplace_back(
                CORE_TEXT("bob-weights", "%1: the weighed masses replace the typed %2."),
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
                    ? CORE_TEXT(
                          "bob-weights",
                          "%1: %2 of %3 weighed; the typed mass is used until all are weighed.")
                    : CORE_TEXT("bob-weights",
                                "%1: %2 of %3 weighed; not used until all are weighed."),
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
                         CORE_TEXT("bob-weights", "must leave a factor of 0 or more"),
                         Number{from_si(field::overbalance_percent, input.factor.overbalance)});
    }
}

void check_weigh_in(const Input& input, bool nominal_needed) {
    if (input.weigh_in) {
        shop::check_weighed(*fitted(input).weigh_in, nominal_needed);
        shop::check_matching(input.weigh_in->matching, crank_of(input).angle_count());
    }
}

void check_parts(const Input& input) {
    for (const PartField& each : part_fields()) {
        const bool needed = each.member == &Parts::piston || each.member == &Parts::big_end;
        if (needed && !mass_of(input, each)) {
            missing("/input/parts_g/" + std::string(each.field.key));
        }
    }
}

}  // namespace ravnoves::bob_weights
