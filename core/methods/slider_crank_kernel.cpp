#include <cmath>

#include "inertia-moments/engine.h"
#include "inertia-moments/method_choices.h"
#include "methods/definition.h"
#include "methods/slider_crank_series.h"
#include "numerics/constants.h"
#include "numerics/harmonics.h"
#include "numerics/slider_crank.h"

namespace ravnoves::methods {

namespace {

/// s, s′, s″ of one mechanism at equally spaced angles of one turn, in units of R.
struct Turn {
    SliderCrank<double> crank{1.0, 1.0, 0.0};
    std::size_t points = 720;

    std::size_t outputs() const { return 3 * points; }
    double evaluations() const { return static_cast<double>(points); }
    double angle(std::size_t i) const {
        return two_pi * static_cast<double>(i) / static_cast<double>(points);
    }
};

/// The piston's motion with a polynomial in w², w = λ (sin θ − K), for the rod's root.
struct PolynomialSliderCrank {
    const SliderCrank<double>& crank;
    std::span<const double> powers;

    PistonMotion<double> at(double sin_theta, double cos_theta) const {
        const double lambda = crank.lambda();
        const double w = lambda * (sin_theta - crank.relative_offset());
        const double x = w * w;
        double f = 0.0;  // with its first and half its second derivative by x
        double df = 0.0;
        double d2f = 0.0;
        for (std::size_t k = powers.size(); k-- > 0;) {
            d2f = d2f * x + df;
            df = df * x + f;
            f = f * x + powers[k];
        }
        // x′ = 2 w w′, x″ = 2 (w′² + w w″)
        const double dw = lambda * cos_theta;
        const double dx = 2.0 * w * dw;
        const double d2x = 2.0 * (dw * dw - w * lambda * sin_theta);
        const double r = crank.crank_radius;
        const double l = crank.rod_length;
        return {r * cos_theta + l * f, -r * sin_theta + l * df * dx,
                -r * cos_theta + l * (2.0 * d2f * dx * dx + df * d2x)};
    }
};

constexpr double arithmetic = 34.0;    // of SliderCrank::at() from given sines
constexpr double both_sines = 30.0;    // a sine and a cosine
constexpr double kept_sines = 4.0;     // a look-up
constexpr double rotated_sines = 6.0;  // one rotation

Message refusal_of(const Turn& turn) {
    return turn.crank.locks()
               ? CORE_TEXT("methods", "the mechanism locks: the crank cannot turn round")
               : Text{};
}

void put(std::span<double> out, std::size_t i, const PistonMotion<double>& motion) {
    out[3 * i] = motion.s;
    out[3 * i + 1] = motion.ds;
    out[3 * i + 2] = motion.d2s;
}

template <typename Scalar>
SliderCrank<Scalar> in(const SliderCrank<double>& crank) {
    return {Scalar(crank.crank_radius), Scalar(crank.rod_length), Scalar(crank.offset)};
}

template <typename Scalar>
void run_exact(const Turn& turn, std::span<double> out) {
    using std::cos;
    using std::sin;
    const auto crank = in<Scalar>(turn.crank);
    for (std::size_t i = 0; i < turn.points; ++i) {
        const auto theta = static_cast<Scalar>(turn.angle(i));
        const auto motion = crank.at(Scalar(sin(theta)), Scalar(cos(theta)));
        put(out, i, {motion.s, motion.ds, motion.d2s});
    }
}

template <typename Scalar>
void run_table(const SliderCrank<Scalar>& crank, std::span<const Scalar> sine,
               std::span<const Scalar> cosine, std::span<double> out) {
    for (std::size_t i = 0; i < sine.size(); ++i) {
        const auto motion = crank.at(sine[i], cosine[i]);
        put(out, i, {motion.s, motion.ds, motion.d2s});
    }
}

/// Sines by turning a vector through the step, from a fresh sine every `restart` points.
template <typename Scalar>
void run_recurrence(const Turn& turn, std::size_t restart, std::span<double> out) {
    const auto crank = in<Scalar>(turn.crank);
    const auto step = static_cast<Scalar>(two_pi / static_cast<double>(turn.points));
    const Scalar cos_step = std::cos(step);
    const Scalar sin_step = std::sin(step);
    Scalar c(1);
    Scalar s(0);
    for (std::size_t i = 0; i < turn.points; ++i) {
        if (i % restart == 0) {
            c = static_cast<Scalar>(std::cos(turn.angle(i)));
            s = static_cast<Scalar>(std::sin(turn.angle(i)));
        }
        const auto motion = crank.at(s, c);
        put(out, i, {motion.s, motion.ds, motion.d2s});
        const Scalar next = c * cos_step - s * sin_step;
        s = s * cos_step + c * sin_step;
        c = next;
    }
}

Method<Turn> series() {
    Method<Turn> method;
    method.info = {"series",
                   CORE_TEXT("methods", "series in λ"),
                   CORE_TEXT("methods",
                             "the terms left out are of the order (λ(1 + K))^2n: three digits at λ "
                             "= 0.5 with 4 terms, and no convergence at locking"),
                   {{CORE_TEXT("methods", "2 terms"), 2},
                    {CORE_TEXT("methods", "3 terms"), 3},
                    {CORE_TEXT("methods", "4 terms"), 4},
                    counted(CORE_TEXT("methods", "%1 terms"), 6),
                    counted(CORE_TEXT("methods", "%1 terms"), 10)},
                   false};
    method.prepare = [](const Turn& turn, const Setting& setting) -> Run {
        return [turn, terms = static_cast<int>(setting.value),
                nodes = UniformTransform<double>(turn.points)](std::span<double> out) {
            const SeriesSliderCrank<double> series{turn.crank, terms};
            for (std::size_t i = 0; i < turn.points; ++i) {
                put(out, i, series.at(nodes.node_sin()[i], nodes.node_cos()[i]));
            }
            return refusal_of(turn);
        };
    };
    method.operations = [](const Turn&, const Setting& setting) {
        return kept_sines + 16.0 + 6.0 * (setting.value - 1.0);
    };
    return method;
}

/// √(1 − x) through Chebyshev points of 0…x₁, as a polynomial of x.
std::vector<double> root_polynomial(double longest, int terms) {
    // In 50 digits: turning a Chebyshev series into powers would cost the digits.
    const auto n = static_cast<std::size_t>(terms);
    std::vector<Real50> place(n);
    std::vector<Real50> difference(n);
    const Real50& pi = boost::math::constants::pi<Real50>();
    for (std::size_t j = 0; j < n; ++j) {
        const Real50 angle = pi * (Real50(j) + Real50(0.5)) / Real50(n);
        place[j] = Real50(longest) * (1 - cos(angle)) / 2;
        difference[j] = sqrt(Real50(1 - place[j]));
    }
    // Newton's divided differences, then his form multiplied out.
    for (std::size_t k = 1; k < n; ++k) {
        for (std::size_t j = n - 1; j >= k; --j) {
            difference[j] = (difference[j] - difference[j - 1]) / (place[j] - place[j - k]);
        }
    }
    std::vector<Real50> power(n, Real50(0));
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = n - 1; j > 0; --j) {
            power[j] = power[j - 1] - place[k] * power[j];
        }
        power[0] = difference[k] - place[k] * power[0];
    }
    return {power.begin(), power.end()};
}

