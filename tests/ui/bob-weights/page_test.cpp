// The page of bob weights by keys and mouse.

#include "bob-weights/bob_weights_page.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>

#include "bob-weights/model/bob_weights_model.h"
#include "case-file/json.h"
#include "events.h"
#include "model/case_document.h"
#include "text/preferences.h"
#include "widgets/number_field.h"
#include "widgets/result_table.h"
#include "workshop/model/job_desk.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace bob_weights;

class BobPageTest : public ::testing::Test {
  protected:
    BobPageTest() : page(QDir(folder.path()).filePath(u"journal.sqlite"_s), nullptr) {
        test::showAt(page, {1187, 712});
        page.activateWindow();
        model = page.viewModel();
        page.openJournal();
    }

    template <typename Widget>
    Widget* find(const char* name) {
        return test::named<Widget>(page, name);
    }
    QString label(const char* name) {
        return find<QLabel>(name)->text().replace(QChar(0x00A0), u' ');
    }
    /// As a person does: the sheet's tab, the field, its text, Enter.
    void type(const char* name, const QString& text) {
        auto* field = find<QWidget>(name);
        for (int sheet = 0; sheet < page.sheets()->count(); ++sheet) {
            if (page.sheets()->widget(sheet)->isAncestorOf(field)) {
                page.sheets()->setCurrentIndex(sheet);
            }
        }
        field->setFocus(Qt::TabFocusReason);
        QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void typeShopCard() {
        const std::pair<const char*, const char*> masses[] = {
            {"rings", "69.5"},      {"piston", "583.9"},  {"pin", "173.6"},   {"locks", "4.8"},
            {"small_end", "162.4"}, {"big_end", "229.8"}, {"shells", "23.7"}, {"oil", "4"}};
        for (const auto& [key, mass] : masses) {
            type(key, QString::fromLatin1(mass));
        }
    }
    void typeReadings() {
        const std::pair<const char*, const char*> values[] = {
            {"position_1", "60"}, {"radius_1", "85"},      {"unbalance_1", "2600"},
            {"angle_1", "75"},    {"position_2", "480"},   {"radius_2", "85"},
            {"angle_2", "210"},   {"unbalance_2", "1450"}, {"maximum_depth_mm", "35"}};
        for (const auto& [key, value] : values) {
            type(key, QString::fromLatin1(value));
        }
        type("diameters_mm", u"8 10 12.5; 16"_s);
    }
    int rowsOf(const char* accessibleName) {
        for (const ResultTable* table : page.findChildren<ResultTable*>()) {
            if (table->accessibleName() == QLatin1String(accessibleName)) {
                return table->rowCount();
            }
        }
        return -1;
    }

    QTemporaryDir folder;
    BobWeightsPage page;
    BobWeightsModel* model = nullptr;
};

TEST_F(BobPageTest, ShopCardByKeys) {
    EXPECT_EQ(label("headline"), u"Still needed: Piston, Big end"_s);
    EXPECT_EQ(rowsOf("Bob weight, line by line"), 0);
    typeShopCard();
    EXPECT_EQ(label("headline"), u"Bob weight 1505.2 g"_s);
    EXPECT_EQ(label("hang"), u"On each of the 4 crankpins."_s);
    EXPECT_TRUE(label("factor").contains(u"nothing remains"_s)) << label("factor").toStdString();
    EXPECT_EQ(rowsOf("Bob weight, line by line"), 9);
    type("reciprocating_percent", u"52"_s);
    EXPECT_EQ(label("headline"), u"Bob weight 1545.0 g"_s) << "994.2 × 1.04 + 511";
}

TEST_F(BobPageTest, TheEngineBringsItsFactor) {
    typeShopCard();
    type("cylinders", u"6"_s);
    type("pin_split_deg", u"30"_s);
    EXPECT_TRUE(label("factor").startsWith(u"Factor 36.6 %"_s)) << label("factor").toStdString();
    auto* engine = find<QComboBox>("type");
    page.sheets()->setCurrentIndex(0);
    engine->setFocus();
    QTest::keyClick(engine, Qt::Key_Down);
    EXPECT_EQ(model->input().engine.type, EngineType::in_line);
    EXPECT_EQ(model->input().engine.rods_per_pin, 1);
    EXPECT_EQ(model->input().engine.pin_split, 0.0);
    EXPECT_FALSE(find<NumberField>("bank_angle_deg")->isEnabled());
    EXPECT_TRUE(label("hang").contains(u"6"_s));
    model->history()->undo();
    EXPECT_EQ(model->input().engine.type, EngineType::v);
    EXPECT_EQ(model->input().engine.rods_per_pin, 2);
    // A rule between two fields is named on the page, not refused.
    type("cylinders", u"7"_s);
    EXPECT_TRUE(label("headline").contains(u"must be even"_s)) << label("headline").toStdString();
}

TEST_F(BobPageTest, ReadingsBecomeHoles) {
    typeShopCard();
    typeReadings();
    ASSERT_TRUE(model->solution().correction);
    EXPECT_EQ(rowsOf("The correction planes"), 2);
    EXPECT_EQ(rowsOf("Holes and slugs"), 2);
    EXPECT_TRUE(label("troubles").isEmpty()) << label("troubles").toStdString();
    const Hole& hole = (*model->solution().correction)[0].holes.at(0);
    EXPECT_NEAR(hole.angle, 75 * degree, 1e-9);
    // Another drill: a word that is none is refused, the drills before it stay.
    type("diameters_mm", u"8 wide"_s);
    EXPECT_EQ(model->input().correction->drill.diameters_mm.size(), 4u);
    type("diameters_mm", u"8"_s);
    EXPECT_GT((*model->solution().correction)[0].holes.size(), 1u);
    // A sector elsewhere: no hole, and the page says what to do.
    type("from_1", u"180"_s);
    type("to_1", u"300"_s);
    EXPECT_TRUE(label("troubles").contains(u"outside the sector"_s))
        << label("troubles").toStdString();
    type("slug_diameter_mm", u"20"_s);
    type("slug_density_kg_m3", u"17500"_s);
    EXPECT_FALSE((*model->solution().correction)[0].slugs.empty());
    // All emptied again, the case has no correction.
    const Json kept = model->inputJson();
    EXPECT_TRUE(kept.contains("correction"));
}

TEST_F(BobPageTest, WeighedPartsGoBeforeTypedOnes) {
    typeShopCard();
    type("cylinders", u"2"_s);
    EXPECT_FALSE(find<NumberField>("mass_piston_3")->isVisibleTo(&page));
    type("mass_piston_1", u"590"_s);
    EXPECT_EQ(label("headline"), u"Bob weight 1505.2 g"_s) << "not all are weighed yet";
    type("mass_piston_2", u"592"_s);
    EXPECT_EQ(label("headline"), u"Bob weight 1512.3 g"_s);
    EXPECT_FALSE(find<NumberField>("piston")->isEnabled());
    EXPECT_TRUE(model->weighInText().contains(u"2.00 off no. 2"_s))
        << model->weighInText().toStdString();
    type("cylinders", u"4"_s);
    EXPECT_EQ(label("headline"), u"Bob weight 1505.2 g"_s) << "two of four are weighed";
}

TEST_F(BobPageTest, WeighedPartsAreSaidInTheUnitsChosen) {
    typeShopCard();
    type("cylinders", u"2"_s);
    type("mass_piston_1", u"566.99046"_s);  // 20 oz
    type("mass_piston_2", u"595.33999"_s);  // 21 oz
    Preferences::instance().setUnits(Preferences::Mass, Preferences::Units::Imperial);
    const QString said = model->weighInText();
    const auto note = model->columnNote(workshop::Part::piston);
    QSettings().clear();
    Preferences::instance().load();
    EXPECT_TRUE(said.contains(u"oz: 1.0000 off no. 2"_s)) << said.toStdString();
    EXPECT_TRUE(note.mean.startsWith(u"20.5000"_s)) << note.mean.toStdString();
    EXPECT_TRUE(note.spread.startsWith(u"1.0000"_s)) << note.spread.toStdString();
}

TEST_F(BobPageTest, LimitsComeByGradeOrByHand) {
    typeShopCard();
    typeReadings();
    auto* grades = find<QComboBox>("grade_list");
    page.sheets()->setCurrentIndex(3);
    grades->setFocus();
    grades->setCurrentIndex(5);
    QTest::keyClick(grades, Qt::Key_Down);  // G 16
    EXPECT_NEAR(*model->input().tolerance->grade, 16e-3, 1e-12);
    type("rotor_mass_kg", u"32"_s);
    type("service_speed_rpm", u"6000"_s);
    EXPECT_TRUE(label("limits").contains(u"407.4 g·mm in each plane"_s))
        << label("limits").toStdString();
    auto* own = find<QCheckBox>("own_limit");
    page.sheets()->setCurrentIndex(3);
    QTest::mouseClick(own, Qt::LeftButton, Qt::NoModifier, {8, own->height() / 2});
    EXPECT_FALSE(model->input().tolerance->by_grade);
    type("g_mm", u"3000"_s);
    EXPECT_EQ(rowsOf("Holes and slugs"), 0) << "both readings are within the limit";
    EXPECT_EQ(model->planeRows().at(0).last(), u"good as it is"_s);
}

TEST_F(BobPageTest, JournalAndCard) {
    typeShopCard();
    typeReadings();
    type("engine_number", u"ZMZ-53 7"_s);
    QTest::keyClick(&page, Qt::Key_F2);
    EXPECT_GT(model->desk()->jobId(), 0);
    JournalQuery query;
    query.scene = u"bob-weights"_s;
    const auto jobs = model->desk()->journal()->search(query);
    ASSERT_EQ(jobs.size(), 1);
    EXPECT_NEAR(*jobs[0].bobWeight, 1505.2, 1e-9);
    EXPECT_NEAR(*jobs[0].frontReading, 2600, 1e-9);
    const QString file = QDir(folder.path()).filePath(u"card.pdf"_s);
    EXPECT_EQ(page.writeCard(file), QString());
    EXPECT_GT(QFileInfo(file).size(), 5000);
    // The next job keeps engine, planes and drills; readings and masses are new.
    QTest::keyClick(&page, Qt::Key_F4);
    EXPECT_FALSE(model->solution().bob_weight);
    EXPECT_EQ(model->input().correction->drill.diameters_mm.size(), 4u);
    EXPECT_FALSE(model->input().correction->readings[0].unbalance);
    EXPECT_EQ(model->desk()->openJob(jobs[0].id), QString());
    EXPECT_EQ(label("headline"), u"Bob weight 1505.2 g"_s);
}

TEST_F(BobPageTest, WhatContradictsItselfHasNoAnswer) {
    typeShopCard();
    type("cylinders", u"7"_s);
    EXPECT_TRUE(label("headline").contains(u"must be even"_s)) << label("headline").toStdString();
    EXPECT_FALSE(model->solution().bob_weight);
    // The journal keeps the sheet, not an answer that it does not have.
    QTest::keyClick(&page, Qt::Key_F2);
    JournalQuery query;
    query.scene = u"bob-weights"_s;
    const auto jobs = model->desk()->journal()->search(query);
    ASSERT_EQ(jobs.size(), 1);
    EXPECT_FALSE(jobs[0].bobWeight);
    type("cylinders", u"8"_s);
    EXPECT_EQ(label("headline"), u"Bob weight 1505.2 g"_s);
    type("reciprocating_percent", u"10"_s);
    type("overbalance_percent", u"-20"_s);
    EXPECT_FALSE(model->solution().bob_weight);
}

TEST_F(BobPageTest, TheNextJobIsNotOfTheFileBeforeIt) {
    CaseDocument document(model, {});
    typeShopCard();
    ASSERT_EQ(document.saveTo(QDir(folder.path()).filePath(u"a.case.json"_s)), QString());
    EXPECT_FALSE(document.path().isEmpty());
    QTest::keyClick(&page, Qt::Key_F2);
    QTest::keyClick(&page, Qt::Key_F4);
    EXPECT_TRUE(document.path().isEmpty());
}

TEST(BobWeightsModel, ReadsDrillsAsTheyAreTyped) {
    using List = std::vector<double>;
    EXPECT_EQ(BobWeightsModel::readDrills(u"8 10 12.5"_s), List({8, 10, 12.5}));
    EXPECT_EQ(BobWeightsModel::readDrills(u"8; 10,5;16"_s), List({8, 10.5, 16}));
    EXPECT_EQ(BobWeightsModel::readDrills(u""_s), List());
    EXPECT_FALSE(BobWeightsModel::readDrills(u"8 mm"_s));
    EXPECT_FALSE(BobWeightsModel::readDrills(u"-3"_s));
}

}  // namespace
}  // namespace ravnoves
