#include "elastic-hinge/kinematics.h"

#include "support.h"

namespace ravnoves::elastic_hinge {
namespace {

using test::derivative;
using test::Fifty;
using test::inertia_at;

/// T and V of the bodies one by one, from their positions alone.
struct Bodies {
    Mechanism<Fifty> m;

    Fifty psi(const Fifty& phi) const { return asin(m.lambda * sin(phi)); }

    Fifty kinetic(const Fifty& phi, const Fifty& omega) const {
        const Fifty r = m.crank_radius;
        const Fifty l = m.rod_length();
        const auto rate = [&](auto f) { return Fifty(omega * derivative(f, phi)); };
        const auto x = [&](const Fifty& along) {
            return [=, this](const Fifty& p) { return Fifty(r * cos(p) + along * cos(psi(p))); };
        };
        const auto y = [&](const Fifty& along) {
            return [=, this](const Fifty& p) { return Fifty(r * sin(p) - along * sin(psi(p))); };
        };
        const auto point = [&](const Fifty& mass, const Fifty& along) {
            const Fifty vx = rate(x(along));
            const Fifty vy = rate(y(along));
            return Fifty(mass * (vx * vx + vy * vy) / 2);
        };
        const Fifty turn = rate([this](const Fifty& p) { return psi(p); });
        return m.crank_mass * r * r / 6 * omega * omega + point(m.rod_mass, Fifty(l / 2)) +
               m.rod_mass * l * l / 24 * turn * turn + point(m.slider_mass, l) +
               point(m.counterweight_mass, Fifty(-m.counterweight_distance));
    }

    Fifty potential(const Fifty& phi) const {
        const Fifty r = m.crank_radius;
        return m.gravity *
               (m.crank_mass * r / 2 * sin(phi) + m.rod_mass * r / 2 * sin(phi) +
                m.counterweight_mass * (r * sin(phi) + m.counterweight_distance * sin(psi(phi))));
    }
};

template <typename Scalar>
EnergyRise<Scalar> rise_at(const Mechanism<Scalar>& m, const Scalar& omega, const Scalar& phi) {
    using std::cos;
    using std::sin;
    return energy_rise(m, omega, Scalar(sin(phi)), Scalar(cos(phi)), inertia_at(m, phi));
}

class ElasticHingeEnergy : public testing::TestWithParam<bool> {
  protected:
    Mechanism<Fifty> mechanism() const {
        const auto plain = test::zotov_mechanism<Fifty>();
        return GetParam() ? test::with_counterweight<Fifty>(plain, Fifty(1) / 10) : plain;
    }
};

TEST_P(ElasticHingeEnergy, IsThatOfTheBodiesOneByOne) {
    const Bodies bodies{mechanism()};
    const Fifty omega(137);
    for (const char* text : {"0.2", "1.3", "2.6", "3.5", "5.1"}) {
        const Fifty phi(text);
        const Fifty inertia = inertia_at(bodies.m, phi).value;
        EXPECT_LT(abs(inertia * omega * omega / 2 - bodies.kinetic(phi, omega)), Fifty("1e-25"));
        const auto rise = rise_at(bodies.m, omega, phi);
        const Fifty direct = bodies.kinetic(phi, omega) + bodies.potential(phi) -
                             bodies.kinetic(Fifty(0), omega) - bodies.potential(Fifty(0));
        EXPECT_LT(abs(rise.rise - direct), Fifty("1e-25"));
    }
}

TEST_P(ElasticHingeEnergy, MomentIsTheDerivativeOfTheEnergy) {
    const auto m = mechanism();
    const Fifty omega(137);
    for (const char* text : {"0", "0.2", "1.3", "2.6", "3.5", "5.1"}) {
        const Fifty phi(text);
        const auto rise = rise_at(m, omega, phi);
        EXPECT_LT(abs(rise.slope -
                      derivative([&](const Fifty& x) { return rise_at(m, omega, x).rise; }, phi)),
                  Fifty("1e-22"));
        EXPECT_LT(abs(rise.second -
                      derivative([&](const Fifty& x) { return rise_at(m, omega, x).slope; }, phi)),
                  Fifty("1e-22"));
    }
}

TEST_P(ElasticHingeEnergy, RiseKeepsItsDigitsNearZero) {
    const auto exact = mechanism();
    Mechanism<double> m = test::zotov_mechanism<double>();
    if (GetParam()) {
        m = test::with_counterweight(m, 0.1);
    }
    for (const double phi : {1e-9, 1e-6, 1e-3}) {
        const double rise = inertia_at(m, phi).rise;
        const Fifty truth = inertia_at(exact, Fifty(phi)).rise;
        EXPECT_LT(abs(Fifty(rise) / truth - 1), 1e-14);
    }
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutCounterweight, ElasticHingeEnergy, testing::Bool());

}  // namespace
}  // namespace ravnoves::elastic_hinge
