#include "balance-shaft/balance_shaft_page.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTableView>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <set>

#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/torque_table_model.h"
#include "balance-shaft/torque_source_editor.h"
#include "import_file.h"
#include "page/mechanism_picture.h"
#include "page_fixture.h"
#include "text/message_text.h"
#include "widgets/verdict_line.h"

namespace ravnoves {
namespace {

class BalanceShaftPageTest : public test::PageTest<BalanceShaftPage> {
  protected:
    TorqueTableEditor* editor = page.findChild<TorqueTableEditor*>();
    TorqueTableModel* table = static_cast<TorqueTableModel*>(editor->table());

    /// What is typed into a cell of the torque table.
    void put(int row, int column, const char* text) {
        table->setData(table->index(row, column), QString::fromLatin1(text), Qt::EditRole);
    }
    QString cell(int row, int column = TorqueTableModel::Torque) const {
        return table->index(row, column).data().toString();
    }
    bool isMarked(int row, int column) const {
        return table->index(row, column).data(EditableTable::TroubleRole).toBool();
    }
};

TEST_F(BalanceShaftPageTest, SliderDragMovesEverythingLive) {
    QSlider* slider = find<QSlider>("shaft_angle_deg_slider");
    const QString before = page.resultsAsText();
    const int y = slider->height() / 2;
    // Take the handle where it stands and pull it to the right.
    const int x = static_cast<int>(slider->width() * slider->value() / 3600.0);
    test::drag(slider, {x, y}, {x + 120, y});
    EXPECT_GT(model->shaftAngleDeg(), 60.0);
    EXPECT_NE(page.resultsAsText(), before);
    EXPECT_NEAR(*field("shaft_angle_deg")->value(), model->shaftAngleDeg(), 0.051);
    // The plot shows the new M_s.
    EXPECT_NEAR(*partPlot(page, "moments")->valueAt(1, 0.0),
                model->result().moment_amplitude * std::sin(model->input().shaft_angle), 1e-6);
}

/// Another field mends what was rejected: the words say so, and once that is given the text is
/// tried again as a step of its own.
TEST_F(BalanceShaftPageTest, ARejectedTextIsTriedAgainWhenItsCauseIsGone) {
    NumberField* crank = field("crank_radius_mm");
    NumberField* rod = field("rod_length_mm");
    type("rod_length_mm", QStringLiteral("45"));
    const QString why = rod->trouble();
    EXPECT_TRUE(why.contains(QStringLiteral("greater than"))) << why.toStdString();
    QTest::keyClick(rod, Qt::Key_Return);
    EXPECT_EQ(rod->trouble(), why);
    type("centre_distance_mm", QStringLiteral("101"));  // no cause of it
    QApplication::processEvents();
    EXPECT_EQ(rod->trouble(), why);
    const int steps = model->history()->count();
    crank->selectAll();
    QTest::keyClicks(crank, QStringLiteral("30"));
    QApplication::processEvents();
    EXPECT_TRUE(
        rod->trouble().startsWith(QStringLiteral("Not accepted before other values changed")));
    QTest::keyClick(crank, Qt::Key_Return);
    QApplication::processEvents();
    EXPECT_TRUE(rod->trouble().isEmpty());
    EXPECT_EQ(rod->value(), 45.0);
    EXPECT_EQ(model->history()->count(), steps + 2);
    model->undo();
    EXPECT_NE(rod->value(), 45.0);
    EXPECT_EQ(crank->value(), 30.0);
    QApplication::processEvents();
    EXPECT_NE(rod->value(), 45.0);  // undone is given up
}

TEST_F(BalanceShaftPageTest, WhatEscapeGaveUpIsForgotten) {
    QSignalSpy said(&page, &ScenePage::status);
    NumberField* rod = field("rod_length_mm");
    type("rod_length_mm", QStringLiteral("45"));
    ASSERT_FALSE(said.last().at(0).toString().isEmpty());
    QTest::keyClick(rod, Qt::Key_Escape);
    EXPECT_TRUE(said.last().at(0).toString().isEmpty());
    type("crank_radius_mm", QStringLiteral("30"));
    QApplication::processEvents();
    EXPECT_NE(rod->value(), 45.0);  // nor is it tried again
    EXPECT_TRUE(rod->trouble().isEmpty());
}

/// Each end of the angles counts as typed: none is judged by what the other was.
TEST_F(BalanceShaftPageTest, AnglesOfTheLimitsMayGoOverZero) {
    type("shaft_angle_from_deg", QStringLiteral("200"));
    type("shaft_angle_to_deg", QStringLiteral("250"));
    type("shaft_angle_from_deg", QStringLiteral("350"));
    type("shaft_angle_to_deg", QStringLiteral("10"));
    for (const char* end : {"shaft_angle_from_deg", "shaft_angle_to_deg"}) {
        EXPECT_TRUE(field(end)->trouble().isEmpty()) << field(end)->trouble().toStdString();
    }
    EXPECT_NEAR(balance_shaft::angle_span(model->input().place_limits), 20.0 * degree, 1e-12);
}

TEST_F(BalanceShaftPageTest, WhatLooksLikeASlipStandsInAmberAboveTheResults) {
    const auto* doubts = find<QLabel>("verdict");
    EXPECT_FALSE(doubts->text().contains(QStringLiteral("implausible together")));
    model->setByKey(QStringLiteral("reciprocating_masses_kg/piston"), QStringLiteral("500"));
    EXPECT_TRUE(doubts->text().contains(QStringLiteral("Mass 500\u00A0kg")))
        << doubts->text().toStdString();
    EXPECT_GE(model->verdict().severity, Severity::warning);
    model->undo();
    EXPECT_FALSE(doubts->text().contains(QStringLiteral("implausible together")));
}

TEST_F(BalanceShaftPageTest, ATraceATurnOffIsMovedByAButton) {
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("trace.csv")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    for (int angle = 0; angle <= 720; ++angle) {
        const double from = (std::remainder(angle - 5.0, 720.0)) / 30.0;
        file.write(QByteArray::number(angle) + ';' +
                   QByteArray::number(1.0 + 60.0 * std::exp(-from * from)) + '\n');
    }
    file.close();
    auto* move = find<QPushButton>("verdict_act");
    EXPECT_NE(model->verdict().act, balance_shaft::move_trace_act);
    test::importBy(
        page, [&] { page.findChild<TorqueSourceEditor*>()->importTrace(file.fileName()); },
        test::keepAngles);
    EXPECT_TRUE(find<QLabel>("verdict")->text().contains(QStringLiteral("by one turn")));
    EXPECT_FALSE(move->isHidden());
    move->click();
    EXPECT_NE(model->verdict().act, balance_shaft::move_trace_act);
    EXPECT_NEAR(model->result().indicated->peak_pressure_angle / degree, 365.0, 0.5);
    EXPECT_EQ(field("crank_angle_shift_deg")->value(), 360.0);
    model->undo();
    EXPECT_FALSE(move->isHidden());
}

TEST_F(BalanceShaftPageTest, AClickInThePlotSetsTheShaft) {
    PlotView* plot = partPlot(page, "range");
    QTest::mouseClick(
        plot, Qt::LeftButton, {},
        QPoint(plot->toPixel(200.0, 0).toPoint().x(), plot->plotArea().center().toPoint().y()));
    EXPECT_NEAR(model->shaftAngleDeg(), 200.0, 2.0);
}

TEST_F(BalanceShaftPageTest, BestButtonsGoThere) {
    press("go_best_range");
    EXPECT_EQ(model->shaftAngleDeg(), *model->result().best_range_buildable.shaft_angle / degree);
    press("go_best_rms");
    EXPECT_EQ(model->shaftAngleDeg(), *model->result().best_rms_buildable.shaft_angle / degree);
}

/// Where no α is feasible, none is offered, and the reason is said.
TEST_F(BalanceShaftPageTest, BestButtonsOfferNothingThatDoesNotFit) {
    type("clearance_mm", QStringLiteral("50"));
    const balance_shaft::BuildableAngles& angles = model->result().buildable;
    ASSERT_TRUE(angles.stretches.empty());
    const double alpha = model->shaftAngleDeg();
    for (const char* name : {"go_best_range", "go_best_rms"}) {
        press(name);
        EXPECT_EQ(model->shaftAngleDeg(), alpha) << name;
        EXPECT_EQ(find<QPushButton>(name)->toolTip(), messageText(angles.reason));
    }
    EXPECT_EQ(std::ranges::count_if(page.sceneActions(), &QAction::isEnabled), 1) << "of play";
    type("clearance_mm", QStringLiteral("2"));
    EXPECT_TRUE(find<QPushButton>("go_best_range")->isEnabled());
    EXPECT_EQ(std::ranges::count_if(page.sceneActions(), &QAction::isEnabled), 3);
}

TEST_F(BalanceShaftPageTest, WhatCannotBeBuiltIsShaded) {
    EXPECT_EQ(partPlot(page, "range")->data().bands.size(), 2U);
    // The page says which sizes that rests on.
    EXPECT_TRUE(field("rod_width_mm")->placeholderText().contains(QStringLiteral("23")));
    type("clearance_mm", QStringLiteral("50"));
    ASSERT_EQ(partPlot(page, "range")->data().bands.size(), 1U);
    EXPECT_EQ(partPlot(page, "range")->data().bands[0].to, 360.0);
}

TEST_F(BalanceShaftPageTest, OffsetCylinderIsDrawnAndTurned) {
    // The shaft below a wide crank: the crank's axis is in the middle of the picture.
    model->setByKey(QStringLiteral("envelope/crank_swing_radius_mm"), QStringLiteral("70"));
    model->setShaftAngleDeg(180.0);
    model->finishDrag();
    type("offset_mm", QStringLiteral("8"));
    EXPECT_EQ(model->input().cylinder.offset, 8e-3);
    EXPECT_GT(model->result().dead_centre, 0.0);
    EXPECT_FALSE(page.findChild<MechanismPicture*>()->grab().isNull());
    // A click straight above the crank's axis turns the crank there, before top dead centre.
    model->crank()->turnTo(60.0);
    QTest::mouseClick(page.findChild<MechanismPicture*>(), Qt::LeftButton, {},
                      QPoint(page.findChild<MechanismPicture*>()->width() / 2, 30));
    EXPECT_NEAR(model->crank()->degrees() + model->result().dead_centre / degree, 360.0, 0.5);
    model->history()->undo();
    EXPECT_EQ(model->input().cylinder.offset, 0.0);
}

TEST_F(BalanceShaftPageTest, TorqueTableIsEdited) {
    ASSERT_EQ(table->rowCount(), 49);
    const QString angle = cell(30, 0);
    const struct {
        int row;
        int column;
        const char* text;  ///< null: what was rejected is taken back
        std::set<std::pair<int, int>> marked;
        const char* said;  ///< of what is rejected
        double peak;       ///< of the torque, N·m
    } steps[]{
        {25, 1, "1000,5", {}, "", 1000.5},
        // What is no number is kept, marked, and changes nothing, nor does what may be two.
        {25, 1, "oops", {{25, 1}}, "Row 26: “oops” is not a number.", 1000.5},
        {25, 1, "1,893", {{25, 1}}, "“1,893” may be 1893 or 1.893: enter one of them.", 1000.5},
        {25, 1, "900", {}, "", 900.0},
        {25, 1, "oops", {{25, 1}}, "Row 26:", 900.0},
        {30, 0, "?", {{25, 1}, {30, 0}}, "Row 26:", 900.0},
        {25, 1, "900", {{30, 0}}, "Row 31:", 900.0},
        // An angle that does not grow is marked too; beside it what is right counts.
        {30, 0, "0", {{30, 0}}, "Row 31:", 900.0},
        {10, 0, "151", {{30, 0}}, "Row 31:", 900.0},
        {25, 1, "901", {{30, 0}}, "Row 31:", 901.0},
        {30, 0, "700", {{30, 0}}, "Row 31:", 901.0},
        {30, 0, nullptr, {}, "", 901.0},
        // An end without its cycle too.
        {0, 0, "1", {{0, 0}}, "Row 1:", 901.0},
        {30, 0, "0", {{0, 0}, {30, 0}}, "Row 31:", 901.0},
        {7, 0, "107", {{0, 0}, {30, 0}}, "Row 1:", 901.0},
        {0, 0, nullptr, {{30, 0}}, "Row 31:", 901.0},
        {30, 0, nullptr, {}, "", 901.0},
    };
    for (const auto& step : steps) {
        SCOPED_TRACE(testing::Message() << step.row << ", " << step.column << ": "
                                        << (step.text != nullptr ? step.text : "back"));
        if (step.text != nullptr) {
            put(step.row, step.column, step.text);
        } else {
            table->takeBackRejected(table->index(step.row, step.column));
        }
        for (int row = 0; row < table->rowCount(); ++row) {
            for (const int column : {0, 1}) {
                EXPECT_EQ(isMarked(row, column), step.marked.contains({row, column})) << row;
            }
        }
        EXPECT_EQ(table->trouble().isEmpty(), step.marked.empty());
        EXPECT_TRUE(table->trouble().contains(QString::fromUtf8(step.said)))
            << table->trouble().toStdString();
        EXPECT_NEAR(model->result().M_up.min, -step.peak, 1e-9);
    }
    EXPECT_EQ(cell(30, 0), angle);
    EXPECT_EQ(model->input().torque.table.crank_angle_deg[10], 151.0);
    EXPECT_EQ(model->input().torque.table.crank_angle_deg[7], 107.0);
    // What is rejected is said up to a few.
    for (int row = 39; row < 46; ++row) {
        put(row, 1, "-");
    }
    EXPECT_TRUE(table->trouble().endsWith(QStringLiteral("Also not accepted: 4")))
        << table->trouble().toStdString();
    for (int row = 39; row < 46; ++row) {
        put(row, 1, "40");
    }
    EXPECT_TRUE(table->trouble().isEmpty());
    // The ends are one instant of the cycle, in a pasted cell too.
    EXPECT_EQ(table->paste(0, 1, {{QStringLiteral("-90")}}), QString());
    EXPECT_EQ(cell(48), QStringLiteral("−90"));
    EXPECT_TRUE(table->trouble().isEmpty());
    EXPECT_EQ(table->paste(48, 1, {{QStringLiteral("0")}}), QString());
    EXPECT_EQ(model->input().torque.table.torque.front(), 0.0);
    put(0, 1, "7");
    EXPECT_EQ(cell(48), QStringLiteral("7"));
    EXPECT_TRUE(table->trouble().isEmpty());
    // A row between two others leaves the curve as it is.
    const double rms = model->result().M_up.rms;
    table->insertRowBelow(10);
    EXPECT_EQ(table->rowCount(), 50);
    EXPECT_NEAR(model->result().M_up.rms, rms, 1e-9);
    table->removeRowRange(11, 1);
    EXPECT_EQ(table->rowCount(), 49);
    editor->view()->setCurrentIndex(table->index(10, 1));
    QTest::mouseClick(test::named<QToolButton>(*editor, "add_row"), Qt::LeftButton);
    EXPECT_EQ(editor->view()->currentIndex(), table->index(11, 1));
    table->removeRowRange(11, 1);
    // Below the end of the cycle is no row: the new one is above it.
    editor->view()->setCurrentIndex(table->index(48, 0));
    QTest::mouseClick(test::named<QToolButton>(*editor, "add_row"), Qt::LeftButton);
    EXPECT_EQ(table->rowCount(), 50);
    EXPECT_EQ(editor->view()->currentIndex(), table->index(48, 0));
    table->removeRowRange(48, 1);
    EXPECT_NEAR(model->result().M_up.rms, rms, 1e-9);
}

TEST_F(BalanceShaftPageTest, ARejectedCellIsTheNewestThingToUndo) {
    QAction undo;
    undo.setShortcut(QKeySequence::Undo);
    page.addAction(&undo);
    QObject::connect(&undo, &QAction::triggered, model, &SceneModel::undo);
    const double before = model->shaftAngleDeg();
    model->setShaftAngleDeg(before + 25.0);
    model->finishDrag();
    QTableView* view = editor->view();
    const auto typeIn = [&](int row, const char* text) {
        view->setCurrentIndex(table->index(row, 1));
        view->edit(table->index(row, 1));
        test::type(view->viewport()->findChild<QLineEdit*>(), QString::fromLatin1(text));
        QApplication::processEvents();
        QApplication::processEvents();
        view->setFocus();
    };
    const QString five = cell(5);
    const QString eight = cell(8);
    typeIn(5, "abc");
    typeIn(8, "77");
    EXPECT_EQ(cell(5), QStringLiteral("abc"));
    EXPECT_EQ(cell(8), QStringLiteral("77"));
    // What is right beside it counts, and is one step of the history.
    EXPECT_EQ(model->input().torque.table.torque[8], 77.0);
    EXPECT_TRUE(isMarked(5, 1));
    QTest::keyClick(view, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(cell(5), five);
    EXPECT_EQ(cell(8), QStringLiteral("77"));
    EXPECT_EQ(table->trouble(), QString());
    QTest::keyClick(view, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(cell(8), eight);
    EXPECT_EQ(model->shaftAngleDeg(), before + 25.0);
    // In the red cell its own text goes, with either key.
    for (const auto& [key, modifier] :
         {std::pair(Qt::Key_Z, Qt::ControlModifier), std::pair(Qt::Key_Escape, Qt::NoModifier)}) {
        typeIn(5, "abc");
        typeIn(8, "77");
        view->setCurrentIndex(table->index(5, 1));
        QTest::keyClick(view, key, modifier);
        EXPECT_EQ(cell(5), five);
        EXPECT_EQ(cell(8), QStringLiteral("77"));
        EXPECT_EQ(table->trouble(), QString());
        EXPECT_EQ(model->shaftAngleDeg(), before + 25.0);
    }
    // It outlives changes elsewhere. The document's undo clears it first, as in fields.
    typeIn(5, "abc");
    model->setByKey(QStringLiteral("shaft_angle_deg"), QStringLiteral("12"));
    EXPECT_EQ(cell(5), QStringLiteral("abc"));
    EXPECT_EQ(cell(8), QStringLiteral("77"));
    model->undo();
    EXPECT_EQ(cell(5), five);
    EXPECT_EQ(table->trouble(), QString());
    EXPECT_EQ(model->shaftAngleDeg(), 12.0);
    model->undo();
    EXPECT_EQ(model->shaftAngleDeg(), before + 25.0);
}

TEST_F(BalanceShaftPageTest, TableTakesASpreadsheet) {
    QApplication::clipboard()->setText(
        QStringLiteral("angle\ttorque\n0\t0\n180\t100,5\n360\t0\n540\t-20\n720\t0\n"));
    QTableView* view = editor->view();
    QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(table->rowCount(), 5);
    EXPECT_NEAR(model->result().M_up.min, -100.5, 1e-9);
    const auto says = [&](const char* text) {
        const auto labels = editor->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
            return label->text().startsWith(QLatin1String(text));
        });
    };
    EXPECT_TRUE(says("Read 5 rows"));
    model->history()->undo();
    EXPECT_EQ(table->rowCount(), 49);
    EXPECT_FALSE(says("Read"));
    // A few cells go where the cursor stands.
    view->setCurrentIndex(table->index(3, 1));
    QApplication::clipboard()->setText(QStringLiteral("-1\n-2\n"));
    QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(cell(4), QStringLiteral("−2"));
    // A cycle that is rejected is not put among the rows of this one.
    const QString below = cell(5);
    QApplication::clipboard()->setText(
        QStringLiteral("0\t-81\n180\t40\n360\t1,893\n540\t40\n720\t-81\n"));
    QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(cell(5), below);
    EXPECT_EQ(cell(4), QStringLiteral("−2"));
    EXPECT_TRUE(table->trouble().isEmpty());
}

TEST_F(BalanceShaftPageTest, MeansOfNodesAreShownWithThePapersTableAlone) {
    const qsizetype rows = model->criteria().rows.size();
    model->setTorqueKind(balance_shaft::TorqueSource::Kind::cycle);
    EXPECT_EQ(model->criteria().rows.size(), rows - 1);
}

TEST_F(BalanceShaftPageTest, TheStrokeIsTwiceTheCrankRadiusWhicheverIsTyped) {
    type("stroke_mm", QStringLiteral("75/2*2"));
    EXPECT_DOUBLE_EQ(model->input().crank_radius, 0.0375);
    EXPECT_EQ(field("crank_radius_mm")->value(), 37.5);
    type("crank_radius_mm", QStringLiteral("46"));
    EXPECT_EQ(field("stroke_mm")->value(), 92.0);
    type("stroke_mm", QStringLiteral("0"));
    EXPECT_FALSE(field("stroke_mm")->trouble().isEmpty());
    EXPECT_DOUBLE_EQ(model->input().crank_radius, 0.046);
}

TEST_F(BalanceShaftPageTest, WhileAnEntryIsRedTheVerdictSaysWhoseResultsTheyAre) {
    const auto* verdict = page.findChild<VerdictLine*>();
    const QString before = verdict->text();
    const int height = verdict->height();
    type("crank_radius_mm", QStringLiteral("-1"));
    EXPECT_TRUE(verdict->text().contains(QStringLiteral("previous value of each red field")));
    EXPECT_EQ(verdict->height(), height) << "no field moves under the hand";
    for (const QString& copied : {page.resultsAsText(), page.resultsAsCsv()}) {
        EXPECT_TRUE(copied.startsWith(QStringLiteral("Results use the previous value")));
    }
    type("crank_radius_mm", QStringLiteral("46"));
    EXPECT_EQ(verdict->text(), before);
}

TEST_F(BalanceShaftPageTest, WhatIsAssumedIsGreyAndHasItsNumber) {
    const NumberField* bore = field("bore_mm");
    blank("bore_mm");
    EXPECT_FALSE(bore->value());
    EXPECT_TRUE(bore->placeholderText().contains(QStringLiteral("92"))) << "the stroke";
    type("stroke_mm", QStringLiteral("80"));
    EXPECT_TRUE(bore->placeholderText().contains(QStringLiteral("80")));
}

TEST_F(BalanceShaftPageTest, StrokesThatTheTableDoesNotFitAreRejectedInWords) {
    auto* strokes = find<QComboBox>("strokes");
    auto* why = find<QLabel>("strokesRejected");
    EXPECT_TRUE(why->isHidden());
    strokes->setFocus();
    QTest::keyClick(strokes, Qt::Key_Up);
    EXPECT_EQ(strokes->currentData(), 4);
    EXPECT_FALSE(why->isHidden());
    EXPECT_TRUE(why->text().contains(QStringLiteral("720"))) << why->text().toStdString();
    type("crank_radius_mm", QStringLiteral("47"));
    EXPECT_TRUE(why->isHidden());
}

}  // namespace
}  // namespace ravnoves
