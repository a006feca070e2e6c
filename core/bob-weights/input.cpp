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
    throw InputError(where, Text::tr("is required and missing"));
}

void need(const std::string& place, const Field& field, const std::optional<double>& value) {
    if (!value) {
        missing(place + std::string(field.key));
    }
}

void check_two(std::size_t count, const std::string& place) {
    if (count != 2) {
        throw InputError(place, Text::tr("must be a list of two"),
                         Number{static_cast<double>(count)});
    }
}

void check_engine(const Engine& engine) {
    const std::string place = "/input/engine/";
    if (engine.type == EngineType::v) {
        need(place, field::bank_angle, engine.bank_angle);
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

constexpr const char* correction_place = "/input/correction/";

void check_planned(const Correction& correction) {
    const std::string place = correction_place;
    check_two(correction.planes.size(), place + "planes");
    check_two(correction.readings.size(), place + "readings");
    for (std::size_t i = 0; i < 2; ++i) {
        const Plane& plane = correction.planes[i];
        const std::string at = place + "planes/" + std::to_string(i) + "/";
        need(at, field::plane_position, plane.position);
        need(at, field::plane_radius, plane.radius);
        if (plane.from_angle || plane.to_angle) {
            need(at, field::from_angle, plane.from_angle);
            need(at, field::to_angle, plane.to_angle);
        }
        const Reading& reading = correction.readings[i];
        const std::string reading_at = place + "readings/" + std::to_string(i) + "/";
        need(reading_at, field::unbalance, reading.unbalance);
        if (!is_read(reading)) {
            need(reading_at, field::angle, reading.angle);
        }
    }
    const auto apart = [&](const char* list, const Field& field, double first, double second) {
        if (first == second) {
            throw InputError(place + list + "/1/" + std::string(field.key),
                             Text::tr("must differ from the first"),
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
    need(place + "drill/", field::maximum_depth, correction.drill.maximum_depth);
    if (correction.slug) {
        const Slug& slug = *correction.slug;
        need(place + "slug/", field::slug_diameter, slug.diameter);
        need(place + "slug/", field::slug_density, slug.density);
        if (*slug.density <= correction.drill.density) {
            throw InputError(place + "slug/" + std::string(field::slug_density.key),
                             {Text::tr("must be greater than the crankshaft's %1"),
                              from_si(field::density, correction.drill.density)},
                             Number{from_si(field::slug_density, *slug.density)});
        }
    }
}

/// Of a job the record counts, which may have been corrected since, and is doubted.
void check_drilled(const DrillingRecord& record, const std::string& at) {
    for (std::size_t i = 0; record.drilled && i < record.drilled->size(); ++i) {
        const DrilledHole& hole = (*record.drilled)[i];
        if (hole.from_depth != 0.0 && hole.depth <= hole.from_depth) {
            throw InputError(at + std::string(field::drilled.key) + "/" + std::to_string(i) + "/" +
                                 std::string(field::drilled_from_depth.key),
                             {Text::tr("must be less than the depth, %1"),
                              from_si(field::drilled_depth, hole.depth)},
                             Number{from_si(field::drilled_from_depth, hole.from_depth)});
        }
    }
}

void check_runs(const Correction& correction, bool is_older) {
    const auto& runs = correction.earlier_runs;
    const std::string place = correction_place + std::string(field::earlier_runs.key);
    if (runs.size() >= max_runs) {
        throw InputError(place, {Text::tr("must be a list of at most %1"), max_runs - 1},
                         Number{static_cast<double>(runs.size())});
    }
    if (is_older) {
        check_drilled(correction.record, correction_place);
        check_drilled(correction.planned, correction_place + std::string(field::planned.key) + "/");
    }
    for (std::size_t run = 0; run < runs.size(); ++run) {
        const auto& readings = runs[run].readings;
        const std::string of_run = place + "/" + std::to_string(run) + "/";
        const std::string at = of_run + std::string(field::readings.key);
        if (is_older) {
            check_drilled(runs[run], of_run);
        }
        if (!readings.empty()) {
            check_two(readings.size(), at);
        }
        for (std::size_t i = 0; i < readings.size(); ++i) {
            need(at + "/" + std::to_string(i) + "/", field::unbalance, readings[i].unbalance);
            if (is_older && !is_read(readings[i])) {
                missing(at + "/" + std::to_string(i) + "/" + std::string(field::angle.key));
            }
        }
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

void check_parts(const Input& input, bool has_plugs) {
    if (input.weigh_in) {
        shop::check_weighed(*fitted(input).weigh_in, has_plugs);
        shop::check_matching(input.weigh_in->matching, crank_of(input).angle_count());
    }
    for (const PartField& each : part_fields()) {
        if (each.is_needed() && !has_plugs) {
            need("/input/parts_g/", each.field, mass_of(input, each));
        }
    }
}

void check_correction(const Correction& correction, bool is_planned, bool is_older) {
    const auto check_count = [&](const Field& field, std::size_t count) {
        if (count != 0) {
            check_two(count, correction_place + std::string(field.key));
        }
    };
    check_count(field::planes, correction.planes.size());
    check_count(field::readings, correction.readings.size());
    const bool is_drilled = std::ranges::any_of(correction.earlier_runs, [](const auto& run) {
        return run.drilled && !run.drilled->empty();
    });
    if (is_planned) {
        check_planned(correction);
    } else if (is_drilled && correction.planes.empty()) {
        missing(correction_place + std::string(field::planes.key));
    }
    check_runs(correction, is_older);
}

void check_tolerance(const Tolerance& tolerance) {
    const std::string place = "/input/tolerance/";
    if (tolerance.by_grade) {
        need(place, field::grade, tolerance.grade);
        need(place, field::rotor_mass, tolerance.rotor_mass);
        need(place, field::service_speed, tolerance.service_speed);
    } else {
        need(place, field::plane_tolerance, tolerance.plane);
    }
    if (tolerance.front_bearing || tolerance.rear_bearing) {
        need(place, field::front_bearing, tolerance.front_bearing);
        need(place, field::rear_bearing, tolerance.rear_bearing);
    }
    if (tolerance.front_bearing && *tolerance.front_bearing == *tolerance.rear_bearing) {
        throw InputError(place + std::string(field::rear_bearing.key),
                         Text::tr("must differ from the first"),
                         Number{from_si(field::rear_bearing, *tolerance.rear_bearing)});
    }
    if (tolerance.front_share != 0.5 && (tolerance.centre_of_mass || tolerance.front_bearing)) {
        throw InputError(place + std::string(field::front_share.key),
                         Text::tr("must be left out if centre of mass or bearings are given"),
                         Number{tolerance.front_share});
    }
}

}  // namespace ravnoves::bob_weights
