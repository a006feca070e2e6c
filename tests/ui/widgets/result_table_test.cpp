#include "widgets/result_table.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMenu>
#include <QScrollBar>
#include <QTimer>
#include <QtMath>
#include <cmath>
#include <random>

#include "events.h"
#include "text/number_text.h"
#include "text/text_width.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

TEST(ResultTableWithReference, ShowsNamesAndDifferencesWithoutScrolling) {
    ResultTable table;
    const auto sized = [](double size) {
        return Results{{u"Quantity"_s, u"Value"_s, u"Unit"_s},
                       {{u"First order's share of Mup"_s, {26.3, u"26.3"_s}, u"%"_s},
                        {u"Envelope, width × height"_s,
                         ResultCell::two(u"%1 × %2"_s, {size, QString::number(size)},
                                         {size + 68, QString::number(size + 68)}),
                         u"mm"_s}}};
    };
    const Results reference = sized(223.0);
    table.setResults(sized(196.0));
    table.showReference(&reference, u"A"_s);
    for (int width = 340; width < 700; width += 10) {
        test::showAt(table, {width, 200});
        EXPECT_LE(table.horizontalHeader()->length(), table.viewport()->width()) << width;
        EXPECT_GE(table.columnWidth(0), textWidth(table.font(), table.item(0, 0)->text())) << width;
    }
    EXPECT_EQ(table.columnCount(), 3);
}

TEST(ResultTable, ColumnsOfWordsGiveWayToNumbersTogether) {
    ResultTable table;
    table.stretchColumn(1);
    const QString words(40, QLatin1Char('m'));
    table.setResults({{u"Place"_s, u"Quantity"_s, u"Value"_s}, {{words, words, {1.0, u"1.0"_s}}}});
    test::showAt(table, {400, 120});
    EXPECT_NEAR(table.columnWidth(0), table.columnWidth(1), 2);
    EXPECT_LE(table.horizontalHeader()->length(), table.viewport()->width());
}

TEST(ResultTableWithReference, ShowsItsVerdictWhereThereIsLittleRoom) {
    ResultTable table;
    const auto scaled = [](double by) {
        ResultRow row{u"range"_s};
        for (const double value : {623.1, 522.1, 644.3}) {
            row << ResultCell(by * value, QString::number(by * value, 'f', 1));
        }
        row << ResultCell(u"50.4\u00A0% better"_s);
        return Results{{u"N·m"_s, u"Mup"_s, u"Ms"_s, u"Mups"_s, u"change"_s}, {row}};
    };
    const Results reference = scaled(1.0);
    table.setResults(scaled(0.8));
    table.showReference(&reference, u"A"_s);
    test::showAt(table, {600, 160});
    const int plenty = table.verticalHeader()->defaultSectionSize();
    test::showAt(table, {310, 160});
    // Absolute differences and percents stand below each other there.
    EXPECT_GT(table.verticalHeader()->defaultSectionSize(), plenty);
    EXPECT_LE(table.horizontalHeader()->length(), table.viewport()->width());
    EXPECT_FALSE(table.horizontalScrollBar()->isVisible());
}

TEST(ColumnsOfResultTable, GrowForWhatDoesNotFitAlone) {
    ResultTable table;
    table.setColumns({u"Quantity"_s, u"Value"_s, u"Unit"_s});
    const auto show = [&](const QString& value) {
        table.setRows({ResultRow{u"Moment"_s, value, u"N·m"_s}});
        return table.columnWidth(1);
    };
    show(u"−123.45"_s);
    test::showAt(table, {400, 80});
    const int width = show(u"123.45"_s);
    EXPECT_EQ(show(u"−123.45"_s), width);
    EXPECT_EQ(show(u"1.5"_s), width);
    const QString longest = u"−1234567.8901"_s;
    EXPECT_GT(show(longest), width);
    EXPECT_GE(table.columnWidth(1), qCeil(textWidth(table.font(), longest)));
    EXPECT_EQ(table.item(0, 1)->text(), longest);
}

