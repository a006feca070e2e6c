// Units that the user wants: only what is written and read is in them, values stay in their own.

#include "text/shown_units.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QSettings>
#include <QSignalSpy>

#include "case-file/field.h"
#include "case-file/message.h"
#include "events.h"
#include "plot/plot_view.h"
#include "shop/model/words.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/preferences.h"
#include "text/result_row.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"
#include "widgets/value_slider.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using Units = Preferences::Units;

constexpr Field radius{
    .key = "crank_radius_mm", .unit = units::mm, .range = Range::greater_than(0, 254)};

class ShownUnits : public ::testing::Test {
  protected:
    ShownUnits() {
        preferences.setUnits(Preferences::Length, Units::Imperial);
        preferences.setUnits(Preferences::Torque, Units::Imperial);
        preferences.setUnits(Preferences::Mass, Units::Gram);
        preferences.setUnits(Preferences::Speed, Units::RadPerSecond);
    }
    ~ShownUnits() override {
        QSettings().clear();
        preferences.load();
    }

    Preferences& preferences = Preferences::instance();
};

TEST_F(ShownUnits, AreExact) {
    EXPECT_EQ(shownUnit(units::mm).name, u"in"_s);
    EXPECT_DOUBLE_EQ(25.4 * shownUnit(units::mm).factor, 1.0);
    EXPECT_DOUBLE_EQ(1.3558179483314004 * shownUnit(units::N_m).factor, 1.0);  // NIST SP 811
    EXPECT_DOUBLE_EQ(shownUnit(units::kg).factor, 1000.0);
    EXPECT_DOUBLE_EQ(60.0 * shownUnit(units::rpm).factor, 6.283185307179586);
    EXPECT_EQ(shownUnit(units::bar).name, u"bar"_s);
    EXPECT_EQ(shownUnit(units::bar).factor, 1.0);
    preferences.setUnits(Preferences::Length, Units::Own);
    EXPECT_EQ(shownUnit(units::mm).name, u"mm"_s);
    EXPECT_EQ(shownUnit(units::mm).factor, 1.0);
}

TEST(Unbroken, KeepsNumbersSymbolsAndTheirWordsTogether) {
    const auto shown = [](const QString& text) {
        return unbroken(text).replace(QChar(0x00A0), u'_');
    };
    EXPECT_EQ(shown(u"Crank radius r"_s), u"Crank radius_r"_s);
    EXPECT_EQ(shown(u"Стальная пробка &mₚ, 5 г·мм"_s), u"Стальная пробка_&mₚ, 5_г·мм"_s);
    EXPECT_EQ(shown(u"Weighed parts: ± 0.5 g, 95 % of 8 plugs"_s),
              u"Weighed parts: ±_0.5_g, 95_% of 8 plugs"_s);
    EXPECT_EQ(shown(u"7850 kg/m³ at a shaft"_s), u"7850_kg/m³ at a shaft"_s);
    EXPECT_EQ(shown(u"Положение цилиндра &1"_s), u"Положение цилиндра_&1"_s);
    EXPECT_EQ(shown(u"of 8 grams, as I said"_s), u"of 8 grams, as I said"_s);
}

TEST_F(ShownUnits, OfAFieldIsWhatIsWrittenReadAndRejected) {
    FormSection section({});
    NumberField* field = section.addNumber(radius);
    test::showAt(section, {300, 80});
    section.activateWindow();
    QSignalSpy edited(field, &NumberField::valueEdited);
    field->setValue(46.0);
    EXPECT_EQ(field->text(), u"1.81102"_s);
    EXPECT_EQ(field->value(), 46.0);
    test::typeOver(field, u"2"_s);
    EXPECT_EQ(field->value(), 50.8);
    test::typeOver(field, u"10"_s);  // the range's end counts
    EXPECT_EQ(field->value(), 254.0);
    test::typeOver(field, u"11"_s);
    EXPECT_EQ(field->trouble().toStdString(),
              "The value must be greater than 0 and at most 10\u00A0in.");
    QTest::keyClick(field, Qt::Key_Escape);
    EXPECT_EQ(field->value(), 46.0);
    EXPECT_EQ(field->unit(), u"in"_s);
    EXPECT_TRUE(field->accessibleName().endsWith(u", in"_s));
}

