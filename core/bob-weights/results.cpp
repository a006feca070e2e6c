#include "bob-weights/results.h"

#include <algorithm>
#include <functional>
#include <string>

#include "bob-weights/factor_theory.h"
#include "bob-weights/fields.h"
#include "bob-weights/solver.h"
#include "numerics/demand.h"
#include "shop/results.h"
#include "shop/sentences.h"

namespace ravnoves::bob_weights {

namespace {

using ravnoves::result_field::feasible;
using ravnoves::result_field::reason;
namespace key {
constexpr ResultField reciprocating_percent{"reciprocating_percent", Text::tr("Balance factor"), 1};
constexpr ResultField not_counted{"not_counted"};
constexpr ResultField crankpins{"crankpins_g", Text::tr("Bob weights of the crankpins"), 1};
constexpr ResultField permissible{"permissible_g_mm", Text::tr("Permissible"), 1};
constexpr ResultField correction{"correction", Text::tr("Correction")};
constexpr ResultField planes{"planes", Text::tr("Plane")};
constexpr ResultField unbalance{"unbalance_g_mm", Text::tr("Unbalance"), 1};
constexpr ResultField angle{"angle_deg", Text::tr("Heavy spot"), 1};
constexpr ResultField holes{"holes", Text::tr("Hole")};
constexpr ResultField slugs{"slugs", Text::tr("Slug")};
constexpr ResultField remaining{"remaining_g_mm", Text::tr("Residual"), 1};
constexpr ResultField remaining_angle{"remaining_angle_deg", Text::tr("Direction of the residual"),
                                      1};
constexpr ResultField within{"within_tolerance", Text::tr("Within tolerance")};
}  // namespace key

std::vector<Message> keys_of(const auto& parts, const auto& part_of) {
    std::vector<Message> keys;
    for (const auto& each : parts) {
        keys.emplace_back(part_of(each)->field.key);
    }
    return keys;
}

/// Visits the values of one result.
class JobVisit {
  public:
    JobVisit(ResultVisitor& visitor, const Input& input, const Result& result)
        : visitor_(visitor), input_(input), result_(result) {}

    void visit_all() {
        RAVNOVES_DEMAND(result_.reciprocating && result_.rotating,
                        "what is written is the result of a whole input");
        visitor_.number({"reciprocating_g", Text::tr("Reciprocating mass"), 1,
                         Text::tr("Mass of one cylinder.")},
                        result_.reciprocating);
        visitor_.number(
            {"rotating_g", Text::tr("Rotating mass"), 1, Text::tr("Mass of one cylinder.")},
            result_.rotating);
        visitor_.number(key::reciprocating_percent, result_.factor);
        visit_bob_weight();
        visitor_.object({"theory", Text::tr("Theory")}, [&] { visit_theory(); });
        visitor_.texts({"not_given"},
                       keys_of(result_.not_given, [](const PartField* part) { return part; }));
        if (visitor_.wants(key::not_counted.key)) {
            visitor_.texts(key::not_counted, shop::both(replaced(input_), not_counted(input_)));
        }
        visitor_.texts({"looks_like_kilograms"},
                       keys_of(result_.in_kilograms, [](const auto& each) { return each.first; }));
        if (input_.weigh_in) {
            visitor_.object(shop::result_field::weigh_in, [&] { visit_weigh_in(); });
        }
        if (result_.permissible) {
            visitor_.numbers(key::permissible,
                             {(*result_.permissible)[0], (*result_.permissible)[1]});
        }
        if (result_.permissible_whole) {
            visitor_.number({"permissible_rotor_g_mm", Text::tr("Permissible, whole shaft"), 1},
                            result_.permissible_whole);
        }
        if (result_.newest() != nullptr) {
            visitor_.object(key::correction, [&] { visit_correction(); });
        }
    }

    void visit_bob_weight() {
        visitor_.number({"bobweight_g", Text::tr("Bob weight"), 1}, result_.bob_weight);
        visitor_.integer({"bobweights", Text::tr("Number of bob weights")},
                         input_.engine.crankpins());
        if (!result_.bob_weight) {
            visitor_.nothing({"lines"});
            return;
        }
        shop::visit_lines(visitor_, result_.lines);
    }

    void visit_planes() {
        visitor_.list(key::planes, 2, [&](std::size_t i) { visit_plane(i); });
    }