TEST(ColumnsOfResultTable, FillTheTableWhateverTheNumbers) {
    std::mt19937 random(3);
    const auto number = [&] {
        const double size = std::pow(10.0, std::uniform_real_distribution(-2.0, 6.0)(random));
        return fixedDecimals(random() % 2 == 0 ? size : -size, 1, QLocale());
    };
    const auto rows = [&] {
        ResultRows rows;
        for (const QString& name : {u"range"_s, u"RMS"_s, u"by nodes"_s, u"mean"_s}) {
            ResultRow row{name};
            for (int column = 1; column < 4; ++column) {
                const QString shown = number();
                row << ResultCell(readFormNumber(shown).value_or(0.0), shown);
            }
            row << ResultCell(number() + u"\u00A0% better"_s);
            rows << row;
        }
        return rows;
    };
    for (const bool compared : {false, true}) {
        for (const int width : {260, 330, 420}) {
            ResultTable table;
            const ResultColumns columns{u"N·m"_s, u"Mup"_s, u"Ms"_s, u"Mups"_s, u"change"_s};
            const Results reference{columns, rows()};
            table.setResults({columns, rows()});
            if (compared) {
                table.showReference(&reference, u"A"_s);
            }
            test::showAt(table, {width, 200});
            for (int step = 0; step < 200; ++step) {
                table.setRows(rows());
                if (step % 3 == 0) {
                    table.resize(width + static_cast<int>(random() % 40),
                                 90 + static_cast<int>(random() % 160));
                }
                QApplication::processEvents();
                ASSERT_GE(table.horizontalHeader()->length(), table.viewport()->width())
                    << compared << width << ' ' << step;
                for (int row = 0; row < table.rowCount(); ++row) {
                    for (int column = 1; column < table.columnCount(); ++column) {
                        ASSERT_LE(textWidth(table.font(), table.item(row, column)->text()),
                                  table.columnWidth(column));
                    }
                }
            }
        }
    }
}

/// A bar at the side takes room from the columns, and one below from the rows.
TEST(WideResultTable, TwoScrollBarsThatWouldCallForOneAnotherComeToAnEnd) {
    ResultTable table;
    table.setColumns({u"Quantity"_s, u"Value"_s, u"Unit"_s});
    table.horizontalHeader()->hide();
    ResultRows rows;
    for (int row = 0; row < 14; ++row) {
        rows << ResultRow{u"Moment error from 70.5 µm"_s, u"34996.54 (23863.6 %)"_s, u"N·m"_s};
    }
    const int height = [&] {
        table.setRows(rows);
        return table.verticalHeader()->length();
    }();
    for (int width = 250; width < 350; ++width) {
        for (const int below : {0, 16}) {  // with room for a bar, and without
            test::showAt(table, {width, height + below});
            for (const QString& value : {u"1"_s, u"34996.54 (23863.6 %)"_s, u"1"_s}) {
                rows[4][1] = ResultCell(value);
                table.setRows(rows);
            }
        }
    }
    QApplication::processEvents();
    EXPECT_EQ(table.rowCount(), 14);
}

