// What tolerances do to the curves and numbers of a page: bands, ±.

#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QSlider>
#include <QTemporaryDir>
#include <cmath>

#include "../../core/balance-shaft/synthetic_engine.h"
#include "balance-shaft/presets.h"
#include "balance-shaft/torque_table.h"
#include "case-file/case_file.h"
#include "case-file/json.h"
#include "case-file/text_file.h"
#include "elastic-hinge/model/elastic_hinge_model.h"
#include "events.h"
#include "files.h"
#include "model/background_job.h"
#include "model/case_document.h"
#include "pictures/figure.h"
#include "plot/plot_view.h"
#include "scene_tests.h"
#include "shown_number.h"
#include "studies/model/part_numbers.h"
#include "studies/study_run.h"
#include "studies/tolerance_bands.h"
#include "text/csv_format.h"
#include "text/file_path.h"
#include "text/preferences.h"
#include "widgets/result_table.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

constexpr double point95 = 1.6448536269514722;

class Bands : public ::testing::Test {
  protected:
    void open(const std::string& scene, const Json& vary, const char* method = "sobol") {
        page = test::makePage(scene);
        page->model()->changeStudy(
            u"tolerances"_s,
            Json{{"vary", vary}, {"watch", Json::object()}, {"method", method}, {"samples", 64}}
                .dump());
        test::showAt(*page, {1280, 800});
        settle();
    }
    void settle() {
        ASSERT_TRUE(test::comes([&] { return !page->isBusy(); }));
    }
    /// The first plot in front with so many curves at least.
    PlotView* plot(int curves) {
        for (PlotView* each : page->findChildren<PlotView*>()) {
            if (each->isVisible() && std::ssize(each->data().curves) >= curves) {
                return each;
            }
        }
        return nullptr;
    }
    static const PlotCurve& curve(const PlotView* plot, std::size_t number) {
        return plot->data().curves.at(number);
    }
    /// Those beside the numbers of tables.
    QStringList texts() const {
        QStringList all;
        for (const ResultTable* table : page->findChildren<ResultTable*>()) {
            for (int row = 0; row < table->rowCount(); ++row) {
                for (int column = 1; column < table->columnCount(); ++column) {
                    all << table->spreadAt(row, column);
                }
            }
        }
        all.removeAll(QString());
        all.removeDuplicates();
        return all;
    }

    std::unique_ptr<ScenePage> page;
};

TEST_F(Bands, AreWhatTheSamplesMakeOfTheScatter) {
    // Ms = P₁ l sin(α + φ): a percent of l is a percent of it.
    open("balance-shaft", {{"/centre_distance_mm", {{"normal_sd", 2.0}}}});
    const PlotView* moments = plot(3);
    ASSERT_NE(moments, nullptr);
    EXPECT_FALSE(curve(moments, 0).hasSpread());  // the engine's own torque
    const PlotCurve& shaft = curve(moments, 1);
    ASSERT_TRUE(shaft.hasSpread());
    const double distance = page->model()->inputJson()["centre_distance_mm"].get<double>();
    const auto top = std::max_element(shaft.y.begin(), shaft.y.end()) - shaft.y.begin();
    const auto at = static_cast<std::size_t>(top);
    const double low = shaft.below[at] / shaft.y[at];
    const double high = shaft.above[at] / shaft.y[at];
    EXPECT_NEAR(low, point95 * 2.0 / distance, 0.05 * low);
    EXPECT_NEAR(high, point95 * 2.0 / distance, 0.05 * high);
    for (std::size_t i = 0; i < shaft.x.size(); ++i) {
        const bool isUp = shaft.y[i] > 0.0;
        const double size = std::abs(shaft.y[i]);
        ASSERT_NEAR(shaft.below[i], size * (isUp ? low : high), 1e-5 * shaft.y[at]) << shaft.x[i];
        ASSERT_NEAR(shaft.above[i], size * (isUp ? high : low), 1e-5 * shaft.y[at]) << shaft.x[i];
    }
    // The same number in the table beside.
    bool found = false;
    for (const ResultTable* table : page->findChildren<ResultTable*>()) {
        for (int row = 0; row < table->rowCount(); ++row) {
            if (table->item(row, 0)->text().startsWith(u"Amplitude of Mₛ"_s)) {
                const auto half = test::readShownNumber(table->spreadAt(row, 1).mid(2));
                ASSERT_TRUE(half);
                EXPECT_NEAR(half->value, 0.5 * (shaft.below[at] + shaft.above[at]), 0.5);
                EXPECT_TRUE(table->asText().contains(table->spreadAt(row, 1)));
                found = true;
            }
        }
    }
    EXPECT_TRUE(found);
    // α ± 40°: at the top of the curve 5 % lie below cos 38° of it.
    open("balance-shaft", {{"/shaft_angle_deg", {{"plus_minus", 40.0}}}});
    const PlotCurve& turned = curve(plot(3), 1);
    const auto peak = static_cast<std::size_t>(std::max_element(turned.y.begin(), turned.y.end()) -
                                               turned.y.begin());
    EXPECT_NEAR(turned.below[peak] / turned.y[peak], 1.0 - std::cos(38.0 * M_PI / 180.0), 0.02);
    EXPECT_NEAR(turned.above[peak] / turned.y[peak], 0.0, 2e-3);
}

