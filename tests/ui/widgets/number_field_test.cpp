#include "widgets/number_field.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QSignalSpy>
#include <cstdlib>
#include <numbers>
#include <random>

#include "error_of.h"
#include "events.h"
#include "processor_time.h"
#include "text/language.h"
#include "text/number_text.h"
#include "text/typed_number.h"
#include "widgets/value_slider.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class NumberFieldTest : public ::testing::Test {
  protected:
    NumberFieldTest() {
        field.setRange(Range::greater_than(0, 100), QStringLiteral("mm"));
        field.setValue(46.0);
        field.setGeometry(0, 0, 120, 30);
        test::showAt(box, {120, 80});
        box.activateWindow();
        field.setFocus();
        field.selectAll();
    }

    QWidget box;
    NumberField field{&box};
};

/// 35 stood there: 1 makes 1 of it, not 135.
TEST_F(NumberFieldTest, AClickThatGivesTheFocusSelectsAllAndTheNextSetsTheCursor) {
    field.clearFocus();
    field.setValue(35.0);
    const auto click = [&] {
        QTest::mouseClick(&field, Qt::LeftButton, {}, {field.width() - 6, 12});
    };
    click();
    EXPECT_EQ(field.selectedText(), QStringLiteral("35"));
    QTest::keyClicks(&field, QStringLiteral("1"));
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_EQ(field.value(), 1.0);
    click();
    EXPECT_FALSE(field.hasSelectedText());
    QTest::keyClicks(&field, QStringLiteral("2"));
    EXPECT_EQ(field.value(), 12.0);
    // What the hand selects stays selected.
    field.clearFocus();
    field.setValue(35.5);
    const QPoint from(field.width() - 6, 12);
    const QPoint to = from - QPoint(field.fontMetrics().horizontalAdvance(QLatin1Char('5')), 0);
    test::drag(&field, from, to, 1);
    EXPECT_LT(field.selectedText().size(), 4);
    EXPECT_TRUE(field.hasSelectedText());
}

TEST_F(NumberFieldTest, ABlankTextThatWasRejectedIsReadOnceItIsAllowed) {
    QSignalSpy edited(&field, &NumberField::valueEdited);
    const auto give = [&](const QString& text) {
        field.setText(text);
        Q_EMIT field.textEdited(text);
        QTest::keyClick(&field, Qt::Key_Return);
        EXPECT_FALSE(field.trouble().isEmpty());
    };
    const auto allow = [&] {
        field.setOptional(true);
        QApplication::processEvents();
    };
    give(QStringLiteral("4x"));
    allow();
    EXPECT_FALSE(field.trouble().isEmpty());
    field.setOptional(false);
    give({});
    EXPECT_EQ(field.value(), 46.0);
    EXPECT_EQ(edited.count(), 0);
    allow();
    EXPECT_EQ(field.trouble(), QString());
    EXPECT_EQ(field.value(), std::nullopt);
    EXPECT_EQ(edited.count(), 1);
}

/// A table that was copied for another program.
TEST_F(NumberFieldTest, APastedMegabyteIsCutAndSaidSo) {
    QApplication::clipboard()->setText(QString(1'000'000, QLatin1Char('7')));
    const test::ProcessorTime time;
    QTest::keyClick(&field, Qt::Key_V, Qt::ControlModifier);
    EXPECT_LT(time.seconds(), 1.0);
    EXPECT_LE(field.text().size(), 1000);
    EXPECT_FALSE(field.said().isEmpty());
    EXPECT_EQ(field.value(), 46.0);
    QTest::keyClick(&field, Qt::Key_Escape);
    EXPECT_EQ(field.text(), QStringLiteral("46"));
    EXPECT_EQ(field.said(), QString());
}

TEST_F(NumberFieldTest, WhatIsShownShortHasItsWholeText) {
    EXPECT_EQ(field.wholeText(), QString());
    QTest::keyClicks(&field, QStringLiteral("12.3456789012345"));
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_EQ(field.text(), QStringLiteral("12.3456789"));
    EXPECT_EQ(field.wholeText(), QStringLiteral("12.3456789012345"));
    field.clearFocus();
    EXPECT_EQ(field.value(), 12.3456789012345);
}

