#include "balance-shaft/relieved_shaft.h"

#include <algorithm>
#include <cmath>

#include "balance-shaft/fields.h"
#include "balance-shaft/input.h"
#include "case-file/decimal.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"
#include "drawing/dxf_document.h"
#include "numerics/constants.h"

namespace ravnoves::balance_shaft {

namespace {

constexpr const char* root = "/input/relieved_shaft";

Number in_mm(double metres) {
    return {metres / units::mm, units::mm, 4};
}

/// The relieved section about the bar's axis, y towards the flat.
struct Section {
    double area = 0.0;           ///< m²
    double removed_area = 0.0;   ///< m²
    double centroid = 0.0;       ///< y, m, below the axis: negative
    double second_moment = 0.0;  ///< about the axis through the centroid along the flat, m⁴
    double outermost = 0.0;      ///< largest distance from that axis, m

    Section(double radius, double depth) {
        const double flat = radius - depth;  // y of the flat
        const double angle = std::acos(std::clamp(flat / radius, -1.0, 1.0));
        const double r2 = radius * radius;
        removed_area = r2 * (angle - std::sin(2.0 * angle) / 2.0);
        area = pi * r2 - removed_area;
        const double half_width = radius * std::sin(angle);
        const double first_moment = -2.0 / 3.0 * half_width * half_width * half_width;
        centroid = first_moment / area;
        // ∫ y² dA of the segment.
        const double removed_second = r2 * r2 * (angle / 4.0 - std::sin(4.0 * angle) / 16.0);
        second_moment = pi * r2 * r2 / 4.0 - removed_second - area * centroid * centroid;
        outermost = std::max(flat - centroid, radius + centroid);
    }

