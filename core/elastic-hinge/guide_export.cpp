#include "elastic-hinge/guide_export.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case-file/decimal.h"
#include "case-file/input_error.h"
#include "drawing/dxf_document.h"
#include "elastic-hinge/fields.h"
#include "elastic-hinge/results.h"

namespace ravnoves::elastic_hinge {

namespace {

constexpr std::size_t max_points = 500'000;

void check_drawing(const Guide& guide, const GuideDrawing& drawing) {
    const BranchSummary& summary = guide.summary(drawing.branch);
    if (!guide.shape || !summary.exists) {
        throw InputError("", guide.reason.empty()
                                 ? Message(Text::tr("no feasible guide"))
                                 : Message(Text::tr("no feasible guide: %1"), guide.reason));
    }
    check_range(field::chord_tolerance, drawing.chord_tolerance / units::mm,
                Text::tr("chord tolerance"), units::mm);
    const Text roller = Text::tr("roller radius");
    check_range(field::roller_radius, drawing.roller_radius / units::mm, roller, units::mm);
    if (summary.largest_roller_radius && drawing.roller_radius >= *summary.largest_roller_radius) {
        throw InputError(roller,
                         {Text::tr("must be less than %1, else the profile is undercut"),
                          Number{*summary.largest_roller_radius / units::mm, units::mm}},
                         Number{drawing.roller_radius / units::mm, units::mm});
    }
}

double offset_of(const GuideDrawing& drawing) {
    return drawing.branch == Branch::compressed ? drawing.roller_radius : -drawing.roller_radius;
}

/// At a distance from the path, in the guide's axes.
PlanePoint drawn(const GuidePoint& point, double offset, const GuideDrawing& drawing) {
    const PlanePoint place = offset_point(point, offset);
    return {place.x, drawing.guide_turns ? -place.y : place.y};
}

double distance_to_chord(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double length = std::hypot(dx, dy);
    if (length == 0.0) {
        return std::hypot(p.x - a.x, p.y - a.y);
    }
    return std::abs((p.x - a.x) * dy - (p.y - a.y) * dx) / length;
}

/// Points of a closed curve, φ in 0…2π, so dense that no chord leaves it by more than the
/// tolerance.
template <typename Curve>
std::vector<PlanePoint> polyline(const Curve& curve, double tolerance) {
    std::vector<PlanePoint> points;
    // Adds the points that are needed strictly between the two.
    const auto divide = [&](const auto& again, double from, const PlanePoint& a, double to,
                            const PlanePoint& b, int depth) -> void {
        const double middle = 0.5 * (from + to);
        const PlanePoint m = curve(middle);
        const PlanePoint q1 = curve(0.5 * (from + middle));
        const PlanePoint q3 = curve(0.5 * (middle + to));
        const double error = std::max(
            {distance_to_chord(m, a, b), distance_to_chord(q1, a, b), distance_to_chord(q3, a, b)});
        if (error <= 0.9 * tolerance || depth >= 30) {
            return;
        }
        if (points.size() >= max_points) {
            throw InputError(
                Text::tr("chord tolerance"),
                {Text::tr("is too small for this guide: more than %1 points"), max_points});
        }
        again(again, from, a, middle, m, depth + 1);
        points.push_back(m);
        again(again, middle, m, to, b, depth + 1);
    };
    constexpr int arcs = 64;
    for (int i = 0; i < arcs; ++i) {
        const double from = two_pi * i / arcs;
        const double to = two_pi * (i + 1) / arcs;
        points.push_back(curve(from));
        divide(divide, from, PlanePoint(points.back()), to, curve(to), 0);
    }
    return points;
}

std::vector<std::string> note_lines(const Guide& guide, const GuideDrawing& drawing) {
    std::vector<std::string> lines;
    if (!drawing.title.empty()) {
        lines.push_back(drawing.title);
    }
    lines.emplace_back(guide.hinge == Hinge::rod
                           ? "Guide of the elastic hinge between crank and rod"
                           : "Guide of the elastic hinge between frame and crank");
    lines.emplace_back(drawing.branch == Branch::compressed
                           ? "Spring compressed: rollers run inside the profile"
                           : "Spring stretched: rollers run outside the profile");
    lines.push_back("Dimensions in mm, scale 1:1, chord tolerance " +
                    format_number(drawing.chord_tolerance / units::mm));
    lines.push_back("Roller radius " + format_number(drawing.roller_radius / units::mm) +
                    ", relief " + format_number(rounded_to_decimals(guide.relief / units::mm, 6)));
    if (drawing.roller_radius == 0.0) {
        lines.emplace_back("WARNING: roller radius 0, the profile is the path of the centre");
    }
    if (const Message note =
            overlap_note(guide.hinge, guide.summary(drawing.branch), drawing.roller_radius);
        !note.empty()) {
        lines.push_back("WARNING: " + note.english());
    }
    const double margin = guide.preload - guide.minimum_preload;
    if (guide.minimum_preload > 0.0 && margin < min_preload_margin) {
        lines.push_back("WARNING: the preload exceeds the minimum by only " +
                        format_number(margin / units::mm, 2));
    }
    lines.emplace_back(drawing.guide_turns
                           ? "Guide turns counter-clockwise, spring is fixed; zero angle on +X"
                           : "Spring turns counter-clockwise, guide is fixed; zero angle on +X");
    return lines;
}

}  // namespace

std::string guide_dxf(const Guide& guide, const GuideDrawing& drawing) {
    check_drawing(guide, drawing);
    DxfDocument dxf({{"PROFILE", DxfDocument::white},
                     {"ROLLER_PATH", DxfDocument::cyan},
                     {"AXIS", DxfDocument::red},
                     {"NOTE", DxfDocument::grey}});
    constexpr bool closed = true;
    double reach = 0.0;
    for (const auto& [offset, layer] :
         {std::pair{offset_of(drawing), "PROFILE"}, std::pair{0.0, "ROLLER_PATH"}}) {
        const auto curve = [&, offset = offset](double phi) {
            return drawn(guide.shape->at(drawing.branch, phi), offset, drawing);
        };
        std::vector<DxfDocument::Point> line;
        for (const PlanePoint& point : polyline(curve, drawing.chord_tolerance)) {
            line.push_back({point.x / units::mm, point.y / units::mm});
            reach = std::max(reach, std::hypot(line.back().x, line.back().y));
        }
        dxf.polyline(std::move(line), closed, layer);
    }
    const double arm = 1.1 * reach;
    dxf.line({-arm, 0.0}, {arm, 0.0}, "AXIS");
    dxf.line({0.0, -arm}, {0.0, arm}, "AXIS");
    const double height = 0.03 * reach;
    double y = -arm - 2.0 * height;
    for (const std::string& line : note_lines(guide, drawing)) {
        dxf.text({-arm, y}, height, line, "NOTE");
        y -= 1.6 * height;
    }
    return dxf.write();
}

std::string guide_csv(const Guide& guide, const GuideDrawing& drawing, double step_deg) {
    check_drawing(guide, drawing);
    check_range(field::table_step, step_deg, "step", units::degree);
    const GuideShape& shape = *guide.shape;
    const double offset = offset_of(drawing);
    std::string text =
        "crank_angle_deg,polar_angle_deg,radius_mm,x_mm,y_mm,profile_x_mm,profile_y_mm\n";
    const auto rows = static_cast<std::size_t>(std::ceil(360.0 / step_deg - 1e-9));
    const double sense = drawing.guide_turns ? -1.0 : 1.0;
    for (std::size_t i = 0; i < rows; ++i) {
        const double phi_deg = step_deg * static_cast<double>(i);
        const GuidePoint point = shape.at(drawing.branch, phi_deg * degree);
        const PlanePoint path = drawn(point, 0.0, drawing);
        const PlanePoint profile = drawn(point, offset, drawing);
        const double polar = guide.hinge == Hinge::rod ? point.angle / degree : phi_deg;
        const double values[] = {phi_deg,
                                 i == 0 ? 0.0 : sense * polar,
                                 point.radius / units::mm,
                                 path.x / units::mm,
                                 path.y / units::mm,
                                 profile.x / units::mm,
                                 profile.y / units::mm};
        const char* separator = "";
        for (const double value : values) {
            text += separator;
            text += format_number(value == 0.0 ? 0.0 : value);
            separator = ",";
        }
        text += '\n';
    }
    return text;
}

}  // namespace ravnoves::elastic_hinge
