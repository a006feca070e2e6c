#include "inertia-moments/inertia_moments_page.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>

#include "case-file/json.h"
#include "inertia-moments/cylinder_editor.h"
#include "inertia-moments/engine_view.h"
#include "inertia-moments/model/cylinder_table_model.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "page_fixture.h"
#include "text/message_text.h"
#include "widgets/form_section.h"
#include "widgets/verdict_line.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
class InertiaMomentsPageTest : public test::PageTest<InertiaMomentsPage> {
  protected:
    /// The plot of a part as it is now, also behind another tab.
    PartPlot* shown(const char* part) {
        PartPlot* plot = partPlot(page, part);
        plot->make();
        return plot;
    }
    PartPlot* ofOrder(int number) { return shown(number == 1 ? "order-1" : "order-2"); }
    QSlider* speed() { return find<QSlider>("speed_rpm_slider"); }
    CylinderTableModel* cylinders() { return page.findChild<CylinderTableModel*>(); }
    void radial() {
        model->edit(QStringLiteral("radial"), [](inertia_moments::Input& input) {
            input.layout.reset();
            input.firing_order.clear();
            for (int i = 0; i < 5; ++i) {
                input.cylinders.push_back({0.0, i * 72.0 * degree, 0.0, 0.0});
            }
        });
    }
    /// The hodographs are those of a page that begins with this input.
    void expectFreshHodographs() {
        InertiaMomentsPage fresh;
        fresh.viewModel()->loadInput(model->inputJson(), {});
        test::showAt(fresh, {1187, 712});
        bring(test::named<QWidget>(fresh, "hodographs"));
        for (const char* part : {"hodograph-forces", "hodograph-moments"}) {
            EXPECT_EQ(shown(part)->grab().toImage(), partPlot(fresh, part)->grab().toImage())
                << part;
        }
    }
};

TEST_F(InertiaMomentsPageTest, SlidersThatMeanNothingAreOff) {
    model->chooseLayout(QStringLiteral("i4"));
    EXPECT_FALSE(find<QSlider>("bank_angle_deg_slider")->isEnabled());
    EXPECT_TRUE(find<QSlider>("offset_mm_slider")->isEnabled());
    EXPECT_FALSE(field("stagger_mm")->isEnabled());
    EXPECT_TRUE(field("stagger_mm")->toolTip().contains(QStringLiteral("No effect")));
    // One from a file can be removed.
    model->setByKey(QStringLiteral("layout/stagger_mm"), QStringLiteral("20"));
    ASSERT_TRUE(field("stagger_mm")->isEnabled());
    type("stagger_mm", QStringLiteral("0"));
    EXPECT_FALSE(field("stagger_mm")->isEnabled());
    model->chooseLayout(QStringLiteral("table"));
    EXPECT_FALSE(find<QSlider>("offset_mm_slider")->isEnabled());
    EXPECT_FALSE(field("spacing_mm")->isVisible());
    model->chooseLayout(QStringLiteral("vr6"));
    EXPECT_TRUE(find<QSlider>("bank_angle_deg_slider")->isEnabled());
    EXPECT_FALSE(field("stagger_mm")->isEnabled());
    model->chooseLayout(QStringLiteral("v6-90"));
    EXPECT_TRUE(field("stagger_mm")->isEnabled());
    EXPECT_FALSE(field("stagger_mm")->toolTip().contains(QStringLiteral("No effect")));
}

TEST_F(InertiaMomentsPageTest, LayoutsAreChosenFromTheList) {
    auto* box = find<QComboBox>("layout");
    for (const Qt::Key key : {Qt::Key_Home, Qt::Key_Down, Qt::Key_End}) {
        QTest::keyClick(box, key);
        EXPECT_EQ(model->layoutName(), box->currentData().toString());
    }
}

TEST_F(InertiaMomentsPageTest, AnotherSpacingKeepsTheEngineInTheMiddle) {
    model->chooseLayout(QStringLiteral("i4"));
    const int steps = model->history()->count();
    type("spacing_mm", QStringLiteral("100"));
    EXPECT_FALSE(field("first_position_mm")->value());
    EXPECT_EQ(field("first_position_mm")->placeholderText(), QStringLiteral("150"));
    EXPECT_EQ(model->history()->count(), steps + 1) << "one step brings both back";
}

