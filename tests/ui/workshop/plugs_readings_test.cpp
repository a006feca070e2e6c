// The readings of the balancing machine in a job with plugs.

#include <QPushButton>
#include <QSettings>
#include <QTabBar>

#include "plugs_page_test.h"
#include "shop/model/verdict.h"
#include "theme/theme.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class PlugReadingsTest : public PlugsPageTest {
  protected:
    /// A job whose bob weight is known, both planes read.
    void read(const QString& front, const QString& rear) {
        model->loadInput(repairJob(), {});
        type("grade_mm_s", u"16"_s);
        type("rotor_mass_kg", u"30"_s);
        type("service_speed_rpm", u"3200"_s);
        type("unbalance_1", front);
        type("unbalance_2", rear);
    }
    QStringList verdicts() const {
        const ResultRow row = model->planeResults().rows.constLast();
        return {row.at(1).text, row.at(2).text};
    }
    QString journalled() {
        press(Qt::Key_F2);
        return model->desk()->journal()->job(model->desk()->jobId())->verdict;
    }
    QString doubted() {
        EXPECT_EQ(verdicts(), QStringList(2, u"another bob weight"_s));
        EXPECT_TRUE(field("unbalance_1")->isDoubtful());
        EXPECT_EQ(page.sheets()->tabBar()->tabTextColor(Machine), Theme::instance().warning());
        return Words().message(model->verdictShown()->text);
    }
};

TEST_F(PlugReadingsTest, AreJudgedByWhatMayRemain) {
    type("customer", u"Smith"_s);
    type("unbalance_1", u"4.9"_s);
    type("unbalance_2", u"5.1"_s);
    EXPECT_FALSE(verdicts().contains(u"PASS"_s)) << "no limit says so";
    // 1000 · 30 · 16 / (3200 π/30) / 2 = 716.2 g·mm
    read(u"700"_s, u"720"_s);
    EXPECT_EQ(verdicts(), (QStringList{u"PASS"_s, u"FAIL"_s}));
    EXPECT_TRUE(label("limits").contains(u"716.2"_s)) << qPrintable(label("limits"));
    type("engine_number", u"1"_s);
    EXPECT_EQ(journalled(), u"fails"_s);
    type("unbalance_2", u"710"_s);
    EXPECT_EQ(journalled(), u"passes"_s);
}

TEST_F(PlugReadingsTest, TheLimitOfThePlugsIsThePapersTheJobsOrTheShops) {
    EXPECT_TRUE(label("tolerance_owner").contains(u"Nazarov"_s));
    type("tolerance_g_mm", u"1440"_s);
    EXPECT_TRUE(label("tolerance_owner").contains(u"for this job only"_s));
    auto* keep = find<QPushButton>("keep_tolerance");
    show(Parts);
    keep->setFocus();
    QTest::keyClick(keep, Qt::Key_Space);
    EXPECT_TRUE(label("tolerance_owner").contains(u"Shop limit"_s));
    EXPECT_FALSE(keep->isVisible());
    PlugsModel next(model->desk()->journal()->path());
    EXPECT_NEAR(next.input().plugs->tolerance, 1440e-6, 1e-12);
    EXPECT_EQ(PlugsModel().input().plugs->tolerance, v8_plugs::default_tolerance);
    QSettings().remove(u"workshop/tolerance_g_mm"_s);
}

TEST_F(PlugReadingsTest, HoldForTheirBobWeightAlone) {
    read(u"4"_s, u"3"_s);
    EXPECT_EQ(verdicts(), (QStringList{u"PASS"_s, u"PASS"_s}));
    auto* hold = find<QPushButton>("readings_hold");
    EXPECT_FALSE(hold->isVisible());
    type("reciprocating_mass_g", u"1010"_s);
    const QString why = u"The readings were taken with another bob weight: "_s;
    EXPECT_TRUE(doubted().contains(why)) << qPrintable(doubted());
    type("engine_number", u"1"_s);
    EXPECT_EQ(journalled(), otherBobWeight);
    EXPECT_TRUE(card().contains(u"with another bob weight"_s));
    // A page made anew shows it, too.
    WorkshopPage again(QString(), nullptr);
    again.viewModel()->loadInput(model->inputJson(), {});
    EXPECT_EQ(again.sheets()->tabBar()->tabTextColor(Machine), Theme::instance().warning());
    // One plane read again is not both.
    type("unbalance_1", u"4.5"_s);
    EXPECT_TRUE(model->withheld().verdict);
    type("unbalance_2", u"3.5"_s);
    EXPECT_FALSE(model->withheld().any());
    model->history()->undo();
    show(Machine);
    ASSERT_TRUE(hold->isVisible());
    QTest::mouseClick(hold, Qt::LeftButton);
    EXPECT_FALSE(hold->isVisible());
    EXPECT_EQ(verdicts(), (QStringList{u"PASS"_s, u"PASS"_s}));
}

}  // namespace
}  // namespace ravnoves
