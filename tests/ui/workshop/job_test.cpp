// The page Workshop by keys and mouse: a job without plugs.

#include "job_page_test.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTabBar>
#include <algorithm>

#include "model/case_document.h"
#include "page/part_views.h"
#include "shop/model/verdict.h"
#include "shown_number.h"
#include "text/preferences.h"
#include "workshop/journal_dialog.h"
#include "workshop/sheets.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace bob_weights;

TEST_F(JobPageTest, ShopCardByKeys) {
    EXPECT_EQ(label("headline"), u"Missing for the bob weight: one piston, big end of one rod"_s);
    EXPECT_EQ(rowsOf("Bob weight, line by line"), 0);
    typeShopCard();
    EXPECT_EQ(label("headline"), u"Bob weight 1505.2 g"_s);
    EXPECT_EQ(label("hang"), u"On each of the 4 crankpins."_s);
    EXPECT_TRUE(has(label("factor"), u"fully balanced"_s));
    EXPECT_EQ(rowsOf("Bob weight, line by line"), 11) << "8 parts, 2 subtotals, the sum";
    type("reciprocating_percent", u"52"_s);
    EXPECT_EQ(label("headline"), u"Bob weight 1545.0 g"_s) << "994.2 × 1.04 + 511";
}

TEST_F(CardJobTest, TheEngineBringsItsFactor) {
    type("cylinders", u"6"_s);
    type("pin_split_deg", u"30"_s);
    EXPECT_TRUE(begins(label("factor"), u"Balance factor 36.6 %"_s));
    keys("type", {Qt::Key_Down});
    EXPECT_EQ(model->input().engine.type, EngineType::in_line);
    EXPECT_EQ(model->input().engine.rods_per_pin, 1);
    EXPECT_EQ(model->input().engine.pin_split, 0.0);
    EXPECT_FALSE(field("bank_angle_deg")->isEnabled());
    EXPECT_TRUE(label("hang").contains(u"6"_s));
    model->history()->undo();
    EXPECT_EQ(model->input().engine.type, EngineType::v);
    EXPECT_EQ(model->input().engine.rods_per_pin, 2);
    // Two rods on a bob weight are of an even number of cylinders; one is of a VR5, too.
    type("cylinders", u"5"_s);
    EXPECT_TRUE(field("cylinders")->trouble().contains(u"5 is odd"_s));
    EXPECT_EQ(model->input().engine.cylinders, 6);
    model->edit(u"rods"_s, [](workshop::Input& input) { input.engine.rods_per_pin = 1; });
    type("cylinders", u"5"_s);
    EXPECT_EQ(model->input().engine.cylinders, 5);
    EXPECT_EQ(label("headline").contains(u"must"_s), false);
}

TEST_F(ReadJobTest, ASlugIsWholeOnTheCardWithItsMass) {
    EXPECT_FALSE(find<QComboBox>("slug_direction")->isEnabled()) << "no slugs";
    // Where no hole has a place.
    fill({{"from_1", "180"},
          {"to_1", "300"},
          {"slug_diameter_mm", "20.25"},
          {"slug_density_kg_m3", "17500"}});
    const auto& plane = (*model->solution().correction)[0];
    ASSERT_EQ(plane.slugs.size(), 1u);
    EXPECT_TRUE(find<QComboBox>("slug_direction")->isEnabled());
    const auto plain = [](QString text) { return text.replace(QChar(0x00A0), u' '); };
    // Its hole is drilled a wall and half its diameter below the rim.
    const QString name = u"slug ⌀ 20.25 mm, "_s +
                         plain(Words().number(plane.slugs[0].slug, units::gram, 1)) +
                         u", hole centre at R 71.9 mm"_s;
    EXPECT_TRUE(
        plain(model->holeResults().rows.at(0).at(0).text).startsWith(u"Front plane: "_s + name));
    EXPECT_EQ(model->holeResults().rows.at(1).at(0).text, u"parallel to the crankshaft"_s);
    const QString adds = u"adds "_s + Words().digits(plane.slugs[0].mass, units::gram, 2);
    EXPECT_EQ(model->holeResults().rows.at(0).at(3).text, adds);
    EXPECT_TRUE(label("hole_note").contains(u"its mass is given with its diameter"_s));
    const QString printed = cardText();
    EXPECT_TRUE(has(printed, name));
    EXPECT_TRUE(has(printed, adds));
    EXPECT_TRUE(has(printed, u"slugs are opposite it."_s)) << "it adds where a hole takes off";
    for (const auto& each : onCard.texts) {
        if (each.text.startsWith(u"slug"_s)) {
            EXPECT_GE(each.pixelSize, 10) << "7 points: it is read at the machine";
            break;
        }
    }
    static const QRegularExpression cut(u"\\w…"_s);
    EXPECT_FALSE(cut.match(printed).hasMatch()) << qPrintable(printed);
    EXPECT_TRUE(
        has(QString(printed).remove(u' '), u"crankshaftdensityof7850kg/m³,slugsof17500kg/m³."_s));
    // Once drilled, too.
    type("run_1_unbalance_1", u"100"_s);
    EXPECT_EQ(plain(model->drilledResults().rows.at(0).at(1).text), u"Front plane: "_s + name);
}

TEST_F(CardJobTest, TheBobWeightOfUnequalCrankpinsIsCalledTheirMean) {
    EXPECT_FALSE(card().contains(u"Masses of the parts"_s));
    model->editWeights(u"Weights"_s, [](WeighIn& sheet) {
        sheet[shop::Part::piston].mass.assign(8, 0.5839);
        sheet[shop::Part::piston].mass[2] = 0.5879;
    });
    EXPECT_EQ(label("headline"), u"Mean bob weight 1505.7 g"_s) << "half of 4 g on one of four";
    const QString single =
        u"g: 1505.2 (cylinders 1+5); 1505.2 (2+6); 1507.2 (3+7); 1505.2 (4+8)."_s;
    EXPECT_TRUE(has(label("hang"), single));
    const QString printed = cardText();
    EXPECT_TRUE(hasAll(printed, {label("headline"), single, u"Masses of the parts by cylinder, g"_s,
                                 u"Piston 583.90 583.90 587.90 583.90"_s,
                                 u"Cylinders that share a crankpin: 1+5; 2+6; 3+7; 4+8."_s}));
    // Alike, there is one bob weight.
    model->editWeights(u"Weights"_s,
                       [](WeighIn& sheet) { sheet[shop::Part::piston].mass[2] = 0.5839; });
    EXPECT_EQ(label("headline"), u"Bob weight 1505.2 g"_s);
}

TEST_F(CardJobTest, TheCardSaysWhetherPartsAreMovedAndWhatToTakeOffByTheirNumbers) {
    model->editWeights(u"Weights"_s, [](WeighIn& sheet) {
        sheet[shop::Part::piston].mass = {0.58, 0.59, 0.6, 0.61, 0.58, 0.59, 0.6, 0.61};
    });
    const QStringList weighed{u"Piston"_s, u"·"_s,     u"10.00"_s, u"20.00"_s, u"30.00"_s,
                              u"·"_s,      u"10.00"_s, u"20.00"_s, u"30.00"_s};
    const ResultRows sets = model->assignmentResults().rows;
    for (const bool isMoved : {false, true}) {
        if (isMoved) {
            model->moveParts();
            ASSERT_TRUE(model->input().weigh_in->is_moved());
        }
        EXPECT_EQ(model->assignmentResults().rows, sets) << "parts keep their numbers";
        const Results takeOff = model->takeOffResults();
        EXPECT_EQ(test::textsOf(takeOff.rows), QVector<QStringList>{weighed})
            << "wherever the pistons are now";
        EXPECT_EQ(takeOff.columns.front().heading, isMoved ? u"Part no."_s : u"Cylinder"_s);
        const QString printed = card();
        EXPECT_EQ(printed.contains(u"suggested, not yet applied"_s), !isMoved);
        EXPECT_EQ(printed.contains(u"Matched parts: applied"_s), isMoved);
        EXPECT_TRUE(printed.contains(takeOff.columns.front().heading + u"\n1\n2"_s));
        EXPECT_TRUE(has(printed, weighed.join(u'\n')));
        EXPECT_TRUE(has(printed, sets.at(0).texts().join(u'\n')));
    }
}

TEST_F(JobPageTest, CrankpinsThatBalanceOneAnotherNeedNoBobWeights) {
    const QString none = u"No bob weights are needed"_s;
    model->edit(u"engine"_s, [](workshop::Input& job) {
        job.engine = {EngineType::in_line, 4, std::nullopt, 1, 0.0};
    });
    EXPECT_EQ(label("headline"), none);
    for (const QString& said : {label("verdict"), card()}) {
        EXPECT_TRUE(has(said, none));
        EXPECT_FALSE(has(said, u"Missing for"_s));
    }
    typeShopCard();
    EXPECT_TRUE(begins(label("verdict"), none)) << "whatever the parts weigh";
    type("locks", QString());
    EXPECT_TRUE(begins(label("verdict"), none));
    type("locks", u"4.8"_s);
    const QString weight =
        u"Bob weight "_s + Words().digits(*model->solution().bob_weight, units::gram, 1);
    for (const QString& said : {label("verdict"), label("headline"), card()}) {
        EXPECT_TRUE(has(said, none));
        EXPECT_FALSE(has(said, weight));
    }
    EXPECT_TRUE(has(label("hang"), u"If you use bob weights: "_s));
    // What is missing is no reason for a job not to be finished.
    type("piston", QString());
    type("engine_number", u"4"_s);
    save();
    EXPECT_TRUE(jobs().at(0).isFinished);
    model->edit(u"engine"_s, [](workshop::Input& job) { job.engine.cylinders = 5; });
    EXPECT_TRUE(has(label("headline"), u"Missing for the bob weight: one piston"_s));
}

TEST_F(JobPageTest, ANewJobBeginsWithTheMachineThatIsKept) {
    const auto back = qScopeGuard([] { QSettings().clear(); });
    type("planes", u"left / right"_s);
    auto* keep = find<QPushButton>("keep_machine");
    ASSERT_FALSE(keep->isHidden());
    QTest::mouseClick(keep, Qt::LeftButton);
    EXPECT_TRUE(keep->isHidden());
    WorkshopPage other(QDir(folder.path()).filePath(u"journal.sqlite"_s), nullptr);
    EXPECT_EQ(other.viewModel()->planeName(1), u"Right"_s);
}

TEST_F(ReadJobTest, ANumberThatMayMeanThousandsSaysHowItWasRead) {
    typeRun(1, {u"900"_s, u"73"_s, u"100"_s, u"210"_s});
    const QString either = u"“1.100” was read as 1.1. Type 1100 if that is meant."_s;
    const struct {
        const char* field;
        const char* typed;
        bool isEither;
    } cases[] = {
        {"piston", "1.100", true},
        {"piston", "568.512", false},
        {"piston", "0.584", false},
        {"piston", "1.10", false},
        {"piston", "1.1000", false},
        {"piston", "1.100 kg", false},
        {"mass_piston_1", "1.100", true},
        {"mass_piston_1", "568.512", false},
        {"radius_1", "1.100", true},
        {"read_at_2", "1.100", true},
        {"unbalance_1", "1.100", true},
        {"angle_1", "1.100", false},
        {"rotor_mass_kg", "1.100", true},
        {"service_speed_rpm", "1.100", true},
        {"centre_of_mass_mm", "1.100", true},
        {"drilled_depth_1", "1.100", false},
        {"from_1", "1.100", false},
    };
    const auto isShown = [&] {
        const auto lines = page.findChildren<TroubleLine*>();
        return std::ranges::any_of(lines, [&](const TroubleLine* line) {
            return line->isVisible() && line->text().contains(either);
        });
    };
    for (const auto& each : cases) {
        SCOPED_TRACE(std::string(each.field) + ": " + each.typed);
        type(each.field, QString::fromLatin1(each.typed));
        EXPECT_EQ(field(each.field)->said().contains(either), each.isEither);
        EXPECT_EQ(field(each.field)->said().isEmpty(), !each.isEither);
        show(sheetOf(field(each.field)));
        EXPECT_EQ(isShown(), each.isEither);
        model->history()->undo();
        EXPECT_EQ(field(each.field)->said(), QString());
        EXPECT_FALSE(isShown());
    }
}

