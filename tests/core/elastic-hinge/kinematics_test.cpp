#include "elastic-hinge/kinematics.h"

#include "elastic-hinge/design.h"
#include "support.h"

namespace ravnoves::elastic_hinge {
namespace {

using test::derivative;
using test::Fifty;

TEST(ElasticHingeKinematics, QuartersOfATurnAreExact) {
    for (const int samples : {13, 721}) {
        const AngleGrid grid = *angle_grid(samples);
        const std::size_t quarter = (grid.size() - 1) / 4;
        const double sines[] = {0.0, 1.0, 0.0, -1.0, 0.0};
        for (std::size_t i = 0; i < 5; ++i) {
            EXPECT_EQ(grid.sin_phi[i * quarter], sines[i]);
            EXPECT_EQ(grid.cos_phi[i * quarter], sines[(i + 1) % 4]);
        }
    }
}

/// Every derivative of either kinematics is the derivative of the one before it.
void expect_derivatives(Kinematics kinematics, const Fifty& lambda) {
    const auto at = [&](const Fifty& phi) {
        return rod_angle(kinematics, lambda, Fifty(sin(phi)), Fifty(cos(phi)));
    };
    for (const char* text : {"0.1", "0.7", "1.5", "1.6", "2.9", "4", "5.5"}) {
        const Fifty phi(text);
        const auto rod = at(phi);
        const auto near = [&](const Fifty& value, auto member) {
            const Fifty numeric = derivative([&](const Fifty& x) { return at(x).*member; }, phi);
            EXPECT_LT(abs(value - numeric), Fifty("1e-25") * (1 + abs(value)))
                << text << " " << value << " " << numeric;
        };
        using Rod = RodAngle<Fifty>;
        near(rod.dcos, &Rod::cos_psi);
        near(rod.d2cos, &Rod::dcos);
        near(rod.d3cos, &Rod::d2cos);
        near(rod.d3psi, &Rod::d2psi);
        if (kinematics == Kinematics::exact) {
            near(rod.d2psi, &Rod::dpsi);
            const Fifty psi =
                derivative([&](const Fifty& x) { return Fifty(asin(lambda * sin(x))); }, phi);
            EXPECT_LT(abs(rod.dpsi - psi), Fifty("1e-25"));
        }
    }
}

TEST(ElasticHingeKinematics, DerivativesAreDerivatives) {
    for (const char* lambda : {"0.05", "0.3", "0.8", "0.99"}) {
        expect_derivatives(Kinematics::exact, Fifty(lambda));
        expect_derivatives(Kinematics::series, Fifty(lambda));
    }
    expect_derivatives(Kinematics::series, Fifty(1));
}

TEST(ElasticHingeKinematics, SeriesDiffersFromExactByTheFourthPowerOfLambda) {
    double before = 0.0;
    for (const double lambda : {0.2, 0.1, 0.05, 0.025}) {
        double error = 0.0;
        for (int i = 0; i < 3600; ++i) {
            const double phi = i * 0.1 * degree;
            const double s = std::sin(phi);
            const double c = std::cos(phi);
            error = std::max(error, std::abs(rod_angle_series(lambda, s, c).cos_psi -
                                             rod_angle_exact(lambda, s, c).cos_psi));
        }
        // 1 − x/2 against √(1 − x): the first term left out is x²/8 with x = λ².
        EXPECT_NEAR(error / std::pow(lambda, 4), 0.125, 0.1 * lambda);
        if (before > 0.0) {
            EXPECT_NEAR(std::log2(before / error), 4.0, 0.05);
        }
        before = error;
    }
}

}  // namespace
}  // namespace ravnoves::elastic_hinge
