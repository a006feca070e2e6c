// The parts that are weighed, and where they go.

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QGuiApplication>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QTabWidget>
#include <map>

#include "case-file/json.h"
#include "report/input_tables.h"
#include "theme/theme.h"
#include "v8-plugs/page_test.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace v8_plugs;

using units::gram;

TEST_F(V8PageTest, AReportSaysWhichTypedChangesDoNotCount) {
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
    const QString unused = u"Not used: weights count in its place"_s;
    EXPECT_TRUE(rows.contains(u"Repair piston and rings Δmᵣₚ|2|g|"_s + unused))
        << qPrintable(rows.join(u'\n'));
    EXPECT_EQ(rows.filter(u"big end"_s).filter(unused).size(), 0);
    EXPECT_EQ(rows.filter(u"Source of the mass changes|Weights of the parts"_s).size(), 1);
    EXPECT_EQ(rows.filter(u"weigh-in"_s).size(), 0);
    // What is grey on the page is not so on paper.
    for (const QLabel* said : page.findChildren<QLabel*>()) {
        EXPECT_FALSE(said->text().contains(u"in grey"_s) &&
                     said->textInteractionFlags().testFlag(Qt::TextSelectableByMouse));
    }
}

TEST_F(V8PageTest, WeighInSheetByKeyboard) {
    page.sheets()->setCurrentIndex(2);
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
    EXPECT_TRUE(label("troubles").contains(u"Piston: spread 7.00"_s));
    // They count, and no box is to be ticked for it.
    auto* use = find<QCheckBox>("changes_from_weigh_in");
    EXPECT_TRUE(use->isChecked());
    EXPECT_NEAR(model->solution().changes.repair_piston_and_rings, 3.5 * gram, 1e-12);
    EXPECT_FALSE(field("repair_piston_and_rings")->isEnabled());
    EXPECT_NEAR(field("repair_piston_and_rings")->value().value_or(0.0), 3.5, 1e-12);
    EXPECT_TRUE(label("advice").startsWith(u"Machine all 8 steel plugs"_s))
        << qPrintable(label("advice"));
    // The parts change places on the sheet too, once they did on the bench.
    auto* move = find<QPushButton>("move_parts");
    ASSERT_TRUE(move->isVisible());
    const auto spread = [&] { return model->solution().crankpin_excess; };
    const auto wanted = model->solution().assigned_excess;
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
    EXPECT_EQ(model->solution().assignment->moved, 0);
    EXPECT_FALSE(move->isVisible());
    model->history()->undo();
    // What does not count is amber, on the sheet and in the answer.
    use->setFocus();
    QTest::keyClick(use, Qt::Key_Space);
    EXPECT_TRUE(field("repair_piston_and_rings")->isEnabled());
    for (const char* name : {"troubles", "weigh_in_summary"}) {
        EXPECT_TRUE(label(name).contains(u"The weights do not count"_s)) << name;
        EXPECT_EQ(find<QLabel>(name)->palette().color(QPalette::WindowText),
                  Theme::instance().warning())
            << name;
    }
    EXPECT_TRUE(label("advice").startsWith(u"Still needed: changes of mass"_s));
    QTest::keyClick(use, Qt::Key_Space);
    EXPECT_FALSE(label("troubles").contains(u"do not count"_s));
    EXPECT_NEAR(model->solution().changes.repair_piston_and_rings, 3.5 * gram, 1e-12);
}