TEST_F(CardJobTest, NewPartsAreNotTheSetsThatWereMoved) {
    model->editWeights(u"Weights"_s, [](WeighIn& sheet) {
        sheet[shop::Part::piston].mass = {0.58, 0.59, 0.6, 0.61, 0.58, 0.59, 0.6, 0.61};
        sheet[shop::Part::rod_big_end].mass = {0.45, 0.46, 0.47, 0.48, 0.48, 0.47, 0.46, 0.45};
        sheet.piston_sets = sheet.rod_sets = {2, 1, 3, 4, 5, 6, 7, 8};
    });
    ASSERT_TRUE(model->canMoveBack());
    model->editWeights(u"Weights"_s, [](WeighIn& sheet) {
        sheet[shop::Part::piston].mass.assign(8, std::nullopt);
    });
    EXPECT_TRUE(model->input().weigh_in->piston_sets.empty());
    EXPECT_EQ(model->input().weigh_in->rod_sets.size(), 8U);
}

TEST_F(CardJobTest, NoPartIsMovedByDoubtedWeights) {
    const auto weigh = [&](double first, double bigEnd) {
        model->editWeights(u"Weights"_s, [&](WeighIn& sheet) {
            using shop::Part;
            sheet[Part::piston].mass = {first, 0.59, 0.6, 0.61, 0.58, 0.59, 0.6, 0.61};
            sheet[Part::rod_big_end].mass = {0.45,  bigEnd, 0.452, 0.454,
                                             0.451, 0.453,  0.455, 0.449};
            sheet[Part::rod_small_end].mass = {0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2};
        });
    };
    const QString suggested = u"suggested"_s;
    weigh(0.58, 0.45);
    EXPECT_TRUE(card().contains(suggested));
    EXPECT_FALSE(find<QPushButton>("move_parts")->isHidden());
    weigh(0.85, 0.45);
    EXPECT_TRUE(has(label("verdict"), u"more than 6 times their scatter"_s)) << "as the help says";
    for (const auto& [first, bigEnd, said] :
         {std::tuple{0.85, 0.45, u"Weigh again first: piston of cylinder 1."_s},
          std::tuple{0.58, 0.15, u"Weigh again first: rod of cylinder 2."_s}}) {
        weigh(first, bigEnd);
        EXPECT_FALSE(has(card(), suggested));
        EXPECT_TRUE(has(card(), said));
        EXPECT_EQ(label("weigh_in_summary"), said);
        EXPECT_TRUE(isAmber("weigh_in_summary"));
        EXPECT_TRUE(find<QPushButton>("move_parts")->isHidden());
        EXPECT_TRUE(model->effectResults().rows.isEmpty());
    }
}

TEST_F(ReadJobTest, TheCardHasEveryWarningOfThePage) {
    type("oil", QString());
    const auto isOnCard = [&] {
        const QString printed = cardText();
        for (const QString& each : model->troubles()) {
            EXPECT_TRUE(printed.contains(QString(each).replace(QChar(0x00A0), u' ')))
                << qPrintable(each) << qPrintable(printed);
        }
        return model->troubles().join(u'\n');
    };
    const auto edit = [&](const std::function<void(Correction&)>& change) {
        model->editCorrection(u"change"_s, change);
    };
    EXPECT_TRUE(isOnCard().contains(u"Not given, 0"_s));
    const auto box = std::ranges::find_if(
        onCard.texts, [](const auto& each) { return each.text.startsWith(u"Not given"_s); });
    const auto table = std::ranges::find_if(onCard.texts, [](const auto& each) {
        return each.text == u"Readings of the balancing machine"_s;
    });
    EXPECT_LT(box->ink.bottom(), table->ink.top()) << "beside the number that it concerns";
    edit([](Correction& it) { it.slug = Slug{0.02, std::nullopt}; });
    EXPECT_TRUE(isOnCard().contains(u"enter Slug density"_s));
    edit([](Correction& it) {
        it.slug.reset();
        it.readings[0].position = -3.0;
    });
    isOnCard();
    type("oil", u"4"_s);  // which stops no reading any more
    const QString printed = cardText();
    EXPECT_TRUE(has(printed, u"far outside the planes"_s));
    // As a file may have it.
    Json input = model->inputJson();
    input["correction"]["planes"][1]["position_mm"] = 60;
    model->loadInput(input, {});
    EXPECT_TRUE(isOnCard().contains(u"Rear plane, position: must differ"_s)) << qPrintable(card());
    edit([](Correction& it) { it.readings[1].unbalance.reset(); });
    isOnCard();
}

TEST_F(JobPageTest, CylindersInLineAreNotPaired) {
    auto* pairs = find<QComboBox>("cylinder_numbering");
    EXPECT_TRUE(pairs->isEnabled());
    model->edit(u"type"_s, [](workshop::Input& input) {
        input.engine.type = EngineType::in_line;
        input.engine.rods_per_pin = 1;
    });
    EXPECT_FALSE(pairs->isEnabled());
    EXPECT_TRUE(pairs->toolTip().contains(u"In line each cylinder has a crankpin of its own"_s));
}

TEST_F(ReadJobTest, ReadingsBecomeHoles) {
    ASSERT_TRUE(model->solution().correction);
    EXPECT_EQ(rowsOf("The correction planes"), 4) << "a row for each quantity that is known";
    EXPECT_EQ(rowsOf("Holes and slugs"), 2);
    EXPECT_EQ(label("troubles").count(u"enter the drilling sector"_s), 2);
    EXPECT_EQ(label("troubles").count(u'\n'), 1) << label("troubles").toStdString();
    const Hole& hole = (*model->solution().correction)[0].holes.at(0);
    EXPECT_NEAR(hole.angle, 75 * degree, 1e-9);
    // Another drill: a word that is none is rejected, the drills before it stay.
    type("diameters_mm", u"8 wide"_s);
    // The name of the field stands before it already.
    EXPECT_EQ(test::named<EntryField>(page, "diameters_mm")->trouble(),
              u"Must be numbers with blanks or semicolons between them, got \"wide\""_s);
    EXPECT_EQ(model->input().correction->drill.diameters_mm.size(), 4u);
    type("diameters_mm", u"8"_s);
    EXPECT_GT((*model->solution().correction)[0].holes.size(), 1u);
    EXPECT_EQ(label("diameters_mm_understood"), u"Read as one value: 8 mm"_s);
    type("diameters_mm", u"8, 10, 12, 5"_s);
    EXPECT_EQ(label("diameters_mm_understood"), u"Read as 4: 8; 10; 12; 5 mm"_s);
    // A sector that ends at the heavy spot: whole holes are in it.
    type("from_1", u"75"_s);
    type("to_1", u"180"_s);
    EXPECT_GT((*model->solution().correction)[0].holes.at(0).angle, 77 * degree);
    EXPECT_FALSE(label("verdict").contains(u"the edge of a hole is "_s));
    // A sector elsewhere: no hole, and the page says what to do.
    type("from_1", u"180"_s);
    type("to_1", u"300"_s);
    EXPECT_TRUE(has(label("troubles"), u"outside the drilling sector"_s));
    fill({{"from_2", "20"}, {"to_2", "100"}});
    limitTo(400);
    const QString impossible = u"FAIL: no hole is possible"_s;
    EXPECT_EQ(model->planeResults().rows.last().texts(),
              QStringList({u"Verdict"_s, impossible, impossible}));
    EXPECT_TRUE(has(label("verdict"), u"No hole is possible."_s));
    EXPECT_TRUE(card().contains(impossible));
    EXPECT_EQ(verdictText(Words(), model->verdictNow()), impossible) << "in the journal";
    type("slug_diameter_mm", u"20"_s);
    type("slug_density_kg_m3", u"17500"_s);
    EXPECT_FALSE((*model->solution().correction)[0].slugs.empty());
}

TEST_F(CardJobTest, WeighedPartsGoBeforeTypedOnes) {
    type("cylinders", u"2"_s);
    EXPECT_FALSE(field("mass_piston_3")->isVisibleTo(&page));
    type("mass_piston_1", u"590"_s);
    EXPECT_EQ(label("headline"), u"Bob weight 1505.2 g"_s) << "not all are weighed yet";
    type("mass_piston_2", u"592"_s);
    EXPECT_EQ(label("headline"), u"Bob weight 1512.3 g"_s);
    EXPECT_FALSE(field("piston")->isEnabled());
    EXPECT_EQ(test::textsOf(model->takeOffResults().rows),
              (QVector<QStringList>{{u"Piston"_s, u"·"_s, u"2.00"_s}}));
    // Swapped rods: nobody is told to grind them to each other.
    fill({{"mass_rod_big_end_1", "160"},
          {"mass_rod_big_end_2", "162"},
          {"mass_rod_small_end_1", "230"},
          {"mass_rod_small_end_2", "231"}});
    EXPECT_TRUE(has(label("verdict"), u"the big end weighs less than the small end"_s));
    EXPECT_EQ(model->takeOffResults().rows.size(), 1) << "the pistons'";
    click("verdict_act");
    // A mean that is what was typed before stands in its place as any other.
    type("mass_piston_1", u"583.9"_s);
    type("mass_piston_2", u"583.9"_s);
    EXPECT_FALSE(field("piston")->isEnabled());
    type("cylinders", u"4"_s);
    EXPECT_EQ(label("headline"), u"Bob weight 1505.2 g"_s) << "two of four are weighed";
}

