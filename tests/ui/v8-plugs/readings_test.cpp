// The readings of the balancing machine.

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QTabBar>
#include <QTabWidget>

#include "case-file/case_file.h"
#include "theme/theme.h"
#include "v8-plugs/page_test.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace v8_plugs;

using units::gram;

TEST_F(V8PageTest, ReadingsAreJudgedByTheToleranceAloneAndBothLimitsAreExplained) {
    type("customer", u"Smith"_s);
    const auto verdicts = [&] {
        const auto rows = model->planeResults().rows;
        return QStringList{rows.at(0).constLast(), rows.at(1).constLast()};
    };
    type("front_reading_g_mm", u"4.9"_s);
    type("rear_reading_g_mm", u"5.1"_s);
    EXPECT_EQ(verdicts(), (QStringList{u"✓ passes"_s, u"✗ fails"_s}));
    EXPECT_TRUE(label("machine_limits").contains(u"Nazarov"_s));
    EXPECT_TRUE(label("machine_limits").contains(u"Readings are judged by it"_s));
    type("grade_mm_s", u"16"_s);
    type("rotor_mass_kg", u"30"_s);
    type("service_speed_rpm", u"3200"_s);
    // 1000 · 30 · 16 / (3200 π/30) / 2 = 716.2 g·mm, 143 times 5.
    EXPECT_EQ(verdicts(), (QStringList{u"✓ passes"_s, u"✓ passes"_s}));
    EXPECT_TRUE(label("machine_limits").contains(u"in front 143 times as much"_s))
        << qPrintable(label("machine_limits"));
    press(Qt::Key_F2);
    EXPECT_EQ(model->desk()->journal()->job(model->desk()->jobId())->verdict, u"passes"_s);
    // A shop sets its own limit once.
    EXPECT_TRUE(label("tolerance_owner").contains(u"Nazarov"_s));
    type("tolerance_g_mm", u"1440"_s);
    EXPECT_TRUE(label("tolerance_owner").contains(u"for this job alone"_s));
    auto* keep = find<QPushButton>("keep_tolerance");
    page.sheets()->setCurrentIndex(0);
    keep->setFocus();
    QTest::keyClick(keep, Qt::Key_Space);
    EXPECT_TRUE(label("tolerance_owner").contains(u"the shop's own"_s));
    EXPECT_FALSE(keep->isVisible());
    V8PlugsModel next(model->desk()->journal()->path());
    EXPECT_NEAR(next.input().tolerance, 1440e-6, 1e-12);
    V8PlugsModel picture({});
    EXPECT_EQ(picture.input().tolerance, default_tolerance);
    QSettings().remove(u"workshop/tolerance_g_mm"_s);
}

TEST_F(V8PageTest, ReadingsHoldForTheirBobWeightAlone) {
    QFile example(QStringLiteral(RAVNOVES_EXAMPLES "/v8-4.25-repair.case.json"));
    ASSERT_TRUE(example.open(QIODevice::ReadOnly));
    model->loadInput(parse_json(example.readAll().toStdString()).at("input"), {});
    ASSERT_TRUE(model->solution().hung());
    type("front_reading_g_mm", u"4"_s);
    type("rear_reading_g_mm", u"3"_s);
    EXPECT_EQ(model->planeResults().rows.at(0).constLast(), u"✓ passes"_s);
    auto* hold = find<QPushButton>("readings_hold");
    EXPECT_FALSE(hold->isVisible());
    const double then = *model->solution().hung();
    type("reciprocating_mass_g", u"1010"_s);
    ASSERT_GT(std::abs(*model->solution().hung() - then), 0.1 * gram);
    EXPECT_EQ(model->planeResults().rows.at(0).constLast(), u"another bob weight"_s);
    EXPECT_TRUE(field("front_reading_g_mm")->isDoubtful());
    EXPECT_EQ(page.sheets()->tabBar()->tabTextColor(4), Theme::instance().warning());
    const QString why = u"The readings were taken with another bob weight: "_s;
    EXPECT_TRUE(label("troubles").contains(why)) << qPrintable(label("troubles"));
    type("engine_number", u"1"_s);
    press(Qt::Key_F2);
    EXPECT_EQ(model->desk()->journal()->job(model->desk()->jobId())->verdict,
              u"other-bob-weight"_s);
    const QString file = QDir(folder.path()).filePath(u"other.pdf"_s);
    EXPECT_EQ(page.writeCard(file), QString());
    QProcess reader;
    reader.start(QStringLiteral(PDFTOTEXT), {u"-layout"_s, file, u"-"_s});
    EXPECT_TRUE(reader.waitForFinished());
    const QString printed = QString::fromUtf8(reader.readAllStandardOutput());
    EXPECT_TRUE(printed.contains(u"taken with another bob weight"_s)) << qPrintable(printed);
    // One plane read again is not both.
    type("front_reading_g_mm", u"4.5"_s);
    EXPECT_TRUE(label("troubles").contains(why));
    type("rear_reading_g_mm", u"3.5"_s);
    EXPECT_FALSE(label("troubles").contains(why));
    model->history()->undo();
    page.sheets()->setCurrentIndex(4);
    ASSERT_TRUE(hold->isVisible());
    QTest::mouseClick(hold, Qt::LeftButton);
    EXPECT_FALSE(hold->isVisible());
    EXPECT_EQ(model->planeResults().rows.at(1).constLast(), u"✓ passes"_s);
}

TEST_F(V8PageTest, ReadingsOfAnotherCrankshaftAreAmber) {
    QFile example(QStringLiteral(RAVNOVES_EXAMPLES "/v8-4.25-repair.case.json"));
    ASSERT_TRUE(example.open(QIODevice::ReadOnly));
    model->loadInput(parse_json(example.readAll().toStdString()).at("input"), {});
    type("front_reading_g_mm", u"4"_s);
    type("rear_reading_g_mm", u"3"_s);
    type("crankshaft_number", u"A-1"_s);
    EXPECT_EQ(model->planeResults().rows.at(0).constLast(), u"✓ passes"_s)
        << "a number that comes later";
    type("crankshaft_number", u"B-2"_s);
    EXPECT_EQ(model->planeResults().rows.at(0).constLast(), u"another crankshaft"_s);
    EXPECT_TRUE(field("front_reading_g_mm")->isDoubtful());
    EXPECT_EQ(page.sheets()->tabBar()->tabTextColor(4), Theme::instance().warning());
    const QString why = u"The readings are of another crankshaft: number "_s;
    EXPECT_TRUE(label("troubles").contains(why)) << qPrintable(label("troubles"));
    // A page made anew shows it, too.
    V8PlugsPage again(QString(), nullptr);
    again.viewModel()->loadInput(model->inputJson(), {});
    EXPECT_EQ(again.sheets()->tabBar()->tabTextColor(4), Theme::instance().warning());
    type("front_reading_g_mm", u"4.5"_s);
    EXPECT_TRUE(label("troubles").contains(why)) << "one plane read again is not both";
    type("rear_reading_g_mm", u"3.5"_s);
    EXPECT_FALSE(label("troubles").contains(why));
    type("engine_number", u"1"_s);
    EXPECT_FALSE(label("troubles").contains(u"another crankshaft"_s));
}

}  // namespace
}  // namespace ravnoves
