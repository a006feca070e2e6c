#include "case-file/result_json.h"

#include <gtest/gtest.h>

#include "case-file/json.h"
#include "case-file/verdict.h"
#include "error_of.h"

namespace ravnoves {
namespace {

TEST(Wanted, NothingSaidIsAll) {
    const Json result = {{"a", {{"b", 1}}}, {"c", 2}};
    EXPECT_TRUE(Wanted().wants("/a/b"));
    EXPECT_EQ(Wanted().pick(result), result);
}

TEST(Wanted, AsksForWhatIsAroundAndWithin) {
    const Wanted wanted({"/a/b", "/list/2/x"});
    for (const char* pointer : {"/a", "/a/b", "/a/b/c", "/list", "/list/2", "/list/2/x"}) {
        EXPECT_TRUE(wanted.wants(pointer)) << pointer;
    }
    for (const char* pointer : {"/a/bc", "/a/c", "/ab", "/list/1", "/b"}) {
        EXPECT_FALSE(wanted.wants(pointer)) << pointer;
    }
}

TEST(Wanted, PicksValuesWholeUnderTheirOwnPaths) {
    const Json result = {{"a", {{"b", 1}, {"c", {1, 2, 3}}}}, {"a/b", 5}, {"d", 4}};
    EXPECT_EQ(Wanted({"/a/c", "/a~1b"}).pick(result),
              (Json{{"a", {{"c", {1, 2, 3}}}}, {"a/b", 5}}));
    EXPECT_EQ(Wanted({"/a/c/1", "/a", "/a~1b", "/a/c"}).pick(result),
              (Json{{"a", result["a"]}, {"a/b", 5}}));
    EXPECT_EQ(Wanted({"/a/c/1", "/a/c/2"}).pick(result),
              (Json{{"a", {{"c", {{"1", 2}, {"2", 3}}}}}}));
}

TEST(Wanted, SaysInOneShortLineWhatIsNotThere) {
    for (const std::string& pointer :
         {std::string("/a\nb"), std::string("/\xff"), "/" + std::string(120'000, 'x')}) {
        try {
            Wanted({pointer}).pick({{"a", 1}});
            FAIL();
        } catch (const InputError& error) {
            EXPECT_LE(error.where().size(), 100U);
            EXPECT_EQ(error.where().find('\n'), std::string::npos);
            EXPECT_NO_THROW(Json(error.where()).dump()) << "is UTF-8";
        }
    }
}

TEST(Wanted, RejectsWhatIsNoPointerOrNotThere) {
    for (const char* pointer : {"", "a", "/~2"}) {
        EXPECT_THROW(Wanted({pointer}), InputError) << pointer;
    }
    for (const std::string pointer : {"/a/x", "/list/7", "/list/01", "/list/x"}) {
        const Json result{{"a", {{"b", 1}}}, {"list", {1, 2}}};
        EXPECT_TRUE(test::error_of([&] {
                        Wanted({pointer}).pick(result);
                    }).starts_with("/result" + pointer + ": "));
    }
}

TEST(Wanted, SentencesThatNoOneWantsAreNotBuilt) {
    int built = 0;
    const auto visited = [&](const Wanted& wanted) {
        return result_json(wanted, VisitResults([&](ResultVisitor& visitor) {
                               visit_verdict(visitor, [&] {
                                   ++built;
                                   return Verdict{Severity::note, Text::tr("a")};
                               });
                               visitor.texts(result_field::notes, [&] {
                                   ++built;
                                   return std::vector<Message>{Text::tr("b")};
                               });
                               visitor.flag(result_field::feasible, true);
                           }));
    };
    EXPECT_EQ(visited(Wanted({"/feasible"})), (Json{{"feasible", true}}));
    EXPECT_EQ(built, 0);
    EXPECT_EQ(visited(Wanted({"/notes", "/verdict/text"})),
              (Json{{"verdict", {{"text", "a"}}}, {"notes", {"b"}}}));
    EXPECT_EQ(built, 2);
}

}  // namespace
}  // namespace ravnoves