TEST_F(CardJobTest, PartsAreMatchedByTheRulesOfTheSheet) {
    const std::vector<double> pistons{584.1, 586.3, 583.2, 588.9, 585.0, 583.9, 587.4, 584.4};
    const std::vector<double> ends{229.0, 231.5, 230.2, 229.9, 233.0, 229.4, 230.0, 231.1};
    weigh("piston", pistons);
    weigh("rod_big_end", ends);
    EXPECT_EQ(rowsOf("Mass to take off each part to match the lightest"), 2);
    const auto placing = [&] { return model->solution().placing.value(); };
    const std::vector<int> asItIs{0, 1, 2, 3, 4, 5, 6, 7};
    EXPECT_TRUE(placing().proven);
    EXPECT_NE(placing().pistons, asItIs);
    EXPECT_LT(placing().after.spread, 0.1 * placing().before.spread);
    // Pistons fitted to their bores, rods that face their side.
    keys("moves_pistons", {Qt::Key_End});
    keys("moves_rods", {Qt::Key_Down});
    EXPECT_EQ(model->input().weigh_in->matching.pistons, shop::SetMoves::stays);
    EXPECT_EQ(model->input().weigh_in->matching.rods, shop::SetMoves::within_bank);
    EXPECT_EQ(placing().pistons, asItIs);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(placing().rods[i] / 4, static_cast<int>(i) / 4);
    }
    // What the engine feels; what it lacks is said.
    auto* moves = field("permitted_crankpin_spread");
    EXPECT_FALSE(moves->isVisibleTo(&page));
    keys("goal", {Qt::Key_Down});
    EXPECT_TRUE(moves->isVisibleTo(&page));
    EXPECT_TRUE(label("weigh_in_summary").contains(u"is missing"_s));
    type("permitted_crankpin_spread", u"3"_s);
    EXPECT_EQ(placing().goal, shop::MatchingGoal::fewest_moves);
    EXPECT_LE(placing().after.spread, 3e-3 + 1e-9);
    keys("goal", {Qt::Key_Down});
    EXPECT_EQ(rowsOf("Effect of the matching"), 3);
    EXPECT_TRUE(label("weigh_in_summary").contains(u"0°; 90°; 270°; 180°"_s));
    fill({{"cylinder_spacing_mm", "112"},
          {"matching_crank_radius", "44"},
          {"service_speed_rpm", "6000"}});
    EXPECT_EQ(rowsOf("Effect of the matching"), 6);
    type("crankpin_angles_deg", u"0; 180; 180"_s);
    EXPECT_EQ(placing().goal, shop::MatchingGoal::min_spread);
    EXPECT_TRUE(label("weigh_in_summary").contains(u"4 angles of the crankpins"_s));
    type("crankpin_angles_deg", u"0 180 180 0"_s);
    EXPECT_EQ(placing().goal, shop::MatchingGoal::min_shaking);
    EXPECT_LT(placing().after.shaking->ends, placing().before.shaking->ends);
    // The weights move as the parts do, which keep their numbers.
    const auto wanted = placing();
    auto* move = find<QPushButton>("move_parts");
    ASSERT_TRUE(move->isVisibleTo(&page));
    QTest::mouseClick(move, Qt::LeftButton);
    EXPECT_FALSE(move->isVisibleTo(&page));
    EXPECT_EQ(placing().moved, 0);
    EXPECT_EQ(page.focusWidget(), find<QWidget>("move_back")) << "the button in its place";
    EXPECT_NEAR(placing().after.spread, wanted.after.spread, 1e-12);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(model->input().weigh_in->rod_sets[i], wanted.rods[i] + 1);
    }
    EXPECT_TRUE(model->input().weigh_in->piston_sets.empty());
    const QString printed = card();
    EXPECT_TRUE(has(printed, u"Rod set from"_s));
    const qsizetype placed = printed.indexOf(u"Matched parts"_s);
    const qsizetype takesOff =
        printed.indexOf(u"To match the lightest part, only if moving is not enough: take off, g"_s);
    EXPECT_TRUE(placed >= 0 && printed.indexOf(u"Rod set from"_s, placed) < takesOff)
        << "taking off is another thing than moving: " << qPrintable(printed);
    EXPECT_GT(printed.indexOf(u"Piston\n"_s, takesOff), takesOff);
    EXPECT_TRUE(printed.contains(u"weigh parts again after making them lighter."_s));
    EXPECT_TRUE(printed.contains(u"Assemble by set numbers"_s));
    // What was weighed is still known, and comes back by a button.
    auto* back = find<QPushButton>("move_back");
    EXPECT_TRUE(back->isVisibleTo(&page));
    EXPECT_FALSE(find<QComboBox>("moves_pins")->isEnabled()) << "the pins went with their pistons";
    EXPECT_TRUE(find<QComboBox>("moves_rods")->isEnabled());
    const auto effects = model->effectResults().rows;
    EXPECT_EQ(effects.at(0).at(1), Words().number(wanted.before.spread, units::gram, 2));
    EXPECT_EQ(effects.at(0).at(2), Words().number(wanted.after.spread, units::gram, 2));
    QTest::mouseClick(back, Qt::LeftButton);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_NEAR(*(*model->input().weigh_in)[shop::Part::rod_big_end].mass[i],
                    ends[i] * units::gram, 1e-12);
        EXPECT_NEAR(*(*model->input().weigh_in)[shop::Part::piston].mass[i],
                    pistons[i] * units::gram, 1e-12);
    }
    EXPECT_FALSE(back->isVisibleTo(&page));
    EXPECT_EQ(page.focusWidget(), move);
    EXPECT_TRUE(find<QComboBox>("moves_pins")->isEnabled());
    model->history()->undo();
    EXPECT_EQ(placing().moved, 0) << "moved again";
    // Kept by the next job but for the weights.
    const workshop::Input kept = model->input();
    model->newJob();
    EXPECT_EQ(model->input().weigh_in->matching, kept.weigh_in->matching);
    EXPECT_TRUE(model->input().weigh_in->is_empty());
    EXPECT_FALSE(model->input().weigh_in->is_moved());
}

TEST_F(CardJobTest, MovedPartsOutliveAnotherNumberOfCylinders) {
    weigh("piston", {584, 586, 588, 590, 592, 584, 586, 588});
    weigh("rod_big_end", {231, 230, 229, 228, 227, 226, 225, 224});
    model->moveParts();
    ASSERT_TRUE(model->input().weigh_in->is_moved());
    const auto weighed = (*model->input().weigh_in)[shop::Part::piston].mass;
    const double mean = *model->solution().bob_weight;
    for (const char* cylinders : {"4", "6", "12", "8"}) {
        type("cylinders", QLatin1String(cylinders));
        EXPECT_EQ(model->placing() != nullptr, std::atoi(cylinders) <= 8) << cylinders;
        // The numbers of the sets are those of eight.
        const bool isWhole = std::atoi(cylinders) == 8;
        EXPECT_NE(find<QPushButton>("move_back")->isHidden(), isWhole) << cylinders;
        if (!isWhole) {
            model->moveBack();
            for (const ResultColumn& column : model->effectResults().columns) {
                EXPECT_NE(column.heading, u"as weighed"_s) << cylinders;
            }
            EXPECT_FALSE(model->assignmentText().contains(u"as weighed"_s)) << cylinders;
        }
        EXPECT_FALSE(page.grab().isNull());
    }
    EXPECT_EQ((*model->input().weigh_in)[shop::Part::piston].mass, weighed);
    EXPECT_NEAR(*model->solution().bob_weight, mean, 1e-12);
}

TEST_F(ReadJobTest, ReadingsHoldForTheirBobWeightAlone) {
    typeLimit(u"3000"_s);
    EXPECT_EQ(verdict(), u"Passes"_s);
    auto* hold = find<QPushButton>("readings_hold");
    EXPECT_FALSE(hold->isVisibleTo(&page));
    type("piston", u"583.92"_s);
    EXPECT_EQ(verdict(), u"Passes"_s) << "no tenth of a gram";
    type("piston", u"590"_s);
    const QString why =
        u"The readings were taken with another bob weight: 1505.2 g then, 1511.3 g "
        u"now."_s;
    EXPECT_TRUE(begins(label("verdict"), u"STOP. "_s + why));
    EXPECT_TRUE(label("other_bob_weight").startsWith(why));
    EXPECT_TRUE(model->holeResults().rows.isEmpty()) << "nothing is to be drilled";
    EXPECT_TRUE(model->planeResults().rows.last().texts().contains(u"another bob weight"_s));
    EXPECT_EQ(model->planeResults().rows.size(), 2) << "nothing is known to remain";
    EXPECT_TRUE(field("unbalance_1")->isDoubtful());
    EXPECT_FALSE(field("position_1")->isDoubtful());
    EXPECT_EQ(sheets->tabBar()->tabTextColor(4), Theme::instance().warning());
    EXPECT_TRUE(card().contains(why.left(55)));
    EXPECT_FALSE(card().contains(u"PASS"_s));
    EXPECT_NEAR(model->resultJson()["correction"]["read_with_bobweight_g"].get<double>(), 1505.2,
                1e-9);
    type("engine_number", u"53-1"_s);
    save();
    ASSERT_EQ(jobs().size(), 1);
    EXPECT_EQ(jobs().at(0).verdict, u"other-bob-weight"_s);
    EXPECT_EQ(verdictText(Words(), jobs().at(0).verdict), u"another bob weight"_s);
    // The mass comes from the weigh-in sheet, too; and back with it all holds.
    type("piston", u"583.9"_s);
    EXPECT_EQ(verdict(), u"Passes"_s);
    EXPECT_FALSE(field("unbalance_1")->isDoubtful());
    EXPECT_FALSE(sheets->tabBar()->tabTextColor(4).isValid());
    // A verdict is not lost without a word.
    save();
    EXPECT_EQ(jobs().at(0).verdict, u"passes"_s);
    type("piston", u"590"_s);
    EXPECT_TRUE(saveAnd(u"Cancel"_s).contains(u"another bob weight"_s));
    whenModal<QMessageBox>(
        [](QMessageBox* box) { QTest::mouseClick(box->defaultButton(), Qt::LeftButton); });
    save();
    ASSERT_EQ(jobs().size(), 1) << "nor is there a second job";
    EXPECT_EQ(jobs().at(0).verdict, u"passes"_s);
    fill({{"piston", "583.9"},
          {"cylinders", "2"},
          {"mass_piston_1", "590"},
          {"mass_piston_2", "592"}});
    EXPECT_EQ(verdict(), u"STOP"_s);
    // A technician who knows better says so; or the machine reads again.
    show(MachineTab);
    ASSERT_TRUE(hold->isVisibleTo(&page));
    QTest::mouseClick(hold, Qt::LeftButton);
    EXPECT_EQ(verdict(), u"Passes"_s);
    EXPECT_FALSE(hold->isVisibleTo(&page));
    model->history()->undo();
    EXPECT_EQ(verdict(), u"STOP"_s);
    // Read again is typed again, be the numbers the same; half a reading is none of this weight.
    const Json stopped = model->inputJson();
    type("unbalance_1", u"2600"_s);
    EXPECT_EQ(field("angle_1")->text(), QString());
    EXPECT_EQ(verdict(), u"STOP"_s);
    fill({{"angle_1", "75"}, {"angle_2", "210"}, {"unbalance_2", "1450"}});
    EXPECT_EQ(verdict(), u"Passes"_s);
    EXPECT_FALSE(hold->isVisibleTo(&page));
    model->loadInput(stopped, {});
    EXPECT_EQ(verdict(), u"STOP"_s);
    typeRun(1, {u"100"_s, u"10"_s, u"100"_s, u"20"_s});
    EXPECT_EQ(verdict(), u"Passes"_s);
    EXPECT_EQ(model->runResults().rows.at(0).constLast(), u"another bob weight"_s);
    EXPECT_EQ(model->runResults().rows.at(1).constLast(), u"PASS"_s);
    // A case of before keeps no bob weight: the readings are of the one that it came with.
    Json old = model->inputJson();
    for (Json& reading : old["correction"]["readings"]) {
        reading.erase("bobweight_g");
    }
    model->loadInput(old, {});
    EXPECT_EQ(verdict(), u"Passes"_s);
    type("big_end", u"260"_s);
    EXPECT_EQ(verdict(), u"STOP"_s);
}

TEST_F(ReadJobTest, ReadingsOfTheNextJobAreOfNoBobWeightBeforeIt) {
    typeLimit(u"3000"_s);
    model->loadInput(model->inputJson(), {});  // as one that is opened
    model->newJob();
    fill({{"unbalance_1", "2600"}, {"angle_1", "75"}, {"unbalance_2", "1450"}, {"angle_2", "210"}});
    typeShopCard();
    type("piston", u"590"_s);
    for (const std::size_t plane : {0U, 1U}) {
        EXPECT_EQ(model->reading(0, plane).bob_weight, std::nullopt) << plane;
    }
    EXPECT_EQ(verdict(), u"Passes"_s) << qPrintable(label("verdict"));
}

