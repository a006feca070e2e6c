// Tolerances of a case: typed, computed, undone and saved, through the window.

#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QToolButton>
#include <numeric>

#include "balance-shaft/model/balance_shaft_model.h"
#include "case-file/case_file.h"
#include "case-file/json.h"
#include "events.h"
#include "page/rejected_entries.h"
#include "page/scene_page.h"
#include "paper/paper.h"
#include "plot/plot_view.h"
#include "report/patience.h"
#include "report/sections.h"
#include "scene_tests.h"
#include "scenes/open_example.h"
#include "shell/main_window.h"
#include "studies/model/study_answers.h"
#include "studies/model/study_figures.h"
#include "studies/model/study_model.h"
#include "studies/model/study_tables.h"
#include "studies/model/sweep_model.h"
#include "studies/study_run.h"
#include "studies/sweep_view.h"
#include "studies/tolerance_window.h"
#include "text/number_text.h"
#include "text/preferences.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/page_columns.h"
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

    template <typename View>
    View* the() const {
        return tolerances->findChild<View*>();
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
        QTest::keyClick(field, Qt::Key_Delete);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        QApplication::processEvents();
    }
    void scatter(const char* pointer, const QString& text) {
        const StudyModel::Input* input = tolerances->model()->input(pointer);
        ASSERT_NE(input, nullptr) << pointer;
        type(tolerances->inputs(), static_cast<int>(input - &tolerances->model()->inputs()[0]),
             ScatterTable::Scatter, text);
    }
    void watch(const char* pointer) {
        const QList<QAction*> results = watchable();
        const QString name = tolerances->model()->resultName(pointer).withUnit();
        const auto found =
            std::ranges::find_if(results, [&](auto* each) { return each->text() == name; });
        ASSERT_TRUE(found != results.end()) << pointer;
        (*found)->trigger();
    }
    /// What the menu offers when it is opened.
    QList<QAction*> watchable() const {
        QMenu* menu = test::named<QPushButton>(*tolerances, "watchable")->menu();
        Q_EMIT menu->aboutToShow();
        return menu->actions();
    }
    void waitForAnswer() {
        ASSERT_TRUE(test::comes([&] {
            const StudyAnswers* answers = tolerances->model()->answers();
            return answers != nullptr && !tolerances->model()->isBusy();
        }));
    }

    /// Brings the sweep to the front. @param input  that is chosen; empty: as it is
    SweepModel& sweep(const QString& input = {}) {
        showTabOf(the<SweepView>());
        if (!input.isEmpty()) {
            auto* inputs = test::named<QComboBox>(*tolerances, "sweep_input");
            inputs->setCurrentIndex(inputs->findData(input));
            Q_EMIT inputs->activated(inputs->currentIndex());
        }
        return *the<SweepView>()->model();
    }
    static const Sweep& done(const SweepModel& model) {
        EXPECT_TRUE(test::comes([&] { return model.sweep() != nullptr && !model.isStale(); }));
        return *model.sweep();
    }
    /// The section of a report.
    Paper section() {
        Paper report;
        addTolerances(report, scene(), Patience());
        return report;
    }
    /// What it says of the first watched value.
    Json ofTheCommandLine() const {
        const SceneModel& scene = *tolerances->model()->scene();
        const studies::Problem problem = studies::problem_of(scene.caseFile(), scene.context());
        const studies::Part part = *studies::run_study(problem);
        return studies::write_results(part)["watched"][problem.study.watch.at(0).pointer];
    }
    static void expectSame(const StudyAnswer& shown, const Json& found) {
        EXPECT_EQ(*shown.mean, found["mean"].get<double>());
        EXPECT_EQ(*shown.deviation, found["standard_deviation"].get<double>());
        EXPECT_EQ(*shown.low, found["percentiles"]["5"].get<double>());
        EXPECT_EQ(*shown.high, found["percentiles"]["95"].get<double>());
        EXPECT_EQ(*shown.linearDeviation, found["linear"]["standard_deviation"].get<double>());
    }

    MainWindow window;
    ToleranceWindow* tolerances = nullptr;
};

/// Before the window is made, and until it is gone.
struct OtherUnits {
    OtherUnits() {
        for (const auto quantity : {Preferences::Length, Preferences::Torque}) {
            Preferences::instance().setUnits(quantity, Preferences::Units::Imperial);
        }
        Preferences::instance().setUnits(Preferences::Mass, Preferences::Units::Gram);
    }
    ~OtherUnits() {
        QSettings().clear();
        Preferences::instance().load();
    }
};

class TolerancesInOtherUnits : OtherUnits, public Tolerances {};

