// The parts that are weighed, and where they go.

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QPushButton>
#include <map>

#include "plugs_page_test.h"
#include "report/input_tables.h"
#include "theme/theme.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace v8_plugs;

using units::gram;

TEST_F(PlugsPageTest, AReportSaysWhichTypedChangesDoNotCount) {
    type("rod_big_end", u"0.5"_s);
    type("repair_piston_and_rings", u"2"_s);
    EXPECT_EQ(model->replacedInputs(), std::vector<std::string>());
    type("nominal_piston", u"600"_s);
    for (int cylinder = 1; cylinder <= 8; ++cylinder) {
        type(("mass_piston_" + std::to_string(cylinder)).c_str(), u"601"_s);
    }
    QStringList rows;
    for (const report::Table& table : inputTables(*model)) {
        for (const QStringList& row : table.rows) {
            rows << row.join(u'|');
        }
    }
    const QString unused = u"Not used: the weighed masses replace it"_s;
    EXPECT_TRUE(rows.contains(u"Repair piston and rings Δmᵣₚ|2|g|"_s + unused))
        << qPrintable(rows.join(u'\n'));
    EXPECT_EQ(rows.filter(u"big end"_s).filter(unused).size(), 0);
    EXPECT_EQ(rows.filter(u"Source of the mass changes|Masses of the parts"_s).size(), 1);
    EXPECT_EQ(rows.filter(u"weigh-in"_s).size(), 0);
    // What is grey on the page is not so on paper.
    for (const QLabel* said : page.findChildren<QLabel*>()) {
        EXPECT_FALSE(said->text().contains(u"Grey values"_s) &&
                     said->textInteractionFlags().testFlag(Qt::TextSelectableByMouse));
    }
}

TEST_F(PlugsPageTest, WeighInSheetByKeyboard) {
    show(WeighIn);
    type("nominal_piston", u"600"_s);
    type("spread_piston", u"2"_s);
    // From here Enter goes down the column.
    EXPECT_EQ(QApplication::focusWidget(), field("mass_piston_1"));
    for (int cylinder = 0; cylinder < 8; ++cylinder) {
        QTest::keyClicks(QApplication::focusWidget(), QString::number(600 + cylinder));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    }
    EXPECT_EQ(QApplication::focusWidget(), field("nominal_pin"));
    EXPECT_NEAR(*(*model->input().weigh_in)[Part::piston].mass[7], 607 * gram, 1e-12);
    EXPECT_TRUE(label("verdict").contains(u"Piston: range 7.00"_s) ||
                label("troubles").contains(u"Piston: range 7.00"_s));
    // They count, and no box is to be ticked for it.
    auto* use = find<QCheckBox>("changes_from_weigh_in");
    EXPECT_TRUE(use->isChecked());
    EXPECT_NEAR(model->plugs()->changes.repair_piston_and_rings, 3.5 * gram, 1e-12);
    EXPECT_FALSE(field("repair_piston_and_rings")->isEnabled());
    EXPECT_NEAR(field("repair_piston_and_rings")->value().value_or(0.0), 3.5, 1e-12);
    EXPECT_TRUE(label("advice").startsWith(u"Machine all 8 steel plugs"_s))
        << qPrintable(label("advice"));
    // The parts change places on the sheet too, once they did on the bench.
    auto* move = find<QPushButton>("move_parts");
    ASSERT_TRUE(move->isVisible());
    const auto spread = [&] { return model->plugs()->crankpin_excess; };
    const auto wanted = model->plugs()->assigned_excess;
    EXPECT_NE(spread(), wanted);
    const ResultRows excess = model->crankpinResults().rows;
    const auto spreads = [&] {
        const ResultRows rows = model->crankpinResults().rows;
        const ResultRow effects =
            matching_text::effects(Words(), model->matchingShown().value()).rows.at(0);
        EXPECT_EQ(effects.at(1).number()->value, rows.at(0).last().number()->value);
        EXPECT_EQ(effects.at(2).number()->value, rows.at(1).last().number()->value);
        return rows;
    };
    spreads();
    move->setFocus();
    QTest::keyClick(move, Qt::Key_Space);
    EXPECT_EQ(spread(), wanted);
    EXPECT_EQ(spreads(), excess) << "moved, they were weighed as before";
    EXPECT_EQ(model->solution().placing->moved, 0);
    EXPECT_FALSE(move->isVisible());
    model->history()->undo();
    // What does not count is amber, on the sheet and in the answer.
    use->setFocus();
    QTest::keyClick(use, Qt::Key_Space);
    EXPECT_TRUE(field("repair_piston_and_rings")->isEnabled());
    for (const char* name : {"troubles", "weigh_in_summary"}) {
        EXPECT_TRUE(label(name).contains(u"Weighed masses are not used"_s)) << name;
        EXPECT_EQ(find<QLabel>(name)->palette().color(QPalette::WindowText),
                  Theme::instance().warning())
            << name;
    }
    EXPECT_TRUE(label("advice").startsWith(u"Missing for the plugs: changes of mass"_s));
    QTest::keyClick(use, Qt::Key_Space);
    EXPECT_FALSE(label("troubles").contains(u"need a nominal mass"_s));
    EXPECT_NEAR(model->plugs()->changes.repair_piston_and_rings, 3.5 * gram, 1e-12);
}

