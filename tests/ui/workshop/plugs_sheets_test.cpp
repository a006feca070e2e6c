// The sheets of the page: their fields, the way through them and what they reject.

#include <QComboBox>
#include <QDate>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QToolTip>
#include <map>

#include "job_page_test.h"
#include "model/case_document.h"
#include "shop/scale_input.h"
#include "v8-plugs/presets.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace v8_plugs;

using units::gram;

class PlugsSheetsTest : public PlugsPageTest {
  protected:
    /// It is not of the other form, with plugs or without.
    bool isThere(const QWidget* field) const {
        for (int sheet = 0; sheet < sheets->count(); ++sheet) {
            if (sheets->widget(sheet)->isAncestorOf(field)) {
                return field->isVisibleTo(sheets->widget(sheet));
            }
        }
        return false;
    }
};

TEST_F(PlugsSheetsTest, NothingTypedIntoTheHeadIsIgnoredInSilence) {
    const std::pair<const char*, int> texts[] = {{"engine_number", 80},
                                                 {"crankshaft_number", 80},
                                                 {"customer", 80},
                                                 {"technician", 80},
                                                 {"notes", 1000}};
    for (const auto& [name, longest] : texts) {
        auto* field = find<EntryField>(name);
        type(field, QString(longest, u'n'));
        EXPECT_EQ(field->trouble(), QString()) << name;
        field->selectAll();
        QApplication::clipboard()->setText(QString(longest + 1, u'n'));
        QTest::keyClick(field, Qt::Key_V, Qt::ControlModifier);
        EXPECT_EQ(QToolTip::text(), u"Cut: at most %1 characters."_s.arg(longest)) << name;
        EXPECT_EQ(field->text().size(), longest);
        QTest::keyClick(field, Qt::Key_Return);
    }
    EXPECT_EQ(model->input().job.notes, std::string(1000, 'n'));
    // What a file brings is shown whole.
    model->edit(u"notes"_s, [](auto& input) { input.job.notes = std::string(1500, 'f'); });
    EXPECT_EQ(find<EntryField>("notes")->text().size(), 1500);
}

TEST_F(PlugsSheetsTest, EnterGoesDownTheSheetsAndOn) {
    sheets->setCurrentIndex(0);
    fieldsOf(0).constFirst()->setFocus();
    QList<QWidget*> visited;
    for (int step = 0;
         step < 250 && (visited.isEmpty() || QApplication::focusWidget() != visited.constLast());
         ++step) {
        visited << QApplication::focusWidget();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    }
    QList<QWidget*> expected;
    for (int sheet = 0; sheet < sheets->count(); ++sheet) {
        bool isBegun = sheet == 0;
        for (QWidget* each : fieldsOf(sheet)) {
            // A sheet is entered at a field: a list or a tick would take the next key for a choice.
            const bool isOpen = each->isEnabled() && isThere(each);
            // What is typed once is not between what is weighed.
            const bool isPassed =
                isBegun && isTypedAlone(each) && !isTypedAlone(expected.constLast());
            isBegun = isBegun || (isOpen && qobject_cast<EntryField*>(each) != nullptr);
            if (isOpen && isBegun && !isPassed) {
                expected << each;
            }
        }
    }
    EXPECT_EQ(visited, expected);
    EXPECT_GT(visited.size(), 80);
    // The last sheet is not left.
    EXPECT_EQ(sheets->currentIndex(), sheets->count() - 1);
    EXPECT_EQ(QApplication::focusWidget(), expected.constLast());
}

