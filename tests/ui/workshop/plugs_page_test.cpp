// The answer of a job with plugs, its plots and the keys of the page.

#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <algorithm>

#include "job_page_test.h"
#include "page/part_views.h"
#include "shop/scale_input.h"
#include "theme/theme.h"
#include "widgets/entry_field.h"
#include "workshop/journal_dialog.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace v8_plugs;

using units::gram;

TEST_F(PlugsPageTest, AnswerFollowsTyping) {
    fill({{"rod_big_end", "0,5"}, {"repair_piston_and_rings", "2"}, {"repair_bearing", "1.1"}});
    EXPECT_EQ(label("advice"), u"Take 1.83 g off each of the 8 steel plugs."_s);
    EXPECT_TRUE(label("headline").startsWith(u"Missing for the bob weight: "_s));
    typeGear();
    EXPECT_EQ(label("headline"), u"Bob weight 2326.6 g"_s);
    EXPECT_TRUE(label("hang").startsWith(u"On each of the 4 crankpins."_s));
    // At every key, not only at Enter.
    show(PartsTab);
    NumberField* shells = field("repair_bearing");
    shells->setFocus();
    shells->selectAll();
    QTest::keyClicks(shells, u"2"_s);
    EXPECT_EQ(label("advice"),
              u"Replace all 8 plugs by aluminium plugs, lightened by 0.38 g each."_s);
    EXPECT_TRUE(has(page.resultsAsText(), u"5.223"_s));
}

TEST_F(PlugsPageTest, AZeroThatWasTypedIsSomethingThatIsKnown) {
    EXPECT_TRUE(begins(label("advice"), u"Missing for the plugs: changes of mass"_s));
    EXPECT_EQ(colour("advice"), Theme::instance().mutedText());
    EXPECT_EQ(label("hang"), QString());
    EXPECT_EQ(field("rod_big_end")->value(), std::nullopt);
    type("rod_big_end", u"0"_s);
    EXPECT_TRUE(label("advice").startsWith(u"Leave the plugs unchanged"_s));
    EXPECT_EQ(colour("advice"), Theme::instance().text());
    EXPECT_EQ(field("repair_bearing")->value(), 0.0);
    type("customer", u"Smith"_s);
    press(Qt::Key_F2);
    EXPECT_GT(model->desk()->jobId(), 0);
    press(Qt::Key_F4);
    EXPECT_TRUE(label("advice").startsWith(u"Missing for the plugs: changes of mass"_s));
}

TEST_F(PlugsPageTest, WhatWasRejectedGoesWithItsJob) {
    type("customer", u"Smith"_s);
    type("rod_big_end", u"0,5"_s);
    press(Qt::Key_F2);
    const qint64 first = model->desk()->jobId();
    ASSERT_GT(first, 0);
    press(Qt::Key_F4);
    type("reciprocating_mass_g", u"abc"_s);
    ASSERT_FALSE(field("reciprocating_mass_g")->trouble().isEmpty());
    // Nothing has changed on the sheet, but something was typed.
    const auto asked = answer(u"Stay"_s);
    press(Qt::Key_F4);
    EXPECT_TRUE(asked->contains(u"abc"_s)) << qPrintable(*asked);
    EXPECT_EQ(field("reciprocating_mass_g")->text(), u"abc"_s);
    answer(u"Continue"_s);
    press(Qt::Key_F4);
    EXPECT_TRUE(field("reciprocating_mass_g")->trouble().isEmpty());
    EXPECT_EQ(field("reciprocating_mass_g")->text(), QString());
    // The group of masses is filled and emptied again while the next one is typed.
    type("repair_piston_and_rings", u"abc"_s);
    type("rod_big_end", u"12,5 k"_s);
    EXPECT_EQ(field("repair_piston_and_rings")->text(), u"abc"_s);
    EXPECT_FALSE(field("repair_piston_and_rings")->trouble().isEmpty());
    EXPECT_EQ(field("rod_big_end")->text(), u"12,5 k"_s);
    // What is saved is said to be without them.
    type("engine_number", u"53"_s);
    const auto saving = answer(u"Cancel"_s);
    press(Qt::Key_F4);
    EXPECT_TRUE(saving->contains(u"abc"_s) && saving->contains(u"12,5 k"_s)) << qPrintable(*saving);
    // The value below it is that of the job which is opened.
    type("reciprocating_mass_g", u"abc"_s);
    EXPECT_EQ(model->desk()->openJob(first), QString());
    EXPECT_TRUE(field("reciprocating_mass_g")->trouble().isEmpty());
    EXPECT_EQ(field("reciprocating_mass_g")->text(), QString());
    EXPECT_FALSE(model->hasRejected());
}

TEST_F(PlugsPageTest, APlugThatCannotBeMadeIsNoAnswer) {
    Json input = repairJob();
    input["plugs"]["plug"] =
        parse_json(R"({"thread": "M22x1.5", "height_mm": 14, "bore_diameter_mm": 14,
        "bore_depth_mm": 14.5})");
    model->loadInput(input, {});
    for (const QString& said : {label("advice"), cardText()}) {
        EXPECT_TRUE(has(said, u"no bottom remains"_s));
        EXPECT_TRUE(has(said, u"such a plug cannot be made"_s));
    }
    EXPECT_EQ(colour("advice"), Theme::instance().error());
    EXPECT_TRUE(label("boring").isEmpty());
    type("bore_depth_mm", u"6"_s);
    EXPECT_FALSE(has(label("advice"), u"cannot"_s));
}

