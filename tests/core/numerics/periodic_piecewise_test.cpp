#include "numerics/periodic_piecewise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "numerics/constants.h"

namespace ravnoves {
namespace {

std::pair<std::vector<double>, std::vector<double>> random_rows(unsigned seed, std::size_t rows,
                                                                double period) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> unit(0.1, 1.0);
    std::vector<double> x{-1.5};
    std::vector<double> y;
    for (std::size_t i = 1; i < rows; ++i) {
        x.push_back(x.back() + unit(generator));
        y.push_back(unit(generator) - 0.5);
    }
    const double scale = period / (x.back() - x.front());
    for (double& place : x) {
        place = -1.5 + (place + 1.5) * scale;
    }
    y.push_back(y.front());
    return {x, y};
}

double integral(const PeriodicPiecewise& f, const auto& g) {
    double sum = 0.0;
    for (std::size_t i = 0; i < f.size(); ++i) {
        constexpr int parts = 10;
        const double h = (f.knots()[i + 1] - f.knots()[i]) / parts;
        for (int k = 0; k < parts; ++k) {
            sum += boost::math::quadrature::gauss<double, 15>::integrate(
                g, f.knots()[i] + h * k, f.knots()[i] + h * (k + 1));
        }
    }
    return sum;
}

class Piecewise : public testing::TestWithParam<std::tuple<bool, int>> {
  protected:
    static PeriodicPiecewise make() {
        const auto [cubic, rows] = GetParam();
        const auto [x, y] =
            random_rows(static_cast<unsigned>(rows), static_cast<std::size_t>(rows), 4.0 * pi);
        return cubic ? PeriodicPiecewise::cubic(x, y) : PeriodicPiecewise::linear(x, y);
    }
};

TEST_P(Piecewise, PassesThroughItsRowsAndRepeats) {
    const auto f = make();
    for (std::size_t i = 0; i < f.size(); ++i) {
        const double x = f.knots()[i];
        EXPECT_EQ(f(x), f.pieces()[i].y);
        const double h = f.knots()[i + 1] - x;
        EXPECT_NEAR(f.pieces()[i].value(h), f.pieces()[(i + 1) % f.size()].y, 1e-13);
        for (const double shift : {-3.0, 1.0, 2.0}) {
            const double inner = x + 0.3 * h;
            EXPECT_NEAR(f(inner + shift * f.period()), f(inner), 1e-11);
        }
    }
    EXPECT_EQ(f(f.knots().back()), f(f.knots().front()));
}

TEST_P(Piecewise, IntegralsAreThoseOfTheInterpolant) {
    const auto f = make();
    const double period = f.period();
    EXPECT_NEAR(f.mean(), integral(f, [&](double x) { return f(x); }) / period, 1e-13);
    const double mean = f.mean();
    EXPECT_NEAR(f.variance(),
                integral(f, [&](double x) { return (f(x) - mean) * (f(x) - mean); }) / period,
                1e-12);
    for (const double order : {0.5, 1.0, 2.0, 5.5}) {
        const FourierPair pair = f.fourier(order);
        EXPECT_NEAR(pair.a,
                    integral(f, [&](double x) { return f(x) * std::cos(order * x); }) * 2 / period,
                    1e-12);
        EXPECT_NEAR(pair.b,
                    integral(f, [&](double x) { return f(x) * std::sin(order * x); }) * 2 / period,
                    1e-12);
    }
}

TEST_P(Piecewise, SeriesIsTheCoefficientsOneByOne) {
    const auto f = make();
    const auto series = f.fourier_series(0.5, 24);
    ASSERT_EQ(series.size(), 24U);
    for (std::size_t k = 0; k < series.size(); ++k) {
        const FourierPair pair = f.fourier(0.5 * static_cast<double>(k + 1));
        EXPECT_NEAR(series[k].a, pair.a, 1e-13) << k;
        EXPECT_NEAR(series[k].b, pair.b, 1e-13) << k;
    }
}

INSTANTIATE_TEST_SUITE_P(LinearAndCubic, Piecewise,
                         testing::Combine(testing::Bool(), testing::Values(2, 3, 4, 10, 200)));

TEST(PeriodicSpline, IsSmoothOverItsEndsToo) {
    for (const std::size_t rows : {2U, 3U, 4U, 10U, 200U}) {
        const auto [x, y] = random_rows(static_cast<unsigned>(rows), rows, 4.0 * pi);
        const auto f = PeriodicPiecewise::cubic(x, y);
        for (std::size_t i = 0; i < f.size(); ++i) {
            const double h = f.knots()[i + 1] - f.knots()[i];
            const auto end = f.pieces()[i].shifted(h);
            const auto& next = f.pieces()[(i + 1) % f.size()];
            EXPECT_NEAR(end.c1, next.c1, 1e-9 * (1.0 + std::abs(next.c1)));
            EXPECT_NEAR(end.c2, next.c2, 1e-9 * (1.0 + std::abs(next.c2)));
        }
    }
}

TEST(PeriodicSpline, ConvergesWithTheFourthOrder) {
    const auto f = [](double x) { return std::exp(std::sin(x)); };
    double previous = 0.0;
    for (const int n : {20, 40, 80, 160}) {
        std::vector<double> x;
        std::vector<double> y;
        for (int i = 0; i <= n; ++i) {
            x.push_back(two_pi * i / n);
            y.push_back(f(two_pi * (i % n) / n));
        }
        const auto spline = PeriodicPiecewise::cubic(x, y);
        double error = 0.0;
        for (int i = 0; i < 1000; ++i) {
            error = std::max(error, std::abs(spline(0.00628 * i) - f(0.00628 * i)));
        }
        if (previous > 0.0) {
            EXPECT_NEAR(std::log2(previous / error), 4.0, 0.3);
        }
        previous = error;
    }
}

TEST(CubicsThroughAFunction, ConvergeWithTheFourthOrderAndKeepKinks) {
    // A kink at 1 and over the ends; the knots lie on them.
    const std::function<double(const double&)> f = [](const double& x) {
        return std::exp(std::sin(pi * x)) + std::abs(x - 1.0);
    };
    double previous = 0.0;
    for (const int n : {20, 40, 80}) {
        std::vector<double> knots;
        for (int i = 0; i <= n; ++i) {
            knots.push_back(0.2 * i * 10.0 / n);
        }
        const auto curve = PeriodicPiecewise::through(f, knots);
        const auto mirrored = curve.negated();
        double error = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const double x = 0.001 * i;
            error = std::max(error, std::abs(curve(x) - f(x)));
            EXPECT_EQ(mirrored(x), -curve(x));
        }
        if (previous > 0.0) {
            EXPECT_NEAR(std::log2(previous / error), 4.0, 0.4);
        }
        previous = error;
    }
    EXPECT_LT(previous, 2e-6);
}

TEST(PeriodicSpline, OfAConstantIsTheConstant) {
    const auto [x, unused] = random_rows(3, 20, 10.0);
    const auto spline = PeriodicPiecewise::cubic(x, std::vector<double>(20, 4.0));
    EXPECT_EQ(spline(0.3), 4.0);
    EXPECT_EQ(spline.variance(), 0.0);
}

}  // namespace
}  // namespace ravnoves