TEST_F(CardJobTest, TheSheetsOfTheMachineBeginWithItsAnswer) {
    for (const Sheet sheet : {MachineTab, CorrectionTab}) {
        show(sheet);
        EXPECT_EQ(label("correction"), u"Enter the readings of both planes."_s);
        EXPECT_FALSE(find<QLabel>("headline")->isVisible());
    }
    typeReadings();
    EXPECT_EQ(label("correction"), u"Enter the permissible residual."_s);
    const auto answered = [&](double limit, const QString& expected, Ink ink) {
        limitTo(limit);
        show(CorrectionTab);
        EXPECT_EQ(label("correction"), expected);
        EXPECT_EQ(colour("correction"), (Theme::instance().*ink)());
        EXPECT_FALSE(find<QLabel>("headline")->isVisible());
        show(PartsTab);
        EXPECT_TRUE(label("headline").startsWith(u"Bob weight "_s));
        EXPECT_FALSE(find<QLabel>("correction")->isVisible());
    };
    answered(3000, u"PASS"_s, &Theme::good);
    answered(100, u"FAIL → drill, then PASS"_s, &Theme::warning);
    type("piston", u"690"_s);
    answered(100, u"STOP: do not drill yet"_s, &Theme::error);
}

TEST_F(ReadJobTest, APassBesideAWarningSaysSoOnPageCardAndInTheJournal) {
    limitTo(3000);
    type("engine_number", u"53-1"_s);
    save();
    EXPECT_EQ(jobs().at(0).verdict, u"passes"_s);
    type("diameters_mm", u"9.87"_s);
    EXPECT_EQ(model->verdictShown()->severity, Severity::warning);
    EXPECT_TRUE(label("troubles").contains(u"A drill of 9.87 mm is unusual."_s));
    const QString said = u"PASS, but see the warnings"_s;
    EXPECT_EQ(label("correction"), said);
    EXPECT_TRUE(card().contains(said));
    save();
    EXPECT_EQ(jobs().at(0).verdict, u"passes-with-warnings"_s);
    EXPECT_EQ(verdictText(Words(), jobs().at(0).verdict), said);
    EXPECT_TRUE(jobs().at(0).isFinished);
}

TEST_F(ReadJobTest, APassWithoutItsLastAngleSaysSoOnPageCardAndInTheJournal) {
    type("engine_number", u"53-1"_s);
    typeRun(1, {u"60"_s, u"100"_s, u"150"_s});
    limitTo(3000);
    const QString missing = u"Run 1, Rear plane: enter the angle."_s;
    const QString said = u"PASS, but see the warnings"_s;
    EXPECT_EQ(label("troubles").count(missing), 1) << qPrintable(label("troubles"));
    EXPECT_EQ(label("correction"), said);
    EXPECT_TRUE(hasAll(cardText(), {missing, said}));
    EXPECT_TRUE(begins(model->runResults().rows.at(1).at(1).text, u"60.0 ∠ 100"_s));
    EXPECT_EQ(model->runResults().rows.at(1).at(2).text, u"150.0"_s);
    save();
    EXPECT_EQ(jobs().at(0).verdict, u"passes-with-warnings"_s);
    EXPECT_FALSE(jobs().at(0).isFinished);
    EXPECT_EQ(model->answerLacks(), u"Enter the angles of the readings."_s);
    type("run_1_angle_2", u"270"_s);
    EXPECT_EQ(label("correction"), u"PASS"_s);
    EXPECT_EQ(model->answerLacks(), QString());
}

TEST_F(JobPageTest, AKeyOfTheWindowTypesNothing) {
    show(PartsTab);
    type("piston", u"583.9"_s);
    auto* piston = field("piston");
    piston->setFocus();
    piston->deselect();
    for (const auto& [modifiers, text] :
         {std::pair(Qt::AltModifier, u"583.9"_s), std::pair(Qt::NoModifier, u"4583.9"_s)}) {
        QKeyEvent key(QEvent::KeyPress, Qt::Key_4, modifiers, u"4"_s);
        piston->setCursorPosition(0);
        QApplication::sendEvent(piston, &key);  // without plugs there is no sheet 4
        EXPECT_EQ(piston->text(), text);
    }
}

TEST_F(CardJobTest, AReadingInGramsIsAtTheDrillingRadius) {
    type("unbalance_1", u"35 g"_s);
    EXPECT_EQ(field("unbalance_1")->trouble(),
              u"Grams need the drilling radius of the plane: enter it first. If two planes have "
              u"different radii, enter g·mm."_s);
    typeReadings();
    type("unbalance_1", u"35 g"_s);
    EXPECT_NEAR(*model->reading(0, 0).unbalance, 35 * 85 * units::gram_mm, 1e-12);
    EXPECT_EQ(field("unbalance_1")->text(), u"2975"_s);
    EXPECT_TRUE(begins(field("unbalance_1")->said(), u"“35 g” at a radius of 85.0"_s));
    // Typed without the unit they would pass, and are asked about.
    limitTo(400);
    fill({{"unbalance_1", "35"}, {"unbalance_2", "20"}});
    EXPECT_EQ(verdict(), u"Passes"_s);
    EXPECT_TRUE(has(label("troubles"), u"enter them with their unit: 35 g."_s));
    // So is the limit of a plane.
    type("g_mm", u"5 g"_s);
    EXPECT_NEAR(*model->input().tolerance->plane, 5 * 85 * units::gram_mm, 1e-12);
    type("radius_2", u"90"_s);
    type("g_mm", u"6 g"_s);
    EXPECT_TRUE(field("g_mm")->trouble().endsWith(u"different radii, enter g·mm."_s));
}

TEST_F(JobPageTest, ACommaBetweenDrillsIsNoDecimalSign) {
    typeReadings();
    const std::vector<double> read = model->input().correction->drill.diameters_mm;
    // A comma between what is no drill may be between two.
    type("diameters_mm", u"10,12"_s);
    EXPECT_EQ(find<EntryField>("diameters_mm")->trouble(),
              u"Must be two numbers or one: enter \"10; 12\" or \"10.12\", got \"10,12\""_s);
    EXPECT_EQ(model->input().correction->drill.diameters_mm, read);
    EXPECT_EQ(label("diameters_mm_understood"), QString());
    type("diameters_mm", u"12 mm; 10 mm"_s);
    EXPECT_EQ(label("diameters_mm_understood"), u"Read as 2: 12; 10 mm"_s);
    // A click selects all: the next drill joins no digits.
    auto* drills = find<EntryField>("diameters_mm");
    drills->clearFocus();
    QTest::mouseClick(drills, Qt::LeftButton);
    EXPECT_EQ(drills->selectedText(), drills->text());
}

TEST_F(ReadJobTest, ReadingsAreOfTheirCrankshaftAlone) {
    limitTo(3000);
    type("crankshaft_number", u"A"_s);
    EXPECT_EQ(verdict(), u"Passes"_s) << "a number that comes later";
    type("crankshaft_number", u"B"_s);
    EXPECT_EQ(verdict(), u"STOP"_s);
    EXPECT_TRUE(begins(label("verdict"),
                       u"STOP. The readings are of another crankshaft: number A then, B now."_s));
    EXPECT_TRUE(field("unbalance_1")->isDoubtful());
    EXPECT_TRUE(model->holeResults().rows.isEmpty());
    EXPECT_EQ(model->resultJson()["correction"]["read_on"], "A");
    // As the file keeps it.
    model->loadInput(model->inputJson(), {});
    EXPECT_EQ(verdict(), u"STOP"_s);
    typeRun(1, {u"100"_s, u"10"_s, u"100"_s, u"20"_s});
    EXPECT_EQ(verdict(), u"Passes"_s);
    EXPECT_EQ(model->runResults().rows.at(0).constLast(), u"another crankshaft"_s);
    type("crankshaft_number", u"C"_s);
    auto* hold = find<QPushButton>("readings_hold");
    show(MachineTab);
    ASSERT_TRUE(hold->isVisibleTo(&page));
    test::showAt(page, {915, 560});
    auto* const sheet = qobject_cast<QScrollArea*>(sheets->widget(4));
    sheet->ensureWidgetVisible(hold);
    const int scrolled = sheet->verticalScrollBar()->value();
    hold->setFocus();
    QTest::mouseClick(hold, Qt::LeftButton);
    EXPECT_EQ(verdict(), u"Passes"_s);
    EXPECT_EQ(model->runResults().rows.at(0).constLast(), u"another crankshaft"_s) << "that of A";
    EXPECT_TRUE(hold->hasFocus());
    QTest::mouseClick(hold, Qt::LeftButton);
    EXPECT_FALSE(hold->isVisible());
    EXPECT_EQ(QApplication::focusWidget(), field("unbalance_1"))
        << "all are there, and nothing is to be drilled";
    EXPECT_EQ(sheet->verticalScrollBar()->value(), scrolled);
}

TEST_F(ReadJobTest, WhatIsMissingIsSaidWithItsPlace) {
    const struct {
        const char* field;
        const char* wrong;
        const char* right;
        QString said;
    } cases[] = {{"radius_1", "", "85",
                  u"Sheet 5, Front plane: enter Radius. From the axis to the drilled rim"_s},
                 {"diameters_mm", "", "8",
                  u"Sheet 6, drills: enter Drills in mm, separated by semicolons: 8; 10; 12.5"_s},
                 {"maximum_depth_mm", "", "20", u"Sheet 6, drills: enter Maximum depth."_s},
                 {"slug_density_kg_m3", "17000", "",
                  u"Sheet 6, heavy metal: enter Slug diameter. Diameter of the available slugs."_s},
                 {"grade_mm_s", "6.3", "", u"Sheet 5, permissible residual: "_s}};
    for (const auto& each : cases) {
        type(each.field, QString::fromLatin1(each.wrong));
        EXPECT_TRUE(has(label("troubles"), each.said));
        EXPECT_FALSE(has(label("troubles"), u"missing"_s));
        type(each.field, QString::fromLatin1(each.right));
        EXPECT_FALSE(has(label("troubles"), each.said));
    }
}

TEST_F(JobPageTest, AJobWithoutNumbersIsNotSavedAndNoneIsFinishedUnfound) {
    type("cylinders", u"6"_s);
    EXPECT_TRUE(saveAnd(u"OK"_s).startsWith(u"The sheet is empty: not saved."_s));
    EXPECT_TRUE(jobs().isEmpty());
    type("cylinders", u"8"_s);
    typeShopCard();
    show(MachineTab);
    EXPECT_TRUE(saveAnd(u"Enter one"_s).contains(u"the journal could not find the job"_s));
    EXPECT_TRUE(jobs().isEmpty());
    EXPECT_EQ(page.focusWidget(), find<QWidget>("engine_number"));
    saveAnd(u"Save without"_s);
    ASSERT_EQ(jobs().size(), 1);
    EXPECT_FALSE(jobs().at(0).isFinished) << "nobody could find it";
    type("crankshaft_number", u"77"_s);
    save();
    ASSERT_EQ(jobs().size(), 1);
    EXPECT_TRUE(jobs().at(0).isFinished);
    type("piston", QString());
    save();
    EXPECT_FALSE(jobs().at(0).isFinished) << "there is no answer any more";
}