    ShaftPiece piece(double length, const RelievedShaftSizes& sizes) const {
        return {length,
                sizes.elastic_modulus * second_moment,
                sizes.density * area,
                -centroid,
                area,
                second_moment / outermost};
    }
};

/// How the whole shaft bends between its bearings.
ShaftBending bending_of(const RelievedShaft& shaft, const RelievedShaftSizes& sizes,
                        const Section& relieved, double angular_speed) {
    const double stub = (shaft.bearing_span - shaft.length) / 2.0;
    const ShaftPiece whole = Section(shaft.diameter / 2.0, 0.0).piece(stub, sizes);
    return shaft_bending({whole, relieved.piece(shaft.length, sizes), whole}, angular_speed);
}

/// What makes a shaft of the right unbalance useless, one sentence each.
std::vector<Message> faults(const RelievedShaft& shaft, const RelievedShaftSizes& sizes,
                            double angular_speed) {
    std::vector<Message> faults;
    if (shaft.bearing_span < shaft.length) {
        faults.emplace_back(CORE_TEXT("balance-shaft",
                                      "The relieved length, %1, does not fit between the bearings, "
                                      "%2 apart."),
                            in_mm(shaft.length), in_mm(shaft.bearing_span));
        return faults;
    }
    if (shaft.length < shortest_shaft_piece * shaft.bearing_span) {
        faults.emplace_back(CORE_TEXT("balance-shaft",
                                      "The relieved length, %1, is less than a thousandth of the "
                                      "span between the bearings, %2."),
                            in_mm(shaft.length), in_mm(shaft.bearing_span));
        return faults;
    }
    const ShaftBending& bending = shaft.bending;
    const auto rpm_of = [](double speed) { return Number{speed / units::rpm, units::rpm, 4}; };
    if (bending.critical_speed < sizes.speed_margin * angular_speed) {
        faults.emplace_back(CORE_TEXT("balance-shaft",
                                      "The shaft whirls at %1: that must be at least %2, %3 times "
                                      "the speed."),
                            rpm_of(bending.critical_speed),
                            rpm_of(sizes.speed_margin * angular_speed),
                            Number{sizes.speed_margin, {}, 4});
    }
    if (!(angular_speed < bending.critical_speed)) {
        return faults;  // there are no loads to judge
    }
    const auto in_MPa = [](double stress) { return Number{stress / units::MPa, units::MPa, 4}; };
    if (bending.combined_stress > sizes.allowable_stress) {
        faults.emplace_back(
            CORE_TEXT("balance-shaft", "The stress, %1, is above the allowable %2."),
            in_MPa(bending.combined_stress), in_MPa(sizes.allowable_stress));
    }
    if (bending.deflection > shaft.permitted_sag) {
        faults.emplace_back(CORE_TEXT("balance-shaft", "The shaft sags by %1; %2 is permitted."),
                            in_mm(bending.deflection), in_mm(shaft.permitted_sag));
    }
    if (sizes.bearing_limit && bending.bearing_load > *sizes.bearing_limit) {
        faults.emplace_back(CORE_TEXT("balance-shaft", "A bearing carries %1; %2 is its limit."),
                            Number{bending.bearing_load, units::newton, 4},
                            Number{*sizes.bearing_limit, units::newton, 4});
    }
    return faults;
}

}  // namespace

void check_relieved_shaft(const RelievedShaftSizes& sizes) {
    check_fields(sizes, root);
    const int given =
        sizes.diameter.has_value() + sizes.depth.has_value() + sizes.length.has_value();
    if (given < 2) {
        throw InputError(
            root,
            {CORE_TEXT("balance-shaft", "must hold two of %1, %2 and %3"), field::bar_diameter.key,
             field::relief_depth.key, field::relief_length.key},
            Number{1.0 * given});
    }
    if (sizes.diameter && sizes.depth && !(*sizes.depth < *sizes.diameter)) {
        throw InputError(std::string(root) + "/depth_mm",
                         {CORE_TEXT("balance-shaft", "must be less than the diameter, %1"),
                          from_si(field::bar_diameter, *sizes.diameter)},
                         Number{from_si(field::relief_depth, *sizes.depth)});
    }
}

RelievedShaft design_relieved_shaft(const RelievedShaftSizes& sizes, double required,
                                    double angular_speed) {
    check_relieved_shaft(sizes);
    RelievedShaft shaft;
    shaft.required = required;
    shaft.diameter = sizes.diameter.value_or(0.0);
    shaft.depth = sizes.depth.value_or(0.0);
    shaft.length = sizes.length.value_or(0.0);
    const double per_volume = 2.0 / 3.0 * sizes.density;  // U = per_volume b a³
    if (!(required > 0.0)) {
        shaft.reason =
            CORE_TEXT("balance-shaft", "No unbalance is needed, so there is nothing to mill away.");
        return shaft;
    }
    if (sizes.length) {
        shaft.critical_radius = std::cbrt(required / (per_volume * shaft.length));
    }
    if (sizes.diameter) {
        shaft.critical_length = required / (per_volume * std::pow(shaft.diameter / 2.0, 3));
    }
    if (!sizes.depth) {
        const double radius = shaft.diameter / 2.0;
        const double a = shaft.critical_radius;
        if (a > radius) {
            shaft.reason = {
                CORE_TEXT("balance-shaft",
                          "The bar is too thin: over a length of %1 its diameter must be at least "
                          "%2; with this diameter the relieved length must be at least %3."),
                in_mm(shaft.length), in_mm(2.0 * a), in_mm(shaft.critical_length)};
            return shaft;
        }
        // The smaller root of h (D − h) = a², without cancellation.
        shaft.depth = a * a / (radius + std::sqrt((radius - a) * (radius + a)));
    } else if (!sizes.diameter) {
        const double a = shaft.critical_radius;
        shaft.diameter = shaft.depth + a * a / shaft.depth;
        shaft.critical_length = required / (per_volume * std::pow(shaft.diameter / 2.0, 3));
    }
    const double width_square = shaft.depth * (shaft.diameter - shaft.depth);
    shaft.half_width = std::sqrt(width_square);
    const double per_length = per_volume * width_square * shaft.half_width;
    if (!sizes.length) {
        shaft.length = required / per_length;
        shaft.critical_radius = std::cbrt(required / (per_volume * shaft.length));
    }
    shaft.unbalance = per_length * shaft.length;

    const Section section(shaft.diameter / 2.0, shaft.depth);
    shaft.mass = sizes.density * shaft.length * section.area;
    shaft.removed_mass = sizes.density * shaft.length * section.removed_area;
    shaft.centre_of_mass_radius = shaft.unbalance / shaft.mass;
    // Uniform load q = U ω²/b on a beam of the length b on two supports.
    const double load = shaft.unbalance * angular_speed * angular_speed / shaft.length;
    const double length2 = shaft.length * shaft.length;
    shaft.sag =
        5.0 / 384.0 * load * length2 * length2 / (sizes.elastic_modulus * section.second_moment);
    shaft.bending_stress = load * length2 / 8.0 * section.outermost / section.second_moment;
    shaft.bearing_span = sizes.bearing_span.value_or(shaft.length + shaft.diameter);
    shaft.permitted_sag =
        sizes.permitted_sag.value_or(shaft.bearing_span / relieved_shaft_sag_ratio);
    const double stubs = std::max(shaft.bearing_span - shaft.length, 0.0);
    shaft.weight = standard_gravity *
                   (shaft.mass + sizes.density * stubs * (section.area + section.removed_area));
    // What is out of all numbers is said below.
    if (shaft.bearing_span >= shaft.length && std::isfinite(shaft.bearing_span) &&
        shaft.length >= shortest_shaft_piece * shaft.bearing_span && section.second_moment > 0.0) {
        shaft.bending = bending_of(shaft, sizes, section, angular_speed);
    }

    if (!std::isfinite(shaft.mass) || !std::isfinite(shaft.diameter) ||
        !std::isfinite(shaft.length) || !std::isfinite(shaft.sag) ||
        !std::isfinite(shaft.bending_stress) || !std::isfinite(shaft.centre_of_mass_radius) ||
        !std::isfinite(shaft.critical_radius) || !std::isfinite(shaft.critical_length) ||
        !std::isfinite(shaft.bending.critical_speed) || !std::isfinite(shaft.bending.weight_sag) ||
        !std::isfinite(shaft.bending.combined_stress) || !std::isfinite(shaft.bending.deflection)) {
        RelievedShaft none;
        none.required = required;
        none.reason =
            CORE_TEXT("balance-shaft", "The unbalance needed is beyond any shaft of such sizes.");
        return none;
    }
    const double ratio = shaft.unbalance / required;
    if (std::abs(ratio - 1.0) > relieved_shaft_tolerance) {
        shaft.reason = {
            CORE_TEXT("balance-shaft", "These sizes give %1 % of the unbalance that is needed."),
            Number{100.0 * ratio, {}, 4}};
        return shaft;
    }
    for (const Message& fault : faults(shaft, sizes, angular_speed)) {
        shaft.reason =
            shaft.reason.empty() ? fault : Message(Text{"", "%1 %2"}, shaft.reason, fault);
    }
    shaft.feasible = shaft.reason.empty();
    constexpr double half = 0.5 * (1.0 + 1e-12);
    if (shaft.depth > half * shaft.diameter) {
        shaft.note = {CORE_TEXT("balance-shaft",
                                "More than half of the bar is milled away: the depth %1 gives the "
                                "same unbalance and a stiffer shaft."),
                      in_mm(shaft.diameter - shaft.depth)};
    }
    return shaft;
}

std::string relieved_shaft_dxf(const RelievedShaft& shaft, const std::string& title) {
    if (!shaft.feasible) {
        throw InputError(
            "", {CORE_TEXT("balance-shaft", "there is no shaft to draw: %1"), shaft.reason});
    }
    DxfDocument drawing({{"SHAFT", DxfDocument::white},
                         {"REMOVED", DxfDocument::cyan},
                         {"AXIS", DxfDocument::red},
                         {"NOTE", DxfDocument::grey}});
    const double radius = shaft.diameter / 2.0 / units::mm;
    const double flat = radius - shaft.depth / units::mm;
    const double half_width = shaft.half_width / units::mm;
    const double angle = std::atan2(flat, half_width) / degree;
    // Section at the origin, the flat above: the rest goes round below it.
    drawing.arc({0.0, 0.0}, radius, 180.0 - angle, 360.0 + angle, "SHAFT");
    drawing.line({-half_width, flat}, {half_width, flat}, "SHAFT");
    drawing.arc({0.0, 0.0}, radius, angle, 180.0 - angle, "REMOVED");
    const double arm = 1.2 * radius;
    drawing.line({-arm, 0.0}, {arm, 0.0}, "AXIS");
    drawing.line({0.0, -arm}, {0.0, arm}, "AXIS");
    // Side view to the right, the bar whole to the bearings on both sides.
    const double length = shaft.length / units::mm;
    const double stub = std::max((shaft.bearing_span - shaft.length) / 2.0 / units::mm, radius);
    const double left = 2.0 * radius;
    const double begin = left + stub;
    const double end = begin + length;
    const double right = end + stub;
    drawing.polyline({{left, -radius},
                      {right, -radius},
                      {right, radius},
                      {end, radius},
                      {end, flat},
                      {begin, flat},
                      {begin, radius},
                      {left, radius}},
                     true, "SHAFT");
    drawing.line({begin, radius}, {end, radius}, "REMOVED");
    drawing.line({left - 0.2 * radius, 0.0}, {right + 0.2 * radius, 0.0}, "AXIS");

    const double height = std::max(0.12 * radius, 0.5);
    double y = -arm - 2.0 * height;
    const auto note = [&](const std::string& words) {
        drawing.text({-radius, y}, height, words, "NOTE");
        y -= 1.6 * height;
    };
    const auto mm = [](double metres) { return format_number(metres / units::mm, 6); };
    if (!title.empty()) {
        note(title);
    }
    note("Balance shaft with a relieved middle; dimensions in mm, scale 1:1");
    note("Diameter " + mm(shaft.diameter) + ", depth " + mm(shaft.depth) + ", length " +
         mm(shaft.length) + ", width of the flat " + mm(2.0 * shaft.half_width));
    note("Unbalance " + format_number(shaft.unbalance / units::gram_mm, 6) +
         " g mm on the side away from the flat; relieved part " + format_number(shaft.mass, 4) +
         " kg");
    return drawing.write();
}

}  // namespace ravnoves::balance_shaft
