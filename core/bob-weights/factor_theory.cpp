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
                return {CORE_TEXT("bob-weights",
                                  "Banks at %1 with crankpins split by %2: the parts of the "
                                  "first-order force that turn against the crank cancel, and 50 % "
                                  "takes up the rest. Nothing remains."),
                        degrees(bank_angle(engine)), degrees(engine.pin_split)};
            }
            if (left > forward_share(engine)) {
                return {CORE_TEXT("bob-weights",
                                  "Split crankpins: banks at %1 and a split of %2 leave a part of "
                                  "%3 of the reciprocating mass that turns against the crank. The "
                                  "part that turns with it is smaller, %4, even at 0 %: no factor "
                                  "makes both equal. With a balance shaft that turns against the "
                                  "crank it is 50 %."),
                        degrees(bank_angle(engine)), degrees(engine.pin_split), percent(left),
                        percent(forward_share(engine))};
            }
            return {CORE_TEXT("bob-weights",
                              "Split crankpins: banks at %1 and a split of %2 leave a part of %3 "
                              "of the reciprocating mass that turns against the crank. At %4 the "
                              "part that turns with it is as large, and both make a motion to and "
                              "fro in one direction, which mounts bear best. With a balance shaft "
                              "that turns against the crank it is 50 %."),
                    degrees(bank_angle(engine)), degrees(engine.pin_split), percent(left),
                    percent(theory_factor(engine))};
        }
        if (left < nothing) {
            return CORE_TEXT("bob-weights",
                             "Two cylinders at 90° on one crankpin: their first-order forces add "
                             "up to one of constant size that turns with the crank, as a mass of "
                             "half of both on the crankpin would. 50 % takes up all of it.");
        }
        if (engine.crankpins() == 1) {
            return {CORE_TEXT("bob-weights",
                              "Banks at %1: with 50 % the part of the first-order force that turns "
                              "with the crank is taken up; a part of %2 of the reciprocating mass "
                              "turns against it and no counterweight reaches it."),
                    degrees(bank_angle(engine)), percent(left)};
        }
        return {
            CORE_TEXT("bob-weights",
                      "Banks at %1: with 50 % the part of the first-order force that turns "
                      "with the crank is taken up; a part of %2 of the reciprocating mass turns "
                      "against it and no counterweight reaches it. The crankpins together may "
                      "cancel it."),
            degrees(bank_angle(engine)), percent(left)};
    }
    if (engine.type == EngineType::boxer) {
        return CORE_TEXT("bob-weights",
                         "Boxer: opposite pistons cancel each other's force. The factor concerns "
                         "what is left of their couple and the load of the main bearings; 50 % "
                         "makes its largest value smallest.");
    }
    if (engine.type == EngineType::in_line) {
        return CORE_TEXT(
            "bob-weights",
            "In line: 50 % turns the to and fro of each piston into a circle of half "
            "the size. Where the crankpins balance one another (four, six in line) the "
            "factor changes the load of the main bearings alone, and no bob weights "
            "are needed where all would weigh the same.");
    }
    return CORE_TEXT("bob-weights",
                     "Each rod on a crankpin of its own: 50 % turns the to and fro of each piston "
                     "into a circle of half the size that turns against the crank.");
}

bool balances_itself(const Engine& engine) {
    return engine.type == EngineType::in_line && engine.cylinders >= 4 && engine.cylinders % 2 == 0;
}

Message factor_effect(const Engine& engine, double factor) {
    const FirstOrder left = first_order(engine, factor, 1.0);
    const double whole = is_pair(engine) ? 2.0 : 1.0;
    if (left.greatest() < nothing * whole) {
        return CORE_TEXT("bob-weights", "Of the first-order force nothing remains.");
    }
    if (std::abs(left.forward) < nothing) {
        return {CORE_TEXT("bob-weights",
                          "A circle remains that turns against the crank: %1 of the reciprocating "
                          "mass of a cylinder."),
                percent(left.greatest())};
    }
    if (std::abs(left.backward) < nothing) {
        return {CORE_TEXT("bob-weights",
                          "A circle remains that turns with the crank: %1 of the reciprocating "
                          "mass of a cylinder."),
                percent(left.greatest())};
    }
    if (std::min(left.upright(), left.across()) < nothing) {
        return {left.upright() > left.across()
                    ? CORE_TEXT("bob-weights",
                                "A motion straight up and down remains: %1 of the reciprocating "
                                "mass of a cylinder.")
                    : CORE_TEXT("bob-weights",
                                "A motion straight across remains: %1 of the reciprocating mass of "
                                "a cylinder."),
                percent(left.greatest())};
    }
    return {CORE_TEXT("bob-weights",
                      "An ellipse remains: %1 of the reciprocating mass of a cylinder upright, %2 "
                      "across."),
            percent(left.upright()), percent(left.across())};
}

}  // namespace ravnoves::bob_weights
