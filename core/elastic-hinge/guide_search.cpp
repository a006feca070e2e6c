#include "elastic-hinge/guide_search.h"

#include <algorithm>
#include <cmath>

#include "case-file/decimal.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"

namespace ravnoves::elastic_hinge {

namespace {

Number millimetres(double length) {
    return {rounded_to_decimals(length / units::mm, 3), units::mm};
}

/// The smallest d_min whose preload √(d_min² + G) is more than the smallest one, √G, by the margin
/// that is wanted. G = maximum energy / 2c grows with d_min as c falls: d_min² = m² + 2 m √G, by
/// iteration.
double deflection_with_margin(const GuideWish& wish, double max_share) {
    const double margin = wish.preload_margin;
    double minimum = margin;
    constexpr int enough = 60;  // each takes off three quarters of the error
    for (int i = 0; i < enough; ++i) {
        const double energy = max_share * wish.relief * (2.0 * minimum + wish.relief);
        minimum = std::sqrt(margin * margin + 2.0 * margin * std::sqrt(energy));
    }
    return minimum;
}

}  // namespace

GuideProposal search_guide(const std::shared_ptr<const Design>& design, const Input& input,
                           Branch branch) {
    GuideProposal proposal;
    proposal.branch = branch;
    const auto reject = [&](Message reason) {
        proposal.reason = std::move(reason);
        return proposal;
    };
    if (!input.spring) {
        return reject(Text::tr("no spring is given: enter its free length"));
    }
    if (!design->has_exact_kinematics()) {
        return reject(Text::tr("at λ = 1 the mechanism locks: no guide"));
    }
    const DemandRange& range = design->range(Hinge::crank);
    const double span = range.span();
    if (!(span > 0.0)) {
        return reject(Text::tr("the hinge releases no energy: its guide is a circle"));
    }
    const double max_energy = input.guide_sign == GuideSign::as_printed ? -range.min : range.max;

    const GuideWish wish = input.guide_search.value_or(GuideWish{});
    const double free_length = input.spring->free_length;
    const double roller_radius = input.roller_radius;
    const double relief = wish.relief;
    const double half = 0.5 * free_length;
    const double limit = 0.5 * wish.outer_diameter - roller_radius;  // of the roller centre's path
    const double shortest = wish.shortest(free_length);

    // Bounds of the smallest deflection d_min.
    const double min_deflection =
        std::max(0.1 * relief, deflection_with_margin(wish, std::max(0.0, max_energy / span)));
    double low = min_deflection;
    double high = 0.0;
    if (branch == Branch::compressed) {
        low = std::max(low, half - limit);
        high = 0.5 * (free_length - shortest) - relief;
        if (high < min_deflection) {
            return reject({Text::tr("a spring of %1 with a minimum length of %2 has no room for a "
                                    "relief of %3; it must be at least %4 long"),
                           millimetres(free_length), millimetres(shortest), millimetres(relief),
                           millimetres(shortest + 2.0 * (min_deflection + relief))});
        }
        const double needed = 2.0 * (half - high + roller_radius);
        if (low > high) {
            return reject({Text::tr("a compressed spring of %1 with a minimum length of %2 needs "
                                    "an outer diameter of at least %3 for a relief of %4"),
                           millimetres(free_length), millimetres(shortest), millimetres(needed),
                           millimetres(relief)});
        }
    } else {
        high = limit - half - relief;
        const double needed = 2.0 * (half + min_deflection + relief + roller_radius);
        if (low > high) {
            return reject({Text::tr("a stretched spring of %1 with a relief of %2 needs an outer "
                                    "diameter of at least %3"),
                           millimetres(free_length), millimetres(relief), millimetres(needed)});
        }
    }

    const auto spring_for = [&](double minimum) {
        Spring spring;
        spring.free_length = free_length;
        spring.stiffness = span / (2.0 * relief * (2.0 * minimum + relief));
        const double start = std::sqrt(minimum * minimum + max_energy / (2.0 * spring.stiffness));
        spring.guide_radius_at_zero = branch == Branch::compressed ? half - start : half + start;
        return spring;
    };
    const auto follows = [&](double minimum) {
        return !make_guide(design, Hinge::crank, spring_for(minimum), input, true)
                    .summary(branch)
                    .undercut;
    };
    // More preload usually smooths the guide, but not always: look everywhere, then sharpen.
    constexpr int looks = 64;
    const auto look = [&](int i) {
        return i == looks ? high : low * std::pow(high / low, static_cast<double>(i) / looks);
    };
    int first = 0;
    while (first <= looks && !follows(look(first))) {
        ++first;
    }
    if (first > looks) {
        return reject({Text::tr("a roller of radius %1 undercuts every guide with a relief of %2: "
                                "use a smaller roller or less relief"),
                       millimetres(roller_radius), millimetres(relief)});
    }
    double minimum = look(first);
    for (double bad = first == 0 ? minimum : look(first - 1); minimum - bad > 1e-9 * free_length;) {
        const double middle = 0.5 * (bad + minimum);
        (follows(middle) ? minimum : bad) = middle;
    }

    proposal.spring = spring_for(minimum);
    try {
        check_fields(proposal.spring);
    } catch (const InputError&) {
        return reject({Text::tr("the required stiffness, %1, is out of range"),
                       Number{proposal.spring.stiffness, units::N_per_m}});
    }
    const double maximum = minimum + relief;
    proposal.found = true;
    proposal.relief = relief;
    proposal.outer_diameter =
        2.0 * (roller_radius + (branch == Branch::compressed ? half - minimum : half + maximum));
    proposal.smallest_spring_length =
        branch == Branch::compressed ? free_length - 2.0 * maximum : free_length + 2.0 * minimum;
    proposal.largest_spring_force = 2.0 * proposal.spring.stiffness * maximum;
    proposal.largest_spring_energy = 2.0 * proposal.spring.stiffness * maximum * maximum;
    return proposal;
}

bool meets_wish(const Guide& guide, const Input& input) {
    if (!guide.feasible) {
        return false;
    }
    const GuideWish wish = input.guide_search.value_or(GuideWish{});
    constexpr double rounding = 1e-6;  // m
    return guide.relief >= wish.relief - rounding &&
           2.0 * (input.roller_radius + guide.summary().max_radius) <=
               wish.outer_diameter + rounding &&
           2.0 * guide.summary().min_radius >=
               wish.shortest(input.spring->free_length) - rounding &&
           guide.preload - guide.minimum_preload >= wish.preload_margin - rounding &&
           !guide.summary().undercut;
}

}  // namespace ravnoves::elastic_hinge
