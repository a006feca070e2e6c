#include "elastic-hinge/model/guide_picture.h"

#include <algorithm>
#include <cmath>

#include "numerics/units.h"

namespace ravnoves {

using elastic_hinge::GuidePoint;
using elastic_hinge::PlanePoint;

void GuidePicture::Path::add(double radius, double angle) {
    x.push_back(radius * std::cos(angle) / units::mm);
    y.push_back(radius * std::sin(angle) / units::mm);
}

double GuidePicture::Path::reach() const {
    double maximum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double radius = std::hypot(x[i], y[i]);
        maximum = std::isfinite(radius) ? std::max(maximum, radius) : maximum;
    }
    return maximum;
}

const std::vector<double>& GuidePicture::radii(Branch branch) const {
    return branch == Branch::compressed ? guide_.radius_compressed : guide_.radius_stretched;
}

double GuidePicture::start(Branch branch) const {
    return guide_.shape ? guide_.shape->spring().start_radius(branch) : 0.0;
}

GuidePicture::Path GuidePicture::circle(Branch branch) const {
    constexpr int steps = 120;
    Path path;
    for (int i = 0; i <= steps && !guide_.polar_angle.empty() && start(branch) > 0.0; ++i) {
        path.add(start(branch), two_pi * i / steps);
    }
    return path;
}

GuidePicture::Path GuidePicture::path(Branch branch) const {
    Path path;
    const std::vector<double>& radius = radii(branch);
    for (std::size_t i = 0; i < radius.size(); ++i) {
        path.add(drawn(radius[i], start(branch)), guide_.polar_angle[i]);
    }
    return path;
}

GuidePicture::Path GuidePicture::profile(double roller_radius) const {
    constexpr int steps = 360;
    Path path;
    const double offset = guide_.branch == Branch::compressed ? roller_radius : -roller_radius;
    for (int i = 0; i <= steps && guide_.feasible && roller_radius > 0.0; ++i) {
        const PlanePoint p = elastic_hinge::offset_point(
            guide_.shape->at(guide_.branch, two_pi * i / steps), offset);
        path.add(drawn(std::hypot(p.x, p.y), start(guide_.branch) + offset), std::atan2(p.y, p.x));
    }
    return path;
}

std::optional<PlanePoint> GuidePicture::centre(Branch branch, double phi) const {
    if (!guide_.shape) {
        return std::nullopt;
    }
    const GuidePoint point = guide_.shape->at(branch, phi);
    const double far = drawn(point.radius, start(branch)) / units::mm;
    if (!std::isfinite(far) || !(point.radius > 0.0)) {
        return std::nullopt;
    }
    return PlanePoint{far * std::cos(point.angle), far * std::sin(point.angle)};
}

std::vector<double> GuidePicture::rise(Branch branch, const Unit& unit) const {
    std::vector<double> rise = radii(branch);
    for (double& value : rise) {
        value = (value - start(branch)) / unit;
    }
    return rise;
}

double GuidePicture::maxRise() const {
    double maximum = 0.0;
    for (const Branch branch : {Branch::compressed, Branch::stretched}) {
        for (const double value : rise(branch, units::metre)) {
            maximum = std::isfinite(value) ? std::max(maximum, std::abs(value)) : maximum;
        }
    }
    return maximum;
}

std::vector<std::pair<double, double>> GuidePicture::gaps(const std::vector<double>& angles) const {
    std::vector<std::pair<double, double>> gaps;
    for (std::size_t i = 0; i < guide_.radius_stretched.size(); ++i) {
        if (std::isfinite(guide_.radius_stretched[i])) {
            continue;
        }
        if (gaps.empty() || gaps.back().second < angles[i - 1]) {
            gaps.emplace_back(angles[i], angles[i]);
        }
        gaps.back().second = angles[i];
    }
    return gaps;
}

}  // namespace ravnoves
