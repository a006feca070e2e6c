#include "elastic-hinge/guide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numerics/maximum.h"

namespace ravnoves::elastic_hinge {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

Number number(double si, Unit unit) {
    return {si / unit, unit, 6};
}

Text name_of(Hinge hinge) {
    constexpr Text names[] = {Text::tr("the crank's hinge"),
                              Text::tr("the crank's hinge with the rod's hinge"),
                              Text::tr("the rod's hinge")};
    return names[static_cast<int>(hinge)];
}

/// What a branch of a guide comes to over the turn.
class BranchScan {
  public:
    BranchScan(const GuideShape& shape, Branch branch, double roller)
        : shape_(shape),
          branch_(branch),
          roller_(roller),
          side_(branch == Branch::compressed ? 1.0 : -1.0) {}

    void take(const GuidePoint& point, double phi) {
        const auto values = measure(point);
        if (!std::isfinite(values[steepest]) || !std::isfinite(point.slope)) {
            return;
        }
        for (std::size_t each = 0; each < measures; ++each) {
            maxima_[each].take(values[each], phi);
        }
    }

    /// @param minimum, maximum  radius of the path, m
    /// @param step  of the grid, rad
    BranchSummary finish(double minimum, double maximum, double step) {
        // Without a roller the path is the profile.
        for (std::size_t each = 0; each < (roller_ > 0.0 ? measures : lowest); ++each) {
            maxima_[each].sharpen(
                [&](double phi) { return measure(shape_.at(branch_, phi))[each]; }, step);
        }
        BranchSummary summary;
        summary.exists = true;
        summary.min_radius = minimum;
        summary.max_radius = maximum;
        summary.profile_min_radius = roller_ > 0.0 ? -maxima_[lowest].value : minimum;
        summary.profile_max_radius = roller_ > 0.0 ? maxima_[highest].value : maximum;
        const double max_bent = maxima_[bent].value;
        summary.smallest_curvature_radius = max_bent > 0.0 ? 1.0 / max_bent : maximum;
        if (const double sharpest = maxima_[against_roller].value;
            sharpest > 0.0 && std::isfinite(1.0 / sharpest)) {
            summary.largest_roller_radius = 1.0 / sharpest;
            summary.undercut = roller_ > *summary.largest_roller_radius;
        }
        summary.max_pressure_angle = std::acos(std::min(-maxima_[steepest].value, 1.0));
        return summary;
    }

  private:
    enum Measure { steepest, bent, against_roller, lowest, highest, measures };

    /// What the maximum over the turn is sought of.
    std::array<double, measures> measure(const GuidePoint& point) const {
        const double cosine =  // of the pressure angle
            point.radius / std::sqrt(point.radius * point.radius + point.slope * point.slope);
        const double bend = point.curvature();
        // The profile lies outside a compressed spring's rollers and inside a stretched one's.
        const double profile = roller_ > 0.0
                                   ? std::sqrt(point.radius * point.radius + roller_ * roller_ +
                                               2.0 * side_ * roller_ * point.radius * cosine)
                                   : point.radius;
        return {-cosine, std::abs(bend), -side_ * bend, -profile, profile};
    }

    const GuideShape& shape_;
    Branch branch_;
    double roller_;
    double side_;
    std::array<Maximum, measures> maxima_{
        {{-1.0}, {}, {}, {-std::numeric_limits<double>::max()}, {}}};
};

}  // namespace

Message overlap_note(Hinge hinge, const BranchSummary& branch, double roller_radius) {
    if (!branch.exists || !(roller_radius > branch.min_radius)) {
        return {};
    }
    return {Text::tr("The two rollers overlap (%1): diameter %2, minimum distance of their centres "
                     "%3. Rollers and spring need separate planes."),
            name_of(hinge), number(2.0 * roller_radius, units::mm),
            number(2.0 * branch.min_radius, units::mm)};
}

double guide_radius(const Spring& spring, Branch branch, double q) {
    const double d0 = spring.preload();
    const double change = q == 0.0 ? 0.0 : q / (d0 + std::sqrt(d0 * d0 - q));
    return spring.start_radius(branch) + (branch == Branch::compressed ? change : -change);
}

double GuidePoint::curvature() const {
    const double square = radius * radius + slope * slope;
    return (square + slope * slope - radius * second) / (square * std::sqrt(square));
}

