#include "inertia-moments/rods.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numeric>

#include "case-file/input_error.h"
#include "inertia-moments/fields.h"
#include "numerics/angle.h"
#include "numerics/maximum.h"

namespace ravnoves::inertia_moments {

namespace {

/// Angles that differ by less are the same, rad: what rounding in a table leaves.
constexpr double same_angle = 1e-6;

bool same_direction(double a, double b) {
    return std::abs(std::remainder(a - b, two_pi)) < same_angle;
}

bool shares_pin(const Throw& pin, const Cylinder& cylinder, std::span<const Cylinder> all,
                double crank_radius) {
    if (!same_direction(pin.crankpin_angle, cylinder.crankpin_angle)) {
        return false;
    }
    bool near = false;
    for (const std::size_t i : pin.cylinders) {
        if (same_direction(all[i].bank_angle, cylinder.bank_angle)) {
            return false;
        }
        const double distance = std::abs(all[i].axial_position - cylinder.axial_position);
        near = near || distance < crank_radius * (1.0 - 1e-9);
    }
    return near;
}

constexpr int scan_samples = 90;  ///< of a turn, when an extremum is looked for

/// The angle in −π…π where a periodic function has its maximum: the best of a scan, then the root
/// of the slope between its neighbours.
template <typename Function, typename Slope>
double angle_of_maximum(const Function& f, const Slope& slope) {
    constexpr double step = two_pi / scan_samples;
    double best = -pi;
    double maximum = f(best);
    for (int i = 1; i < scan_samples; ++i) {
        const double angle = step * i - pi;
        if (const double value = f(angle); value > maximum) {
            maximum = value;
            best = angle;
        }
    }
    if (!(slope(best - step) > 0.0 && slope(best + step) < 0.0)) {
        return best;
    }
    std::uintmax_t steps = 100;
    const auto [before, after] = boost::math::tools::toms748_solve(
        slope, best - step, best + step, boost::math::tools::eps_tolerance<double>(), steps);
    return 0.5 * (before + after);
}

/// The throw of a cylinder.
const Throw& throw_of(std::span<const Throw> throws, std::size_t cylinder) {
    return *std::find_if(throws.begin(), throws.end(), [&](const Throw& pin) {
        return std::find(pin.cylinders.begin(), pin.cylinders.end(), cylinder) !=
               pin.cylinders.end();
    });
}

/// The cylinder on whose rod an articulated one hangs.
std::size_t master_of(std::span<const Cylinder> cylinders, const Throw& pin, std::size_t own) {
    std::vector<std::size_t> plain;  // on the same pin
    for (const std::size_t i : pin.cylinders) {
        if (!cylinders[i].articulated) {
            plain.push_back(i);
        }
    }
    const int number = cylinders[own].articulated->master;
    const std::string pointer = rod_pointer(own, field::master);
    if (number == 0) {
        if (plain.size() != 1) {
            throw InputError(pointer,
                             plain.empty()
                                 ? Message(Text::tr("must have a master rod: all rods on the "
                                                    "crankpin of cylinder %1 are articulated"),
                                           own + 1)
                                 : Message(Text::tr("must be given: any of the rods of cylinders "
                                                    "%1 on this crankpin could be the master"),
                                           numbers_of(plain)));
        }
        return plain.front();
    }
    const auto master = static_cast<std::size_t>(number) - 1;
    const auto reject = [&](const Message& why) {
        throw InputError(pointer, why, Number{static_cast<double>(number)});
    };
    if (master >= cylinders.size()) {
        reject({Text::tr("must be a cylinder of the table, 1 to %1"), cylinders.size()});
    }
    if (cylinders[master].articulated) {
        reject(
            {Text::tr("must be a rod on the crankpin; the rod of cylinder %1 is articulated too"),
             number});
    }
    if (std::find(plain.begin(), plain.end(), master) == plain.end()) {
        reject(
            {Text::tr("must run on the same crankpin (same angle, another direction, less than "
                      "the crank radius away); cylinder %1 runs on the crankpin of cylinders %2"),
             own + 1, numbers_of(pin.cylinders)});
    }
    return master;
}

}  // namespace

std::string numbers_of(std::span<const std::size_t> cylinders) {
    std::string text;
    for (const std::size_t i : cylinders) {
        text += (text.empty() ? "" : ", ") + std::to_string(i + 1);
    }
    return text;
}

std::vector<Throw> crank_throws(std::span<const Cylinder> cylinders, double crank_radius) {
    std::vector<std::size_t> order(cylinders.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto front_first = [&](std::size_t a, std::size_t b) {
        return cylinders[a].axial_position > cylinders[b].axial_position;
    };
    // Masters that are named first, then the rods that name them: what else is in the direction
    // of one of these has a crankpin of its own.
    const auto names = [&](const Cylinder& rod, std::size_t i) {
        return rod.articulated && static_cast<std::size_t>(rod.articulated->master) == i + 1;
    };
    const auto rank = [&](std::size_t i) {
        if (cylinders[i].articulated) {
            return cylinders[i].articulated->master > 0 ? 1 : 2;
        }
        return std::any_of(cylinders.begin(), cylinders.end(),
                           [&](const Cylinder& rod) { return names(rod, i); })
                   ? 0
                   : 2;
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return rank(a) != rank(b) ? rank(a) < rank(b) : front_first(a, b);
    });
    std::vector<Throw> throws;
    for (const std::size_t i : order) {
        const Cylinder& cylinder = cylinders[i];
        const auto is_own = [&](const Throw& each) {
            return shares_pin(each, cylinder, cylinders, crank_radius);
        };
        const auto is_masters = [&](const Throw& each) {
            return is_own(each) && std::any_of(each.cylinders.begin(), each.cylinders.end(),
                                               [&](std::size_t on) { return names(cylinder, on); });
        };
        // The throw behind the others is the nearest.
        auto pin = std::find_if(throws.rbegin(), throws.rend(), is_masters);
        if (pin == throws.rend()) {
            pin = std::find_if(throws.rbegin(), throws.rend(), is_own);
        }
        Throw& own = pin != throws.rend()
                         ? *pin
                         : throws.emplace_back(Throw{{}, 0.0, cylinder.crankpin_angle});
        own.cylinders.push_back(i);
    }
    for (Throw& each : throws) {
        std::sort(each.cylinders.begin(), each.cylinders.end());
        std::stable_sort(each.cylinders.begin(), each.cylinders.end(), front_first);
        for (const std::size_t i : each.cylinders) {
            each.position +=
                cylinders[i].axial_position / static_cast<double>(each.cylinders.size());
        }
    }
    std::stable_sort(throws.begin(), throws.end(), [&](const Throw& a, const Throw& b) {
        return front_first(a.cylinders.front(), b.cylinders.front());
    });
    return throws;
}

std::map<std::size_t, const Throw*> kinds_of_throw(std::span<const Throw> throws) {
    std::map<std::size_t, const Throw*> kinds;
    for (const Throw& each : throws) {
        kinds.try_emplace(each.cylinders.size(), &each);
    }
    return kinds;
}

std::string rod_pointer(std::size_t cylinder, const Field& field) {
    return "/input/cylinders/" + std::to_string(cylinder) + "/" +
           std::string(field::articulated.key) + "/" + std::string(field.key);
}

ArticulatedMotion ArticulatedCrank::at(double sin_theta, double cos_theta) const {
    if (is_plain()) {
        return {plain().at(sin_theta, cos_theta), {}, {}, {}};
    }
    const RodSwing<double> swing =
        master.rod_at(sin_theta * master_lead.real() + cos_theta * master_lead.imag(),
                      cos_theta * master_lead.real() - sin_theta * master_lead.imag());
    ArticulatedMotion motion;
    motion.arm = knuckle * std::polar(1.0, swing.psi);
    const std::complex<double> turned(-motion.arm.imag(), motion.arm.real());
    motion.darm = swing.dpsi * turned;
    motion.d2arm = swing.d2psi * turned - swing.dpsi * swing.dpsi * motion.arm;
    // The knuckle pin across the axis, and the articulated rod's length along it.
    const double y = sin_theta + motion.arm.imag() - offset;
    const double dy = cos_theta + motion.darm.imag();
    const double d2y = -sin_theta + motion.d2arm.imag();
    // Two roots: the product of two long rods could overflow.
    const double root = std::sqrt(rod_length - y) * std::sqrt(rod_length + y);
    const double t = y / root;
    motion.piston = {cos_theta + motion.arm.real() + root, -sin_theta + motion.darm.real() - t * dy,
                     -cos_theta + motion.d2arm.real() - dy * dy * (1.0 + t * t) / root - t * d2y};
    return motion;
}

ArticulatedMotion ArticulatedCrank::two_term_at(double sin_theta, double cos_theta) const {
    const double lambda = master.lambda();
    const double sin_master = sin_theta * master_lead.real() + cos_theta * master_lead.imag();
    const double cos_master = cos_theta * master_lead.real() - sin_theta * master_lead.imag();
    const double psi = lambda * (master.offset - sin_master);
    const double dpsi = -lambda * cos_master;
    const double d2psi = lambda * sin_master;
    ArticulatedMotion motion;
    motion.arm = knuckle * std::complex<double>(1.0 - 0.5 * psi * psi, psi);
    motion.darm = knuckle * std::complex<double>(-psi * dpsi, dpsi);
    motion.d2arm = knuckle * std::complex<double>(-dpsi * dpsi - psi * d2psi, d2psi);
    // Across the axis the square of ψ would be of the third order.
    const double y = sin_theta + knuckle.imag() + knuckle.real() * psi - offset;
    const double dy = cos_theta + knuckle.real() * dpsi;
    const double d2y = -sin_theta + knuckle.real() * d2psi;
    motion.piston = {cos_theta + motion.arm.real() + rod_length - 0.5 * y * y / rod_length,
                     -sin_theta + motion.darm.real() - y * dy / rod_length,
                     -cos_theta + motion.d2arm.real() - (dy * dy + y * d2y) / rod_length};
    return motion;
}

double ArticulatedCrank::dead_centre(double side) const {
    return angle_of_maximum([&](double theta) { return side * at(theta).piston.s; },
                            [&](double theta) { return side * at(theta).piston.ds; });
}

double ArticulatedCrank::top_dead_centre() const {
    return is_plain() ? plain().top_dead_centre() : dead_centre(1.0);
}

double ArticulatedCrank::bottom_dead_centre() const {
    return is_plain() ? plain().bottom_dead_centre() : wrap_turn(dead_centre(-1.0));
}

double ArticulatedCrank::stroke() const {
    return is_plain() ? plain().stroke()
                      : at(top_dead_centre()).piston.s - at(bottom_dead_centre()).piston.s;
}

double ArticulatedCrank::reach() const {
    const auto across = [&](double theta) {
        return std::abs(std::sin(theta) + at(theta).arm.imag() - offset);
    };
    constexpr double step = two_pi / scan_samples;
    Maximum farthest;
    for (int i = 0; i < scan_samples; ++i) {
        farthest.take(across(step * i), step * i);
    }
    farthest.sharpen(across, step);
    return farthest.value;
}

void complete_rods(std::vector<Cylinder>& cylinders, std::span<const Throw> throws,
                   double rod_length) {
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
        Cylinder& cylinder = cylinders[i];
        if (!cylinder.articulated) {
            continue;
        }
        ArticulatedRod& rod = *cylinder.articulated;
        const std::size_t number = master_of(cylinders, throw_of(throws, i), i);
        const Cylinder& master = cylinders[number];
        if (!(rod.knuckle_radius < rod_length)) {
            throw InputError(rod_pointer(i, field::knuckle_radius),
                             {Text::tr("must be less than %1, the length of the master rod"),
                              Number{.value = rod_length / units::mm, .digits = 6}},
                             Number{from_si(field::knuckle_radius, rod.knuckle_radius)});
        }
        rod.master = static_cast<int>(number) + 1;
        rod.knuckle_angle = rod.knuckle_angle.value_or(cylinder.bank_angle - master.bank_angle);
        rod.rod_length = rod.rod_length.value_or(rod_length - rod.knuckle_radius);
        cylinder.crankpin_angle = master.crankpin_angle;
    }
}

void hang_on_masters(std::vector<Cylinder>& cylinders, double crank_radius) {
    for (const Throw& pin : crank_throws(cylinders, crank_radius)) {
        const std::size_t master = *std::min_element(pin.cylinders.begin(), pin.cylinders.end());
        for (const std::size_t i : pin.cylinders) {
            cylinders[i].articulated.reset();
            if (i != master) {
                ArticulatedRod& rod = cylinders[i].articulated.emplace();
                rod.knuckle_radius =
                    rounded(usual_knuckle_share * crank_radius, field::knuckle_radius, 3);
                rod.master = static_cast<int>(master) + 1;
            }
        }
    }
}

}  // namespace ravnoves::inertia_moments