TEST_F(TolerancesInOtherUnits, AreTypedAndShownInThese) {
    const double perNm = shownUnit(units::N_m).factor;
    scatter("/reciprocating_masses_kg/piston", u"0.5"_s);
    scatter("/centre_distance_mm", u"0.05"_s);
    ASSERT_EQ(study().vary.size(), 2U);
    EXPECT_EQ(study().vary[0].size, 0.0005);
    EXPECT_EQ(study().vary[1].size, 1.27);
    // Tiny ones are written out, and the column has room for them.
    scatter("/centre_distance_mm", u"0.0000123456"_s);
    const QString tiny =
        StudyModel::scatterText(*tolerances->model()->input("/centre_distance_mm"));
    EXPECT_EQ(tiny, u"0.0000123456"_s);
    const QTableView* inputs = tolerances->inputs()->view();
    EXPECT_TRUE(test::comes([&] {
        return inputs->columnWidth(ScatterTable::Scatter) >
               QFontMetrics(inputs->font()).horizontalAdvance(tiny);
    }));
    // A unit may be typed with them, as with limits.
    scatter("/centre_distance_mm", u"s 0.254 mm"_s);
    EXPECT_EQ(study().vary[1].size, 0.254);
    scatter("/centre_distance_mm", u"1 kg"_s);
    EXPECT_TRUE(tolerances->inputs()->trouble().contains(u"kg"_s));
    EXPECT_EQ(study().vary[1].size, 0.254) << "no length";
    scatter("/centre_distance_mm", u"0.05"_s);
    watch("/moment_amplitude_Nm");
    const auto limit = [&] {
        return tolerances->watched()
            ->view()
            ->model()
            ->index(0, WatchTable::Maximum)
            .data()
            .toString();
    };
    type(tolerances->watched(), 0, WatchTable::Maximum, u"1234.5678"_s);
    EXPECT_NEAR(study().watch[0].max.value(), 1234.5678 / perNm, 1e-6);
    const auto stored = study().watch[0].max;
    type(tolerances->watched(), 0, WatchTable::Maximum, limit());
    EXPECT_EQ(study().watch[0].max, stored) << "what is shown stands for all its digits";
    type(tolerances->watched(), 0, WatchTable::Maximum, u"600 Nm"_s);
    EXPECT_NEAR(study().watch[0].max.value(), 600.0, 1e-6);
    EXPECT_EQ(limit(), QLocale().toString(600.0 * perNm, 'g', 6));
    type(tolerances->watched(), 0, WatchTable::Maximum, u"6 kg"_s);
    EXPECT_NEAR(study().watch[0].max.value(), 600.0, 1e-6) << "no torque";
    tolerances->watched()->takeBackRejected();
    waitForAnswer();
    const double nominal = *tolerances->model()->answers()->values.at(0).nominal * perNm;
    const auto* table = the<ResultTable>();
    EXPECT_TRUE(table->item(0, 0)->text().endsWith(u"lb·ft"_s));
    const StudyAnswer& value = tolerances->model()->answers()->values.at(0);
    EXPECT_EQ(table->item(0, 1)->text(), value.text(value.nominal, perNm));
    EXPECT_NEAR(QLocale().toDouble(table->item(0, 1)->text()), nominal, 0.1 * *value.deviation);
    EXPECT_TRUE(the<PlotView>()->title().endsWith(u"lb·ft"_s));
    EXPECT_EQ(the<PlotView>()->data().x.spec.title, u"lb·ft"_s);

    const double piston = scene().inputJson()["reciprocating_masses_kg"]["piston"].get<double>();
    done(sweep());
    const plot::Mark& mark = the<SweepView>()->plot()->data().marks.at(0);
    EXPECT_EQ(mark.text, QLocale().toString(nominal, 'g', 5));
    EXPECT_NEAR(mark.x, 1000.0 * piston, 1e-9);

    static const QRegularExpression tags(u"(<[^>]*>\\n?)+"_s);
    const QString body = section().body;
    const qsizetype row = body.lastIndexOf(u"<tr>"_s, body.indexOf(u"Samples solved"_s));
    const QStringList found = body.mid(row).split(tags, Qt::SkipEmptyParts);
    ASSERT_GE(found.size(), 8);
    EXPECT_EQ(found[0], table->item(0, 0)->text());
    EXPECT_EQ(found[1], table->item(0, 1)->text());
    EXPECT_TRUE(found[7].contains(limit())) << found[7].toStdString();
}

TEST_F(Tolerances, NoShareIsGivenToWhatHasNoEffect) {
    auto& model = dynamic_cast<BalanceShaftModel&>(scene());
    model.setTorqueKind(balance_shaft::TorqueSource::Kind::cycle);
    scatter("/reciprocating_masses_kg/piston", u"1 %"_s);
    scatter("/centre_distance_mm", u"1"_s);
    watch("/metrics/M_up/range_Nm");  // without shaft
    waitForAnswer();
    for (const StudyAnswer::Share& share : tolerances->model()->answers()->values[0].shares) {
        EXPECT_EQ(share.alone > 0.0, share.pointer != "/centre_distance_mm") << share.pointer;
    }
}

TEST_F(Tolerances, ResultsAreNamedWithTheUnitsOfTheirKeys) {
    const auto name = [](const char* scene, const char* pointer) {
        return StudyModel(test::makePage(scene)->model()).resultName(pointer).withUnit();
    };
    EXPECT_EQ(name("balance-shaft", "/metrics/M_ups/range_Nm"), u"Mᵤₚₛ, range, N·m"_s);
    EXPECT_EQ(name("inertia-moments", "/exact/order_2/moment_Nm/forward/amplitude"),
              u"Exact, order 2, moment, forward part, amplitude, N·m"_s);
    EXPECT_EQ(name("elastic-hinge", "/guide/minimum_stiffness_N_m"),
              u"Crank guide, Minimum stiffness, kN/m"_s);
    // What only another case has is named from then on.
    const auto shop = test::makePage("workshop");
    const StudyModel study(shop->model());
    EXPECT_FALSE(study.resultName("/bobweight_g").text.contains(u' '));
    test::openExample(*shop->model());
    EXPECT_TRUE(study.resultName("/bobweight_g").text.contains(u' '));
}

TEST_F(Tolerances, AreStepsOfTheHistoryAndStayInTheCase) {
    scatter("/crank_radius_mm", u"s 0.01"_s);
    watch("/metrics/M_ups/range_Nm");
    type(tolerances->watched(), 0, WatchTable::Maximum, u"1100"_s);
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
    scene().loadFile(file, scene().context());
    EXPECT_EQ(study().watch.at(0).max, 1100.0);
}

TEST_F(Tolerances, AStudyThatIsRejectedStaysUntilItIsCleared) {
    CaseFile file = scene().caseFile();
    file.study = {{"vary", {{"/crank_radius_mm", {{"plus", 1}}}}}, {"watch", Json::object()}};
    scene().loadFile(file, scene().context());
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
    scatter("/crank_radius_mm", u"0.5"_s);
    watch("/metrics/M_ups/range_Nm");
    waitForAnswer();
    const StudyModel& model = *tolerances->model();
    ASSERT_FALSE(model.answers()->values.at(0).within);
    const double limit = *model.answers()->values.at(0).mean;
    QAbstractItemModel* table = tolerances->watched()->view()->model();
    ASSERT_TRUE(table->setData(table->index(0, WatchTable::Maximum), formNumber(limit, QLocale())));
    waitForAnswer();
    const Json found = ofTheCommandLine();
    const StudyAnswer& shown = model.answers()->values.at(0);
    expectSame(shown, found);
    EXPECT_EQ(*shown.within, found["within"]["share"].get<double>());
    EXPECT_EQ(*shown.withinLow, found["within"]["low"].get<double>());
    EXPECT_EQ(*shown.withinHigh, found["within"]["high"].get<double>());
    EXPECT_GT(*shown.within, 0.3);
    EXPECT_LT(*shown.within, 0.7);
    EXPECT_EQ(the<PlotView>()->data().lines.size(), 2U);
    const std::vector<double>& heights = the<PlotView>()->data().curves[0].y;
    EXPECT_NEAR(std::accumulate(heights.begin(), heights.end(), 0.0), 100.0, 1e-9);
    scene().undo();
    waitForAnswer();
    EXPECT_FALSE(model.answers()->values.at(0).within);
}

