#pragma once

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_dec_float.hpp>

#include "elastic-hinge/result.h"
#include "error_of.h"

namespace ravnoves::elastic_hinge::test {

using Fifty = boost::multiprecision::cpp_dec_float_50;

/// Derivative in 50 digits: the truncation error is of order h⁴ = 1e-40.
template <typename Function>
Fifty derivative(const Function& f, const Fifty& x) {
    const Fifty h("1e-10");
    return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h);
}

template <typename Scalar>
Mechanism<Scalar> zotov_mechanism(Scalar lambda = Scalar(3) / 10) {
    const Scalar g = Scalar(982) / 100;
    return {Scalar(5) / g, Scalar(13) / 2 / g, Scalar(6) / g, g, Scalar(5) / 100, lambda};
}

template <typename Scalar>
Mechanism<Scalar> with_counterweight(Mechanism<Scalar> mechanism, Scalar distance) {
    mechanism.counterweight_distance = distance;
    mechanism.counterweight_mass = mechanism.balancing_mass();
    return mechanism;
}

template <typename Scalar>
ReducedInertia<Scalar> inertia_at(const Mechanism<Scalar>& m, const Scalar& phi) {
    using std::cos;
    using std::sin;
    const Scalar s = sin(phi);
    const Scalar c = cos(phi);
    return reduced_inertia(m, s, c, rod_angle_exact(m.lambda, s, c));
}

/// In the spring at a radius of the guide, ½ c (ℓ₀ − 2ρ)², J.
inline double energy_in(const GuideShape& shape, double radius) {
    const double change = shape.spring().free_length - 2.0 * radius;
    return 0.5 * shape.spring().stiffness * change * change;
}

/// ∫ over one turn of samples that hold both ends, by the trapezoidal rule (spectral here).
inline double turn_integral(const std::vector<double>& samples) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        sum += samples[i];
    }
    return sum * two_pi / static_cast<double>(samples.size() - 1);
}

using ravnoves::test::error_of;

}  // namespace ravnoves::elastic_hinge::test