TEST_F(PlugsPageTest, MovedPartsKeepTheirNumbersOnSheetAndCard) {
    show(WeighIn);
    type("nominal_piston", u"600"_s);
    for (int i = 1; i <= 8; ++i) {
        type(("mass_piston_" + std::to_string(i)).c_str(), QString::number(600 + i % 4 * 2));
    }
    ASSERT_TRUE(model->plugs()->assignment);
    std::vector<int> wanted;
    for (const int from : model->plugs()->assignment->pistons) {
        wanted.push_back(from + 1);
    }
    ASSERT_NE(wanted, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
    bool isSuggested = false;
    const auto printed = [&] {
        const QString text = card();
        QString line;
        isSuggested = text.contains(u"suggested, not yet applied"_s);
        for (const QString& each : text.split(u'\n')) {
            line = each.contains(u"Piston set from"_s) ? each.simplified() : line;
        }
        return line;
    };
    const auto said = [&] {
        QStringList numbers;
        for (const int number : wanted) {
            numbers << QString::number(number);
        }
        return u"Piston set from "_s + numbers.join(u' ');
    };
    EXPECT_EQ(printed(), said());
    EXPECT_TRUE(isSuggested);
    const auto table = model->assignmentResults().rows;
    auto* move = find<QPushButton>("move_parts");
    move->setFocus();
    QTest::keyClick(move, Qt::Key_Space);
    // The weights have moved; the numbers say where the parts came from, on sheet and card.
    EXPECT_EQ(model->solution().placing->moved, 0);
    EXPECT_EQ(printed(), said());
    EXPECT_FALSE(isSuggested);
    EXPECT_EQ(model->assignmentResults().rows, table);
    EXPECT_TRUE(label("weigh_in_summary").contains(u"Assemble by set numbers"_s));
    // Kept by the case file.
    const workshop::Input kept = model->input();
    const Json file = model->inputJson();
    model->loadDefault();
    model->loadInput(file, {});
    EXPECT_EQ(model->input().weigh_in, kept.weigh_in);
    auto* back = find<QPushButton>("move_back");
    show(WeighIn);
    ASSERT_TRUE(back->isVisible());
    back->setFocus();
    QTest::keyClick(back, Qt::Key_Space);
    for (std::size_t i = 1; i <= 8; ++i) {
        EXPECT_NEAR(*(*model->input().weigh_in)[Part::piston].mass[i - 1],
                    (600 + static_cast<double>(i % 4) * 2) * gram, 1e-12);
    }
    EXPECT_FALSE(model->input().weigh_in->is_moved());
}

TEST_F(PlugsPageTest, FittedPistonsStayAndWhatTheEngineFeelsIsMadeSmall) {
    show(WeighIn);
    type("nominal_piston", u"600"_s);
    type("spread_piston", u"2"_s);
    type("nominal_rod_big_end", u"500"_s);
    for (int i = 1; i <= 8; ++i) {
        type(("mass_piston_" + std::to_string(i)).c_str(), QString::number(600 + i * i % 7));
        type(("mass_rod_big_end_" + std::to_string(i)).c_str(), QString::number(500 + i * i % 5));
    }
    EXPECT_EQ(model->takeOffResults().rows.size(), 2);
    EXPECT_EQ(model->takeOffResults().rows.at(0).at(1), u"1.00"_s) << "601 g, the lightest 600";
    const auto choose = [&](const char* name, Qt::Key key) {
        auto* box = find<QComboBox>(name);
        box->setFocus(Qt::TabFocusReason);
        QTest::keyClick(box, key);
    };
    choose("moves_pistons", Qt::Key_End);
    choose("goal", Qt::Key_End);
    const auto placing = [&] { return model->plugs()->assignment.value(); };
    EXPECT_EQ(placing().pistons, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(placing().goal, shop::MatchingGoal::least_shaking);
    EXPECT_LT(placing().shaking->ends, placing().shaking_before->ends);
    EXPECT_TRUE(label("weigh_in_summary").contains(u"enter the cylinder spacing"_s))
        << qPrintable(label("weigh_in_summary"));
    type("cylinder_spacing_mm", u"110"_s);
    EXPECT_EQ(model->effectResults().rows.size(), 4);
    EXPECT_EQ(model->history()->undoText(), u"Cylinder spacing"_s);
    const Json matching = model->inputJson().at("weigh_in").at("matching");
    EXPECT_EQ(matching,
              (Json{{"goal", "least-shaking"}, {"pistons", "stay"}, {"cylinder_spacing_mm", 110}}));
    // The card says what to take off pistons too far apart, and what is gained.
    const QString printed = card();
    EXPECT_TRUE(printed.contains(u"take off"_s)) << qPrintable(printed);
    EXPECT_TRUE(printed.contains(u"Effect of the matching"_s));
    show(WeighIn);
    model->newJob();
    EXPECT_EQ(model->input().weigh_in->matching.pistons, shop::SetMoves::stays);
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
    const QString odd =
        u"1000.00\u00A0g entered, but the nominal parts add up to 1022.00\u00A0g."_s;
    EXPECT_TRUE(label("troubles").contains(odd)) << "although more is missing";
    EXPECT_EQ(label("troubles").count(u"entered, but"_s), 1);
    EXPECT_EQ(colour("troubles"), Theme::instance().warning());
    auto* fill = find<QPushButton>("fill_masses");
    ASSERT_TRUE(fill->isEnabled());
    show(Parts);
    fill->setFocus();
    QTest::keyClick(fill, Qt::Key_Space);
    EXPECT_NEAR(*field("reciprocating_mass_g")->value(), 1022.0, 1e-9);
    EXPECT_FALSE(label("troubles").contains(u"entered, but"_s));
    EXPECT_FALSE(fill->isEnabled());
}

TEST_F(PlugsPageTest, MassesThatCannotBeAreNoticedAtOnce) {
    const struct {
        const char* field;
        const char* wrong;
        const char* right;
        QString said;
    } masses[] = {
        {"mass_piston_1", "0.5682", "568.2", u"Piston: 0.568\u00A0g looks like kilograms"_s},
        {"nominal_shells", "0.06", "60", u"Shells: 0.06\u00A0g looks like kilograms"_s},
        {"reciprocating_mass_g", "1.02", "1020", u"1.02\u00A0g looks like kilograms"_s},
        {"mass_piston_2", "5682", "568", u"Piston: cylinder 2 weighs"_s}};
    for (const auto& mass : masses) {
        if (QLatin1String(mass.field) == "mass_piston_2"_L1) {
            type("mass_piston_3", u"568"_s);
        }
        type(mass.field, QLatin1String(mass.wrong));
        EXPECT_TRUE(label("verdict").contains(mass.said)) << qPrintable(label("verdict"));
        EXPECT_TRUE(model->withheld().bob_weight);
        type(mass.field, QLatin1String(mass.right));
        EXPECT_FALSE(model->withheld().any()) << qPrintable(label("verdict"));
    }
}

TEST_F(PlugsPageTest, NothingIsToBeDoneByDoubtedWeights) {
    show(WeighIn);
    type("nominal_piston", u"600"_s);
    for (int i = 1; i <= 8; ++i) {
        type(("mass_piston_" + std::to_string(i)).c_str(), QString::number(600 + i % 4 * 2));
    }
    const QString said = u"Weigh again first: piston of cylinder 3."_s;
    const QString advice = label("advice");
    EXPECT_TRUE(advice.startsWith(u"Machine all 8"_s)) << qPrintable(advice);
    auto* move = find<QPushButton>("move_parts");
    EXPECT_TRUE(move->isVisible());
    EXPECT_TRUE(card().contains(u"suggested, not yet applied"_s));
    type("mass_piston_3", u"706"_s);
    EXPECT_EQ(label("advice"), QString());
    EXPECT_EQ(label("weigh_in_summary"), said);
    EXPECT_FALSE(move->isVisible());
    EXPECT_EQ(model->boringText(), QString());
    EXPECT_TRUE(model->crankpinResults().rows.isEmpty());
    EXPECT_TRUE(model->optionResults().rows.isEmpty());
    const QString printed = card().simplified();
    EXPECT_EQ(printed.count(said), 1) << qPrintable(printed);
    EXPECT_EQ(printed.count(u"cylinder 3 weighs"_s), 1) << qPrintable(printed);
    EXPECT_FALSE(printed.contains(u"suggested, not yet applied"_s));
    EXPECT_FALSE(printed.contains(u"lighter than nominal"_s) || printed.contains(advice));
    type("mass_piston_3", u"606"_s);
    EXPECT_EQ(label("advice"), advice);
}

TEST_F(PlugsPageTest, ColumnsOfASpreadsheetArePastedInOneStepOrNotAtAll) {
    show(WeighIn);
    NumberField* first = field("mass_piston_1");
    const auto paste = [&](const QString& text) {
        QGuiApplication::clipboard()->setText(text);
        first->setFocus();
        QTest::keyClick(first, Qt::Key_V, Qt::ControlModifier);
    };
    paste(u"Piston, g\tPin, g\r\n601,5\t151\r\n602\t\r\n603\t153\r\n"_s);
    EXPECT_EQ(field("mass_piston_1")->value(), 601.5);
    EXPECT_EQ(field("mass_pin_3")->value(), 153.0);
    EXPECT_FALSE((*model->input().weigh_in)[Part::pin].mass[1]) << "a gap stays a gap";
    model->history()->undo();
    EXPECT_FALSE(model->input().weigh_in);
    for (const QString& bad : {u"601\nheavy"_s, u"601\n-5"_s, u"1\n2\n3\n4\n5\n6\n7\n8\n9"_s}) {
        paste(bad);
        EXPECT_FALSE(model->input().weigh_in) << qPrintable(bad);
    }
}

}  // namespace
}  // namespace ravnoves
