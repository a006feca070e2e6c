// The paper's own numbers: N. D. Chainov, P. R. Vallejo Maldonado, 2020.
#include <gtest/gtest.h>

#include "engines.h"
#include "example_check.h"

namespace ravnoves::inertia_moments {
namespace {

using test::vr5;

double minutes(double degrees, double arc_minutes) {
    return degrees + arc_minutes / 60.0;
}

/// Angle in degrees folded to 0…360.
double deg(double angle) {
    return wrap_turn(angle) / degree;
}

TEST(VolkswagenVr5, AgreesWithTheContractsExample) {
    ravnoves::test::check_example("vr5-volkswagen");
}

/// Coefficients of a unit length: `a` with l = 0 and `l` with a = 0, in units of m R ω² cos(γ/2)
/// (vertical) or sin(γ/2) (horizontal), for order 2 also of λ.
struct Coefficients {
    Harmonic<double> vertical;
    Harmonic<double> horizontal;
};

Coefficients printed_form(int order, double a, double l) {
    Input input = vr5();
    input.cylinders = make_cylinders(*input.layout, input.crank_radius, input.lambda);
    input.layout.reset();
    // l_cm is measured from crankpin 4.
    for (std::size_t i = 0; i < input.cylinders.size(); ++i) {
        input.cylinders[i].axial_position = a * (3.0 - static_cast<double>(i)) + l;
    }
    const Result result = solve(input);
    const RotatingPair& moment = result.two_term.order(order).moment;
    double unit = result.engine.force_unit();
    if (order == 2) {
        unit *= input.lambda;
    }
    const double half = 7.5 * degree;
    const double vertical = unit * std::cos(half);
    const double horizontal = -unit * std::sin(half);  // bank 1 lies on the negative side of x
    return {{moment.vertical().cos / vertical, moment.vertical().sin / vertical},
            {moment.horizontal().cos / horizontal, moment.horizontal().sin / horizontal}};
}

TEST(VolkswagenVr5, SixteenPrintedCoefficients) {
    const double tolerance = 0.001;
    const auto a1 = printed_form(1, 1.0, 0.0);
    const auto l1 = printed_form(1, 0.0, 1.0);
    EXPECT_NEAR(a1.vertical.cos, 0.324, tolerance);
    EXPECT_NEAR(l1.vertical.cos, -0.012, tolerance);
    EXPECT_NEAR(a1.vertical.sin, -0.293, tolerance);
    EXPECT_NEAR(l1.vertical.sin, 0.0146, tolerance);
    EXPECT_NEAR(a1.horizontal.cos, 3.667, tolerance);
    EXPECT_NEAR(l1.horizontal.cos, 0.959, tolerance);
    EXPECT_NEAR(a1.horizontal.sin, -2.509, tolerance);
    EXPECT_NEAR(l1.horizontal.sin, 0.786, tolerance);
    const auto a2 = printed_form(2, 1.0, 0.0);
    const auto l2 = printed_form(2, 0.0, 1.0);
    EXPECT_NEAR(a2.vertical.cos, 5.158, tolerance);
    EXPECT_NEAR(l2.vertical.cos, 0.368, tolerance);
    EXPECT_NEAR(a2.vertical.sin, -1.345, tolerance);
    EXPECT_NEAR(l2.vertical.sin, -0.0738, tolerance);
    EXPECT_NEAR(a2.horizontal.cos, 3.078, tolerance);
    EXPECT_NEAR(l2.horizontal.cos, 0.632, tolerance);
    EXPECT_NEAR(a2.horizontal.sin, 2.072, tolerance);
    EXPECT_NEAR(l2.horizontal.sin, 3.151, tolerance);
}

TEST(VolkswagenVr5, TwelvePrintedAngles) {
    Input input = vr5();
    for (const int order : {1, 2}) {
        for (const Direction direction : {Direction::forward, Direction::backward}) {
            Shaft shaft;
            shaft.order = order;
            shaft.direction = direction;
            input.shafts.push_back(shaft);
        }
    }
    input.shaft_basis = DesignBasis::two_term;
    const Result result = solve(input);
    const double one_minute = 1.0 / 60.0;

    EXPECT_NEAR(deg(*result.tdc_angle), minutes(3, 20), one_minute);
    // The second bank's crankpins against those of the in-line five.
    const auto pin = [&](std::size_t i) {
        return result.engine.cylinders[i].crankpin_angle / degree;
    };
    EXPECT_NEAR(216.0 - pin(1), minutes(21, 40), one_minute);
    EXPECT_NEAR(72.0 - pin(3), minutes(21, 40), one_minute);
    // Between neighbouring crankpins round the crank: 1, 4, 3, 2, 5.
    EXPECT_NEAR(pin(3) - pin(0), minutes(50, 20), one_minute);
    EXPECT_NEAR(pin(4) - pin(1), minutes(93, 40), one_minute);
    EXPECT_NEAR(pin(2) - pin(3), minutes(93, 40), one_minute);
    EXPECT_NEAR(360.0 - pin(1), minutes(165, 40), one_minute);
    EXPECT_NEAR(360.0 - pin(4) + pin(3), minutes(122, 20), one_minute);

    // Planes of the shafts' moments at φ = 0: +ω from the x axis (clockwise, on the other side),
    // the others from the y axis.
    const auto plane = [&](std::size_t i) { return deg(std::arg(result.shafts[i].target)); };
    EXPECT_NEAR(180.0 - plane(0), minutes(1, 10), one_minute);
    EXPECT_NEAR(plane(1) - 90.0, minutes(19, 51), 1.2 * one_minute);
    EXPECT_NEAR(plane(2) - 90.0, minutes(17, 39), 1.2 * one_minute);
    EXPECT_NEAR(90.0 - plane(3), minutes(10, 53), one_minute);

    // Counterweights, from crankpin 1 against the rotation.
    EXPECT_NEAR(deg(-std::arg(-result.rotating.force_factor)), minutes(136, 50), one_minute);
    EXPECT_NEAR(deg(-std::arg(-result.rotating.moment_factor)), minutes(75, 43), one_minute);

    // Not printed, from the same formulas; N·m.
    const double moments[] = {295.96, 244.87, 576.67, 484.71};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(std::abs(result.shafts[i].target), moments[i], 0.005);
    }
}

// Fig. 6: curves of the printed formulas with the engine's numbers. Its axes run from −600 to 600
// (order 1) and from −1200 to 1200 N·m (order 2).
TEST(VolkswagenVr5, AmplitudesOfFigure6) {
    const Result result = solve(vr5());
    const double a = 0.063;
    const double l = 0.0158;
    const double unit = result.engine.force_unit();
    const double c = unit * std::cos(7.5 * degree);
    const double s = unit * std::sin(7.5 * degree);
    const double m1y = c * std::hypot(0.324 * a - 0.012 * l, -0.293 * a + 0.0146 * l);
    const double m1x = s * std::hypot(3.667 * a + 0.959 * l, -2.509 * a + 0.786 * l);
    const double m2y = 0.265 * c * std::hypot(5.158 * a + 0.368 * l, 1.345 * a + 0.0738 * l);
    const double m2x = 0.265 * s * std::hypot(3.078 * a + 0.632 * l, 2.072 * a + 3.151 * l);
    const RotatingPair& order_1 = result.two_term.order(1).moment;
    const RotatingPair& order_2 = result.two_term.order(2).moment;
    EXPECT_NEAR(amplitude(order_1.vertical()), m1y, 0.003 * m1y);
    EXPECT_NEAR(amplitude(order_1.horizontal()), m1x, 0.001 * m1x);
    EXPECT_NEAR(amplitude(order_2.vertical()), m2y, 0.001 * m2y);
    EXPECT_NEAR(amplitude(order_2.horizontal()), m2x, 0.001 * m2x);
    EXPECT_GT(m1x, 400.0);
    EXPECT_LT(m1x, 600.0);
    EXPECT_GT(m2y, 1000.0);
    EXPECT_LT(m2y, 1200.0);
}

// The paper's sums over the crankpins as functions of the shift γ_ш of the second bank. The sign
// of 1.118 sin γ_ш in ΣM_cx is a misprint: only + gives the paper's own 75°43′.
TEST(VolkswagenVr5, RotatingMassesAsPrinted) {
    const Result result = solve(vr5());
    const double shift = 15.0 * degree + 2.0 * *result.tdc_angle;
    const double half = std::sin(shift / 2.0) * std::sin(shift / 2.0);
    // Relative to crankpin 1, which is up (y) in the paper's figure; x is to its right there.
    const double force_y = half + 0.36327 * std::sin(shift);
    const double force_x = 0.5 * std::sin(shift) - 0.72654 * half;
    EXPECT_NEAR(std::abs(result.rotating.force_factor), std::hypot(force_x, force_y), 2e-5);
    const double moment_y = 1.382 - 1.5388 * std::sin(shift) - 1.118 * std::cos(shift);
    const double moment_x = 1.9021 + 1.118 * std::sin(shift) - 1.5388 * std::cos(shift);
    EXPECT_NEAR(std::abs(result.rotating.moment_factor) / 0.063, std::hypot(moment_x, moment_y),
                2e-4);
    EXPECT_NEAR(std::atan(std::abs(moment_x / moment_y)) / degree, minutes(75, 43), 1.0 / 30.0);
}

TEST(VolkswagenVr5, TwoTermIsNotEnoughInTheVerticalPlane) {
    const Result result = solve(vr5());
    bool force_1 = false;
    bool force_3 = false;
    for (const Difference& d : result.differences) {
        if (d.quantity == Quantity::force && d.plane == Plane::vertical) {
            force_1 = force_1 || (d.order == 1 && d.warning);
            force_3 = force_3 || (d.order == 3 && d.warning && d.two_term == 0.0);
        }
        if (d.quantity == Quantity::force && d.plane == Plane::horizontal && d.order == 1) {
            EXPECT_FALSE(d.warning);
            EXPECT_LT(*d.relative, 0.001);
        }
    }
    EXPECT_TRUE(force_1);
    EXPECT_TRUE(force_3);
}

}  // namespace
}  // namespace ravnoves::inertia_moments
