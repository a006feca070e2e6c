#include "widgets/result_table.h"

#include <gtest/gtest.h>

#include <QHeaderView>

#include "events.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class ResultTableTest : public ::testing::Test {
  protected:
    ResultTableTest() {
        for (ResultTable* each : {&table, &reference}) {
            each->setColumns({u"Quantity"_s, u"Value, N"_s});
            each->setTips({{u"Force"_s, u"what it is"_s}, {u"Value, N"_s, u"of this input"_s}});
            each->setRows({{u"Force"_s, u"1.5"_s}});
        }
        table.setReference(&reference, u"A"_s);
    }
    void show(const QString& value) { table.setRows({{u"Force"_s, value}}); }
    bool differencesInColumns() const { return table.columnCount() == 4; }

    ResultTable reference;
    ResultTable table;
};

TEST_F(ResultTableTest, ValuesThatMoveAtOneWidthLayItOutOnce) {
    const QString longer = u"123456789012345678901234567890.5"_s;
    int width = 200;
    for (; width < 600; width += 10) {
        show(u"2.5"_s);
        test::showAt(table, {width, 120});
        if (!differencesInColumns()) {
            continue;
        }
        show(longer);
        if (!differencesInColumns()) {
            break;  // a width where the long one has no room and the short one has
        }
    }
    ASSERT_LT(width, 600);
    const int height = table.verticalHeader()->defaultSectionSize();
    show(u"2.5"_s);
    EXPECT_FALSE(differencesInColumns());
    EXPECT_EQ(table.verticalHeader()->defaultSectionSize(), height);
    // Another width is another layout.
    test::showAt(table, {width + 1, 120});
    EXPECT_TRUE(differencesInColumns());
}

TEST(WideResultTable, NamesThatBeginAlikeAreToldApart) {
    ResultTable table;
    table.setColumns({u"Option"_s, u"constant, g"_s, u"slope"_s, u"limit, g"_s, u"remove, g"_s});
    table.setRows(
        {{u"(✗) New crankshaft, plugs of steel"_s, u"1.5"_s, u"2"_s, u"3"_s, u"4"_s},
         {u"(✗) New crankshaft, plugs of aluminium"_s, u"1.5"_s, u"2"_s, u"3"_s, u"4"_s}});
    test::showAt(table, {330, 120});
    const QFontMetrics metrics(table.font());
    EXPECT_GT(table.columnWidth(0), metrics.horizontalAdvance(u"(✗) New crankshaf"_s));
    EXPECT_FALSE(table.wordWrap());
}

TEST(WideResultTable, ASlipOfTheKeysLeavesNoScrollBar) {
    ResultTable table;
    table.setColumns({u"N·m"_s, u"Mup"_s, u"Ms"_s, u"change"_s});
    const auto isTooWide = [&](const QString& value) {
        table.setRows({{u"range"_s, value, value, value}});
        return table.horizontalHeader()->length() > table.viewport()->width();
    };
    test::showAt(table, {330, 120});
    EXPECT_FALSE(isTooWide(u"1208.0"_s));
    EXPECT_TRUE(isTooWide(u"1234567890123456789012345.0"_s));
    EXPECT_FALSE(isTooWide(u"1208.0"_s));
}

TEST_F(ResultTableTest, EveryCellSaysWhatItIs) {
    test::showAt(table, {600, 120});
    show(u"2.5"_s);
    show(u"3.5"_s);
    ASSERT_TRUE(differencesInColumns());
    EXPECT_EQ(table.item(0, 0)->toolTip(), u"what it is"_s);
    EXPECT_EQ(table.item(0, 1)->toolTip(), u"what it is\nof this input"_s);
    EXPECT_EQ(table.horizontalHeaderItem(1)->toolTip(), u"of this input"_s);
    for (const int column : {2, 3}) {
        const QString tip = table.horizontalHeaderItem(column)->toolTip();
        EXPECT_TRUE(tip.contains(u"reference A"_s)) << tip.toStdString();
        EXPECT_EQ(table.item(0, column)->toolTip(), tip);
    }
}

}  // namespace
}  // namespace ravnoves
