#include "methods/model/methods_model.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QSignalSpy>
#include <optional>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "events.h"
#include "examples.h"
#include "methods/model/case_budget_model.h"
#include "methods_support.h"
#include "processor_time.h"
#include "scenes/scenes.h"
#include "text/message_text.h"

namespace ravnoves {
namespace {

using test::waitUntilMeasured;

std::size_t kernelIndex(const MethodsModel& model, const char* id) {
    for (std::size_t i = 0; i < model.kernels().size(); ++i) {
        if (model.kernels()[i].id == id) {
            return i;
        }
    }
    ADD_FAILURE() << id;
    return 0;
}

TEST(MethodsModel, IsNoCase) {
    MethodsModel model;
    EXPECT_FALSE(model.hasCaseFile());
    EXPECT_TRUE(model.inputJson().empty());
    EXPECT_THROW(model.loadInput(Json{{"lambda", 0.3}}, {}), InputError);
    try {
        model.setByKey(QStringLiteral("lambda"), QStringLiteral("0.3"));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.where(), "/input/lambda");
        EXPECT_NE(error.allowed().find("kernel, sweep, value"), std::string::npos);
    }
    EXPECT_FALSE(model.history()->canUndo());
}

TEST(MethodsModel, SettingsAreChecked) {
    MethodsModel model;
    model.setByKey(QStringLiteral("kernel"), QStringLiteral("guide"));
    model.setByKey(QStringLiteral("sweep"), QStringLiteral("locking"));
    model.setByKey(QStringLiteral("value"), QStringLiteral("0.1"));
    EXPECT_EQ(model.kernel().id, "guide");
    EXPECT_EQ(model.sweep().id, "locking");
    EXPECT_EQ(model.value(), 0.1);
    const auto rejected = [&](const char* key, const char* value, const char* allowed) {
        try {
            model.setByKey(QString::fromLatin1(key), QString::fromLatin1(value));
            ADD_FAILURE() << key;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where(), key);
            EXPECT_EQ(error.found(), value);
            EXPECT_NE(error.allowed().find(allowed), std::string::npos) << error.what();
        }
    };
    rejected("kernel", "giude", "hinge-motion");
    rejected("sweep", "offset", "stiffness");
    rejected("value", "1.5", "to 0.99");
    rejected("value", "nan", "to 0.99");
    EXPECT_EQ(model.value(), 0.1);
}

std::optional<OpenCase> openExample(const char* name) {
    return OpenCase{test::example(name), {}};
}

TEST(CaseBudgetModel, ShowsEachLeadingResultWithWhatChangesIt) {
    CaseBudgetModel model;
    QSignalSpy changed(&model, &CaseBudgetModel::changed);
    model.load(std::nullopt);
    EXPECT_TRUE(model.results().rows.isEmpty());
    EXPECT_TRUE(messageText(model.verdict().text).startsWith(QStringLiteral("Open a case")));
    const auto load = [&](const std::optional<OpenCase>& open) {
        model.load(open);
        ASSERT_TRUE(test::comes([&] { return !model.isRunning(); }));
    };
    auto open = openExample("tmz-650d");
    open->file.study = {{"vary", {{"/crank_radius_mm", {{"plus_minus", 0.5}}}}},
                        {"watch", Json::object()}};
    load(open);
    const auto budget = methods::case_budget(open->file, open->context);
    const Results results = model.results();
    qsizetype rows = 0;
    for (const auto& doubt : budget) {
        ASSERT_NE(results.rows[rows][1].number(), nullptr);
        EXPECT_DOUBLE_EQ(results.rows[rows++][1].number()->value,
                         *doubt.result.si / doubt.result.unit);
        for (const auto& contribution : doubt.contributions) {
            ASSERT_NE(results.rows[rows][2].number(), nullptr);
            EXPECT_DOUBLE_EQ(results.rows[rows++][2].number()->value,
                             *contribution.change / doubt.result.unit);
        }
    }
    EXPECT_EQ(results.rows.size(), rows);
    const auto name = [&](int row) { return results.rows[row][0].text.trimmed(); };
    EXPECT_EQ(name(1), QStringLiteral("Interpolation: periodic cubic spline"));
    EXPECT_EQ(results.rows[1][3].text, QStringLiteral("N·m"));
    EXPECT_FALSE(results.rows[1][2].text.contains(QStringLiteral("N·m"))) << "a number alone";
    EXPECT_EQ(name(2), QStringLiteral("Tolerance: Crank radius r"));
    EXPECT_EQ(name(3), QStringLiteral("Rounding"));
    // The headline is of the first result, which leads the page, too, and of what changes it most.
    const QString headline = messageText(model.verdict().text);
    EXPECT_TRUE(headline.startsWith(messageText(budget.front().result.name) + QLatin1Char(':')))
        << headline.toStdString();
    EXPECT_TRUE(headline.contains(name(1) + QLatin1Char(','))) << headline.toStdString();
    EXPECT_GE(model.leftOut().size(), 3);
    // Of a first result that only rounding changes, the headline is of the next.
    load(openExample("radial-9"));
    EXPECT_FALSE(messageText(model.verdict().text).contains(QStringLiteral("Rounding")));
    // An empty case is no error.
    load(openExample("../templates/workshop"));
    EXPECT_TRUE(model.results().rows.isEmpty());
    EXPECT_EQ(model.verdict().severity, Severity::note);
    const QStringList leftOut = model.leftOut();
    EXPECT_EQ(leftOut.count(QStringLiteral("The crankshaft is rigid.")), 1);
    // A case that is rejected is named in the window's words.
    open = openExample("tmz-650d");
    open->file.input["crank_radius_mm"] = -1;
    load(open);
    EXPECT_TRUE(model.results().rows.isEmpty());
    EXPECT_EQ(model.verdict().severity, Severity::error);
}