TEST_F(ShownUnits, OfASliderAreInItsBox) {
    ValueSlider slider(u"&l"_s, {0.0, 254.0, 0.1, 10.0, 1}, u"mm"_s);
    slider.setValue(127.0);
    EXPECT_EQ(slider.box()->text(), u"5.000"_s);
    EXPECT_EQ(slider.box()->unit(), u"in"_s);
    QSignalSpy edited(&slider, &ValueSlider::valueEdited);
    test::type(slider.box(), u"2"_s);
    EXPECT_DOUBLE_EQ(slider.value(), 50.8);
    ASSERT_EQ(edited.size(), 1);
    EXPECT_DOUBLE_EQ(edited.front().front().toDouble(), 50.8);
    const auto type = [&](const QString& text) {
        test::type(slider.box(), text);
        return slider.value();
    };
    EXPECT_DOUBLE_EQ(type(u"1.2 mm"_s), 1.2);
    EXPECT_DOUBLE_EQ(type(u"1,5"_s), 38.1);
    slider.setRange(0.0, 200.0);  // 7.874 in, rounded down
    EXPECT_DOUBLE_EQ(type(u"200 mm"_s), 200.0);
    EXPECT_EQ(slider.trouble(), QString());
}

TEST_F(ShownUnits, OfAPlotAreOnItsAxesInItsSentenceAndInItsTable) {
    QWidget window;
    PlotView plot(&window);
    plot.resize(500, 300);
    Figure figure{.title = u"Torque"_s, .x = {u"l, mm"_s, 0.0, 254.0}, .left = {u"N·m"_s}};
    figure.add("M", {.name = u"M"_s}, {0.0, 254.0}, {0.0, 1.3558179483314004});
    plot.showFigure(figure);
    plot.grab();
    EXPECT_EQ(plot.data().x.interval(), std::pair(0.0, 254.0));  // data stay
    EXPECT_TRUE(plot.sentence().contains(u"from 0.00 to 10.00\u00A0in"_s))
        << plot.sentence().toStdString();
    EXPECT_TRUE(plot.sentence().contains(u"1.00\u00A0lb·ft"_s) ||
                plot.sentence().contains(u"1.000\u00A0lb·ft"_s))
        << plot.sentence().toStdString();
    EXPECT_TRUE(plot.dataAsCsv().contains(u"l, in"_s));
}

TEST_F(ShownUnits, OfMessagesAreTheUsers) {
    EXPECT_EQ(messageText(Message(Number{25.4, units::mm})), u"1\u00A0in"_s);
    EXPECT_EQ(messageText(Message(Number{1.5, units::kg, 3})), u"1500\u00A0g"_s);
    EXPECT_EQ(messageText(Message(Number{1.5, units::bar})), u"1.5\u00A0bar"_s);
    EXPECT_EQ(shownNumber(0.0254, units::mm, 1), u"1.000\u00A0in"_s);
    EXPECT_EQ(messageText(Range::between(25.4, 254.0).message(units::mm)),
              u"must be from 1 to 10\u00A0in"_s);
}

TEST_F(ShownUnits, OfAJobCardAreInItsLanguage) {
    preferences.setUnits(Preferences::Mass, Units::Imperial);
    constexpr double ounce = 0.028349523125;
    EXPECT_EQ(Words(u"en"_s).number(ounce, units::gram, 2), u"1.0000\u00A0oz"_s);
    EXPECT_EQ(Words(u"ru"_s).number(ounce, units::gram, 2), u"1,0000\u00A0унц"_s);
    EXPECT_EQ(Words(u"en"_s).plain(0.0254, units::mm, 2), u"1"_s);
    EXPECT_EQ(Words(u"en"_s).message(Message(Number{25.4, units::mm})), u"1\u00A0in"_s);
}

TEST_F(ShownUnits, OfTablesAreOfTheSameQuantity) {
    EXPECT_EQ(shownRow(u"r"_s, 0.0254, units::mm, 1).texts(),
              (QStringList{u"r"_s, u"1.000"_s, u"in"_s}));
    EXPECT_EQ(shownShort(0.05, units::mm, 4), u"1.969\u00A0in"_s);
    EXPECT_EQ(shownFigures(1.5, units::kg, 3), u"1500"_s);  // no 1.5e+03
    EXPECT_DOUBLE_EQ(shownValue(1.3558179483314004, units::N_m), 1.0);
    EXPECT_EQ(shownAs(units::bar), units::bar);
}

TEST(ShownFigures, ArePowersOfTenOnlyWhereThoseAreShorter) {
    EXPECT_EQ(shownFigures(10052.4 * units::gram_mm, units::gram_mm, 4), u"10052"_s);
    EXPECT_EQ(shownFigures(1234.56, units::newton, 4), u"1235"_s);
    EXPECT_TRUE(shownFigures(2.5e7, units::newton, 4).contains(u'E'));
}

}  // namespace
}  // namespace ravnoves
