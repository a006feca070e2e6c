#include "inertia-moments/results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "case-file/decimal.h"
#include "inertia-moments/fields.h"
#include "inertia-moments/result.h"

namespace ravnoves::inertia_moments {

namespace {

namespace key {
constexpr ResultField curves{"curves", Text::tr("Curves")};
constexpr ResultField unbalanced_curves{"unbalanced_curves", Text::tr("Curves before balancing")};
constexpr ResultField remaining_curves{"remaining_curves", Text::tr("Residual curves")};
constexpr ResultField angle{"angle_deg", Text::tr("angle"), 1};
constexpr ResultField cylinder{"cylinder", Text::tr("cylinder"), 0};
constexpr ResultField crank_angle =
    ResultField{"crank_angle_deg", Text::tr("crank angle"), 1}.with(Period::cycle);
constexpr ResultField interval =
    ResultField{"interval_deg", Text::tr("firing interval"), 1}.with(Period::none);
constexpr ResultField firing_cycle =
    ResultField{"firing_cycle_deg", Text::tr("Firing cycle"), 0}.with(Period::none);
constexpr ResultField unbalance{"unbalance_kg_m", Text::tr("unbalance"), 5};
constexpr ResultField mass{"mass_kg", Text::tr("mass")};
constexpr ResultField cancels_force{"cancels_N", Text::tr("cancels"), 1};
constexpr ResultField cancels_moment{"cancels_Nm", Text::tr("cancels"), 2};
constexpr ResultField before_force{"order_max_before_N", Text::tr("maximum before"), 1};
constexpr ResultField before_moment{"order_max_before_Nm", Text::tr("maximum before"), 2};
constexpr ResultField remaining_force{"order_max_remaining_N", Text::tr("maximum after"), 1};
constexpr ResultField remaining_moment{"order_max_remaining_Nm", Text::tr("maximum after"), 2};
/// [k − 1] is order k.
constexpr std::array<ResultField, 12> orders{{{"order_1", Text::tr("order 1")},
                                              {"order_2", Text::tr("order 2")},
                                              {"order_3", Text::tr("order 3")},
                                              {"order_4", Text::tr("order 4")},
                                              {"order_5", Text::tr("order 5")},
                                              {"order_6", Text::tr("order 6")},
                                              {"order_7", Text::tr("order 7")},
                                              {"order_8", Text::tr("order 8")},
                                              {"order_9", Text::tr("order 9")},
                                              {"order_10", Text::tr("order 10")},
                                              {"order_11", Text::tr("order 11")},
                                              {"order_12", Text::tr("order 12")}}};
}  // namespace key

/// The direction within a turn, or nothing where the amplitude is zero beside its scale.
std::optional<double> direction(Complex vector, double scale) {
    return std::abs(vector) > zero_share * scale ? std::optional(wrap_turn(std::arg(vector)))
                                                 : std::nullopt;
}

/// Of a counterweight, measured against the rotation.
std::optional<double> lag(Complex weight, double scale) {
    const auto angle = direction(weight, scale);
    return angle ? std::optional(wrap_turn(-*angle)) : std::nullopt;
}

void visit_harmonic(ResultVisitor& visitor, const ResultField& field, const Harmonic<double>& h) {
    visitor.object(field, [&] {
        visitor.number({"cos", Text::tr("cosine"), 2}, h.cos);
        visitor.number({"sin", Text::tr("sine"), 2}, h.sin);
    });
}

void visit_rotating_part(ResultVisitor& visitor, const ResultField& field, Complex vector,
                         double scale) {
    visitor.object(field, [&] {
        visitor.number({"amplitude", Text::tr("amplitude"), 2}, std::abs(vector));
        visitor.number(key::angle, direction(vector, scale));
    });
}

void visit_pair(ResultVisitor& visitor, const ResultField& field, const RotatingPair& pair,
                double scale) {
    visitor.object(field, [&] {
        visit_harmonic(visitor, {"horizontal", Text::tr("horizontal")}, pair.horizontal());
        visit_harmonic(visitor, {"vertical", Text::tr("vertical")}, pair.vertical());
        visit_rotating_part(visitor, {"forward", Text::tr("forward part")}, pair.forward, scale);
        visit_rotating_part(visitor, {"backward", Text::tr("backward part")}, pair.backward, scale);
    });
}

const ResultField& order_key(int order) {
    return key::orders.at(static_cast<std::size_t>(order) - 1);
}

void visit_orders(ResultVisitor& visitor, const ResultField& field, const EngineOrders& orders) {
    visitor.object(field, [&] {
        for (const EngineOrder& order : orders.orders) {
            visitor.object(order_key(order.order), [&] {
                visit_pair(visitor, {"force_N", Text::tr("force"), 1}, order.force,
                           order.force_scale);
                visit_pair(visitor, {"moment_Nm", Text::tr("moment"), 2}, order.moment,
                           order.moment_scale);
                visitor.object({"roll_moment_Nm", Text::tr("roll moment"), 2}, [&] {
                    visit_harmonic(visitor, {"inertia", Text::tr("from offsets and rods")},
                                   order.inertia_roll);
                    visit_harmonic(visitor, {"reaction_torque", Text::tr("reaction torque")},
                                   order.reaction_torque);
                    visit_harmonic(visitor, {"total", Text::tr("sum")}, order.roll());
                });
            });
        }
    });
}

void visit_throws(ResultVisitor& visitor, const Engine& engine) {
    visitor.list({"throws", Text::tr("Crank throws")}, engine.throws.size(), [&](std::size_t i) {
        const Throw& pin = engine.throws[i];
        std::vector<int> cylinders;
        for (const std::size_t cylinder : pin.cylinders) {
            cylinders.push_back(static_cast<int>(cylinder) + 1);
        }
        visitor.integers({"cylinders"}, cylinders);
        visitor.number({"axial_position_mm", Text::tr("axial position"), 1}, pin.position);
        visitor.number({"crankpin_angle_deg", Text::tr("crankpin angle"), 1},
                       wrap_turn(pin.crankpin_angle));
        visitor.number({"rotating_mass_kg", Text::tr("rotating mass")}, engine.mass_on(pin));
    });
}

/// With what their input leaves out filled in.
void visit_articulated_rods(ResultVisitor& visitor, const Engine& engine) {
    std::vector<std::size_t> cylinders;
    for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
        if (engine.cylinders[i].articulated) {
            cylinders.push_back(i);
        }
    }
    if (cylinders.empty()) {
        return;
    }
    visitor.list(
        {"articulated_rods", Text::tr("Articulated rods")}, cylinders.size(), [&](std::size_t i) {
            const auto& rod = *engine.cylinders[cylinders[i]].articulated;
            visitor.integer(key::cylinder, static_cast<long long>(cylinders[i]) + 1);
            visitor.integer({"master", Text::tr("master cylinder"), 0}, rod.master);
            visitor.number({"knuckle_radius_mm", Text::tr("knuckle radius"), 2},
                           rod.knuckle_radius);
            visitor.number({"knuckle_angle_deg", Text::tr("knuckle angle"), 2}, rod.knuckle_angle);
            visitor.number({"rod_length_mm", Text::tr("rod length"), 2}, rod.rod_length);
        });
}

void visit_rotating_masses(ResultVisitor& visitor, const RotatingMasses& rotating) {
    visitor.object({"rotating", Text::tr("Rotating masses")}, [&] {
        const Complex force = rotating.force_factor;
        const Complex moment = rotating.moment_factor;
        visitor.number({"force_factor", Text::tr("force factor")}, std::abs(force));
        visitor.number({"force_angle_deg", Text::tr("angle of the force"), 1},
                       direction(force, rotating.force_scale));
        visitor.number({"moment_factor_m", Text::tr("moment factor about mean z"), 4,
                        Text::tr("About the mean axial position of the crankpins.")},
                       std::abs(moment));
        visitor.number({"moment_angle_deg", Text::tr("angle of the moment"), 1},
                       direction(moment, rotating.moment_scale));
        visitor.number({"force_N", Text::tr("force"), 1}, std::abs(rotating.force()));
        visitor.number({"moment_Nm", Text::tr("moment about mean z"), 2,
                        Text::tr("About the mean axial position of the crankpins.")},
                       std::abs(rotating.moment()));
        visitor.number({"counterweight_force_lag_deg",
                        Text::tr("lag of the counterweight against the force"), 1},
                       lag(-force, rotating.force_scale));
        visitor.number({"counterweight_moment_lag_deg",
                        Text::tr("lag of the counterweights against the moment"), 1},
                       lag(-moment, rotating.moment_scale));
    });
}

void visit_quantity(ResultVisitor& visitor, const ResultField& field, const Difference& horizontal,
                    const Difference& vertical) {
    visitor.object(field, [&] {
        visitor.number({"horizontal_percent", Text::tr("horizontal"), 1}, horizontal.relative);
        visitor.number({"vertical_percent", Text::tr("vertical"), 1}, vertical.relative);
    });
}

void visit_differences(ResultVisitor& visitor, const Result& result) {
    visitor.object({"difference", Text::tr("Difference of the two-term form")}, [&] {
        // compare() gives the components of an order in this order.
        constexpr std::size_t components = 5;
        const std::span<const Difference> all(result.differences);
        for (std::size_t i = 0; i + components <= all.size(); i += components) {
            visitor.object(order_key(all[i].order), [&] {
                visit_quantity(visitor, {"force", Text::tr("force")}, all[i], all[i + 1]);
                visit_quantity(visitor, {"moment", Text::tr("moment")}, all[i + 2], all[i + 3]);
                visitor.number({"roll_moment_percent", Text::tr("roll moment"), 1},
                               all[i + 4].relative);
            });
        }
        visitor.texts({"warnings"}, [&] {
            std::vector<Message> warnings;
            for (const Difference& difference : all) {
                if (difference.warning) {
                    warnings.push_back(describe(difference));
                }
            }
            return warnings;
        });
    });
}

void visit_firing(ResultVisitor& visitor, const Input& input, const Result& result) {
    if (!result.firing.empty()) {
        visitor.list({"firing", Text::tr("Firing order")}, result.firing.size(),
                     [&](std::size_t i) {
                         visitor.integer(key::cylinder, result.firing[i].cylinder);
                         visitor.number(key::crank_angle, result.firing[i].crank_angle);
                         visitor.number(key::interval, result.firing[i].interval);
                     });
        visitor.number(key::firing_cycle, input.cycle());
        visitor.flag({"fires_evenly", Text::tr("Even firing"), 0}, fires_evenly(result.firing));
    } else if (!result.firing_trouble.empty()) {
        visitor.text({"firing_reason"}, result.firing_trouble);
    }
}

template <typename Enum>
std::string_view word(std::span<const Word> words, Enum value) {
    return words[static_cast<std::size_t>(value)].word;
}

void visit_shafts(ResultVisitor& visitor, const std::vector<ShaftDesign>& shafts) {
    if (shafts.empty()) {
        return;
    }
    visitor.list({"balance_shafts", Text::tr("Balance shafts")}, shafts.size(), [&](std::size_t i) {
        const ShaftDesign& design = shafts[i];
        const bool force = design.shaft.balances == Balances::force;
        visitor.integer({"order", Text::tr("order"), 0}, design.shaft.order);
        visitor.word({"direction"}, word(field::directions, design.shaft.direction));
        visitor.word({"balances"}, word(field::tasks, design.shaft.balances));
        visitor.number(key::unbalance, design.unbalance);
        visitor.number(key::mass, design.mass);
        visitor.number({"phase_deg", Text::tr("phase"), 1},
                       design.phase ? std::optional(wrap_turn(*design.phase)) : std::nullopt);
        visitor.number(force ? key::cancels_force : key::cancels_moment, std::abs(design.target));
        visitor.number(force ? key::before_force : key::before_moment, design.before);
        visitor.number(force ? key::remaining_force : key::remaining_moment, design.remaining);
    });
}

void visit_counterweights(ResultVisitor& visitor, const CounterweightDesign& design) {
    const double scale = std::abs(design.against_force) + std::abs(design.against_moment) +
                         std::abs(design.front.unbalance) + std::abs(design.rear.unbalance);
    const auto visit = [&](const ResultField& field, const Counterweight& weight) {
        visitor.object(field, [&] {
            visitor.number(key::unbalance, std::abs(weight.unbalance));
            visitor.number(key::mass, weight.mass());
            visitor.number(key::angle, direction(weight.unbalance, scale));
            visitor.number({"lag_deg", Text::tr("lag"), 1}, lag(weight.unbalance, scale));
        });
    };
    visitor.object({"counterweights", Text::tr("Counterweights")}, [&] {
        visit({"front", Text::tr("front")}, design.front);
        visit({"rear", Text::tr("rear")}, design.rear);
        visitor.number({"force_unbalance_kg_m", Text::tr("unbalance against the force"), 5},
                       std::abs(design.against_force));
        visitor.number({"moment_unbalance_kg_m", Text::tr("unbalance against the moment"), 5},
                       std::abs(design.against_moment));
    });
}

void visit_curves(ResultVisitor& visitor, const ResultField& field, const WrenchCurves& curves) {
    visitor.object(field, [&] {
        visitor.numbers(key::crank_angle, curves.crank_angle);
        visitor.numbers({"force_x_N", Text::tr("horizontal force"), 1}, curves.force_x);
        visitor.numbers({"force_y_N", Text::tr("vertical force"), 1}, curves.force_y);
        visitor.numbers({"moment_x_Nm", Text::tr("moment about x"), 2}, curves.moment_x);
        visitor.numbers({"moment_y_Nm", Text::tr("moment about y"), 2}, curves.moment_y);
        visitor.numbers({"inertia_roll_Nm", Text::tr("roll moment from offsets and rods"), 2},
                        curves.inertia_roll);
        visitor.numbers({"reaction_torque_Nm", Text::tr("reaction torque"), 2},
                        curves.reaction_torque);
        visitor.numbers({"roll_moment_Nm", Text::tr("roll moment"), 2}, curves.roll);
    });
}

}  // namespace