  private:
    /// @param planned  it is not there yet
    void visit_hole(const Hole& hole, bool added, bool planned) {
        // A slug takes off less than nothing: so every line counts in the same sense.
        const double sign = added ? -1.0 : 1.0;
        visitor_.number({"diameter_mm", Text::tr("Diameter"), 2}, hole.diameter);
        visitor_.number({"depth_mm", Text::tr("Depth"), 1}, hole.depth);
        visitor_.number({"angle_deg", Text::tr("Angle"), 1}, hole.angle);
        visitor_.number({"removed_g", Text::tr("Takes off"), 2}, sign * hole.mass);
        visitor_.number({"removed_g_mm", Text::tr("Takes off, unbalance"), 1},
                        sign * hole.unbalance);
        if (added) {
            visitor_.number({"added_g", Text::tr("Adds"), 2}, hole.mass);
            visitor_.number({"added_g_mm", Text::tr("Adds, unbalance"), 1}, hole.unbalance);
            if (hole.slug > 0.0) {
                visitor_.number({"slug_g", Text::tr("Mass of the slug"), 2}, hole.slug);
            }
            const auto speed = service_speed(input_);
            visitor_.word({"direction"}, direction_words[hole.is_axial ? 0 : 1].word);
            visitor_.number({"radius_mm", Text::tr("Radius of the hole centre"), 1,
                             Text::tr("Radius of the slug's centre about the crank "
                                      "axis.")},
                            hole.slug_radius);
            visitor_.number(
                {"centrifugal_force_N", Text::tr("Centrifugal force"), 0,
                 Text::tr("Centrifugal force of the slug at the service speed.")},
                speed && hole.slug > 0.0 ? std::optional(hole.slug_force(*speed)) : std::nullopt);
            return;
        }
        const bool is_deeper = hole.deepens && hole.from_depth > 0.0;
        visitor_.word({"deepens"}, is_deeper && planned
                                       ? "/correction/earlier_runs/" +
                                             std::to_string(hole.deepens->run) + "/drilled/" +
                                             std::to_string(hole.deepens->hole)
                                       : std::string());
        visitor_.number({"from_depth_mm", Text::tr("Depth before"), 1},
                        is_deeper ? std::optional(hole.from_depth) : std::nullopt);
    }

    void visit_holes(const ResultField& field, const std::vector<Hole>& holes, bool added,
                     bool planned) {
        visitor_.list(field, holes.size(),
                      [&](std::size_t i) { visit_hole(holes[i], added, planned); });
    }

    void visit_reading(const RunResult& run, std::size_t i) {
        visitor_.number(key::unbalance, run.unbalances()[i]);
        visitor_.number(key::angle, run.planes[i] ? run.planes[i]->angle : std::nullopt);
    }

    void visit_plane(std::size_t i) {
        const RunResult& newest = *result_.newest();
        visit_reading(newest, i);
        const auto radius =
            newest.has_vectors() ? input_.correction->planes[i].radius : std::nullopt;
        visitor_.number(
            {"grams_at_radius", Text::tr("Mass at drilling radius"), 2, {}, units::gram},
            radius ? std::optional(*newest.unbalances()[i] / *radius) : std::nullopt);
        visitor_.flag({"within_tolerance_as_measured", Text::tr("Within tolerance as measured")},
                      newest.within(i));
        if (!result_.correction) {
            for (const ResultField* field : {&key::holes, &key::slugs, &key::remaining,
                                             &key::remaining_angle, &key::within, &feasible}) {
                visitor_.nothing(*field);
            }
            return;
        }
        const PlaneResult& plane = (*result_.correction)[i];
        visit_holes(key::holes, plane.holes, false, true);
        visit_holes(key::slugs, plane.slugs, true, true);
        visitor_.number(key::remaining, plane.remaining);
        visitor_.number(key::remaining_angle, plane.remaining_angle);
        visitor_.flag(key::within, plane.within_tolerance);
        visitor_.flag(feasible, plane.reason.empty());
        if (plane.beyond_sector > 0.0) {
            visitor_.number({"edge_beyond_sector_mm", Text::tr("Edge beyond the sector"), 2},
                            plane.beyond_sector);
        }
        if (!plane.reason.empty()) {
            visitor_.text(reason, plane.reason);
        }
    }

    void visit_run(const RunResult& run, bool is_newest) {
        visitor_.list(key::planes, 2, [&](std::size_t i) {
            visit_reading(run, i);
            visitor_.flag(key::within, run.within(i));
            if (const auto& other = run.other_effect[i]; run.contradicts(i)) {
                visitor_.object({"expected", Text::tr("Expected")}, [&] {
                    visitor_.number(key::unbalance, other->expected);
                    visitor_.number(key::angle, other->expected_angle);
                    visitor_.flag(
                        {"drilling_acted_opposite", Text::tr("Drilling acted the opposite way")},
                        other->is_opposite);
                    visitor_.flag({"drilling_acted_in_other_plane",
                                   Text::tr("Drilling acted in the other plane")},
                                  other->is_in_other_plane);
                });
            }
            if (!is_newest || run.is_drilled()) {
                visit_holes({"drilled_holes", Text::tr("Drilled hole")}, run.drilled[i].holes,
                            false, false);
                visit_holes({"drilled_slugs", Text::tr("Pressed-in slug")}, run.drilled[i].slugs,
                            true, false);
            }
        });
        visitor_.flag(key::within, run.passes());
        shop::visit_other(visitor_, run.read_with, run.read_on);
    }

