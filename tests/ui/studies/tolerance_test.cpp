// Tolerances of a case: typed, computed, undone and saved, through the window.

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QTableView>
#include <QTableWidget>
#include <QToolButton>

#include "balance-shaft/model/balance_shaft_model.h"
#include "case-file/case_file.h"
#include "case-file/json.h"
#include "events.h"
#include "plot/plot_view.h"
#include "shell/main_window.h"
#include "shell/scene_page.h"
#include "studies/model/study_model.h"
#include "studies/model/study_tables.h"
#include "studies/study_run.h"
#include "studies/tolerance_window.h"
#include "studies/tornado_view.h"
#include "widgets/result_table.h"
#include "widgets/table_editor.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class Tolerances : public ::testing::Test {
  protected:
    Tolerances() {
        test::showAt(window, {1280, 800});
        window.showScene(u"balance-shaft"_s);
        QTest::keyClick(&window, Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
        QApplication::processEvents();
        tolerances = window.findChild<ToleranceWindow*>();
        EXPECT_NE(tolerances, nullptr);
    }

    SceneModel& scene() { return *tolerances->model()->scene(); }
    const studies::Study& study() const { return tolerances->model()->study(); }
    /// Types a text into a cell, as a user does.
    static void type(TableEditor* editor, int row, int column, const QString& text) {
        QTableView* view = editor->view();
        // The editor before it is still to be deleted.
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        view->setFocus();
        view->setCurrentIndex(view->model()->index(row, column));
        QTest::keyClick(view, Qt::Key_F2);
        auto* field = view->findChild<QLineEdit*>();
        ASSERT_NE(field, nullptr);
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        QApplication::processEvents();
    }
    void scatter(const char* pointer, const QString& text) {
        const auto& inputs = tolerances->model()->inputs();
        const auto at =
            std::find_if(inputs.begin(), inputs.end(),
                         [&](const StudyModel::Input& each) { return each.pointer == pointer; });
        ASSERT_NE(at, inputs.end()) << pointer;
        type(tolerances->inputs(), static_cast<int>(at - inputs.begin()), ScatterTable::Scatter,
             text);
    }
    void watch(const char* pointer) {
        auto* box = test::named<QComboBox>(*tolerances, "watchable");
        const int place = box->findData(QLatin1String(pointer));
        ASSERT_GT(place, 0) << pointer;
        box->setCurrentIndex(place);
        Q_EMIT box->activated(place);
    }
    void waitForAnswer() {
        ASSERT_TRUE(QTest::qWaitFor(
            [&] {
                const StudyAnswers* answers = tolerances->model()->answers();
                return answers != nullptr && !tolerances->model()->isBusy();
            },
            60'000));
    }

    MainWindow window;
    ToleranceWindow* tolerances = nullptr;
};

TEST_F(Tolerances, WhatIsTypedIsComputedAndShown) {
    scatter("/crank_radius_mm", u"0.02"_s);
    scatter("/reciprocating_masses_kg/piston", u"1 %"_s);
    watch("/metrics/M_ups/range_Nm");
    ASSERT_EQ(study().vary.size(), 2U);
    ASSERT_EQ(study().watch.size(), 1U);
    waitForAnswer();
    const StudyAnswers& answers = *tolerances->model()->answers();
    ASSERT_EQ(answers.values.size(), 1U);
    const StudyAnswer& range = answers.values[0];
    EXPECT_EQ(answers.solved, study().samples);
    // So little scatter is linear; the mean stays where the nominal is.
    EXPECT_NEAR(*range.deviation, *range.linearDeviation, 0.03 * *range.deviation);
    EXPECT_NEAR(*range.mean, *range.nominal, 0.2 * *range.deviation);
    EXPECT_LT(*range.low, *range.nominal);
    EXPECT_GT(*range.high, *range.nominal);
    double whole = 0.0;
    for (const TornadoView::Bar& bar : tolerances->tornado()->bars()) {
        whole += bar.alone;
    }
    EXPECT_NEAR(whole, 1.0, 0.05);
    double heights = 0.0;
    for (const double height : tolerances->histogram()->data().curves[0].y) {
        heights += height;
    }
    EXPECT_NEAR(heights, 100.0, 0.5);  // all but what lies beyond the 0.1 % and 99.9 % points
    EXPECT_EQ(tolerances->table()->rowCount(), 1);
}

TEST_F(Tolerances, ResultsAreNamedWithTheUnitsOfTheirKeys) {
    EXPECT_EQ(StudyModel::resultName("/metrics/M_ups/range_Nm"), u"metrics, M_ups, range, N·m"_s);
    EXPECT_EQ(StudyModel::resultName("/guide/minimum_stiffness_N_m"),
              u"guide, minimum stiffness, N/m"_s);
    EXPECT_EQ(StudyModel::resultName("/bobweight_g"), u"bobweight, g"_s);
}

TEST_F(Tolerances, AreStepsOfTheHistoryAndStayInTheCase) {
    scatter("/crank_radius_mm", u"s 0.01"_s);
    watch("/metrics/M_ups/range_Nm");
    type(tolerances->watched(), 0, WatchTable::Most, u"1100"_s);
    EXPECT_EQ(study().watch.at(0).max, 1100.0);
    const CaseFile file = scene().caseFile();
    EXPECT_EQ(studies::read_study(file.study), study());
    EXPECT_TRUE(scene().hasChanges());
    scene().undo();
    EXPECT_FALSE(study().watch.at(0).max);
    scene().undo();
    scene().undo();
    EXPECT_TRUE(study().vary.empty());
    EXPECT_TRUE(scene().caseFile().study.is_null());
    scene().redo();
    ASSERT_EQ(study().vary.size(), 1U);
    EXPECT_EQ(study().vary[0].spread, studies::Varied::Spread::normal);
    scene().loadFile(file, scene().context(), false);
    EXPECT_EQ(study().watch.at(0).max, 1100.0);
}

TEST_F(Tolerances, AStudyThatIsRefusedStaysUntilItIsCleared) {
    CaseFile file = scene().caseFile();
    file.study = {{"vary", {{"/crank_radius_mm", {{"plus", 1}}}}}, {"watch", Json::object()}};
    scene().loadFile(file, scene().context(), false);
    EXPECT_FALSE(tolerances->model()->trouble().isEmpty());
    scatter("/crank_radius_mm", u"0.5"_s);
    watch("/metrics/M_ups/range_Nm");
    EXPECT_EQ(scene().caseFile().study, file.study);
    tolerances->model()->clear();
    EXPECT_TRUE(scene().caseFile().study.is_null());
    scatter("/crank_radius_mm", u"0.5"_s);
    EXPECT_EQ(study().vary.size(), 1U);
    scene().undo();
    scene().undo();
    EXPECT_EQ(scene().caseFile().study, file.study);
}

TEST_F(Tolerances, TheCommandLineFindsTheSame) {
    scatter("/crank_radius_mm", u"0.02"_s);
    watch("/optimum/range/range_Nm");
    waitForAnswer();
    const studies::Problem problem = studies::problem_of(scene().caseFile(), scene().context());
    studies::Part part = studies::begin_part(problem);
    studies::run_part(problem, part);
    const Json found = studies::write_results(part)["watched"]["/optimum/range/range_Nm"];
    const StudyAnswer& shown = tolerances->model()->answers()->values.at(0);
    EXPECT_EQ(*shown.mean, found["mean"].get<double>());
    EXPECT_EQ(*shown.deviation, found["standard_deviation"].get<double>());
    EXPECT_EQ(*shown.high, found["percentiles"]["95"].get<double>());
}

TEST_F(Tolerances, WhatIsNoToleranceIsRefusedInWords) {
    QSignalSpy trouble(qobject_cast<EditableTable*>(tolerances->inputs()->view()->model()),
                       &EditableTable::troubleChanged);
    scatter("/crank_radius_mm", u"abc"_s);
    ASSERT_GE(trouble.count(), 1);
    EXPECT_TRUE(trouble.last().at(0).toString().contains(u"abc"_s));
    EXPECT_TRUE(study().vary.empty());
    scatter("/crank_radius_mm", u"-1"_s);
    EXPECT_TRUE(study().vary.empty());
    scatter("/crank_radius_mm", u"0.02"_s);
    EXPECT_EQ(study().vary.size(), 1U);
    EXPECT_TRUE(trouble.last().at(0).toString().isEmpty());
}

TEST_F(Tolerances, WhatCannotBeSolvedIsCounted) {
    // Some cranks would have no length at all.
    scatter("/crank_radius_mm", u"s 40"_s);
    watch("/metrics/M_ups/range_Nm");
    waitForAnswer();
    const StudyAnswers& answers = *tolerances->model()->answers();
    std::uint64_t refused = 0;
    for (const auto& [reason, count] : answers.refused) {
        EXPECT_FALSE(reason.isEmpty());
        refused += count;
    }
    EXPECT_GT(refused, 0U);
    EXPECT_EQ(answers.solved + refused, study().samples);
}

}  // namespace
}  // namespace ravnoves
