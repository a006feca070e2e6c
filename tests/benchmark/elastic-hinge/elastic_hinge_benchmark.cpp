#include <benchmark/benchmark.h>

#include <Eigen/Core>

#include "elastic-hinge/design.h"
#include "elastic-hinge/presets.h"
#include "elastic-hinge/solver.h"

namespace ravnoves::elastic_hinge {
namespace {

/// What a case asks for: the curves at 721 points, three guides.
void solve_a_case(benchmark::State& state) {
    const Input input = preset_zotov();
    for (auto _ : state) {
        benchmark::DoNotOptimize(solve(input));
    }
}
BENCHMARK(solve_a_case)->Unit(benchmark::kMicrosecond);

/// All curves at one more λ, as a page with families asks for them.
void curves_at_another_lambda(benchmark::State& state) {
    Input input = preset_zotov();
    input.lambda = 0.35;
    for (auto _ : state) {
        benchmark::DoNotOptimize(curves_at(Design(input, false), input.angular_speed));
    }
}
BENCHMARK(curves_at_another_lambda)->Unit(benchmark::kMicrosecond);

/// The rival: seven of its curves written down in arrays of Eigen, without
/// derivatives, guides and checks.
void curves_in_plain_eigen(benchmark::State& state) {
    const Mechanism<double> m = Design(preset_zotov()).mechanism();
    const double omega = 100.0;
    const Eigen::ArrayXd phi = Eigen::ArrayXd::LinSpaced(721, 0.0, two_pi);
    for (auto _ : state) {
        const Eigen::ArrayXd s = phi.sin();
        const Eigen::ArrayXd c = phi.cos();
        const double r = m.crank_radius;
        const double l = m.rod_length();
        const double square = omega * omega;
        const Eigen::ArrayXd sin_psi = m.lambda * s;
        const Eigen::ArrayXd cos_psi = (1.0 - sin_psi.square()).sqrt();
        const Eigen::ArrayXd p = m.lambda * c / cos_psi;
        const Eigen::ArrayXd p2 = -sin_psi * (1.0 - p.square()) / cos_psi;
        const Eigen::ArrayXd d2cos = -(cos_psi * p.square() + sin_psi * p2);
        const Eigen::ArrayXd reach =
            m.slider_mass * (l * d2cos - r * c) + m.rod_mass * (l * d2cos / 2.0 - r * c) / 2.0;
        const Eigen::ArrayXd inertia =
            r * s * reach - m.rod_mass * l * l / 12.0 * p2 - m.rod_mass * r * l / 4.0 * s * cos_psi;
        const Eigen::ArrayXd moment = m.gravity * m.static_moment() * cos_psi + square * inertia;
        const double mean = moment.head(720).mean();
        const Eigen::ArrayXd potential = moment - mean;
        const Eigen::ArrayXd without = -moment / (l * cos_psi);
        const Eigen::ArrayXd with = -mean / (l * cos_psi);
        const Eigen::ArrayXd slide = s * (1.0 + p);
        const Eigen::ArrayXd reduced =
            r * r *
            ((m.crank_mass + m.rod_mass) / 3.0 + m.slider_mass * slide.square() +
             m.rod_mass * (s.square() * (1.0 + p / 2.0).square() - s.square() / 4.0 -
                           (1.0 - m.lambda * m.lambda) * s.square() / (12.0 * cos_psi.square())));
        const Eigen::ArrayXd dslide = c * (1.0 + p) + s * p2;
        const Eigen::ArrayXd slope =
            2.0 * r * r * (m.slider_mass * slide * dslide) +
            m.rod_mass * r * r *
                (s * c *
                     ((1.0 + p) * (p + 3.0) / 2.0 -
                      (1.0 - m.lambda * m.lambda) / (6.0 * cos_psi.square())) +
                 s.square() * ((1.0 + p / 2.0) * p2 -
                               (1.0 - m.lambda * m.lambda) / 6.0 * sin_psi * p / cos_psi.cube()));
        const Eigen::ArrayXd crank = 0.5 * square * slope + potential_amplitude(m) * c;
        const Eigen::ArrayXd crank_with_rod = crank + potential * (1.0 + p);
        benchmark::DoNotOptimize(without.data());
        benchmark::DoNotOptimize(with.data());
        benchmark::DoNotOptimize(reduced.data());
        benchmark::DoNotOptimize(crank_with_rod.data());
        benchmark::ClobberMemory();
    }
}
BENCHMARK(curves_in_plain_eigen)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ravnoves::elastic_hinge