TEST_F(PlugsSheetsTest, TabGoesDownASheetAndAlongTheRowsOfItsGrid) {
    for (int sheet = 0; sheet < sheets->count(); ++sheet) {
        sheets->setCurrentIndex(sheet);
        QList<QWidget*> expected;
        for (QWidget* each : fieldsOf(sheet)) {
            if (each->isEnabled() && isThere(each)) {
                expected << each;
            }
        }
        // The fields of its grids lie beside each other.
        const auto cell = [](const QWidget* field) {
            static const QRegularExpression grid(
                u"^(mass_|nominal_|spread_|(position|radius|read_at|from|to)_\\d)"_s);
            return grid.match(field->objectName()).hasMatch();
        };
        const auto first = std::find_if(expected.begin(), expected.end(), cell);
        const auto last = std::find_if_not(first, expected.end(), cell);
        std::stable_sort(first, last, [&](const QWidget* a, const QWidget* b) {
            return a->mapTo(&page, QPoint()).y() < b->mapTo(&page, QPoint()).y();
        });
        expected.constFirst()->setFocus();
        for (QWidget* each : expected) {
            EXPECT_EQ(QApplication::focusWidget(), each)
                << sheet << " " << qPrintable(each->objectName());
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
    }
}

TEST_F(PlugsSheetsTest, ArrowsGoFromCellToCell) {
    show(WeighInTab);
    const auto press = [](Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); };
    const auto at = [] { return QApplication::focusWidget()->objectName(); };
    field("mass_piston_2")->setFocus(Qt::TabFocusReason);
    press(Qt::Key_Right);
    EXPECT_EQ(at(), u"mass_pin_2"_s);
    press(Qt::Key_Down);
    EXPECT_EQ(at(), u"mass_pin_3"_s);
    QTest::keyClicks(QApplication::focusWidget(), u"12.5"_s);
    press(Qt::Key_Left);
    EXPECT_EQ(at(), u"mass_pin_3"_s) << "the cursor moves in what is typed";
    press(Qt::Key_Home);
    press(Qt::Key_Left);
    EXPECT_EQ(at(), u"mass_piston_3"_s);
    EXPECT_EQ(field("mass_pin_3")->value(), 12.5);
    press(Qt::Key_Right);
    EXPECT_EQ(field("mass_pin_3")->selectedText(), field("mass_pin_3")->text());
    press(Qt::Key_Up);
    EXPECT_EQ(at(), u"mass_pin_2"_s);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_EQ(at(), u"mass_piston_2"_s);
    for (int step = 0; step < 6; ++step) {
        press(Qt::Key_Up);
    }
    EXPECT_EQ(at(), u"nominal_piston"_s);
}

TEST_F(PlugsSheetsTest, TheLimitOfThePlugsIsThePapersTheJobsOrTheShops) {
    EXPECT_TRUE(label("tolerance_owner").contains(u"Nazarov"_s));
    type("tolerance_g_mm", u"1440"_s);
    EXPECT_TRUE(label("tolerance_owner").contains(u"for this job only"_s));
    keys("keep_tolerance", {Qt::Key_Space});
    EXPECT_TRUE(label("tolerance_owner").contains(u"Shop limit"_s));
    EXPECT_FALSE(find<QPushButton>("keep_tolerance")->isVisible());
    PlugsModel next(model->desk()->journal()->path());
    EXPECT_NEAR(next.input().plugs->tolerance, 1440e-6, 1e-12);
    EXPECT_EQ(PlugsModel().input().plugs->tolerance, v8_plugs::default_tolerance);
    QSettings().remove(u"workshop/tolerance_g_mm"_s);
}

TEST_F(PlugsSheetsTest, PlugsThatComeBackHaveTheirValues) {
    const char* there = "has_new_plug";
    const auto toggle = [&] { keys(there, {Qt::Key_Space}); };
    toggle();
    EXPECT_FALSE(find<QComboBox>("crankshaft")->isEnabled());
    EXPECT_FALSE(field("new_plug_radius_mm")->isEnabled());
    EXPECT_FALSE(model->plugs()->option(OptionId::new_steel_to_steel));
    toggle();
    EXPECT_EQ(model->input().plugs->engine, engine_presets().front());
    there = "has_aluminium_plug";
    toggle();
    EXPECT_FALSE(model->input().plugs->engine.has_aluminium_plug);
    EXPECT_EQ(model->input().plugs->engine.aluminium_plug_mass, std::nullopt);
    toggle();
    EXPECT_EQ(model->input().plugs->engine, engine_presets().front());
    // What was typed is brought back by undo; those of a case that has none are the paper's.
    type("aluminium_plug_mass_g", u"1.2"_s);
    toggle();
    model->history()->undo();
    EXPECT_EQ(model->input().plugs->engine.aluminium_plug_mass, 1.2 * gram);
    // The engine that there is changes nothing when it is chosen.
    auto* engines = find<QComboBox>("engine");
    Q_EMIT engines->activated(engines->currentIndex());
    EXPECT_EQ(model->input().plugs->engine.aluminium_plug_mass, 1.2 * gram);
    toggle();
    model->loadCase(model->inputJson(), {}, {});
    toggle();
    EXPECT_EQ(model->input().plugs->engine, engine_presets().front());
}

