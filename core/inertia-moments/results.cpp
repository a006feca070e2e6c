#include "inertia-moments/results.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "case-file/decimal.h"
#include "inertia-moments/fields.h"
#include "inertia-moments/result_fields.h"
#include "inertia-moments/solver.h"

namespace ravnoves::inertia_moments {

namespace {

namespace key = result_field;

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
        visitor.number(key::cosine, h.cos);
        visitor.number(key::sine, h.sin);
    });
}

void visit_rotating_part(ResultVisitor& visitor, const ResultField& field, Complex vector,
                         double scale) {
    visitor.object(field, [&] {
        visitor.number(key::amplitude, std::abs(vector));
        visitor.number(key::angle, direction(vector, scale));
    });
}

void visit_pair(ResultVisitor& visitor, const ResultField& field, const RotatingPair& pair,
                double scale) {
    visitor.object(field, [&] {
        visit_harmonic(visitor, key::horizontal, pair.horizontal());
        visit_harmonic(visitor, key::vertical, pair.vertical());
        visit_rotating_part(visitor, key::forward, pair.forward, scale);
        visit_rotating_part(visitor, key::backward, pair.backward, scale);
    });
}

const ResultField& order_key(int order) {
    return key::orders.at(static_cast<std::size_t>(order) - 1);
}

void visit_orders(ResultVisitor& visitor, const ResultField& field, const EngineOrders& orders) {
    visitor.object(field, [&] {
        for (const EngineOrder& order : orders.orders) {
            visitor.object(order_key(order.order), [&] {
                visit_pair(visitor, key::order_force, order.force, order.force_scale);
                visit_pair(visitor, key::order_moment, order.moment, order.moment_scale);
                visitor.object(key::roll_moment, [&] {
                    visit_harmonic(visitor, key::inertia, order.inertia_roll);
                    visit_harmonic(visitor, key::reaction_torque, order.reaction_torque);
                    visit_harmonic(visitor, key::total, order.roll());
                });
            });
        }
    });
}

void visit_throws(ResultVisitor& visitor, const Engine& engine) {
    visitor.list(key::throws, engine.throws.size(), [&](std::size_t i) {
        const Throw& pin = engine.throws[i];
        std::vector<int> cylinders;
        for (const std::size_t cylinder : pin.cylinders) {
            cylinders.push_back(static_cast<int>(cylinder) + 1);
        }
        visitor.integers(key::cylinders, cylinders);
        visitor.number(key::axial_position, pin.position);
        visitor.number(key::crankpin_angle, wrap_turn(pin.crankpin_angle));
        visitor.number(key::rotating_mass, engine.mass_on(pin));
    });
}

/// With what their input leaves out filled in.
void visit_articulated_rods(ResultVisitor& visitor, const Engine& engine) {
    std::vector<std::size_t> cylinders;
    for (std::size_t i = 0; i < engine.knuckles.size(); ++i) {
        if (engine.knuckles[i]) {
            cylinders.push_back(i);
        }
    }
    if (cylinders.empty()) {
        return;
    }
    visitor.list(key::articulated_rods, cylinders.size(), [&](std::size_t i) {
        const auto& rod = *engine.knuckles[cylinders[i]];
        visitor.integer(key::cylinder, static_cast<long long>(cylinders[i]) + 1);
        visitor.integer(key::master, static_cast<long long>(rod.master) + 1);
        visitor.number(key::knuckle_radius, rod.knuckle_radius);
        visitor.number(key::knuckle_angle, rod.knuckle_angle);
        visitor.number(key::rod_length, rod.rod_length);
    });
}

void visit_rotating_masses(ResultVisitor& visitor, const RotatingMasses& rotating) {
    visitor.object(key::rotating, [&] {
        const Complex force = rotating.force_factor;
        const Complex moment = rotating.moment_factor;
        visitor.number(key::force_factor, std::abs(force));
        visitor.number(key::force_angle, direction(force, rotating.force_scale));
        visitor.number(key::moment_factor, std::abs(moment));
        visitor.number(key::moment_angle, direction(moment, rotating.moment_scale));
        visitor.number(key::rotating_force, std::abs(rotating.force()));
        visitor.number(key::rotating_moment, std::abs(rotating.moment()));
        visitor.number(key::force_lag, lag(-force, rotating.force_scale));
        visitor.number(key::moment_lag, lag(-moment, rotating.moment_scale));
    });
}

void visit_quantity(ResultVisitor& visitor, const ResultField& field, const Difference& horizontal,
                    const Difference& vertical) {
    visitor.object(field, [&] {
        visitor.number(key::force_horizontal_percent, horizontal.relative);
        visitor.number(key::force_vertical_percent, vertical.relative);
    });
}