TEST_F(InertiaMomentsPageTest, RigidRodIsSwitchedOnAsTwoMasses) {
    press("rigid_rod");
    ASSERT_TRUE(model->input().rod.has_value());
    EXPECT_NEAR(model->result().engine.rod_couple_inertia, 0.0, 1e-12);
    EXPECT_TRUE(field("rod_inertia_kg_m2")->isVisible());
    type("rod_inertia_kg_m2", QStringLiteral("0.004"));
    EXPECT_GT(std::abs(model->result().engine.rod_couple_inertia), 1e-4);
    press("rigid_rod");
    EXPECT_FALSE(model->input().rod.has_value());
}

TEST_F(InertiaMomentsPageTest, RotatingMassIsGivenForACylinderOrForAThrow) {
    auto* given = find<QComboBox>("rotating_mass_given");
    auto* onThrow = find<QLabel>("mass_on_throw");
    EXPECT_TRUE(
        field("rotating_mass_kg")->toolTip().startsWith(QStringLiteral("Mass of one cylinder")));
    EXPECT_FALSE(given->isEnabled());  // each pin of the VR5 has one rod
    EXPECT_EQ(onThrow->text(), QStringLiteral("0.8\u00A0kg, rods: 1"));
    model->chooseLayout(QStringLiteral("v8-cross-plane"));
    EXPECT_TRUE(given->isEnabled());
    EXPECT_EQ(onThrow->text(), QStringLiteral("1.6\u00A0kg, rods: 2"));
    const double weight = model->result().counterweights->front.mass();
    given->setFocus();
    QTest::keyClick(given, Qt::Key_Down);
    EXPECT_TRUE(model->input().rotating_mass_of_throw);
    EXPECT_TRUE(field("rotating_mass_per_throw_kg")->isVisible());
    EXPECT_FALSE(field("rotating_mass_kg")->isVisible());
    EXPECT_NEAR(*field("rotating_mass_per_throw_kg")->value(), 1.6, 1e-12);
    EXPECT_NEAR(model->result().counterweights->front.mass(), weight, 1e-12);
    type("rotating_mass_per_throw_kg", QStringLiteral("2"));
    EXPECT_NEAR(model->result().engine.rotating_mass, 1.0, 1e-12);
    EXPECT_TRUE(page.resultsAsText().contains(QStringLiteral("On a throw, rods: 2, g")));
    model->history()->undo();
    model->history()->undo();
    EXPECT_FALSE(model->input().rotating_mass_of_throw);
    EXPECT_NEAR(*field("rotating_mass_kg")->value(), 0.8, 1e-12);
}

TEST_F(InertiaMomentsPageTest, TwoStrokesFireInOneTurn) {
    auto* strokes = find<QComboBox>("strokes");
    model->chooseLayout(QStringLiteral("i4"));
    EXPECT_NEAR(model->result().firing[0].interval / degree, 180.0, 1e-9);
    strokes->setFocus();
    QTest::keyClick(strokes, Qt::Key_Up);
    EXPECT_EQ(model->input().strokes, 2);
    EXPECT_NEAR(model->result().firing[0].interval / degree, 90.0, 1e-9);
    bring("firing");
    EXPECT_FALSE(page.grab().isNull());
    // On a crank of its own the order of a four-stroke does not fit, and the page says which would.
    model->chooseLayout(QStringLiteral("v8-cross-plane"));
    EXPECT_TRUE(model->result().firing.empty());
    auto* misfit = test::named<QLabel>(page, "firing_misfit");
    EXPECT_FALSE(misfit->isHidden());
    EXPECT_TRUE(misfit->text().contains(QStringLiteral("cannot fire in the order")));
    EXPECT_FALSE(page.grab().isNull());
    model->setFiringOrder(inertia_moments::dead_centre_order(model->result().engine));
    EXPECT_EQ(model->result().firing.size(), 8U);
    EXPECT_TRUE(misfit->isHidden());
    EXPECT_FALSE(page.grab().isNull());  // pairs that fire at once
    model->history()->undo();
    EXPECT_EQ(model->input().strokes, 2);
}