TEST_F(ReadJobTest, LimitsComeByGradeOrByHand) {
    type("customer", u"Smith"_s);
    auto* grades = find<QComboBox>("grade_list");
    grades->setCurrentIndex(5);
    keys("grade_list", {Qt::Key_Down});  // G 16
    EXPECT_NEAR(*model->input().tolerance->grade, 16e-3, 1e-12);
    type("rotor_mass_kg", u"32"_s);
    type("service_speed_rpm", u"6000"_s);
    // By hand: 32 kg × 16 mm/s ÷ (6000 · 2π ÷ 60) ÷ 2 = 407.4 g·mm, ÷ 85 mm = 4.79 g.
    EXPECT_TRUE(has(label("limits"), u"407.4 g·mm (4.79 g at R 85 mm) in each plane"_s));
    auto* own = find<QCheckBox>("own_limit");
    show(MachineTab);
    QTest::mouseClick(own, Qt::LeftButton, Qt::NoModifier, {8, own->height() / 2});
    EXPECT_FALSE(model->input().tolerance->by_grade);
    type("g_mm", u"3000"_s);
    EXPECT_EQ(rowsOf("Holes and slugs"), 0) << "both readings are within the limit";
    EXPECT_EQ(model->planeResults().rows.last().texts(),
              QStringList({u"Verdict"_s, u"PASS"_s, u"PASS"_s}));
    EXPECT_EQ(verdict(), u"Passes"_s);
    EXPECT_TRUE(card().contains(u"Shop limit"_s));
    type("g_mm", u"2000"_s);
    EXPECT_EQ(model->planeResults().rows.last().texts(),
              QStringList({u"Verdict"_s, u"FAIL → drill, then PASS"_s, u"PASS"_s}));
    EXPECT_EQ(verdict(), u"Fails"_s);
    EXPECT_TRUE(label("verdict").contains(u"After the planned correction: "_s));
    save();
    EXPECT_EQ(jobs().at(0).verdict, u"fails-then-passes"_s);
    EXPECT_TRUE(card().contains(u"FAIL → drill, then PASS"_s));
    // What was typed into a limit that a grade replaces waits for nobody.
    type("g_mm", u"5 wide"_s);
    EXPECT_FALSE(label("rejected").isEmpty());
    keys("grade_list", {Qt::Key_Down});
    EXPECT_TRUE(model->input().tolerance->by_grade);
    EXPECT_FALSE(field("g_mm")->isEnabled());
    EXPECT_EQ(field("g_mm")->text() + field("g_mm")->trouble(), QString());
    EXPECT_EQ(label("rejected"), QString());
}

TEST_F(ReadJobTest, ARejectedEntryLeavesNothingOnTheCardToBeSetOrDrilled) {
    limitTo(2000);
    weigh("piston", {583.9, 584.9, 583.9, 583.9, 583.9, 583.9, 583.9, 583.9});
    model->confirmReadings();  // of the bob weight by these pistons
    ASSERT_TRUE(model->solution().is_planned());
    const QStringList answers{model->holeResults().columns[3].heading,
                              u"After correction"_s,
                              Words().digits(*model->solution().bob_weight, units::gram, 1),
                              u"Balance factor"_s,
                              u"FAIL"_s,
                              u"Permissible residual: "_s,
                              u"take off"_s};
    ASSERT_TRUE(hasAll(card(), answers));
    const QString printed = card({u"Unbalance: no number"_s});
    EXPECT_TRUE(hasAll(printed.simplified(),
                       {u"STOP: no bob weight yet"_s,
                        u"until these entries are corrected: Unbalance: no number"_s}));
    EXPECT_TRUE(has(printed, u"2600"_s)) << "what was read is a record";
    for (const QString& each : answers) {
        EXPECT_FALSE(has(printed, each));
    }
}

TEST_F(ReadJobTest, JournalAndCard) {
    type("engine_number", u"ZMZ-53 7"_s);
    save();
    EXPECT_GT(model->desk()->jobId(), 0);
    const auto jobs = this->jobs();
    ASSERT_EQ(jobs.size(), 1);
    EXPECT_NEAR(*jobs[0].bobWeight, 1505.2, 1e-9);
    EXPECT_NEAR(*jobs[0].frontReading, 2600, 1e-9);
    // The list has the engine in the language of its reader.
    model->edit(u"engine"_s, [](workshop::Input& job) {
        job.engine = {EngineType::in_line, 4, std::nullopt, 1, 0.0};
    });
    JournalJob listed = model->journalEntry();
    listed.form = QByteArray::fromStdString(write_case(model->caseFile()).dump());
    const Words russian(u"ru"_s);
    EXPECT_EQ(listedJob(russian, listed).engine,
              WorkshopModel::engineName(russian, model->input().engine));
    EXPECT_NE(listedJob(russian, listed).engine, u"4 in line"_s);
    model->history()->undo();
    // A copy keeps engine, planes and drills; readings and masses are new. It begins on sheet 1
    // with a word about what it has.
    show(MachineTab);
    QString said;
    QObject::connect(&page, &ScenePage::status, &page, [&](const QString& text) { said = text; });
    whenModal<JournalDialog>(
        [](JournalDialog* dialog) { test::named<QPushButton>(*dialog, "journal_copy")->click(); });
    press(Qt::Key_F3);
    EXPECT_EQ(model->desk()->jobId(), 0);
    EXPECT_FALSE(model->solution().bob_weight);
    EXPECT_EQ(model->input().correction->drill.diameters_mm.size(), 4u);
    EXPECT_FALSE(model->input().correction->readings[0].unbalance);
    EXPECT_EQ(sheets->currentIndex(), 0);
    EXPECT_EQ(page.focusWidget(), find<QWidget>("engine_number"));
    EXPECT_TRUE(has(said, u"Engine, machine, planes and drills are kept."_s));
}

TEST_F(CardJobTest, AJobWithPlanesIsUnfinishedUntilItIsRead) {
    type("engine_number", u"7"_s);
    save();
    EXPECT_TRUE(jobs().at(0).isFinished);
    type("position_1", u"60"_s);
    save();
    EXPECT_FALSE(jobs().at(0).isFinished);
    typeReadings();
    save();
    EXPECT_TRUE(jobs().at(0).isFinished);
}

TEST_F(JobPageTest, TheMachineBeginsAtTheNextReading) {
    model->loadInput(bobWeightsJob(), {});
    ASSERT_TRUE(model->isPlanned());
    show(MachineTab);
    EXPECT_EQ(page.focusWidget(), find<QWidget>("run_1_unbalance_1"));
    // Whenever it is opened, wherever the focus was on it.
    find<QWidget>("grade_mm_s")->setFocus();
    show(JobTab);
    show(MachineTab);
    EXPECT_EQ(page.focusWidget(), find<QWidget>("run_1_unbalance_1"));
    // Also as the first sheet that the window shows; nothing scrolls.
    WorkshopPage first(QString(), nullptr);
    first.model()->loadInput(model->inputJson(), {});
    test::named<QTabWidget>(first, "sheets")->setCurrentIndex(MachineTab);
    test::showAt(first, {915, 560});
    EXPECT_EQ(first.focusWidget(), test::named<QWidget>(first, "run_1_unbalance_1"));
    const auto* sheet =
        qobject_cast<QScrollArea*>(test::named<QTabWidget>(first, "sheets")->widget(MachineTab));
    EXPECT_EQ(sheet->verticalScrollBar()->value(), 0);
    // Where all is read and nothing is to be drilled, at the readings.
    limitTo(5000);
    ASSERT_FALSE(model->isPlanned());
    show(JobTab);
    show(MachineTab);
    EXPECT_EQ(page.focusWidget(), find<QWidget>("unbalance_1"));
}

TEST_F(JobPageTest, ACaseIsProposedByTheNameOfItsJob) {
    const CaseDocument document(model);
    QStringList proposed{document.proposedPath()};
    for (const char* number : {"ЗМЗ-53 № 1234/56", "//"}) {
        model->edit(u"number"_s, [&](workshop::Input& input) { input.job.engine_number = number; });
        proposed << document.proposedPath();
    }
    EXPECT_EQ(proposed, QStringList({u"workshop.case.json"_s, u"ЗМЗ-53_1234_56.case.json"_s,
                                     u"workshop.case.json"_s}));
}

TEST_F(CardJobTest, WhatContradictsItselfHasNoAnswerOnPageCardAndJournal) {
    type("customer", u"Smith"_s);
    EXPECT_TRUE(has(card(), u"Bob weight 1505.2 g"_s));
    type("cylinders", QString());
    EXPECT_FALSE(field("cylinders")->trouble().isEmpty()) << "it is needed";
    EXPECT_EQ(model->input().engine.cylinders, 8);
    const auto expectNone = [&](const QString& why) {
        EXPECT_FALSE(model->solution().bob_weight);
        EXPECT_TRUE(has(label("headline"), why));
        const QString printed = card();
        EXPECT_TRUE(has(printed, label("headline")));
        static const QRegularExpression answer(
            u"Bob weight \\d|Missing for the bob weight|On each of"_s);
        EXPECT_FALSE(has(printed, answer));
    };
    Json odd = model->inputJson();
    odd["engine"]["cylinders"] = 7;
    model->loadInput(odd, {});
    expectNone(u"must be even"_s);
    // The journal keeps the sheet, not an answer that it does not have.
    save();
    ASSERT_EQ(jobs().size(), 1);
    EXPECT_FALSE(jobs().at(0).bobWeight);
    type("cylinders", u"8"_s);
    EXPECT_EQ(label("headline"), u"Bob weight 1505.2 g"_s);
    fill({{"reciprocating_percent", "10"}, {"overbalance_percent", "-20"}});
    expectNone(u"must leave a factor of 0 or more"_s);
}

TEST_F(JobPageTest, ReadingsAreNotComparedWithAWeightThatIsNotKnown) {
    model->loadInput(bobWeightsJob(), {});
    type("reciprocating_percent", u"10"_s);
    EXPECT_TRUE(has(label("verdict"), u"another bob weight"_s));
    type("overbalance_percent", u"-20"_s);
    ASSERT_FALSE(model->solution().bob_weight);
    EXPECT_FALSE(has(label("verdict"), u"another bob weight"_s));
    EXPECT_FALSE(has(card(), u"another bob weight"_s));
}

TEST_F(CardJobTest, TheNextJobIsNotOfTheFileBeforeIt) {
    type("customer", u"Smith"_s);
    CaseDocument document(model);
    ASSERT_EQ(document.saveTo(QDir(folder.path()).filePath(u"a.case.json"_s)), QString());
    EXPECT_FALSE(document.path().isEmpty());
    save();
    press(Qt::Key_F4);
    EXPECT_TRUE(document.path().isEmpty());
}

TEST_F(ReadJobTest, WhatMayBeWrongIsSaidAndMarked) {
    fill({{"grade_mm_s", "16"},
          {"rotor_mass_kg", "32"},
          {"service_speed_rpm", "6000"},
          {"front_bearing_mm", "0"},
          {"rear_bearing_mm", "540"},
          {"centre_of_mass_mm", "270"}});
    const struct {
        const char* field;
        const char* wrong;
        const char* right;
        QString said;  ///< behind "STOP. "
        bool isOfWeight = false;
        bool isMarked = true;
    } cases[] = {
        {"piston", "0.584", "583.9", u"Piston: 0.584 g looks like kilograms. Enter grams."_s, true,
         false},
        {"big_end", "60", "229.8",
         u"The big end of the rod, 60.00 g, weighs less than its small end, 162.40 g."_s, true,
         false},
        {"reciprocating_percent", "0.5", "50",
         u"A balance factor of 0.50 % looks like a fraction."_s, true},
        {"rotor_mass_kg", "32000", "32", u"A crankshaft of 32000 kg is too heavy"_s},
        {"rotor_mass_kg", "120", "32", u"A crankshaft of 120 kg is too heavy"_s},
        {"service_speed_rpm", "6", "6000", u"A service speed of 6 min⁻¹ is implausible."_s},
        {"front_bearing_mm", "700", "0", u"The bearings are in reverse order"_s},
        {"centre_of_mass_mm", "6000", "270", u"The centre of mass is not between the bearings"_s},
    };
    for (const auto& each : cases) {
        type(each.field, QString::fromLatin1(each.wrong));
        EXPECT_TRUE(begins(label("verdict"), u"STOP. "_s + each.said));
        EXPECT_EQ(model->withheld().bob_weight, each.isOfWeight);
        EXPECT_EQ(label("doubtful").startsWith(u"Do not use: bob weight "_s), each.isOfWeight);
        EXPECT_EQ(field(each.field)->isDoubtful(), each.isMarked) << each.field;
        type(each.field, QString::fromLatin1(each.right));
        EXPECT_EQ(label("doubtful"), QString());
        EXPECT_EQ(verdict(), u"Fails"_s) << qPrintable(label("verdict"));
        EXPECT_FALSE(field(each.field)->isDoubtful()) << each.field;
    }
}

