#include "balance-shaft/shaft_bending.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

namespace {

using Eigen::Index;

/// The equations lose (L/h)⁴ of their digits, h the shortest element's length.
using Real = long double;
using Matrix4 = Eigen::Matrix<Real, 4, 4>;
using Vector4 = Eigen::Matrix<Real, 4, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

constexpr double most_elements = 24.0;  ///< in a piece that is the whole shaft

/// One element: deflection and slope at both of its ends are its unknowns.
struct Element {
    double length;
    const ShaftPiece* piece;

    Matrix4 stiffness() const {
        const Real h = length;
        Matrix4 k;
        k << 12.0, 6.0 * h, -12.0, 6.0 * h,               //
            6.0 * h, 4.0 * h * h, -6.0 * h, 2.0 * h * h,  //
            -12.0, -6.0 * h, 12.0, -6.0 * h,              //
            6.0 * h, 2.0 * h * h, -6.0 * h, 4.0 * h * h;
        return k * (piece->stiffness / (h * h * h));
    }
    Matrix4 mass() const {
        const Real h = length;
        Matrix4 m;
        m << 156.0, 22.0 * h, 54.0, -13.0 * h,              //
            22.0 * h, 4.0 * h * h, 13.0 * h, -3.0 * h * h,  //
            54.0, 13.0 * h, 156.0, -22.0 * h,               //
            -13.0 * h, -3.0 * h * h, -22.0 * h, 4.0 * h * h;
        return m * (piece->mass * h / 420.0);
    }
    /// Of an even load, N/m.
    Vector4 load(double even) const {
        const Real h = length;
        return even * h / 12.0 * Vector4(6.0, h, 6.0, -h);
    }
};

std::vector<Element> elements_of(const std::vector<ShaftPiece>& pieces) {
    double whole = 0.0;
    for (const ShaftPiece& piece : pieces) {
        whole += piece.length;
    }
    std::vector<Element> elements;
    for (const ShaftPiece& piece : pieces) {
        if (piece.length >= shortest_shaft_piece * whole) {
            // An even number: a node stands in the middle, where most shafts bend most.
            const double pairs = std::ceil(most_elements / 2.0 * piece.length / whole);
            const auto count = static_cast<int>(2.0 * pairs);
            elements.insert(elements.end(), static_cast<std::size_t>(count),
                            Element{piece.length / count, &piece});
        }
    }
    return elements;
}

/// The matrices without the two deflections in the bearings.
class Beam {
  public:
    explicit Beam(std::vector<Element> elements) : elements_(std::move(elements)) {
        const auto size = static_cast<Index>(2 * elements_.size() + 2);
        stiffness_ = Matrix::Zero(size, size);
        mass_ = Matrix::Zero(size, size);
        for (std::size_t i = 0; i < elements_.size(); ++i) {
            const auto at = static_cast<Index>(2 * i);
            stiffness_.block<4, 4>(at, at) += elements_[i].stiffness();
            mass_.block<4, 4>(at, at) += elements_[i].mass();
        }
        free_.push_back(1);
        for (Index i = 2; i < size - 2; ++i) {
            free_.push_back(i);
        }
        free_.push_back(size - 1);
    }

    /// Inverse iteration: the error of the eigenvalue falls by (ω₁/ω₂)⁴ a step, 1/256 for an even
    /// bar.
    double critical_speed() const {
        const Matrix mass = within(mass_);
        const Eigen::LLT<Matrix> factors(within(stiffness_));
        Vector shape = factors.solve(mass.diagonal());
        Real square = 0.0;
        for (int step = 0; step < 200; ++step) {
            const Vector inertia = mass * shape;
            const Vector next = factors.solve(inertia);
            const Real last = square;
            square = next.dot(inertia) / next.dot(mass * next);
            shape = next / next.cwiseAbs().maxCoeff();
            if (!std::isfinite(square) || std::abs(square - last) <= 1e-14 * square) {
                break;
            }
        }
        return static_cast<double>(std::sqrt(square));
    }

