#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "methods/definition.h"
#include "studies/sampler.h"
#include "studies/taylor.h"

namespace ravnoves::methods {

namespace {

using studies::Law;

/// So many studies with seeds of their own are one problem: their errors are averaged, so that no
/// lucky seed counts.
constexpr std::size_t seeds = 16;
constexpr double jump_deg = 60.0;  ///< between the two minima
constexpr double sway_deg = 10.0;  ///< of each of them
/// What no number holds: it is rejected.
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double aside = 0.5;  ///< part of the value that another input makes, unbound

/// A value whose inputs scatter uniformly.
struct ScatterCase {
    enum class Kind {
        amplitude,  ///< of the shaft's moment, part of its nominal: m_j r l ω², each 1 ± size
        jump,    ///< a best angle, degrees: of two minima the other where x₁ − x₂ < −size
        corner,  ///< a value that a clearance holds above size, and another input moves as well
    };
    Kind kind = Kind::amplitude;
    double size = 0.01;

    std::size_t inputs() const {
        constexpr std::array<std::size_t, 3> counts{4, 3, 2};
        return counts[static_cast<std::size_t>(kind)];
    }
    std::vector<Law> laws() const {
        const bool about_one = kind == Kind::amplitude;
        return std::vector<Law>(inputs(),
                                studies::law_of({.pointer = "", .size = about_one ? size : 1.0},
                                                about_one ? 1.0 : 0.0));
    }
    double operator()(std::span<const double> x) const {
        switch (kind) {
            case Kind::amplitude:
                return x[0] * x[1] * x[2] * x[3] * x[3];
            case Kind::jump:
                return sway_deg * x[2] + (x[0] - x[1] + size < 0.0 ? jump_deg : 0.0);
            case Kind::corner:
                break;
        }
        return std::max(x[0], size) + aside * x[1];
    }
};

struct Moments {
    Real50 mean;
    Real50 variance;
};

/// In closed form.
Moments closed_form(const ScatterCase& of) {
    const Real50 s(of.size);
    const Real50 third = Real50(1) / 3;
    switch (of.kind) {
        case ScatterCase::Kind::amplitude: {
            const Real50 square = 1 + s * s * third;
            const Real50 fourth = 1 + 2 * s * s + s * s * s * s / 5;
            return {square, square * square * square * fourth - square * square};
        }
        case ScatterCase::Kind::jump: {
            const Real50 gap = std::max(Real50(2 - s), Real50(0));
            const Real50 p = gap * gap / 8;
            return {jump_deg * p,
                    p * (1 - p) * jump_deg * jump_deg + Real50(sway_deg) * sway_deg * third};
        }
        case ScatterCase::Kind::corner:
            break;
    }
    const Real50 mean = s * (s + 1) / 2 + (1 - s * s) / 4;
    const Real50 square = s * s * (s + 1) / 2 + (1 - s * s * s) / 6;
    return {mean, square - mean * mean + Real50(aside) * aside * third};
}

/// The case in the place of a scene.
class CaseResponse final : public Response {
  public:
    explicit CaseResponse(const ScatterCase& of) : of_(of) {}
    bool evaluate(std::span<const double> x, std::span<double> y) override {
        y[0] = of_(x);
        return true;
    }

