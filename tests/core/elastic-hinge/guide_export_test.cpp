#include "elastic-hinge/guide_export.h"

#include <clocale>
#include <sstream>

#include "dxf_drawing.h"
#include "elastic-hinge/presets.h"
#include "support.h"

namespace ravnoves::elastic_hinge {
namespace {

double distance_to_polyline(const auto& p, const std::vector<DL_VertexData>& points) {
    double minimum = 1e300;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& a = points[i];
        const auto& b = points[(i + 1) % points.size()];
        const double dx = b.x - a.x;
        const double dy = b.y - a.y;
        const double u =
            std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        minimum = std::min(minimum, std::hypot(p.x - a.x - u * dx, p.y - a.y - u * dy));
    }
    return minimum;
}

Guide deep_guide(Branch branch) {
    Input input = preset_zotov();
    input.spring = Spring{2e5, 0.2, branch == Branch::compressed ? 0.088 : 0.112};
    return solve(input).crank_guide;
}

class ElasticHingeExport : public testing::TestWithParam<Branch> {};

TEST_P(ElasticHingeExport, DxfReadsBackClosedAndWithinItsTolerance) {
    const Guide guide = deep_guide(GetParam());
    ASSERT_TRUE(guide.feasible) << guide.reason.english();
    GuideDrawing drawing;
    drawing.branch = GetParam();
    drawing.roller_radius = 0.006;
    drawing.chord_tolerance = 5e-6;
    drawing.title = "Направляющая guide 1";
    const ravnoves::test::DxfDrawing read(guide_dxf(guide, drawing));
    EXPECT_EQ(read.units, 4);  // mm
    for (const char* layer : {"PROFILE", "ROLLER_PATH", "AXIS", "NOTE"}) {
        EXPECT_TRUE(read.layers.contains(layer)) << layer;
    }
    EXPECT_EQ(read.lines.count("AXIS"), 2U);
    ASSERT_FALSE(read.texts.empty());
    EXPECT_EQ(read.texts.front().text, " guide 1");
    bool tolerance_named = false;
    for (const DL_TextData& note : read.texts) {
        tolerance_named |= note.text.find("chord tolerance 0.005") != std::string::npos;
    }
    EXPECT_TRUE(tolerance_named);

    const double side = GetParam() == Branch::compressed ? 1.0 : -1.0;
    const struct {
        const char* layer;
        double offset;
    } curves[] = {{"ROLLER_PATH", 0.0}, {"PROFILE", side * drawing.roller_radius}};
    for (const auto& curve : curves) {
        const auto& polyline = read.polylines.at(curve.layer);
        EXPECT_TRUE(polyline.closed);
        ASSERT_GT(polyline.points.size(), 64U);
        // Closed once: the last point is not the first again, but near it.
        const auto& first = polyline.points.front();
        const auto& last = polyline.points.back();
        const double gap = std::hypot(first.x - last.x, first.y - last.y);
        EXPECT_GT(gap, 0.0);
        EXPECT_LT(gap, 10.0);
        double worst = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const double phi = two_pi * (i + 0.37) / 2000;
            PlanePoint p = offset_point(guide.shape->at(GetParam(), phi), curve.offset);
            p = {p.x * 1e3, -p.y * 1e3};  // the guide turns: its polar angle is −φ
            worst = std::max(worst, distance_to_polyline(p, polyline.points));
        }
        EXPECT_LT(worst, 0.005);
        EXPECT_GT(worst, 0.0005);  // and no thousand points too many
    }
    // The roller touches: the profile is everywhere one roller radius from the path.
    const auto& path = read.polylines.at("ROLLER_PATH").points;
    const auto& profile = read.polylines.at("PROFILE").points;
    for (std::size_t i = 0; i < profile.size(); i += 17) {
        EXPECT_NEAR(distance_to_polyline(profile[i], path), 6.0, 0.006);
        EXPECT_GT(
            side * (std::hypot(profile[i].x, profile[i].y) - std::hypot(path[0].x, path[0].y)),
            0.0);
    }
}

