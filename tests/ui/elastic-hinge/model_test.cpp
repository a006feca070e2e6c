#include "elastic-hinge/model/elastic_hinge_model.h"

#include <gtest/gtest.h>

#include "case-file/input_error.h"
#include "case-file/json.h"
#include "comes.h"
#include "elastic-hinge/input.h"
#include "elastic-hinge/presets.h"
#include "text/message_text.h"

namespace ravnoves {
namespace {

using elastic_hinge::CounterweightInertia;
using elastic_hinge::GuideSign;
using elastic_hinge::Hinge;
using elastic_hinge::Kinematics;
using elastic_hinge::RodCounterweight;

QString verdictOf(const ElasticHingeModel& model) {
    return messageText(model.verdict().text);
}

/// Waits until the worker thread has computed the motions of the present input.
void waitForMotions(ElasticHingeModel& model) {
    ASSERT_TRUE(test::comes([&] { return !model.runner()->isRunning(); }));
    ASSERT_NE(model.motions(), nullptr);
}

TEST(ElasticHingeModel, SetsValuesByTheirKeys) {
    ElasticHingeModel model;
    model.setByKey(QStringLiteral("spring/stiffness_N_m"), QStringLiteral("3e5"));
    EXPECT_EQ(model.input().spring->stiffness, 3e5);
    model.setByKey(QStringLiteral("kinematics"), QStringLiteral("series"));
    EXPECT_EQ(model.input().kinematics, Kinematics::series);
    model.setByKey(QStringLiteral("crank_angle_deg"), QStringLiteral("400"));
    EXPECT_NEAR(model.crank()->degrees(), 40.0, 1e-12);
    model.setByKey(QStringLiteral("exaggeration"), QStringLiteral("20"));
    EXPECT_EQ(model.exaggeration(), 20.0);
    model.setByKey(QStringLiteral("exaggeration"), QStringLiteral("auto"));
    EXPECT_TRUE(model.hasAutomaticExaggeration());
    model.setByKey(QStringLiteral("guide_shown"), QStringLiteral("rod"));
    EXPECT_EQ(model.shownHinge(), Hinge::rod);
    model.setByKey(QStringLiteral("animate"), QStringLiteral("off-design"));
    EXPECT_EQ(model.animated(), ElasticHingeModel::Animated::OffDesign);
    for (const auto& [key, value] : {std::pair("lamda", "0.3"), std::pair("guide_shown", "wheel"),
                                     std::pair("exaggeration", "0")}) {
        EXPECT_THROW(model.setByKey(QString::fromLatin1(key), QString::fromLatin1(value)),
                     InputError)
            << key;
    }
}

TEST(ElasticHingeModel, SaysThatThePapersGuideIsNoDesign) {
    ElasticHingeModel model;
    EXPECT_EQ(model.verdict().severity, Severity::warning);
    EXPECT_TRUE(verdictOf(model).contains(QStringLiteral("0.018\u00A0mm")))
        << verdictOf(model).toStdString();
    model.edit(QStringLiteral("c"), [](auto& input) {
        input.spring->stiffness = 3e5;
        input.roller_radius = 5e-3;
    });
    EXPECT_EQ(model.verdict().severity, Severity::good);
    model.edit(QStringLiteral("sign"),
               [](auto& input) { input.guide_sign = GuideSign::as_printed; });
    EXPECT_EQ(model.verdict().severity, Severity::warning);
    EXPECT_TRUE(verdictOf(model).contains(QStringLiteral("printed in the paper")));
    model.edit(QStringLiteral("roller"), [](auto& input) {
        input.spring = elastic_hinge::Spring{23e3, 0.06, 0.012};
        input.guide_sign = GuideSign::energy;
        input.roller_radius = 0.2;
    });
    EXPECT_EQ(model.verdict().severity, Severity::error);
    EXPECT_TRUE(verdictOf(model).contains(QStringLiteral("undercut")));
}

TEST(ElasticHingeModel, TooLittlePreloadIsCorrected) {
    for (const double radius : {0.0995, 0.1005}) {
        ElasticHingeModel model;
        model.edit(QStringLiteral("rho"),
                   [&](auto& input) { input.spring->guide_radius_at_zero = radius; });
        EXPECT_EQ(model.verdict().severity, Severity::error);
        EXPECT_TRUE(verdictOf(model).contains(QStringLiteral("0.6001")))
            << verdictOf(model).toStdString();
        EXPECT_TRUE(verdictOf(model).contains(QStringLiteral("28801.8")))
            << verdictOf(model).toStdString();
        model.takeMinimumPreload();
        EXPECT_TRUE(model.result().crank_guide.feasible);
        EXPECT_NEAR(model.result().crank_guide.preload, 0.6505e-3, 1e-6);
        EXPECT_EQ(model.result().crank_guide.branch == elastic_hinge::Branch::compressed,
                  radius < 0.1);
        // There is nothing more to mend.
        const Json corrected = model.inputJson();
        model.takeMinimumPreload();
        EXPECT_EQ(model.inputJson(), corrected);
    }
}

TEST(ElasticHingeModel, TakesOverNoGuideThatIsNotFound) {
    ElasticHingeModel model;
    model.takeProposal();
    EXPECT_TRUE(verdictOf(model).contains(QStringLiteral("roller radius is 0")));
    model.edit(QStringLiteral("roller"), [](auto& input) { input.roller_radius = 5e-3; });
    EXPECT_EQ(model.verdict().severity, Severity::good) << verdictOf(model).toStdString();
    model.edit(QStringLiteral("wish"), [](auto& input) {
        input.guide_search = elastic_hinge::GuideWish{1e-3, 0.05, {}};
    });
    EXPECT_FALSE(model.proposal().found);
    EXPECT_TRUE(model.proposalText().contains(QStringLiteral("at least")));
    const Json before = model.inputJson();
    model.takeProposal();
    EXPECT_EQ(model.inputJson(), before);
}

TEST(ElasticHingeModel, MotionsComeFromTheWorkerThread) {
    ElasticHingeModel model;
    waitForMotions(model);
    EXPECT_LT(model.motions()->both->ripple, 1e-8);
    EXPECT_NEAR(model.motions()->offSpeed, 120.0, 1e-9);
    EXPECT_GT(model.motions()->offDesign->ripple, 0.1);
    EXPECT_EQ(model.motionsText().count(QLatin1Char('\n')), 3);

    // The printed sign: the crank turns back.
    model.edit(QStringLiteral("sign"),
               [](auto& input) { input.guide_sign = GuideSign::as_printed; });
    waitForMotions(model);
    EXPECT_EQ(model.motions()->crank->end, elastic_hinge::MotionEnd::reversed);
    EXPECT_TRUE(model.motionsText().contains(QStringLiteral("reverses")));
    bool reported = false;
    for (const ResultRow& row : model.quantities().rows) {
        reported = reported || row[1] == QStringLiteral("reverses");
    }
    EXPECT_TRUE(reported);

    // Where the guide does not exist only the bare mechanism moves.
    model.edit(QStringLiteral("rho"), [](auto& input) {
        input.guide_sign = GuideSign::energy;
        input.spring->guide_radius_at_zero = 0.0999;
    });
    waitForMotions(model);
    EXPECT_TRUE(model.motions()->without.has_value());
    EXPECT_FALSE(model.motions()->crank.has_value());
    EXPECT_EQ(model.animatedMotion(), nullptr);
}

TEST(ElasticHingeModel, ThePictureFollowsTheMotion) {
    ElasticHingeModel model;
    waitForMotions(model);
    model.setAnimated(ElasticHingeModel::Animated::WithoutHinge);
    const auto* motion = model.animatedMotion();
    ASSERT_NE(motion, nullptr);
    const double time = 0.37 * motion->time.back();
    model.setMotionTime(time);
    EXPECT_NEAR(std::remainder(model.crank()->degrees() - motion->angle_at(time) / degree, 360.0),
                0.0, 1e-9);
    EXPECT_NEAR(model.shownSpeed(), motion->speed_at(time), 1e-12);
    EXPECT_GT(std::abs(model.shownSpeed() - 100.0), 1.0);
    // Where it was left it stays in another motion, and comes back to it from one that stops.
    const double left = motion->angle_at(time);
    for (const double speed : {200.0, 1.2, 300.0}) {
        model.edit(QStringLiteral("speed"),
                   [speed](elastic_hinge::Input& input) { input.angular_speed = speed; });
        waitForMotions(model);
        const auto* now = model.animatedMotion();
        ASSERT_NE(now, nullptr);
        EXPECT_NEAR(std::remainder(model.crank()->degrees() - left / degree, 360.0), 0.0, 1e-9);
        EXPECT_EQ(model.motionTime().has_value(), speed > 2.0) << speed;
        if (model.motionTime()) {
            EXPECT_NEAR(now->angle_at(*model.motionTime()), left, 1e-9) << speed;
            EXPECT_NEAR(model.shownSpeed(), now->speed_at(*now->time_at(left)), 1e-9);
        }
    }
    model.edit(QStringLiteral("speed"), [](auto& input) { input.angular_speed = 100.0; });
    waitForMotions(model);
    model.crank()->turnTo(model.crank()->degrees() + 1.0);
    EXPECT_EQ(model.shownSpeed(), 100.0);
}

TEST(ElasticHingeModel, ExaggerationIsChosenByTheRelief) {
    ElasticHingeModel model;
    EXPECT_EQ(model.exaggeration(), 500.0);
    model.edit(QStringLiteral("c"), [](auto& input) {
        input.spring->stiffness = 3e5;
        input.roller_radius = 5e-3;
    });
    EXPECT_EQ(model.exaggeration(), 10.0);
    model.edit(QStringLiteral("rho"),
               [](auto& input) { input.spring->guide_radius_at_zero = 0.0999; });
    EXPECT_EQ(model.exaggeration(), 1.0);
}

TEST(ElasticHingeModel, TheTableIsOfTheGuideThatIsShown) {
    ElasticHingeModel model;
    model.edit(QStringLiteral("c"), [](auto& input) {
        input.spring->stiffness = 3e5;
        input.rod_hinge_spring = elastic_hinge::Spring{2e5, 0.2, 0.08};
    });
    for (const Hinge hinge : {Hinge::rod, Hinge::crank_with_rod, Hinge::crank}) {
        model.setShownHinge(hinge);
        const ResultRow relief = model.quantities().rows.front();
        EXPECT_TRUE(relief[0].text.contains(model.shownHingeName()))
            << relief[0].text.toStdString();
        ASSERT_NE(relief[1].number(), nullptr);
        EXPECT_DOUBLE_EQ(relief[1].number()->value, model.guideOf(hinge).relief * 1e3);
        EXPECT_TRUE(std::get<Figure>(model.part("guides")).title.contains(model.shownHingeName()));
    }
}

TEST(ElasticHingeModel, TheVerdictNamesGuidesAsTheListDoes) {
    ElasticHingeModel model;
    model.edit(QStringLiteral("rod hinge"), [](auto& input) {
        input.rod_hinge_spring = elastic_hinge::Spring{2e5, 0.2, 0.0999};
    });
    const QString verdict = messageText(model.verdict().text);
    const QString listed = ElasticHingeModel::hingeNames().last();
    EXPECT_TRUE(verdict.contains(listed.section(QStringLiteral(" ("), 0, 0) + u':'))
        << verdict.toStdString();
}

TEST(ElasticHingeModel, TablesHoldNoEmptyCellsWhateverTheInput) {
    ElasticHingeModel model;
    const auto check = [&] {
        for (const ResultRow& row : model.quantities().rows) {
            ASSERT_EQ(row.size(), model.quantities().columns.size());
            for (const QString& cell : row) {
                EXPECT_FALSE(cell.isEmpty());
                EXPECT_FALSE(cell.contains(QStringLiteral("nan"), Qt::CaseInsensitive));
                EXPECT_FALSE(cell.contains(QStringLiteral("inf"), Qt::CaseInsensitive));
            }
        }
        EXPECT_FALSE(model.verdict().text.empty());
        EXPECT_FALSE(model.proposalText().isEmpty());
    };
    check();
    model.edit(QStringLiteral("series"), [](auto& input) {
        input.kinematics = Kinematics::series;
        input.lambda = 1.0;
    });
    check();
    EXPECT_TRUE(verdictOf(model).contains(QStringLiteral("locks")));
    model.edit(QStringLiteral("counterweight"), [](auto& input) {
        input = elastic_hinge::preset_zotov();
        input.rod_counterweight = RodCounterweight{0.1, {}, CounterweightInertia::as_printed};
    });
    check();
    EXPECT_TRUE(verdictOf(model).contains(QStringLiteral("(9)")));
    model.edit(QStringLiteral("no spring"), [](auto& input) { input.spring.reset(); });
    check();
    model.edit(QStringLiteral("nothing moves"), [](auto& input) {
        input.masses_as_weights = false;
        input.gravity = 0.0;
        input.angular_speed = 0.0;
        input.spring = elastic_hinge::Spring{1e5, 0.2, 0.09};
    });
    check();
}

}  // namespace
}  // namespace ravnoves
