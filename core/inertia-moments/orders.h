#pragma once

#include <array>
#include <optional>
#include <vector>

#include "inertia-moments/engine.h"
#include "numerics/harmonics.h"

namespace ravnoves::inertia_moments {

/// One order of a vector in the front view as two rotating vectors:
/// x + iy = A e^{ikφ} + B e^{−ikφ}. Its tip runs round an ellipse.
struct RotatingPair {
    Complex forward;   ///< A
    Complex backward;  ///< B

    /// Order k of u·f where f = Re(c e^{ikφ}).
    static RotatingPair of(Complex direction, Complex c) {
        return {0.5 * direction * c, 0.5 * direction * std::conj(c)};
    }
    RotatingPair& operator+=(const RotatingPair& other) {
        forward += other.forward;
        backward += other.backward;
        return *this;
    }
    friend RotatingPair operator-(const RotatingPair& a, const RotatingPair& b) {
        return {a.forward - b.forward, a.backward - b.backward};
    }
    /// x as cos·cos kφ + sin·sin kφ.
    Harmonic<double> horizontal() const {
        return {(forward + backward).real(), (backward - forward).imag()};
    }
    /// y likewise.
    Harmonic<double> vertical() const {
        return {(forward + backward).imag(), (forward - backward).real()};
    }
    /// The vector where e^{ikφ} is `turn`.
    Complex along(Complex turn) const { return forward * turn + backward * std::conj(turn); }
    /// The vector at kφ (rad).
    Complex at(double angle) const { return along(std::polar(1.0, angle)); }
    double max() const { return std::abs(forward) + std::abs(backward); }  ///< long half axis
};

inline double amplitude(const Harmonic<double>& h) {
    return std::hypot(h.cos, h.sin);
}
/// φ·k at which cos·cos kφ + sin·sin kφ is largest, rad in (−π, π].
inline double phase(const Harmonic<double>& h) {
    return std::atan2(h.sin, h.cos);
}

/// Amplitudes under this share of their scale count as nothing, and their directions too.
inline constexpr double zero_share = 1e-9;

/// Everything of one order. The axial force is 0 in every planar mechanism; the five other
/// components follow.
struct EngineOrder {
    int order = 0;        ///< k
    RotatingPair force;   ///< N
    RotatingPair moment;  ///< (M_x, M_y) about the reference position, N·m
    /// Roll moment of the inertia forces about the crank axis: −Σ e F of the offset axes and the
    /// rods' couples. Counter-clockwise, N·m
    Harmonic<double> inertia_roll;
    /// Reaction of the inertia torque on the engine, −Σ F ds/dφ, N·m: the torque leaves through the
    /// shaft, its reaction remains.
    Harmonic<double> reaction_torque;
    /// Amplitudes that the cylinders would reach all in phase, or order_accuracy / zero_share of
    /// m R ω² where that is more (orders that are 0 but for rounding): what counts as zero is
    /// measured against these.
    double force_scale = 0.0;   ///< N
    double moment_scale = 0.0;  ///< N·m
    double roll_scale = 0.0;    ///< N·m

    /// M_z of this order on the engine, N·m.
    Harmonic<double> roll() const {
        return {inertia_roll.cos + reaction_torque.cos, inertia_roll.sin + reaction_torque.sin};
    }
};

/// The orders of an engine's reciprocating parts (rotating masses are apart).
struct EngineOrders {
    std::vector<EngineOrder> orders;  ///< [k − 1] is order k

