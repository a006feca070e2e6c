#include "balance-shaft/table_reading.h"

#include <gtest/gtest.h>

#include "test_cases.h"

namespace ravnoves::balance_shaft {
namespace {

using test::error_of;

const TorqueTable small{{0, 180, 360, 540, 720}, {0, -90.5, 893, 30, 0}};

std::string rejection_of_text(const std::string& text) {
    return error_of([&] { parse_cycle(Measured::torque, text); });
}

TEST(ParsedCycle, ReadsEverySeparatorAndDecimalSign) {
    const std::vector<std::string> texts = {
        "0,0\n180,-90.5\n360,893\n540,30\n720,0\n",
        "0, 0\n180, -90.5\n360, 893\n540, 30\n720, 0\n",
        "0;0\n180;-90,5\n360;893\n540;30\n720;0",
        "0\t0\r\n180\t-90,5\r\n360\t893\r\n540\t30\r\n720\t0\r\n",
        "0 0\n180 -90,5\n360   893\n540 30\n720 0\n",
        "\xEF\xBB\xBF\"0\",\"0\"\n\"180\",\"-90,5\"\n\"360\",\"893\"\n\"540\",\"30\"\n\"720\","
        "\"0\"",
        "crank angle;torque\n°;N·m\n0;0\n180;\xE2\x88\x92"
        "90.5\n360;8.93e2\n540;+30\n720;0\n",
        "# measured\n\nphi, M\n0,0,\n180,-90.5,\n360,893,\n540,30,\n720,0,\n",
        "0;0\r180;-90,5\r360;893\r540;30\r720;0",
    };
    for (const std::string& text : texts) {
        EXPECT_EQ(
            error_of([&] { EXPECT_EQ(parse_cycle(Measured::torque, text).table, small) << text; }),
            "no error")
            << text;
    }
    EXPECT_EQ(parse_cycle(Measured::torque, texts[6]).describe().english(),
              "5 rows, separated by semicolons, angles in degrees, with a header");
    EXPECT_EQ(parse_cycle(Measured::torque, texts[3]).describe().english(),
              "5 rows, separated by tabs, decimal comma, angles in degrees");
}

TEST(ParsedCycle, ReadsOneTurnAsTheCycleOfATwoStroke) {
    const auto read = parse_cycle(Measured::torque, "0;1\n90;2\n180;3\n360;1\n");
    EXPECT_EQ(read.strokes, 2);
    EXPECT_EQ(read.table, (TorqueTable{{0, 90, 180, 360}, {1, 2, 3, 1}}));
    EXPECT_EQ(read.describe().english(),
              "4 rows, separated by semicolons, angles in degrees, 360°, the cycle of a two-stroke "
              "engine");
}

TEST(ParsedCycle, KnowsRadians) {
    const auto by_span =
        parse_cycle(Measured::torque, "0;1\n3.14159265;2\n6.28319;3\n12.56637;1\n");
    EXPECT_TRUE(by_span.in_radians);
    EXPECT_EQ(by_span.strokes, 4);
    EXPECT_NEAR(by_span.table.crank_angle_deg[1], 180.0, 1e-6);
    EXPECT_EQ(by_span.table.crank_angle_deg.back(), 720.0);
    const auto one_turn =
        parse_cycle(Measured::torque, "angle, rad;torque\n0;1\n3.14159;2\n6.28319;1\n");
    EXPECT_TRUE(one_turn.in_radians && one_turn.strokes == 2);
    EXPECT_EQ(one_turn.table.crank_angle_deg.back(), 360.0);
    EXPECT_TRUE(
        parse_cycle(Measured::torque, "угол, рад;M\n0;1\n3.14159;2\n6.28319;1\n").in_radians);
    // The header and the span must agree.
    EXPECT_EQ(rejection_of_text("phi [rad];M\n0;1\n180;2\n720;1\n"),
              "line 4, column 1: the angles must span 720° (or 360°, or 4π or 2π in radians), the "
              "last row repeating the first, got 720 rad");
    EXPECT_NE(rejection_of_text("phi [deg];M\n0;1\n3.14159;2\n6.28319;1\n"), "no error");
    // Not a unit: "radius", "grad".
    EXPECT_FALSE(
        parse_cycle(Measured::torque, "crank radius 46;M\n0;1\n180;2\n720;1\n").in_radians);
}

TEST(ParsedCycle, KeepsAnyStartOfTheCycle) {
    const auto read = parse_cycle(Measured::torque, "-360;5\n0;7\n360;5\n");
    EXPECT_EQ(read.table, (TorqueTable{{-360, 0, 360}, {5, 7, 5}}));
}

TEST(ParsedCycle, ErrorsNameLineAndColumn) {
    const std::string two_columns = "line 3: must have two columns, crank angle and torque";
    const std::string no_rows = "the torque table must have at least 3 rows, got 0";
    const std::pair<std::string, std::string> cases[] = {
        // The name of the file may stand in a case that somebody else wrote: no line of a file
        // that is no table is quoted.
        {"root:x:0\ndaemon:x:1\nbin:x:2\n", two_columns},
        {"user\nlogin\n12:secret\n", two_columns},
        {"user\nlogin\nname;secret\n", "line 3, column 1: must be a finite number"},
        {"user\nlogin\n1;infantry\n", "line 3, column 2: must be a finite number"},
        // After a row that is one, what is wrong in another is said, as it stands.
        {"0;0\n180;x\n720;0\n", "line 2, column 2: must be a finite number, got \"x\""},
        {"0\t0\n360\t\xE2\x88\x92\xE2\x88\x92"
         "5\n720\t0\n",
         "line 2, column 2: must be a finite number, got \"−−5\""},
        {"0\t0\n360\tпять\n720\t0\n", "line 2, column 2: must be a finite number, got \"пять\""},
        {"0\t0\n360\t\xEF\xFF\n720\t0\n",  // of another code page
         "line 2, column 2: must be a finite number, got \"\uFFFD\uFFFD\""},
        {"", no_rows},
        {"\n\n  \n", no_rows},
        {"phi;M\n", no_rows},
        {"0;0\n", "the torque table must have at least 3 rows, got 1"},
        {"0;0\n720;0\n", "the torque table must have at least 3 rows, got 2"},
        {std::string("\x7F"
                     "ELF\2\1\1\0\0\0",
                     10),
         "line 1: must be text; this looks like a binary file"},
        {std::string("0;0\n\0\1\2", 7), "line 2: must be text; this looks like a binary file"},
        {"a;b\n0;0\n\n1O;5\n720;0\n", "line 4, column 1: must be a finite number, got \"1O\""},
        {"0;0\n180;nan\n720;0\n", "line 2, column 2: must be a finite number, got \"nan\""},
        {"0;inf\n180;1\n720;0\n", "line 1, column 2: must be a finite number, got \"inf\""},
        {"nan;0\n180;1\n720;0\n", "line 1, column 1: must be a finite number, got \"nan\""},
        {"0;0\n180;1e999\n720;0\n", "line 2, column 2: must be a finite number, got \"1e999\""},
        {"0;0\n180;\n720;0\n", "line 2, column 2: must be a finite number, got \"\""},
        {"0;0\n180\n720;0\n", "line 2: must have two columns, crank angle and torque, got \"180\""},
        {"0;0;1\n180;0;2\n720;0;1\n",
         "line 1: must have two columns, crank angle and torque, or the case must name two of them "
         "in \"columns\", got 3 columns"},
        {"0;0\n200;5\n180;1\n720;0\n",
         "line 3, column 1: must be greater than the angle of the row before, 200, got 180"},
        {"0;0\n180;5\n180;1\n720;0\n",
         "line 3, column 1: must not repeat the angle of the row before, 180, got 180"},
        {"0;0\n180;5\n720;12\n",
         "line 3, column 2: must equal the first torque, 0 N·m, since the cycle repeats, got 12 "
         "N·m"},
        {"0;0\n180;5\n700;0\n",
         "line 3, column 1: the angles must span 720° (or 360°, or 4π or 2π in radians), the last "
         "row repeating the first, got 700°"},
        {"0;0\n180;2e12\n720;0\n",
         "line 2, column 2: must be from -1000000000000 to 1000000000000, got 2000000000000"},
        {"0;0\n1e9;2\n720;0\n",
         "line 2, column 1: must be from -36000000 to 36000000, got 1000000000"},
        {"0,5,1,5\n180,5,2,5\n",
         "line 1, column 1: must not separate columns by commas and use decimal commas at once; "
         "separate the columns by semicolons, got \"0,5,1,5\""}};
    for (const auto& [text, error] : cases) {
        EXPECT_EQ(rejection_of_text(text), error);
    }
    EXPECT_NE(rejection_of_text("just\nsome\nprose\n"), "no error");
}

TEST(ParsedCycle, ACommaBetweenThousandsIsNotTakenForADecimalOne) {
    EXPECT_EQ(
        rejection_of_text("0\t-81.5\n360\t1,893\n720\t-81.5\n"),
        "line 2, column 2: must have the decimal sign of the numbers above: all points or all "
        "commas, and nothing between thousands, got \"1,893\"");
    EXPECT_EQ(rejection_of_text("0;1,500\n360;2.5\n720;1,500\n").substr(0, 17),
              "line 2, column 2:");
    EXPECT_EQ(rejection_of_text("0;1,5\n360;2.5\n720;1,5\n"), "no error");
    EXPECT_EQ(rejection_of_text("0\t-81,5\n360\t1,893\n720\t-81,5\n"), "no error");
    // Among whole numbers it can be either.
    EXPECT_EQ(rejection_of_text("0\t-81\n360\t1,893\n720\t-81\n"),
              "line 2, column 2: must be unambiguous: its comma may divide thousands or be a "
              "decimal sign, as no other number of the column has one, got \"1,893\"");
    EXPECT_EQ(rejection_of_text("0\t0\n360\t1,893\n720\t0\n"), "no error");
    EXPECT_EQ(rejection_of_text("0\t1,250\n360\t1,893\n720\t1,250\n"), "no error");
    EXPECT_EQ(rejection_of_text("0\t-81\n180\t12,5\n360\t1,893\n720\t-81\n"), "no error");
}

TEST(ParsedCycle, TwentyThousandRowsAreReadAndMoreAreRejected) {
    const TorqueTable table = test::random_table(7, largest_torque_table);
    std::string text = write_torque_table(table);
    EXPECT_EQ(parse_cycle(Measured::torque, text).table, table);
    text = write_torque_table(test::random_table(7, largest_torque_table + 1));
    EXPECT_EQ(rejection_of_text(text),
              "a cycle must have at most 20000 rows: use larger steps, got 20001");
}

TEST(TorqueTableCheck, NamesThePointer) {
    const auto check = [](const TorqueTable& table) {
        return error_of([&] { check_torque_table(table, "/input/torque"); });
    };
    EXPECT_EQ(check(small), "no error");
    EXPECT_EQ(check({{0, 180, 720}, {0, 1}}),
              "/input/torque/torque_Nm: must have as many numbers as crank_angle_deg, 3, got 2");
    EXPECT_EQ(check({}), "/input/torque/crank_angle_deg: must have at least 3 numbers, got 0");
    EXPECT_EQ(check({{0, 180, 720}, {0, std::nan(""), 0}}),
              "/input/torque/torque_Nm/1: must be from -1000000000000 to 1000000000000, got not a "
              "number");
    EXPECT_EQ(check({{0, 180, 100, 720}, {0, 1, 2, 0}}),
              "/input/torque/crank_angle_deg/2: must be greater than the angle of the row before, "
              "180, got 100");
    EXPECT_EQ(check({{0, 180, 720}, {0, 1, 2}}),
              "/input/torque/torque_Nm/2: must equal the first torque, 0 N·m, since the cycle "
              "repeats, got 2 N·m");
    EXPECT_EQ(check({{0, 180, 360}, {0, 1, 0}}), "no error");
    EXPECT_EQ(check({{0, 180, 540}, {0, 1, 0}}),
              "/input/torque/crank_angle_deg: must span 720°, or 360° for a two-stroke engine, the "
              "last row repeating the first, got 540°");
}

TEST(BalanceShaftTorqueTable, RowsTooCloseForASlopeAreRejected) {
    TorqueTable table{{0.0, 1e-12, 300.0, 720.0}, {10.0, -10.0, 5.0, 10.0}};
    EXPECT_EQ(error_of([&] { check_torque_table(table, "/input/torque"); }),
              "/input/torque/crank_angle_deg/1: must be at least 1e-09° more than the angle of the "
              "row before, 0, got 1e-12");
    table.crank_angle_deg[1] = 1e-6;  // a step of the torque is a table like any other
    EXPECT_NO_THROW(check_torque_table(table, "/input/torque"));
}

}  // namespace
}  // namespace ravnoves::balance_shaft
