#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

/// One-step methods for φ̈ = f(φ, φ̇) that Boost.Odeint lacks. f is called as f(angle, speed).
namespace ravnoves {

struct TurnState {
    double angle = 0.0;  ///< rad
    double speed = 0.0;  ///< rad/s
};

/// Butcher's table of an implicit method of S stages.
template <std::size_t S>
struct ImplicitTable {
    std::array<std::array<double, S>, S> a;
    std::array<double, S> b;
};

/// Order 2, symplectic.
inline constexpr ImplicitTable<1> implicit_midpoint{{{{0.5}}}, {1.0}};

namespace detail {
inline constexpr double root_15 = 3.872983346207416885;
inline constexpr double root_6 = 2.449489742783178098;
}  // namespace detail

/// Gauss's collocation of order 6, symplectic.
inline constexpr ImplicitTable<3> gauss_6{
    {{{5.0 / 36.0, 2.0 / 9.0 - detail::root_15 / 15.0, 5.0 / 36.0 - detail::root_15 / 30.0},
      {5.0 / 36.0 + detail::root_15 / 24.0, 2.0 / 9.0, 5.0 / 36.0 - detail::root_15 / 24.0},
      {5.0 / 36.0 + detail::root_15 / 30.0, 2.0 / 9.0 + detail::root_15 / 15.0, 5.0 / 36.0}}},
    {5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0}};

/// Radau IIA of order 5, which damps what is stiff.
inline constexpr ImplicitTable<3> radau_5{
    {{{(88.0 - 7.0 * detail::root_6) / 360.0, (296.0 - 169.0 * detail::root_6) / 1800.0,
       (-2.0 + 3.0 * detail::root_6) / 225.0},
      {(296.0 + 169.0 * detail::root_6) / 1800.0, (88.0 + 7.0 * detail::root_6) / 360.0,
       (-2.0 - 3.0 * detail::root_6) / 225.0},
      {(16.0 - detail::root_6) / 36.0, (16.0 + detail::root_6) / 36.0, 1.0 / 9.0}}},
    {(16.0 - detail::root_6) / 36.0, (16.0 + detail::root_6) / 36.0, 1.0 / 9.0}};

/// A step of an implicit method. The stages are found by fixed-point iteration down to rounding: a
/// motion is not stiff, and what is left over would spoil what a symplectic method is for.
/// @param rates  accelerations at the last step's stages on entry (any guess will do), at this
///               one's on return
template <std::size_t S, typename Acceleration>
void implicit_step(const ImplicitTable<S>& table, const Acceleration& f, double h, TurnState& x,
                   std::array<double, S>& rates) {
    std::array<double, S> speed{};
    std::array<double, S> last{};
    constexpr int most_passes = 60;
    for (int pass = 0; pass < most_passes; ++pass) {
        double change = 0.0;
        for (std::size_t i = 0; i < S; ++i) {
            speed[i] = x.speed;
            for (std::size_t j = 0; j < S; ++j) {
                speed[i] += h * table.a[i][j] * rates[j];
            }
            change = std::max(change, std::abs(speed[i] - last[i]));
        }
        for (std::size_t i = 0; i < S; ++i) {
            double angle = x.angle;
            for (std::size_t j = 0; j < S; ++j) {
                angle += h * table.a[i][j] * speed[j];
            }
            rates[i] = f(angle, speed[i]);
        }
        last = speed;
        constexpr double rounding = 4e-16;
        if (pass > 0 && !(change > rounding * std::abs(speed[0]))) {
            break;
        }
    }
    for (std::size_t j = 0; j < S; ++j) {
        x.angle += h * table.b[j] * speed[j];
        x.speed += h * table.b[j] * rates[j];
    }
}

/// The method of order 8 of Dormand and Prince with error estimates of orders 5 and 3 and step
/// control, DOP853 of [hairer-norsett-wanner].
class Dop853 {
  public:
    /// @param tolerance  of a step: rad, and part of `speed`
    /// @param speed      a usual one, rad/s, > 0
    /// @param step       the first one tried, s
    Dop853(double tolerance, double speed, double step)
        : tolerance_(tolerance), speed_tolerance_(tolerance * speed), step_(step) {}

    /// Brings the state from one time to a later one, on which the last step is made to end.
    /// @return false where steps shrink to nothing, are too many or a value is not finite
    template <typename Acceleration>
    bool advance(const Acceleration& f, double seconds, TurnState& x) {
        double done = 0.0;
        constexpr int most_steps = 100'000;
        for (int i = 0; done < seconds; ++i) {
            if (i == most_steps) {
                return false;
            }
            const bool last = done + step_ >= seconds;
            const double h = last ? seconds - done : step_;
            TurnState next = x;
            const double error = attempt(f, h, next);
            if (!std::isfinite(error)) {
                return false;
            }
            const double factor =
                std::clamp(0.9 * std::pow(std::max(error, 1e-30), -0.125), 1.0 / 3.0, 6.0);
            if (error <= 1.0) {
                x = next;
                done = last ? seconds : done + h;
                step_ = last ? std::max(step_, h * factor) : h * factor;
            } else {
                step_ = h * factor;
            }
        }
        return true;
    }