    const EngineOrder& order(int k) const& { return orders[static_cast<std::size_t>(k) - 1]; }
    /// Of orders that end with the statement a copy.
    EngineOrder order(int k) && { return orders[static_cast<std::size_t>(k) - 1]; }
};

/// Orders of what the moving parts of one cylinder do, by its own crank angle θ, in units of m_j R
/// ω² (forces) and m_j R² ω² (moments). [k] is order k; [0] the mean.
struct CylinderOrders {
    std::vector<Harmonic<double>> along;   ///< force along the cylinder's axis
    std::vector<Harmonic<double>> across;  ///< counter-clockwise; empty without a mass at a knuckle
    std::vector<Harmonic<double>> roll;    ///< moment about the crank axis
    std::vector<Harmonic<double>> torque;  ///< on the crank
};

/// The moving parts of a cylinder, in units of m_j and R.
struct CylinderParts {
    ArticulatedCrank crank;
    double knuckle = 0.0;  ///< mass at the knuckle pin instead of the crankpin
    double couple = 0.0;   ///< inertia of a rod on the crankpin above its two masses'
};

/// Orders of a cylinder by a discrete Fourier transform.
///
/// Forces and moments are what momentum, spin and energy lose by θ: −m a of piston and knuckle pin,
/// its moment, its torque by virtual work, F ds/dφ; the same of the rod's couple with its angle ψ.
/// The samples are of those: they are finite up to locking, where s″ is not.
/// @param form  two_term: of the motion by two_term_at()
/// @param transform  its length on the crankpin by transform_length(crank.harmonic_decay(), …)
CylinderOrders cylinder_orders(const CylinderParts& parts, DesignBasis form, int max_order,
                               const UniformTransform<double>& transform);

/// The paper's two-term force cos θ + Kλ sin θ + λ cos 2θ, with the torque that belongs to it: the
/// product with its own integral (orders 1…4, mean 0). The rod's angle to the same order is
/// ψ = λ(K − sin θ).
CylinderOrders two_term_cylinder_orders(double lambda, double relative_offset, double couple);

/// Exact orders 1…max_order of forces and moments. Where rods are articulated, the transform grows
/// until twice its samples change nothing.
/// @throws InputError where an articulated rod is too near locking for that
EngineOrders exact_orders(const Engine& engine, int max_order = highest_order);

/// The paper's two-term form, orders 1…4: forces and moments have 1 and 2, the torque 1…4. The
/// paper has none for an articulated rod; ArticulatedCrank::two_term_at() becomes the paper's as
/// the knuckle pin nears the crankpin.
EngineOrders two_term_orders(const Engine& engine);

/// Forces and moments over one turn.
struct WrenchCurves {
    /// @param angles  rad
    explicit WrenchCurves(std::vector<double> angles = {});
    void add(std::size_t i, Complex force, Complex moment, double inertia, double reaction);

    std::vector<double> crank_angle;                           ///< rad, 0…2π
    std::vector<double> force_x, force_y, moment_x, moment_y;  ///< N, N, N·m, N·m
    std::vector<double> inertia_roll, reaction_torque, roll;   ///< N·m
};

/// Exact curves of the reciprocating parts, without orders.
/// @param angles  rad, 0…2π
WrenchCurves exact_curves(const Engine& engine, std::vector<double> angles);

/// The exact curves, and beside them the curves of a sum of orders.
WrenchCurves with_orders(WrenchCurves curves, const EngineOrders& orders);

/// Of an order: force and moment, each horizontal and vertical, and the roll moment.
std::array<Harmonic<double>, 5> components(const EngineOrder& order);

/// How far the two-term form is from the exact one, in one component of one order.
struct Difference {
    int order = 0;
    std::size_t component = 0;  ///< of components()
    double exact = 0.0;         ///< amplitude, N or N·m
    double two_term = 0.0;      ///< amplitude
    double error = 0.0;         ///< amplitude of the difference (a wrong phase counts), N or N·m
    /// error / exact; empty where the exact amplitude is negligible beside the quantity's largest.
    std::optional<double> relative;
    /// error / the quantity's largest amplitude of any order (of a balanced engine: 2 % of what its
    /// cylinders would reach in phase).
    double of_largest = 0.0;
    /// Both are so large that the two-term form is not enough for this component.
    bool warning = false;
};

/// Compares all orders of `exact` component by component; orders that the two-term form does not
/// have count as left out whole.
std::vector<Difference> compare(const EngineOrders& exact, const EngineOrders& two_term);

/// A warning as a sentence: "order 1 force, vertical plane: the two-term form is 12.8 % off".
Message describe(const Difference& difference);

}  // namespace ravnoves::inertia_moments