  private:
    ScatterCase of_;
};

Run linear(const ScatterCase& of, double) {
    return [of, laws = of.laws()](std::span<double> out) {
        CaseResponse response(of);
        const studies::Taylor taylor = studies::expand(response, laws, 1).front();
        const auto found = taylor.propagated(laws);
        for (std::size_t seed = 0; seed < seeds; ++seed) {
            out[2 * seed] = found ? *taylor.value : nothing;
            out[2 * seed + 1] = found ? found->deviation : nothing;
        }
        return Message();
    };
}

Method<ScatterCase> sampled(MethodInfo info, studies::Method points) {
    return {std::move(info), [points](const ScatterCase& of, double samples) -> Run {
                return [of, points, laws = of.laws(),
                        samples = static_cast<std::uint64_t>(samples)](std::span<double> out) {
                    std::vector<double> u(laws.size());
                    for (std::size_t seed = 0; seed < seeds; ++seed) {
                        studies::Sampler sampler(points, seed, laws.size());
                        double sum = 0.0;
                        double squares = 0.0;
                        double first = 0.0;
                        for (std::uint64_t i = 0; i < samples; ++i) {
                            sampler.point(i, u);
                            for (std::size_t j = 0; j < u.size(); ++j) {
                                u[j] = laws[j].at(u[j]);
                            }
                            const double value = of(u);
                            first = i == 0 ? value : first;
                            sum += value - first;
                            squares += (value - first) * (value - first);
                        }
                        const auto n = static_cast<double>(samples);
                        out[2 * seed] = first + sum / n;
                        out[2 * seed + 1] =
                            std::sqrt(std::max(0.0, squares - sum * sum / n) / (n - 1.0));
                    }
                    return Message();
                };
            }};
}

std::vector<Expected> reference(const ScatterCase& of) {
    const Moments known = closed_form(of);
    const Real50 deviation = sqrt(known.variance);
    const auto scale = static_cast<double>(deviation);
    return {{0, known.mean, scale}, {1, deviation, scale}};
}

/// Root mean square over the seeds of the larger of both errors.
double measure(const ScatterCase&, std::span<const double> out,
               const std::vector<Expected>& reference) {
    double squares = 0.0;
    for (std::size_t seed = 0; seed < seeds; ++seed) {
        double worst = 0.0;
        for (const Expected& each : reference) {
            const Real50 off = Real50(out[2 * seed + each.index]) - each.value;
            worst = std::max(worst, static_cast<double>(abs(off)) / each.scale);
        }
        squares += worst * worst;
    }
    return std::sqrt(squares / static_cast<double>(seeds));
}

}  // namespace

Kernel scatter_kernel() {
    Definition<ScatterCase> definition;
    definition.outputs = 2 * seeds;
    definition.evaluations = [](const ScatterCase&) { return static_cast<double>(seeds); };
    Kernel& kernel = definition.kernel;
    kernel.id = "scatter";
    kernel.title = Text::tr("Uncertain inputs");
    kernel.quantity = Text::tr("mean and standard deviation of a result of uncertain inputs");
    kernel.error_measure =
        Text::tr("larger error of both, share of the standard deviation, RMS over 16 seeds");
    kernel.evaluation = Text::tr("one study, without the cost of the result itself");
    kernel.reference = Text::tr("closed forms of mean and variance");
    kernel.choice = {
        "balance-shaft", "sobol", "4096 samples", 1e-2,
        Text::tr(
            "Uncertain inputs are known to a few digits, so a hundredth of the standard "
            "deviation suffices. Slopes give that for a few samples, but fail unnoticed where an "
            "optimum jumps or a clearance limits. Scrambled Sobol points give it everywhere with "
            "the fewest samples; other seeds show their error.")};
    constexpr Text samples = Text::tr("%1 samples");
    definition.methods = {
        {{"linear",
          Text::tr("slopes at the nominal"),
          Text::tr("does not include anything away from the nominal: a jump, a corner, a curve"),
          {{Text::tr("differences"), 0}}},
         linear},
        sampled({"monte-carlo", Text::tr("Monte Carlo"),
                 Text::tr("converges always, but a digit needs a hundred times the samples"),
                 counted(samples, {64, 256, 1024, 8192}), true},
                studies::Method::monte_carlo),
        sampled({"sobol", Text::tr("scrambled Sobol points"),
                 Text::tr("a digit needs about ten times the samples; across a jump a little more"),
                 counted(samples, {64, 256, 1024, 4096}), true},
                studies::Method::sobol),
    };
    using Kind = ScatterCase::Kind;
    constexpr std::size_t points = 13;  // each takes some hundred thousand samples
    definition.sweeps = {
        {{"scatter", Text::tr("scatter of masses, lengths and speed, an amplitude"), units::none,
          1e-4, 0.5, Spacing::logarithmic, 1e-4, 0.5, 0.01, points},
         [](double size) {
             return ScatterCase{Kind::amplitude, size};
         }},
        {{"jump", Text::tr("difference of two minima, share of its scatter"), units::none, 0.05,
          1.2, Spacing::linear, 0.05, 1.2, 0.8, points},
         [](double gap) {
             return ScatterCase{Kind::jump, gap};
         }},
        {{"corner", Text::tr("where a clearance limits, share of the input's scatter"), units::none,
          -0.95, 0.9, Spacing::linear, -0.95, 0.9, -0.5, points},
         [](double place) {
             return ScatterCase{Kind::corner, place};
         }},
    };
    definition.reference = reference;
    definition.measure = measure;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