PlanePoint offset_point(const GuidePoint& point, double distance) {
    const double c = std::cos(point.angle);
    const double s = std::sin(point.angle);
    const double length = std::hypot(point.radius, point.slope);
    // Tangent (ρ′ c − ρ s, ρ′ s + ρ c); its outward normal is that turned by −90°.
    const double nx = (point.slope * s + point.radius * c) / length;
    const double ny = (point.radius * s - point.slope * c) / length;
    return {point.radius * c + distance * nx, point.radius * s + distance * ny};
}

GuideShape::GuideShape(std::shared_ptr<const Design> design, Hinge hinge, const Spring& spring,
                       GuideSign sign)
    : design_(std::move(design)), hinge_(hinge), spring_(spring) {
    const bool reversed = sign == GuideSign::as_printed && hinge != Hinge::rod;
    scale_ = (reversed ? -0.5 : 0.5) / spring.stiffness;
    const double preload = spring.preload();
    rounding_ = 8.0 * std::numeric_limits<double>::epsilon() * preload *
                (preload + 0.5 * spring.free_length);
}

std::pair<GuidePoint, GuidePoint> GuideShape::both(const Demand& demand) const {
    const double q = given_out(demand);
    const double d0 = spring_.preload();
    const double square = d0 * d0 - q;
    if (!(square >= -rounding_)) {
        const GuidePoint none{demand.polar_angle, nothing, nothing, nothing};
        return {none, none};
    }
    const double d = std::sqrt(std::max(square, 0.0));
    const double change = q == 0.0 ? 0.0 : q / (d0 + d);  // as in guide_radius()
    double slope = 0.0;
    double second = 0.0;
    const double dsquare = -scale_ * demand.moment;
    const double d2square = -scale_ * demand.dmoment;
    if (dsquare != 0.0 || d2square != 0.0) {
        const double inverse = 1.0 / d;  // infinite where an unloaded spring is to be loaded
        slope = 0.5 * dsquare * inverse;
        second = (0.5 * d2square - slope * slope) * inverse;
    }
    return {
        {demand.polar_angle, spring_.start_radius(Branch::compressed) + change, -slope, -second},
        {demand.polar_angle, spring_.start_radius(Branch::stretched) - change, slope, second}};
}

GuidePoint GuideShape::at(Branch branch, const Demand& demand) const {
    const auto points = both(demand);
    return branch == Branch::compressed ? points.first : points.second;
}

DemandRange GuideShape::given_out() const {
    const DemandRange range = design_->range(hinge_);
    return scale_ > 0.0 ? DemandRange{scale_ * range.min, scale_ * range.max, range.min_angle,
                                      range.max_angle}
                        : DemandRange{scale_ * range.max, scale_ * range.min, range.max_angle,
                                      range.min_angle};
}

namespace {

/// Why there is no guide where the preload is too small.
Message preload_reason(const Guide& guide) {
    // Rounded up so that what is shown suffices.
    const double minimum = std::ceil(guide.minimum_preload / units::mm * 1e4 - 1e-9) / 1e4;
    const Message reason{Text::tr("from a crank angle of %1 the spring stores too little energy "
                                  "(worst at %2): the preload |ℓ₀/2 − ρ₀| is %3, the minimum %4"),
                         number(guide.first_missing_angle, units::degree),
                         number(guide.worst_angle, units::degree), number(guide.preload, units::mm),
                         Number{minimum, units::mm, -4}};
    if (guide.minimum_stiffness && std::isfinite(*guide.minimum_stiffness)) {
        return {Text::tr("%1; with this preload the minimum stiffness is %2"), reason,
                number(*guide.minimum_stiffness * (1.0 + 5e-6), units::kN_per_m)};
    }
    return reason;
}

}  // namespace