Method<Turn> chebyshev() {
    Method<Turn> method;
    method.info = {
        "chebyshev",
        CORE_TEXT("methods", "Chebyshev interpolant of the rod's root"),
        CORE_TEXT(
            "methods",
            "spreads its error over all angles: one digit more than the series with four terms and "
            "two with six, but no convergence at locking either, where the root has no slope"),
        {counted(CORE_TEXT("methods", "%1 terms"), 3), counted(CORE_TEXT("methods", "%1 terms"), 4),
         counted(CORE_TEXT("methods", "%1 terms"), 6),
         counted(CORE_TEXT("methods", "%1 terms"), 10)},
        false};
    method.prepare = [](const Turn& turn, const Setting& setting) -> Run {
        const double reach = turn.crank.lambda() * (1.0 + std::abs(turn.crank.relative_offset()));
        std::vector<double> powers;
        if (!turn.crank.locks()) {
            powers = root_polynomial(reach * reach, static_cast<int>(setting.value));
        }
        return [turn, powers = std::move(powers),
                nodes = UniformTransform<double>(turn.points)](std::span<double> out) {
            const PolynomialSliderCrank polynomial{turn.crank, powers};
            for (std::size_t i = 0; i < turn.points && !powers.empty(); ++i) {
                put(out, i, polynomial.at(nodes.node_sin()[i], nodes.node_cos()[i]));
            }
            return refusal_of(turn);
        };
    };
    method.operations = [](const Turn&, const Setting& setting) {
        return kept_sines + 22.0 + 6.0 * (setting.value - 1.0);
    };
    return method;
}