  private:
    static constexpr std::size_t stages = 12;
    static constexpr double a[stages][stages - 1] = {
        {},
        {5.26001519587677318785587544488e-2},
        {1.97250569845378994544595329183e-2, 5.91751709536136983633785987549e-2},
        {2.95875854768068491816892993775e-2, 0.0, 8.87627564304205475450678981324e-2},
        {2.41365134159266685502369798665e-1, 0.0, -8.84549479328286085344864962717e-1,
         9.24834003261792003115737966543e-1},
        {3.7037037037037037037037037037e-2, 0.0, 0.0, 1.70828608729473871279604482173e-1,
         1.25467687566822425016691814123e-1},
        {3.7109375e-2, 0.0, 0.0, 1.70252211019544039314978060272e-1,
         6.02165389804559606850219397283e-2, -1.7578125e-2},
        {3.70920001185047927108779319836e-2, 0.0, 0.0, 1.70383925712239993810214054705e-1,
         1.07262030446373284651809199168e-1, -1.53194377486244017527936158236e-2,
         8.27378916381402288758473766002e-3},
        {6.24110958716075717114429577812e-1, 0.0, 0.0, -3.36089262944694129406857109825,
         -8.68219346841726006818189891453e-1, 2.75920996994467083049415600797e1,
         2.01540675504778934086186788979e1, -4.34898841810699588477366255144e1},
        {4.77662536438264365890433908527e-1, 0.0, 0.0, -2.48811461997166764192642586468,
         -5.90290826836842996371446475743e-1, 2.12300514481811942347288949897e1,
         1.52792336328824235832596922938e1, -3.32882109689848629194453265587e1,
         -2.03312017085086261358222928593e-2},
        {-9.3714243008598732571704021658e-1, 0.0, 0.0, 5.18637242884406370830023853209,
         1.09143734899672957818500254654, -8.14978701074692612513997267357,
         -1.85200656599969598641566180701e1, 2.27394870993505042818970056734e1,
         2.49360555267965238987089396762, -3.0467644718982195003823669022},
        {2.27331014751653820792359768449, 0.0, 0.0, -1.05344954667372501984066689879e1,
         -2.00087205822486249909675718444, -1.79589318631187989172765950534e1,
         2.79488845294199600508499808837e1, -2.85899827713502369474065508674,
         -8.87285693353062954433549289258, 1.23605671757943030647266201528e1,
         6.43392746015763530355970484046e-1}};
    static constexpr std::array<double, stages> b = {5.42937341165687622380535766363e-2,
                                                     0.0,
                                                     0.0,
                                                     0.0,
                                                     0.0,
                                                     4.45031289275240888144113950566,
                                                     1.89151789931450038304281599044,
                                                     -5.8012039600105847814672114227,
                                                     3.1116436695781989440891606237e-1,
                                                     -1.52160949662516078556178806805e-1,
                                                     2.01365400804030348374776537501e-1,
                                                     4.47106157277725905176885569043e-2};
    static constexpr std::array<double, stages> error_5 = {0.1312004499419488073250102996e-1,
                                                           0.0,
                                                           0.0,
                                                           0.0,
                                                           0.0,
                                                           -0.1225156446376204440720569753e1,
                                                           -0.4957589496572501915214079952,
                                                           0.1664377182454986536961530415e1,
                                                           -0.3503288487499736816886487290,
                                                           0.3341791187130174790297318841,
                                                           0.8192320648511571246570742613e-1,
                                                           -0.2235530786388629525884427845e-1};
    /// The first, ninth and twelfth weight of the method of order 3.
    static constexpr double order_3[] = {0.244094488188976377952755905512,
                                         0.733846688281611857341361741547,
                                         0.220588235294117647058823529412e-1};

    /// @return the error against the tolerance
    template <typename Acceleration>
    double attempt(const Acceleration& f, double h, TurnState& x) const {
        std::array<double, stages> angle_rate{};
        std::array<double, stages> speed_rate{};
        for (std::size_t i = 0; i < stages; ++i) {
            TurnState at = x;
            for (std::size_t j = 0; j < i; ++j) {
                at.angle += h * a[i][j] * angle_rate[j];
                at.speed += h * a[i][j] * speed_rate[j];
            }
            angle_rate[i] = at.speed;
            speed_rate[i] = f(at.angle, at.speed);
        }
        double sum_5 = 0.0;
        double sum_3 = 0.0;
        const auto take = [&](const std::array<double, stages>& rate, double scale, double& to) {
            double step = 0.0;
            double fifth = 0.0;
            for (std::size_t i = 0; i < stages; ++i) {
                step += b[i] * rate[i];
                fifth += error_5[i] * rate[i];
            }
            const double third =
                step - order_3[0] * rate[0] - order_3[1] * rate[8] - order_3[2] * rate[11];
            sum_5 += (fifth / scale) * (fifth / scale);
            sum_3 += (third / scale) * (third / scale);
            to += h * step;
        };
        take(angle_rate, tolerance_, x.angle);
        take(speed_rate, speed_tolerance_, x.speed);
        const double both = sum_5 + 0.01 * sum_3;
        return both > 0.0 ? h * sum_5 / std::sqrt(2.0 * both) : both;
    }

    double tolerance_;
    double speed_tolerance_;
    double step_;
};

}  // namespace ravnoves
