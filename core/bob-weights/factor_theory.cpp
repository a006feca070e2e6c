#include "bob-weights/factor_theory.h"

#include <algorithm>
#include <cmath>

namespace ravnoves::bob_weights {

namespace {

/// Shares of the reciprocating mass of one cylinder under it are rounding.
constexpr double nothing = 1e-9;

/// γ of the pair: of a boxer whose two rods share a crankpin half a turn.
double bank_angle(const Engine& engine) {
    return engine.type == EngineType::v ? engine.bank_angle.value_or(0.0) : pi;
}

double backward_share(const Engine& engine) {
    return is_pair(engine) ? std::cos(bank_angle(engine) + 0.5 * engine.pin_split) : 0.5;
}

double forward_share(const Engine& engine) {
    return is_pair(engine) ? std::cos(0.5 * engine.pin_split) : 0.5;
}

Number degrees(double angle) {
    return {angle / degree, units::degree, 4};
}

Number percent(double share) {
    return {100.0 * share, units::percent, 3};
}

}  // namespace

bool is_pair(const Engine& engine) {
    return engine.rods_per_pin == 2 || engine.pin_split != 0.0;
}

ForcePath force_path(const FirstOrder& force) {
    constexpr int steps = 180;
    ForcePath path;
    for (int i = 0; i <= steps; ++i) {
        const double phi = two_pi * i / steps;
        path.across.push_back((force.forward - force.backward) * std::sin(phi));
        path.upright.push_back((force.forward + force.backward) * std::cos(phi));
    }
    return path;
}

FirstOrder first_order(const Engine& engine, double factor, double reciprocating_mass) {
    return {reciprocating_mass * (1.0 - 2.0 * factor) * forward_share(engine),
            reciprocating_mass * backward_share(engine)};
}

double theory_factor(const Engine& engine) {
    if (engine.pin_split == 0.0) {
        return 0.5;
    }
    const double ratio = std::abs(backward_share(engine)) / forward_share(engine);
    return 0.5 * std::max(0.0, 1.0 - (ratio < nothing ? 0.0 : ratio));
}

Message factor_reason(const Engine& engine) {
    const double left = std::abs(backward_share(engine));
    if (engine.type == EngineType::v && is_pair(engine)) {
        if (engine.pin_split != 0.0) {
            if (left < nothing) {
                return {
                    Text::tr(
                        "Banks at %1, crankpins split by %2: the backward parts of the first order "
                        "cancel, 50 % balances the rest. First-order force fully balanced."),
                    degrees(bank_angle(engine)), degrees(engine.pin_split)};
            }
            if (left > forward_share(engine)) {
                return {Text::tr("Banks at %1, crankpins split by %2: %3 of the reciprocating "
                                 "mass turns against the crank, with the crank only %4 even at 0 "
                                 "%. With a backward balance shaft use 50 %."),
                        degrees(bank_angle(engine)), degrees(engine.pin_split), percent(left),
                        percent(forward_share(engine))};
            }
            return {Text::tr("Banks at %1, crankpins split by %2: %3 of the reciprocating mass "
                             "turns against the crank. At %4 the residual is a straight motion, "
                             "easiest on the mounts; with a backward balance shaft use 50 %."),
                    degrees(bank_angle(engine)), degrees(engine.pin_split), percent(left),
                    percent(theory_factor(engine))};
        }
        if (left < nothing) {
            return Text::tr(
                "Two cylinders at 90° on one crankpin: their first-order forces add up to a "
                "constant force that turns with the crank. 50 % balances it fully.");
        }
        if (engine.crankpins() == 1) {
            return {Text::tr("Banks at %1: 50 % balances the forward part of the first order. "
                             "Counterweights cannot balance the backward part, %2 of the "
                             "reciprocating mass."),
                    degrees(bank_angle(engine)), percent(left)};
        }
        return {Text::tr("Banks at %1: 50 % balances the forward part of the first order. The "
                         "backward part, %2 of the reciprocating mass, may cancel between the "
                         "crankpins, not by counterweights."),
                degrees(bank_angle(engine)), percent(left)};
    }
    if (engine.type == EngineType::boxer) {
        return Text::tr(
            "Boxer: opposite pistons cancel each other's force. The factor affects "
            "residual couple and main bearing load; 50 % minimises the maximum.");
    }
    if (engine.type == EngineType::in_line) {
        return Text::tr(
            "In line: 50 % halves the first-order force of each piston. If the crankpins balance "
            "one another (four, six in line), equal bob weights are not needed.");
    }
    return Text::tr(
        "Each rod on its own crankpin: 50 % leaves half the first-order force of each "
        "piston, turning against the crank.");
}

bool balances_itself(const Engine& engine) {
    return engine.type == EngineType::in_line && engine.cylinders >= 4 && engine.cylinders % 2 == 0;
}

Message factor_effect(const Engine& engine, double factor) {
    const FirstOrder left = first_order(engine, factor, 1.0);
    const double whole = is_pair(engine) ? 2.0 : 1.0;
    if (left.maximum() < nothing * whole) {
        return Text::tr("First-order force fully balanced.");
    }
    if (std::abs(left.forward) < nothing) {
        return {Text::tr("Residual: a circle against the crank, %1 of the reciprocating mass of a "
                         "cylinder."),
                percent(left.maximum())};
    }
    if (std::abs(left.backward) < nothing) {
        return {
            Text::tr(
                "Residual: a circle with the crank, %1 of the reciprocating mass of a cylinder."),
            percent(left.maximum())};
    }
    if (std::min(left.upright(), left.across()) < nothing) {
        return {left.upright() > left.across()
                    ? Text::tr("Residual: a straight vertical motion, %1 of the reciprocating "
                               "mass of a cylinder.")
                    : Text::tr("Residual: a straight horizontal motion, %1 of the reciprocating "
                               "mass of a cylinder."),
                percent(left.maximum())};
    }
    return {Text::tr("Residual: an ellipse, %1 of the reciprocating mass of a cylinder "
                     "vertically, %2 horizontally."),
            percent(left.upright()), percent(left.across())};
}

}  // namespace ravnoves::bob_weights
