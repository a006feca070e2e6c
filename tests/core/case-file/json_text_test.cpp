#include "case-file/json_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "case-file/json.h"

namespace ravnoves {
namespace {

std::string in_lines(const Json& value) {
    return json_text(value, JsonLayout::lines);
}
std::string in_one_line(const Json& value) {
    return json_text(value, JsonLayout::one_line);
}

TEST(JsonText, IsThatOfTheLibrary) {
    const Json document = Json::parse(R"({
        "title": "Равновес \"V-8\"\n\u0001\\", "empty": {}, "none": [], "null": null,
        "truth": [true, false], "deep": {"a": [{"b": [1, -2, 18446744073709551615]}]},
        "key \"quoted\"": "", "numbers": [0.0, -0.0, 1.0, -1.5, 100000.0, 123456.789,
        1e14, 123456789012345.0, 1e15, 1.5e15, 1e22, 1.7976931348623157e308, 5e-324, 0.1, 0.001,
        0.00012345, 0.0001, 0.00001, 1.25e-7, -9.80665e-10]})");
    EXPECT_EQ(in_lines(document), document.dump(2));
    EXPECT_EQ(in_one_line(document), document.dump());
    for (const Json& alone : {Json(), Json(2.5), Json("text"), Json::array(), Json(true)}) {
        EXPECT_EQ(in_lines(alone), alone.dump(2));
    }
}

TEST(JsonText, DeepAndLongValuesAreThoseOfTheLibrary) {
    Json deep = 1.5;
    for (int i = 0; i < 200; ++i) {
        deep = i % 2 == 0 ? Json{{"a", i}, {"deeper", deep}, {"z", -i}} : Json{i, deep, "z"};
    }
    EXPECT_EQ(in_lines(deep), deep.dump(2));
    EXPECT_EQ(in_one_line(deep), deep.dump());
    const Json longer = {std::string(100'000, 'x'), std::string(40'000, '"'), deep};
    EXPECT_EQ(in_lines(longer), longer.dump(2));
}

TEST(JsonText, NumbersOfEverySizeReadBackAndTakeNoMoreDigits) {
    std::mt19937_64 random(20);
    std::size_t different = 0;
    constexpr int count = 100'000;
    for (int i = 0; i < count; ++i) {
        const auto value = std::bit_cast<double>(random());
        if (!std::isfinite(value)) {
            continue;
        }
        const std::string text = in_one_line(value);
        const std::string librarys = Json(value).dump();
        ASSERT_EQ(std::bit_cast<std::uint64_t>(Json::parse(text).get<double>()),
                  std::bit_cast<std::uint64_t>(value))
            << text;
        ASSERT_LE(text.size(), librarys.size()) << text << ' ' << librarys;
        different += text != librarys ? 1 : 0;
    }
    // The library's way misses the shortest or the nearest text of a few in a thousand.
    EXPECT_LT(different, count / 100);
}

TEST(JsonText, WhatJsonCannotHoldIsAsTheLibraryHasIt) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const Json numbers = {infinite, -infinite, std::nan("")};
    EXPECT_EQ(in_one_line(numbers), "[null,null,null]");
    const Json bytes = "ab\xFF\xC3";
    EXPECT_EQ(in_lines(bytes), bytes.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace
}  // namespace ravnoves