void visit_results(ResultVisitor& visitor, const Input& input, const Result& result) {
    visitor.set_turns_of_cycle(input.strokes / 2);
    visit_verdict(visitor, [&] { return verdict(input, result); });
    const Engine& engine = result.engine;
    std::vector<double> pins;
    std::vector<double> tops;
    std::vector<double> strokes;
    for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
        pins.push_back(wrap_turn(engine.cylinders[i].crankpin_angle));
        tops.push_back(engine.top_dead_centre(i));
        strokes.push_back(engine.stroke(i));
    }
    visitor.numbers({"crankpin_angle_deg", Text::tr("Crankpin angle"), 1}, pins);
    if (input.layout) {
        visitor.number({"tdc_angle_deg", Text::tr("Crank angle at TDC"), 2,
                        Text::tr("From the cylinder's axis, without sign.")},
                       std::abs(tops.front()));
    }
    visitor.numbers({"cylinder_tdc_angle_deg", Text::tr("Crank angle at TDC of each cylinder"), 2},
                    tops);
    visitor.numbers({"cylinder_stroke_mm", Text::tr("Stroke"), 2}, strokes);
    visit_articulated_rods(visitor, engine);
    visit_orders(visitor, {"two_term", Text::tr("Two-term")}, result.two_term);
    visit_orders(visitor, {"exact", Text::tr("Exact")}, result.exact);
    visit_rotating_masses(visitor, result.rotating);
    visit_throws(visitor, engine);
    visit_differences(visitor, result);
    visit_firing(visitor, input, result);
    visitor.texts(ravnoves::result_field::notes, result.notes);
    visit_shafts(visitor, result.shafts);
    if (result.counterweights) {
        visit_counterweights(visitor, *result.counterweights);
    }
    visit_orders(visitor,
                 {"unbalanced", Text::tr("Before balancing"), 3,
                  Text::tr("Exact orders with the rotating masses.")},
                 result.unbalanced);
    visit_orders(visitor, {"remaining", Text::tr("Residual forces and moments")}, result.remaining);
    if (input.step) {
        visit_curves(visitor, key::curves, result.curves);
        visit_curves(visitor, key::unbalanced_curves, result.unbalanced_curves);
        visit_curves(visitor, key::remaining_curves, result.remaining_curves);
    }
}