TEST_F(NumberFieldTest, ArrowsGoToTheNextWholeNumber) {
    QTest::keyClick(&field, Qt::Key_Up);
    EXPECT_EQ(field.value(), 46.0);  // what is no whole number has no next
    field.setWhole(true);
    QSignalSpy edited(&field, &NumberField::valueEdited);
    QTest::keyClick(&field, Qt::Key_Up);
    QTest::keyClick(&field, Qt::Key_Up);
    EXPECT_EQ(field.value(), 48.0);
    EXPECT_EQ(edited.size(), 2);
    EXPECT_TRUE(field.isEditing());
    QTest::keyClick(&field, Qt::Key_Escape);
    EXPECT_EQ(field.value(), 46.0);
    field.setValue(1.0);
    QTest::keyClick(&field, Qt::Key_Down);  // 0 is not in the range
    EXPECT_EQ(field.value(), 1.0);
    EXPECT_EQ(field.text(), QStringLiteral("1"));
}

TEST_F(NumberFieldTest, RejectsInWordsAndKeepsTheLastValue) {
    QSignalSpy edited(&field, &NumberField::valueEdited);
    QTest::keyClicks(&field, QStringLiteral("-3"));
    EXPECT_EQ(field.value(), 46.0);
    EXPECT_EQ(field.trouble(),
              QStringLiteral("The value must be greater than 0 and at most 100\u00A0mm."));
    EXPECT_TRUE(edited.isEmpty());
    // A valid beginning ("10" of "101") shows its effect, but does not count.
    for (const char* bad : {"nan", "inf", "1e999", "abc", "1 2", "0", "101", "56.7.1"}) {
        test::typeOver(&field, QString::fromLatin1(bad));
        EXPECT_FALSE(field.trouble().isEmpty()) << bad;
        EXPECT_EQ(field.value(), 46.0) << bad;
    }
    EXPECT_EQ(edited.last().at(0).value<std::optional<double>>(), 46.0);
}

TEST_F(NumberFieldTest, RejectedTextStaysUntilAnotherValueIsSet) {
    QLineEdit other(&box);
    other.setGeometry(0, 40, 120, 30);
    other.show();
    QTest::keyClicks(&field, QStringLiteral("56.7.1"));
    QTest::mouseClick(&other, Qt::LeftButton);
    ASSERT_TRUE(other.hasFocus());
    field.setValue(46.0);  // as a model does whenever something changed
    EXPECT_EQ(field.text(), QStringLiteral("56.7.1"));
    EXPECT_FALSE(field.trouble().isEmpty());
    QTest::mouseClick(&field, Qt::LeftButton);
    QTest::keyClick(&field, Qt::Key_Escape);
    EXPECT_EQ(field.text(), QStringLiteral("46"));
    EXPECT_TRUE(field.trouble().isEmpty());
    test::typeOver(&field, QStringLiteral("x"));
    field.setValue(47.0);
    EXPECT_EQ(field.text(), QStringLiteral("47"));
    EXPECT_TRUE(field.trouble().isEmpty());
}

TEST_F(NumberFieldTest, ACommaThatMayDivideThousandsIsAskedAbout) {
    field.setRange(Range::greater_than(0, 5000), QStringLiteral("mm"));
    QTest::keyClicks(&field, QStringLiteral("1,25"));
    EXPECT_EQ(field.value(), 1.25);
    QTest::keyClicks(&field, QStringLiteral("0"));
    EXPECT_EQ(field.value(), 46.0) << "neither 1250 nor 1.25";
    EXPECT_EQ(field.trouble(), QStringLiteral("“1,250” may be 1250 or 1.25: enter one of them."));
    QTest::keyClicks(&field, QStringLiteral("5"));
    EXPECT_EQ(field.value(), 1.2505) << "no thousands";
    // Also where only one of both is allowed.
    field.setRange(Range::between(100, 5000), QStringLiteral("mm"));
    test::typeOver(&field, QStringLiteral("3,600"));
    EXPECT_TRUE(field.trouble().contains(QStringLiteral("3600 or 3.6")))
        << qPrintable(field.trouble());
    // And of a mass at a lever.
    field.setRange(Range::between(0, 1e9), QStringLiteral("g·mm"));
    field.setLever([] { return std::optional(0.1); });
    test::typeOver(&field, QStringLiteral("1,450 g"));
    EXPECT_TRUE(field.trouble().contains(QStringLiteral("1450 or 1.45")))
        << qPrintable(field.trouble());
    for (const char* plain : {"0,125", "-0,125", "1250", "1.250", "1,2500", "1234,567"}) {
        EXPECT_TRUE(readTypedNumber(QString::fromLatin1(plain), {}).value) << plain;
    }
    const TypedNumber mass = readTypedNumber(QStringLiteral("−12,500 g"), QStringLiteral("kg"));
    EXPECT_FALSE(mass.value);
    EXPECT_TRUE(mass.trouble.contains(QStringLiteral("−12500 or −12.5")))
        << qPrintable(mass.trouble);
    installLanguage(QStringLiteral("ru"));
    EXPECT_EQ(readTypedNumber(QStringLiteral("1,250"), {}).value, 1.25);
    installLanguage(QStringLiteral("en"));
}

