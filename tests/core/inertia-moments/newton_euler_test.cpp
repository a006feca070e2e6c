// Rigid rods against the equations of motion of piston, rod and crank, written here from free
// bodies alone: nothing of the core's kinematics or of the reduction to two masses is used.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "engines.h"

namespace ravnoves::inertia_moments {
namespace {

using Vector = Eigen::Vector2d;

double cross(const Vector& a, const Vector& b) {
    return a.x() * b.y() - a.y() * b.x();
}
/// k × a: a turned by +90°.
Vector perpendicular(const Vector& a) {
    return {-a.y(), a.x()};
}

struct Loads {
    Vector force = Vector::Zero();   // on the engine block
    Vector moment = Vector::Zero();  // Σ F (z − z_ref)
    double roll = 0.0;               // about the crank axis
    double shaft_torque = 0.0;       // that keeps the crank at constant speed
};

/// What piston and main bearings press on the block, summed over the cylinders.
Loads free_bodies(const Input& input, double phi) {
    Loads sum;
    const double omega = input.angular_speed;
    const double length = input.crank_radius / input.lambda;
    const RigidRod& rod = *input.rod;
    for (const Cylinder& cylinder : input.cylinders) {
        const double beta = cylinder.bank_angle;
        const Vector u(-std::sin(beta), std::cos(beta));  // axis, outwards
        const Vector n = perpendicular(u);                // counter-clockwise side
        const double pin_angle =
            phi + input.cylinders.front().bank_angle + cylinder.crankpin_angle + pi / 2.0;
        const Vector pin = input.crank_radius * Vector(std::cos(pin_angle), std::sin(pin_angle));
        const Vector pin_velocity = omega * perpendicular(pin);
        const Vector pin_acceleration = -omega * omega * pin;
        // Piston pin on its axis at the rod's length from the crankpin, the outer of two points.
        const Vector foot = cylinder.offset * n;
        const double along = (pin - foot).dot(u);
        const double across = (pin - foot).dot(n);
        const Vector piston = foot + (along + std::sqrt(length * length - across * across)) * u;
        const Vector r = piston - pin;
        // v_pin + ω_r k×r = v u, then the same for accelerations.
        Eigen::Matrix2d system;
        system.col(0) = perpendicular(r);
        system.col(1) = -u;
        const Vector rates = system.colPivHouseholderQr().solve(-pin_velocity);
        const double rod_rate = rates.x();
        const Vector accelerations =
            system.colPivHouseholderQr().solve(-pin_acceleration + rod_rate * rod_rate * r);
        const double rod_acceleration = accelerations.x();
        const Vector piston_acceleration = accelerations.y() * u;
        const Vector to_centre = rod.centre_from_big_end / length * r;
        const Vector centre_acceleration = pin_acceleration +
                                           rod_acceleration * perpendicular(to_centre) -
                                           rod_rate * rod_rate * to_centre;
        // Unknown: force of rod on piston (2), of crank on rod (2), of the wall on the piston
        // along n (1).
        Eigen::Matrix<double, 5, 5> a = Eigen::Matrix<double, 5, 5>::Zero();
        Eigen::Matrix<double, 5, 1> b;
        a.block<2, 2>(0, 0) = Eigen::Matrix2d::Identity();
        a.block<2, 1>(0, 4) = n;
        b.segment<2>(0) = input.reciprocating_mass * piston_acceleration;
        a.block<2, 2>(2, 0) = -Eigen::Matrix2d::Identity();
        a.block<2, 2>(2, 2) = Eigen::Matrix2d::Identity();
        b.segment<2>(2) = rod.mass * centre_acceleration;
        const Vector piston_arm = r - to_centre;
        a(4, 0) = piston_arm.y();  // −(arm × F)
        a(4, 1) = -piston_arm.x();
        a(4, 2) = to_centre.y();  // (−to_centre) × F
        a(4, 3) = -to_centre.x();
        b(4) = rod.inertia * rod_acceleration;
        const Eigen::Matrix<double, 5, 1> x = a.fullPivLu().solve(b);
        const Vector on_rod(x(2), x(3));
        const double wall = x(4);
        // Crank with its rotating mass: bearing force − force on the rod = m a.
        const Vector bearing = on_rod + input.rotating_mass * pin_acceleration;
        const Vector on_block = -bearing - wall * n;
        sum.force += on_block;
        sum.moment += (cylinder.axial_position - input.reference_position) * on_block;
        sum.roll += cross(piston, Vector(-wall * n));
        sum.shaft_torque += cross(pin, on_rod);
    }
    return sum;
}

TEST(RigidRods, AgreeWithNewtonEuler) {
    for (const double inertia : {0.0, 0.001, 0.006}) {
        for (const double centre : {0.0, 0.03, 0.055}) {
            Input input = test::irregular();
            input.rod = RigidRod{0.6, centre, inertia};
            const Engine engine = make_engine(input);
            const RotatingMasses rotating = rotating_masses(engine);
            const double unit = engine.force_unit();
            for (int i = 0; i < 50; ++i) {
                const double phi = 0.13 * i;
                const Loads truth = free_bodies(input, phi);
                const test::Wrench wrench = test::exact_wrench(engine, phi);
                const Complex turn = crankpin_direction(engine) * std::polar(1.0, phi);
                const Complex force = wrench.force + rotating.force() * turn;
                const Complex moment =
                    wrench.moment + rotating.moment_about(input.reference_position) * turn;
                EXPECT_NEAR(force.real(), truth.force.x(), 1e-11 * unit);
                EXPECT_NEAR(force.imag(), truth.force.y(), 1e-11 * unit);
                EXPECT_NEAR(moment.real(), truth.moment.x(), 1e-11 * unit);
                EXPECT_NEAR(moment.imag(), truth.moment.y(), 1e-11 * unit);
                EXPECT_NEAR(wrench.roll(), truth.roll, 1e-11 * unit);
                // The torque that holds the speed is the reaction torque's counterpart.
                EXPECT_NEAR(wrench.reaction_torque, truth.shaft_torque, 1e-11 * unit);
            }
        }
    }
}

}  // namespace
}  // namespace ravnoves::inertia_moments