TEST_P(ElasticHingeExport, CsvHoldsTheSameCurve) {
    const Guide guide = deep_guide(GetParam());
    GuideDrawing drawing;
    drawing.branch = GetParam();
    drawing.roller_radius = 0.006;
    for (const bool turns : {true, false}) {
        drawing.guide_turns = turns;
        std::stringstream stream(guide_csv(guide, drawing, 0.5));
        std::string line;
        std::getline(stream, line);
        EXPECT_EQ(line,
                  "crank_angle_deg,polar_angle_deg,radius_mm,x_mm,y_mm,profile_x_mm,profile_y_mm");
        int rows = 0;
        while (std::getline(stream, line)) {
            std::stringstream cells(line);
            std::vector<double> v;
            for (std::string cell; std::getline(cells, cell, ',');) {
                v.push_back(std::stod(cell));
            }
            ASSERT_EQ(v.size(), 7U);
            EXPECT_DOUBLE_EQ(v[0], 0.5 * rows);
            EXPECT_DOUBLE_EQ(v[1], turns ? -v[0] : v[0]);
            EXPECT_NEAR(v[3], v[2] * std::cos(v[1] * degree), 1e-9);
            EXPECT_NEAR(v[4], v[2] * std::sin(v[1] * degree), 1e-9);
            EXPECT_NEAR(std::hypot(v[5] - v[3], v[6] - v[4]), 6.0, 1e-9);
            EXPECT_NEAR(v[2], guide.shape->at(GetParam(), v[0] * degree).radius * 1e3, 1e-12);
            ++rows;
        }
        EXPECT_EQ(rows, 720);
    }
}

INSTANTIATE_TEST_SUITE_P(BothBranches, ElasticHingeExport,
                         testing::Values(Branch::compressed, Branch::stretched));

TEST(ElasticHingeExportRejections, SayWhy) {
    Input input = preset_zotov();
    input.spring->guide_radius_at_zero = 0.0999;
    const Guide none = solve(input).crank_guide;
    EXPECT_NE(test::error_of([&] { guide_dxf(none, {}); }).find("preload"), std::string::npos);
    EXPECT_NE(test::error_of([&] { guide_csv(none, {}, 1.0); }).find("preload"), std::string::npos);

    const Guide guide = deep_guide(Branch::compressed);
    GuideDrawing drawing;
    drawing.chord_tolerance = 0.0;
    EXPECT_NE(test::error_of([&] { guide_dxf(guide, drawing); }).find("chord tolerance"),
              std::string::npos);
    drawing = {};
    drawing.branch = Branch::stretched;
    drawing.roller_radius = 0.2;
    EXPECT_NE(test::error_of([&] { guide_dxf(guide, drawing); }).find("undercut"),
              std::string::npos);
    EXPECT_NE(test::error_of([&] { guide_csv(guide, {}, 0.0); }), "no error");
    EXPECT_EQ(test::error_of([&] { guide_csv(guide, {}, 0.005); }),
              "step: must be from 0.01 to 90°, got 0.005°");
}

TEST(ElasticHingeExportRejections, NumbersKeepTheirPointInALocaleWithCommas) {
    const std::string plain = guide_dxf(deep_guide(Branch::compressed), {});
    bool found = false;
    for (const char* name : {"ru_RU.UTF-8", "ru_RU.utf8", "de_DE.UTF-8", "de_DE.utf8"}) {
        if (std::setlocale(LC_ALL, name) != nullptr) {
            found = true;
            break;
        }
    }
    const std::string local = guide_dxf(deep_guide(Branch::compressed), {});
    std::setlocale(LC_ALL, "C");
    if (!found) {
        GTEST_SKIP() << "no locale with a decimal comma on this machine";
    }
    EXPECT_EQ(plain, local);
}

}  // namespace
}  // namespace ravnoves::elastic_hinge
