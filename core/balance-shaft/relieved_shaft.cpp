#include "balance-shaft/relieved_shaft.h"

#include <algorithm>
#include <cmath>

#include "balance-shaft/fields.h"
#include "balance-shaft/input.h"
#include "case-file/decimal.h"
#include "case-file/field_writer.h"
#include "case-file/input_error.h"
#include "drawing/dxf_document.h"

namespace ravnoves::balance_shaft {

double half_disc_length(double radius, double unbalance, double density) {
    return unbalance / (2.0 / 3.0 * density * std::pow(radius, 3));
}

void check_relieved_shaft(const RelievedShaftSizes& sizes) {
    constexpr const char* root = "/input/relieved_shaft";
    check_fields(sizes, root);
    const int given =
        sizes.diameter.has_value() + sizes.depth.has_value() + sizes.length.has_value();
    if (given < 2) {
        throw InputError(root,
                         {Text::tr("must have two of %1, %2 and %3"), field::bar_diameter.key,
                          field::relief_depth.key, field::relief_length.key},
                         Number{1.0 * given});
    }
    if (sizes.diameter && sizes.depth && !(*sizes.depth < *sizes.diameter)) {
        throw InputError(std::string(root) + "/depth_mm",
                         {Text::tr("must be less than the diameter, %1"),
                          from_si(field::bar_diameter, *sizes.diameter)},
                         Number{from_si(field::relief_depth, *sizes.depth)});
    }
}

RelievedShaft design_relieved_shaft(const RelievedShaftSizes& sizes, double required) {
    check_relieved_shaft(sizes);
    RelievedShaft shaft;
    shaft.required = required;
    shaft.diameter = sizes.diameter.value_or(0.0);
    shaft.depth = sizes.depth.value_or(0.0);
    shaft.length = sizes.length.value_or(0.0);
    const double per_volume = 2.0 / 3.0 * sizes.density;  // U = per_volume b a³
    if (!(required > 0.0)) {
        shaft.reason = Text::tr("No unbalance is required: no relief.");
        return shaft;
    }
    if (sizes.length) {
        shaft.critical_radius = std::cbrt(required / (per_volume * shaft.length));
    }
    if (sizes.diameter) {
        shaft.critical_length = half_disc_length(shaft.diameter / 2.0, required, sizes.density);
    }
    if (!sizes.depth) {
        const double radius = shaft.diameter / 2.0;
        const double a = shaft.critical_radius;
        constexpr double rounding = 1e-12;  // half a bar, sized by its critical radius
        if (a > radius * (1.0 + rounding)) {
            shaft.reason = {
                Text::tr("The bar is too thin: over a length of %1 its diameter must be at least "
                         "%2; with this diameter the relieved length must be at least %3."),
                in_mm(shaft.length), in_mm(2.0 * a), in_mm(shaft.critical_length)};
            return shaft;
        }
        // The smaller root of h (D − h) = a², without cancellation.
        shaft.depth = a * a / (radius + std::sqrt(std::max(radius - a, 0.0) * (radius + a)));
    } else if (!sizes.diameter) {
        const double a = shaft.critical_radius;
        shaft.diameter = shaft.depth + a * a / shaft.depth;
        shaft.critical_length = half_disc_length(shaft.diameter / 2.0, required, sizes.density);
    }
    const double width_square = shaft.depth * (shaft.diameter - shaft.depth);
    shaft.half_width = std::sqrt(width_square);
    const double per_length = per_volume * width_square * shaft.half_width;
    if (!sizes.length) {
        shaft.length = required / per_length;
        shaft.critical_radius = std::cbrt(required / (per_volume * shaft.length));
    }
    shaft.unbalance = per_length * shaft.length;

    const double radius = shaft.diameter / 2.0;
    const double angle = std::acos(std::clamp((radius - shaft.depth) / radius, -1.0, 1.0));
    const double removed_area = radius * radius * (angle - std::sin(2.0 * angle) / 2.0);
    shaft.mass = sizes.density * shaft.length * (pi * radius * radius - removed_area);
    shaft.removed_mass = sizes.density * shaft.length * removed_area;
    shaft.centre_of_mass_radius = shaft.unbalance / shaft.mass;
    if (!std::isfinite(shaft.mass) || !std::isfinite(shaft.diameter) ||
        !std::isfinite(shaft.length) || !std::isfinite(shaft.centre_of_mass_radius) ||
        !std::isfinite(shaft.critical_radius) || !std::isfinite(shaft.critical_length)) {
        RelievedShaft none;
        none.required = required;
        none.reason = Text::tr("No shaft of these sizes has the required unbalance.");
        return none;
    }
    const double ratio = shaft.unbalance / required;
    if (std::abs(ratio - 1.0) > relieved_shaft_tolerance) {
        shaft.reason = {Text::tr("These sizes give %1 % of the required unbalance."),
                        Number{100.0 * ratio, {}, 4}};
        return shaft;
    }
    shaft.feasible = true;
    constexpr double half = 0.5 * (1.0 + 1e-12);
    if (shaft.depth > half * shaft.diameter) {
        shaft.note = {Text::tr("More than half of the bar is milled away: the depth %1 gives the "
                               "same unbalance and a stiffer shaft."),
                      in_mm(shaft.diameter - shaft.depth)};
    }
    return shaft;
}

std::string relieved_shaft_dxf(const RelievedShaft& shaft) {
    if (!shaft.feasible) {
        throw InputError("", {Text::tr("no drawing: %1"), shaft.reason});
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
    // Side view to the right, half a diameter of whole bar on both sides.
    const double length = shaft.length / units::mm;
    const double left = 2.0 * radius;
    const double begin = left + radius;
    const double end = begin + length;
    const double right = end + radius;
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
    note("Balance shaft with a relieved middle; dimensions in mm, scale 1:1");
    note("Diameter " + mm(shaft.diameter) + ", depth " + mm(shaft.depth) + ", length " +
         mm(shaft.length) + ", width of the flat " + mm(2.0 * shaft.half_width));
    note("Unbalance " + format_number(shaft.unbalance / units::gram_mm, 6) +
         " g mm on the side away from the flat; relieved part " + format_number(shaft.mass, 4) +
         " kg");
    return drawing.write();
}

}  // namespace ravnoves::balance_shaft