TEST(NumberText, HasThePointOfItsLanguageOnEveryDesktop) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");  // the desktop's is read once for a program
    qunsetenv("LC_ALL");
    qputenv("LANG", "en_US.UTF-8");
    qputenv("LC_NUMERIC", "de_DE.UTF-8");
    EXPECT_EXIT(
        {
            installLanguage();
            const bool isComma = QLocale::system().decimalPoint() == QStringLiteral(",");
            const bool isRead = readTypedNumber(QStringLiteral("1,450"), {}).value.has_value();
            std::_Exit(!isComma ? 1 : isRead ? 2 : 0);  // what Qt holds is no leak
        },
        testing::ExitedWithCode(0), "");
}

TEST_F(NumberFieldTest, EnterEndsAnEditing) {
    test::type(&field, QStringLiteral("12,50"));
    EXPECT_EQ(field.text(), QStringLiteral("12.5"));
    QTest::keyClick(&field, Qt::Key_Escape);
    EXPECT_EQ(field.value(), 12.5);
    EXPECT_FALSE(field.isEditing());
}

TEST_F(NumberFieldTest, WhatIsTypedAfterARejectedEnterTakesItsPlace) {
    QTest::keyClicks(&field, QStringLiteral("5 85"));
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_FALSE(field.trouble().isEmpty());
    QTest::keyClicks(&field, QStringLiteral("58.5"));
    EXPECT_EQ(field.text(), QStringLiteral("58.5"));
    EXPECT_EQ(field.value(), 58.5);
}

TEST_F(NumberFieldTest, OfATableThatIsPastedIntoAFieldTheBeginningIsQuoted) {
    QString table;
    for (int i = 0; i < 50; ++i) {
        table += QStringLiteral("%1 0.5 ").arg(i);
    }
    field.insert(table);
    EXPECT_TRUE(field.trouble().startsWith(QStringLiteral("“0 0.5 1 0.5")))
        << qPrintable(field.trouble());
    EXPECT_LT(field.trouble().size(), 80) << qPrintable(field.trouble());
}

TEST(NumberText, WritesWhatAPersonWants) {
    const QLocale english(QLocale::English);
    const QLocale russian(QLocale::Russian);
    EXPECT_EQ(formNumber(46.0, english), QStringLiteral("46"));
    EXPECT_EQ(formNumber(0.658, russian), QStringLiteral("0,658"));
    EXPECT_EQ(formNumber(3600.0, russian), QStringLiteral("3600"));
    EXPECT_EQ(writtenOut(3.9370079e-5, english, 6), QStringLiteral("0.0000393701"));
    EXPECT_EQ(writtenOut(-2e-5, russian), QStringLiteral("-0,00002"));
    EXPECT_EQ(writtenOut(1234567.0, english, 6), QStringLiteral("1234567"));
    EXPECT_EQ(writtenOut(1e-30, english), formNumber(1e-30, english));
    EXPECT_EQ(fixedNumber(-0.001, 2, english), QStringLiteral("0.00"));
    EXPECT_EQ(fixedNumber(0.01625 / 1e-3, 1, english), QStringLiteral("16.3"));
    EXPECT_EQ(fixedNumber(0.82315 / 1e-3, 1, english), QStringLiteral("823.2"));
    EXPECT_EQ(fixedNumber(1.5625, 3, english), QStringLiteral("1.563"));
    EXPECT_EQ(fixedNumber(-1.5, 1, english), QStringLiteral("\u22121.5"));
    EXPECT_EQ(fixedNumber(7.8357568328379722e26, 4, english), QStringLiteral("7.83576E+26"));
    EXPECT_EQ(fixedNumber(999999999.0, 1, english), QStringLiteral("999999999.0"));
    EXPECT_EQ(fixedNumber(std::nan(""), 1, english), QStringLiteral("–"));
    EXPECT_EQ(fixedNumber(-1234.5678, 2, russian), QStringLiteral("\u22121234,57"));
    EXPECT_EQ(fixedNumber(12.0, 0, russian), QStringLiteral("12"));
    EXPECT_EQ(fixedDecimals(2.5, 0, english), QStringLiteral("3"));
    EXPECT_EQ(fixedDecimals(-0.125, 2, english), QStringLiteral("\u22120.13"));
}

