#include "shop/scale_line.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ravnoves::shop {
namespace {

using Kind = ScaleLine::Kind;

TEST(ScaleLine, OfEveryCommonFormIsRead) {
    struct Case {
        std::string line;
        Kind kind;
        double mass;  // kg
    };
    const std::vector<Case> cases{
        {"S S      123.45 g", Kind::stable, 0.12345},
        {"S D      123.45 g", Kind::moving, 0.12345},
        {"S S     -0.5685 kg", Kind::stable, -0.5685},
        {"S I", Kind::other, 0.0},
        {"S +", Kind::overload, 0.0},
        {"S -", Kind::underload, 0.0},
        {"ST,+00123.4  g", Kind::stable, 0.1234},
        {"US,+00123.4  g", Kind::moving, 0.1234},
        {"ST,-00000,3  g", Kind::stable, -0.0003},
        {"ST,GS,+  123.4 g", Kind::stable, 0.1234},
        {"ST,NT,20.00,oz", Kind::stable, 20.0 * 0.028349523125},
        {"ST,NT,   20.00,oz", Kind::stable, 20.0 * 0.028349523125},
        {"OL,+9999999E+19", Kind::overload, 0.0},
        {"QT,+00000012 PC", Kind::other, 0.0},
        {"N     +  123.45 g  ", Kind::stable, 0.12345},
        {"N     +  123.45    ", Kind::moving, 0.12345},
        {"   568.5 g ?", Kind::moving, 0.5685},
        {"   568.5 g   N", Kind::stable, 0.5685},
        {"\x02 568.5g G\x03", Kind::stable, 0.5685},
        {"123.45", Kind::stable, 0.12345},
        {"123,45 g", Kind::stable, 0.12345},
        {",5 g", Kind::stable, 0.0005},
        {"+ 1.25 lb", Kind::stable, 1.25 * 0.45359237},
        {"568,5 \xD0\xB3", Kind::stable, 0.5685},
        {"0,5685 \xEA\xE3", Kind::stable, 0.5685},
    };
    for (const Case& each : cases) {
        const ScaleLine read = parse_scale_line(each.line);
        EXPECT_EQ(read.kind, each.kind) << each.line;
        EXPECT_DOUBLE_EQ(read.mass(), each.mass) << each.line;
    }
    EXPECT_DOUBLE_EQ(parse_scale_line("S S 123.45 g").last_digit(), 1e-5);
    EXPECT_DOUBLE_EQ(parse_scale_line("1.25", units::pound).mass(), 1.25 * 0.45359237);
}

TEST(ScaleLine, ThatIsGarbledOrHalfIsNoWeight) {
    for (const char* line : {"",
                             "S",
                             "S S",
                             "S S      123.45",
                             "ST,+00123.4",
                             "S X 12.0 g",
                             "S S 12 3.4 g",
                             "S S 1\x7F"
                             "3.45 g",
                             "1.234,5 g",
                             "12.3.4",
                             "568.5 gg",
                             "568.5 ct",
                             "5 g 6",
                             "E12 g",
                             "568.5 g S",
                             "0000000000012.5 g",
                             "g",
                             "+",
                             "S S \xFF\xFE g",
                             "----"}) {
        EXPECT_EQ(parse_scale_line(line).kind, Kind::garbled) << line;
    }
}

// What is left of a line whose end never came must not become another weight.
TEST(ScaleLine, CutAnywhereIsNeverAnotherWeight) {
    for (const std::string line : {"S S     1568.45 g", "ST,GS,+ 1568.4 kg", "ST,+01568.4  g"}) {
        for (std::size_t end = 0; end < line.size(); ++end) {
            EXPECT_NE(parse_scale_line(line.substr(0, end)).kind, Kind::stable)
                << line.substr(0, end);
        }
    }
}

TEST(ScaleLines, ComeWholeHoweverTheyAreCut) {
    const std::string sent = "S S  1.5 g\r\nS D  2.5 g\n\rST,+3.5 g\r\r\n4.5 g\nhalf";
    for (std::size_t step = 1; step < sent.size(); ++step) {
        ScaleLines lines;
        std::vector<std::string> found;
        for (std::size_t at = 0; at < sent.size(); at += step) {
            lines.add(std::string_view(sent).substr(at, step));
            for (std::string line; lines.next(line);) {
                found.push_back(line);
            }
        }
        EXPECT_EQ(found,
                  (std::vector<std::string>{"S S  1.5 g", "S D  2.5 g", "ST,+3.5 g", "4.5 g"}));
        EXPECT_TRUE(lines.is_half());
        EXPECT_EQ(lines.drop(), "half");
        EXPECT_FALSE(lines.is_half());
    }
    ScaleLines noise;
    noise.add(std::string(1000, 'x'));
    std::string line;
    EXPECT_TRUE(noise.next(line));
    EXPECT_FALSE(noise.is_half());
}

TEST(PartByPart, TakesEachPartOnce) {
    PartByPart parts;
    const auto send = [&](const char* text, int times) {
        int taken = 0;
        for (int i = 0; i < times; ++i) {
            taken += parts.takes(parse_scale_line(text)) ? 1 : 0;
        }
        return taken;
    };
    EXPECT_EQ(send("ST,+0000.0 g", 10), 0);
    EXPECT_EQ(send("US,+0412.7 g", 3), 0);
    EXPECT_EQ(send("ST,+0568.5 g", 2), 0);
    EXPECT_EQ(send("ST,+0568.5 g", 20), 1);
    EXPECT_EQ(send("ST,+0568.6 g", 20), 0);  // a draught
    EXPECT_EQ(send("US,+0000.3 g", 1), 0);   // off for a moment
    EXPECT_EQ(send("ST,+0568.5 g", 20), 1);  // the next, of the same weight
    EXPECT_EQ(send("S S -12.0 g", 5), 0);
    EXPECT_EQ(send("xx", 5), 0);
}

}  // namespace
}  // namespace ravnoves::shop