TEST_F(V8PageTest, MovedPartsKeepTheirNumbersOnSheetAndCard) {
    page.sheets()->setCurrentIndex(2);
    type("nominal_piston", u"600"_s);
    for (int i = 1; i <= 8; ++i) {
        type(("mass_piston_" + std::to_string(i)).c_str(), QString::number(600 + i % 4 * 2));
    }
    ASSERT_TRUE(model->solution().assignment);
    std::vector<int> wanted;
    for (const int from : model->solution().assignment->pistons) {
        wanted.push_back(from + 1);
    }
    ASSERT_NE(wanted, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
    bool isSuggested = false;
    const auto printed = [&] {
        const QString file = QDir(folder.path()).filePath(u"moved.pdf"_s);
        EXPECT_EQ(page.writeCard(file), QString());
        QProcess reader;
        reader.start(QStringLiteral(PDFTOTEXT), {u"-layout"_s, file, u"-"_s});
        EXPECT_TRUE(reader.waitForFinished());
        QString line;
        const QString text = QString::fromUtf8(reader.readAllStandardOutput());
        isSuggested = text.contains(u"Sets as suggested, not applied yet."_s);
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
    EXPECT_EQ(model->solution().assignment->moved, 0);
    EXPECT_EQ(printed(), said());
    EXPECT_FALSE(isSuggested);
    EXPECT_EQ(model->assignmentResults().rows, table);
    EXPECT_TRUE(label("weigh_in_summary").contains(u"Assemble by the numbers"_s));
    // Kept by the case file.
    const Input kept = model->input();
    const Json file = model->inputJson();
    model->loadDefault();
    model->loadInput(file, {});
    EXPECT_EQ(model->input().weigh_in, kept.weigh_in);
    auto* back = find<QPushButton>("move_back");
    page.sheets()->setCurrentIndex(2);
    ASSERT_TRUE(back->isVisible());
    back->setFocus();
    QTest::keyClick(back, Qt::Key_Space);
    for (std::size_t i = 1; i <= 8; ++i) {
        EXPECT_NEAR(*(*model->input().weigh_in)[Part::piston].mass[i - 1],
                    (600 + static_cast<double>(i % 4) * 2) * gram, 1e-12);
    }
    EXPECT_FALSE(model->input().weigh_in->is_moved());
}

TEST_F(V8PageTest, FittedPistonsStayAndWhatTheEngineFeelsIsMadeSmall) {
    page.sheets()->setCurrentIndex(2);
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
    const auto placing = [&] { return model->solution().assignment.value(); };
    EXPECT_EQ(placing().pistons, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(placing().goal, shop::MatchingGoal::least_shaking);
    EXPECT_LT(placing().shaking->ends, placing().shaking_before->ends);
    EXPECT_TRUE(label("weigh_in_summary").contains(u"needs the cylinder spacing"_s))
        << qPrintable(label("weigh_in_summary"));
    type("cylinder_spacing_mm", u"110"_s);
    EXPECT_EQ(model->effectResults().rows.size(), 4);
    EXPECT_EQ(model->history()->undoText(), u"Cylinder spacing"_s);
    const Json matching = model->inputJson().at("weigh_in").at("matching");
    EXPECT_EQ(matching,
              (Json{{"goal", "least-shaking"}, {"pistons", "stay"}, {"cylinder_spacing_mm", 110}}));
    // The card says what to take off pistons too far apart, and what is gained.
    const QString file = QDir(folder.path()).filePath(u"matched.pdf"_s);
    EXPECT_EQ(page.writeCard(file), QString());
    QProcess reader;
    reader.start(QStringLiteral(PDFTOTEXT), {u"-layout"_s, file, u"-"_s});
    EXPECT_TRUE(reader.waitForFinished());
    const QString printed = QString::fromUtf8(reader.readAllStandardOutput());
    EXPECT_TRUE(printed.contains(u"take off"_s)) << qPrintable(printed);
    EXPECT_TRUE(printed.contains(u"First-order unbalance of the differences"_s));
    page.sheets()->setCurrentIndex(2);
    model->newJob();
    EXPECT_EQ(model->input().weigh_in->matching.pistons, shop::SetMoves::stays);
}

TEST_F(V8PageTest, NominalMassesAreCheckedAgainstThePartsOrFilledFromThem) {
    const std::map<const char*, const char*> parts{
        {"nominal_piston", "568.5"},      {"nominal_pin", "151.2"},       {"nominal_rings", "62.3"},
        {"nominal_rod_small_end", "240"}, {"nominal_rod_big_end", "590"}, {"nominal_shells", "60"}};
    for (const auto& [name, grams] : parts) {
        type(name, QString::fromLatin1(grams));
    }
    type("reciprocating_mass_g", u"1000"_s);  // 22 g short of the parts
    type("rotating_mass_g", u"650"_s);
    EXPECT_TRUE(
        label("troubles")
            .contains(
                u"Reciprocating mass\u00A0mⱼ: 1000.00\u00A0g typed, but the nominal parts give "
                u"1022.00\u00A0g."_s))
        << qPrintable(label("troubles"));
    EXPECT_FALSE(label("troubles").contains(u"Rotating mass"_s));
    EXPECT_EQ(find<QLabel>("troubles")->palette().color(QPalette::WindowText),
              Theme::instance().warning());
    auto* fill = find<QPushButton>("fill_masses");
    ASSERT_TRUE(fill->isEnabled());
    page.sheets()->setCurrentIndex(1);
    fill->setFocus();
    QTest::keyClick(fill, Qt::Key_Space);
    EXPECT_NEAR(*field("reciprocating_mass_g")->value(), 1022.0, 1e-9);
    EXPECT_FALSE(label("troubles").contains(u"typed, but"_s));
    EXPECT_FALSE(fill->isEnabled());
}

TEST_F(V8PageTest, MassesInKilogramsAreNoticed) {
    type("mass_piston_1", u"0.5682"_s);
    EXPECT_TRUE(label("troubles").contains(u"Piston: 0.568\u00A0g looks like kilograms"_s))
        << qPrintable(label("troubles"));
    type("mass_piston_1", u"568.2"_s);
    EXPECT_FALSE(label("troubles").contains(u"kilograms"_s));
    type("nominal_shells", u"0.06"_s);
    EXPECT_TRUE(label("troubles").contains(u"Shells: 0.060\u00A0g looks like kilograms"_s));
    type("reciprocating_mass_g", u"1.02"_s);
    EXPECT_TRUE(label("troubles").contains(u"mⱼ: 1.020\u00A0g looks like kilograms"_s));
}

TEST_F(V8PageTest, AMassUnlikeTheOthersIsNoticed) {
    type("mass_piston_1", u"568.2"_s);
    type("mass_piston_2", u"5682"_s);
    type("mass_piston_3", u"568"_s);
    EXPECT_TRUE(
        label("troubles").contains(u"Piston: cylinder 2 weighs 5682\u00A0g, the others about"_s))
        << qPrintable(label("troubles"));
    EXPECT_FALSE(label("troubles").contains(u"Piston: spread"_s));
    type("mass_piston_2", u"568.2"_s);
    EXPECT_FALSE(label("troubles").contains(u"the others"_s));
}

TEST_F(V8PageTest, NothingIsToBeDoneByDoubtedWeights) {
    page.sheets()->setCurrentIndex(2);
    type("nominal_piston", u"600"_s);
    for (int i = 1; i <= 8; ++i) {
        type(("mass_piston_" + std::to_string(i)).c_str(), QString::number(600 + i % 4 * 2));
    }
    const auto printed = [&] {
        const QString file = QDir(folder.path()).filePath(u"doubted.pdf"_s);
        EXPECT_EQ(page.writeCard(file), QString());
        QProcess reader;
        reader.start(QStringLiteral(PDFTOTEXT), {u"-layout"_s, file, u"-"_s});
        EXPECT_TRUE(reader.waitForFinished());
        return QString::fromUtf8(reader.readAllStandardOutput()).simplified();
    };
    const QString said = u"Weigh again first: piston of cylinder 3."_s;
    const QString advice = label("advice");
    auto* move = find<QPushButton>("move_parts");
    EXPECT_TRUE(move->isVisible());
    EXPECT_TRUE(printed().contains(u"Sets as suggested"_s));
    type("mass_piston_3", u"706"_s);
    EXPECT_EQ(label("advice"), said);
    EXPECT_EQ(find<QLabel>("advice")->palette().color(QPalette::WindowText),
              Theme::instance().warning());
    EXPECT_EQ(label("weigh_in_summary"), said);
    EXPECT_FALSE(move->isVisible());
    EXPECT_EQ(model->boringText(), QString());
    EXPECT_TRUE(model->crankpinResults().rows.isEmpty());
    const QString card = printed();
    EXPECT_EQ(card.count(said), 2) << "as the answer, and below the weights" << qPrintable(card);
    EXPECT_EQ(card.count(u"cylinder 3 weighs"_s), 1) << qPrintable(card);
    EXPECT_FALSE(card.contains(u"Sets as suggested"_s));
    EXPECT_FALSE(card.contains(u"lighter than nominal"_s) || card.contains(u"Machine all"_s));
    type("mass_piston_3", u"606"_s);
    EXPECT_EQ(label("advice"), advice);
}

TEST_F(V8PageTest, ColumnOfASpreadsheetIsPastedWithoutItsHeading) {
    page.sheets()->setCurrentIndex(2);
    NumberField* first = field("mass_piston_1");
    const auto paste = [&](const QString& text) {
        QGuiApplication::clipboard()->setText(text);
        first->setFocus();
        QTest::keyClick(first, Qt::Key_V, Qt::ControlModifier);
    };
    paste(u"Piston, g\tPin, g\r\n601,5\t151\r\n602\t\r\n603\t153\r\n"_s);
    const WeighIn& sheet = model->input().weigh_in.value();
    EXPECT_EQ(field("mass_piston_1")->value(), 601.5);
    EXPECT_EQ(field("mass_pin_3")->value(), 153.0);
    EXPECT_FALSE(sheet[Part::pin].mass[1]) << "a gap stays a gap";
    model->history()->undo();
    EXPECT_FALSE(model->input().weigh_in) << "the paste is one step";
    // Refused as a whole: a word, a mass out of range, more rows than cylinders.
    for (const QString& bad : {u"601\nheavy"_s, u"601\n-5"_s, u"1\n2\n3\n4\n5\n6\n7\n8\n9"_s}) {
        paste(bad);
        EXPECT_FALSE(model->input().weigh_in) << qPrintable(bad);
    }
    paste(u"1\n2\n3\n4\n5\n6\n7\n8\n"_s);
    EXPECT_EQ(field("mass_piston_8")->value(), 8.0);
}

}  // namespace
}  // namespace ravnoves