    void visit_correction() {
        visit_planes();
        visitor_.list({"runs", Text::tr("Run")}, result_.runs.size(), [&](std::size_t i) {
            visit_run(result_.runs[i], i + 1 == result_.runs.size());
        });
        visitor_.number({"amplification", Text::tr("Amplification of errors"), 2},
                        result_.amplification);
        shop::visit_other(visitor_, result_.newest()->read_with, result_.newest()->read_on);
    }

    void visit_weigh_in() {
        shop::visit_columns(visitor_, *input_.weigh_in);
        visitor_.numbers(key::crankpins, result_.crankpins);
        if (result_.placing) {
            visitor_.object(shop::result_field::assignment, [&] {
                shop::visit_matched(visitor_, *result_.placing,
                                    input_.weigh_in->matching.crank_radius, service_speed(input_));
                visitor_.numbers(key::crankpins, result_.placed_crankpins);
            });
        }
    }

    void visit_theory() {
        visitor_.number(key::reciprocating_percent, result_.theory_factor);
        visitor_.text(reason, factor_reason(input_.engine));
        visitor_.text({"effect"},
                      factor_effect(input_.engine, result_.factor + input_.factor.overbalance));
        visitor_.integer({"cylinders", Text::tr("Cylinders")}, is_pair(input_.engine) ? 2 : 1);
        const auto left = [&](const ResultField& field, const auto& part) {
            visitor_.number(field, result_.first_order
                                       ? std::optional(std::invoke(part, *result_.first_order))
                                       : std::nullopt);
        };
        left({"forward_g", Text::tr("Force with the crank"), 1}, &FirstOrder::forward);
        left({"backward_g", Text::tr("Force against the crank"), 1}, &FirstOrder::backward);
        left({"upright_g", Text::tr("Vertical force"), 1}, &FirstOrder::upright);
        left({"across_g", Text::tr("Horizontal force"), 1}, &FirstOrder::across);
    }

    ResultVisitor& visitor_;
    const Input& input_;
    const Result& result_;
};

}  // namespace

void visit_job(ResultVisitor& visitor, const Input& input, const Result& result) {
    JobVisit(visitor, input, result).visit_all();
}

void visit_bob_weight(ResultVisitor& visitor, const Input& input, const Result& result) {
    JobVisit(visitor, input, result).visit_bob_weight();
}

void visit_planes(ResultVisitor& visitor, const Input& input, const Result& result) {
    if (result.newest() != nullptr) {
        visitor.object(key::correction, [&] { JobVisit(visitor, input, result).visit_planes(); });
    }
}

Verdict verdict(const Input& input, const Result& result,
                const std::array<std::string, 2>& plane_names) {
    Verdict verdict{Severity::note,
                    Text::tr("No bob weights are needed: the crankpins balance one another.")};
    if (result.bob_weight) {
        const Number weight{*result.bob_weight / units::gram, units::gram, -1};
        verdict.text = {
            balances_itself(input.engine)
                ? Text::tr("No bob weights are needed: the crankpins balance one another. If you "
                           "use them: %1 each.")
            : input.engine.crankpins() == 1
                ? Text::tr("Hang a bob weight of %1 on the crankpin.")
                : Text::tr("Hang bob weights of %1 on the %2 crankpins."),
            weight, input.engine.crankpins()};
    }
    const RunResult* newest = result.newest();
    if (newest != nullptr && result.holds() && newest->is_read()) {
        verdict = {Severity::good, {}};
        shop::add_machine_verdict(verdict, newest->unbalances(), result.permissible, plane_names);
        if (verdict.text.empty()) {
            verdict = {Severity::note,
                       result.permissible
                           ? Text::tr("Enter the reading of the other plane.")
                           : Text::tr("Enter the permissible residual for a verdict.")};
        }
        if (result.correction && newest->passes() != true) {
            const auto& planes = *result.correction;
            const auto names = shop::plane_names(plane_names);
            const auto after = result.passes_after();
            verdict.severity = after == true ? Severity::warning : Severity::error;
            verdict.text = shop::two_sentences(
                verdict.text,
                result.is_planned()
                    ? Message{Text::tr("After the planned correction: %1 %3, %2 %4."),
                              shop::in_gram_millimetres(planes[0].remaining),
                              shop::in_gram_millimetres(planes[1].remaining), names[0], names[1]}
                    : Text::tr("No hole is possible."));
        }
        if (!newest->acted_as_meant()) {
            verdict.warn(
                Text::tr("The last drilling did not have the planned effect: find the "
                         "cause before drilling again."));
        }
    } else if (!result.holds()) {
        verdict.warn(shop::other_readings(result.newest()->read_with, result.newest()->read_on,
                                          result.bob_weight));
    }
    for (const auto& [part, mass] : result.in_kilograms) {
        verdict.warn({Text::tr("A mass of %1 looks like kilograms."),
                      Number{mass / units::gram, units::gram, 3}});
    }
    return verdict;
}

}  // namespace ravnoves::bob_weights