void visit_results(ResultVisitor& visitor, const Input& input) {
    const bool with_curves = visitor.wants(key::curves.key) ||
                             visitor.wants(key::unbalanced_curves.key) ||
                             visitor.wants(key::remaining_curves.key);
    visit_results(visitor, input, solve(input, with_curves));
}

namespace {

/// Of the orders that matter the one with the largest residual; null where all are balanced.
const EngineOrder* largest(const EngineOrders& remaining, RotatingPair EngineOrder::*what,
                           double EngineOrder::*scale) {
    constexpr int orders_that_matter = 4;
    const EngineOrder* found = nullptr;
    double maximum = 0.0;
    for (const EngineOrder& order : remaining.orders) {
        const double size = (order.*what).max();
        if (order.order <= orders_that_matter && size > zero_share * order.*scale &&
            size > maximum) {
            found = &order;
            maximum = size;
        }
    }
    return found;
}

/// The largest residuals, without warnings.
Verdict residual_verdict(const EngineOrders& remaining) {
    Message text;
    if (const EngineOrder* order =
            largest(remaining, &EngineOrder::force, &EngineOrder::force_scale)) {
        text = {Text::tr("Maximum residual force: %1, order %2."),
                Number{rounded_to_digits(order->force.max(), 4), units::newton}, order->order};
    }
    if (const EngineOrder* order =
            largest(remaining, &EngineOrder::moment, &EngineOrder::moment_scale)) {
        const Message moment{Text::tr("Maximum residual moment: %1, order %2."),
                             Number{rounded_to_digits(order->moment.max(), 4), units::N_m},
                             order->order};
        text = text.empty() ? moment : Message(Text{"%1 %2"}, text, moment);
    }
    return text.empty() ? Verdict{Severity::good, Text::tr("Forces and moments of orders 1 to 4 "
                                                           "are balanced.")}
                        : Verdict{Severity::note, text};
}

}  // namespace

Verdict verdict(const Input& input, const Result& result) {
    Verdict verdict = residual_verdict(result.remaining);
    for (const Message& note : result.notes) {
        verdict.warn(note);
    }
    const auto rank = [](const Difference& each) { return each.warning ? each.of_largest : -1.0; };
    const auto worst = std::ranges::max_element(result.differences, {}, rank);
    if (worst->warning && input.shaft_basis == DesignBasis::two_term && !result.shafts.empty()) {
        verdict.warn({Text::tr("The shafts are designed by the two-term form, which is "
                               "inaccurate here: %1."),
                      describe(*worst)});
    }
    return verdict;
}

}  // namespace ravnoves::inertia_moments