TEST_F(Tolerances, TheCommandLineFindsTheSameOfEachSourceOfTheTorque) {
    using Kind = balance_shaft::TorqueSource::Kind;
    scatter("/crank_radius_mm", u"0.5"_s);
    scatter("/shaft_angle_deg", u"1"_s);
    watch("/metrics/M_ups/range_Nm");
    auto& model = dynamic_cast<BalanceShaftModel&>(scene());
    std::vector<double> deviations;
    for (const Kind kind : {Kind::table, Kind::cycle, Kind::table}) {
        model.setTorqueKind(kind);
        waitForAnswer();
        const StudyAnswer& shown = tolerances->model()->answers()->values.at(0);
        expectSame(shown, ofTheCommandLine());
        deviations.push_back(*shown.deviation);
    }
    EXPECT_NE(deviations[0], deviations[1]);
    EXPECT_EQ(deviations[0], deviations[2]);
}

TEST_F(Tolerances, WhereTheLinearAnswerFailsItIsMarked) {
    scatter("/shaft_angle_deg", u"40"_s);
    watch("/metrics/M_ups/range_Nm");
    waitForAnswer();
    const StudyAnswer& answer = tolerances->model()->answers()->values.at(0);
    ASSERT_TRUE(answer.fails);
    const QTableWidgetItem* linear = the<ResultTable>()->item(0, 4);
    EXPECT_TRUE(linear->text().endsWith(u"⚠"_s));
    EXPECT_EQ(linear->toolTip(), tolerances->model()->named(*answer.fails));
    EXPECT_FALSE(linear->toolTip().contains(u"/shaft_angle_deg"_s));  // by its name
}

TEST_F(Tolerances, WhatIsNoToleranceIsRejectedInWords) {
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
    // Every one that is rejected is named, and the answer says that it is without them.
    watch("/metrics/M_ups/range_Nm");
    waitForAnswer();
    const auto ink = [&] { return the<ResultTable>()->palette().color(QPalette::Text); };
    EXPECT_EQ(ink(), Theme::instance().text());
    scatter("/crank_radius_mm", u"abc"_s);
    scatter("/centre_distance_mm", u"xyz"_s);
    EXPECT_TRUE(trouble.last().at(0).toString().contains(u"abc"_s));
    EXPECT_TRUE(trouble.last().at(0).toString().contains(u"xyz"_s));
    EXPECT_EQ(ink(), Theme::instance().warning());
    EXPECT_EQ(trouble.last().at(0).toString().count(u'\n'), 1);
    scatter("/crank_radius_mm", u"abc"_s);
    scatter("/centre_distance_mm", u"0.1"_s);
    EXPECT_TRUE(trouble.last().at(0).toString().contains(u"abc"_s));
    scatter("/crank_radius_mm", u"0.02"_s);
    waitForAnswer();
    EXPECT_EQ(ink(), Theme::instance().text());
}

TEST_F(Tolerances, EscapeAndUndoEndWhatIsRejectedAndLeaveTheWindow) {
    QTableView* view = tolerances->inputs()->view();
    const auto* rejected = static_cast<const ScatterTable*>(view->model());
    scatter("/crank_radius_mm", u"abc"_s);
    ASSERT_EQ(rejected->rejectedNames().size(), 1);
    QTest::keyClick(view, Qt::Key_Escape);
    EXPECT_TRUE(rejected->rejectedNames().isEmpty());
    EXPECT_TRUE(tolerances->isVisible());
    scatter("/crank_radius_mm", u"0.02"_s);
    scatter("/centre_distance_mm", u"xyz"_s);
    ASSERT_EQ(rejected->rejectedNames().size(), 1);
    scene().undo();  // by the menu of the window
    EXPECT_TRUE(rejected->rejectedNames().isEmpty());
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QTest::keyClick(view, Qt::Key_F2);
    auto* typing = view->findChild<QLineEdit*>();
    ASSERT_NE(typing, nullptr);
    QTest::keyClicks(typing, u"7"_s);
    QTest::keyClick(typing, Qt::Key_Escape);
    EXPECT_TRUE(tolerances->isVisible());
    EXPECT_EQ(study().vary.size(), 1U);
}

TEST_F(Tolerances, ClosingAsksWhereAnEntryWasRejected) {
    QString said;
    const auto answer = [&](const QString& button) {
        test::answerWith(tolerances, button, [&](const QString& text) { said = text; });
    };
    QTableView* view = tolerances->inputs()->view();
    scatter("/centre_distance_mm", u"xyz"_s);
    const QModelIndex red = view->currentIndex();
    view->setCurrentIndex(view->model()->index(0, 0));
    answer(u"Stay"_s);
    QTest::keyClick(view, Qt::Key_Escape);
    EXPECT_TRUE(said.contains(u"not accepted"_s)) << said.toStdString();
    EXPECT_TRUE(said.contains(u"“xyz” is not a tolerance"_s)) << said.toStdString();
    EXPECT_TRUE(tolerances->isVisible());
    EXPECT_EQ(view->currentIndex(), red);
    answer(u"Continue without them"_s);
    tolerances->close();
    EXPECT_FALSE(tolerances->isVisible());
}

TEST_F(Tolerances, EscapeClosesTheWindowFromATableToo) {
    QTest::keyClick(the<ResultTable>(), Qt::Key_Escape);
    EXPECT_FALSE(tolerances->isVisible());
}