TEST_F(PlugsSheetsTest, APresetBeginsAJobOfToday) {
    const Json plugs = parse_json(R"({
        "engine": {"type": "v", "cylinders": 8, "bank_angle_deg": 90}, "plugs": {"engine": "6 l"}})");
    model->editPlugs({}, [](auto& input) { input.tolerance = 7.0 * units::gram_mm; });
    model->keepTolerance();  // the shop's
    CaseDocument document(model);
    document.begin({"workshop", "V-8 of 6 litres", plugs});
    EXPECT_DOUBLE_EQ(model->input().plugs->tolerance, 7.0 * units::gram_mm);
    EXPECT_EQ(QString::fromStdString(model->input().job.date),
              QDate::currentDate().toString(Qt::ISODate));
    EXPECT_FALSE(document.needsSaving());
    // A job that has its day keeps it, a case its limit, and what is opened is as it was.
    Json dated = model->inputJson();
    dated["job"]["date"] = "2020-02-02";
    document.begin({"workshop", "V-8 of 6 litres", dated});
    EXPECT_EQ(model->input().job.date, "2020-02-02");
    dated["job"]["date"] = "";
    dated["plugs"]["tolerance_g_mm"] = 3;
    document.begin({"workshop", "V-8 of 6 litres", dated});
    EXPECT_DOUBLE_EQ(model->input().plugs->tolerance, 3.0 * units::gram_mm);
    document.open({"workshop", "V-8 of 6 litres", plugs}, folder.filePath(u"a.case.json"_s));
    EXPECT_EQ(model->input().job.date, "");
    QSettings().remove(u"workshop/tolerance_g_mm"_s);
}

