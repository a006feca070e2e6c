#include "case-file/json_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <limits>
#include <random>

#include "case-file/json.h"
#include "case-file/text_file.h"

namespace ravnoves {
namespace {

void expect_as_dumped(const Json& value) {
    EXPECT_EQ(json_text(value, 2), value.dump(2));
    EXPECT_EQ(json_text(value, 0), value.dump(0));
    EXPECT_EQ(json_text(value, -1), value.dump());
}

TEST(JsonText, IsWhatTheLibraryWrites) {
    expect_as_dumped(
        {{"empty", Json::object()},
         {"none", Json::array()},
         {"null", nullptr},
         {"truth", {true, false}},
         {"whole",
          {0, -1, std::numeric_limits<std::int64_t>::min(),
           std::numeric_limits<std::uint64_t>::max()}},
         {"words", {"", "plain", "α \"b\" \\ \n \t \x01 \x7f", "Уравновешивание"}},
         {"ключ \"\n", {{"deeper", {{{"a", 1}}, Json::array({Json::array()})}}}},
         {"no number",
          {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}}});
    for (const auto& file : std::filesystem::directory_iterator(RAVNOVES_EXAMPLES)) {
        expect_as_dumped(Json::parse(read_text_file(file.path())));
    }
}

TEST(JsonText, WritesEveryDouble) {
    std::mt19937_64 generator(3);
    Json numbers = {0.0, -0.0, 1.0, 1e15, 1e16, 1e-4, 1e-5, 0.1, 5e-324, 1.7976931348623157e308};
    for (int i = 0; i < 20'000; ++i) {
        const auto any = std::bit_cast<double>(generator());
        numbers.push_back(std::isfinite(any) ? any : 1.0);
        numbers.push_back(std::ldexp(static_cast<double>(generator() >> 11U), i % 120 - 90));
    }
    EXPECT_EQ(json_text(numbers, -1), numbers.dump());
}

TEST(JsonText, TextThatIsNotUtf8IsRefusedOrMended) {
    const Json value = {{"a", "\xff!"}};
    EXPECT_THROW(json_text(value, -1), Json::type_error);
    EXPECT_EQ(json_text(value, -1, true), "{\"a\":\"\xEF\xBF\xBD!\"}");
}

}  // namespace
}  // namespace ravnoves