TEST_F(Bands, AreThereAgainWhenTheHandRests) {
    open("balance-shaft", {{"/centre_distance_mm", {{"plus_minus", 1.0}}}});
    PlotView* moments = plot(3);
    const std::vector<double> before = curve(moments, 1).above;
    EXPECT_GT(texts().size(), 1);
    auto* slider = test::named<QSlider>(*page, "shaft_angle_deg_slider");
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_PageUp);
    EXPECT_FALSE(curve(moments, 1).hasSpread());
    EXPECT_EQ(texts(), QStringList(u"± …"_s));
    EXPECT_TRUE(page->isBusy());
    settle();
    ASSERT_TRUE(curve(moments, 1).hasSpread());
    EXPECT_NE(curve(moments, 1).above, before);
    EXPECT_GT(texts().size(), 1);
    // A limit has no band: nothing begins.
    Json study = parse_json(page->model()->study());
    study["watch"] = {{"/metrics/M_ups/range_Nm", {{"max", 2000.0}}}};
    page->model()->changeStudy(u"limit"_s, study.dump());
    EXPECT_FALSE(page->isBusy());
}

TEST_F(Bands, StayWhereTheTextOfTheCaseChanges) {
    open("balance-shaft", {{"/centre_distance_mm", {{"normal_sd", 2.0}}}});
    const auto* bands = page->findChild<ToleranceBands*>();
    page->model()->editText(u"another title"_s, u"notes"_s);
    EXPECT_FALSE(bands->isBusy());
    page->model()->keepVariant();
    EXPECT_FALSE(bands->isBusy());
    page->model()->setByKey(u"centre_distance_mm"_s, u"130"_s);
    EXPECT_TRUE(bands->isBusy());
}

TEST_F(Bands, AreNotAwaitedOnceTheTolerancesAreUndone) {
    open("balance-shaft", {{"/centre_distance_mm", {{"plus_minus", 1.0}}}});
    page->model()->setByKey(u"centre_distance_mm"_s, u"130"_s);
    page->model()->undo();
    EXPECT_EQ(texts(), QStringList(u"± …"_s));
    page->model()->undo();
    EXPECT_EQ(texts(), QStringList());
}

TEST_F(Bands, AreSwitchedOffAndOn) {
    open("balance-shaft", {{"/centre_distance_mm", {{"plus_minus", 1.0}}}});
    ToleranceBands::setShown(false);
    EXPECT_FALSE(plot(3)->data().hasSpread());
    EXPECT_FALSE(page->isBusy());
    ToleranceBands::setShown(true);
    settle();
    EXPECT_TRUE(plot(3)->data().hasSpread());
    page->model()->undo();  // no tolerances any more
    EXPECT_FALSE(plot(3)->data().hasSpread());
}