// The table from the keyboard: a radial, its rods hung on masters, one of them changed and put
// back.
TEST_F(InertiaMomentsPageTest, ArticulatedRodsAreEditedInTheTable) {
    bring("cylinders");
    auto* box = find<QCheckBox>("articulated");
    ASSERT_NE(box, nullptr);
    EXPECT_FALSE(box->isVisible());  // every pin of the VR5 has one rod
    radial();
    EXPECT_TRUE(box->isVisible());
    EXPECT_FALSE(box->isChecked());
    QTableView* view = page.findChild<CylinderEditor*>()->view();
    EXPECT_EQ(view->model()->columnCount(), CylinderTableModel::KnuckleRadius);
    const double plain = model->result().exact.order(2).force.max();
    EXPECT_TRUE(messageText(model->verdict().text).contains(QStringLiteral("Articulated rods")));
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Space);
    EXPECT_TRUE(box->isChecked());
    EXPECT_FALSE(messageText(model->verdict().text).contains(QStringLiteral("plain rods")));
    EXPECT_GT(model->result().exact.order(2).force.max(), plain + 100.0);
    ASSERT_EQ(view->model()->columnCount(), CylinderTableModel::Columns);
    const auto cell = [&](int row, int column) { return view->model()->index(row, column); };
    const auto typeInto = [&](int row, int column, const char* text) {
        return view->model()->setData(cell(row, column), QString::fromLatin1(text));
    };
    // The master has nothing to type in but a knuckle radius; the others show what follows.
    EXPECT_TRUE(cell(0, CylinderTableModel::KnuckleAngle).data().toString().isEmpty());
    EXPECT_FALSE(cell(0, CylinderTableModel::RodLength).flags().testFlag(Qt::ItemIsEditable));
    EXPECT_EQ(cell(2, CylinderTableModel::KnuckleAngle).data().toString(), QStringLiteral("144"));
    EXPECT_EQ(cell(2, CylinderTableModel::Master).data().toString(), QStringLiteral("1"));
    EXPECT_FALSE(cell(2, CylinderTableModel::Master).data(Qt::FontRole).value<QFont>().italic());
    const auto angle = cell(2, CylinderTableModel::KnuckleAngle);
    EXPECT_TRUE(angle.data(Qt::FontRole).value<QFont>().italic());
    EXPECT_TRUE(angle.data(Qt::EditRole).toString().isEmpty());
    // A radius, an angle, a length, a mass.
    EXPECT_TRUE(typeInto(2, CylinderTableModel::KnuckleRadius, "36,5"));
    EXPECT_TRUE(typeInto(2, CylinderTableModel::KnuckleAngle, "143"));
    EXPECT_TRUE(typeInto(2, CylinderTableModel::RodLength, "133"));
    EXPECT_TRUE(typeInto(2, CylinderTableModel::KnuckleMass, "0.2"));
    const auto& rod = model->input().cylinders.at(2).articulated;
    ASSERT_TRUE(rod.has_value());
    EXPECT_NEAR(rod->knuckle_radius, 0.0365, 1e-15);
    EXPECT_NEAR(*rod->knuckle_angle, 143.0 * degree, 1e-15);
    EXPECT_NEAR(*rod->rod_length, 0.133, 1e-15);
    EXPECT_NEAR(rod->knuckle_mass, 0.2, 1e-15);
    EXPECT_FALSE(cell(2, CylinderTableModel::RodLength).data(Qt::FontRole).value<QFont>().italic());
    QSignalSpy trouble(cylinders(), &EditableTable::troubleChanged);
    // The picture has the knuckle pins.
    const QImage hung = page.findChild<EngineView*>()->grab().toImage();
    EXPECT_TRUE(typeInto(1, CylinderTableModel::KnuckleRadius, "20"));
    EXPECT_NE(page.findChild<EngineView*>()->grab().toImage(), hung);
    // Masters keep their cylinders; without one the others cannot run.
    CylinderTableModel* table = cylinders();
    table->removeRowRange(2, 1);
    ASSERT_EQ(model->input().cylinders.size(), 4U);
    EXPECT_EQ(model->result().engine.cylinders[3].articulated->master, 1);
    table->removeRowRange(0, 1);
    EXPECT_EQ(model->input().cylinders.size(), 4U);
    EXPECT_TRUE(trouble.last().at(0).toString().contains(QStringLiteral("master rod")));
    // A row copied from an articulated one has a plain rod.
    table->insertRowBelow(1);
    ASSERT_EQ(model->input().cylinders.size(), 5U);
    EXPECT_FALSE(model->input().cylinders.at(2).articulated.has_value());
    // An emptied knuckle radius puts the rod back on the crankpin.
    EXPECT_TRUE(typeInto(1, CylinderTableModel::KnuckleRadius, ""));
    EXPECT_FALSE(model->input().cylinders.at(1).articulated.has_value());
    EXPECT_TRUE(cell(1, CylinderTableModel::RodLength).data().toString().isEmpty());
    // A block from a spreadsheet, with an empty cell for what follows.
    view->setCurrentIndex(cell(1, CylinderTableModel::KnuckleRadius));
    QApplication::clipboard()->setText(QStringLiteral("35\t\t140\t1\n"));
    QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    const auto& pasted = model->input().cylinders.at(1).articulated;
    ASSERT_TRUE(pasted.has_value());
    EXPECT_FALSE(pasted->knuckle_angle.has_value());
    EXPECT_NEAR(*pasted->rod_length, 0.14, 1e-15);
}

