#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "elastic-hinge/guide.h"

namespace ravnoves {

/// A guide as its picture shows it: in mm, with the relief enlarged about the circles of ρ(0).
class GuidePicture {
  public:
    using Branch = elastic_hinge::Branch;

    struct Path {
        std::vector<double> x;  ///< mm
        std::vector<double> y;

        void add(double radius, double angle);  ///< m, rad
        double reach() const;  ///< maximum distance from the centre, mm
    };

    /// @param guide  must outlive the picture
    GuidePicture(const elastic_hinge::Guide& guide, double exaggeration)
        : guide_(guide), exaggeration_(exaggeration) {}

    /// The circle of ρ(0); empty where there is no guide.
    Path circle(Branch branch) const;
    Path path(Branch branch) const;
    /// What the roller touches, of the design's branch; empty for a roller without size.
    Path profile(double roller_radius) const;
    /// The roller's centre at a crank angle (rad), mm.
    std::optional<elastic_hinge::PlanePoint> centre(Branch branch, double phi) const;
    /// ρ − ρ(0) over the turn.
    std::vector<double> rise(Branch branch, const Unit& unit) const;
    /// Its maximum on both branches, m.
    double maxRise() const;
    /// Where the guide does not exist, as stretches of the angles.
    std::vector<std::pair<double, double>> gaps(const std::vector<double>& angles) const;

  private:
    const std::vector<double>& radii(Branch branch) const;
    double start(Branch branch) const;
    double drawn(double radius, double start) const {
        return start + exaggeration_ * (radius - start);
    }

    const elastic_hinge::Guide& guide_;
    double exaggeration_;
};

}  // namespace ravnoves
