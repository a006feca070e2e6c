#include "elastic-hinge/elastic_hinge_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTabWidget>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "case-file/json.h"
#include "case-file/text_file.h"
#include "csv_lines.h"
#include "elastic-hinge/hinge_mechanism_view.h"
#include "elastic-hinge/presets.h"
#include "page_fixture.h"
#include "text/csv_format.h"
#include "text/shown_units.h"
#include "theme/theme.h"

namespace ravnoves {
namespace {

using elastic_hinge::CounterweightInertia;
using elastic_hinge::Hinge;
using elastic_hinge::Kinematics;
class ElasticHingePageTest : public test::PageTest<ElasticHingePage> {
  protected:
    PlotView* plotOf(std::string_view part) { return partPlot(page, part); }
    QPushButton* cancelButton() { return find<QPushButton>("cancel_motion"); }
    void waitForMotions() {
        ASSERT_TRUE(test::comes([this] { return !model->runner()->isRunning(); }));
    }
};

TEST_F(ElasticHingePageTest, KeysBeforeADragAreAStepOfTheirOwn) {
    auto* slider = find<QSlider>("lambda_slider");
    const double before = model->input().lambda;
    QTest::keyClick(slider, Qt::Key_Right);
    QTest::keyClick(slider, Qt::Key_Right);
    const double byKeys = model->input().lambda;
    ASSERT_GT(byKeys, before);
    slider->setSliderDown(true);
    slider->setSliderPosition(slider->maximum() / 2);
    slider->setSliderDown(false);
    ASSERT_NE(model->input().lambda, byKeys);
    model->history()->undo();
    EXPECT_DOUBLE_EQ(model->input().lambda, byKeys);
    model->history()->undo();
    EXPECT_DOUBLE_EQ(model->input().lambda, before) << "both keys are one step";
}

TEST_F(ElasticHingePageTest, TheDistanceIsOfTheCounterweight) {
    auto* distance = field("counterweight_distance_mm");
    EXPECT_FALSE(distance->isEnabled());
    press("rod_counterweight");
    ASSERT_TRUE(model->input().rod_counterweight.has_value());
    EXPECT_EQ(model->input().rod_counterweight->inertia, CounterweightInertia::newton_euler);
    EXPECT_TRUE(distance->isEnabled());
    type("counterweight_distance_mm", QStringLiteral("50"));
    EXPECT_NEAR(model->input().rod_counterweight->distance, 0.05, 1e-15);
    while (model->history()->canUndo()) {
        model->history()->undo();
    }
    EXPECT_EQ(model->input(), elastic_hinge::preset_zotov());
    EXPECT_FALSE(distance->isEnabled());
}

TEST_F(ElasticHingePageTest, WithoutASpringWhatIsTypedGivesOneAlsoWhereItIsWhatIsShown) {
    model->edit(QStringLiteral("No spring"), [](auto& input) { input.spring.reset(); });
    EXPECT_TRUE(field("free_length_mm")->text().isEmpty());
    NumberField* stiffness = field("stiffness_kN_m");
    EXPECT_EQ(stiffness->palette().color(QPalette::Text), Theme::instance().mutedText());
    type("stiffness_kN_m", QStringLiteral("20000"));
    ASSERT_TRUE(model->input().spring);
    EXPECT_DOUBLE_EQ(model->input().spring->stiffness, 2e7);
    EXPECT_NE(stiffness->palette().color(QPalette::Text), Theme::instance().mutedText());
}

TEST_F(ElasticHingePageTest, BothStiffnessesHaveOneUnit) {
    press("own_rod_spring");
    NumberField* stiffness = field("rod_hinge_stiffness_N_m");
    EXPECT_EQ(stiffness->unit(), field("stiffness_kN_m")->unit());
    type("rod_hinge_stiffness_N_m", QStringLiteral("300"));
    EXPECT_DOUBLE_EQ(model->input().rod_hinge_spring->stiffness, 3e5);
}

TEST_F(ElasticHingePageTest, ACaseBeyondTheSlidersWidensThem) {
    model->setByKey(QStringLiteral("angular_speed_rad_s"), QStringLiteral("5000"));
    EXPECT_EQ(field("angular_speed_rad_s")->value(), 5000.0);
    model->setByKey(QStringLiteral("spring/guide_radius_at_zero_mm"), QStringLiteral("350"));
    EXPECT_EQ(field("guide_radius_at_zero_mm")->value(), 350.0);
    EXPECT_NEAR(model->input().spring->guide_radius_at_zero, 0.35, 1e-15);
    // While a hand drags it, what it drags over stays.
    auto* slider = find<QSlider>("angular_speed_rad_s_slider");
    slider->setSliderDown(true);
    slider->setSliderPosition(100);
    EXPECT_EQ(model->input().angular_speed, 100.0);
    EXPECT_EQ(slider->maximum(), 5000);
    slider->setSliderDown(false);
    EXPECT_EQ(slider->maximum(), 600);
    EXPECT_EQ(model->input().angular_speed, 100.0);
}

TEST_F(ElasticHingePageTest, FieldsEditTheCase) {
    type("slider_weight", QStringLiteral("7,5"));
    EXPECT_NEAR(model->input().slider_mass * 9.82, 7.5, 1e-12);
    type("start_speed_rad_s", QStringLiteral("80"));
    EXPECT_EQ(model->input().motion->start_speed, 80.0);
    field("start_speed_rad_s")->selectAll();
    QTest::keyClick(field("start_speed_rad_s"), Qt::Key_Backspace);
    EXPECT_FALSE(model->input().motion->start_speed.has_value());
    // Gravity changes masses, not weights.
    type("gravity_m_s2", QStringLiteral("9.80665"));
    EXPECT_NEAR(model->input().slider_mass, 7.5 / 9.80665, 1e-12);
    EXPECT_EQ(field("slider_weight")->text(), QStringLiteral("7.5"));
    EXPECT_EQ(model->inputJson().at("weights_N").at("rod").dump(), "6.5");
}

TEST_F(ElasticHingePageTest, MassesMayBeGivenForWeights) {
    EXPECT_TRUE(field("rod_weight")->isVisible());
    choose("masses_given_as", 1);
    EXPECT_FALSE(model->input().masses_as_weights);
    EXPECT_FALSE(field("rod_weight")->isVisible());
    ASSERT_TRUE(field("rod_mass")->isVisible());
    type("rod_mass", QStringLiteral("0.7"));
    EXPECT_EQ(model->input().rod_mass, 0.7);
    type("gravity_with_masses", QStringLiteral("0"));
    EXPECT_EQ(model->input().gravity, 0.0);
    EXPECT_TRUE(model->inputJson().contains("masses_kg"));
    // Weights without gravity are rejected, and the choice shows it.
    QSignalSpy status(&page, &ScenePage::status);
    choose("masses_given_as", 0);
    EXPECT_EQ(status.size(), 1);
    EXPECT_EQ(find<QComboBox>("masses_given_as")->currentIndex(), 1);
}

TEST_F(ElasticHingePageTest, FamiliesHaveTheCaseAmongThem) {
    model->setByKey(QStringLiteral("angular_speed_rad_s"), QStringLiteral("250"));
    int families = 0;
    for (const char* tab : {"rod-hinge", "side-force", "crank-moment"}) {
        bring(tab);
        for (const PlotView* plot : page.findChildren<PlotView*>()) {
            for (int i = 0; i < std::ssize(plot->data().curves); ++i) {
                if (plot->isVisible() &&
                    plot->data().curve(i).style.name == QStringLiteral("this case")) {
                    ++families;
                    EXPECT_TRUE(plot->valueAt(i, 90.0).has_value()) << qPrintable(plot->title());
                    if (plot->title().contains(QStringLiteral("without"))) {
                        EXPECT_EQ(plot->data().curves[static_cast<std::size_t>(i)].y,
                                  model->result().curves.side_force_without_hinge);
                    }
                }
            }
        }
    }
    EXPECT_GE(families, 4);
}

TEST_F(ElasticHingePageTest, LambdaOneIsDrawnBySeriesOnly) {
    auto* box = field("lambda");
    const double before = model->input().lambda;
    type("lambda", QStringLiteral("1"));
    EXPECT_FALSE(box->trouble().isEmpty());
    EXPECT_EQ(model->input().lambda, before);
    QTest::keyClick(box, Qt::Key_Escape);
    choose("kinematics", 1);
    EXPECT_EQ(model->input().kinematics, Kinematics::series);
    type("lambda", QStringLiteral("1"));
    EXPECT_EQ(model->input().lambda, 1.0);
    EXPECT_TRUE(find<QLabel>("verdict")->text().contains(QStringLiteral("locks")));
    bring("rod-hinge");
    EXPECT_TRUE(plotOf("rod-moment")->valueAt(0, 90.0).has_value());
    bring("crank-moment");
    EXPECT_FALSE(plotOf("crank-moment")->valueAt(0, 90.0).has_value());
    // Back to the exact kinematics is rejected at λ = 1, and the choice shows it.
    choose("kinematics", 0);
    EXPECT_EQ(find<QComboBox>("kinematics")->currentIndex(), 1);
}

/// Nothing is left of it, and the axis does not enlarge the rounding.
TEST_F(ElasticHingePageTest, ASideForceThatIsRoundingIsALine) {
    press("rod_counterweight");
    bring("crank-moment");
    EXPECT_EQ(plotOf("crank-moment")->data().curve(1).style.name,
              QStringLiteral("with hinge (M₁*)"));
    bring("side-force");
    const auto [low, high] = plotOf("side-force-lambdas")->data().left.interval();
    EXPECT_LT(low, -0.9);
    EXPECT_GT(high, 0.9);
}

TEST_F(ElasticHingePageTest, AMissingGuideIsShownAsAGapAndCorrected) {
    type("guide_radius_at_zero_mm", QStringLiteral("99.5"));
    PlotView* relief = plotOf("relief");
    EXPECT_TRUE(relief->valueAt(0, 20.0).has_value());
    EXPECT_FALSE(relief->valueAt(0, 76.0).has_value());
    EXPECT_TRUE(relief->valueAt(1, 180.0).has_value());  // the second piece of the same curve
    auto* preload = find<QPushButton>("verdict_act");
    ASSERT_TRUE(preload->isVisible());
    QTest::mouseClick(preload, Qt::LeftButton);
    EXPECT_TRUE(model->result().crank_guide.feasible);
    EXPECT_FALSE(preload->isVisible());
    EXPECT_TRUE(relief->valueAt(0, 76.0).has_value());
}

TEST_F(ElasticHingePageTest, GuideChoiceAndExaggerationFollowTheMouse) {
    choose("guide_shown", 2);
    EXPECT_EQ(model->shownHinge(), Hinge::rod);
    EXPECT_TRUE(model->hasAutomaticExaggeration());
    press("exaggeration_auto");
    EXPECT_FALSE(model->hasAutomaticExaggeration());
    QTest::keyClick(find<QSlider>("exaggeration_slider"), Qt::Key_Home);
    EXPECT_EQ(model->exaggeration(), 1.0);
    EXPECT_TRUE(plotOf("guides")->title().contains(QStringLiteral("to scale")));
    press("exaggeration_auto");
    EXPECT_GT(model->exaggeration(), 1.0);
}

TEST_F(ElasticHingePageTest, TablesAndPointsOfEnlargedGuidesHaveTheirTruePlaces) {
    PlotView* plot = plotOf("guides");
    model->setExaggeration(5.0);
    // A copy: the edit below makes another guide.
    const std::vector<double> radius = model->shownGuide().radius_compressed;
    const double largest = *std::max_element(radius.begin(), radius.end()) / units::mm;
    const auto lines = test::csv_lines(plot->csv(CsvFormat(QLocale::c())).toStdString());
    const auto x = std::ranges::find_if(lines[0], [](const std::string& name) {
        return name.find("compressed: x") != std::string::npos;
    });
    const auto column = static_cast<std::size_t>(x - lines[0].begin());
    ASSERT_LT(column + 1, lines[0].size());
    double found = 0.0;
    for (const auto& line : lines) {  // words are 0
        const auto number = [&](std::size_t cell) { return std::atof(line.at(cell).c_str()); };
        found = std::max(found, std::hypot(number(column), number(column + 1)));
    }
    EXPECT_NEAR(found, largest, 1e-6 * largest);

    // The point of 0° lies on the x axis.
    showTabOf(plot);
    QApplication::processEvents();
    ASSERT_TRUE(test::pointUntil(
        plot, [&] { return plot->toPixel(radius[0] / units::mm, 0.0); },
        [&] { return plot->data().pointRead.has_value(); }));
    const PlotCurve& curve = plot->data().curves[plot->data().pointRead->first];
    EXPECT_EQ(curve.text(0).section(QLatin1Char('\n'), 1, 1), QStringLiteral("φ = 0.0°"));
    EXPECT_TRUE(curve.text(0).contains(shownNumber(radius[0], units::mm, 4)));

    // With a gap the curve begins behind it: each point has the angle at which it stands.
    model->edit(QStringLiteral("gap"),
                [](auto& input) { input.spring->guide_radius_at_zero = 0.0999; });
    QApplication::processEvents();
    const PlotCurve& torn = plot->data().curves[3];
    ASSERT_LT(torn.x.size(), radius.size());
    ASSERT_TRUE(torn.isReadable());
    for (std::size_t k = 0; k < torn.x.size(); k += 7) {
        const double seen = std::fmod(std::atan2(torn.y[k], torn.x[k]) / degree + 360.0, 360.0);
        const QString read = torn.text(torn.places[k]).section(QLatin1Char('\n'), 1, 1);
        EXPECT_NEAR(seen, read.mid(4).chopped(1).toDouble(), 0.06) << k;
    }
}

TEST_F(ElasticHingePageTest, AHandOnThePictureEndsItsMotion) {
    waitForMotions();
    auto* picture = page.findChild<HingeMechanismView*>();
    picture->setPlaying(true);
    EXPECT_TRUE(test::comes([&] { return model->motionTime().has_value(); }));
    // Straight above the crank's axis it stands at 90°.
    QTest::mouseClick(picture, Qt::LeftButton, {}, QPoint(95, picture->height() / 2 - 60));
    EXPECT_FALSE(picture->isPlaying());
    EXPECT_NEAR(model->crank()->degrees(), 90.0, 10.0);
    QTest::keyClick(picture, Qt::Key_Left);
    EXPECT_FALSE(model->motionTime().has_value());
}

TEST_F(ElasticHingePageTest, SearchTakesOverWhatItFound) {
    bring("search");
    auto* answer = find<QLabel>("search_answer");
    EXPECT_TRUE(answer->text().contains(QStringLiteral("1.000\u00A0mm")))
        << answer->text().toStdString();
    type("relief_mm", QStringLiteral("2"));
    EXPECT_TRUE(answer->text().contains(QStringLiteral("2.000\u00A0mm")))
        << answer->text().toStdString();
    press("take_proposal");
    EXPECT_NEAR(model->result().crank_guide.relief, 2e-3, 1e-9);
    // A present design that has more relief than required is better: nothing is offered.
    type("relief_mm", QStringLiteral("1"));
    EXPECT_FALSE(find<QPushButton>("take_proposal")->isEnabled());
    EXPECT_TRUE(answer->text().contains(QStringLiteral("meets the requirements")))
        << answer->text().toStdString();
    type("relief_mm", QStringLiteral("2.5"));
    EXPECT_TRUE(find<QPushButton>("take_proposal")->isEnabled());
    type("outer_diameter_mm", QStringLiteral("50"));
    EXPECT_FALSE(find<QPushButton>("take_proposal")->isEnabled());
    EXPECT_TRUE(answer->text().startsWith(QStringLiteral("None")));
}

TEST_F(ElasticHingePageTest, ExportsAsTheFormIsSet) {
    bring("export");
    const QTemporaryDir folder;
    choose("export_hinge", 2);
    choose("export_turns", 1);
    type("step_deg", QStringLiteral("90"));
    const QString csv = folder.filePath(QStringLiteral("rod.csv"));
    EXPECT_EQ(model->exportGuide(csv), QString());
    const std::string text = read_text_file(csv.toStdString());
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
    EXPECT_NE(text.find("\n90,107.4576"), std::string::npos) << text;  // θ = 90° + asin 0.3
    const QString dxf = folder.filePath(QStringLiteral("rod.dxf"));
    EXPECT_EQ(model->exportGuide(dxf), QString());
    EXPECT_NE(read_text_file(dxf.toStdString()).find("ROLLER_PATH"), std::string::npos);
    EXPECT_TRUE(model->exportGuide(QStringLiteral("/nowhere/guide.dxf"))
                    .contains(QStringLiteral("/nowhere/guide.dxf")));
    EXPECT_TRUE(find<QPushButton>("export_dxf")->isEnabled());
    model->edit(QStringLiteral("rho"),
                [](auto& input) { input.spring->guide_radius_at_zero = 0.09999; });
    EXPECT_FALSE(find<QPushButton>("export_dxf")->isEnabled());
    EXPECT_TRUE(model->exportGuide(csv).contains(QStringLiteral("preload")));
    EXPECT_EQ(read_text_file(csv.toStdString()), text);  // what was there stays
}

TEST_F(ElasticHingePageTest, AnExportAsksAboutEntriesThatAreRejected) {
    bring("export");
    type("step_deg", QStringLiteral("-5"));
    QString asked;
    test::whenModal<QMessageBox>(&page, [&asked](QMessageBox* box) {
        asked = box->text();
        box->button(QMessageBox::Cancel)->click();
    });
    press("export_csv");
    EXPECT_TRUE(asked.contains(QStringLiteral("not accepted"))) << asked.toStdString();
}

TEST_F(ElasticHingePageTest, MotionIsCancelledByItsButton) {
    bring("motion");
    waitForMotions();
    EXPECT_FALSE(cancelButton()->isVisible());
    type("turns", QStringLiteral("1000"));
    ASSERT_TRUE(model->runner()->isRunning());
    EXPECT_TRUE(cancelButton()->isVisible());
    QTest::mouseClick(cancelButton(), Qt::LeftButton);
    waitForMotions();
    EXPECT_FALSE(cancelButton()->isVisible());
    EXPECT_LT(model->motions()->without->crank_angle.back(), 10 * two_pi);  // the old one
}

}  // namespace
}  // namespace ravnoves