Method<Turn> exact() {
    Method<Turn> method;
    method.info = {"exact",
                   CORE_TEXT("methods", "exact"),
                   CORE_TEXT("methods",
                             "in float the angle itself has seven digits; near locking the error "
                             "grows as the rounding divided by 1 − λ(1 + K)"),
                   {{CORE_TEXT("methods", "float"), 0}, {CORE_TEXT("methods", "double"), 1}},
                   false};
    method.prepare = [](const Turn& turn, const Setting& setting) -> Run {
        return [turn, wide = setting.value > 0](std::span<double> out) {
            wide ? run_exact<double>(turn, out) : run_exact<float>(turn, out);
            return refusal_of(turn);
        };
    };
    method.operations = [](const Turn&, const Setting&) { return arithmetic + both_sines; };
    return method;
}

Method<Turn> exact_recurrence() {
    Method<Turn> method;
    method.info = {
        "exact-recurrence",
        CORE_TEXT("methods", "exact, sines by recurrence"),
        CORE_TEXT("methods", "rounding adds up over the points since the last fresh sine"),
        {{CORE_TEXT("methods", "float, never fresh"), -1e9},
         {CORE_TEXT("methods", "never fresh"), 1e9},
         counted(CORE_TEXT("methods", "fresh every %1"), 256),
         counted(CORE_TEXT("methods", "fresh every %1"), 16)},
        false};
    method.prepare = [](const Turn& turn, const Setting& setting) -> Run {
        return [turn, value = setting.value](std::span<double> out) {
            const auto restart = static_cast<std::size_t>(std::abs(value));
            value > 0 ? run_recurrence<double>(turn, restart, out)
                      : run_recurrence<float>(turn, restart, out);
            return refusal_of(turn);
        };
    };
    method.operations = [](const Turn& turn, const Setting& setting) {
        const double restart = std::min(std::abs(setting.value), turn.evaluations());
        return arithmetic + rotated_sines + both_sines / restart;
    };
    return method;
}

template <typename Scalar>
Run prepare_table(const Turn& turn) {
    const UniformTransform<double> nodes(turn.points);
    std::vector<Scalar> sine(nodes.node_sin().begin(), nodes.node_sin().end());
    std::vector<Scalar> cosine(nodes.node_cos().begin(), nodes.node_cos().end());
    return [crank = in<Scalar>(turn.crank), sine = std::move(sine), cosine = std::move(cosine),
            refusal = refusal_of(turn)](std::span<double> out) {
        run_table<Scalar>(crank, sine, cosine, out);
        return refusal;
    };
}

Method<Turn> exact_table() {
    Method<Turn> method;
    method.info = {"exact-table",
                   CORE_TEXT("methods", "exact, sines kept"),
                   CORE_TEXT("methods",
                             "near locking the error grows as the rounding divided by 1 − λ(1 + "
                             "K): nine digits are left at 1 − λ(1 + K) = 10⁻⁶"),
                   {{CORE_TEXT("methods", "float"), 0}, {CORE_TEXT("methods", "double"), 1}},
                   false};
    method.prepare = [](const Turn& turn, const Setting& setting) -> Run {
        return setting.value > 0 ? prepare_table<double>(turn) : prepare_table<float>(turn);
    };
    method.operations = [](const Turn&, const Setting&) { return arithmetic + kept_sines; };
    return method;
}

/// The points at which errors are taken: all over the turn, close about the rod's farthest swing,
/// and at the end, where a recurrence has drifted most.
std::vector<std::size_t> probes(std::size_t points) {
    std::vector<std::size_t> list;
    constexpr std::size_t spread = 36;
    for (std::size_t k = 0; k < spread; ++k) {
        list.push_back(k * points / spread);
    }
    for (const std::size_t quarter : {points / 4, 3 * points / 4}) {
        for (std::size_t k = 1; k <= 3 && quarter + k < points; ++k) {
            list.push_back(quarter + k);
            list.push_back(quarter - k);
        }
    }
    list.push_back(points - 1);
    return list;
}

std::vector<Expected> reference(const Turn& turn) {
    const auto crank = in<Real50>(turn.crank);
    const Real50 step = boost::math::constants::two_pi<Real50>() / Real50(turn.points);
    std::vector<Expected> list;
    if (turn.crank.locks()) {
        return list;
    }
    double scale[3] = {1.0, 1.0, 1.0};
    for (const std::size_t i : probes(turn.points)) {
        const auto motion = crank.at(Real50(step * Real50(i)));
        const Real50 values[3] = {motion.s, motion.ds, motion.d2s};
        for (std::size_t k = 0; k < 3; ++k) {
            list.push_back({3 * i + k, values[k], 1.0});
            scale[k] = std::max(scale[k], std::abs(static_cast<double>(values[k])));
        }
    }
    for (Expected& expected : list) {
        expected.scale = scale[expected.index % 3];
    }
    return list;
}