TEST_F(Bands, AreInPicturesAndTables) {
    open("balance-shaft", {{"/centre_distance_mm", {{"plus_minus", 1.0}}}});
    PlotView* moments = plot(3);
    const QTemporaryDir folder;
    const auto svg = [&] {
        const QString path = folder.filePath(u"plot.svg"_s);
        EXPECT_EQ(moments->findChild<FigureMenu*>()->write(path, {}), QString());
        return QString::fromUtf8(test::contentOf(path));
    };
    const QString with = svg();
    EXPECT_TRUE(with.contains(u"5…95 %"_s));
    EXPECT_TRUE(moments->csv(CsvFormat(QLocale::c())).contains(u"95 %"_s));
    ToleranceBands::setShown(false);
    EXPECT_FALSE(svg().contains(u"5…95 %"_s));
    EXPECT_LT(svg().count(u"fill-opacity=\"0.25"_s), with.count(u"fill-opacity=\"0.25"_s));
    ToleranceBands::setShown(true);
}

TEST_F(Bands, RestBeforeTheUnitsChange) {
    open("balance-shaft", {{"/centre_distance_mm", {{"plus_minus", 1.0}}}});
    page->model()->setByKey(u"centre_distance_mm"_s, u"130"_s);
    const auto* bands = page->findChild<ToleranceBands*>();
    ASSERT_TRUE(test::comes([&] { return bands->job()->isRunning(); }));
    Preferences& preferences = Preferences::instance();
    QObject reported;
    QObject::connect(&preferences, &Preferences::changed, &reported,
                     [&] { EXPECT_FALSE(bands->job()->isRunning()); });
    preferences.setUnits(Preferences::Length, Preferences::Units::Imperial);
    EXPECT_FALSE(bands->job()->isRunning());
    preferences.setUnits(Preferences::Length, Preferences::Units::Own);
}

TEST_F(Bands, WhereNoSampleCanBeSolvedNothingIsAwaited) {
    open("balance-shaft", {{"/centre_distance_mm", {{"plus_minus", 1.0}}}});
    page->model()->changeStudy(
        u"too much"_s,
        Json{{"vary", {{"/centre_distance_mm", {{"plus_minus", 1e12}}}}}, {"watch", Json::object()}}
            .dump());
    EXPECT_TRUE(texts().contains(u"± …"_s));
    settle();
    EXPECT_FALSE(texts().contains(u"± …"_s));
}

TEST_F(Bands, OfACaseWhoseFileIsGoneThereAreNone) {
    const QTemporaryDir folder;
    open("balance-shaft", {{"/centre_distance_mm", {{"plus_minus", 1.0}}}});
    write_text_file(
        fsPath(folder.filePath(u"ind.csv"_s)),
        balance_shaft::write_torque_table(balance_shaft::preset_tmz_650d().torque.table));
    Json input = page->model()->inputJson();
    input["torque"] = {{"csv", "ind.csv"}};
    page->model()->loadInput(input, CaseContext{fsPath(folder.path())});
    ASSERT_TRUE(QFile::remove(folder.filePath(u"ind.csv"_s)));
    settle();
    EXPECT_FALSE(plot(3)->data().hasSpread());
}

/// "This case" names the phase among what is uncertain: ± and bands include it.
TEST_F(Bands, IncludeThePhaseThatATraceLeavesOpen) {
    const QTemporaryDir folder;
    std::string rows = "deg;bar\n";
    const balance_shaft::PressureTrace trace = balance_shaft::test::trace_of(
        balance_shaft::test::synthetic_engines().front().pressure(1.0), 1.0);
    for (std::size_t i = 0; i < trace.pressure.size(); ++i) {
        rows += std::to_string(i) + ';' + std::to_string(trace.pressure[i] / 1e5) + '\n';
    }
    write_text_file(fsPath(folder.filePath(u"p.csv"_s)), rows);
    Json vary{{"/centre_distance_mm", {{"plus_minus", 1e-3}}}};
    const auto found = [&] {
        open("balance-shaft", vary);
        Json input = page->model()->inputJson();
        input["torque"] = {{"pressure", {{"csv", "p.csv"}}}};
        input["cylinder"] = {{"bore_mm", 95.5}, {"rod_length_mm", 150}};
        page->model()->loadInput(input, CaseContext{fsPath(folder.path())});
        settle();
        return texts();
    };
    const QStringList byItself = found();
    const auto phase = studies::open_input(page->model()->caseFile(), page->model()->context(),
                                           std::vector<studies::Varied>());
    ASSERT_TRUE(phase);
    vary[phase->pointer] = {{"from", phase->from}, {"to", phase->to}};
    EXPECT_EQ(byItself, found()) << "as if it had been typed";
    vary[phase->pointer] = {{"plus_minus", 1e-6}};
    EXPECT_NE(byItself, found()) << "what is typed is in its place";
    vary = Json::object();
    EXPECT_EQ(found().filter(u"±"_s).isEmpty(), false) << "without a tolerance too";
}