TEST(NumberText, FixedDecimalsAreThoseOfTheLocale) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> size(-9.0, 9.0);
    for (QLocale locale : {QLocale(QLocale::English), QLocale(QLocale::Russian),
                           QLocale(QLocale::Arabic, QLocale::Egypt)}) {
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        for (int i = 0; i < 4000; ++i) {
            // Halves of the last digit too, which are rounded away from nothing.
            const double value = i % 4 < 2
                                     ? (i - 2000) / 16.0
                                     : (i % 2 == 0 ? -1.0 : 1.0) * std::pow(10.0, size(random));
            const int decimals = i % 7;
            const double shown = std::round(value * std::pow(10.0, decimals)) == 0.0 ? 0.0 : value;
            ASSERT_EQ(fixedDecimals(value, decimals, locale),
                      trueMinus(locale.toString(shown, 'f', decimals)))
                << value << ' ' << decimals;
        }
    }
}

TEST(NumberText, AUnitThatIsTypedIsConverted) {
    const auto typed = [](const char16_t* text, const char16_t* unit) {
        return readTypedNumber(QString::fromUtf16(text), QString::fromUtf16(unit))
            .value.value_or(0.0);
    };
    EXPECT_NEAR(typed(u"300 rad/s", u"min⁻¹"), 300.0 * 30.0 / std::numbers::pi, 1e-9);
    EXPECT_NEAR(typed(u"850 kPa", u"bar"), 8.5, 1e-12);
    EXPECT_NEAR(typed(u"0,85 МПа", u"bar"), 8.5, 1e-12);
    EXPECT_NEAR(typed(u"60 N/mm", u"kN/m"), 60.0, 1e-12);
    EXPECT_NEAR(typed(u"60 Н/мм", u"N/m"), 60000.0, 1e-9);
    EXPECT_NEAR(typed(u"1 rad", u"°"), 180.0 / std::numbers::pi, 1e-12);
    EXPECT_NEAR(typed(u"90 град", u"rad"), std::numbers::pi / 2.0, 1e-12);
    EXPECT_DOUBLE_EQ(typed(u"1.5 kN", u"N"), 1500.0);
    EXPECT_DOUBLE_EQ(typed(u"1 250,5 g", u"g"), 1250.5);
    EXPECT_DOUBLE_EQ(typed(u"\u22121\u202F250\u00A0000", u"N"), -1250000.0);
    EXPECT_FALSE(readTypedNumber(QStringLiteral("12 50"), QStringLiteral("g")).value);
    EXPECT_NEAR(typed(u"10 lb·ft", u"N·m"), 13.558179, 1e-6);
    // Of balancing machines, as their papers and people write them.
    for (const char16_t* unit : {u"g·mm", u"г·мм"}) {
        for (const char16_t* text : {u"85 g·cm", u"85 г·см", u"85 гсм", u"85 г*см", u"85 г×см",
                                     u"85 g cm", u"85гсм", u"0.85 г·м", u"0,85 кг·мм"}) {
            EXPECT_DOUBLE_EQ(typed(text, unit), 850.0) << QString::fromUtf16(text).toStdString();
        }
        EXPECT_NEAR(typed(u"1.2 oz·in", unit), 864.09, 0.005);
        EXPECT_DOUBLE_EQ(typed(u"0.001 kg·m", unit), 1000.0);
    }
    for (const char16_t* unit : {u"kg/m³", u"кг/м³"}) {
        for (const char16_t* text : {u"7.85 g/cm³", u"7.85 g/cm3", u"7,85 г/см³", u"7,85 г/см3",
                                     u"7.85g/cm^3", u"7850 kg/m3", u"7850 кг/м³", u"7850"}) {
            EXPECT_DOUBLE_EQ(typed(text, unit), 7850.0) << QString::fromUtf16(text).toStdString();
        }
    }
    EXPECT_FALSE(readTypedNumber(QStringLiteral("17 g/cm3"), QStringLiteral("g")).value);
    EXPECT_FALSE(readTypedNumber(QStringLiteral("85 g·cm"), QStringLiteral("g")).value);
    EXPECT_FALSE(readTypedNumber(QStringLiteral("5 mm"), QStringLiteral("°")).value);
}

