// Master and articulated rods against the closure of the loop in 50 digits, momentum and energy by
// differences of positions, and the second order that follows by hand.
#include "inertia-moments/rods.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "case-file/result_json.h"
#include "engines.h"
#include "inertia-moments/engine.h"
#include "inertia-moments/fields.h"
#include "inertia-moments/input.h"
#include "inertia-moments/presets.h"
#include "numerics/real50.h"

namespace ravnoves::inertia_moments {
namespace {

/// A radial on one pin, its rods hung on that of cylinder 1.
Input star(int count, double lambda, double knuckle_share) {
    Input input;
    input.crank_radius = 0.0873;
    input.lambda = lambda;
    input.angular_speed = 230.0;
    input.reciprocating_mass = 2.5;
    for (int i = 0; i < count; ++i) {
        input.cylinders.push_back({0.0, two_pi * i / count, 0.0, 0.0});
        if (i > 0) {
            input.cylinders.back().articulated.emplace().knuckle_radius =
                knuckle_share * input.crank_radius;
        }
    }
    return input;
}

Input without_articulated(Input input) {
    for (Cylinder& cylinder : input.cylinders) {
        cylinder.articulated.reset();
    }
    return input;
}

// ------------------------------------------------------------- the closure, written here again

using Point = Eigen::Matrix<Real50, 2, 1>;

/// On the circle about the origin, from y towards −x.
Point on_circle(const Real50& radius, const Real50& angle) {
    return {-radius * sin(angle), radius * cos(angle)};
}

/// The piston pin on its axis at a distance from a point: Newton's method from far outside.
Point piston_pin(const Cylinder& cylinder, const Point& foot, const Real50& length) {
    const Point axis = on_circle(1, Real50(cylinder.bank_angle));
    const Point origin = Real50(cylinder.offset) * axis.unitOrthogonal();
    Real50 s = Real50(3) * (length + foot.norm());
    for (int step = 0; step < 100; ++step) {
        const Point rod = origin + s * axis - foot;
        s -= (rod.squaredNorm() - length * length) / (Real50(2) * rod.dot(axis));
    }
    return origin + s * axis;
}

struct PinPlaces {
    std::vector<Point> pistons;
    std::vector<Point> feet;  ///< of the rods
    std::vector<Point> pins;  ///< crankpins
};

/// All pins at φ, in metres. Angles of knuckle pins and lengths as the input gives them.
PinPlaces places_at(const Input& input, const std::vector<std::size_t>& masters,
                    const Real50& phi) {
    const Real50 radius(input.crank_radius);
    const Real50 length = radius / Real50(input.lambda);
    PinPlaces places;
    for (std::size_t i = 0; i < input.cylinders.size(); ++i) {
        const Cylinder& cylinder = input.cylinders[i];
        const Real50 angle =
            phi + Real50(input.cylinders[0].bank_angle) + Real50(cylinder.crankpin_angle);
        const Point pin = on_circle(radius, angle);
        places.pins.push_back(pin);
        places.feet.push_back(pin);
        if (!cylinder.articulated) {
            places.pistons.push_back(piston_pin(cylinder, pin, length));
            continue;
        }
        const ArticulatedRod& rod = *cylinder.articulated;
        const Cylinder& master = input.cylinders[masters[i]];
        const Point along = piston_pin(master, pin, length) - pin;
        const Real50 gamma = rod.knuckle_angle
                                 ? Real50(*rod.knuckle_angle)
                                 : Real50(cylinder.bank_angle) - Real50(master.bank_angle);
        places.feet.back() =
            pin + Real50(rod.knuckle_radius) / length * (Eigen::Rotation2D<Real50>(gamma) * along);
        const Real50 own_length =
            rod.rod_length ? Real50(*rod.rod_length) : length - Real50(rod.knuckle_radius);
        places.pistons.push_back(piston_pin(cylinder, places.feet.back(), own_length));
    }
    return places;
}

const std::vector<std::size_t> star_masters{2, 2, 2, 2, 4, 4};

TEST(ArticulatedRods, PlacesCloseTheLoop) {
    const Input input = test::irregular_star();
    const Engine engine = make_engine(input);
    for (int k = 0; k < 24; ++k) {
        const double phi = 0.27 * k;
        const auto poses = engine_pose(engine, phi);
        const PinPlaces places = places_at(input, star_masters, Real50(phi));
        for (std::size_t i = 0; i < poses.size(); ++i) {
            const auto expect_at = [&](const Complex& found, const Point& truth) {
                EXPECT_NEAR(found.real(), static_cast<double>(truth[0]), 2e-16) << i << " " << phi;
                EXPECT_NEAR(found.imag(), static_cast<double>(truth[1]), 2e-16) << i << " " << phi;
            };
            expect_at(poses[i].piston_pin, places.pistons[i]);
            expect_at(poses[i].rod_foot, places.feet[i]);
            expect_at(poses[i].crankpin, places.pins[i]);
            EXPECT_EQ(poses[i].articulated, input.cylinders[i].articulated.has_value());
        }
    }
}

// Newton on the whole: force and moments are −d/dt of momentum and angular momentum, the reaction
// to the crank's torque is d/dφ of the kinetic energy; all by differences of positions alone.
TEST(ArticulatedRods, ForcesAreThoseOfMomentumAndEnergy) {
    const Input input = test::irregular_star();
    const Engine engine = make_engine(input);
    const Real50 h("1e-9");
    const Real50 omega(input.angular_speed);
    const double unit = engine.force_unit();
    for (int k = 0; k < 24; ++k) {
        const double phi = 0.27 * k + 0.1;
        std::array<PinPlaces, 5> at;  // φ − 2h … φ + 2h
        for (int j = 0; j < 5; ++j) {
            at[static_cast<std::size_t>(j)] =
                places_at(input, star_masters, Real50(phi) + Real50(j - 2) * h);
        }
        Point force = Point::Zero();
        Point moment = Point::Zero();
        Real50 roll(0);
        Real50 energy_rate(0);
        const auto add = [&](const Real50& mass, auto&& list, std::size_t i, const Real50& z) {
            const auto place = [&](std::size_t j) -> const Point& { return list(at.at(j))[i]; };
            const auto speed = [&](std::size_t j) -> Point {
                return Real50(1) / (Real50(2) * h) * (place(j + 1) - place(j - 1));
            };
            const Point acceleration =
                Real50(1) / (h * h) * (place(3) - Real50(2) * place(2) + place(1));
            const Real50 factor = -mass * omega * omega;
            force += factor * acceleration;
            moment += factor * z * acceleration;
            roll += factor * place(2).unitOrthogonal().dot(acceleration) * place(2).norm();
            energy_rate -=
                factor * (speed(3).squaredNorm() - speed(1).squaredNorm()) / (Real50(4) * h);
        };
        for (std::size_t i = 0; i < input.cylinders.size(); ++i) {
            const Cylinder& cylinder = input.cylinders[i];
            const Real50 z(cylinder.axial_position - input.reference_position);
            add(
                Real50(input.reciprocating_mass),
                [](const PinPlaces& all) -> const auto& { return all.pistons; }, i, z);
            if (cylinder.articulated) {
                const Real50 mass(cylinder.articulated->knuckle_mass);
                add(
                    mass, [](const PinPlaces& all) -> const auto& { return all.feet; }, i, z);
                add(
                    -mass, [](const PinPlaces& all) -> const auto& { return all.pins; }, i, z);
            }
        }
        const test::Wrench wrench = test::exact_wrench(engine, phi);
        const auto complex = [](const Point& point) {
            return Complex(static_cast<double>(point[0]), static_cast<double>(point[1]));
        };
        test::expect_near(wrench,
                          {complex(force), complex(moment), static_cast<double>(roll),
                           static_cast<double>(energy_rate)},
                          1e-13 * unit);
    }
}

TEST(ArticulatedRods, ScaleOfMomentsIsThatOfForcesTimesTheirLever) {
    Input input = test::irregular_star();
    for (Cylinder& cylinder : input.cylinders) {
        cylinder.axial_position = 0.113;
    }
    const EngineOrders orders = exact_orders(make_engine(input), 6);
    for (const EngineOrder& order : orders.orders) {
        EXPECT_GT(order.force_scale, 0.0);
        EXPECT_NEAR(order.moment_scale, 0.1 * order.force_scale, 1e-12 * order.force_scale);
    }
}

// By hand, with a = ρλ/l, b = ρλ²/2 + ρ²λ²/(2l) and lengths in R: an articulated piston stands at
// cos θ − sin²θ/(2l) + a sin θ sin φ − b sin²φ but for a constant. Round the star the second term
// adds up to nothing and the third to (N/2) a (e^{2iφ} − 1)/(2i); the master's cylinder has none of
// them, but λ/4 cos 2φ, which leaves c cos 2φ on its axis, c = λ/4 − 1/(4l) + (a − b)/2.
TEST(ArticulatedRods, SecondOrderOfARadial) {
    for (const int count : {5, 7, 9, 63}) {
        for (const double rho : {0.35, 0.75}) {
            const double lambda = 0.25;
            const double l = 1.0 / lambda - rho;
            const double a = rho * lambda / l;
            const double b = rho * lambda * lambda / 2.0 + rho * rho * lambda * lambda / (2.0 * l);
            const double c = lambda / 4.0 - 1.0 / (4.0 * l) + (a - b) / 2.0;
            const Result result = solve(star(count, lambda, rho));
            const double unit = result.engine.force_unit();
            const RotatingPair& second = result.two_term.order(2).force;
            EXPECT_NEAR(std::abs(second.forward) / unit, count * a - 2.0 * c, 1e-12) << count;
            EXPECT_NEAR(std::abs(second.backward) / unit, 2.0 * std::abs(c), 1e-12) << count;
            for (const int k : {3, 4}) {
                EXPECT_EQ(result.two_term.order(k).force.max(), 0.0);
            }
            // The exact one is not far, and plain rods have none.
            const double exact = std::abs(result.exact.order(2).force.forward) / unit;
            EXPECT_NEAR(exact, count * a, 0.06 * count * a) << count;
            // Without offsets the first order stays as it is: what the rods add is even in φ + π.
            EXPECT_NEAR(std::abs(result.exact.order(1).force.forward) / unit, 0.5 * count, 1e-11);
            const Result plain = solve(without_articulated(star(count, lambda, rho)));
            EXPECT_LT(plain.exact.order(2).force.max(), 1e-12 * unit) << count;
            EXPECT_NEAR(std::abs(plain.exact.order(1).force.forward) / unit, 0.5 * count, 1e-11);
        }
    }
}

// What the two-term form leaves out is of the third order: half as long a crank, an eighth.
TEST(ArticulatedRods, TwoTermFormIsRightToTheSecondOrder) {
    const auto error_at = [](double lambda) {
        ArticulatedCrank crank{{1.0, 1.0 / lambda, 0.2},
                               std::polar(1.0, 1.1),
                               std::polar(0.7, 0.15),
                               1.0 / lambda - 0.5,
                               -0.15};
        double maximum = 0.0;
        for (int k = 0; k < 200; ++k) {
            const double theta = two_pi * k / 200;
            const auto exact = crank.at(std::sin(theta), std::cos(theta)).piston;
            const auto two_term = crank.two_term_at(std::sin(theta), std::cos(theta)).piston;
            maximum = std::max(maximum, std::abs(exact.s - two_term.s) +
                                            std::abs(exact.ds - two_term.ds) +
                                            std::abs(exact.d2s - two_term.d2s));
        }
        return maximum;
    };
    EXPECT_LT(error_at(0.01), 1e-5);
    EXPECT_NEAR(error_at(0.04) / error_at(0.02), 8.0, 0.8);
    EXPECT_NEAR(error_at(0.02) / error_at(0.01), 8.0, 0.4);
}

TEST(ArticulatedRods, DeadCentresAreThoseOfThePiston) {
    const Input input = test::irregular_star();
    const Engine engine = make_engine(input);
    for (std::size_t i = 0; i < engine.cylinders.size(); ++i) {
        if (!engine.cylinders[i].articulated) {
            continue;
        }
        const ArticulatedCrank crank = engine.crank(i);
        const auto s = [&](double theta) {
            return crank.at(std::sin(theta), std::cos(theta)).piston.s;
        };
        double highest = -1e9;
        double lowest = 1e9;
        for (int k = 0; k < 3600; ++k) {
            highest = std::max(highest, s(two_pi * k / 3600));
            lowest = std::min(lowest, s(two_pi * k / 3600));
        }
        const double top = crank.top_dead_centre();
        const double bottom = crank.bottom_dead_centre();
        EXPECT_NEAR(s(top), highest, 2e-6);
        EXPECT_GE(s(top), highest);
        EXPECT_NEAR(s(bottom), lowest, 2e-6);
        EXPECT_LE(s(bottom), lowest);
        EXPECT_NEAR(crank.at(std::sin(top), std::cos(top)).piston.ds, 0.0, 1e-14);
        EXPECT_NEAR(engine.stroke(i), engine.crank_radius * (highest - lowest), 1e-6);
    }
    // A radial is its own mirror image about the master's axis.
    const Result radial = solve(star(9, 0.25, 0.75));
    EXPECT_NEAR(radial.engine.stroke(0), 2.0 * radial.engine.crank_radius, 1e-15);
    for (std::size_t i = 1; i < 9; ++i) {
        EXPECT_NEAR(radial.engine.top_dead_centre(i), -radial.engine.top_dead_centre(9 - i), 1e-12);
        EXPECT_NEAR(radial.engine.stroke(i), radial.engine.stroke(9 - i), 1e-14);
        EXPECT_GT(radial.engine.stroke(i), radial.engine.stroke(0));
    }
}

TEST(ArticulatedRods, ARadialKeepsTheSizesOfTheEngine) {
    Input input = preset_vw_vr5();
    const Input before = input;
    make_radial(input, 9);
    EXPECT_EQ(input.crank_radius, before.crank_radius);
    EXPECT_EQ(input.ratio(), before.ratio());
    EXPECT_EQ(input.angular_speed, before.angular_speed);
    EXPECT_EQ(input.reciprocating_mass, before.reciprocating_mass);
    EXPECT_EQ(input.rotating_mass, before.rotating_mass);
    ASSERT_EQ(input.cylinders.size(), 9U);
    EXPECT_NEAR(input.cylinders[1].articulated->knuckle_radius, 67.0 / 87.3 * before.crank_radius,
                1e-5);
    EXPECT_NO_THROW(solve(input));
}

TEST(ArticulatedRods, EveryPresetRadialFiresEveryOtherCylinder) {
    for (const int count : radial_counts) {
        const Input input = preset_radial(count);
        EXPECT_TRUE(read_input(write_input(input)) == input) << count;
        ASSERT_EQ(input.cylinders.size(), static_cast<std::size_t>(count));
        const Result result = solve(input);
        EXPECT_TRUE(result.notes.empty()) << count;
        EXPECT_TRUE(result.firing_trouble.empty()) << count;
        ASSERT_EQ(result.firing.size(), input.cylinders.size());
        double cycle = 0.0;
        for (const auto& event : result.firing) {
            cycle += event.interval;
            EXPECT_NEAR(event.interval / degree, 720.0 / count, 8.0) << count;
        }
        EXPECT_NEAR(cycle / degree, 720.0, 1e-9);
        for (int i = 0; i < count; ++i) {
            const int next = input.firing_order[static_cast<std::size_t>((i + 1) % count)];
            const int here = input.firing_order[static_cast<std::size_t>(i)];
            EXPECT_EQ((next - here + count) % count, 2) << count;
        }
        // All rods but the master's hang on it, at pins that stand apart round the crankpin.
        EXPECT_FALSE(result.engine.cylinders[0].articulated.has_value());
        for (std::size_t i = 1; i < input.cylinders.size(); ++i) {
            ASSERT_TRUE(result.engine.cylinders[i].articulated.has_value()) << count;
            EXPECT_EQ(result.engine.cylinders[i].articulated->master, 1);
            const double radius = result.engine.cylinders[i].articulated->knuckle_radius;
            EXPECT_NEAR(radius / input.crank_radius, usual_knuckle_share, 0.025) << count;
            EXPECT_LE(result.engine.cylinders[i].articulated->knuckle_mass, input.rotating_mass);
        }
    }
}

TEST(ArticulatedRods, WhatNobodyBuildsIsRemarkedOn) {
    Input input = star(5, 0.25, 0.75);
    EXPECT_TRUE(solve(input).notes.empty());
    input.cylinders[1].articulated->rod_length = 0.0873 / 0.25;  // as long as the master
    EXPECT_TRUE(solve(input).notes.empty());
    input.cylinders[1].articulated->rod_length = 0.36;
    input.cylinders[3].articulated->rod_length = 0.4;
    const Result result = solve(input);
    ASSERT_EQ(result.notes.size(), 1U);
    EXPECT_NE(result.notes[0].english().find("cylinders 2, 4 are longer"), std::string::npos);
}

// Rounding of the two-term form is no moment that it has.
TEST(Comparison, RoundingOfTheTwoTermFormIsNothing) {
    EngineOrder exact;
    exact.order = 1;
    exact.roll_scale = 1000.0;
    exact.reaction_torque = {0.0, 5.0};
    EngineOrder rounding = exact;
    rounding.reaction_torque = {8.55e-13, 0.0};
    const auto roll_of = [](const EngineOrder& right, const EngineOrder& short_form) {
        const auto differences = compare(EngineOrders{{right}}, EngineOrders{{short_form}});
        const auto roll = std::find_if(differences.begin(), differences.end(),
                                       [](const auto& d) { return d.component == 4; });
        return *roll;
    };
    const Difference left_out = roll_of(exact, rounding);
    EXPECT_EQ(left_out.two_term, 0.0);
    ASSERT_TRUE(left_out.relative.has_value());
    EXPECT_EQ(*left_out.relative, 1.0);
    const Difference nothing = roll_of(rounding, rounding);
    EXPECT_EQ(nothing.two_term, 0.0);
    EXPECT_FALSE(nothing.relative.has_value());
    EXPECT_EQ(roll_of(exact, exact).two_term, 5.0);
}

TEST(ArticulatedRods, BadInputIsNamedByItsField) {
    struct Bad {
        std::vector<std::pair<const char*, Json>> changes;  ///< null takes the value away
        const char* said;                                   ///< the beginning
    };
    constexpr const char* radius = "/cylinders/2/articulated/knuckle_radius_mm";
    constexpr const char* master = "/cylinders/2/articulated/master";
    constexpr const char* angle = "/cylinders/2/crankpin_angle_deg";
    constexpr const char* second = "/cylinders/1/articulated";
    const Json rigid = {{"mass_kg", 0.5}, {"centre_from_big_end_mm", 100}, {"inertia_kg_m2", 0.01}};
    const Bad all[] = {
        {{}, "no error"},
        {{{radius, -1}}, "3/knuckle_radius_mm: must be "},
        {{{radius, nullptr}}, "3/knuckle_radius_mm: "},
        {{{radius, 400}},
         "3/knuckle_radius_mm: must be less than 349.2, the length of the master rod, got 400"},
        {{{"/cylinders/2/articulated/rod_length_mm", 0}},
         "3/rod_length_mm: must be greater than 0"},
        {{{master, 6}}, "3/master: must be a cylinder of the table, 1 to 5, got 6"},
        {{{master, -1}}, "3/master: "},
        {{{master, 2}},
         "3/master: must be a rod on the crankpin; the rod of cylinder 2 is articulated too, got "
         "2"},
        {{{master, 3}},
         "3/master: must be a rod on the crankpin; the rod of cylinder 3 is articulated too, got "
         "3"},
        {{{"/cylinders/2/articulated/masters", 1}}, "3/masters"},
        // On a crankpin of its own: without a master named, and with it.
        {{{angle, 30}},
         "3/master: must have a master rod: all rods on the crankpin of cylinder 3 are "
         "articulated"},
        {{{angle, 30}, {master, 1}},
         "3/master: must run on the same crankpin (same angle, another direction, less than the "
         "crank radius away); cylinder 3 runs on the crankpin of cylinders 3, got 1"},
        // Two plain rods on the pin: which is the master must be said.
        {{{second, nullptr}},
         "3/master: must be given: any of the rods of cylinders 1, 2 on this crankpin could be the "
         "master"},
        {{{second, nullptr},
          {master, 2},
          {"/cylinders/3/articulated/master", 2},
          {"/cylinders/4/articulated/master", 2}},
         "no error"},
        {{{"/rod", rigid}},
         "/input/rod: must be left out with articulated rods (cylinder 2): master and articulated "
         "rods differ in mass, so enter their shares in the masses"},
        {{{"/cylinders/2/articulated/knuckle_mass_kg", 0.1}},
         "3/knuckle_mass_kg: must be at most 0, the rotating mass of one cylinder, got 0.1"}};
    for (const Bad& bad : all) {
        Json json = write_input(star(5, 0.25, 0.75));
        for (const auto& [pointer, value] : bad.changes) {
            const Json::json_pointer place(pointer);
            if (value.is_null()) {
                json[place.parent_pointer()].erase(place.back());
            } else {
                json[place] = value;
            }
        }
        std::string expected = bad.said;
        if (expected.starts_with("3/")) {
            expected.replace(0, 1, "/input/cylinders/2/articulated");
        }
        const std::string said = test::rejection_of(json);
        EXPECT_EQ(said.substr(0, expected.size()), expected) << said;
    }
}

TEST(ArticulatedRods, LockingIsRejectedInWords) {
    Input input = star(5, 0.25, 0.75);
    input.cylinders[1].articulated->rod_length = 0.2;
    const double reach =
        make_engine(input).crank(1).reach() * input.crank_radius;  // of the knuckle pin
    EXPECT_GT(reach, 0.9 * input.crank_radius);
    input.cylinders[1].articulated->rod_length = reach * (1.0 + 1e-6);
    EXPECT_THROW(static_cast<void>(solve(input)), InputError);  // its orders need too many samples
    input.cylinders[1].articulated->rod_length = 0.9 * reach;
    const std::string place = "/input/cylinders/1/articulated/";
    const std::string why = ": must leave the articulated rod longer than ";
    EXPECT_TRUE(test::rejection_of(write_input(input)).starts_with(place + "rod_length_mm" + why));
    // A length that is not given, and a rod that reaches its piston nowhere.
    input.cylinders[1].articulated->rod_length.reset();
    input.cylinders[1].articulated->knuckle_radius = 0.27;
    EXPECT_TRUE(
        test::rejection_of(write_input(input)).starts_with(place + "knuckle_radius_mm" + why));
    input.cylinders[1].articulated->knuckle_radius = 0.06;
    input.cylinders[1].articulated->knuckle_angle = 3.0;
    input.cylinders[1].offset = 1.0;
    EXPECT_TRUE(
        test::rejection_of(write_input(input)).starts_with(place + "knuckle_radius_mm" + why));
}

// A second cylinder in the direction of another is on a crankpin of its own; the rods that follow
// in the table stay on that of their master.
TEST(ArticulatedRods, RunOnTheCrankpinOfTheirMaster) {
    Input input = star(5, 0.25, 0.75);
    for (std::size_t i = 1; i < 5; ++i) {
        input.cylinders[i].articulated->master = 1;
    }
    input.cylinders.insert(input.cylinders.begin() + 2, {0.0, input.cylinders[1].bank_angle});
    const Engine engine = make_engine(input);
    ASSERT_EQ(engine.throws.size(), 2U);
    EXPECT_EQ(engine.throws[0].cylinders, (std::vector<std::size_t>{0, 1, 3, 4, 5}));
    EXPECT_EQ(engine.throws[1].cylinders, (std::vector<std::size_t>{2}));
}

TEST(ArticulatedRods, HangOnTheFirstCylinderOfEachThrow) {
    Input input = test::unit_engine("v8-cross-plane");
    input.cylinders = make_engine(input).cylinders;
    input.layout.reset();
    hang_on_masters(input.cylinders, input.crank_radius);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(input.cylinders[i].articulated.has_value(), i % 2 == 1);
    }
    const Result result = solve(input);
    EXPECT_EQ(result.engine.cylinders[5].articulated->master, 5);
    EXPECT_NEAR(*result.engine.cylinders[5].articulated->knuckle_angle, -pi / 2.0, 1e-12);
    // Its crank balances the second order all the same, and the first is that of plain rods; what
    // changes is the fourth.
    const double unit = result.engine.force_unit();
    const Result plain = solve(without_articulated(input));
    EXPECT_LT(result.exact.order(2).moment.max(), 1e-11 * unit);
    EXPECT_LT((result.exact.order(1).moment - plain.exact.order(1).moment).max(), 1e-11 * unit);
    EXPECT_GT((result.exact.order(4).force - plain.exact.order(4).force).max(), 1e-3 * unit);
}

}  // namespace
}  // namespace ravnoves::inertia_moments
