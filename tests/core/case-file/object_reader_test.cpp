#include "case-file/object_reader.h"

#include <gtest/gtest.h>

#include "case-file/case_file.h"
#include "case-file/decimal.h"
#include "case-file/json.h"
#include "error_of.h"

namespace ravnoves {
namespace {

using test::error_of;

TEST(ObjectReader, NamesTheElementOfAList) {
    const Json input = parse_json(R"({"list": [1, 2, "x"]})");
    ObjectReader reader(input, "/input");
    EXPECT_EQ(error_of([&] { reader.numbers("list", Range{}); }),
              "/input/list/2: must be a number, got \"x\"");
}

TEST(ObjectReader, UnknownKeyNamesTheNearest) {
    const auto rejected = [](const char* input, std::initializer_list<const char*> known) {
        const Json json = parse_json(input);
        ObjectReader reader(json, "/input");
        for (const char* key : known) {
            reader.has(key);
        }
        return error_of([&] { reader.finish(); });
    };
    EXPECT_EQ(rejected(R"({"crank_radus_mm": 46})", {"crank_radius_mm", "lambda"}),
              "/input/crank_radus_mm: is not a known key; the nearest is \"crank_radius_mm\"");
    // The unit is left out.
    EXPECT_EQ(rejected(R"({"gravity": 9.81})", {"gravity_m_s2", "cavity"}),
              "/input/gravity: is not a known key; the nearest is \"gravity_m_s2\"");
}

TEST(ObjectReader, AMissingKeyNamesWhatIsNearlyIt) {
    const auto rejected = [](const char* input) {
        const Json json = parse_json(input);
        ObjectReader reader(json, "/input");
        reader.has("rod_length_mm");
        return error_of([&] { reader.number("crank_radius_mm", Range::greater_than(0)); });
    };
    const std::string missing = "/input/crank_radius_mm: is required and missing";
    EXPECT_EQ(rejected(R"({"crank_radius": 46})"), missing + "; found: \"crank_radius\"");
    EXPECT_EQ(rejected(R"({"crank_radus_mm": 46})"), missing + "; found: \"crank_radus_mm\"");
    EXPECT_EQ(rejected(R"({"rod_length_mm": 46, "crank": 1})"), missing);
    EXPECT_EQ(rejected("{}"), missing);
}

TEST(ParseJson, SyntaxErrorsNameLineAndColumn) {
    EXPECT_EQ(error_of([] { parse_json("{\n  \"a\": NaN\n}"); }),
              "line 2, column 8: is not valid JSON");
    EXPECT_NE(error_of([] { parse_json(std::string_view("\0\1\2\377", 4)); }), "no error");
}

TEST(ParseJson, RejectsNestingThatWouldExhaustTheStack) {
    const std::size_t levels = 1'000'000;
    const std::string deep = std::string(levels, '[') + std::string(levels, ']');
    EXPECT_EQ(error_of([&] { parse_json(deep); }), "is nested more than 100 levels deep");
    EXPECT_EQ(error_of([&] { parse_json("{\"a\": " + deep + "}"); }),
              "is nested more than 100 levels deep");
    // Brackets in a text nest nothing, whatever is escaped before its closing quote.
    const std::string text = R"("\"\\\")" + std::string(200, '[') + R"(")";
    EXPECT_EQ(parse_json(text).get<std::string>().size(), 203U);
    const std::string allowed = std::string(100, '[') + std::string(100, ']');
    EXPECT_TRUE(parse_json(allowed).is_array());
}

TEST(ParseJson, RejectsKeysGivenTwice) {
    EXPECT_EQ(error_of([] { parse_json(R"({"a": 1, "b": [{}, {"c": 1, "d": 2, "c": 1}]})"); }),
              "/b/1/c: is given twice");
    EXPECT_EQ(error_of([] { parse_json(R"({"a/b": {}, "a\u002fb": 2})"); }),
              "/a~1b: is given twice");
    // Among many, too, the first as the last.
    std::string many = "{";
    for (int i = 0; i < 40; ++i) {
        many += "\"k" + std::to_string(i) + "\": 0, ";
    }
    EXPECT_EQ(parse_json(many + "\"z\": 1}").size(), 41U);
    for (const char* key : {"k0", "k15", "k16", "k39"}) {
        EXPECT_EQ(error_of([&] { parse_json(many + '"' + key + "\": 1}"); }),
                  std::string("/") + key + ": is given twice");
    }
    // The same key in different objects is none.
    const char* const apart = R"({"a":{"a":[{"a":1},{"a":null}]},"b":[true,-3,0.5,"x",[],{}]})";
    EXPECT_EQ(parse_json(apart).dump(), apart);
    EXPECT_EQ(parse_json(" 3 ").dump(), "3");
}

TEST(ParseJson, RejectsNulAndSaysWhere) {
    EXPECT_EQ(error_of([] { parse_json(std::string_view("{\n\"a\": 1}\0, \"b\"", 16)); }),
              "line 2, column 8: must not contain the character NUL");
    EXPECT_EQ(error_of([] { parse_json(R"({"a": [1, "t.csv\u0000.json"]})"); }),
              R"(/a/1: must not contain the character NUL, got "t.csv\u0000.json")");
    EXPECT_EQ(error_of([] { parse_json(R"({"a": {"b\u0000": 1}})"); }),
              R"(/a/b\u0000: must not contain the character NUL)");
    EXPECT_EQ(error_of([] { parse_json(R"({"a": [0, 1e999]})"); }),
              "/a/1: contains a number that is too large for this program");
}

TEST(ParseJson, RejectsMoreValuesThanAnyCaseHas) {
    std::string zeros = "[0";
    for (int i = 0; i < 5'000'000; ++i) {
        zeros += ",0";
    }
    EXPECT_EQ(error_of([&] { parse_json(zeros + "]"); }), "must have at most 5000000 values");
}

TEST(ParseJson, RejectsMoreNamesThanAnyObjectHas) {
    std::string text = "{\"a\": {";
    for (int i = 0; i < 300'000; ++i) {
        text += (i == 0 ? "\"" : ",\"") + std::to_string(i) + "\":1";
    }
    EXPECT_EQ(error_of([&] { parse_json(text + "}}"); }), "/a: must have at most 1000 names");
}

// What a file holds neither reaches the terminal as a command nor fills it.
TEST(ObjectReader, ShowsKeysAndValuesPrintableAndShort) {
    const std::string escape = "\x1B[2J\n\x7F\xC2\x9B";
    EXPECT_EQ(printable("ж" + escape + "é"), R"(ж\u001b[2J\u000a\u007f\u009bé)");
    EXPECT_EQ(printable("a\xE2\x80\xAE"
                        "b\xE2\x81\xA6"
                        "c\xE2\x80\xA9 №"),
              "a\\u202eb\\u2066c\xE2\x80\xA9 №");
    EXPECT_EQ(printable("M\xFCller-\xE9"), "M\xFCller-\xE9") << "broken, and no control character";
    EXPECT_EQ(printable("жжж", 5), "жж…");
    EXPECT_EQ(printable("жжж", 6), "жжж");
    EXPECT_EQ(show(Json("\x7F")), R"("\u007f")");
    Json input;
    input[escape] = 1;
    EXPECT_EQ(error_of([&] { ObjectReader(input, "/input").finish(); }),
              R"(/input/\u001b[2J\u000a\u007f\u009b: is not a known key)");
    input.clear();
    input[std::string(30'000'000, 'k')] = 1;
    ObjectReader reader(input, "/input");
    reader.has("crank_radius_mm");
    EXPECT_EQ(error_of([&] { reader.finish(); }),
              "/input/" + std::string(80, 'k') + "…: is not a known key");
    EXPECT_EQ(quoted_list({escape}).english(), R"("\u001b[2J\u000a\u007f\u009b")");
}

TEST(SetInputValue, MakesWhatIsMissingButNoGapInAList) {
    Json input = parse_json(R"({"a": [1, {"b": 2}], "c": 3})");
    set_input_value(input, "/a/1/b", 4);
    set_input_value(input, "/a/2", 5);
    set_input_value(input, "/d/e~1f", "x");
    EXPECT_EQ(input.dump(), R"({"a":[1,{"b":4},5],"c":3,"d":{"e/f":"x"}})");
    const auto rejection = [&](const char* pointer) {
        return error_of([&] { set_input_value(input, pointer, 1); });
    };
    // 900 million numbers would be made first.
    EXPECT_EQ(rejection("/a/900000000"),
              "/input/a/900000000: is not in the list, which has 3 elements");
    EXPECT_EQ(rejection("/a/x"), "/input/a/x: is not in the list, which has 3 elements");
    EXPECT_EQ(rejection("/c/d"), "/input/c/d: is not a known key");
    EXPECT_EQ(input.at("a").size(), 3U);
}

TEST(ParseJson, SaysThatAnEmptyFileIsEmpty) {
    EXPECT_EQ(error_of([] { parse_json(""); }), "is empty");
    EXPECT_EQ(error_of([] { parse_json(" \r\n\t"); }), "is empty");
}

TEST(Decimal, ReadsCommaAndPoint) {
    EXPECT_EQ(parse_decimal("1,5"), 1.5);
    EXPECT_EQ(parse_decimal(" 1.5\t"), 1.5);
    EXPECT_EQ(parse_decimal("\xE2\x88\x92"
                            "3"),
              -3.0);
    EXPECT_EQ(parse_decimal("+2e3"), 2000.0);
    for (const char* bad : {"", " ", "1.234,5", "1 2", "abc", "1,2,3", "nan", "inf", "1e999", "--1",
                            "+-1", "0x10", "1e"}) {
        EXPECT_FALSE(parse_decimal(bad).has_value()) << bad;
    }
}

TEST(RangeTest, DescribesItself) {
    EXPECT_EQ(Range::greater_than(0).message(), "must be greater than 0");
    EXPECT_EQ(Range::between(0, 360).message(), "must be from 0 to 360");
    EXPECT_EQ(Range::greater_than(0, 5).message(), "must be greater than 0 and at most 5");
    EXPECT_FALSE(Range{}.contains(std::nan("")));
    EXPECT_FALSE(Range{}.contains(Range::unbounded));
}

TEST(Decimal, IsWrittenAsPeopleWriteIt) {
    EXPECT_EQ(format_number(100000), "100000");
    EXPECT_EQ(format_number(1e6), "1000000");
    EXPECT_EQ(format_number(19487.6, 4), "19490");
    EXPECT_EQ(format_number(1.23456e-12, 3), "1.23e-12");
    EXPECT_EQ(format_number(-0.001), "-0.001");
    EXPECT_EQ(format_number(0.1), "0.1");
    EXPECT_EQ(format_number(0), "0");
    EXPECT_EQ(format_number(1e300), "1e+300");
    EXPECT_EQ(format_number(1e-12), "1e-12");
}

TEST(Decimal, IsRoundedToDigitsDecimalsOrAStep) {
    EXPECT_EQ(rounded_to_digits(19487.6, 4), 19490.0);
    EXPECT_EQ(rounded_to_decimals(19487.648, 2), 19487.65);
    EXPECT_EQ(rounded_to_decimals(-0.0004, 3), 0.0);
    for (const auto& [value, step] :
         {std::pair{0.99, 0.5}, std::pair{1.0, 1.0}, std::pair{4.99, 2.0}, std::pair{5.0, 5.0},
          std::pair{999.0, 500.0}, std::pair{0.03, 0.02}}) {
        EXPECT_DOUBLE_EQ(round_step(value), step) << value;
    }
}

}  // namespace
}  // namespace ravnoves
