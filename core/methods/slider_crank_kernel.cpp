#include <cmath>

#include "methods/definition.h"
#include "methods/reference_mechanism.h"
#include "numerics/constants.h"
#include "numerics/harmonics.h"

namespace ravnoves::methods {

namespace {

// s, s′, s″ of one mechanism at equally spaced angles of one turn, in units of R.
constexpr std::size_t points = 720;

double angle(std::size_t i) {
    return two_pi * static_cast<double>(i) / static_cast<double>(points);
}

Message rejection_of(const SliderCrank<double>& crank) {
    return crank.locks() ? Text::tr("the mechanism locks: the crank cannot make a turn") : Text{};
}

template <typename Scalar>
void put(std::span<double> out, std::size_t i, const PistonMotion<Scalar>& motion) {
    out[3 * i] = motion.s;
    out[3 * i + 1] = motion.ds;
    out[3 * i + 2] = motion.d2s;
}

template <typename Scalar>
SliderCrank<Scalar> in(const SliderCrank<double>& crank) {
    return {Scalar(crank.crank_radius), Scalar(crank.rod_length), Scalar(crank.offset)};
}

/// The rod's root as a binomial series: √(1 − w²) ≈ 1 − w²/2 − w⁴/8 − …, w = λ (sin θ − K). Two
/// terms are the form of [chainov-vallejo-maldonado], with the constants that it leaves out of s.
PistonMotion<double> by_series(const SliderCrank<double>& crank, int terms, double sin_theta,
                               double cos_theta) {
    const double lambda = crank.lambda();
    const double w = lambda * (sin_theta - crank.relative_offset());
    // f = Σ b_k w^(2k) with its first and second derivative by w.
    double f = 1.0;
    double df = 0.0;
    double d2f = 0.0;
    double b = 1.0;
    double power = 1.0;  // w^(2k − 2)
    for (int k = 1; k < terms; ++k) {
        b *= (2.0 * k - 3.0) / (2.0 * k);
        d2f += b * 2.0 * k * (2.0 * k - 1.0) * power;
        df += b * 2.0 * k * power * w;
        power *= w * w;
        f += b * power;
    }
    const double r = crank.crank_radius;
    const double l = crank.rod_length;
    const double dw = lambda * cos_theta;
    const double d2w = -lambda * sin_theta;
    return {r * cos_theta + l * f, -r * sin_theta + l * df * dw,
            -r * cos_theta + l * (d2f * dw * dw + df * d2w)};
}

Run prepare_series(const SliderCrank<double>& mechanism, double terms) {
    return [mechanism, terms = static_cast<int>(terms),
            nodes = UniformTransform<double>(points)](std::span<double> out) {
        for (std::size_t i = 0; i < points; ++i) {
            put(out, i, by_series(mechanism, terms, nodes.node_sin()[i], nodes.node_cos()[i]));
        }
        return rejection_of(mechanism);
    };
}

template <typename Scalar>
Run prepare_exact(const SliderCrank<double>& mechanism) {
    return [mechanism](std::span<double> out) {
        const auto crank = in<Scalar>(mechanism);
        for (std::size_t i = 0; i < points; ++i) {
            put(out, i, crank.at(static_cast<Scalar>(angle(i))));
        }
        return rejection_of(mechanism);
    };
}

template <typename Scalar>
Run prepare_table(const SliderCrank<double>& mechanism) {
    const UniformTransform<double> nodes(points);
    std::vector<Scalar> sine(nodes.node_sin().begin(), nodes.node_sin().end());
    std::vector<Scalar> cosine(nodes.node_cos().begin(), nodes.node_cos().end());
    return [crank = in<Scalar>(mechanism), sine = std::move(sine), cosine = std::move(cosine),
            rejection = rejection_of(mechanism)](std::span<double> out) {
        for (std::size_t i = 0; i < sine.size(); ++i) {
            put(out, i, crank.at(sine[i], cosine[i]));
        }
        return rejection;
    };
}

/// All over the turn, and close about the rod's farthest swing.
std::vector<std::size_t> probes() {
    std::vector<std::size_t> list;
    constexpr std::size_t spread = 36;
    for (std::size_t k = 0; k < spread; ++k) {
        list.push_back(k * points / spread);
    }
    for (const std::size_t quarter : {points / 4, 3 * points / 4}) {
        for (std::size_t k = 1; k <= 3; ++k) {
            list.push_back(quarter + k);
            list.push_back(quarter - k);
        }
    }
    return list;
}

std::vector<Expected> reference(const SliderCrank<double>& mechanism) {
    const Real50 step = boost::math::constants::two_pi<Real50>() / Real50(points);
    std::vector<Expected> list;
    if (mechanism.locks()) {
        return list;
    }
    double scale[3] = {1.0, 1.0, 1.0};
    for (const std::size_t i : probes()) {
        const auto motion = reference_piston(mechanism, step * Real50(i));
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

}  // namespace

Kernel slider_crank_kernel() {
    const std::vector<Setting> precision{{Text::tr("float"), 0}, {Text::tr("double"), 1}};
    Definition<SliderCrank<double>> definition;
    definition.outputs = 3 * points;
    definition.evaluations = [](const SliderCrank<double>&) { return static_cast<double>(points); };
    Kernel& kernel = definition.kernel;
    kernel.id = "slider-crank";
    kernel.title = Text::tr("Slider-crank kinematics");
    kernel.quantity = Text::tr("s, s′, s″ of the piston pin over one turn");
    kernel.error_measure = Text::tr("share of the maximum |s|, |s′|, |s″| of the turn");
    kernel.evaluation = Text::tr("s, s′ and s″ at one crank angle");
    kernel.reference = Text::tr("the closure |crankpin − pin| = L, differentiated");
    kernel.choice = {
        "inertia-moments", "exact-table", "double", 1e-9,
        Text::tr(
            "Reports print six digits, and balanced layouts must give zero as a difference of "
            "large forces: nine digits. The exact form needs one square root; a series of the "
            "same cost has three digits at λ = 0.5 and none near locking. The sines of the nodes "
            "are stored: every cylinder and turn needs them.")};
    definition.methods = {
        {{"series",
          Text::tr("series in λ"),
          Text::tr("the terms left out are of the order (λ(1 + K))^2n: three digits at λ "
                   "= 0.5 with 4 terms, and no convergence at locking"),
          {{Text::tr("2 terms"), 2},
           {Text::tr("3 terms"), 3},
           {Text::tr("4 terms"), 4},
           counted(Text::tr("%1 terms"), 6),
           counted(Text::tr("%1 terms"), 10)}},
         prepare_series},
        {{"exact", Text::tr("exact"),
          Text::tr("in float the angle itself has seven digits; near locking the error "
                   "grows as the rounding divided by 1 − λ(1 + K)"),
          precision},
         [](const SliderCrank<double>& mechanism, double wide) {
             return wide > 0.0 ? prepare_exact<double>(mechanism) : prepare_exact<float>(mechanism);
         }},
        {{"exact-table", Text::tr("exact, sines kept"),
          Text::tr("near locking the error grows as the rounding divided by 1 − λ(1 + K): nine "
                   "digits remain at 1 − λ(1 + K) = 10⁻⁶"),
          precision},
         [](const SliderCrank<double>& mechanism, double wide) {
             return wide > 0.0 ? prepare_table<double>(mechanism) : prepare_table<float>(mechanism);
         }},
    };
    definition.sweeps = slider_crank_sweeps(1e-6, 1e-6);
    definition.reference = reference;
    return make_kernel(std::move(definition));
}

}  // namespace ravnoves::methods
