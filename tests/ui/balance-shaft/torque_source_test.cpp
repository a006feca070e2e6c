#include "balance-shaft/torque_source_editor.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>

#include "balance-shaft/balance_shaft_page.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/model/torque_table_model.h"
#include "case-file/case_file.h"
#include "page_fixture.h"
#include "text/preferences.h"
#include "text/shown_units.h"
#include "widgets/form_section.h"

namespace ravnoves {
namespace {

using Kind = balance_shaft::TorqueSource::Kind;

class TorqueSourceTest : public test::PageTest<BalanceShaftPage> {
  protected:
    void choose(int index) { PageTest::choose("torque_source", index); }

    TorqueSourceEditor* source = page.findChild<TorqueSourceEditor*>();
    TorqueTableEditor* entries = source->findChild<TorqueTableEditor*>();
};

TEST_F(TorqueSourceTest, TheComputedCycleStartsAtTheLoadOfTheTable) {
    const double mean = model->result().M_up.mean;
    choose(2);
    ASSERT_EQ(model->input().torque.kind, Kind::cycle);
    EXPECT_NEAR(model->result().M_up.mean, mean, 1e-6 * std::abs(mean));
    EXPECT_FALSE(model->cycle().rows.isEmpty());
    // Back again, the table is as it was.
    choose(0);
    EXPECT_EQ(model->input().torque.kind, Kind::table);
    EXPECT_NEAR(model->result().M_up.range, 1208.0, 1e-9);
    EXPECT_TRUE(model->cycle().rows.isEmpty());
}

TEST_F(TorqueSourceTest, ACaseWithAComputedCycleAloneLeadsToATable) {
    choose(2);
    Json input = model->inputJson();
    model->loadCase(input, {}, QStringLiteral("Cycle"));  // no other source is known now
    ASSERT_EQ(model->input().torque.table.size(), 0U);
    const double range = model->result().M_up.range;
    choose(0);
    EXPECT_EQ(model->input().torque.kind, Kind::cycle);
    EXPECT_EQ(find<QComboBox>("torque_source")->currentIndex(), 0);
    auto* take = find<QPushButton>("take_computed_torque");
    bring(source);
    ASSERT_TRUE(take->isVisible());
    QTest::mouseClick(take, Qt::LeftButton);
    EXPECT_EQ(model->input().torque.kind, Kind::table);
    EXPECT_EQ(model->input().torque.table.size(), 721U);
    EXPECT_NEAR(model->result().M_up.range, range, 2e-3 * range);
    EXPECT_FALSE(take->isVisible());
    // Undone, the cycle is there, and so is the way.
    model->undo();
    EXPECT_EQ(model->input().torque.kind, Kind::cycle);
    choose(0);
    EXPECT_TRUE(take->isVisible());
    QApplication::clipboard()->setText(QStringLiteral("0;0\n180;-50\n360;0\n540;50\n720;0\n"));
    for (auto* tool : entries->findChildren<QToolButton*>()) {
        if (tool->accessibleName() == QStringLiteral("Paste (Ctrl+V)")) {
            ASSERT_TRUE(tool->isVisible());
            QTest::mouseClick(tool, Qt::LeftButton);
        }
    }
    EXPECT_EQ(model->input().torque.kind, Kind::table);
    EXPECT_EQ(model->input().torque.table.size(), 5U);
}

TEST_F(TorqueSourceTest, APastedTableOfAnotherCycleWarnsThatTheEngineChanges) {
    const auto pasted = [&](const char* text) {
        QApplication::clipboard()->setText(QString::fromUtf8(text));
        entries->paste();
        QStringList said;
        for (const auto* label : entries->findChildren<QLabel*>()) {
            said << label->text();
        }
        return said.join(QLatin1Char('\n'));
    };
    const QString note = QStringLiteral("the four-stroke engine is now a two-stroke");
    EXPECT_FALSE(pasted("0;0\n360;100\n720;0\n").contains(note));
    EXPECT_TRUE(pasted("0;0\n180;100\n360;0\n").contains(note));
    EXPECT_EQ(model->input().strokes, 2);
    EXPECT_FALSE(pasted("0;0\n180;90\n360;0\n").contains(note));
}

TEST_F(TorqueSourceTest, APastedTextInItsOwnUnitIsNotConvertedByTheShownOne) {
    Preferences::instance().setUnits(Preferences::Torque, Preferences::Units::Imperial);
    const auto pasted = [&](const char* heading) {
        QApplication::clipboard()->setText(QString::fromUtf8(heading) +
                                           QStringLiteral("0;0\n360;100\n720;0\n"));
        entries->paste();
        return model->input().torque.table.torque.at(1);
    };
    const double shown = 100 * shownAs(units::N_m);
    EXPECT_NE(shown, 100.0);
    EXPECT_NEAR(pasted(""), shown, 1e-9);
    EXPECT_NEAR(pasted("deg;M (lbf·in)\n"), 100 * units::lbf_in, 1e-9);
    EXPECT_NEAR(pasted("deg;M\n"), shown, 1e-9);
    EXPECT_NEAR(pasted("deg;M (N·m)\n"), 100.0, 1e-9);
    EXPECT_NEAR(pasted("deg;M (lb-ft)\n"), 100 * units::lbf_ft, 1e-9);
    Preferences::instance().setUnits(Preferences::Torque, Preferences::Units::Own);
}

TEST_F(TorqueSourceTest, WithoutATraceItSaysWhoseResultsTheyAre) {
    const auto* line = find<QLabel>("no_trace");
    bring(source);
    choose(1);
    EXPECT_TRUE(line->isVisible());
    EXPECT_TRUE(line->text().contains(QStringLiteral("the table is used")))
        << qPrintable(line->text());
    choose(2);
    EXPECT_FALSE(line->isVisible());
    choose(1);
    EXPECT_TRUE(line->text().contains(QStringLiteral("computed"))) << qPrintable(line->text());
}

TEST_F(TorqueSourceTest, AnEmptySourceStaysChosenUntilAnotherGivesTheTorque) {
    model->setTorqueKind(balance_shaft::TorqueSource::Kind::cycle);
    model->edit(QStringLiteral("x"), [](balance_shaft::Input& input) { input.torque.table = {}; });
    const auto* chosen = find<QComboBox>("torque_source");
    bring(source);
    const auto* take = find<QPushButton>("take_computed_torque");
    for (const int empty : {0, 1}) {
        choose(empty);
        model->editField("/crank_radius_mm", 45.0 + empty, QStringLiteral("x"));
        EXPECT_EQ(chosen->currentIndex(), empty) << "another input changes nothing of it";
        EXPECT_EQ(take->isVisible(), empty == 0);
    }
    choose(0);
    QApplication::clipboard()->setText(QStringLiteral("deg;M\n0;1\n180;2\n360;3\n540;4\n720;1\n"));
    entries->paste();
    EXPECT_EQ(model->input().torque.table.size(), 5U);
    EXPECT_EQ(model->input().torque.kind, balance_shaft::TorqueSource::Kind::table);
    EXPECT_EQ(chosen->currentIndex(), 0);
    EXPECT_FALSE(take->isVisible());
    model->undo();
    EXPECT_EQ(chosen->currentIndex(), 2) << "the cycle gives the torque again";
}

TEST_F(TorqueSourceTest, AnEmptyTableBeginsWithTheFirstRowAdded) {
    model->setTorqueKind(Kind::cycle);
    model->edit(QStringLiteral("x"), [](balance_shaft::Input& input) { input.torque.table = {}; });
    bring(source);
    choose(0);
    QTest::mouseClick(test::named<QToolButton>(*entries, "add_row"), Qt::LeftButton);
    EXPECT_EQ(model->input().torque.kind, Kind::table);
    EXPECT_EQ(model->input().torque.table,
              (balance_shaft::TorqueTable{{0.0, 360.0, 720.0}, {0.0, 0.0, 0.0}}));
    EXPECT_EQ(model->input().strokes, 4);
    QTableView* view = entries->view();
    EXPECT_EQ(view->currentIndex().row(), 0) << "it is typed from the top";
    view->model()->setData(view->model()->index(1, TorqueTableModel::Torque), QStringLiteral("50"),
                           Qt::EditRole);
    EXPECT_EQ(model->input().torque.table.torque.at(1), 50.0);
    model->undo();
    model->undo();
    EXPECT_EQ(model->input().torque.kind, Kind::cycle);
}

TEST_F(TorqueSourceTest, ABlockWithoutRoomIsRejectedInWords) {
    QTableView* view = entries->view();
    const QAbstractItemModel& table = *view->model();
    const auto paste = [&](int row, const QString& block) {
        view->setCurrentIndex(table.index(row, TorqueTableModel::Torque));
        QApplication::clipboard()->setText(block);
        entries->paste();
        return entries->findChild<TroubleLine*>()->text();
    };
    const auto before = model->input().torque.table;
    EXPECT_TRUE(
        paste(3, QStringLiteral("9000\t7\n9001\t8\n")).contains(QStringLiteral("2 columns")));
    EXPECT_TRUE(paste(3, QStringLiteral("1\t2\t3\n")).contains(QStringLiteral("3 columns")));
    EXPECT_TRUE(paste(table.rowCount() - 2, QStringLiteral("1\n2\n3\n"))
                    .contains(QStringLiteral("3 rows")));
    EXPECT_EQ(model->input().torque.table, before);
}

}  // namespace
}  // namespace ravnoves
