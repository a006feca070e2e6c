#include "shop/matching.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "case-file/input_error.h"
#include "numerics/constants.h"
#include "shop/sentences.h"
#include "shop/set_search.h"

namespace ravnoves::shop {

namespace {

using Vector = std::complex<double>;

bool is_whole(const PartColumn& column, std::size_t count) {
    return column.mass.size() == count && column.is_weighed();
}

/// By how much each part differs from the mean of its column; zeros where one is not weighed.
std::vector<double> differences(const PartColumn& column, std::size_t count) {
    std::vector<double> list(count, 0.0);
    const auto found = is_whole(column, count) ? statistics(column) : std::nullopt;
    for (std::size_t i = 0; found && i < count; ++i) {
        list[i] = *column.mass[i] - found->mean;
    }
    return list;
}

/// Whether a part changes its cylinder with its set.
bool moves_with_set(const MatchingRules& rules, Part part) {
    const PartMoves moves = part == Part::pin      ? rules.pins
                            : part == Part::rings  ? rules.rings
                            : part == Part::shells ? rules.shells
                                                   : PartMoves::with_set;
    return moves == PartMoves::with_set;
}

/// What the crank lacks, so that it is not known what the engine feels; empty where that is known.
Message crank_fault(const Crank& crank) {
    if (crank.has_banks && !crank.bank_angle) {
        return Text::tr("the bank angle is missing");
    }
    if (crank.angles.size() != static_cast<std::size_t>(crank.angle_count())) {
        return {Text::tr("enter %1 angles of the crankpins"), crank.angle_count()};
    }
    if (crank.bank_offset != 0.0 && !crank.spacing) {
        return Text::tr("the bank offset needs the cylinder spacing");
    }
    return {};
}

/// The placing, as in Matched, that returns each set to where it was weighed.
std::array<std::vector<int>, 2> where_weighed(const WeighIn& sheet) {
    const std::size_t cylinders = sheet.columns.front().mass.size();
    std::array<std::vector<int>, 2> from;
    for (std::size_t kind = 0; kind < 2; ++kind) {
        const SetNumbers numbers =
            whole_numbers(kind == 0 ? sheet.piston_sets : sheet.rod_sets, cylinders);
        from[kind].resize(cylinders);
        for (std::size_t i = 0; i < cylinders; ++i) {
            from[kind].at(static_cast<std::size_t>(numbers.at(i)) - 1) = static_cast<int>(i);
        }
    }
    return from;
}

/// A number of each set of both kinds and, last, of what stays in its place.
using Sets = std::array<std::vector<double>, 3>;

/// Sums of the parts of n cylinders, each times its factor.
Sets sums_of(const WeighIn& sheet, std::size_t n, const PartFactors& factors) {
    Sets sets;
    sets.fill(std::vector<double>(n, 0.0));
    for (const Part part : all_parts) {
        const auto list = differences(sheet[part], n);
        const std::size_t kind = !moves_with_set(sheet.matching, part) ? 2
                                 : is_of_piston(part)                  ? 0
                                                                       : 1;
        for (std::size_t i = 0; i < n; ++i) {
            sets[kind][i] += factors[static_cast<std::size_t>(part)] * list[i];
        }
    }
    return sets;
}

using Places = std::vector<CylinderPlace>;

/// Within what sets of the kind change places.
std::vector<int> groups_of(const Places& places, SetMoves moves) {
    std::vector<int> groups;
    for (std::size_t i = 0; i < places.size(); ++i) {
        groups.push_back(moves == SetMoves::anywhere      ? 0
                         : moves == SetMoves::within_bank ? places[i].bank
                                                          : static_cast<int>(i));
    }
    return groups;
}

SetSearch empty_search(const Places& places, const MatchingRules& rules, std::size_t dimensions) {
    SetSearch search;
    search.places = places.size();
    search.dimensions = dimensions;
    search.fixed.assign(dimensions, 0.0);
    for (std::size_t kind = 0; kind < 2; ++kind) {
        search.kinds[kind].adds.assign(search.places * search.places * dimensions, 0.0);
        search.kinds[kind].group = groups_of(places, kind == 0 ? rules.pistons : rules.rods);
    }
    return search;
}

/// Calls `add` for each set in each place, with what it adds there; of what stays there is one set
/// for each place.
void fill(SetSearch& search, const auto& add) {
    for (std::size_t place = 0; place < search.places; ++place) {
        for (std::size_t set = 0; set < search.places; ++set) {
            for (std::size_t kind = 0; kind < 2; ++kind) {
                add(&search.kinds[kind].adds[(set * search.places + place) * search.dimensions],
                    kind, set, place);
            }
        }
        add(search.fixed.data(), 2, place, place);
    }
}

SetSearch search_of_spread(const MatchingTask& task) {
    const Places places = places_of(task.crank);
    int pins = 0;
    for (const CylinderPlace& place : places) {
        pins = std::max(pins, place.crankpin + 1);
    }
    SetSearch search = empty_search(places, task.sheet.matching, static_cast<std::size_t>(pins));
    const Sets sums = sums_of(task.sheet, places.size(), task.factors);
    fill(search, [&](double* adds, std::size_t kind, std::size_t set, std::size_t place) {
        adds[places[place].crankpin] += sums[kind][set];
    });
    return search;
}

/// Middle and length of the crankshaft between its end cylinders.
struct Reach {
    double middle = 0.0;
    double length = 0.0;
};

Reach reach_of(const Places& places) {
    const auto [first, last] =
        std::minmax_element(places.begin(), places.end(),
                            [](const auto& a, const auto& b) { return a.position < b.position; });
    return {0.5 * (first->position + last->position), last->position - first->position};
}

/// The first-order force with the crank and against it, at the front end and the rear end.
SetSearch search_of_shaking(const MatchingTask& task) {
    const Places places = places_of(task.crank);
    constexpr std::size_t dimensions = 8;
    SetSearch search = empty_search(places, task.sheet.matching, dimensions);
    search.size = SetSearch::Size::norm;
    // Big ends and shells rotate, the rest reciprocates.
    const Sets rotating = sums_of(task.sheet, places.size(), {0, 0, 0, 0, 1, 1});
    const Sets reciprocating = sums_of(task.sheet, places.size(), {1, 1, 1, 1, 0, 0});
    const Reach reach = reach_of(places);
    fill(search, [&](double* adds, std::size_t kind, std::size_t set, std::size_t place) {
        const CylinderPlace& at = places[place];
        const double rear =
            reach.length > 0.0 ? 0.5 + (at.position - reach.middle) / reach.length : 0.5;
        const double half = 0.5 * reciprocating[kind][set];
        const Vector forward = (rotating[kind][set] + half) * std::polar(1.0, at.crank_angle);
        const Vector backward = half * std::polar(1.0, 2.0 * at.axis - at.crank_angle);
        const Vector parts[] = {(1.0 - rear) * forward, rear * forward, (1.0 - rear) * backward,
                                rear * backward};
        for (std::size_t i = 0; i < 4; ++i) {
            adds[2 * i] += parts[i].real();
            adds[2 * i + 1] += parts[i].imag();
        }
    });
    return search;
}

}  // namespace

std::vector<Weighed> take_off(std::span<const Weighed> masses) {
    std::vector<Weighed> list(masses.size());
    const auto found = statistics(masses, std::nullopt);
    for (std::size_t i = 0; found && i < masses.size(); ++i) {
        if (masses[i]) {
            list[i] = *masses[i] - *masses[static_cast<std::size_t>(found->lightest)];
        }
    }
    return list;
}

int Crank::angle_count() const {
    return has_throws ? cylinders / 2 : cylinders;
}

void Crank::follow(const WeighIn& sheet) {
    numbering = sheet.numbering;
    spacing = sheet.matching.cylinder_spacing;
    bank_offset = sheet.matching.bank_offset.value_or(0.0);
    if (!sheet.matching.crankpin_angles_deg.empty()) {
        angles.clear();
        for (const double angle : sheet.matching.crankpin_angles_deg) {
            angles.push_back(angle * degree);
        }
    }
}

std::vector<CylinderPlace> places_of(const Crank& crank) {
    std::vector<CylinderPlace> places;
    const int half = (crank.cylinders + 1) / 2;
    for (int i = 0; i < crank.cylinders; ++i) {
        const bool alternating = crank.numbering == CylinderNumbering::alternating;
        const int bank = !crank.has_banks ? 0 : alternating ? i % 2 : i / half;
        const int station = !crank.has_banks ? i : alternating ? i / 2 : i % half;
        const double side = bank == 0 ? 0.5 : -0.5;
        CylinderPlace place;
        place.bank = bank;
        place.crankpin = crank.rods_per_pin == 2 ? station : i;
        place.axis = crank.has_banks ? side * crank.bank_angle.value_or(0.0) : 0.0;
        const auto at = static_cast<std::size_t>(crank.has_throws ? station : i);
        if (at < crank.angles.size()) {
            place.crank_angle = crank.angles[at] - (crank.has_throws ? side * crank.split : 0.0);
        }
        place.position = station * crank.spacing.value_or(1.0) + bank * crank.bank_offset;
        places.push_back(place);
    }
    return places;
}

std::vector<int> part_numbers(const WeighIn& sheet, Part part) {
    return whole_numbers(!moves_with_set(sheet.matching, part) ? SetNumbers()
                         : is_of_piston(part)                  ? sheet.piston_sets
                                                               : sheet.rod_sets,
                         sheet[part].mass.size());
}

void move_sets(WeighIn& sheet, const std::vector<int>& pistons, const std::vector<int>& rods) {
    const WeighIn before = sheet;
    for (const Part part : all_parts) {
        if (!moves_with_set(sheet.matching, part)) {
            continue;
        }
        const std::vector<int>& from = is_of_piston(part) ? pistons : rods;
        for (std::size_t i = 0; i < from.size(); ++i) {
            sheet[part].mass[i] = before[part].mass[static_cast<std::size_t>(from[i])];
        }
    }
    sheet.piston_sets = moved_numbers(before.piston_sets, pistons);
    sheet.rod_sets = moved_numbers(before.rod_sets, rods);
}

void forget_sets(WeighIn& sheet) {
    const auto is_weighed = [&](bool of_piston) {
        return std::any_of(all_parts.begin(), all_parts.end(), [&](Part part) {
            return is_of_piston(part) == of_piston && moves_with_set(sheet.matching, part) &&
                   !sheet[part].is_empty();
        });
    };
    for (const bool of_piston : {true, false}) {
        if (!is_weighed(of_piston)) {
            (of_piston ? sheet.piston_sets : sheet.rod_sets).clear();
        }
    }
}

void move_back(WeighIn& sheet) {
    const auto from = where_weighed(sheet);
    move_sets(sheet, from[0], from[1]);
}

Placed placed_by(const MatchingTask& task, const std::array<std::vector<int>, 2>& from) {
    const SetSearch by_spread = search_of_spread(task);
    Placed placed{sum_of(by_spread, from), size_of(by_spread, from), std::nullopt};
    if (!crank_fault(task.crank).empty()) {
        return placed;
    }
    const SetSearch search = search_of_shaking(task);
    const auto sum = sum_of(search, from);
    const auto part = [&](std::size_t i) { return Vector(sum[2 * i], sum[2 * i + 1]); };
    const double arm = 0.5 * reach_of(places_of(task.crank)).length;
    // Two parts that turn in opposite senses meet twice a turn.
    placed.shaking = {
        std::abs(part(0) + part(1)) + std::abs(part(2) + part(3)),
        arm * (std::abs(part(1) - part(0)) + std::abs(part(3) - part(2))),
        size_of(search, from) / std::sqrt(2.0),
    };
    return placed;
}

std::optional<Matched> match(const MatchingTask& task) {
    const MatchingRules& rules = task.sheet.matching;
    const auto n = static_cast<std::size_t>(task.crank.cylinders);
    const bool counts = std::any_of(task.sheet.columns.begin(), task.sheet.columns.end(),
                                    [&](const PartColumn& column) { return is_whole(column, n); });
    if (n == 0 || !counts) {
        return std::nullopt;
    }
    Matched matched;
    matched.goal = rules.goal;
    matched.spacing_known = task.crank.spacing.has_value();
    if (rules.goal == MatchingGoal::fewest_moves && !rules.permitted_spread) {
        matched.goal = MatchingGoal::min_spread;
        matched.remark = Text::tr(
            "The permitted range of the crankpins is missing: they are made as equal as possible.");
    }
    if (const Message fault = crank_fault(task.crank);
        rules.goal == MatchingGoal::min_shaking && !fault.empty()) {
        matched.goal = MatchingGoal::min_spread;
        matched.remark = {
            Text::tr(
                "Shaking cannot be computed (%1): the crankpins are made as equal as possible."),
            fault};
    }
    SetSearch search = matched.goal == MatchingGoal::min_shaking ? search_of_shaking(task)
                                                                 : search_of_spread(task);
    // A scale reads to hundredths of a gram: a microgram of rounding is no violation.
    constexpr double rounding = 1e-9;
    const bool has_limit = matched.goal == MatchingGoal::fewest_moves;
    if (has_limit) {
        search.enough = *rules.permitted_spread + rounding;
    }
    const SetsFound found = best_placing(search);
    matched.pistons = found.from[0];
    matched.rods = found.from[1];
    matched.moved = found.moved;
    matched.proven = found.proven;
    matched.before = placed_by(task, unmoved_sets(n));
    matched.after = placed_by(task, found.from);
    matched.as_weighed =
        task.sheet.is_moved() ? placed_by(task, where_weighed(task.sheet)) : matched.before;
    if (has_limit && matched.after.spread > search.enough) {
        matched.remark = {
            found.proven ? Text::tr("No combination gives a range of %1: the crankpins are made "
                                    "as equal as possible. Make the heavier parts lighter.")
                         : Text::tr("No combination found gives a range of %1: the crankpins are "
                                    "made as equal as possible. Make the heavier parts lighter."),
            in_grams(*rules.permitted_spread)};
    }
    return matched;
}

void check_matching(const MatchingRules& rules, int angle_count) {
    const std::string place = "/input/weigh_in/matching/";
    if (!rules.crankpin_angles_deg.empty() &&
        rules.crankpin_angles_deg.size() != static_cast<std::size_t>(angle_count)) {
        throw InputError(place + std::string(field::crankpin_angles.key),
                         {Text::tr("must be a list of %1 angles"), angle_count},
                         Number{static_cast<double>(rules.crankpin_angles_deg.size())});
    }
    if (rules.bank_offset && !rules.cylinder_spacing) {
        throw InputError(place + std::string(field::cylinder_spacing.key),
                         Text::tr("is required with the bank offset"));
    }
}

}  // namespace ravnoves::shop