/// Of a rod as long as its crank there is no exact kinematics to compare with: its curve is empty.
TEST(PartNumbers, OfACurveThatTheCaseHasNotKeepTheirPlaces) {
    ElasticHingeModel model;
    model.setByKey(u"kinematics"_s, u"series"_s);
    model.setByKey(u"lambda"_s, u"1"_s);
    const Figure figure = std::get<Figure>(model.part("rod-moment"));
    ASSERT_TRUE(std::any_of(figure.curves.begin(), figure.curves.end(),
                            [](const auto& curve) { return curve.x.size() != curve.y.size(); }));
    std::vector<std::string_view> ids;
    for (const PagePart& part : model.parts()) {
        ids.push_back(part.id);
    }
    PartNumbers numbers(model, ids);
    const auto other = model.another(false);
    for (const char* lambda : {"1", "0.3"}) {
        other->loadCase(model.inputJson(), {}, {});
        other->setByKey(u"lambda"_s, QString::fromLatin1(lambda));
        EXPECT_NO_THROW(numbers.add(*other)) << lambda;
    }
}

TEST(ScatteredNumber, IsBetweenOrderStatisticsAndTheShortWayRound) {
    ScatteredNumber plain{.nominal = 10.0};
    ScatteredNumber angle{.nominal = 359.0, .period = 360.0};
    ScatteredNumber rare;
    constexpr int samples = 101;
    for (int i = 0; i < samples; ++i) {
        plain.add(10.0 + i);
        angle.add(1.0);
        rare.add(i % 5 == 0 ? std::nan("") : 1.0);
    }
    EXPECT_NEAR(plain.sides(samples)->first, -5.0, 1e-6);
    EXPECT_NEAR(plain.sides(samples)->second, 95.0, 1e-6);
    EXPECT_NEAR(angle.sides(samples)->second, 2.0, 1e-6);
    EXPECT_FALSE(rare.sides(samples)) << "a fifth of the samples has none";
}

class EveryPagesBands : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryPagesBands, StandAboutItsCurvesOrNumbers) {
    const QDir examples(QString::fromUtf8(RAVNOVES_EXAMPLES));
    for (const QString& name : examples.entryList({u"*.case.json"_s})) {
        CaseFile file = CaseDocument::read(examples.filePath(name));
        if (file.scene != GetParam()) {
            continue;
        }
        SCOPED_TRACE(name.toStdString());
        Json vary = Json::object();
        const Json flat = file.input.flatten();
        for (const auto& [key, value] : flat.items()) {
            if (value.is_number_float() && vary.size() < 4 &&
                key.find("torque") == std::string::npos) {
                vary[key] = {{"plus_minus_percent", 1.0}};
            }
        }
        file.study = {{"vary", vary}, {"watch", Json::object()}, {"samples", 64}};
        const auto page = test::makePage(GetParam());
        page->model()->loadFile(file, {examples.path().toStdString()});
        test::showAt(*page, {1280, 800});
        ASSERT_TRUE(test::comes([&] { return !page->isBusy(); }));
        int found = 0;
        for (const PlotView* plot : page->findChildren<PlotView*>()) {
            for (const PlotCurve& curve : plot->data().curves) {
                found += curve.hasSpread() ? 1 : 0;
                for (std::size_t i = 0; curve.hasSpread() && i < curve.x.size(); ++i) {
                    ASSERT_TRUE(std::isfinite(curve.below[i]) && std::isfinite(curve.above[i]));
                }
            }
        }
        for (const ResultTable* table : page->findChildren<ResultTable*>()) {
            for (int row = 0; row < table->rowCount(); ++row) {
                for (int column = 1; column < table->columnCount(); ++column) {
                    found += table->spreadAt(row, column).isEmpty() ? 0 : 1;
                }
            }
        }
        EXPECT_GT(found, 0);
        return;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryPagesBands, ::testing::ValuesIn(test::sceneNamesWithCases()),
                         test::sceneOf<::testing::TestParamInfo<std::string>>);

}  // namespace
}  // namespace ravnoves