void visit_differences(ResultVisitor& visitor, const Result& result) {
    visitor.object(key::difference, [&] {
        // compare() gives the components of an order in this order.
        constexpr std::size_t components = 5;
        const std::span<const Difference> all(result.differences);
        for (std::size_t i = 0; i + components <= all.size(); i += components) {
            visitor.object(order_key(all[i].order), [&] {
                visit_quantity(visitor, key::difference_force, all[i], all[i + 1]);
                visit_quantity(visitor, key::difference_moment, all[i + 2], all[i + 3]);
                visitor.number(key::roll_moment_percent, all[i + 4].relative);
            });
        }
        visitor.texts(key::warnings, [&] {
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
        visitor.list(key::firing, result.firing.size(), [&](std::size_t i) {
            visitor.integer(key::cylinder, result.firing[i].cylinder);
            visitor.number(key::crank_angle, result.firing[i].crank_angle);
            visitor.number(key::interval, result.firing[i].interval);
        });
        visitor.number(key::firing_cycle, input.cycle());
        visitor.flag(key::fires_evenly, fires_evenly(result.firing));
    } else if (!result.firing_trouble.empty()) {
        visitor.text(key::firing_reason, result.firing_trouble);
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
    visitor.list(key::balance_shafts, shafts.size(), [&](std::size_t i) {
        const ShaftDesign& design = shafts[i];
        const bool force = design.shaft.balances == Balances::force;
        visitor.integer(key::order, design.shaft.order);
        visitor.word(key::direction, word(field::directions, design.shaft.direction));
        visitor.word(key::balances, word(field::tasks, design.shaft.balances));
        visitor.number(key::unbalance, design.unbalance);
        visitor.number(key::mass, design.mass);
        visitor.number(key::phase,
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
            visitor.number(key::lag, lag(weight.unbalance, scale));
        });
    };
    visitor.object(key::counterweights, [&] {
        visit(key::front, design.front);
        visit(key::rear, design.rear);
        visitor.number(key::force_unbalance, std::abs(design.against_force));
        visitor.number(key::moment_unbalance, std::abs(design.against_moment));
    });
}

void visit_curves(ResultVisitor& visitor, const ResultField& field, const WrenchCurves& curves) {
    visitor.object(field, [&] {
        visitor.numbers(key::crank_angle, curves.crank_angle);
        visitor.numbers(key::force_x, curves.force_x);
        visitor.numbers(key::force_y, curves.force_y);
        visitor.numbers(key::moment_x, curves.moment_x);
        visitor.numbers(key::moment_y, curves.moment_y);
        visitor.numbers(key::inertia_roll, curves.inertia_roll);
        visitor.numbers(key::reaction, curves.reaction_torque);
        visitor.numbers(key::roll, curves.roll);
    });
}

}  // namespace

void visit_results(ResultVisitor& visitor, const Input& input, const Result& result) {
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
    visitor.numbers(key::crankpin_angles, pins);
    if (result.tdc_angle) {
        visitor.number(key::tdc_angle, result.tdc_angle);
    }
    visitor.numbers(key::cylinder_tdc_angles, tops);
    visitor.numbers(key::cylinder_strokes, strokes);
    visit_articulated_rods(visitor, engine);
    visit_orders(visitor, key::two_term, result.two_term);
    visit_orders(visitor, key::exact, result.exact);
    visit_rotating_masses(visitor, result.rotating);
    visit_throws(visitor, engine);
    visit_differences(visitor, result);
    visit_firing(visitor, input, result);
    visitor.texts(ravnoves::result_field::notes, result.notes);
    visit_shafts(visitor, result.shafts);
    if (result.counterweights) {
        visit_counterweights(visitor, *result.counterweights);
    }
    visit_orders(visitor, key::unbalanced, result.unbalanced);
    visit_orders(visitor, key::remaining, result.remaining);
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

/// The largest residuals of the orders that matter, without warnings.
Verdict residual_verdict(const EngineOrders& remaining) {
    constexpr int orders_that_matter = 4;
    const EngineOrder* force = nullptr;
    const EngineOrder* moment = nullptr;
    for (const EngineOrder& order : remaining.orders) {
        if (order.order > orders_that_matter) {
            break;
        }
        if (order.force.max() > zero_share * order.force_scale &&
            (force == nullptr || order.force.max() > force->force.max())) {
            force = &order;
        }
        if (order.moment.max() > zero_share * order.moment_scale &&
            (moment == nullptr || order.moment.max() > moment->moment.max())) {
            moment = &order;
        }
    }
    if (force == nullptr && moment == nullptr) {
        return {Severity::good,
                Message(CORE_TEXT("inertia-moments",
                                  "Forces and moments of orders 1 to 4 are balanced."))};
    }
    std::vector<Message> said;
    if (force != nullptr) {
        said.emplace_back(CORE_TEXT("inertia-moments", "Maximum residual force: %1, order %2."),
                          Number{rounded_to_digits(force->force.max(), 4), units::newton},
                          force->order);
    }
    if (moment != nullptr) {
        said.emplace_back(CORE_TEXT("inertia-moments", "Maximum residual moment: %1, order %2."),
                          Number{rounded_to_digits(moment->moment.max(), 4), units::N_m},
                          moment->order);
    }
    return {Severity::note,
            said.size() == 1 ? said.front() : Message(Text{"", "%1 %2"}, said[0], said[1])};
}

}  // namespace

Verdict verdict(const Input& input, const Result& result) {
    Verdict verdict = residual_verdict(result.remaining);
    for (const Message& note : result.notes) {
        verdict.warn(note);
    }
    const Difference* worst = nullptr;
    for (const Difference& difference : result.differences) {
        if (difference.warning && (worst == nullptr || difference.of_largest > worst->of_largest)) {
            worst = &difference;
        }
    }
    if (worst != nullptr && input.shaft_basis == DesignBasis::two_term && !result.shafts.empty()) {
        verdict.warn({CORE_TEXT("inertia-moments",
                                "The shafts are designed by the two-term form, which is "
                                "inaccurate here: %1."),
                      describe(*worst)});
    }
    return verdict;
}

}  // namespace ravnoves::inertia_moments