    struct Response {
        Vector displacement;          ///< deflections and slopes
        std::vector<Vector4> forces;  ///< at the ends of each element: force, moment, twice
    };
    /// @param load   of a piece, N/m
    /// @param omega2 ω², below the critical speed's
    template <typename Load>
    Response response(const Load& load, Real omega2) const {
        Vector loads = Vector::Zero(stiffness_.rows());
        for (std::size_t i = 0; i < elements_.size(); ++i) {
            loads.segment<4>(static_cast<Index>(2 * i)) +=
                elements_[i].load(load(*elements_[i].piece));
        }
        const Matrix dynamic = stiffness_ - omega2 * mass_;
        Response response;
        response.displacement = Vector::Zero(loads.size());
        const Vector wanted = loads(free_);
        const Eigen::LDLT<Matrix> factors(within(dynamic));
        const Vector found = factors.solve(wanted);
        for (std::size_t i = 0; i < free_.size(); ++i) {
            response.displacement[free_[i]] = found[static_cast<Index>(i)];
        }
        for (std::size_t i = 0; i < elements_.size(); ++i) {
            const Element& element = elements_[i];
            const Vector4 ends = response.displacement.segment<4>(static_cast<Index>(2 * i));
            response.forces.emplace_back((element.stiffness() - omega2 * element.mass()) * ends -
                                         element.load(load(*element.piece)));
        }
        return response;
    }

    const std::vector<Element>& elements() const { return elements_; }

  private:
    Matrix within(const Matrix& whole) const { return whole(free_, free_); }

    std::vector<Element> elements_;
    Matrix stiffness_;
    Matrix mass_;
    std::vector<Index> free_;
};

}  // namespace

ShaftBending shaft_bending(const std::vector<ShaftPiece>& pieces, double angular_speed) {
    const Beam beam(elements_of(pieces));
    ShaftBending bending;
    bending.critical_speed = beam.critical_speed();
    const auto weight =
        beam.response([](const ShaftPiece& piece) { return piece.mass * standard_gravity; }, 0.0);
    const auto largest = [](const Vector& displacement) {
        return static_cast<double>(
            displacement(Eigen::seq(0, Eigen::last, 2)).array().abs().maxCoeff());
    };
    bending.weight_sag = largest(weight.displacement);
    if (!(angular_speed < bending.critical_speed)) {
        return bending;
    }
    const double omega2 = angular_speed * angular_speed;
    const auto whirl = beam.response(
        [omega2](const ShaftPiece& piece) { return piece.mass * piece.eccentricity * omega2; },
        omega2);
    // The weight in the direction of the centrifugal load.
    const Vector together = whirl.displacement.cwiseAbs() + weight.displacement.cwiseAbs();
    bending.deflection = largest(together);
    bending.journal_slope =
        static_cast<double>(std::max(together[1], together[together.size() - 1]));
    const auto sum = [&](std::size_t element, Index force) {
        return static_cast<double>(std::abs(whirl.forces[element][force]) +
                                   std::abs(weight.forces[element][force]));
    };
    const std::size_t last = beam.elements().size() - 1;
    bending.bearing_load = std::max(sum(0, 0), sum(last, 2));
    for (std::size_t i = 0; i <= last; ++i) {
        const ShaftPiece& piece = *beam.elements()[i].piece;
        for (const Index end : {0, 2}) {
            const double bend = sum(i, end + 1) / piece.section_modulus;
            const double shear = 4.0 / 3.0 * sum(i, end) / piece.area;
            bending.bending_stress = std::max(bending.bending_stress, bend);
            bending.combined_stress =
                std::max(bending.combined_stress, std::sqrt(bend * bend + 3.0 * shear * shear));
        }
    }
    return bending;
}

}  // namespace ravnoves::balance_shaft