TEST_F(PlugsPageTest, SaysWhereThePlugsAreWhileTheBobWeightsHang) {
    for (const char* name : {"reciprocating_mass_g", "rotating_mass_g"}) {
        type(name, u"700"_s);
    }
    fill({{"oil_mass_g", "30"},
          {"oil_coefficient", "1"},
          {"steel_plug_mass_g", "25"},
          {"rod_big_end", "0.5"}});
    ASSERT_TRUE(model->plugs()->before) << qPrintable(label("headline"));
    const BobWeight& after = *model->plugs()->chosen()->bob_weight;
    // About 59 g: two plugs of 25 g at 1.18 times the crank radius.
    EXPECT_GT(after.sum() - after.with_plugs_in(), 55 * gram);
    EXPECT_TRUE(has(label("hang"), u"Without plugs; with the planned plugs use "_s +
                                       QString::number(after.with_plugs_in() / gram, 'f', 1)));
    EXPECT_TRUE(has(label("check"), u"Big end × 2.445: 2 for two rods, k"_s));
    EXPECT_TRUE(has(label("check"), u"effect here: 0.22 g"_s));
}

TEST_F(PlugsPageTest, PlotsShowLinesLimitsAndToday) {
    find<QToolButton>("details")->click();
    QApplication::processEvents();
    type("rod_big_end", u"1"_s);
    PartPlot* plot = partPlot(page, "compensation");
    plot->make();  // it may stand behind another
    for (const OptionId id : all_options) {
        const auto& option = model->plugs()->option(id);
        const int curve = static_cast<int>(id);
        EXPECT_NEAR(*plot->valueAt(curve, 0.0), option->constant / gram, 1e-9);
        EXPECT_NEAR(*plot->valueAt(curve, option->max_reduction / gram), option->maximum / gram,
                    1e-9);
        EXPECT_FALSE(plot->valueAt(curve, option->max_reduction / gram + 0.01));
    }
    // Today's excess as a line, the option chosen as a ring on it.
    const Option& chosen = *model->plugs()->chosen();
    const double excess = *model->plugs()->unbalanced_mass / gram;
    const Figure figure = std::get<Figure>(model->part("compensation"));
    ASSERT_EQ(figure.lines.size(), 1U);
    EXPECT_NEAR(figure.lines.front().at, excess, 1e-12);
    const plot::Mark& ring = figure.marks->back();
    EXPECT_TRUE(ring.ring);
    EXPECT_NEAR(ring.x, chosen.reduction / gram, 1e-12);
    EXPECT_NEAR(ring.y, excess, 1e-9);
    EXPECT_EQ(ring.role, series(static_cast<int>(chosen.id)));
}

TEST_F(PlugsPageTest, SheetsOfTheNextJobBeginAtTheirFirstEmptyField) {
    for (int sheet = 0; sheet < sheets->count(); ++sheet) {
        sheets->setCurrentIndex(sheet);
        fieldsOf(sheet).constLast()->setFocus();
    }
    press(Qt::Key_F4);
    for (int sheet = 1; sheet < sheets->count(); ++sheet) {
        sheets->setCurrentIndex(sheet);
        const auto fields = fieldsOf(sheet);
        const auto empty = std::find_if(fields.begin(), fields.end(), [](QWidget* field) {
            const auto* entry = qobject_cast<EntryField*>(field);
            return entry != nullptr && entry->isEnabled() && entry->isVisible() &&
                   entry->text().isEmpty() && !isTypedAlone(entry);
        });
        ASSERT_NE(empty, fields.end());
        EXPECT_EQ(page.focusWidget(), *empty) << sheet;
    }
    // Where one was in this job, one goes on.
    fieldsOf(1).constLast()->setFocus();
    sheets->setCurrentIndex(2);
    sheets->setCurrentIndex(1);
    EXPECT_EQ(page.focusWidget(), fieldsOf(1).constLast());
}

TEST_F(PlugsPageTest, KeysWorkRightAfterTheStart) {
    WorkshopPage fresh(QDir(folder.path()).filePath(u"fresh.sqlite"_s), nullptr);
    fresh.show();
    ASSERT_TRUE(test::becomesActive(fresh));
    QApplication::processEvents();
    ASSERT_TRUE(fresh.isAncestorOf(QApplication::focusWidget()));
    bool seen = false;
    whenModal<JournalDialog>([&](JournalDialog* dialog) {
        seen = true;
        dialog->reject();
    });
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F3);
    EXPECT_TRUE(seen);
}

TEST_F(PlugsPageTest, ASheetStaysWhereItIsWhileAnotherWindowIsUsed) {
    page.resize(900, 500);
    sheets->setCurrentIndex(2);
    auto* sheet = qobject_cast<QScrollArea*>(sheets->currentWidget());
    ASSERT_TRUE(test::becomesActive(page));
    fieldsOf(2).constFirst()->setFocus();
    QScrollBar* bar = sheet->verticalScrollBar();
    ASSERT_GT(bar->maximum(), 0);
    bar->setValue(bar->maximum());
    QWidget other;
    test::showAt(other, {200, 100});
    ASSERT_TRUE(test::becomesActive(other));
    ASSERT_TRUE(test::becomesActive(page));
    ASSERT_TRUE(fieldsOf(2).constFirst()->hasFocus());
    EXPECT_EQ(bar->value(), bar->maximum());
}

}  // namespace
}  // namespace ravnoves