TEST_F(InertiaMomentsPageTest, ARadialOfTheListHasArticulatedRods) {
    model->chooseLayout(QStringLiteral("radial-9"));
    EXPECT_TRUE(model->hasArticulatedRods());
    EXPECT_FALSE(model->setEvenFiring().isEmpty());
    EXPECT_FALSE(find<QPushButton>("even_firing")->isEnabled());
    ASSERT_EQ(model->result().firing.size(), 9U);
    bring("firing");
    EXPECT_FALSE(page.grab().isNull());
    // Dead centres and strokes are read at the numbers of the cylinders.
    EXPECT_EQ(cylinders()->headerData(3, Qt::Vertical, Qt::ToolTipRole).toString(),
              QStringLiteral("Top dead centre 3.686° from its axis, stroke 90.40\u00A0mm"));
    // A rigid rod for all is rejected in words.
    auto* rigid = find<QCheckBox>("rigid_rod");
    QSignalSpy status(&page, &ScenePage::status);
    rigid->click();
    EXPECT_FALSE(model->input().rod.has_value());
    EXPECT_FALSE(rigid->isChecked());
    ASSERT_GE(status.size(), 1);
    EXPECT_TRUE(status.last().at(0).toString().contains(QStringLiteral("articulated")));
    // Sizes and speed are the engine's, knuckles are the layout's.
    model->editField("/speed_rpm", 1800.0, {});
    EXPECT_EQ(model->layoutName(), QStringLiteral("radial-9"));
}