TEST_F(Tolerances, WhatIsNoLimitStaysAndIsRejectedInWords) {
    watch("/metrics/M_ups/range_Nm");
    const QAbstractItemModel* table = tolerances->watched()->view()->model();
    const auto text = [&](int column) { return table->index(0, column).data().toString(); };
    const auto isRed = [&](int column) {
        return table->index(0, column).data(EditableTable::TroubleRole).toBool();
    };
    type(tolerances->watched(), 0, WatchTable::Minimum, u"abc"_s);
    EXPECT_EQ(text(WatchTable::Minimum), u"abc"_s);
    EXPECT_TRUE(isRed(WatchTable::Minimum));
    type(tolerances->watched(), 0, WatchTable::Maximum, u"100"_s);
    EXPECT_TRUE(isRed(WatchTable::Minimum)) << "still no number";
    type(tolerances->watched(), 0, WatchTable::Minimum, u"200"_s);
    EXPECT_TRUE(isRed(WatchTable::Minimum)) << "above the upper limit";
    EXPECT_FALSE(study().watch[0].min);
    type(tolerances->watched(), 0, WatchTable::Maximum, u"300"_s);
    EXPECT_FALSE(isRed(WatchTable::Minimum));
    EXPECT_EQ(study().watch[0].min, 200.0);
    EXPECT_EQ(study().watch[0].max, 300.0);
}

TEST_F(Tolerances, WhatIsTypedAfterAResultIsPickedIsItsLimit) {
    watch("/metrics/M_ups/range_Nm");
    watchable().at(1)->trigger();  // the leading result is watched already
    ASSERT_EQ(study().watch.size(), 2U);
    EXPECT_EQ(tolerances->focusWidget(), tolerances->watched()->view());
    const QModelIndex at = tolerances->watched()->view()->currentIndex();
    ASSERT_TRUE(at.isValid());
    EXPECT_EQ(at.column(), WatchTable::Minimum);
    EXPECT_NE(study().watch[static_cast<std::size_t>(at.row())].pointer, "/metrics/M_ups/range_Nm");
}

TEST_F(Tolerances, WhatHasTwoMeaningsIsAskedFor) {
    scatter("/centre_distance_mm", u"1,000"_s);
    EXPECT_TRUE(tolerances->inputs()->trouble().contains(u"may be 1000 or 1:"_s));
    EXPECT_TRUE(study().vary.empty());
    watch("/metrics/M_ups/range_Nm");
    type(tolerances->watched(), 0, WatchTable::Maximum, u"1,100"_s);
    EXPECT_FALSE(study().watch[0].max);
    type(tolerances->watched(), 0, WatchTable::Maximum, u"1,1"_s);
    EXPECT_EQ(study().watch[0].max, 1.1);
    // Limits of an angle across 0° are written a turn on.
    watch("/optimum/range/shaft_angle_deg");
    type(tolerances->watched(), 1, WatchTable::Minimum, u"355"_s);
    type(tolerances->watched(), 1, WatchTable::Maximum, u"3"_s);
    const QString why = tolerances->watched()->trouble();
    EXPECT_TRUE(why.contains(u"enter 363 instead of 3"_s)) << why.toStdString();
    type(tolerances->watched(), 1, WatchTable::Maximum, u"363"_s);
    EXPECT_EQ(tolerances->watched()->trouble(), QString());
}

TEST_F(Tolerances, AreTypedInTheUnitOfTheField) {
    const auto speed = [&]() -> const StudyModel::Input& {
        return *tolerances->model()->input("/angular_speed_rad_s");
    };
    CaseFile file = scene().caseFile();
    file.input.erase("speed_rpm");
    file.input["angular_speed_rad_s"] = 120.0 * pi;
    scene().loadFile(file, scene().context());
    const auto row = static_cast<int>(&speed() - &tolerances->model()->inputs()[0]);
    EXPECT_EQ(tolerances->inputs()->table()->index(row, ScatterTable::Nominal).data(),
              u"3600\u00A0min⁻¹"_s);
    scatter("/angular_speed_rad_s", u"30"_s);
    ASSERT_EQ(study().vary.size(), 1U);
    EXPECT_NEAR(study().vary[0].size, pi, 1e-9);
    EXPECT_EQ(StudyModel::scatterText(speed()), u"30"_s);
}