TEST_F(PlugsSheetsTest, EmptiedFieldTakesTheNextDigitsAlone) {
    // What an empty field means (0, 5 g·mm, 7850 kg/m³) must not join what is typed next.
    const struct {
        const char* name;
        const char* typed;
        double usual;
    } cases[] = {{"tolerance_g_mm", "3", 5.0},
                 {"rod_big_end", "1.5", 0.0},
                 {"steel_density_kg_m3", "7900", 7850.0},
                 {"front_share", "0.4", 0.5}};
    for (const auto& each : cases) {
        NumberField* target = field(each.name);
        type(target, QLatin1String(each.typed));
        target->setFocus();
        QTest::keyClick(target, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(target, Qt::Key_Delete);
        EXPECT_TRUE(target->text().isEmpty()) << each.name;
        QTest::keyClicks(target, QLatin1String(each.typed));
        EXPECT_EQ(target->text(), QLatin1String(each.typed)) << each.name;
        EXPECT_NEAR(target->value().value(), QString::fromLatin1(each.typed).toDouble(), 1e-12);
        // Left empty it shows what counts.
        QTest::keyClick(target, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(target, Qt::Key_Delete);
        QTest::keyClick(target, Qt::Key_Return);
        EXPECT_NEAR(target->value().value(), each.usual, 1e-12) << each.name;
        EXPECT_FALSE(target->text().isEmpty()) << each.name;
    }
}

TEST_F(PlugsSheetsTest, FieldsStayWhereTheyAreWhileOneTypes) {
    // Those above and itself; a line may come below them.
    const auto places = [&](int sheet) {
        QList<QPoint> points;
        for (QWidget* each : fieldsOf(sheet)) {
            points << each->mapTo(each->window(), QPoint());
            if (each == QApplication::focusWidget()) {
                break;
            }
        }
        return points;
    };
    const std::map<const char*, const char*> typed{
        {"tolerance_g_mm", "1440"}, {"repair_bearing", "3"}, {"steel_plug_mass_g", "22.5"},
        {"mass_pin_4", "0.151"},    {"grade_mm_s", "16"},    {"unbalance_2", "9"}};
    for (const auto& [name, text] : typed) {
        int sheet = 0;
        while (!fieldsOf(sheet).contains(find<QWidget>(name))) {
            ++sheet;
        }
        sheets->setCurrentIndex(sheet);
        find<QWidget>(name)->setFocus();
        QTest::keyClick(find<QWidget>(name), Qt::Key_A, Qt::ControlModifier);
        QApplication::processEvents();
        const auto before = places(sheet);
        QTest::keyClicks(find<QWidget>(name), QString::fromLatin1(text));
        QApplication::processEvents();
        QApplication::processEvents();
        EXPECT_EQ(places(sheet), before) << name;
    }
}

TEST_F(PlugsPageTest, EngineBringsItsPlugAndItsOwnSheets) {
    type("customer", u"Smith"_s);
    fill({{"height_mm", "9.5"},
          {"bore_diameter_mm", "12"},
          {"bore_depth_mm", "5"},
          {"cutter_diameter_mm", "14"},
          {"nominal_piston", "600"},
          {"spread_piston", "2"},
          {"mass_piston_1", "601"}});
    // Kept with the job, and found by the engine's name.
    const PlugSheet plug = model->input().plugs->plug.value();
    type("engine_name", u"Kept"_s);
    EXPECT_EQ(find<QComboBox>("engine")->placeholderText(), u"Kept"_s);
    save();
    ASSERT_EQ(model->desk()->journal()->search({.text = u"kept"_s}).size(), 1);
    const qint64 kept = model->desk()->jobId();
    keys("engine", {Qt::Key_Home, Qt::Key_Down});
    EXPECT_EQ(model->input().plugs->preset, "6 l");
    EXPECT_EQ(field("height_mm")->value(), 11.0) << "another engine's plug stays";
    EXPECT_FALSE(field("bore_diameter_mm")->value());
    EXPECT_EQ(field("cutter_diameter_mm")->value(), 14.0) << "the cutter is the shop's";
    EXPECT_FALSE(field("nominal_piston")->value());
    EXPECT_EQ(field("mass_piston_1")->value(), 601.0) << "what the scale said stays";
    EXPECT_EQ(find<QLineEdit>("engine_name")->text(), QString());
    EXPECT_EQ(model->desk()->openJob(kept, true), QString());
    EXPECT_EQ(model->input().plugs->engine.name, "Kept");
    EXPECT_EQ(model->input().plugs->plug, plug);
    EXPECT_EQ(field("nominal_piston")->value(), 600.0);
    EXPECT_EQ(field("spread_piston")->value(), 2.0);
    EXPECT_FALSE(field("mass_piston_1")->value());
    fill({{"customer", "Jones"}, {"mass_piston_1", "602"}});
    // The next job keeps what is the engine's.
    fill({{"grade_mm_s", "16"},
          {"rotor_mass_kg", "30"},
          {"service_speed_rpm", "3200"},
          {"unbalance_1", "100"}});
    press(Qt::Key_F2);
    press(Qt::Key_F4);
    EXPECT_EQ(model->input().plugs->plug, plug);
    EXPECT_EQ(field("nominal_piston")->value(), 600.0);
    EXPECT_FALSE(field("mass_piston_1")->value());
    EXPECT_EQ(field("grade_mm_s")->value(), 16.0);
    EXPECT_FALSE(field("unbalance_1")->value());
}

}  // namespace
}  // namespace ravnoves
