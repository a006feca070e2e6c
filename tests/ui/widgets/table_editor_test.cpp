#include "widgets/table_editor.h"

#include <gtest/gtest.h>

namespace ravnoves {
namespace {

std::vector<QStringList> read(const char* text) {
    return readTextTable(QString::fromUtf8(text));
}

TEST(TextTable, TakesTabsAndSemicolons) {
    const std::vector<QStringList> cells{{QStringLiteral("0"), QStringLiteral("1,5")},
                                         {QStringLiteral("-3"), QStringLiteral("2.5")}};
    EXPECT_EQ(read("0\t1,5\r\n-3\t2.5\r\n"), cells);
    EXPECT_EQ(read("0; 1,5\n\n-3 ;2.5"), cells);
    EXPECT_TRUE(read(" \n").empty());
}

TEST(TextTable, PassesOverAHeader) {
    EXPECT_EQ(read("z, mm\tβ\n1\t2\n").size(), 1U);
    EXPECT_EQ(read("\n;;\n1;2\n").size(), 1U);
    // One line of words alone is no header, and neither is a line with a number in it.
    EXPECT_EQ(read("a\tb\n").size(), 1U);
    EXPECT_EQ(read("a\t1\n2\t3\n").size(), 2U);
    // Nor one with a slip in it: what follows would move up.
    EXPECT_EQ(read("56O,1\n562,2\n").size(), 2U);
    EXPECT_EQ(read("1.562,1\n562,2\n").size(), 2U);
}

// A message that quotes it would take a minute to be laid out.
TEST(TextTable, CutsACellThatNoNumberIsAsLongAs) {
    const auto rows = readTextTable(QString(1'000'000, u'7') + QStringLiteral("\t1"));
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0][0], QString(1000, u'7') + QChar(0x2026));
    EXPECT_EQ(rows[0][1], QStringLiteral("1"));
}

TEST(TextTable, KeepsGapsWhereTheyMeanSomething) {
    const auto rows = readTextTable(QStringLiteral("Pin, g\n151\n\n153\n\n"), EmptyLine::gap);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[1].join(QString()), QString());
    EXPECT_EQ(rows[2], QStringList{QStringLiteral("153")});
    EXPECT_EQ(readTextTable(QStringLiteral("\n152\n"), EmptyLine::gap).size(), 2U);
}

TEST(TextTable, ThousandsAreNotTakenForDecimals) {
    EXPECT_EQ(mixedDecimalSigns(read("0.5\t1,893\n2\t3\n")),
              QStringLiteral("Not pasted: “1,893” has a comma, “0.5” a point. Use one decimal sign "
                             "and no thousands separators."));
    for (const char* table : {"0,5\t1,893\n", "0.5\t1,89\n", "0.5\t0,893\n", "1.5\t1893\n",
                              "1,893 g\t0,5\n", "a.b\t1,893\n"}) {
        EXPECT_EQ(mixedDecimalSigns(read(table)), QString()) << table;
    }
}

}  // namespace
}  // namespace ravnoves