TEST(MethodsModel, MeasuresWhatIsChosenWhenItComesToTheFront) {
    MethodsModel model;
    QApplication::processEvents();
    EXPECT_FALSE(model.measuring()->isRunning());
    EXPECT_EQ(model.shown(), nullptr);
    model.setActive(true);
    waitUntilMeasured(model);
    ASSERT_NE(model.shown(), nullptr);
    EXPECT_FALSE(model.isStale());
    EXPECT_EQ(&model.shown()->kernel(), &model.kernel());
    EXPECT_EQ(model.shown()->map->curves.size(), model.kernel().methods.size());
}

TEST(MethodsModel, KeepsWhatWasMeasured) {
    MethodsModel model;
    model.setActive(true);
    waitUntilMeasured(model);
    const MethodMeasurement* first = model.shown();
    model.setKernel(kernelIndex(model, "guide"));
    // The old measurement stays until the new one is complete.
    EXPECT_EQ(model.shown(), first);
    EXPECT_TRUE(model.isStale());
    waitUntilMeasured(model);
    EXPECT_EQ(model.shown()->kernel().id, "guide");
    EXPECT_FALSE(model.isStale());
    // Back at once, with nothing to measure.
    QSignalSpy running(model.measuring(), &BackgroundJob::runningChanged);
    model.setKernel(0);
    EXPECT_EQ(model.shown(), first);
    EXPECT_FALSE(model.isStale());
    QTest::qWait(300);
    EXPECT_EQ(running.count(), 0);
}

TEST(MethodsModel, ADragIsMeasuredWhereItEnds) {
    MethodsModel model;
    model.setKernel(kernelIndex(model, "moment-range"));
    model.setActive(true);
    waitUntilMeasured(model);
    QSignalSpy measured(&model, &SceneModel::changed);
    for (int angle = 100; angle <= 140; ++angle) {
        model.setValue(angle);
        EXPECT_TRUE(model.isStale());
        QApplication::processEvents();
    }
    EXPECT_EQ(measured.count(), 0);
    EXPECT_NE(model.shown(), nullptr);
    ASSERT_TRUE(measured.wait(20000));
    EXPECT_EQ(model.shown()->report.value, 140.0);
    EXPECT_EQ(measured.count(), 1);
}

/// Closing the page in the midst of the slowest kernel takes no longer than a moment.
TEST(MethodsModel, EndsCleanlyWhileMeasuring) {
    std::optional<test::ProcessorTime> time;
    {
        MethodsModel model;
        model.setKernel(kernelIndex(model, "hinge-motion"));
        model.setViewOption(QStringLiteral("sweep"), QStringLiteral("turns"));
        model.setActive(true);
        model.measureAgain();
        QTest::qWait(400);
        EXPECT_TRUE(model.measuring()->isRunning());
        time.emplace();
    }
    EXPECT_LT(time->seconds(), 3.0);
}

}  // namespace
}  // namespace ravnoves