TEST_F(CardJobTest, WhatIsNotGivenIsSaid) {
    EXPECT_EQ(label("troubles"), QString());
    type("locks", QString());
    EXPECT_TRUE(has(card(), u"Not given, 0 g is used: locks of one pin."_s));
    EXPECT_TRUE(label("troubles").contains(u"Not given, 0 g is used: locks of one pin."_s));
    EXPECT_TRUE(begins(label("headline"), u"Provisional: "_s));
    EXPECT_TRUE(begins(label("verdict"), u"Provisional. "_s));
    type("locks", u"0"_s);
    EXPECT_TRUE(begins(label("headline"), u"Bob weight"_s));
    EXPECT_EQ(label("troubles"), QString()) << "a 0 that is typed is meant";
}

TEST_F(CardJobTest, WhatIsTypedAgainstTheScaleCanBePutRight) {
    fill({{"cylinders", "2"}, {"mass_piston_1", "483.9"}, {"mass_piston_2", "483.9"}});
    EXPECT_EQ(label("verdict"),
              u"STOP. Piston: 583.90 g entered, but 483.90 g weighed. Correct the wrong value."_s);
    ASSERT_TRUE(field("piston")->isEnabled());
    EXPECT_EQ(field("piston")->value(), 583.9);
    type("piston", {});
    EXPECT_NE(verdict(), u"STOP"_s) << qPrintable(label("verdict"));
    EXPECT_FALSE(field("piston")->isEnabled());
    EXPECT_EQ(field("piston")->value(), 483.9);
}

TEST_F(ReadJobTest, WhatIsZeroNeedsNoAngle) {
    type("g_mm", u"100"_s);
    type("unbalance_1", u"0"_s);
    type("angle_1", QString());
    EXPECT_FALSE(label("headline").contains(u"enter"_s));
    const auto& result = model->solution();
    ASSERT_TRUE(result.correction);
    EXPECT_EQ(result.runs.size(), 1U);
    // And has none, in the form and on the card.
    EXPECT_EQ(field("angle_1")->placeholderText(), u"–"_s);
    fill({{"run_1_unbalance_1", "0"}, {"run_1_unbalance_2", "5"}, {"run_1_angle_2", "10"}});
    EXPECT_TRUE(has(card(), u"Run 1\n0.0\n–\n5.0\n10.0"_s));
    EXPECT_TRUE(has(card(), u"Measured\n0.0 g·mm\n5.0 g·mm\nHeavy spot\n–\n10.0°\n"_s));
    type("unbalance_1", u"12"_s);
    EXPECT_EQ(field("angle_1")->placeholderText(), u"required"_s);
}

TEST_F(CardJobTest, ARejectedEntryThatNoResultNeedsLeavesTheAnswerUpToDate) {
    const QString file = QDir(folder.path()).filePath(u"card.pdf"_s);
    type("date", u"31.02.2024"_s);
    EXPECT_FALSE(find<EntryField>("date")->trouble().isEmpty());
    EXPECT_TRUE(label("rejected").isEmpty()) << qPrintable(label("rejected"));
    EXPECT_FALSE(isAmber("headline"));
    ASSERT_EQ(page.writeCard(file), QString());
    const QString printed = textOfPdf(file).simplified();
    EXPECT_FALSE(has(printed, u"outdated"_s));
    EXPECT_TRUE(has(printed, u"Not accepted, the previous value is used: "_s));
    type("date", u"2024-02-29"_s);
    EXPECT_TRUE(find<EntryField>("date")->trouble().isEmpty());
}

TEST_F(ReadJobTest, ARejectedNameOfThePlanesStopsThePlan) {
    typeLimit(u"300"_s);
    EXPECT_GT(rowsOf("Holes and slugs"), 0);
    type("planes", u"rear"_s);
    EXPECT_EQ(rowsOf("Holes and slugs"), 0);
    EXPECT_EQ(label("correction"), u"STOP: do not drill yet"_s);
    type("planes", u"left / right"_s);
    EXPECT_GT(rowsOf("Holes and slugs"), 0);
}

TEST_F(ReadJobTest, AFileHasNoValueFromBeforeARejectedEntry) {
    type("unbalance_1", u"26o0"_s);
    CaseDocument document(model);
    const QString path = QDir(folder.path()).filePath(u"a.case.json"_s);
    ASSERT_EQ(document.saveTo(path), QString());
    const Json readings = CaseDocument::read(path).input.at("correction").at("readings");
    EXPECT_FALSE(readings[0].contains("unbalance_g_mm"));
    EXPECT_EQ(readings[1].at("unbalance_g_mm"), 1450);
}

TEST_F(ReadJobTest, NothingIsSavedBesideARejectedEntryWhoseValueCannotBeBlank) {
    type("engine_number", u"54"_s);
    CaseDocument document(model);
    const QString path = QDir(folder.path()).filePath(u"a.case.json"_s);
    for (const auto& [entry, bad, good] : {std::tuple("cylinders", u"8x"_s, u"8"_s),
                                           {"diameters_mm", u"8,10"_s, u"8; 10"_s},
                                           {"planes", u"rear"_s, u"left / right"_s}}) {
        type(entry, bad);
        const QString name = find<EntryField>(entry)->accessibleName();
        EXPECT_TRUE(has(document.saveTo(path), name));
        EXPECT_FALSE(QFile::exists(path));
        const auto said = std::make_shared<QString>();
        whenModal<QMessageBox>([said](QMessageBox* why) {
            *said = why->text();
            why->accept();
        });
        save();
        EXPECT_TRUE(has(*said, name));
        EXPECT_EQ(jobs().size(), 0);
        EXPECT_TRUE(find<EntryField>(entry)->isVisible()) << "to be corrected";
        const auto asked = answer(u"Cancel"_s);
        press(Qt::Key_F4);
        EXPECT_TRUE(has(*asked, name));
        EXPECT_FALSE(has(*asked, u"are left out"_s)) << "it cannot be";
        type(entry, good);
    }
    EXPECT_EQ(document.saveTo(path), QString());
    save();
    EXPECT_EQ(jobs().size(), 1);
}

TEST_F(ReadJobTest, AJobIsSavedWithoutTheValueBeforeARejectedEntry) {
    typeLimit(u"300"_s);
    type("engine_number", u"54"_s);
    type("unbalance_1", u"26o0"_s);
    EXPECT_TRUE(has(saveAnd(u"Continue"_s), u"are left out"_s));
    ASSERT_EQ(jobs().size(), 1);
    EXPECT_FALSE(jobs().at(0).isFinished);
    EXPECT_FALSE(has(jobs().at(0).verdict, u"passes"_s));
    EXPECT_FALSE(field("unbalance_1")->value()) << "what was typed waits";
    const auto asked = answer(u"Stay"_s);
    press(Qt::Key_F4);
    EXPECT_TRUE(has(*asked, u"are left out"_s)) << "also once it is saved";
    EXPECT_EQ(field("unbalance_2")->text(), u"1450"_s) << "the other reading";
    EXPECT_EQ(rowsOf("Holes and slugs"), 0);
}

TEST_F(ReadJobTest, WhatNoResultNeedsIsSavedAsBefore) {
    type("engine_number", u"54"_s);
    type("date", u"2026-13-45"_s);
    const QString said = saveAnd(u"Continue"_s);
    EXPECT_TRUE(has(said, u"the previous values are used"_s));
    EXPECT_FALSE(has(said, u"are left out"_s));
    EXPECT_EQ(jobs().size(), 1);
}

TEST_F(ReadJobTest, ACopyForACrashHasNoValueFromBeforeARejectedEntry) {
    type("unbalance_1", u"1,450"_s);
    CaseFile copy = model->caseFile();
    model->leaveOutRejected(copy.input);
    EXPECT_FALSE(copy.input.at("correction").at("readings")[0].contains("unbalance_g_mm"));
    EXPECT_EQ(copy.input.at("correction").at("readings")[1].at("unbalance_g_mm"), 1450);
}

TEST_F(JobPageTest, NoResultIsOutdatedWhereThereIsNone) {
    type("piston", u"58x"_s);
    EXPECT_TRUE(begins(label("rejected"), u"Entries not accepted: One piston"_s));
    EXPECT_FALSE(has(label("verdict"), u"previous value"_s));
    type("piston", u"583.9"_s);
    type("piston", u"58x"_s);
    model->keepForSaving();
    EXPECT_FALSE(model->input().parts.piston) << "nor is the value before it saved";
    typeShopCard();
    type("pin", u"17x"_s);
    EXPECT_TRUE(begins(label("rejected"), u"Result outdated: "_s));
}

TEST_F(CardJobTest, ARejectedEntryMakesTheAnswerStale) {
    type("engine_number", u"53"_s);
    type("piston", u"58x"_s);
    EXPECT_TRUE(has(label("rejected"), u"One piston"_s));
    EXPECT_TRUE(isAmber("headline"));
    EXPECT_TRUE(label("verdict").startsWith(u"STOP. Entries not accepted: One piston"_s));
    EXPECT_FALSE(find<QLabel>("headline")->font().bold());
    EXPECT_EQ(page.focusWidget(), field("piston")) << "Enter does not pass it over";
    // The tab says so, wherever one is.
    show(JobTab);
    EXPECT_EQ(sheets->tabBar()->tabTextColor(PartsTab), Theme::instance().error());
    EXPECT_TRUE(begins(page.resultsAsText(), u"STOP. Entries not accepted: One piston"_s));
    EXPECT_TRUE(saveAnd(u"Continue"_s).contains(u"One piston"_s));
    ASSERT_EQ(jobs().size(), 1);
    EXPECT_FALSE(jobs().at(0).isFinished);
    type("piston", u"583.9"_s);
    EXPECT_TRUE(label("rejected").isEmpty());
    EXPECT_FALSE(label("verdict").contains(u"red entry"_s));
    EXPECT_FALSE(isAmber("headline"));
    EXPECT_FALSE(sheets->tabBar()->tabTextColor(PartsTab).isValid());
    save();
    EXPECT_TRUE(jobs().at(0).isFinished) << qPrintable(model->answerLacks() + model->jobName());
}