TEST(WideResultTable, NamesThatBeginAlikeAreDistinguishable) {
    ResultTable table;
    table.setColumns({u"Option"_s, u"constant, g"_s, u"slope"_s, u"limit, g"_s, u"remove, g"_s});
    table.setRows(
        {{u"(✗) New crankshaft, plugs of steel"_s, u"1.5"_s, u"2"_s, u"3"_s, u"4"_s},
         {u"(✗) New crankshaft, plugs of aluminium"_s, u"1.5"_s, u"2"_s, u"3"_s, u"4"_s}});
    test::showAt(table, {330, 120});
    const QFontMetrics metrics(table.font());
    EXPECT_GT(table.columnWidth(0), metrics.horizontalAdvance(u"(✗) New crankshaf"_s));
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

TEST(ResultTableWithReference, EveryCellSaysWhatItIs) {
    ResultTable table;
    const auto force = [](double value) {
        return ResultRow{{u"Force"_s, {value, QString::number(value)}}, u"what it is"_s};
    };
    const Results results{{u"Quantity"_s, {u"Value, N"_s, u"of this input"_s}}, {force(1.5)}};
    table.setResults(results);
    table.showReference(&results, u"A"_s);
    test::showAt(table, {600, 120});
    table.setRows({force(2.5)});
    table.setRows({force(3.5)});
    EXPECT_EQ(table.item(0, 0)->toolTip(), u"what it is"_s);
    const QString tip = table.item(0, 1)->toolTip();
    EXPECT_TRUE(tip.startsWith(u"what it is\nof this input"_s)) << tip.toStdString();
    EXPECT_TRUE(tip.endsWith(u"reference A"_s)) << tip.toStdString();
    EXPECT_EQ(table.horizontalHeaderItem(1)->toolTip(), u"of this input"_s);
}

TEST(NarrowResultTable, HeadingsGoOnASecondLineBeforeItScrolls) {
    ResultTable table;
    table.setColumns({u"Quantity"_s, u"without shaft, N·m"_s, u"with shaft, N·m"_s});
    table.setRows({{u"Largest moment"_s, u"1208.0"_s, u"1082.4"_s}});
    test::showAt(table, {600, 120});
    const int oneLine = table.horizontalHeader()->height();
    test::showAt(table, {310, 120});
    EXPECT_LE(table.horizontalHeader()->length(), table.viewport()->width());
    EXPECT_GT(table.horizontalHeader()->height(), oneLine);
    test::showAt(table, {600, 120});
    EXPECT_EQ(table.horizontalHeader()->height(), oneLine);
}

TEST(CopiedResultTable, IsTheWholeUnlessCellsAreSelected) {
    ResultTable table;
    table.setColumns({u"Quantity"_s, u"Value"_s, u"Unit"_s});
    table.setRows({{u"Force"_s, u"−1.5"_s, u"N"_s}, {u"Moment"_s, u"2"_s, u"N·m"_s}});
    test::showAt(table, {400, 120});
    const auto copied = [&] {
        QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
        return QApplication::clipboard()->text();
    };
    const QString whole = u"Quantity\tValue\tUnit\nForce\t-1.5\tN\nMoment\t2\tN·m\n"_s;
    EXPECT_EQ(copied(), whole);
    table.setCurrentCell(0, 1);
    EXPECT_EQ(copied(), whole);
    table.setRangeSelected({0, 1, 1, 1}, true);
    EXPECT_EQ(copied(), u"-1.5\n2\n"_s);
    // The menu copies one cell, too.
    table.clearSelection();
    table.item(1, 1)->setSelected(true);
    QTimer::singleShot(0, &table, [] {
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        ASSERT_NE(menu, nullptr);
        EXPECT_TRUE(menu->actions().at(0)->isEnabled());
        menu->actions().at(0)->trigger();
        menu->close();
    });
    QContextMenuEvent press(QContextMenuEvent::Keyboard, {}, table.mapToGlobal(QPoint()));
    QApplication::sendEvent(table.viewport(), &press);
    EXPECT_EQ(QApplication::clipboard()->text(), u"2\n"_s);
    // Of what is shown; powers of ten as spreadsheets read them.
    table.setRows(
        {{u"10 runs"_s, u"−3.2·10⁻⁷"_s, u"10⁶"_s}, {u"10⁻⁶°"_s, u"< 10⁻¹² N"_s, u"N·m"_s}});
    table.setColumnHidden(2, true);
    EXPECT_EQ(table.asText(), u"Quantity\tValue\n10 runs\t-3.2e-7\n1e-6°\t< 1e-12 N\n"_s);
    EXPECT_EQ(table.asCsv(), u"Quantity,Value\n10 runs,-3.2e-7\n1e-6°,< 1e-12 N\n"_s);
}

TEST(SpreadResultTable, NeitherSideSaysMoreDigitsThanTheOtherBears) {
    ResultTable table;
    table.setColumns({u"Quantity"_s, u"Value"_s});
    const struct {
        const char16_t* value;
        double below, above;
        const char16_t* shown;
        const char16_t* spread;
    } rows[] = {
        {u"0.145", 0.0123, 0.0123, u"0.145", u"± 0.012"},
        {u"0.145", 0.00123, 0.00123, u"0.145", u"± 0.0012"},
        {u"0.145", 0.000123, 0.000123, u"0.145", u"± 0.0001"},
        {u"0.145", 0.0000123, 0.0000123, u"0.145", u""},
        {u"0.145", 0.00001, 0.0123, u"0.145", u"+0.012 −0"},
        {u"1066.746", 35.0, 35.0, u"1067", u"± 35"},
        {u"1066.746", 0.35, 0.35, u"1066.75", u"± 0.35"},
        {u"1066.746", 0.0035, 0.0035, u"1066.746", u"± 0.0035"},
    };
    for (const auto& [value, below, above, shown, spread] : rows) {
        const QString text = QString::fromUtf16(value);
        table.setRows({ResultRow{u"Force"_s, {text.toDouble(), text}}});
        table.setSpreads({{0, 1, u"Force"_s, below, above}});
        EXPECT_EQ(table.item(0, 1)->text(), QString::fromUtf16(shown)) << below;
        EXPECT_EQ(table.spreadAt(0, 1), QString::fromUtf16(spread)) << above;
        table.setSpreads({});
        EXPECT_EQ(table.item(0, 1)->text(), text);
    }
}

TEST(SpreadResultTable, PutsItsSidesBelowEachOtherBeforeItScrolls) {
    ResultTable table;
    table.setColumns({u"N"_s, u"exact"_s, u"two-term"_s, u"diff."_s});
    const ResultCell value(0.0001431, u"0.0001431"_s);
    table.setRows({ResultRow{u"The sixth order's force"_s, value, value, value}});
    std::vector<CellSpread> spreads;
    for (const int column : {1, 2, 3}) {
        spreads.push_back({0, column, table.item(0, 0)->text(), 0.00000031, 0.00000052});
    }
    table.setSpreads(spreads);
    for (const int width : {900, 380}) {
        test::showAt(table, {width, 160});
        EXPECT_LE(table.horizontalHeader()->length(), table.viewport()->width()) << width;
    }
}

}  // namespace
}  // namespace ravnoves
