#include "methods/methods_page.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QTabWidget>
#include <QToolButton>
#include <cmath>

#include "events.h"
#include "methods/method_plots.h"
#include "methods/model/case_budget_model.h"
#include "methods/model/method_words.h"
#include "methods/validation_view.h"
#include "methods_support.h"
#include "page_fixture.h"
#include "shell/main_window.h"
#include "text/csv_format.h"
#include "theme/theme.h"
#include "widgets/result_table.h"
#include "widgets/verdict_line.h"

namespace ravnoves {
namespace {

class MethodsPageTest : public test::PageTest<MethodsPage> {
  protected:
    MethodsPageTest() { tabs->setCurrentIndex(1); }

    void measure() {
        page.setActive(true);
        test::waitUntilMeasured(*model);
        QApplication::processEvents();
    }

    QTabWidget* tabs = page.findChild<QTabWidget*>({}, Qt::FindDirectChildrenOnly);
    MethodPlots* plots = page.findChild<MethodPlots*>();
};

/// A value that was typed and given up leaves nothing behind.
TEST_F(MethodsPageTest, EscapeInTheValueBringsTheOldOneBack) {
    auto* value = field("value");
    const QString before = value->text();
    test::typeOver(value, QString::number(model->sweep().at(0.5)));
    EXPECT_NE(model->value(), model->sweep().present);
    QTest::keyClicks(value, QStringLiteral("x"));
    EXPECT_FALSE(value->trouble().isEmpty());
    QTest::keyClick(value, Qt::Key_Escape);
    EXPECT_EQ(value->text(), before);
    EXPECT_EQ(model->value(), model->sweep().present);
}

TEST_F(MethodsPageTest, WhatIsRejectedIsInTheTableAlone) {
    choose("kernel", 5);
    model->setViewOption(QStringLiteral("sweep"), QStringLiteral("speed"));
    model->setValue(1e4);  // the spring stores too little
    measure();
    const QString csv = find<PlotView>("work_plot")->dataAsCsv();
    int row = 0;
    for (const auto& point : model->shown()->report.rows) {
        EXPECT_TRUE(point.result.rejected());
        EXPECT_FALSE(csv.contains(CsvFormat().number(point.timing.median)));
        EXPECT_EQ(page.table()->item(row++, 3)->text(), QStringLiteral("rejected"));
    }
    for (const auto& each : model->shown()->report.rows) {
        EXPECT_FALSE(each.holds);
    }
}

TEST_F(MethodsPageTest, KernelAndParameterAreChosen) {
    measure();
    choose("kernel", 5);
    EXPECT_EQ(model->kernel().id, "guide");
    EXPECT_EQ(find<QComboBox>("sweep")->count(), static_cast<int>(model->kernel().sweeps.size()));
    choose("sweep", 4);
    EXPECT_EQ(model->sweep().id, "locking");
    EXPECT_EQ(field("value")->text(), QStringLiteral("0.7"));
    EXPECT_TRUE(find<QLabel>("words")->text().contains(QStringLiteral("relief")));
    // The charts of the kernel before stay, pale, until the new ones are there.
    EXPECT_TRUE(find<PlotView>("work_plot")->isFaded());
    EXPECT_TRUE(find<PlotView>("work_plot")->title().contains(QStringLiteral("Slider-crank")));
    test::waitUntilMeasured(*model);
    EXPECT_FALSE(find<PlotView>("work_plot")->isFaded());
    EXPECT_TRUE(find<PlotView>("work_plot")->title().contains(QStringLiteral("Guide")));
    EXPECT_TRUE(find<PlotView>("stability_plot")->title().contains(QStringLiteral("Guide")));
}

TEST_F(MethodsPageTest, SliderAndFieldSetTheValue) {
    measure();
    auto* slider = find<QSlider>("value_slider");
    const int y = slider->height() / 2;
    const int x = slider->width() / 4;
    test::drag(slider, {x, y}, {x + 30, y});
    slider->setFocus();
    const double before = model->value();
    QTest::keyClick(slider, Qt::Key_PageUp);
    EXPECT_GT(model->value(), before);
    // A drag leaves the errors along the parameter as they are, and pales the times.
    EXPECT_TRUE(find<PlotView>("work_plot")->isFaded());
    EXPECT_FALSE(find<PlotView>("stability_plot")->isFaded());

    NumberField* value = field("value");
    test::type(value, QStringLiteral("0,001"));
    EXPECT_EQ(model->value(), 0.001);
    EXPECT_EQ(slider->value(), 300);
    test::typeOver(value, QStringLiteral("2"));
    EXPECT_NE(value->trouble(), QString());
    EXPECT_EQ(model->value(), 0.001);
    QTest::keyClick(value, Qt::Key_Escape);
    slider->setFocus(Qt::TabFocusReason);
    test::turnWheel(slider, QPoint(20, y), -1);
    EXPECT_LT(model->value(), 0.001);
}

TEST_F(MethodsPageTest, AClickIntoTheStabilityChartSetsTheValue) {
    measure();
    PlotView* plot = find<PlotView>("stability_plot");
    QTest::mouseClick(plot, Qt::LeftButton, {}, plot->toPixel(0.5, 1e-9).toPoint());
    EXPECT_NEAR(std::log10(model->value()), std::log10(0.5), 0.03);
}

TEST_F(MethodsPageTest, ARowTellsWhereItsMethodFails) {
    measure();
    ResultTable* table = page.table();
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                      table->visualItemRect(table->item(0, 0)).center());
    EXPECT_EQ(model->shownMethod(), 0U);
    EXPECT_TRUE(find<QLabel>("limits")->text().contains(QStringLiteral("no convergence")));
    QTest::keyClick(table, Qt::Key_End, Qt::ControlModifier);
    EXPECT_EQ(model->shownMethod(), model->kernel().methods.size() - 1);
    EXPECT_TRUE(find<QLabel>("limits")->text().contains(QStringLiteral("near locking")));
}

TEST_F(MethodsPageTest, MeasuresAgainAndCancels) {
    measure();
    auto* progress = page.findChild<QProgressBar*>();
    EXPECT_FALSE(progress->isVisible());
    const MethodMeasurement* old = model->shown();
    const QPoint place = find<QPushButton>("measure_again")->pos();
    QTest::mouseClick(find<QPushButton>("measure_again"), Qt::LeftButton);
    EXPECT_TRUE(model->measuring()->isRunning());
    EXPECT_TRUE(progress->isVisible());
    EXPECT_EQ(find<QPushButton>("measure_again")->pos(), place);  // nothing moved
    EXPECT_TRUE(find<PlotView>("work_plot")->isFaded());
    EXPECT_GT(page.table()->rowCount(), 8);
    QTest::mouseClick(find<QPushButton>("cancel"), Qt::LeftButton);
    EXPECT_FALSE(model->measuring()->isRunning());
    EXPECT_FALSE(find<PlotView>("work_plot")->isFaded());
    QTest::qWait(200);
    EXPECT_EQ(model->shown(), old);
    QTest::mouseClick(find<QPushButton>("measure_again"), Qt::LeftButton);
    QSignalSpy progressed(model->measuring(), &BackgroundJob::progress);
    test::waitUntilMeasured(*model);
    EXPECT_GT(progressed.count(), 3);
}

/// Times and orders are for those who ask for them.
TEST_F(MethodsPageTest, NanosecondsAreBehindDetails) {
    measure();
    for (const bool shown : {false, true}) {
        EXPECT_NE(page.table()->isColumnHidden(2), shown);
        EXPECT_NE(page.table()->isColumnHidden(4), shown);
        EXPECT_EQ(find<QLabel>("words")->text().contains(QStringLiteral("One evaluation")), shown);
        // Copied is what is shown, its numbers as spreadsheets read them.
        page.table()->clearSelection();
        page.table()->setFocus();
        QTest::keyClick(page.table(), Qt::Key_C, Qt::ControlModifier);
        const QString copied = QApplication::clipboard()->text();
        EXPECT_EQ(copied, page.resultsAsText());
        EXPECT_EQ(copied.section(QLatin1Char('\n'), 0, 0).count(QLatin1Char('\t')), shown ? 4 : 2);
        EXPECT_FALSE(copied.contains(QRegularExpression(QStringLiteral("\\t−?[0-9.]*·?10[⁻⁰-⁹]"))));
        EXPECT_TRUE(
            copied.contains(QRegularExpression(QStringLiteral("\\t[0-9.]+e-[0-9]+[\\t\\n]"))))
            << copied.toStdString();
        QTest::mouseClick(find<QToolButton>("details"), Qt::LeftButton);
    }
}

TEST_F(MethodsPageTest, TheValidationReportIsATab) {
    measure();
    bring("validation");
    ValidationView* view = page.findChild<ValidationView*>();
    ASSERT_TRUE(test::comes([&] { return view->viewModel()->report() != nullptr; }));
    const auto& report = *view->viewModel()->report();
    const int all = static_cast<int>(report.rows.size());
    EXPECT_EQ(view->table()->rowCount(), all);
    const QString counts = find<QLabel>("counts")->text();
    EXPECT_TRUE(counts.contains(QString::number(all))) << counts.toStdString();
    EXPECT_TRUE(counts.contains(
        QStringLiteral("reproduced: %1").arg(report.count(methods::Verdict::reproduced))));

    choose("paper_filter", 2);
    EXPECT_LT(view->table()->rowCount(), all);
    for (const auto* row : view->viewModel()->rows()) {
        EXPECT_EQ(row->scene, "elastic-hinge");
    }
    EXPECT_TRUE(page.findChild<VerdictLine*>()->text().startsWith(QStringLiteral("OK: All ")));
    choose("verdict_filter", 3);
    for (const auto* row : view->viewModel()->rows()) {
        EXPECT_EQ(row->verdict, methods::Verdict::slip);
    }
    ASSERT_GT(view->table()->rowCount(), 0);
    QTest::mouseClick(view->table()->viewport(), Qt::LeftButton, {},
                      view->table()->visualItemRect(view->table()->item(0, 2)).center());
    EXPECT_EQ(find<QLabel>("reason")->text(),
              methodText(view->viewModel()->rows().front()->reason));
    QTest::mouseClick(find<QPushButton>("copy_csv"), Qt::LeftButton);
    const QString csv = QApplication::clipboard()->text();
    EXPECT_EQ(csv.count(QLatin1Char('\n')), 1 + view->table()->rowCount());
    EXPECT_EQ(page.resultsAsCsv(), csv);
    view->table()->setFocus();
    QTest::keyClick(view->table(), Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QApplication::clipboard()->text().count(QLatin1Char('\n')), 1);
}

/// The rows that the keys go to are in sight, and so are the headings and the reason.
TEST_F(MethodsPageTest, TheReportFollowsTheKeys) {
    bring("validation");
    ValidationView* view = page.findChild<ValidationView*>();
    ASSERT_TRUE(test::comes([&] { return view->viewModel()->report() != nullptr; }));
    QApplication::processEvents();
    ResultTable* table = view->table();
    table->setFocus();
    table->setCurrentCell(0, 0);
    const auto seen = [&](QWidget* part, const QRect& rect) {
        return part->visibleRegion().contains(rect.center());
    };
    for (const int down : {35, 1000, -20}) {
        for (int i = 0; i < std::min(std::abs(down), 40); ++i) {
            QTest::keyClick(table, down > 100 ? Qt::Key_PageDown
                                   : down > 0 ? Qt::Key_Down
                                              : Qt::Key_Up);
        }
        EXPECT_TRUE(seen(table->viewport(), table->visualItemRect(table->currentItem()))) << down;
        QWidget* headings = table->horizontalHeader()->viewport();
        EXPECT_TRUE(seen(headings, headings->rect())) << down;
        EXPECT_TRUE(seen(find<QLabel>("reason"), find<QLabel>("reason")->rect())) << down;
    }
    EXPECT_GT(table->currentRow(), 60);
    // Where the whole page scrolls, it follows a table that does not.
    table->setShownRows(0);
    QApplication::processEvents();
    QTest::keyClick(table, Qt::Key_Home, Qt::ControlModifier);
    QTest::keyClick(table, Qt::Key_End, Qt::ControlModifier);
    EXPECT_TRUE(seen(table->viewport(), table->visualItemRect(table->currentItem())));
}

TEST_F(MethodsPageTest, TheReportStopsTheMeasurement) {
    page.setActive(true);
    ASSERT_TRUE(test::comes([&] { return model->measuring()->isRunning(); }));
    bring("validation");
    EXPECT_FALSE(model->measuring()->isRunning());
    bring("charts");
    test::waitUntilMeasured(*model);
}

/// In the window: no case to save, the open case of the scene, the theme.
TEST(MethodsInTheWindow, HasNoCaseToSave) {
    MainWindow window;
    test::showAt(window, {1280, 800});
    const auto action = [&](const QKeySequence& keys) { return test::actionOfKeys(window, keys); };
    const QList<QKeySequence> needCase{QKeySequence(QKeySequence::New),
                                       QKeySequence(QKeySequence::Save)};
    for (const QKeySequence& keys : needCase) {
        EXPECT_TRUE(action(keys)->isEnabled());
    }
    const QString tip = action(needCase[1])->toolTip();
    ASSERT_TRUE(window.showScene(QStringLiteral("methods")));
    ASSERT_EQ(window.currentScene(), QStringLiteral("methods"));
    for (const QKeySequence& keys : needCase) {
        EXPECT_FALSE(action(keys)->isEnabled());
        EXPECT_TRUE(action(keys)->toolTip().contains(QStringLiteral("no case file")));
    }
    EXPECT_TRUE(action(QKeySequence(QKeySequence::Open))->isEnabled());
    EXPECT_FALSE(window.isWindowModified());
    QTest::keyClick(&window, Qt::Key_1, Qt::ControlModifier);
    EXPECT_TRUE(action(needCase[1])->isEnabled());
    EXPECT_EQ(action(needCase[1])->toolTip(), tip);
}

TEST(MethodsInTheWindow, BeginsWithTheCaseThatWasInFront) {
    MainWindow window;
    test::showAt(window, {1280, 800});
    ASSERT_TRUE(window.showScene(QStringLiteral("elastic-hinge")));
    window.currentPage()->model()->setByKey(QStringLiteral("lambda"), QStringLiteral("0.55"));
    ASSERT_TRUE(window.showScene(QStringLiteral("methods")));
    auto* page = static_cast<MethodsPage*>(window.currentPage());
    const CaseBudgetModel& budget = *page->budget();
    ASSERT_TRUE(test::comes([&] { return !budget.isRunning(); }));
    EXPECT_EQ(budget.open()->file.scene, "elastic-hinge");
    EXPECT_EQ(budget.open()->file.input.at("lambda"), 0.55);
    const auto* table = test::named<ResultTable>(*page, "case_table");
    EXPECT_EQ(table->rowCount(), budget.results().rows.size());
    EXPECT_GT(table->rowCount(), 4);
    EXPECT_EQ(page->resultsAsText(), table->asText());
    EXPECT_FALSE(page->viewModel()->measuring()->isRunning());
}

}  // namespace
}  // namespace ravnoves