Guide make_guide(std::shared_ptr<const Design> design, Hinge hinge,
                 const std::optional<Spring>& spring, const Input& input, bool by_angle) {
    Guide guide;
    guide.hinge = hinge;
    if (!design->has_exact_kinematics()) {
        guide.reason = Text::tr(
            "at λ = 1 the mechanism locks at a crank angle of 90°: no guide "
            "and no motion, only M₁₂ and side force by the series");
        return guide;
    }
    if (!spring) {
        guide.reason = {Text::tr("no spring is given for %1"), name_of(hinge)};
        return guide;
    }
    const auto shape =
        std::make_shared<const GuideShape>(std::move(design), hinge, *spring, input.guide_sign);
    guide.shape = shape;
    guide.branch = spring->branch();
    guide.preload = spring->preload();

    const DemandRange given_out = shape->given_out();
    guide.minimum_preload = std::sqrt(given_out.max);
    guide.worst_angle = given_out.max_angle;
    const double square = guide.preload * guide.preload;
    if (square > 0.0) {
        guide.minimum_stiffness = spring->stiffness * (given_out.max / square);
    }
    const bool exists = given_out.max <= square + shape->rounding();
    const double lowest = std::sqrt(std::max(square - given_out.max, 0.0));
    const double highest = std::sqrt(square - given_out.min);
    const double half_length = 0.5 * spring->free_length;

    // Where it ends is seen angle by angle.
    const std::size_t n = by_angle || !exists ? shape->design().grid().size() : 0;
    const double step = shape->design().grid().angle[1];
    guide.polar_angle.resize(n);
    guide.radius_compressed.resize(n);
    guide.radius_stretched.resize(n);
    BranchScan compressed(*shape, Branch::compressed, input.roller_radius);
    BranchScan stretched(*shape, Branch::stretched, input.roller_radius);
    const bool fits = half_length > highest;  // a compressed spring keeps a length
    const double waves = input.profile_error_waves;
    const auto hinge_moment = [](const Demand& demand) {
        return std::abs(demand.moment * demand.dpolar);
    };
    Maximum largest_moment;
    // ρ′² + (n d)², what waves on the profile work by.
    const auto wave_effect = [&](const GuidePoint& outer) {
        const double slope = std::isfinite(outer.slope) ? outer.slope : 0.0;
        const double wave = waves * std::abs(outer.radius - half_length);
        return slope * slope + wave * wave;
    };
    Maximum steepest_error;
    bool missing = false;
    for (std::size_t i = 0; i < n; ++i) {
        const double phi = step * static_cast<double>(i);
        const Demand demand = shape->design().demand_at(hinge, i);
        const auto [inner, outer] = shape->both(demand);
        largest_moment.take(hinge_moment(demand), phi);
        guide.polar_angle[i] = demand.polar_angle;
        guide.radius_stretched[i] = outer.radius;
        guide.radius_compressed[i] = inner.radius > 0.0 ? inner.radius : nothing;
        if (std::isnan(outer.radius)) {
            if (!missing) {
                guide.first_missing_angle = phi;
            }
            missing = true;
            continue;
        }
        if (exists) {
            if (fits) {
                compressed.take(inner, phi);
            }
            stretched.take(outer, phi);
            steepest_error.take(wave_effect(outer), phi);
        }
    }

    largest_moment.sharpen(
        [&](double phi) { return hinge_moment(shape->design().demand(hinge, phi)); }, step);
    guide.largest_moment = largest_moment.value;

    if (!exists) {
        guide.lacks_preload = true;
        if (!missing) {
            guide.first_missing_angle = guide.worst_angle;
        }
        guide.reason = preload_reason(guide);
        return guide;
    }

    steepest_error.sharpen(
        [&](double phi) { return wave_effect(shape->at(Branch::stretched, phi)); }, step);
    guide.relief = highest + lowest > 0.0 ? given_out.span() / (highest + lowest) : 0.0;
    guide.largest_spring_force = 2.0 * spring->stiffness * highest;
    guide.smallest_spring_force = 2.0 * spring->stiffness * lowest;
    guide.stretched = stretched.finish(half_length + lowest, half_length + highest, step);
    if (fits) {
        guide.compressed = compressed.finish(half_length - highest, half_length - lowest, step);
    }

    // Π = 2c (d + η)²: its error is 2c (2 d η + η²), that of the moment the derivative of it.
    const double amplitude = input.profile_error;
    const double force = 2.0 * spring->stiffness * amplitude;
    guide.error.amplitude = amplitude;
    guide.error.waves = input.profile_error_waves;
    guide.error.torque = force * (2.0 * std::sqrt(steepest_error.value) + waves * amplitude);
    guide.error.energy = force * (2.0 * highest + amplitude);
    guide.error.relative =
        guide.largest_moment > 0.0 ? guide.error.torque / guide.largest_moment : 0.0;

    if (guide.branch == Branch::compressed && !fits) {
        guide.reason = {
            Text::tr("the spring would be compressed by %1, its whole free length (%2) or more"),
            number(2.0 * highest, units::mm), number(spring->free_length, units::mm)};
        return guide;
    }
    guide.feasible = true;
    return guide;
}

}  // namespace ravnoves::elastic_hinge