// What is rejected is named by row and column as they are read, while the text stands in its cell.
TEST_F(InertiaMomentsPageTest, ARejectedCellIsNamedUntilItIsCorrected) {
    model->chooseLayout(QStringLiteral("radial-9"));
    bring("cylinders");
    CylinderTableModel* table = cylinders();
    auto* line = page.findChild<CylinderEditor*>()->findChild<TroubleLine*>();
    ASSERT_NE(line, nullptr);
    QSignalSpy status(&page, &ScenePage::status);
    const auto put = [&](int row, int column, const char* text) {
        return table->setData(table->index(row, column), QString::fromLatin1(text), Qt::EditRole);
    };
    using Table = CylinderTableModel;
    const struct {
        int row;
        int column;
        const char* text;
        bool isTaken;
        QStringList said;  ///< of the rejected cells, from now on
    } steps[]{
        {1, Table::KnuckleRadius, "-5", false, {u"row 2, knuckle radius: must be from 0 to"_s}},
        {2, Table::KnuckleRadius, "66", true, {u"row 2, knuckle radius"_s}},
        {3,
         Table::KnuckleAngle,
         "abc",
         false,
         {u"row 2, knuckle radius"_s, u"row 4, knuckle angle: must be a number, got \"abc\""_s}},
        {4, Table::Master, "1.5", false, {u"row 5, master rod: must be a whole"_s}},
        {4,
         Table::Master,
         "2",
         false,
         {u"row 5, master rod: must be a rod on the crankpin; the rod"_s}},
        // One after the other they go.
        {1, Table::KnuckleRadius, "67", true, {u"row 4"_s, u"row 5"_s}},
        {4, Table::Master, "1", true, {u"row 4"_s}},
        {3, Table::KnuckleAngle, "120", true, {}},
    };
    for (const auto& step : steps) {
        SCOPED_TRACE(step.text);
        EXPECT_EQ(put(step.row, step.column, step.text), step.isTaken);
        for (const QString& said : step.said) {
            EXPECT_TRUE(line->text().contains(u"Cylinders, "_s + said)) << qPrintable(line->text());
        }
        EXPECT_EQ(line->isVisible(), !step.said.isEmpty());
        EXPECT_FALSE(line->text().contains(u"/input"_s));
        EXPECT_FALSE(status.last().at(0).toString().contains(u"/input"_s));
        EXPECT_EQ(status.last().at(0).toString().isEmpty(), step.isTaken);
        if (step.isTaken) {
            EXPECT_FALSE(line->text().contains(u"row %1,"_s.arg(step.row + 1)));
        }
    }
    EXPECT_TRUE(line->text().isEmpty());
    // A rejected change of the rows leaves no entry beside that of a cell.
    EXPECT_FALSE(put(1, Table::KnuckleRadius, "-5"));
    table->removeRowRange(0, table->rowCount());
    EXPECT_TRUE(page.findChild<VerdictLine*>()->text().contains(u"value of each red field"_s));
}

TEST_F(InertiaMomentsPageTest, AnEngineBesideAnotherShowsTheSameQuantity) {
    InertiaMomentsPage beside;  // the VR5, whose charts show moments
    const PlotView* plot = partPlot(beside, "order-2");
    model->chooseLayout(QStringLiteral("radial-9"));
    beside.viewModel()->takeView(*model);
    EXPECT_EQ(plot->title(), QStringLiteral("Order 2, forces"));
    const auto& second = beside.viewModel()->result().exact.order(2);
    EXPECT_NEAR(*plot->valueAt(0, 30.0), second.force.at(60.0 * degree).imag(), 1e-6);
    model->chooseLayout(QStringLiteral("vw-vr5"));
    beside.viewModel()->takeView(*model);
    EXPECT_EQ(plot->title(), QStringLiteral("Order 2"));
    EXPECT_NEAR(*plot->valueAt(0, 30.0), second.moment.at(60.0 * degree).imag(), 1e-6);
}

TEST_F(InertiaMomentsPageTest, AShaftThatIsOnShowsWhatItCancels) {
    bring("balancing");
    const double before = model->result().remaining.order(1).moment.max();
    // The weights on the end webs alone leave the reciprocating parts; without them nothing differs
    // from what there was before, and there is no curve of what is left.
    EXPECT_NEAR(*ofOrder(1)->valueAt(4, 90.0),
                model->result().exact.order(1).moment.at(90.0 * degree).imag(), 1e-9);
    const auto weigh = [&](bool enabled) {
        model->edit(QString(),
                    [&](inertia_moments::Input& input) { input.end_webs->enabled = enabled; });
    };
    weigh(false);
    EXPECT_FALSE(ofOrder(1)->valueAt(4, 90.0).has_value());
    weigh(true);
    press("shaft_enabled_0");
    EXPECT_LT(model->result().remaining.order(1).moment.max(), before);
    EXPECT_NEAR(*ofOrder(1)->valueAt(4, 90.0),
                model->result().remaining.order(1).moment.at(90.0 * degree).imag(), 1e-9);
    // The action switches all.
    for (const bool enabled : {true, false}) {
        page.sceneActions().at(1)->trigger();
        for (const auto& shaft : model->input().shafts) {
            EXPECT_EQ(shaft.enabled, enabled);
        }
    }
}

