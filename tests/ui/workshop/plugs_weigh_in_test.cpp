// The parts that are weighed, and where they go.

#include <QCheckBox>
#include <QPushButton>
#include <map>

#include "job_page_test.h"
#include "report/sections.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace v8_plugs;

using units::gram;

/// The rows of the inputs in a report.
QStringList reported(SceneModel& model) {
    QStringList rows;
    for (const paper::Table& table : inputTables(model)) {
        for (const QStringList& row : table.rows) {
            rows << row.join(u'|');
        }
    }
    return rows;
}

TEST_F(PlugsPageTest, AReportSaysWhichTypedChangesDoNotCount) {
    type("rod_big_end", u"0.5"_s);
    type("repair_piston_and_rings", u"2"_s);
    EXPECT_EQ(model->replacedInputs(), std::vector<std::string>());
    type("nominal_piston", u"600"_s);
    weigh("piston", std::vector<double>(8, 601.0));
    const QStringList rows = reported(*model);
    const QString unused = u"Not used: other inputs replace it"_s;
    EXPECT_TRUE(rows.contains(u"One repair piston with rings Δmᵣₚ|2|g|"_s + unused))
        << qPrintable(rows.join(u'\n'));
    EXPECT_EQ(rows.filter(u"big end"_s).filter(unused).size(), 0);
    EXPECT_EQ(rows.filter(u"Source of the mass changes|Masses of the parts"_s).size(), 1);
    EXPECT_EQ(rows.filter(u"weigh-in"_s).size(), 0);
}

TEST_F(PlugsPageTest, AReportNamesOverriddenValuesAsTheForm) {
    Json input = model->inputJson();
    input["plugs"]["engine"] = "4.25 l";
    input["plugs"]["engine_overrides"] = {{"steel_plug_mass_g", 28.5}, {"oil_mass_g", 20}};
    model->loadInput(input, {});
    const QStringList rows = reported(*model);
    EXPECT_EQ(rows.filter(u"One steel plug mₚ|28.5|g|"_s).size(), 1)
        << qPrintable(rows.join(u'\n'));
    EXPECT_EQ(rows.filter(u"Oil of one crankpin mₘ|20|g|"_s).size(), 1);
}

TEST_F(PlugsPageTest, WeighInSheetByKeyboard) {
    show(WeighInTab);
    type("nominal_piston", u"600"_s);
    type("spread_piston", u"2"_s);
    // From here Enter goes down the column.
    EXPECT_EQ(QApplication::focusWidget(), field("mass_piston_1"));
    for (int cylinder = 0; cylinder < 8; ++cylinder) {
        QTest::keyClicks(QApplication::focusWidget(), QString::number(600 + cylinder));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    }
    EXPECT_EQ(QApplication::focusWidget(), field("mass_pin_1"));
    EXPECT_NEAR(*(*model->input().weigh_in)[Part::piston].mass[7], 607 * gram, 1e-12);
    EXPECT_TRUE(label("verdict").contains(u"Piston: range 7.00"_s) ||
                label("troubles").contains(u"Piston: range 7.00"_s));
    // They count, and no box is to be ticked for it.
    auto* use = find<QCheckBox>("changes_from_weigh_in");
    EXPECT_TRUE(use->isChecked());
    EXPECT_NEAR(model->plugs()->changes.repair_piston_and_rings, 3.5 * gram, 1e-12);
    EXPECT_FALSE(field("repair_piston_and_rings")->isEnabled());
    EXPECT_NEAR(field("repair_piston_and_rings")->value().value_or(0.0), 3.5, 1e-12);
    EXPECT_TRUE(begins(label("advice"), u"Provisional: take 1.48 g off"_s));
    // The parts change places on the sheet too, once they did on the bench.
    auto* move = find<QPushButton>("move_parts");
    ASSERT_TRUE(move->isVisible());
    const auto placing = [&] { return model->solution().placing.value(); };
    const double wanted = placing().after.spread;
    EXPECT_GT(placing().before.spread, wanted);
    const ResultRow spreads = model->effectResults().rows.at(0);
    keys("move_parts", {Qt::Key_Space});
    EXPECT_NEAR(placing().before.spread, wanted, 1e-12);
    EXPECT_EQ(model->effectResults().rows.at(0), spreads) << "moved, they were weighed as before";
    EXPECT_EQ(placing().moved, 0);
    EXPECT_FALSE(move->isVisible());
    model->history()->undo();
    // What does not count is amber, on the sheet and in the answer.
    keys("changes_from_weigh_in", {Qt::Key_Space});
    EXPECT_TRUE(field("repair_piston_and_rings")->isEnabled());
    for (const char* name : {"troubles", "weigh_in_summary"}) {
        EXPECT_TRUE(label(name).contains(u"Weighed masses are not used"_s)) << name;
        EXPECT_TRUE(isAmber(name)) << name;
    }
    EXPECT_TRUE(label("advice").startsWith(u"Missing for the plugs: changes of mass"_s));
    QTest::keyClick(use, Qt::Key_Space);
    EXPECT_FALSE(label("troubles").contains(u"need a nominal mass"_s));
    EXPECT_NEAR(model->plugs()->changes.repair_piston_and_rings, 3.5 * gram, 1e-12);
}

TEST_F(PlugsPageTest, NominalMassesAreCheckedAgainstThePartsOrFilledFromThem) {
    const std::map<const char*, const char*> parts{
        {"nominal_piston", "568.5"},      {"nominal_pin", "151.2"},       {"nominal_rings", "62.3"},
        {"nominal_rod_small_end", "240"}, {"nominal_rod_big_end", "590"}, {"nominal_shells", "60"}};
    for (const auto& [name, grams] : parts) {
        type(name, QString::fromLatin1(grams));
    }
    type("reciprocating_mass_g", u"1000"_s);  // 22 g short of the parts
    type("rotating_mass_g", u"650"_s);
    const QString odd = u"1000.00 g entered, but the nominal parts add up to 1022.00 g."_s;
    EXPECT_TRUE(label("troubles").contains(odd)) << "although more is missing";
    EXPECT_EQ(label("troubles").count(u"entered, but"_s), 1);
    EXPECT_TRUE(isAmber("troubles"));
    auto* fill = find<QPushButton>("fill_masses");
    ASSERT_TRUE(fill->isEnabled());
    keys("fill_masses", {Qt::Key_Space});
    EXPECT_NEAR(*field("reciprocating_mass_g")->value(), 1022.0, 1e-9);
    EXPECT_FALSE(label("troubles").contains(u"entered, but"_s));
    EXPECT_FALSE(fill->isEnabled());
}

}  // namespace
}  // namespace ravnoves