TEST(NumberText, WhatIsTypedToBeComputedIsComputed) {
    const struct {
        const char16_t* text;
        const char16_t* unit;
        std::optional<double> value;
    } cases[] = {
        {u"75/2", u"mm", 37.5},
        {u"2*46+3 mm", u"mm", 95.0},
        {u"(3 + 1/2) in", u"mm", 88.9},
        {u"2×(46,5−0.5)", u"mm", 92.0},
        {u"0.1+0.2", u"", 0.3},
        {u"-(1+2)", u"", -3.0},
        {u"1e3/4", u"", 250.0},
        {u"2*150 rad/s", u"rad/s", 300.0},  // the stroke of a unit divides nothing
        {u"34/2 g/cm3", u"kg/m³", 17000.0},
        {u"46", u"mm", 46.0},
        {u"1 250 g", u"g", 1250.0},
        {u"1/0", u"mm", {}},
        {u"2*", u"mm", {}},
        {u"sin(1)", u"", {}},
        {u"2 3", u"", {}},
        {u"3,600/2", u"", {}},  // 3600 or 3.6
        {u"75/2 g", u"mm", {}},
    };
    for (const auto& each : cases) {
        EXPECT_EQ(
            readTypedFormula(QString::fromUtf16(each.text), QString::fromUtf16(each.unit)).value,
            each.value)
            << QString::fromUtf16(each.text).toStdString();
    }
    EXPECT_FALSE(readTypedNumber(QStringLiteral("10-8"), {}).value) << "of a list or a scale";
}

TEST(LogarithmicSlider, GoesByDecades) {
    ValueSlider slider(u"&c"_s, {1.0, 1e6, 0.1, 1.0, 1, 50, 3}, u"kN/m"_s);
    slider.setValue(20000.0);
    QSignalSpy edited(&slider, &ValueSlider::valueEdited);
    QTest::keyClick(slider.slider(), Qt::Key_PageDown);  // one decade
    ASSERT_EQ(edited.size(), 1);
    EXPECT_NEAR(slider.value(), 2000.0, 40.0);  // to the nearest step
    QTest::keyClick(slider.slider(), Qt::Key_Home);
    EXPECT_DOUBLE_EQ(slider.value(), 1.0);
    QTest::keyClick(slider.slider(), Qt::Key_End);
    EXPECT_DOUBLE_EQ(slider.value(), 1e6);
    // Every step is the same part of the value, and comes out with three digits.
    QTest::keyClick(slider.slider(), Qt::Key_Left);
    EXPECT_DOUBLE_EQ(slider.value(), 955000.0);
    // The box takes any value.
    test::type(slider.box(), QStringLiteral("1234.5"));
    EXPECT_DOUBLE_EQ(slider.value(), 1234.5);
    // It shows a tenth of the unit at least; a soft spring has less.
    ValueSlider soft(u"&c"_s, {0.02, 1e6, 0.1, 1.0, 1, 50, 3}, u"kN/m"_s);
    soft.setValue(0.02);
    for (const double next : {0.0209, 0.0219}) {
        QTest::keyClick(soft.slider(), Qt::Key_Right);
        EXPECT_DOUBLE_EQ(soft.value(), next);
    }
}

TEST(NumberList, ReadsNumbersOneAfterTheOther) {
    using List = std::vector<double>;
    const Field drills{.key = "drills_mm",
                       .unit = units::mm,
                       .range = Range::greater_than(0, 100),
                       .label = {"&Drills"}};
    for (const char* typed : {"8 10,5 16", "8; 10.5;16", "8, 10,5, 16", "8; 10.50; 16",
                              " 8mm ;10.5 16 ", "8 mm; 10.5 mm 16"}) {
        EXPECT_EQ(readNumberList(QString::fromUtf8(typed), drills, {}), List({8, 10.5, 16}))
            << typed;
    }
    EXPECT_EQ(readNumberList({}, drills, {}), List());
    EXPECT_EQ(
        readNumberList(QString::fromUtf8("0° 90°"), Field{.key = "", .unit = units::degree}, {}),
        List({0, 90}));
    EXPECT_EQ(numberListText({8, 10.5}, drills), QStringLiteral("8; 10.5"));
    for (const auto& [typed, why] :
         {std::pair("8 wide",
                    "Drills: must be numbers with blanks or semicolons between them, got \"wide\""),
          std::pair("8 -3", "Drills: must be greater than 0 and at most 100 mm, got -3 mm"),
          std::pair("8,125", "Drills: “8,125” may be 8125 or 8.125: enter one of them."),
          std::pair("8,10",
                    "Drills: must be two numbers or one: enter \"8; 10\" or \"8.1\", got \"8,10\""),
          std::pair(
              "6, 10,0mm",
              "Drills: must be two numbers or one: enter \"10; 0\" or \"10\", got \"10,0mm\"")}) {
        EXPECT_EQ(
            test::error_of([&] { readNumberList(QString::fromUtf8(typed), drills, "Drills"); }),
            why);
    }
}

}  // namespace
}  // namespace ravnoves