TEST_F(InertiaMomentsPageTest, ShaftsAreEditedInTheList) {
    bring("balancing");
    auto* length = find<NumberField>("shaft_length_0");
    ASSERT_NE(length, nullptr);
    const double unbalance = model->result().shafts[0].unbalance;
    const double old = *length->value();
    test::type(length, QString::number(2.0 * old));
    EXPECT_NEAR(model->result().shafts[0].unbalance, 0.5 * unbalance, 1e-12);
    press("shaft_enabled_2");
    EXPECT_TRUE(model->input().shafts[2].enabled);
    test::type(find<NumberField>("shaft_error_2"), QStringLiteral("180"));
    EXPECT_NEAR(std::abs(model->result().remaining.order(2).moment.forward),
                2.0 * std::abs(model->result().exact.order(2).moment.forward), 1e-9);
    press("add_shaft");
    EXPECT_EQ(model->input().shafts.size(), 5U);
    press("remove_shaft_0");
    QApplication::processEvents();
    EXPECT_EQ(model->input().shafts.size(), 4U);
    EXPECT_EQ(model->input().shafts[0].direction, inertia_moments::Direction::backward);
    // Counterweights off: the rotating masses then count in what is left.
    const double left = model->result().remaining.order(1).force.max();
    press("counterweights");
    EXPECT_FALSE(model->input().end_webs->enabled);
    EXPECT_GT(model->result().remaining.order(1).force.max(), left + 1000.0);
    EXPECT_FALSE(field("front_radius_mm")->isVisible());
}

TEST_F(InertiaMomentsPageTest, CylindersAreEditedAsATable) {
    bring("cylinders");
    CylinderTableModel* table = cylinders();
    ASSERT_EQ(table->rowCount(), 5);
    QSignalSpy trouble(table, &EditableTable::troubleChanged);
    EXPECT_TRUE(table->setData(table->index(1, CylinderTableModel::CrankpinAngle),
                               QStringLiteral("200,5"), Qt::EditRole));
    EXPECT_EQ(model->layoutName(), QStringLiteral("table"));
    EXPECT_NEAR(model->result().engine.cylinders[1].crankpin_angle / degree, 200.5, 1e-9);
    EXPECT_FALSE(table->setData(table->index(1, CylinderTableModel::Offset), QStringLiteral("x"),
                                Qt::EditRole));
    EXPECT_FALSE(trouble.last().at(0).toString().isEmpty());
    // An offset at which cylinder 1 locks.
    EXPECT_FALSE(table->setData(table->index(0, CylinderTableModel::Offset), QStringLiteral("150"),
                                Qt::EditRole));
    EXPECT_TRUE(trouble.last().at(0).toString().contains(QStringLiteral("locks")));
    QTest::mouseClick(find<QToolButton>("add_row"), Qt::LeftButton);
    EXPECT_EQ(table->rowCount(), 6);
    table->removeRowRange(0, 6);
    EXPECT_EQ(table->rowCount(), 6);  // one at least
    table->removeRowRange(4, 2);
    EXPECT_EQ(table->rowCount(), 4);
    while (model->history()->canUndo()) {
        model->history()->undo();
    }
    EXPECT_EQ(table->rowCount(), 5);
    EXPECT_EQ(model->layoutName(), QStringLiteral("vw-vr5"));
}

TEST_F(InertiaMomentsPageTest, CylindersAreTypedPastedAndCopied) {
    bring("cylinders");
    QTableView* view = page.findChild<CylinderEditor*>()->view();
    view->setFocus();
    // A V-twin from a spreadsheet over the first rows.
    view->setCurrentIndex(view->model()->index(0, 0));
    QApplication::clipboard()->setText(
        QStringLiteral("z\tβ\te\tκ\r\n0\t22,5\t0\t0\r\n0\t-22,5\t0\t0\r\n"));
    QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    EXPECT_NEAR(model->input().cylinders.at(1).bank_angle / degree, -22.5, 1e-9);
    EXPECT_EQ(model->input().cylinders.size(), 5U);
    // Typing into a cell.
    view->setCurrentIndex(view->model()->index(2, CylinderTableModel::BankAngle));
    QTest::keyClick(view, Qt::Key_3);
    auto* editor = view->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    EXPECT_EQ(editor->text(), QStringLiteral("3"));
    QTest::keyClicks(editor, QStringLiteral("0"));
    EXPECT_EQ(editor->text(), QStringLiteral("30"));
    QTest::keyClick(editor, Qt::Key_Return);
    QApplication::processEvents();  // the view takes the text over when the key is done
    EXPECT_NEAR(model->input().cylinders.at(2).bank_angle / degree, 30.0, 1e-9);
    // Pasting beyond the end adds cylinders.
    view->setCurrentIndex(view->model()->index(4, 0));
    QApplication::clipboard()->setText(QStringLiteral("-90;0;0;90\n-150;0;0;180\n-210;0;0;270\n"));
    QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(model->input().cylinders.size(), 7U);
}