TEST_F(ReadJobTest, ARejectedEntryStopsThePlanAsADoubtDoes) {
    typeLimit(u"300"_s);
    fill({{"mass_piston_1", "591.25"}, {"mass_piston_2", "590"}});
    const QString file = QDir(folder.path()).filePath(u"card.pdf"_s);
    const auto printed = [&] {
        EXPECT_EQ(page.writeCard(file), QString());
        return textOfPdf(file);
    };
    auto* planes = dynamic_cast<PartTable*>(partView(page, "planes"));
    const auto copied = [&] {
        QTest::keyClick(planes, Qt::Key_C, Qt::ControlModifier);
        return QGuiApplication::clipboard()->text();
    };
    const int holes = rowsOf("Holes and slugs");
    EXPECT_GT(holes, 0);
    EXPECT_TRUE(hasAll(printed(), {u"2600.0"_s, u"591.25"_s}));
    EXPECT_FALSE(has(page.resultsAsText() + page.resultsAsCsv() + copied() + printed(), u"STOP"_s));
    type("mass_piston_1", u"59x"_s);
    type("unbalance_1", u"26x0"_s);
    EXPECT_EQ(rowsOf("Holes and slugs"), 0);
    EXPECT_EQ(find<QWidget>("plane_1")->accessibleDescription(), u"no correction yet"_s);
    EXPECT_EQ(label("correction"), u"STOP: do not drill yet"_s);
    EXPECT_TRUE(begins(label("hole_note"), u"STOP"_s));
    EXPECT_TRUE(begins(label("rejected"), u"Result outdated: "_s));
    EXPECT_TRUE(field("run_1_unbalance_1")->isEnabled()) << "the holes may have been drilled";
    const QString stop = u"STOP. Entries not accepted: "_s;
    EXPECT_TRUE(begins(page.resultsAsText(), stop));
    EXPECT_TRUE(begins(page.resultsAsCsv().remove(u'"'), stop));
    EXPECT_TRUE(begins(copied(), stop));
    // The values before are not on the card, each page of which says STOP.
    const QStringList pages = printed().split(u'\f', Qt::SkipEmptyParts);
    EXPECT_EQ(pages.size(), 2);
    for (const QString& each : pages) {
        EXPECT_TRUE(has(each, u"STOP"_s));
        EXPECT_FALSE(has(each, u"2600.0"_s));
        EXPECT_FALSE(has(each, u"591.25"_s));
    }
    EXPECT_TRUE(has(pages.at(0), u"1450.0"_s)) << "the other reading";
    EXPECT_TRUE(has(pages.at(1), u"590.00"_s));
    type("unbalance_1", u"2600"_s);
    type("mass_piston_1", u"591.25"_s);
    EXPECT_EQ(rowsOf("Holes and slugs"), holes);
    // A doubt is the first line, too, and once.
    type("radius_1", u"8.5"_s);
    const QString doubted = label("verdict");
    EXPECT_TRUE(begins(doubted, u"STOP. "_s));
    EXPECT_TRUE(begins(page.resultsAsText().replace(QChar(0x00A0), u' '), doubted));
    EXPECT_EQ(page.resultsAsText().count(u"STOP. "_s), 1);
    EXPECT_TRUE(has(page.resultsAsCsv(), u"STOP. "_s));
    for (const QString& each : printed().split(u'\f', Qt::SkipEmptyParts)) {
        EXPECT_TRUE(has(each, u"STOP"_s));
    }
}

TEST_F(CardJobTest, RunsFollowOneAnother) {
    type("customer", u"Smith"_s);
    EXPECT_FALSE(field("run_1_unbalance_1")->isEnabled()) << "nothing is planned yet";
    typeReadings();
    show(MachineTab);
    // The sheet below keeps its place while runs come.
    const auto place = [&] { return field("position_1")->mapTo(&page, QPoint()).y(); };
    const int before = place();
    EXPECT_TRUE(field("run_1_unbalance_1")->isEnabled());
    EXPECT_FALSE(field("run_2_unbalance_1")->isEnabled());
    typeLimit(u"300"_s);
    EXPECT_EQ(rowsOf("Runs of the machine"), 0);
    type("run_1_unbalance_1", u"350"_s);
    EXPECT_FALSE(model->solution().correction) << "its readings are not all there";
    EXPECT_TRUE(has(label("troubles"), u"Sheet 5, Run 1, Front plane: enter the angle"_s));
    // Else it is not deepened, for the run does not show its depth.
    model->editCorrection({}, [](Correction& correction) {
        for (DrilledHole& hole : *correction.earlier_runs[0].drilled) {
            hole.state = HoleState::measured;
        }
    });
    fill({{"run_1_angle_1", "80"}, {"run_1_unbalance_2", "120"}, {"run_1_angle_2", "200"}});
    EXPECT_EQ(model->input().correction->earlier_runs.size(), 1u);
    EXPECT_EQ(place(), before);
    EXPECT_TRUE(field("run_2_unbalance_1")->isEnabled());
    EXPECT_NEAR(*model->input().correction->readings[0].unbalance, 350e-6, 1e-12);
    ASSERT_TRUE(model->solution().correction);
    const std::vector<Hole>& holes = (*model->solution().correction)[0].holes;
    ASSERT_EQ(holes.size(), 1u);
    EXPECT_TRUE(holes[0].deepens) << "that of the run before";
    EXPECT_NEAR(holes[0].angle, 75 * degree, 1e-9);
    const double remaining = (*model->solution().correction)[0].remaining;
    EXPECT_LT(remaining, 300e-6) << "the next correction is that of the newest run";
    EXPECT_EQ(rowsOf("Runs of the machine"), 2);
    EXPECT_EQ(model->runResults().rows.at(0).last(), u"FAIL"_s);
    EXPECT_EQ(verdict(), u"Fails"_s);
    EXPECT_TRUE(label("verdict").contains(u"After the planned correction: "_s));
    typeRun(2, {u"60"_s, u"10"_s, u"20"_s, u"300"_s});
    EXPECT_EQ(model->runResults().rows.at(2).last(), u"PASS"_s);
    const QString printed = card();
    EXPECT_TRUE(hasAll(printed, {u"Run 2"_s, u"2600.0"_s, u"350.0"_s, u"60.0"_s, u"300.0 g·mm"_s,
                                 u"480 mm"_s, u"85 mm"_s}));
    // As a window of 1024 × 700 has it, nothing scrolls sideways.
    test::showAt(page, {915, 560});
    for (const ResultTable* table : page.findChildren<ResultTable*>()) {
        if (table->isVisible()) {
            EXPECT_EQ(table->horizontalScrollBar()->maximum(), 0)
                << qPrintable(table->accessibleName());
        }
    }
    for (int i = 0; i < sheets->count(); ++i) {
        sheets->setCurrentIndex(i);
        QApplication::processEvents();
        const auto* sheet = qobject_cast<QScrollArea*>(sheets->widget(i));
        EXPECT_EQ(sheet->horizontalScrollBar()->maximum(), 0) << i;
    }
    save();
    EXPECT_NEAR(*jobs().at(0).frontReading, 60, 1e-9);
    EXPECT_EQ(jobs().at(0).verdict, u"passes"_s);
    EXPECT_EQ(model->inputJson().at("correction").at("earlier_runs").size(), 2u);
    EXPECT_EQ(model->resultJson().at("correction").at("runs").size(), 3u);
    // A run without any reading is none.
    typeRun(2, {{}, {}, {}, {}});
    EXPECT_EQ(model->newestRun(), 1u);
    EXPECT_NEAR(*model->input().correction->readings[0].unbalance, 350e-6, 1e-12);
    page.model()->undo();
    EXPECT_EQ(model->newestRun(), 2u);
}

TEST_F(ReadJobTest, WhatIsDrilledStaysInSight) {
    show(MachineTab);
    const auto shown = [this] {
        QStringList rows;
        for (const ResultRow& row : model->drilledResults().rows) {
            rows << row.texts().join(u" | "_s);
        }
        return rows;
    };
    EXPECT_TRUE(shown().isEmpty());
    QStringList planned;
    for (const ResultRow& row : model->holeResults().rows) {
        planned << u"After “Before” | "_s + row.texts().join(u" | "_s);
    }
    ASSERT_EQ(planned.size(), 2);
    type("run_1_unbalance_1", u"900"_s);
    EXPECT_EQ(shown(), planned) << "also while the next run is being typed";
    fill({{"run_1_angle_1", "73"}, {"run_1_unbalance_2", "100"}, {"run_1_angle_2", "210"}});
    EXPECT_EQ(shown(), planned);
    EXPECT_EQ(rowsOf("Already drilled"), 2);
    const QString depth = model->drilledResults().rows.at(0).at(2).text;
    EXPECT_TRUE(card().contains(u"Already drilled\n"_s));
    EXPECT_TRUE(card().contains(depth + u'\n'));
    // Other drills say nothing of the holes that are there, nor does a reading that is put right.
    type("diameters_mm", u"10"_s);
    EXPECT_EQ(shown(), planned);
    show(MachineTab);
    const QString corrected = u"Before: the drilled holes were planned from another reading."_s;
    type("angle_1", u"60"_s);
    EXPECT_EQ(shown(), planned);
    EXPECT_TRUE(has(label("troubles"), corrected));
    EXPECT_TRUE(card().contains(corrected));
    model->loadInput(model->inputJson(), {});
    EXPECT_EQ(shown(), planned);
    EXPECT_TRUE(label("troubles").contains(corrected));
    limitTo(5000);
    EXPECT_FALSE(label("troubles").contains(corrected)) << "the next run passes";
    model->history()->undo();
    EXPECT_TRUE(label("troubles").contains(corrected));
    type("angle_1", u"75"_s);
    EXPECT_FALSE(label("troubles").contains(corrected));
    // Nor do they where the next run is emptied and typed again.
    typeRun(1, {{}, {}, {}, {}});
    EXPECT_EQ(model->newestRun(), 0u);
    model->loadInput(model->inputJson(), {});
    show(MachineTab);
    typeRun(1, {u"900"_s, u"73"_s, u"100"_s, u"210"_s});
    EXPECT_EQ(shown(), planned);
    // The picture has them where nothing is to be drilled, too.
    const auto picture = [this] {
        auto* view = find<QWidget>("plane_1");
        view->resize(300, 250);  // whatever room the verdict leaves
        return view->grab().toImage();
    };
    type("run_1_unbalance_1", u"1"_s);
    const QImage drawn = picture();
    model->editCorrection(u"none"_s, [](Correction& it) { it.earlier_runs[0].drilled.emplace(); });
    EXPECT_TRUE(shown().isEmpty());
    EXPECT_NE(picture(), drawn);
    page.model()->undo();
    EXPECT_EQ(picture(), drawn);
    page.model()->undo();
    // Once all is within its limits they are still there.
    typeRun(2, {u"1"_s, u"10"_s, u"1"_s, u"10"_s});
    ASSERT_TRUE(shown().size() > 2);
    EXPECT_EQ(shown().mid(0, 2), planned);
    EXPECT_TRUE(shown().at(2).startsWith(u"After Run 1 | Front"_s));
    EXPECT_TRUE(card().contains(u"Already drilled\n"_s));
}

TEST_F(ReadJobTest, ReadingsMayBeSaidToHoldAfterTheNextRun) {
    show(MachineTab);
    type("overbalance_percent", u"2"_s);
    auto* hold = find<QPushButton>("readings_hold");
    const auto run = [&](bool isHeldBefore) {
        show(MachineTab);
        if (isHeldBefore) {
            hold->click();
        }
        typeRun(1, {u"900"_s, u"73"_s, u"100"_s, u"210"_s});
        if (!isHeldBefore) {
            EXPECT_TRUE(model->drilledResults().rows.isEmpty());
            hold->click();
        }
    };
    const Json start = model->inputJson();
    run(true);
    const Correction before = *model->input().correction;
    EXPECT_EQ(model->drilledResults().rows.size(), 2);
    model->loadInput(start, {});
    run(false);
    EXPECT_EQ(*model->input().correction, before);
}