TEST_F(Tolerances, ABlockIsPastedWholeAndAsOneStep) {
    QTableView* view = tolerances->inputs()->view();
    const auto paste = [&](const QString& text) {
        view->setCurrentIndex(view->model()->index(0, ScatterTable::Scatter));
        QGuiApplication::clipboard()->setText(text);
        QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    };
    const auto said = [&] { return tolerances->inputs()->findChild<TroubleLine*>()->text(); };
    paste(u"0.5\nabc\nx\n"_s);
    EXPECT_TRUE(study().vary.empty());
    EXPECT_TRUE(said().contains(u"“abc”"_s) && said().contains(u"“x”"_s)) << qPrintable(said());
    paste(u"1\n"_s.repeated(view->model()->rowCount() + 1));
    EXPECT_TRUE(study().vary.empty()) << "nothing is dropped without a word";
    paste(u"0.5\n1 %\n"_s);
    EXPECT_EQ(study().vary.size(), 2U);
    EXPECT_EQ(said(), QString());
    const int step = scene().history()->index();
    tolerances->inputs()->table()->removeRowRange(0, 2);
    EXPECT_TRUE(study().vary.empty());
    EXPECT_EQ(scene().history()->index(), step + 1);
    scene().undo();
    QTest::keyClick(view, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(study().vary.empty());
    // Whole rows, copied and pasted where they were, stay what they are; their values are none of
    // ±.
    view->selectAll();
    tolerances->inputs()->copy();
    view->setCurrentIndex(view->model()->index(0, ScatterTable::Scatter));
    QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    EXPECT_TRUE(study().vary.empty());
    EXPECT_EQ(said(), QString());
    // What stood there in red gives way.
    scatter("/crank_radius_mm", u"abc"_s);
    const int row = view->currentIndex().row();
    QGuiApplication::clipboard()->setText(u"0.5\n"_s);
    view->setCurrentIndex(view->model()->index(row, ScatterTable::Scatter));
    QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(tolerances->inputs()->trouble(), QString());
}

TEST_F(Tolerances, LimitsAreWrittenAndClearedAsOneStep) {
    watch("/metrics/M_ups/range_Nm");
    watch("/moment_amplitude_Nm");
    QTableView* view = tolerances->watched()->view();
    const auto* history = scene().history();
    int step = history->index();
    type(tolerances->watched(), 0, WatchTable::Minimum, u"abc"_s);
    view->setCurrentIndex(view->model()->index(0, WatchTable::Minimum));
    QGuiApplication::clipboard()->setText(u"1\t2\n3\t4\n"_s);
    QTest::keyClick(view, Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(study().watch[1].max, 4.0);
    EXPECT_EQ(history->index(), ++step);
    EXPECT_EQ(tolerances->watched()->trouble(), QString()) << "the block stands in its place";
    view->selectionModel()->select({view->model()->index(0, WatchTable::Minimum),
                                    view->model()->index(1, WatchTable::Maximum)},
                                   QItemSelectionModel::ClearAndSelect);
    QTest::keyClick(view, Qt::Key_Delete);
    EXPECT_FALSE(study().watch[0].min || study().watch[1].max);
    EXPECT_EQ(history->index(), ++step);
    tolerances->activateWindow();
    QTest::keyClick(view, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(study().watch[1].max, 4.0);
    QTest::keyClick(view, Qt::Key_Y, Qt::ControlModifier);
    EXPECT_FALSE(study().watch[1].max);
    // A limit that lets one stand that was rejected before.
    type(tolerances->watched(), 0, WatchTable::Maximum, u"2"_s);
    type(tolerances->watched(), 0, WatchTable::Minimum, u"5"_s);
    step = history->index();
    type(tolerances->watched(), 0, WatchTable::Maximum, u"6"_s);
    EXPECT_EQ(study().watch[0].min, 5.0);
    EXPECT_EQ(history->index(), step + 1);
    tolerances->watched()->table()->removeRowRange(0, 2);
    EXPECT_TRUE(study().watch.empty());
    EXPECT_EQ(history->index(), step + 2);
    scene().undo();
    view->setCurrentIndex(view->model()->index(0, WatchTable::Name));
    QTest::keyClick(view, Qt::Key_Delete);
    EXPECT_EQ(study().watch.size(), 1U);
}

TEST_F(Tolerances, WhatCannotBeSolvedIsCountedByReasonsInWords) {
    // Some cranks would have no length at all, some rings no mass.
    scatter("/crank_radius_mm", u"s 40"_s);
    scatter("/reciprocating_masses_kg/rings", u"s 0.5"_s);
    watch("/metrics/M_ups/range_Nm");
    waitForAnswer();
    std::uint64_t rejected = 0;
    for (const studies::Rejection& each : tolerances->model()->answers()->rejected) {
        const QString reason = tolerances->model()->named(each.reason);
        EXPECT_FALSE(reason.contains(u'/')) << reason.toStdString();
        EXPECT_TRUE(reason.contains(u':')) << reason.toStdString();
        rejected += each.count;
    }
    EXPECT_GT(rejected, 0U);
    EXPECT_EQ(tolerances->model()->answers()->solved + rejected, study().samples);
    for (const auto& [severity, note] : notesOf(*tolerances->model()).lines) {
        EXPECT_FALSE(note.contains(u"/input"_s)) << note.toStdString();
    }
}

TEST_F(Tolerances, AGridIsOfTheCommandLine) {
    scatter("/crank_radius_mm", u"0.5"_s);
    watch("/metrics/M_ups/range_Nm");
    CaseFile file = scene().caseFile();
    for (const Json& vary :
         {file.study["vary"], Json{{"/crank_radius_mm", {{"values", {40, 44}}}}}}) {
        file.study["method"] = "grid";
        file.study["vary"] = vary;
        scene().loadFile(file, scene().context());
        EXPECT_FALSE(tolerances->model()->trouble().isEmpty());
        tolerances->model()->setMethod(studies::Method::monte_carlo);
        EXPECT_EQ(scene().caseFile().study, file.study) << "it is not understood";
        tolerances->model()->clear();
        EXPECT_TRUE(tolerances->model()->trouble().isEmpty());
    }
}

TEST_F(Tolerances, FollowADraggedAngle) {
    scatter("/centre_distance_mm", u"1"_s);
    watch("/metrics/M_ups/range_Nm");
    waitForAnswer();
    auto& model = dynamic_cast<BalanceShaftModel&>(scene());
    for (const double angle : {100.0, 110.0, 115.6}) {
        model.setShaftAngleDeg(angle);
        EXPECT_TRUE(tolerances->model()->isStale());
    }
    EXPECT_TRUE(the<PlotView>()->isFaded());
    waitForAnswer();
    EXPECT_FALSE(tolerances->model()->isStale());
    EXPECT_FALSE(the<PlotView>()->isFaded());
    EXPECT_EQ(*tolerances->model()->answers()->values.at(0).nominal,
              scene().resultJson()["metrics"]["M_ups"]["range_Nm"].get<double>());
    EXPECT_NEAR(tolerances->model()->input("/shaft_angle_deg")->value, 115.6, 1e-9);
}

TEST_F(Tolerances, AnInputIsSweptWhileTheOthersScatter) {
    scatter("/centre_distance_mm", u"1"_s);
    scatter("/reciprocating_masses_kg/piston", u"1 %"_s);
    watch("/moment_amplitude_Nm");
    EXPECT_EQ(sweep().input(), "/reciprocating_masses_kg/piston");  // what scatters, at once
    SweepModel& model = sweep(u"/centre_distance_mm"_s);
    done(model);
    const Json input = scene().inputJson();
    const double distance = input["centre_distance_mm"].get<double>();
    const auto& places = model.sweep()->places;
    EXPECT_NEAR(places.front().x, distance - 1.0, 1e-9);
    EXPECT_NEAR(places.back().x, distance + 1.0, 1e-9);
    // P₁ l goes with l and with the masses: a percent of the piston, uniform.
    double mass = 0.0;
    for (const auto& each : input["reciprocating_masses_kg"]) {
        mass += each.get<double>();
    }
    const double part = 0.009 * input["reciprocating_masses_kg"]["piston"].get<double>() / mass;
    for (const Sweep::Place& place : places) {
        ASSERT_NEAR(place.mean / place.x, places.front().mean / places.front().x, 1e-9);
        ASSERT_NEAR(place.low / place.mean, 1.0 - part, 0.05 * part);
        ASSERT_NEAR(place.high / place.mean, 1.0 + part, 0.05 * part);
    }
    const PlotCurve& mean = the<SweepView>()->plot()->data().curves[0];
    ASSERT_TRUE(mean.hasSpread());
    EXPECT_EQ(mean.y.back(), places.back().mean);
    EXPECT_EQ(mean.above.back(), places.back().high - places.back().mean);
    // The result of the row that is selected is swept.
    watch("/metrics/M_up/min_Nm");
    ASSERT_TRUE(test::comes([&] { return the<ResultTable>()->rowCount() == 2; }));
    the<ResultTable>()->setCurrentCell(1, 0);
    done(model);
    EXPECT_EQ(model.result(), "/metrics/M_up/min_Nm");
    EXPECT_LT(model.sweep()->places.front().mean, 0.0);
    EXPECT_GT(model.sweep()->places.front().size, 0.0);
    for (const Sweep::Place& place : model.sweep()->places) {
        EXPECT_GE(place.size, std::abs(place.mean));
        EXPECT_GE(place.size, model.sweep()->best->size);
    }
}

TEST_F(Tolerances, ASweepGoesFromOneTypedValueToAnother) {
    scatter("/centre_distance_mm", u"1"_s);
    scatter("/reciprocating_masses_kg/piston", u"1 %"_s);
    watch("/moment_amplitude_Nm");
    SweepModel& model = sweep(u"/centre_distance_mm"_s);
    const auto ends = [&] {
        const auto& places = done(model).places;
        return std::pair(places.front().x, places.back().x);
    };
    const double distance = scene().inputJson()["centre_distance_mm"].get<double>();
    EXPECT_EQ(ends(), std::pair(distance - 1.0, distance + 1.0)) << "the limits of its tolerance";
    auto* from = test::named<NumberField>(*tolerances, "sweep_from");
    auto* to = test::named<NumberField>(*tolerances, "sweep_to");
    EXPECT_TRUE(from->placeholderText().contains(QLocale().toString(distance - 1.0)))
        << from->placeholderText().toStdString();
    const auto type = [](NumberField* field, const QString& text) {
        field->selectAll();
        QTest::keyClick(field, Qt::Key_Delete);
        test::type(field, text);
    };
    type(from, u"80"_s);
    type(to, u"2*60"_s);
    EXPECT_EQ(ends(), std::pair(80.0, 120.0));
    // A range the wrong way round, or beyond what the input may be, says so.
    type(to, u"70"_s);
    EXPECT_EQ(model.trouble(), u"“From” must be less than “to”."_s);
    type(to, u""_s);
    EXPECT_EQ(ends(), std::pair(80.0, distance + 1.0));
    type(from, u"-5"_s);
    EXPECT_FALSE(from->trouble().isEmpty());
    // Those of one input are not those of another.
    sweep(u"/reciprocating_masses_kg/piston"_s);
    EXPECT_FALSE(to->value());
    const double piston = scene().inputJson()["reciprocating_masses_kg"]["piston"].get<double>();
    EXPECT_NEAR(ends().first, 0.99 * piston, 1e-9);
}

TEST_F(Tolerances, ASweepShowsItsPointsAsTheyComeAndIsMadeOnce) {
    scatter("/centre_distance_mm", u"1"_s);
    watch("/metrics/M_ups/range_Nm");
    waitForAnswer();
    const auto* view = the<SweepView>();
    SweepModel& model = *view->model();
    std::vector<std::size_t> soFar;
    const auto reported = QObject::connect(&model, &SweepModel::changed, [&] {
        if (model.isPartial()) {
            soFar.push_back(view->plot()->data().curves.at(0).x.size());
        }
    });
    const QSignalSpy runs(model.job(), &BackgroundJob::runningChanged);
    sweep();
    ASSERT_TRUE(model.isBusy());
    the<QTabWidget>()->setCurrentIndex(0);
    sweep();
    const Sweep found = done(model);
    EXPECT_EQ(runs.count(), 2) << "one run, which a change of tab does not end";
    EXPECT_EQ(soFar, (std::vector<std::size_t>{16, 31, 61, 121}));
    QObject::disconnect(reported);
    // Of the same case and settings they need not be found again.
    SweepModel again(tolerances->model());
    QSignalSpy parts(&again, &SweepModel::changed);
    again.setWatched(true);
    EXPECT_EQ(done(again), found);
    EXPECT_EQ(parts.count(), 1);
}

/// A report of the case that the window has solved, or another window.
TEST_F(Tolerances, ACaseThatIsTheSameIsSolvedOnce) {
    scatter("/centre_distance_mm", u"1"_s);
    watch("/metrics/M_ups/range_Nm");
    tolerances->model()->setSamples(65536);
    QSignalSpy told(tolerances->model()->job(), &BackgroundJob::progress);
    waitForAnswer();
    EXPECT_GT(told.count(), 0);
    const auto solved = [&] {
        StudyModel other(&scene());
        const QSignalSpy again(other.job(), &BackgroundJob::progress);
        other.setWatched(true);
        EXPECT_TRUE(test::comes([&] { return other.answers() != nullptr; }));
        EXPECT_EQ(*other.answers()->values.at(0).mean,
                  *tolerances->model()->answers()->values.at(0).mean);
        return again.count();
    };
    EXPECT_EQ(solved(), 0);
    scatter("/centre_distance_mm", u"2"_s);
    told.clear();
    waitForAnswer();
    EXPECT_GT(told.count(), 0) << "another case";
    EXPECT_EQ(solved(), 0);
    // A watched value that the program watches anyway is an answer more.
    tolerances->model()->watch("/buildable/at_shaft_angle");
    waitForAnswer();
    EXPECT_EQ(tolerances->model()->answers()->values.size(), 2U);
}

/// A case from elsewhere: another torque source has taken the input along.
TEST_F(Tolerances, AToleranceThatIsGoneDoesNotStopASweep) {
    scatter("/centre_distance_mm", u"1"_s);
    watch("/moment_amplitude_Nm");
    CaseFile file = scene().caseFile();
    file.study["vary"]["/torque/cycle/compression_ratio"] = {{"plus_minus", 0.5}};
    scene().loadFile(file, scene().context());
    SweepModel& model = sweep();
    ASSERT_TRUE(test::comes(
        [&] { return !model.trouble().isEmpty() || (model.sweep() && !model.isStale()); }));
    EXPECT_EQ(model.trouble(), QString());
    const auto* inputs = test::named<QComboBox>(*tolerances, "sweep_input");
    EXPECT_LT(inputs->findData(u"/torque/cycle/compression_ratio"_s), 0);
}

TEST_F(Tolerances, TheRobustAngleIsTheLowestOfTheSweepThatCanBeBuilt) {
    scatter("/centre_distance_mm", u"0.2"_s);
    watch("/metrics/M_ups/range_Nm");
    const Sweep sweep = done(this->sweep(u"/shaft_angle_deg"_s));
    EXPECT_EQ(sweep.places.back().x, 360.0);
    ASSERT_TRUE(sweep.best);
    double maximum = 0.0;
    double minimum = 1.0;
    for (const Sweep::Place& place : sweep.places) {
        maximum = std::max(maximum, place.built);
        minimum = std::min(minimum, place.built);
    }
    EXPECT_LT(minimum, maximum);
    EXPECT_GE(sweep.best->built, std::min(maximum, Sweep::minBuilt));
    for (const Sweep::Place& place : sweep.places) {
        EXPECT_TRUE(place.built < std::min(maximum, Sweep::minBuilt) ||
                    place.high >= sweep.best->high);
    }
    // Near the best angle of the inputs as they are.
    EXPECT_NEAR(sweep.best->x,
                scene().resultJson()["optimum_buildable"]["range"]["shaft_angle_deg"].get<double>(),
                3.0);
    const double best = sweep.best->x;
    QTest::mouseClick(test::named<QPushButton>(*tolerances, "take_best"), Qt::LeftButton);
    EXPECT_NEAR(scene().inputJson()["shaft_angle_deg"].get<double>(), best, 1e-9);
    scene().undo();
}

TEST_F(Tolerances, RejectedSamplesOfASweepAreNotCalledInfeasible) {
    scatter("/reciprocating_masses_kg/piston", u"150 %"_s);  // a mass below 0 is no input
    watch("/moment_amplitude_Nm");
    const Sweep sweep = done(this->sweep(u"/shaft_angle_deg"_s));
    ASSERT_TRUE(sweep.best);
    for (const Sweep::Place& place : sweep.places) {
        ASSERT_NEAR(place.rejected, 1.0 / 6.0, 0.02);
        ASSERT_LE(place.built, 1.0 - place.rejected);
    }
    const auto plots = the<SweepView>()->findChildren<PlotView*>();
    const PlotCurve& rejected = plots.at(1)->data().curves.at(1);
    EXPECT_EQ(rejected.style.name, u"rejected"_s);
    EXPECT_DOUBLE_EQ(rejected.y.front(), 100.0 * sweep.places.front().rejected);
    const auto labels = the<SweepView>()->findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(
        labels, [](const QLabel* each) { return each->text().contains(u"Rejected samples: "_s); }));
}

TEST_F(Tolerances, TheWindowNamesItsCase) {
    EXPECT_TRUE(tolerances->windowTitle().endsWith(scene().titleShown()));
    scene().editText(u"Another engine"_s, QString());
    EXPECT_EQ(tolerances->windowTitle(), u"Tolerances – Another engine"_s);
}

TEST_F(Tolerances, AnEmptyWindowSaysTheNextStep) {
    const auto says = [&](const QString& text) {
        return std::ranges::any_of(tolerances->findChildren<QLabel*>(), [&](const QLabel* each) {
            return each->isVisible() && each->text().contains(text);
        });
    };
    EXPECT_TRUE(says(u"Enter the tolerance"_s));
    tolerances->model()->take(StudyModel::Preset::Typical);
    EXPECT_GT(study().vary.size(), 3U);
    EXPECT_EQ(scene().history()->index(), 1);
    EXPECT_TRUE(says(u"Choose a result"_s));
    tolerances->model()->setSamples(64);
    watch("/metrics/M_ups/range_Nm");
    waitForAnswer();
    EXPECT_FALSE(says(u"Choose a result"_s));
    EXPECT_EQ(the<ResultTable>()->rowCount(), 1);
    // Two digits of the standard deviation.
    const StudyAnswer& range = tolerances->model()->answers()->values.at(0);
    const int decimals = 1 - static_cast<int>(std::floor(std::log10(*range.deviation)));
    EXPECT_EQ(the<ResultTable>()->item(0, 3)->text(),
              QLocale().toString(*range.deviation, 'f', std::max(decimals, 0)));
}

TEST_F(Tolerances, MethodsThatAreGoneGiveWayAndLoseNothing) {
    for (const char* method : {"second-order", "latin-hypercube"}) {
        CaseFile file = scene().caseFile();
        file.study = {{"vary", {{"/crank_radius_mm", {{"plus_minus", 0.5}}}}},
                      {"watch", {{"/metrics/M_ups/range_Nm", {{"max", 1100}}}}},
                      {"method", method},
                      {"samples", 64},
                      {"seed", 7}};
        scene().loadFile(file, scene().context());
        EXPECT_EQ(tolerances->model()->trouble(), QString());
        EXPECT_EQ(tolerances->model()->removedMethod(), QLatin1String(method));
        EXPECT_EQ(study().method, studies::Method::sobol);
        ASSERT_EQ(study().vary.size(), 1U);
        EXPECT_EQ(study().vary[0].size, 0.5);
        EXPECT_EQ(study().watch.at(0).max, 1100.0);
        EXPECT_EQ(study().seed, 7U);
        waitForAnswer();
        EXPECT_EQ(tolerances->model()->answers()->solved, 64U);
        EXPECT_EQ(scene().caseFile().study, file.study) << "the file is as it was until a change";
        scatter("/crank_radius_mm", u"0.4"_s);
        EXPECT_EQ(scene().caseFile().study["method"], "sobol");
        EXPECT_TRUE(tolerances->model()->removedMethod().isEmpty());
    }
}

TEST_F(Tolerances, OfAnInputThatIsGoneStayAndAreRemovedByHand) {
    CaseFile file = scene().caseFile();
    file.study = {{"vary",
                   {{"/crank_radius_mm", {{"plus_minus", 0.5}}},
                    {"/reciprocating_masses_kg/gone_part", {{"plus_minus", 0.01}}}}},
                  {"watch", {{"/moment_amplitude_Nm", Json::object()}}},
                  {"samples", 64}};
    scene().loadFile(file, scene().context());
    waitForAnswer();
    EXPECT_EQ(tolerances->model()->trouble(), QString());
    EXPECT_EQ(tolerances->model()->answers()->solved, 64U);
    EXPECT_EQ(study().vary.size(), 2U);
    const QAbstractItemModel* table = tolerances->inputs()->view()->model();
    const QModelIndex last = table->index(table->rowCount() - 1, ScatterTable::Name);
    EXPECT_TRUE(last.data().toString().contains(u"no longer"_s))
        << qPrintable(last.data().toString());
    EXPECT_FALSE(last.data().toString().contains(u'/'));
    EXPECT_FALSE(last.data(Qt::ToolTipRole).toString().contains(u'/'));
    tolerances->inputs()->view()->setCurrentIndex(last);
    QTest::keyClick(tolerances->inputs()->view(), Qt::Key_Delete);
    EXPECT_EQ(study().vary.size(), 1U);
}

TEST_F(Tolerances, OfWhatIsLeftToItsDefaultAreInTheFile) {
    ASSERT_FALSE(scene().inputJson().contains("crank_share"));
    scatter("/crank_share", u"0.1"_s);
    tolerances->model()->setSamples(64);
    watch("/metrics/M_ups/range_Nm");
    waitForAnswer();
    EXPECT_EQ(tolerances->model()->answers()->solved, study().samples);
    const CaseFile file = scene().caseFile();
    EXPECT_EQ(file.input["crank_share"], 0.5);
    EXPECT_NO_THROW(studies::problem_of(file, scene().context()));
    scene().loadFile(file, scene().context());
    EXPECT_EQ(study().vary.size(), 1U);
}

TEST(ToleranceInputs, AreNoCountsAndNoNames) {
    const auto page = test::makePage("inertia-moments");
    const StudyModel study(page->model());
    EXPECT_GT(study.inputs().size(), 5U);
    for (const StudyModel::Input& input : study.inputs()) {
        EXPECT_EQ(input.pointer.find("firing_order"), std::string::npos) << input.pointer;
        EXPECT_NE(input.pointer, "/layout/cylinders");
        EXPECT_FALSE(input.name.isEmpty());
    }
}

TEST_F(Tolerances, AreOfNoSettings) {
    ASSERT_TRUE(scene().inputJson().contains("step_deg"));
    for (const StudyModel::Input& input : tolerances->model()->inputs()) {
        EXPECT_NE(input.pointer, "/step_deg");
    }
    const auto* swept = test::named<QComboBox>(*tolerances, "sweep_input");
    EXPECT_EQ(swept->findData(u"/step_deg"_s), -1);
    EXPECT_GT(swept->findData(u"/crank_radius_mm"_s), -1);
}

TEST_F(Tolerances, WhatIsRejectedIsSaidBeforeTheCaseIsSaved) {
    EXPECT_TRUE(rejectedEntries(window.currentPage()).isEmpty());
    scatter("/crank_radius_mm", u"abc"_s);
    watch("/metrics/M_ups/range_Nm");
    type(tolerances->watched(), 0, WatchTable::Minimum, u"much"_s);
    const QStringList rejected = rejectedEntries(window.currentPage());
    ASSERT_EQ(rejected.size(), 2);
    EXPECT_TRUE(rejected[0].startsWith(u"Inputs and their tolerances: Crank radius"_s))
        << rejected[0].toStdString();
    EXPECT_TRUE(rejected[1].startsWith(u"Results to watch: "_s)) << rejected[1].toStdString();
    EXPECT_TRUE(rejectedInputs(window.currentPage()).isEmpty());
}

// The first example's shaft stands in the cylinder, and at the edge of what fits, about half of
// the samples do.
TEST_F(Tolerances, SayHowManySamplesAreFeasible) {
    auto& model = dynamic_cast<BalanceShaftModel&>(scene());
    EXPECT_EQ(section().body, QString());  // without tolerances no word of them
    scatter("/shaft_angle_deg", u"0.5"_s);
    watch("/moment_amplitude_Nm");
    waitForAnswer();
    const StudyAnswers* answers = tolerances->model()->answers();
    EXPECT_EQ(*answers->feasible, model.result().is_buildable ? 1.0 : 0.0);
    ASSERT_FALSE(model.result().buildable.stretches.empty());
    model.setShaftAngleDeg(model.result().buildable.stretches.front().from / degree);
    waitForAnswer();
    answers = tolerances->model()->answers();
    EXPECT_EQ(answers->values.size(), 1U);
    EXPECT_NEAR(*answers->feasible, 0.5, 0.02);
    const auto labels = tolerances->findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(labels, [&](const QLabel* each) {
        return each->text().contains(u"Feasible samples: "_s);
    }));
    // In the report too, with the sweep and its share of feasible samples.
    scene().setSweepChoice({.input = "/shaft_angle_deg", .result = "/moment_amplitude_Nm"});
    const Paper report = section();
    EXPECT_EQ(report.drawings.size(), 2U);
    EXPECT_EQ(report.body.count(u"class=\"warning\""_s), 1);
}

}  // namespace
}  // namespace ravnoves