/// The pin from the closure of the mechanism alone: |crankpin − pin| = L by Newton's method, its
/// derivatives by differences of that.
std::optional<double> check(const Turn& turn, const std::vector<Expected>& reference) {
    const Real50 L(turn.crank.rod_length);
    const Real50 e(turn.crank.offset);
    const Real50 step = boost::math::constants::two_pi<Real50>() / Real50(turn.points);
    const auto pin = [&](const Real50& theta) {
        const Real50 x = cos(theta);
        const Real50 y = sin(theta) - e;
        Real50 s = L + 1;  // outside the root, from where Newton's method descends
        for (int i = 0; i < 60; ++i) {
            const Real50 gap = (s - x) * (s - x) + y * y - L * L;
            const Real50 next = s - gap / (2 * (s - x));
            if (abs(Real50(next - s)) < Real50("1e-47")) {
                break;
            }
            s = next;
        }
        return s;
    };
    const Real50 h("1e-12");
    Real50 worst(0);
    for (std::size_t k = 0; k < reference.size(); k += 3 * 7) {
        const Real50 theta = step * Real50(reference[k].index / 3);
        const Real50 middle = pin(theta);
        const Real50 ahead = pin(theta + h);
        const Real50 behind = pin(theta - h);
        const Real50 values[3] = {middle, (ahead - behind) / (2 * h),
                                  (ahead - 2 * middle + behind) / (h * h)};
        for (std::size_t j = 0; j < 3; ++j) {
            const Real50 gap =
                abs(Real50(values[j] - reference[k + j].value)) / reference[k + j].scale;
            worst = std::max(worst, gap);
        }
    }
    return static_cast<double>(worst);
}

Turn turn_of(double lambda, double relative_offset, std::size_t points = 720) {
    return {{1.0, 1.0 / lambda, relative_offset}, points};
}

}  // namespace

Kernel slider_crank_kernel() {
    constexpr double vr5_lambda = 0.265;  // of the paper's VR5
    constexpr double vr5_offset = 12.5 / 45.0;
    Definition<Turn> definition;
    Kernel& kernel = definition.kernel;
    kernel.id = "slider-crank";
    kernel.title = CORE_TEXT("methods", "Slider-crank kinematics");
    kernel.quantity = CORE_TEXT("methods", "s, s′, s″ of the piston pin over one turn");
    kernel.error_measure = CORE_TEXT("methods", "part of the largest |s|, |s′|, |s″| of the turn");
    kernel.evaluation = CORE_TEXT("methods", "s, s′ and s″ at one crank angle");
    kernel.check_text = CORE_TEXT(
        "methods",
        "the closure |crankpin − pin| = L solved by Newton's method, derivatives by differences");
    kernel.check_tolerance = 1e-15;
    kernel.choice = inertia_moments::slider_crank_choice;
    definition.methods = {series(), chebyshev(), exact(), exact_recurrence(), exact_table()};
    definition.sweeps = {
        {{"lambda", CORE_TEXT("methods", "crank ratio λ, K = 0"), units::none, 0.01, 1.0,
          Spacing::towards_end, 1e-6, 0.01, 1.0 - 1e-6, vr5_lambda},
         [](double lambda) { return turn_of(lambda, 0.0); }},
        {{"offset", CORE_TEXT("methods", "relative offset K at λ = 0.265"), units::none, 0.0,
          1.0 / vr5_lambda - 1.0, Spacing::towards_end, 1e-6, 0.0,
          (1.0 / vr5_lambda - 1.0) * (1.0 - 1e-6), vr5_offset},
         [](double offset) { return turn_of(vr5_lambda, offset); }},
        {{"points", CORE_TEXT("methods", "points of one turn at λ = 0.265"), units::none, 72.0,
          720'000.0, Spacing::logarithmic, 0.0, 72.0, 720'000.0, 720.0},
         [](double points) {
             return turn_of(vr5_lambda, vr5_offset, static_cast<std::size_t>(points / 4.0) * 4);
         }},
    };
    definition.reference = reference;
    definition.refusal = [](const Turn& turn) {
        const auto locking = inertia_moments::find_locking(
            turn.crank.crank_radius, turn.crank.lambda(), {{0.0, 0.0, turn.crank.offset, 0.0}});
        return locking ? inertia_moments::describe(*locking) : Message();
    };
    definition.check = check;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