TEST_F(InertiaMomentsPageTest, ADragTurnsThePictureWithoutAJumpAtThePress) {
    EngineView* picture = page.findChild<EngineView*>();
    const double before = model->crank()->degrees();
    QTest::mousePress(picture, Qt::LeftButton, {}, QPoint(30, 150));
    EXPECT_NEAR(model->crank()->degrees(), before, 1e-9);
    test::movePointer(picture, QPoint(60, 60), Qt::LeftButton);
    QTest::mouseRelease(picture, Qt::LeftButton, {}, QPoint(60, 60));
    EXPECT_GT(std::abs(model->crank()->degrees() - before), 3.0);
}

TEST_F(InertiaMomentsPageTest, AxesFollowKeysThatPause) {
    bring("hodographs");
    const inertia_moments::Input before = model->input();
    speed()->setFocus();
    for (int i = 0; i < 60; ++i) {
        QTest::keyClick(speed(), Qt::Key_Left);
    }
    EXPECT_TRUE(model->isMoved());
    QTRY_VERIFY(!model->isMoved());
    expectFreshHodographs();
    // What follows is one step with them.
    QTest::keyClick(speed(), Qt::Key_Left);
    model->undo();
    EXPECT_EQ(model->input(), before);
}

TEST_F(InertiaMomentsPageTest, TheRodsLengthMayStandForLambda) {
    NumberField* length = field("rod_length_mm");
    NumberField* ratio = field("lambda");
    EXPECT_TRUE(length->text().isEmpty());
    EXPECT_EQ(length->placeholderText(), QStringLiteral("169.811"));
    test::type(length, QStringLiteral("150"));
    EXPECT_NEAR(model->input().rod_length(), 0.15, 1e-12);
    EXPECT_TRUE(ratio->text().isEmpty());
    EXPECT_EQ(ratio->placeholderText(), QStringLiteral("0.3"));
    type("crank_radius_mm", QStringLiteral("50"));
    EXPECT_NEAR(model->input().rod_length(), 0.15, 1e-12);
    EXPECT_NEAR(model->result().engine.lambda, 1.0 / 3.0, 1e-12);
    // Emptied, the other one is given, as it is shown.
    blank("rod_length_mm");
    EXPECT_FALSE(model->input().given_rod_length);
    EXPECT_EQ(model->input().lambda, 0.333333);
    test::type(ratio, QStringLiteral("0.25"));
    EXPECT_NEAR(model->input().rod_length(), 0.2, 1e-12);
    // What cannot be is rejected in its field.
    test::type(length, QStringLiteral("40"));
    EXPECT_NEAR(model->input().rod_length(), 0.2, 1e-12);
    EXPECT_EQ(model->inputJson().count("lambda"), 1U);
}

TEST_F(InertiaMomentsPageTest, EveryTabOfEveryLayoutDraws) {
    for (const QString& name : InertiaMomentsModel::layoutNames()) {
        model->chooseLayout(name);
        test::onEveryTab(page, [] {});
        EXPECT_FALSE(page.grab().isNull());
    }
    // A firing order that the crank cannot run through, and no shafts, no weights.
    model->chooseLayout(QStringLiteral("v8-cross-plane"));
    model->setFiringOrder({1, 2, 3, 4, 5, 6, 7, 8});
    model->edit(QStringLiteral("bare"), [](inertia_moments::Input& input) {
        input.shafts.clear();
        input.end_webs.reset();
        input.rotating_mass = 0.0;
    });
    test::onEveryTab(page, [] {});
    EXPECT_FALSE(page.grab().isNull());
}

}  // namespace
}  // namespace ravnoves