TEST_F(CardJobTest, ColumnsArePasted) {
    type("cylinders", u"4"_s);
    show(WeighInTab);
    auto* first = field("mass_piston_1");
    const auto paste = [&](const QString& text) {
        first->setFocus();
        QApplication::clipboard()->setText(text);
        QTest::keyClick(first, Qt::Key_V, Qt::ControlModifier);
    };
    paste(u"Piston\tPin\n590\t170 g\n592\t0.172 kg\n"_s);
    const auto mass = [&](shop::Part part, std::size_t cylinder) {
        return (*model->input().weigh_in)[part].mass.at(cylinder).value_or(0) / units::gram;
    };
    EXPECT_NEAR(mass(shop::Part::piston, 1), 592, 1e-9);
    EXPECT_NEAR(mass(shop::Part::pin, 1), 172, 1e-9);
    for (const QString& bad :
         {u"1\n2\n3\n4\n5\n"_s, u"601\nheavy"_s, u"601\n-5"_s, u"601\n1,450"_s}) {
        paste(bad);
        EXPECT_TRUE(label("weigh_in_trouble").startsWith(u"Not pasted: "_s)) << qPrintable(bad);
        EXPECT_NEAR(mass(shop::Part::piston, 0), 590, 1e-9);
    }
    paste(u"601,5\t151\r\n602\t\r\n603\t153\r\n"_s);
    EXPECT_NEAR(mass(shop::Part::piston, 0), 601.5, 1e-9);
    EXPECT_NEAR(mass(shop::Part::pin, 1), 172, 1e-9) << "a gap leaves what is there";
    model->history()->undo();
    EXPECT_NEAR(mass(shop::Part::piston, 2), 0, 1e-9) << "one step";
    QTest::keyClick(first, Qt::Key_Down);
    EXPECT_EQ(page.focusWidget(), field("mass_piston_2"));
    // More cylinders than the sheet has lines.
    type("cylinders", u"20"_s);
    show(WeighInTab);
    paste(QStringList(20, u"600"_s).join(u'\n'));
    EXPECT_EQ(label("headline"), u"Bob weight 1521.3 g"_s) << "all 20 count";
}

TEST_F(CardJobTest, AnotherEngineIsAJobOfItsOwn) {
    CaseDocument document(model);
    type("engine_number", u"A 1"_s);
    ASSERT_EQ(document.saveTo(QDir(folder.path()).filePath(u"a.case.json"_s)), QString());
    save();
    type("oil", u"5"_s);
    ASSERT_TRUE(document.needsSaving());
    save();
    EXPECT_TRUE(document.needsSaving()) << "the journal has it, the file has not";
    EXPECT_TRUE(model->desk()->isJournaled());
    EXPECT_EQ(jobs().size(), 1);
    type("crankshaft_number", u"K 7"_s);
    save();
    EXPECT_EQ(jobs().size(), 1) << "a number that comes later";
    type("engine_number", u"B 2"_s);
    const QString asked = saveAnd(u"Cancel"_s);
    EXPECT_TRUE(asked.contains(u"A 1 / K 7"_s) && asked.contains(u"B 2 / K 7"_s))
        << qPrintable(asked);
    EXPECT_EQ(jobs().at(0).engineNumber, u"A 1"_s);
    saveAnd(u"Save as a new job"_s);
    ASSERT_EQ(jobs().size(), 2);
    EXPECT_EQ(jobs().at(0).engineNumber, u"B 2"_s);
    type("cylinders", u"6"_s);
    EXPECT_TRUE(saveAnd(u"Cancel"_s).contains(u"another engine"_s));
    type("cylinders", u"8"_s);
    type("engine_number", u"B 3"_s);
    saveAnd(u"Change that job"_s);
    EXPECT_EQ(jobs().size(), 2);
}

TEST_F(ReadJobTest, TheNextJobOfAnotherEngineHasNothingOfTheCrankshaftBefore) {
    fill({{"from_1", "10"},
          {"to_1", "350"},
          {"grade_mm_s", "6.3"},
          {"rotor_mass_kg", "24"},
          {"service_speed_rpm", "5500"},
          {"engine_number", "A 1"}});
    limitTo(40);
    save();
    QString said;
    QObject::connect(&page, &ScenePage::status, &page, [&](const QString& text) { said = text; });
    press(Qt::Key_F4);
    EXPECT_TRUE(has(said, u"typed and weighed masses"_s));
    EXPECT_FALSE(model->hasNumbers());
    EXPECT_EQ(model->input().tolerance->plane, 40 * units::gram_mm);
    const Correction carried = *model->input().correction;
    ASSERT_EQ(carried.planes[0].radius, 85 * units::mm) << "of the same engine it stays";
    EXPECT_FALSE(model->input().tolerance->rotor_mass) << "the next crankshaft's is its own";
    EXPECT_TRUE(model->input().tolerance->service_speed);
    type("cylinders", u"6"_s);
    EXPECT_TRUE(has(said, u"previous crankshaft"_s));
    const auto isBlank = [](const Plane& plane) { return plane == Plane{}; };
    const Correction& now = *model->input().correction;
    EXPECT_TRUE(std::all_of(now.planes.begin(), now.planes.end(), isBlank));
    EXPECT_EQ(now.drill, carried.drill) << "of the shop";
    EXPECT_EQ(model->input().tolerance->grade, 6.3 * units::mm_per_s);
    EXPECT_FALSE(model->input().tolerance->rotor_mass);
    EXPECT_FALSE(model->input().tolerance->service_speed);
    EXPECT_FALSE(model->input().tolerance->plane);
    // What is typed for this engine stays, and one step brings all of it back.
    type("radius_1", u"85"_s);
    type("cylinders", u"12"_s);
    EXPECT_EQ(model->input().correction->planes[0].radius, 85 * units::mm);
    for (int step = 0; step < 3; ++step) {
        model->undo();
    }
    EXPECT_EQ(*model->input().correction, carried);
    EXPECT_TRUE(model->input().tolerance->service_speed);
}

TEST_F(CardJobTest, AJobFromAFileIsNotSavedTwiceWithoutAWord) {
    type("engine_number", u"E-1"_s);
    save();
    const auto reload = [this] { model->loadInput(model->inputJson(), {}); };
    reload();
    save();
    EXPECT_EQ(jobs().size(), 1) << "as the journal has it: nothing to ask";
    reload();
    type("piston", u"600"_s);
    EXPECT_TRUE(saveAnd(u"Cancel"_s)
                    .startsWith(u"The journal already has a job of E-1 on this day, saved on"_s));
    ASSERT_EQ(jobs().size(), 1);
    EXPECT_NEAR(*jobs().at(0).bobWeight, 1505.2, 1e-9) << "nothing is lost without a word";
    saveAnd(u"Replace it"_s);
    ASSERT_EQ(jobs().size(), 1);
    EXPECT_GT(*jobs().at(0).bobWeight, 1506.0);
    // From here it is the sheet's job.
    type("piston", u"610"_s);
    save();
    EXPECT_EQ(jobs().size(), 1);
    reload();
    type("piston", u"620"_s);
    saveAnd(u"Save as another"_s);
    EXPECT_EQ(jobs().size(), 2);
    // A crankshaft number that came later is of the same job; another day or number is not.
    reload();
    type("crankshaft_number", u"C-1"_s);
    saveAnd(u"Replace it"_s);
    EXPECT_EQ(jobs().size(), 2);
    reload();
    type("date", u"2020-01-02"_s);
    save();
    EXPECT_EQ(jobs().size(), 3);
    reload();
    type("engine_number", u"E-2"_s);
    type("crankshaft_number", u"C-2"_s);
    save();
    EXPECT_EQ(jobs().size(), 4);
    // Without numbers it may be anybody's.
    reload();
    type("engine_number", {});
    type("crankshaft_number", {});
    type("customer", u"Somebody"_s);
    save();
    EXPECT_EQ(jobs().size(), 5);
}

TEST_F(JobPageTest, ARotorStaysInKilogramsAndTheCardHasTheSplit) {
    Preferences::instance().setUnits(Preferences::Mass, Preferences::Units::Gram);
    const WorkshopPage again(QString(), nullptr);
    const QString mass = test::named<NumberField>(again, "rotor_mass_kg")->unit();
    typeShopCard();
    model->editTolerance(u"limit"_s, [](Tolerance& it) {
        it.grade = 6.3 * units::mm_per_s;
        it.rotor_mass = 32.0;
        it.service_speed = 6000 * units::rpm;
    });
    model->edit(u"split"_s, [](workshop::Input& input) {
        input.engine.cylinders = 6;
        input.engine.pin_split = 30.0 * degree;
    });
    const QString printed = card();
    QSettings().clear();
    Preferences::instance().load();
    EXPECT_EQ(mass, u"kg"_s);
    EXPECT_TRUE(has(printed, u", 32 kg at"_s));
    EXPECT_TRUE(has(printed, u"On each of the 6 crankpins"_s));
}

TEST_F(ReadJobTest, TheMachineIsSetUpAsItCountsAndShows) {
    const double heavy = (*model->solution().correction)[0].holes.at(0).angle;
    EXPECT_TRUE(hasAll(label("convention"), {u"at the heavy spot"_s, u"radially from the rim"_s}));
    EXPECT_TRUE(
        hasAll(cardText(), {u"at the heavy spot"_s, u"radially from the rim"_s, u"0°: …"_s}))
        << "to be written";
    keys("shows", {Qt::Key_Down});
    EXPECT_EQ(model->input().machine.shows, workshop::Machine::Shows::light);
    EXPECT_NEAR((*model->solution().correction)[0].holes.at(0).angle, heavy + pi, 1e-9);
    EXPECT_EQ(field("angle_1")->value(), 75.0) << "as the machine shows it";
    type("zero", u"keyway"_s);
    type("planes", u"left, right"_s);
    EXPECT_TRUE(begins(field("radius_1")->accessibleName(), u"Left: Radius"_s));
    EXPECT_TRUE(begins(field("angle_2")->accessibleName(), u"Before, Right: Light spot"_s));
    EXPECT_TRUE(begins(field("angle_2")->accessibleDescription(), u"Spot shown by the machine"_s));
    EXPECT_TRUE(begins(model->holeResults().rows.at(0).at(0).text, u"Left: "_s));
    const QString printed = cardText();
    EXPECT_TRUE(hasAll(printed, {u"Left"_s, u"0°: keyway."_s, u"opposite the light spot"_s}));
    EXPECT_FALSE(has(printed, u"Front plane"_s));
    EXPECT_EQ(label("convention"), model->machineText());
    EXPECT_EQ(printed.count(model->machineText()), 1) << "beside the holes";
    const Json kept = model->inputJson();
    model->newJob();
    EXPECT_EQ(model->inputJson().at("machine"), kept.at("machine")) << "the next job's, too";
}

TEST_F(ReadJobTest, NamesOfThePlanesMoveNoReading) {
    typeRun(1, {u"900"_s, u"73"_s, u"100"_s, u"210"_s});
    const Correction before = *model->input().correction;
    const auto shown = [this] {
        QStringList texts;
        for (const char* name : {"position_1", "radius_2", "unbalance_1", "angle_1", "unbalance_2",
                                 "angle_2", "run_1_unbalance_1", "run_1_unbalance_2"}) {
            texts << field(name)->text();
        }
        return texts;
    };
    const QStringList typed = shown();
    const double hole = (*model->solution().correction)[0].unbalance;
    for (const char* names : {"rear / front", "2 / 1", "pulley / flywheel"}) {
        type("planes", QString::fromLatin1(names));
        EXPECT_EQ(*model->input().correction, before) << names;
        EXPECT_EQ(shown(), typed) << names;
        EXPECT_EQ((*model->solution().correction)[0].unbalance, hole) << names;
    }
    EXPECT_TRUE(begins(field("unbalance_1")->accessibleName(), u"Before, Pulley: "_s));
    EXPECT_EQ(find<QComboBox>("drilled_plane_1")->currentText(), u"Pulley"_s);
}

}  // namespace
}  // namespace ravnoves
