#include "v8-plugs/v8_plugs_page.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QInputDialog>
#include <QInputMethodEvent>
#include <QLabel>
#include <QMessageBox>
#include <QPainter>
#include <QPrintPreviewDialog>
#include <QPrintPreviewWidget>
#include <QPrinter>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSettings>
#include <QSignalSpy>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTabBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <QVBoxLayout>
#include <map>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "events.h"
#include "plot/plot_view.h"
#include "theme/theme.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/plugs_card.h"
#include "v8-plugs/presets.h"
#include "v8-plugs/scene.h"
#include "widgets/file_dialogs.h"
#include "widgets/number_field.h"
#include "widgets/result_table.h"
#include "workshop/checked_field.h"
#include "workshop/journal_dialog.h"
#include "workshop/shop_dialog.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace v8_plugs;

using units::gram;

class V8PageTest : public ::testing::Test {
  protected:
    V8PageTest() : page(QDir(folder.path()).filePath(u"journal.sqlite"_s), nullptr) {
        test::showAt(page, {1187, 712});
        page.activateWindow();
        model = page.viewModel();
        page.openJournal();
    }

    template <typename Widget>
    Widget* find(const char* name) {
        return test::named<Widget>(page, name);
    }
    NumberField* field(const char* name) { return find<NumberField>(name); }
    QString label(const char* name) {
        settle();
        return find<QLabel>(name)->text();
    }
    /// A placing that is looked for is found.
    void settle() {
        EXPECT_TRUE(QTest::qWaitFor([this] { return !model->isSearching(); }));
    }

    /// Types as a person does: goes to the field, types over what is there, presses Enter.
    void type(QWidget* target, const QString& text) {
        for (int sheet = 0; sheet < page.sheets()->count(); ++sheet) {
            if (page.fieldsOf(sheet).contains(target)) {
                page.sheets()->setCurrentIndex(sheet);
            }
        }
        target->setFocus();
        QTest::keyClick(target, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(target, text);
        QTest::keyClick(target, Qt::Key_Return);
    }
    void type(const char* name, const QString& text) { type(find<QWidget>(name), text); }

    /// A key that is an action's, wherever the focus is; what it saves is saved then.
    void press(Qt::Key key) {
        page.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
        QTest::keyClick(&page, key);
        ASSERT_TRUE(QTest::qWaitFor([this] { return !model->desk()->isWaiting(); }, 20'000));
    }

    /// Answers the next message box with a button.
    static void answer(QMessageBox::StandardButton button) {
        whenModal<QMessageBox>(
            [button](QMessageBox* box) { QTest::mouseClick(box->button(button), Qt::LeftButton); });
    }

    template <typename Dialog, typename Act>
    static void whenModal(Act act) {
        test::whenModal<Dialog>(qApp, act);
    }

    QTemporaryDir folder;
    V8PlugsPage page;
    V8PlugsModel* model = nullptr;
};

TEST_F(V8PageTest, AnswerIsAmberWhereTheNeglectedShiftMatters) {
    type("repair_piston_and_rings", u"4.3"_s);
    auto* advice = page.findChild<QLabel*>(u"advice"_s);
    const auto colour = [&] { return advice->palette().color(QPalette::WindowText); };
    EXPECT_EQ(colour(), Theme::instance().text());
    model->edit(u"plug"_s, [](Input& input) {
        input.plug.emplace();
        input.plug->thread = Thread{22e-3, 1.5e-3};
        input.plug->height = 14e-3;
        input.plug->cutter_diameter = 14e-3;
    });
    EXPECT_EQ(colour(), Theme::instance().warning());
    EXPECT_TRUE(label("advice").startsWith(u"Machine all 8 steel plugs by 1.82"_s))
        << qPrintable(label("advice"));
    EXPECT_TRUE(label("troubles").contains(u"Bore to"_s)) << qPrintable(label("troubles"));
    // Nothing below it says that all is well, and what is copied has the warning.
    EXPECT_FALSE(model->checkText().contains(u"balanced"_s)) << qPrintable(model->checkText());
    EXPECT_TRUE(model->optionResults().rows.at(0).constFirst().text.startsWith(u"! "_s));
    EXPECT_EQ(find<QLabel>("check")->palette().color(QPalette::WindowText),
              Theme::instance().warning());
    EXPECT_TRUE(model->optionResults().rows.at(0).tip.contains(u"By the method alone"_s));
    EXPECT_TRUE(page.resultsAsText().contains(u"Bore to"_s));
    model->edit(u"excess"_s, [](Input& input) {
        input.plug.reset();
        input.typed_changes.repair_piston_and_rings = 0.1;
    });
    EXPECT_EQ(colour(), Theme::instance().error());
}

TEST_F(V8PageTest, AnswerFollowsTyping) {
    type("rod_big_end", u"0,5"_s);
    type("repair_piston_and_rings", u"2"_s);
    type("repair_bearing", u"1.1"_s);
    EXPECT_EQ(label("advice"), u"Machine all 8 steel plugs by 1.83\u00A0g each."_s);
    EXPECT_TRUE(label("hang").startsWith(u"The bob weight still needs"_s));
    type("reciprocating_mass_g", u"1000"_s);
    type("rotating_mass_g", u"650"_s);
    type("oil_mass_g", u"20"_s);
    type("oil_coefficient", u"1"_s);
    EXPECT_EQ(label("hang"), u"Hang 2326.6\u00A0g on each crankpin."_s);
    // At every key, not only at Enter.
    page.sheets()->setCurrentIndex(0);
    NumberField* shells = field("repair_bearing");
    shells->setFocus();
    shells->selectAll();
    QTest::keyClicks(shells, u"2"_s);
    EXPECT_EQ(label("advice"),
              u"Replace all 8 plugs by aluminium ones lightened by 0.38\u00A0g each."_s);
    EXPECT_TRUE(page.resultsAsText().contains(u"5.222"_s)) << qPrintable(page.resultsAsText());
}

TEST_F(V8PageTest, EnterGoesDownTheSheetsAndOn) {
    page.sheets()->setCurrentIndex(0);
    page.fieldsOf(0).constFirst()->setFocus();
    QList<QWidget*> visited;
    for (int step = 0;
         step < 200 && (visited.isEmpty() || page.sheets()->currentIndex() != 0 ||
                        visited.size() < 5 || QApplication::focusWidget() != visited.constFirst());
         ++step) {
        visited << QApplication::focusWidget();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    }
    QList<QWidget*> expected;
    for (int sheet = 0; sheet < page.sheets()->count(); ++sheet) {
        for (QWidget* each : page.fieldsOf(sheet)) {
            if (each->isEnabled()) {
                expected << each;
            }
        }
    }
    EXPECT_EQ(visited, expected);
    EXPECT_GT(visited.size(), 90);
}

TEST_F(V8PageTest, TabGoesTheSameWayDownASheet) {
    for (int sheet = 0; sheet < page.sheets()->count(); ++sheet) {
        page.sheets()->setCurrentIndex(sheet);
        QList<QWidget*> expected;
        for (QWidget* each : page.fieldsOf(sheet)) {
            if (each->isEnabled()) {
                expected << each;
            }
        }
        expected.constFirst()->setFocus();
        for (QWidget* each : expected) {
            EXPECT_EQ(QApplication::focusWidget(), each)
                << sheet << " " << qPrintable(each->objectName());
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
    }
}

TEST_F(V8PageTest, EveryFieldIsLargeAndNamesItsUnit) {
    for (int sheet = 0; sheet < page.sheets()->count(); ++sheet) {
        for (QWidget* each : page.fieldsOf(sheet)) {
            const QString name = each->objectName();
            EXPECT_FALSE(name.isEmpty());
            EXPECT_GE(each->minimumHeight(), qobject_cast<QCheckBox*>(each) != nullptr ? 0
                                             : sheet == 2                              ? 30
                                                                                       : 34)
                << qPrintable(name);
        }
    }
    // Units stand in the accessible name of every quantity.
    EXPECT_EQ(field("crank_radius_mm")->accessibleName(), u"Crank radius r, mm"_s);
    EXPECT_EQ(field("mass_piston_3")->accessibleName(), u"Piston of cylinder 3, g"_s);
}

TEST_F(V8PageTest, MnemonicsOfASheetDiffer) {
    for (int sheet = 0; sheet < page.sheets()->count(); ++sheet) {
        page.sheets()->setCurrentIndex(sheet);
        QMap<QChar, QString> used;
        const auto note = [&](const QString& text) {
            const qsizetype at = text.indexOf(u'&');
            if (at < 0 || at + 1 >= text.size()) {
                return;
            }
            const QChar key = text.at(at + 1).toLower();
            EXPECT_FALSE(used.contains(key))
                << qPrintable(text) << " and " << qPrintable(used.value(key));
            used[key] = text;
        };
        for (QLabel* each : page.sheets()->currentWidget()->findChildren<QLabel*>()) {
            if (each->buddy() != nullptr) {
                note(each->text());
            }
        }
        for (QAbstractButton* each :
             page.sheets()->currentWidget()->findChildren<QAbstractButton*>()) {
            note(each->text());
        }
    }
}

TEST_F(V8PageTest, ImpossibleEntriesAreRefusedInWords) {
    const Json before = model->inputJson();
    for (const char* name :
         {"crank_radius_mm", "steel_plug_mass_g", "oil_mass_g", "height_mm", "cutter_diameter_mm",
          "grade_mm_s", "rotor_mass_kg", "front_reading_g_mm", "mass_piston_1", "nominal_rings",
          "tolerance_g_mm"}) {
        for (const QString& text : {u"-5"_s, u"1e300"_s, u"abc"_s, u"1.2.3"_s, u"nan"_s}) {
            type(name, text);
            EXPECT_FALSE(field(name)->trouble().isEmpty()) << name << " " << qPrintable(text);
            QTest::keyClick(field(name), Qt::Key_Escape);
        }
    }
    for (const char* name : {"piston", "rod_big_end"}) {
        type(name, u"1e9"_s);
        EXPECT_FALSE(field(name)->trouble().isEmpty()) << name;
        QTest::keyClick(field(name), Qt::Key_Escape);
    }
    auto* date = find<CheckedField>("date");
    type(date, u"31.02.2024"_s);
    EXPECT_TRUE(date->trouble().contains(u"no date"_s));
    auto* thread = find<CheckedField>("thread");
    type(thread, u"22"_s);
    EXPECT_TRUE(thread->trouble().contains(u"M22×1.5"_s));
    // What was valid on the way ("1" of "1e300") is undone.
    while (model->history()->canUndo()) {
        model->history()->undo();
    }
    EXPECT_EQ(model->inputJson(), before);
    type(date, u"31.5.24"_s);
    EXPECT_EQ(model->input().job.date, "2024-05-31");
    type(thread, u"m30×1,5"_s);
    EXPECT_NEAR(model->input().plug->thread->diameter, 0.03, 1e-12);
}

TEST_F(V8PageTest, EmptiedFieldTakesTheNextDigitsAlone) {
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

TEST_F(V8PageTest, RefusedEntryStaysUntilItIsMended) {
    type("engine_number", u"53"_s);
    NumberField* mass = field("steel_plug_mass_g");
    type(mass, u"-5"_s);
    EXPECT_EQ(QApplication::focusWidget(), mass);  // Enter does not pass it over
    QTest::keyClick(mass, Qt::Key_Tab);
    NumberField* other = field("rod_coefficient");
    type(other, u"0.5"_s);
    EXPECT_EQ(mass->text(), u"-5"_s);
    EXPECT_FALSE(mass->trouble().isEmpty());
    EXPECT_EQ(model->input().engine.steel_plug_mass, find_preset("4.25 l")->steel_plug_mass);
    // The tab says so, and neither journal nor card take the job without a word.
    page.sheets()->setCurrentIndex(0);
    EXPECT_TRUE(page.sheets()->tabBar()->tabTextColor(1).isValid());
    const auto* stale = test::named<QLabel>(page, "refused");
    EXPECT_TRUE(stale->text().contains(u"Steel plug\u00A0mₚ"_s)) << qPrintable(stale->text());
    EXPECT_FALSE(test::named<QLabel>(page, "advice")->font().bold());
    QString asked;
    const auto reply = [&](QMessageBox::StandardButton button) {
        whenModal<QMessageBox>([&asked, button](QMessageBox* box) {
            asked = box->text();
            QTest::mouseClick(box->button(button), Qt::LeftButton);
        });
    };
    reply(QMessageBox::Cancel);
    press(Qt::Key_F2);
    EXPECT_TRUE(asked.contains(u"Steel plug mₚ"_s)) << qPrintable(asked);
    EXPECT_EQ(model->desk()->jobId(), 0);
    reply(QMessageBox::Ignore);
    press(Qt::Key_F2);
    EXPECT_GT(model->desk()->jobId(), 0);
    page.sheets()->setCurrentIndex(1);
    type(mass, u"25"_s);
    EXPECT_TRUE(mass->trouble().isEmpty());
    EXPECT_TRUE(stale->text().isEmpty());
    EXPECT_FALSE(page.sheets()->tabBar()->tabTextColor(1).isValid());
    EXPECT_NEAR(*model->input().engine.steel_plug_mass, 25 * gram, 1e-12);
}

TEST_F(V8PageTest, RefusedWeightNeverBecomesAnother) {
    page.sheets()->setCurrentIndex(2);
    NumberField* mass = field("mass_piston_1");
    QTest::mouseClick(mass, Qt::LeftButton);
    QTest::keyClicks(mass, u"5672.5.1"_s);
    const auto weight = [&] {
        return model->input().weigh_in ? (*model->input().weigh_in)[Part::piston].mass[0]
                                       : std::nullopt;
    };
    EXPECT_EQ(weight(), std::nullopt);
    QTest::mouseClick(field("mass_piston_2"), Qt::LeftButton);
    QTest::keyClicks(field("mass_piston_2"), u"830"_s);
    EXPECT_EQ(mass->text(), u"5672.5.1"_s);
    EXPECT_FALSE(mass->trouble().isEmpty());
    EXPECT_EQ(weight(), std::nullopt);
    QTest::mouseClick(mass, Qt::LeftButton);
    QTest::keyClick(mass, Qt::Key_Escape);
    EXPECT_EQ(mass->text(), QString());
    EXPECT_EQ(weight(), std::nullopt);
}

TEST_F(V8PageTest, SheetsNeedNoScrollingSideways) {
    for (int sheet = 0; sheet < page.sheets()->count(); ++sheet) {
        page.sheets()->setCurrentIndex(sheet);
        QApplication::processEvents();
        auto* scroll = qobject_cast<QScrollArea*>(page.sheets()->widget(sheet));
        ASSERT_NE(scroll, nullptr);
        EXPECT_LE(scroll->widget()->width(), scroll->viewport()->width()) << sheet;
        for (QWidget* each : page.fieldsOf(sheet)) {
            const int end = each->mapTo(scroll->widget(), QPoint(each->width(), 0)).x();
            EXPECT_LE(end, scroll->viewport()->width()) << qPrintable(each->objectName());
        }
    }
}

TEST_F(V8PageTest, OwnEnginesByKeyboard) {
    page.sheets()->setCurrentIndex(1);
    auto* keep = find<QPushButton>("save_engine");
    auto* rename = find<QPushButton>("rename_engine");
    auto* remove = find<QPushButton>("remove_engine");
    EXPECT_FALSE(rename->isEnabled());
    EXPECT_FALSE(remove->isEnabled());
    const auto giveName = [&](QPushButton* button, const QString& name) {
        whenModal<QInputDialog>([name](QInputDialog* dialog) {
            dialog->setTextValue(name);
            QTest::keyClick(dialog, Qt::Key_Return);
        });
        button->setFocus();
        QTest::keyClick(button, Qt::Key_Space);
    };
    type("steel_plug_mass_g", u"25"_s);
    giveName(keep, u"ZMZ-53"_s);
    EXPECT_EQ(model->engineNames().constLast(), u"ZMZ-53"_s);
    EXPECT_TRUE(rename->isEnabled());
    giveName(rename, u"ZMZ-66"_s);
    EXPECT_EQ(model->engineNames().constLast(), u"ZMZ-66"_s);
    EXPECT_EQ(model->input().engine.name, "ZMZ-66");
    // The same name again, in other capitals: asked first.
    type("steel_plug_mass_g", u"26"_s);
    EXPECT_TRUE(model->ownEngineChanged());
    EXPECT_FALSE(model->engineNote().isEmpty());
    const auto keepAnd = [&](QMessageBox::StandardButton button) {
        whenModal<QInputDialog>([button](QInputDialog* dialog) {
            answer(button);
            dialog->setTextValue(u"zmz-66"_s);
            QTest::keyClick(dialog, Qt::Key_Return);
        });
        QTest::mouseClick(keep, Qt::LeftButton);
    };
    keepAnd(QMessageBox::No);
    EXPECT_TRUE(model->ownEngineChanged());
    keepAnd(QMessageBox::Yes);
    EXPECT_FALSE(model->ownEngineChanged());
    EXPECT_EQ(model->engineNames().size(), 8);
    answer(QMessageBox::Yes);
    QTest::mouseClick(remove, Qt::LeftButton);
    EXPECT_EQ(model->engineNames().size(), 7);
    EXPECT_FALSE(remove->isEnabled());
}

TEST_F(V8PageTest, TheWindowAsksForTheJournal) {
    type("engine_number", u"7"_s);
    answer(QMessageBox::Save);
    EXPECT_EQ(page.askToSave(), true);
    EXPECT_EQ(model->desk()->journal()->search({}).size(), 1);
    type("engine_number", u"8"_s);
    answer(QMessageBox::Cancel);
    EXPECT_EQ(page.askToSave(), false);
}

TEST_F(V8PageTest, WeighInSheetByKeyboard) {
    page.sheets()->setCurrentIndex(2);
    type("nominal_piston", u"600"_s);
    type("spread_piston", u"2"_s);
    // From here Enter goes down the column.
    EXPECT_EQ(QApplication::focusWidget(), field("mass_piston_1"));
    for (int cylinder = 0; cylinder < 8; ++cylinder) {
        QTest::keyClicks(QApplication::focusWidget(), QString::number(600 + cylinder));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    }
    EXPECT_EQ(QApplication::focusWidget(), field("nominal_pin"));
    EXPECT_NEAR(*(*model->input().weigh_in)[Part::piston].mass[7], 607 * gram, 1e-12);
    EXPECT_TRUE(label("troubles").contains(u"Piston: spread 7.00"_s));
    // They count, and no box is to be ticked for it.
    auto* use = find<QCheckBox>("changes_from_weigh_in");
    EXPECT_TRUE(use->isChecked());
    EXPECT_NEAR(model->solution().changes.repair_piston_and_rings, 3.5 * gram, 1e-12);
    EXPECT_FALSE(field("repair_piston_and_rings")->isEnabled());
    EXPECT_NEAR(field("repair_piston_and_rings")->value().value_or(0.0), 3.5, 1e-12);
    EXPECT_TRUE(label("advice").startsWith(u"Machine all 8 steel plugs"_s))
        << qPrintable(label("advice"));
    // The parts change places on the sheet too, once they did on the bench.
    auto* move = find<QPushButton>("move_parts");
    ASSERT_TRUE(move->isVisible());
    const auto spread = [&] { return model->solution().crankpin_excess; };
    const auto wanted = model->solution().assigned_excess;
    EXPECT_NE(spread(), wanted);
    move->setFocus();
    QTest::keyClick(move, Qt::Key_Space);
    settle();
    EXPECT_EQ(spread(), wanted);
    EXPECT_EQ(model->solution().assignment->moved, 0);
    EXPECT_FALSE(move->isVisible());
    model->history()->undo();
    // What does not count is amber, on the sheet and in the answer.
    use->setFocus();
    QTest::keyClick(use, Qt::Key_Space);
    EXPECT_TRUE(field("repair_piston_and_rings")->isEnabled());
    for (const char* name : {"troubles", "weigh_in_summary"}) {
        EXPECT_TRUE(label(name).contains(u"The weights of the parts do not count"_s)) << name;
        EXPECT_EQ(find<QLabel>(name)->palette().color(QPalette::WindowText),
                  Theme::instance().warning())
            << name;
    }
    EXPECT_TRUE(label("advice").startsWith(u"Still needed: changes of mass"_s));
    QTest::keyClick(use, Qt::Key_Space);
    EXPECT_FALSE(label("troubles").contains(u"do not count"_s));
    EXPECT_NEAR(model->solution().changes.repair_piston_and_rings, 3.5 * gram, 1e-12);
}

TEST_F(V8PageTest, MovedPartsKeepTheirNumbersOnSheetAndCard) {
    page.sheets()->setCurrentIndex(2);
    type("nominal_piston", u"600"_s);
    for (int i = 1; i <= 8; ++i) {
        type(("mass_piston_" + std::to_string(i)).c_str(), QString::number(600 + i % 4 * 2));
    }
    settle();
    ASSERT_TRUE(model->solution().assignment);
    std::vector<int> wanted;
    for (const int from : model->solution().assignment->pistons) {
        wanted.push_back(from + 1);
    }
    ASSERT_NE(wanted, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
    const auto printed = [&] {
        const QString file = QDir(folder.path()).filePath(u"moved.pdf"_s);
        EXPECT_EQ(page.writeCard(file), QString());
        QProcess reader;
        reader.start(QStringLiteral(PDFTOTEXT), {u"-layout"_s, file, u"-"_s});
        EXPECT_TRUE(reader.waitForFinished());
        QString line;
        for (const QString& each : QString::fromUtf8(reader.readAllStandardOutput()).split(u'\n')) {
            line = each.contains(u"Piston set from"_s) ? each.simplified() : line;
        }
        return line;
    };
    const auto said = [&] {
        QStringList numbers;
        for (const int number : wanted) {
            numbers << QString::number(number);
        }
        return u"Piston set from "_s + numbers.join(u' ');
    };
    EXPECT_EQ(printed(), said());
    const auto table = model->assignmentResults().rows;
    auto* move = find<QPushButton>("move_parts");
    move->setFocus();
    QTest::keyClick(move, Qt::Key_Space);
    // The weights have moved; the numbers say where the parts came from, on sheet and card.
    settle();
    EXPECT_EQ(model->solution().assignment->moved, 0);
    EXPECT_EQ(printed(), said());
    EXPECT_EQ(model->assignmentResults().rows, table);
    EXPECT_TRUE(label("weigh_in_summary").contains(u"Assemble by the numbers"_s));
    // Kept by the case file.
    const Input kept = model->input();
    const Json file = model->inputJson();
    model->loadDefault();
    model->loadInput(file, {});
    EXPECT_EQ(model->input().weigh_in, kept.weigh_in);
    auto* back = find<QPushButton>("move_back");
    page.sheets()->setCurrentIndex(2);
    ASSERT_TRUE(back->isVisible());
    back->setFocus();
    QTest::keyClick(back, Qt::Key_Space);
    for (std::size_t i = 1; i <= 8; ++i) {
        EXPECT_NEAR(*(*model->input().weigh_in)[Part::piston].mass[i - 1],
                    (600 + static_cast<double>(i % 4) * 2) * gram, 1e-12);
    }
    EXPECT_FALSE(model->input().weigh_in->is_moved());
}

TEST_F(V8PageTest, FittedPistonsStayAndWhatTheEngineFeelsIsMadeSmall) {
    page.sheets()->setCurrentIndex(2);
    type("nominal_piston", u"600"_s);
    type("spread_piston", u"2"_s);
    type("nominal_rod_big_end", u"500"_s);
    for (int i = 1; i <= 8; ++i) {
        type(("mass_piston_" + std::to_string(i)).c_str(), QString::number(600 + i * i % 7));
        type(("mass_rod_big_end_" + std::to_string(i)).c_str(), QString::number(500 + i * i % 5));
    }
    EXPECT_EQ(model->takeOffResults().rows.size(), 2);
    EXPECT_EQ(model->takeOffResults().rows.at(0).at(1), u"1.00"_s) << "601 g, the lightest 600";
    const auto choose = [&](const char* name, Qt::Key key) {
        auto* box = find<QComboBox>(name);
        box->setFocus(Qt::TabFocusReason);
        QTest::keyClick(box, key);
    };
    choose("moves_pistons", Qt::Key_End);
    choose("goal", Qt::Key_End);
    const auto placing = [&] {
        settle();
        return model->solution().assignment.value();
    };
    EXPECT_EQ(placing().pistons, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(placing().goal, workshop::MatchingGoal::least_shaking);
    EXPECT_LT(placing().shaking->ends, placing().shaking_before->ends);
    EXPECT_TRUE(label("weigh_in_summary").contains(u"needs the cylinder spacing"_s))
        << qPrintable(label("weigh_in_summary"));
    type("cylinder_spacing_mm", u"110"_s);
    settle();
    EXPECT_EQ(model->effectResults().rows.size(), 4);
    EXPECT_EQ(model->history()->undoText(), u"Cylinder spacing"_s);
    const Json matching = model->inputJson().at("weigh_in").at("matching");
    EXPECT_EQ(matching,
              (Json{{"goal", "least-shaking"}, {"pistons", "stay"}, {"cylinder_spacing_mm", 110}}));
    // The card says what to take off pistons too far apart, and what is gained.
    const QString file = QDir(folder.path()).filePath(u"matched.pdf"_s);
    EXPECT_EQ(page.writeCard(file), QString());
    QProcess reader;
    reader.start(QStringLiteral(PDFTOTEXT), {u"-layout"_s, file, u"-"_s});
    EXPECT_TRUE(reader.waitForFinished());
    const QString printed = QString::fromUtf8(reader.readAllStandardOutput());
    EXPECT_TRUE(printed.contains(u"take off"_s)) << qPrintable(printed);
    EXPECT_TRUE(printed.contains(u"First-order unbalance of the differences"_s));
    page.sheets()->setCurrentIndex(2);
    model->newJob();
    EXPECT_EQ(model->input().weigh_in->matching.pistons, workshop::SetMoves::stays);
}

TEST_F(V8PageTest, NominalMassesAreCheckedAgainstThePartsOrFilledFromThem) {
    const std::map<const char*, const char*> parts{
        {"nominal_piston", "568.5"},      {"nominal_pin", "151.2"},       {"nominal_rings", "62.3"},
        {"nominal_rod_small_end", "240"}, {"nominal_rod_big_end", "590"}, {"nominal_shells", "60"}};
    for (const auto& [name, grams] : parts) {
        type(name, QString::fromLatin1(grams));
    }
    type("reciprocating_mass_g", u"1000"_s);  // 22 g short of the parts
    type("rotating_mass_g", u"650"_s);
    EXPECT_TRUE(
        label("troubles")
            .contains(
                u"Reciprocating mass\u00A0mⱼ: 1000.00\u00A0g typed, but the nominal parts give "
                u"1022.00\u00A0g."_s))
        << qPrintable(label("troubles"));
    EXPECT_FALSE(label("troubles").contains(u"Rotating mass"_s));
    EXPECT_EQ(find<QLabel>("troubles")->palette().color(QPalette::WindowText),
              Theme::instance().warning());
    auto* fill = find<QPushButton>("fill_masses");
    ASSERT_TRUE(fill->isEnabled());
    page.sheets()->setCurrentIndex(1);
    fill->setFocus();
    QTest::keyClick(fill, Qt::Key_Space);
    EXPECT_NEAR(*field("reciprocating_mass_g")->value(), 1022.0, 1e-9);
    EXPECT_FALSE(label("troubles").contains(u"typed, but"_s));
    EXPECT_FALSE(fill->isEnabled());
}

TEST_F(V8PageTest, EngineBringsItsPlugAndItsOwnSheets) {
    type("height_mm", u"9.5"_s);
    type("bore_diameter_mm", u"12"_s);
    type("bore_depth_mm", u"5"_s);
    type("cutter_diameter_mm", u"14"_s);
    type("nominal_piston", u"600"_s);
    type("spread_piston", u"2"_s);
    type("mass_piston_1", u"601"_s);
    // Kept with the engine.
    const PlugSheet plug = model->input().plug.value();
    whenModal<QInputDialog>([](QInputDialog* dialog) {
        dialog->setTextValue(u"Kept"_s);
        dialog->accept();
    });
    QTest::mouseClick(find<QPushButton>("save_engine"), Qt::LeftButton);
    auto* engine = find<QComboBox>("engine");
    page.sheets()->setCurrentIndex(0);
    engine->setFocus();
    QTest::keyClick(engine, Qt::Key_Home);
    QTest::keyClick(engine, Qt::Key_Down);
    EXPECT_EQ(model->input().preset, "6 l");
    EXPECT_EQ(field("height_mm")->value(), 11.0) << "another engine's plug stays";
    EXPECT_FALSE(field("bore_diameter_mm")->value());
    EXPECT_EQ(field("cutter_diameter_mm")->value(), 14.0) << "the cutter is the shop's";
    EXPECT_FALSE(field("nominal_piston")->value());
    EXPECT_EQ(field("mass_piston_1")->value(), 601.0) << "what the scale said stays";
    QTest::keyClick(engine, Qt::Key_End);
    EXPECT_EQ(model->input().engine.name, "Kept");
    EXPECT_EQ(model->input().plug, plug);
    EXPECT_EQ(field("nominal_piston")->value(), 600.0);
    EXPECT_EQ(field("spread_piston")->value(), 2.0);
    // The next job keeps what is the engine's and says so.
    type("grade_mm_s", u"16"_s);
    type("rotor_mass_kg", u"30"_s);
    type("service_speed_rpm", u"3200"_s);
    type("front_reading_g_mm", u"100"_s);
    press(Qt::Key_F2);
    EXPECT_FALSE(find<QLabel>("carried_over")->isVisibleTo(&page));
    press(Qt::Key_F4);
    EXPECT_EQ(model->input().plug, plug);
    EXPECT_EQ(field("nominal_piston")->value(), 600.0);
    EXPECT_FALSE(field("mass_piston_1")->value());
    EXPECT_EQ(field("grade_mm_s")->value(), 16.0);
    EXPECT_FALSE(field("front_reading_g_mm")->value());
    EXPECT_EQ(label("carried_over"),
              u"From the job before: the engine's values, the plug's sizes, nominal masses and "
              "permitted spreads, grade, mass and speed."_s);
    type("height_mm", u"10"_s);
    EXPECT_FALSE(label("carried_over").contains(u"plug"_s));
}

TEST_F(V8PageTest, ReadingsAreJudgedByTheToleranceAloneAndBothLimitsAreExplained) {
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

/// A button that hides when it is pressed gives the focus to whatever comes next.
TEST_F(V8PageTest, ItsKeysWorkWhereverTheFocusIs) {
    QWidget window;
    QVBoxLayout column(&window);
    QPushButton other(u"Other"_s, &window);
    column.addWidget(&other);
    column.addWidget(&page);
    test::showAt(window, {1187, 760});
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    type("engine_number", u"53-11"_s);
    other.setFocus();
    ASSERT_TRUE(other.hasFocus());
    QTest::keyClick(&other, Qt::Key_F2);
    EXPECT_TRUE(QTest::qWaitFor([this] { return model->desk()->jobId() != 0; }, 20'000));
    page.setParent(nullptr);
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

TEST_F(V8PageTest, APlugThatCannotBeMadeIsNoAnswer) {
    QFile example(QStringLiteral(RAVNOVES_EXAMPLES "/v8-4.25-repair.case.json"));
    ASSERT_TRUE(example.open(QIODevice::ReadOnly));
    Json input = parse_json(example.readAll().toStdString()).at("input");
    input["plug"] = parse_json(R"({"thread": "M22x1.5", "height_mm": 14, "bore_diameter_mm": 14,
        "bore_depth_mm": 14.5})");
    model->loadInput(input, {});
    EXPECT_TRUE(label("advice").contains(u"there is no bottom"_s)) << qPrintable(label("advice"));
    EXPECT_EQ(find<QLabel>("advice")->palette().color(QPalette::WindowText),
              Theme::instance().error());
    EXPECT_TRUE(label("boring").isEmpty());
    type("bore_depth_mm", u"6"_s);
    EXPECT_FALSE(label("advice").contains(u"cannot"_s)) << qPrintable(label("advice"));
}

TEST_F(V8PageTest, TheNextJobSaysWhatItKeeps) {
    QFile example(QStringLiteral(RAVNOVES_EXAMPLES "/v8-4.25-repair.case.json"));
    ASSERT_TRUE(example.open(QIODevice::ReadOnly));
    model->loadInput(parse_json(example.readAll().toStdString()).at("input"), {});
    model->history()->setClean();
    const QSignalSpy said(&page, &ScenePage::status);
    press(Qt::Key_F4);
    ASSERT_FALSE(said.isEmpty());
    EXPECT_TRUE(said.last().at(0).toString().contains(u"the engine's values"_s))
        << qPrintable(said.last().at(0).toString());
}

TEST_F(V8PageTest, MassesInKilogramsAreNoticed) {
    type("mass_piston_1", u"0.5682"_s);
    EXPECT_TRUE(label("troubles").contains(u"Piston: 0.568\u00A0g looks like kilograms"_s))
        << qPrintable(label("troubles"));
    type("mass_piston_1", u"568.2"_s);
    EXPECT_FALSE(label("troubles").contains(u"kilograms"_s));
    type("nominal_shells", u"0.06"_s);
    EXPECT_TRUE(label("troubles").contains(u"Shells: 0.060\u00A0g looks like kilograms"_s));
    type("reciprocating_mass_g", u"1.02"_s);
    EXPECT_TRUE(label("troubles").contains(u"mⱼ: 1.020\u00A0g looks like kilograms"_s));
}

TEST_F(V8PageTest, AMassUnlikeTheOthersIsNoticed) {
    type("mass_piston_1", u"568.2"_s);
    type("mass_piston_2", u"5682"_s);
    type("mass_piston_3", u"568"_s);
    EXPECT_TRUE(
        label("troubles").contains(u"Piston: cylinder 2 weighs 5682\u00A0g, the others about"_s))
        << qPrintable(label("troubles"));
    EXPECT_FALSE(label("troubles").contains(u"Piston: spread"_s));
    type("mass_piston_2", u"568.2"_s);
    EXPECT_FALSE(label("troubles").contains(u"the others"_s));
}

TEST_F(V8PageTest, FieldsStayWhereTheyAreWhileOneTypes) {
    const auto places = [&](int sheet) {
        QList<QPoint> points;
        for (QWidget* each : page.fieldsOf(sheet)) {
            points << each->mapTo(each->window(), QPoint());
        }
        return points;
    };
    const std::map<const char*, const char*> typed{
        {"tolerance_g_mm", "1440"}, {"repair_bearing", "3"}, {"steel_plug_mass_g", "22.5"},
        {"mass_pin_4", "0.151"},    {"grade_mm_s", "16"},    {"rear_reading_g_mm", "9"}};
    for (const auto& [name, text] : typed) {
        int sheet = 0;
        while (!page.fieldsOf(sheet).contains(find<QWidget>(name))) {
            ++sheet;
        }
        page.sheets()->setCurrentIndex(sheet);
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

TEST_F(V8PageTest, KeysWorkRightAfterTheStartAndChoicesShowTheFocus) {
    V8PlugsPage fresh(QDir(folder.path()).filePath(u"fresh.sqlite"_s), nullptr);
    fresh.show();
    fresh.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&fresh));
    QApplication::processEvents();
    ASSERT_TRUE(fresh.isAncestorOf(QApplication::focusWidget()));
    bool seen = false;
    whenModal<JournalDialog>([&](JournalDialog* dialog) {
        seen = true;
        dialog->reject();
    });
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F3);
    EXPECT_TRUE(seen);
    auto* process = fresh.findChild<QComboBox*>(u"process"_s);
    fresh.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&fresh));
    const QImage without = process->grab().toImage();
    process->setFocus(Qt::OtherFocusReason);
    QApplication::processEvents();
    EXPECT_NE(process->grab().toImage(), without);
}

TEST_F(V8PageTest, SaysWhereThePlugsAreWhileTheBobWeightsHang) {
    for (const char* name : {"reciprocating_mass_g", "rotating_mass_g", "oil_mass_g"}) {
        type(name, u"700"_s);
    }
    type("oil_coefficient", u"1"_s);
    type("steel_plug_mass_g", u"25"_s);
    type("rod_big_end", u"0.5"_s);
    ASSERT_TRUE(model->solution().before) << qPrintable(label("hang"));
    const BobWeight& after =
        model->solution().bob_weights[index(model->solution().advice->option->id)]->after;
    // About 59 g: two plugs of 25 g at 1.18 times the crank radius.
    EXPECT_GT(after.sum() - after.with_plugs_in(), 55 * gram);
    EXPECT_TRUE(label("plugs_while_hung")
                    .contains(u"The plugs are out of the shaft then; while they are in it hang "_s +
                              QString::number(after.with_plugs_in() / gram, 'f', 1)))
        << qPrintable(label("hang"));
    EXPECT_TRUE(label("check").contains(u"Big end × 2.445: 2 for two rods as usual"_s))
        << qPrintable(label("check"));
    EXPECT_TRUE(label("check").contains(u"worth 0.22\u00A0g here"_s)) << qPrintable(label("check"));
}

TEST_F(V8PageTest, CardIsWholeOnLetterAndOnItsSide) {
    type("engine_number", u"card"_s);
    type("rod_big_end", u"1"_s);
    struct Paper {
        QPageSize::PageSizeId size;
        QPageLayout::Orientation side;
    };
    for (const Paper& paper : {Paper{QPageSize::Letter, QPageLayout::Portrait},
                               Paper{QPageSize::A4, QPageLayout::Landscape},
                               Paper{QPageSize::A5, QPageLayout::Portrait}}) {
        const QString file = QDir(folder.path()).filePath(u"paper.pdf"_s);
        QPrinter printer(QPrinter::HighResolution);
        printer.setOutputFormat(QPrinter::PdfFormat);
        printer.setOutputFileName(file);
        PlugsCard::setPage(printer);
        printer.setPageSize(QPageSize(paper.size));
        printer.setPageOrientation(paper.side);
        ASSERT_TRUE(PlugsCard(model->input(), model->wholeSolution(), Words()).print(printer));
        // Words that lie beyond the paper would be left out by a crop to it.
        QProcess reader;
        reader.start(QStringLiteral(PDFTOTEXT), {u"-bbox"_s, file, u"-"_s});
        ASSERT_TRUE(reader.waitForFinished());
        const QString words = QString::fromUtf8(reader.readAllStandardOutput());
        const auto number = [](const QString& text, const QString& key) {
            return QRegularExpression(key + u"=\"([-0-9.]+)\""_s)
                .match(text)
                .captured(1)
                .toDouble();
        };
        const QString sheet = words.mid(words.indexOf(u"<page "_s), 100);
        int count = 0;
        for (const QString& line : words.split(u'\n')) {
            if (line.contains(u"<word "_s)) {
                ++count;
                EXPECT_GE(number(line, u"xMin"_s), 0.0) << qPrintable(line);
                EXPECT_GE(number(line, u"yMin"_s), 0.0) << qPrintable(line);
                EXPECT_LE(number(line, u"xMax"_s), number(sheet, u"width"_s)) << qPrintable(line);
                EXPECT_LE(number(line, u"yMax"_s), number(sheet, u"height"_s)) << qPrintable(line);
            }
        }
        EXPECT_GT(count, 100);
        EXPECT_EQ(words.count(u"<page "_s), 1);
    }
}

TEST_F(V8PageTest, JournalListsWhatTheMachineSaidAndFindsTheCrankshaft) {
    type("engine_number", u"53-11"_s);
    type("crankshaft_number", u"KV-77"_s);
    type("rod_big_end", u"1"_s);
    type("front_reading_g_mm", u"3.14159"_s);
    type("rear_reading_g_mm", u"6"_s);
    press(Qt::Key_F2);
    QStringList cells;
    whenModal<JournalDialog>([&](JournalDialog* dialog) {
        QTest::keyClicks(dialog->findChild<QLineEdit*>(u"journal_search"_s), u"kv-77"_s);
        auto* table = dialog->findChild<QTableWidget*>(u"journal_table"_s);
        for (int i = 0; table->rowCount() == 1 && i < table->columnCount(); ++i) {
            cells << table->item(0, i)->text();
        }
        dialog->reject();
    });
    press(Qt::Key_F3);
    EXPECT_TRUE(cells.contains(u"KV-77"_s));
    EXPECT_TRUE(cells.contains(u"fails: 3.1 / 6.0"_s)) << qPrintable(cells.join(u'|'));
}

TEST_F(V8PageTest, CellsShowHundredthsOfAGram) {
    page.sheets()->setCurrentIndex(2);
    type("mass_piston_8", u"1568.52"_s);
    NumberField* cell = field("mass_piston_8");
    // Frame and margins are three pixels at each side.
    EXPECT_LE(cell->fontMetrics().horizontalAdvance(u"1568.52"_s) + 6, cell->width());
}

TEST_F(V8PageTest, JobsArePutAsideUnfinishedAndTheTechnicianIsRemembered) {
    type("engine_number", u"53-11"_s);
    type("technician", u"O. Bauer"_s);
    page.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
    QTest::keyClick(&page, Qt::Key_F2, Qt::ShiftModifier);
    ASSERT_TRUE(QTest::qWaitFor([this] { return !model->desk()->isWaiting(); }, 20'000));
    ASSERT_GT(model->desk()->jobId(), 0);
    EXPECT_FALSE(model->desk()->journal()->job(model->desk()->jobId())->isFinished);
    press(Qt::Key_F4);
    EXPECT_EQ(model->input().job.technician, "O. Bauer");
    V8PlugsModel tomorrow(model->desk()->journal()->path());
    EXPECT_EQ(tomorrow.input().job.technician, "O. Bauer");
    type("engine_number", u"done"_s);
    type("rod_big_end", u"0"_s);
    press(Qt::Key_F2);
    QStringList found;
    whenModal<JournalDialog>([&](JournalDialog* dialog) {
        auto* table = dialog->findChild<QTableWidget*>(u"journal_table"_s);
        EXPECT_EQ(table->rowCount(), 2);
        auto* box = dialog->findChild<QCheckBox*>(u"journal_unfinished"_s);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Space);
        for (int i = 0; table->rowCount() == 1 && i < table->columnCount(); ++i) {
            found << table->item(0, i)->text();
        }
        table->setFocus();
        QTest::keyClick(table, Qt::Key_Return);
        if (dialog->isVisible()) {
            QTest::mouseClick(dialog->findChild<QPushButton*>(u"journal_open"_s), Qt::LeftButton);
        }
    });
    press(Qt::Key_F3);
    EXPECT_TRUE(found.contains(u"53-11"_s) && found.contains(u"unfinished"_s))
        << qPrintable(found.join(u'|'));
    // Gone on with and finished: it is the same job.
    EXPECT_EQ(model->input().job.engine_number, "53-11");
    type("rod_big_end", u"1"_s);
    press(Qt::Key_F2);
    EXPECT_EQ(model->desk()->journal()->search({}).size(), 2);
    EXPECT_TRUE(model->desk()->journal()->job(model->desk()->jobId())->isFinished);
    QSettings().remove(u"workshop/technician"_s);
}

TEST_F(V8PageTest, JournalIsBackedUpAndRestoredByTheMenu) {
    const QString backup = QDir(folder.path()).filePath(u"backup.sqlite"_s);
    const auto before = fileChoosers();
    fileChoosers().save = [&](auto...) { return backup; };
    fileChoosers().open = [&](auto...) { return backup; };
    QString said;
    const auto command = [&](const QString& name) {
        whenModal<QMessageBox>([&said](QMessageBox* box) {
            said = box->text();
            QTest::keyClick(box, Qt::Key_Return);
        });
        for (QAction* action : page.sceneActions()) {
            if (action != nullptr && action->objectName() == name) {
                action->trigger();
            }
        }
    };
    type("engine_number", u"first"_s);
    press(Qt::Key_F2);
    command(u"back_up"_s);
    EXPECT_TRUE(said.contains(backup)) << qPrintable(said);
    ASSERT_TRUE(model->desk()->journal()->remove(model->desk()->jobId()));
    press(Qt::Key_F4);
    type("engine_number", u"second"_s);
    press(Qt::Key_F2);
    command(u"restore"_s);
    EXPECT_EQ(said, u"Jobs brought back: 1; already in the journal: 0."_s);
    EXPECT_EQ(model->desk()->journal()->search({}).size(), 2);
    command(u"restore"_s);
    EXPECT_EQ(said, u"Jobs brought back: 0; already in the journal: 1."_s);
    QFile torn(backup);
    ASSERT_TRUE(torn.open(QIODevice::WriteOnly));
    torn.write("a letter");
    torn.close();
    command(u"restore"_s);
    EXPECT_TRUE(said.contains(u"no backup"_s)) << qPrintable(said);
    EXPECT_EQ(model->desk()->journal()->search({}).size(), 2);
    fileChoosers() = before;
}

TEST_F(V8PageTest, WindowLivesWhileAnotherProgramHoldsTheJournal) {
    type("engine_number", u"53-11"_s);
    type("rod_big_end", u"1"_s);
    QSignalSpy status(&page, &ScenePage::status);
    {
        QSqlDatabase other = QSqlDatabase::addDatabase(u"QSQLITE"_s, u"other"_s);
        other.setDatabaseName(model->desk()->journal()->path());
        ASSERT_TRUE(other.open());
        QSqlQuery query(other);
        ASSERT_TRUE(query.exec(u"BEGIN IMMEDIATE"_s));
        int ticks = 0;
        bool asked = false;
        QTimer clock;
        QObject::connect(&clock, &QTimer::timeout, [&] {
            if (++ticks == 5) {
                asked = page.askToSave().value();  // the window is to close
            }
            // The journal may say besides that it waits to be opened; without either word the
            // other program ends before the window gives up and asks.
            if ((ticks >= 40 && status.count() >= 2) || ticks >= 400) {
                query.exec(u"ROLLBACK"_s);
                clock.stop();
            }
        });
        clock.start(20);
        press(Qt::Key_F2);
        EXPECT_GE(ticks, 40);
        EXPECT_FALSE(asked);
    }
    QSqlDatabase::removeDatabase(u"other"_s);
    QStringList said;
    for (const QList<QVariant>& each : status) {
        said << each.at(0).toString();
    }
    ASSERT_GE(said.size(), 3) << said.join(u'\n').toStdString();
    EXPECT_TRUE(said.last().contains(u"saved in the journal"_s)) << said.last().toStdString();
    const QString before = said.join(u'\n');
    EXPECT_TRUE(before.contains(u"Another program is writing"_s));
    EXPECT_TRUE(before.contains(u"still being saved"_s));
    EXPECT_GT(model->desk()->jobId(), 0);
}

TEST_F(V8PageTest, ShopStandsOnTheCard) {
    const QString logo = QDir(folder.path()).filePath(u"logo.png"_s);
    QImage picture(60, 20, QImage::Format_RGB32);
    picture.fill(Qt::red);
    ASSERT_TRUE(picture.save(logo));
    const auto before = fileChoosers();
    fileChoosers().open = [&](auto...) { return logo; };
    whenModal<ShopDialog>([](ShopDialog* dialog) {
        QTest::keyClicks(dialog->findChild<QLineEdit*>(u"shop_name"_s), u"Smith & Sons"_s);
        QTest::mouseClick(dialog->findChild<QPushButton*>(u"shop_choose"_s), Qt::LeftButton);
        EXPECT_FALSE(dialog->findChild<QLabel*>(u"shop_logo"_s)->pixmap().isNull());
        dialog->accept();
    });
    for (QAction* action : page.sceneActions()) {
        if (action != nullptr && action->objectName() == u"shop"_s) {
            action->trigger();
        }
    }
    const QString file = QDir(folder.path()).filePath(u"shop.pdf"_s);
    ASSERT_EQ(page.writeCard(file), QString());
    QProcess reader;
    reader.start(QStringLiteral(PDFTOTEXT), {file, u"-"_s});
    ASSERT_TRUE(reader.waitForFinished());
    EXPECT_TRUE(QString::fromUtf8(reader.readAllStandardOutput()).contains(u"Smith & Sons"_s));
    PlugsCard card(model->input(), model->wholeSolution(), Words());
    card.setShop(Shop::kept());
    QImage paper(2100, 2970, QImage::Format_RGB32);
    QPainter painter(&paper);
    card.paint(painter, QRectF(0, 0, 2100, 2970));
    EXPECT_EQ(paper.pixelColor(170, 72), QColor(Qt::red));
    fileChoosers() = before;
    QSettings().remove(u"workshop"_s);
}

TEST_F(V8PageTest, EmptySheetGivesNoAnswerAndIsNotJournalled) {
    const auto save = [&] {
        QString said;
        whenModal<QMessageBox>([&said](QMessageBox* box) {
            said = box->text();
            QTest::keyClick(box, Qt::Key_Return);
        });
        press(Qt::Key_F2);
        return said;
    };
    const auto colour = [&] {
        return find<QLabel>("advice")->palette().color(QPalette::WindowText);
    };
    EXPECT_TRUE(label("advice").startsWith(u"Still needed: changes of mass"_s))
        << qPrintable(label("advice"));
    EXPECT_EQ(colour(), Theme::instance().mutedText());
    EXPECT_FALSE(label("hang").contains(u"Hang"_s)) << qPrintable(label("hang"));
    EXPECT_TRUE(save().startsWith(u"The sheet is empty: nothing is saved. Still needed:"_s));
    EXPECT_EQ(model->desk()->jobId(), 0);
    EXPECT_TRUE(model->desk()->journal()->search({}).isEmpty());
    // A zero that was typed is something that is known.
    EXPECT_EQ(field("rod_big_end")->value(), std::nullopt);
    type("rod_big_end", u"0"_s);
    EXPECT_TRUE(label("advice").startsWith(u"Leave the plugs as they are"_s));
    EXPECT_EQ(colour(), Theme::instance().text());
    EXPECT_EQ(field("repair_bearing")->value(), 0.0);
    press(Qt::Key_F2);
    EXPECT_GT(model->desk()->jobId(), 0);
    press(Qt::Key_F4);
    EXPECT_TRUE(label("advice").startsWith(u"Still needed: changes of mass"_s));
}

TEST_F(V8PageTest, JobWithoutAnAnswerIsSavedAndSaidSo) {
    type("engine_number", u"53-11"_s);
    QSignalSpy status(&page, &ScenePage::status);
    press(Qt::Key_F2);
    ASSERT_EQ(status.count(), 1);
    EXPECT_TRUE(status.at(0).at(0).toString().contains(
        u"put aside in the journal, unfinished. Still needed:"_s));
    const auto job = model->desk()->journal()->job(model->desk()->jobId());
    ASSERT_TRUE(job);
    EXPECT_FALSE(job->unbalancedMass);
    EXPECT_FALSE(job->isFinished);
    EXPECT_TRUE(job->recommended.isEmpty());
}

TEST_F(V8PageTest, ColumnOfASpreadsheetIsPastedWithoutItsHeading) {
    page.sheets()->setCurrentIndex(2);
    NumberField* first = field("mass_piston_1");
    const auto paste = [&](const QString& text) {
        QGuiApplication::clipboard()->setText(text);
        first->setFocus();
        QTest::keyClick(first, Qt::Key_V, Qt::ControlModifier);
    };
    paste(u"Piston, g\tPin, g\r\n601,5\t151\r\n602\t\r\n603\t153\r\n"_s);
    const WeighIn& sheet = model->input().weigh_in.value();
    EXPECT_EQ(field("mass_piston_1")->value(), 601.5);
    EXPECT_EQ(field("mass_pin_3")->value(), 153.0);
    EXPECT_FALSE(sheet[Part::pin].mass[1]) << "a gap stays a gap";
    model->history()->undo();
    EXPECT_FALSE(model->input().weigh_in) << "the paste is one step";
    // Refused as a whole: a word, a mass out of range, more rows than cylinders.
    for (const QString& bad : {u"601\nheavy"_s, u"601\n-5"_s, u"1\n2\n3\n4\n5\n6\n7\n8\n9"_s}) {
        paste(bad);
        EXPECT_FALSE(model->input().weigh_in) << qPrintable(bad);
    }
    paste(u"1\n2\n3\n4\n5\n6\n7\n8\n"_s);
    EXPECT_EQ(field("mass_piston_8")->value(), 8.0);
}

TEST_F(V8PageTest, EngineChoiceAndFlags) {
    type("rod_big_end", u"0"_s);
    auto* engine = find<QComboBox>("engine");
    engine->setFocus();
    QTest::keyClick(engine, Qt::Key_Down);
    EXPECT_EQ(model->input().preset, "6 l");
    EXPECT_EQ(field("crank_radius_mm")->value(), 47.5);
    auto* flag = find<QCheckBox>("has_new_plug");
    page.sheets()->setCurrentIndex(1);
    QTest::mouseClick(flag, Qt::LeftButton, {}, QPoint(10, flag->height() / 2));
    EXPECT_FALSE(model->input().engine.has_new_plug);
    EXPECT_FALSE(field("new_plug_radius_mm")->isEnabled());
    EXPECT_FALSE(find<QComboBox>("crankshaft")->isEnabled());
    EXPECT_TRUE(model->solution().advice);
    EXPECT_FALSE(model->solution().option(OptionId::new_steel_to_steel));
    QTest::mouseClick(flag, Qt::LeftButton, {}, QPoint(10, flag->height() / 2));
    EXPECT_TRUE(model->adviceText().startsWith(u"Still needed: new plug radius"_s));
}

TEST_F(V8PageTest, PlotsShowLinesLimitsAndToday) {
    type("rod_big_end", u"1"_s);
    const PlotView* plot = page.compensationPlot();
    for (const OptionId id : all_options) {
        const auto& option = model->solution().option(id);
        const int curve = static_cast<int>(id);
        EXPECT_NEAR(*plot->valueAt(curve, 0.0), option->constant / gram, 1e-9);
        EXPECT_NEAR(*plot->valueAt(curve, option->max_reduction / gram), option->maximum / gram,
                    1e-9);
        EXPECT_FALSE(plot->valueAt(curve, option->max_reduction / gram + 0.01));
    }
    // Today's excess as a line, the option chosen as a ring on it.
    const Option& chosen = *model->solution().advice->option;
    const QImage picture = page.compensationPlot()->grab().toImage();
    const auto apart = [](const QColor& a, const QColor& b) {
        return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
               std::abs(a.blue() - b.blue());
    };
    const auto near = [&](const QColor& a, const QColor& b) { return apart(a, b) < 60; };
    const double excess = *model->solution().unbalanced_mass / gram;
    const int row = qRound(plot->toPixel(0.0, excess).y());
    int today = 0;
    for (int x = qRound(plot->plotArea().left()); x < plot->plotArea().right(); ++x) {
        for (int y = row - 1; y <= row + 1; ++y) {
            // The line may lie between two rows of pixels and be paler in each.
            const QColor pixel = picture.pixelColor(x, y);
            today +=
                apart(pixel, Theme::instance().curve(6)) < apart(pixel, Theme::instance().panel())
                    ? 1
                    : 0;
        }
    }
    EXPECT_GT(today, 12);
    const QPoint ring = plot->toPixel(chosen.reduction / gram, excess).toPoint();
    int around = 0;
    for (int dx = -9; dx <= 9; ++dx) {
        for (int dy = -9; dy <= 9; ++dy) {
            const bool onRing = dx * dx + dy * dy >= 16;
            around += onRing && near(picture.pixelColor(ring.x() + dx, ring.y() + dy),
                                     Theme::instance().curve(static_cast<int>(chosen.id)))
                          ? 1
                          : 0;
        }
    }
    EXPECT_GT(around, 20);
    // Fig. 2: Δk = Δr / r.
    for (std::size_t i = 0; i < shift_curves.size(); ++i) {
        EXPECT_NEAR(*page.shiftPlot()->valueAt(static_cast<int>(i), 1.2),
                    1.2e-3 / shift_curves[i].crank_radius, 1e-9);
    }
}

TEST_F(V8PageTest, JobGoesToTheJournalByKeyAndComesBack) {
    type("engine_number", u"53-11"_s);
    type("rod_big_end", u"1"_s);
    QSignalSpy status(&page, &ScenePage::status);
    press(Qt::Key_F2);
    ASSERT_EQ(status.count(), 1);
    EXPECT_TRUE(status.at(0).at(0).toString().contains(u"53-11"_s));
    const qint64 id = model->desk()->jobId();
    EXPECT_GT(id, 0);
    press(Qt::Key_F4);
    EXPECT_EQ(model->desk()->jobId(), 0);
    EXPECT_EQ(QApplication::focusWidget(), find<QWidget>("engine_number"));
    // F3: search, Enter to the list, Enter opens.
    bool seen = false;
    whenModal<JournalDialog>([&](JournalDialog* dialog) {
        auto* search = dialog->findChild<QLineEdit*>(u"journal_search"_s);
        auto* table = dialog->findChild<QTableWidget*>(u"journal_table"_s);
        QTest::keyClicks(search, u"nothing like it"_s);
        EXPECT_EQ(table->rowCount(), 0);
        search->clear();
        QTest::keyClicks(search, u"53"_s);
        EXPECT_EQ(table->rowCount(), 1);
        QTest::keyClick(search, Qt::Key_Return);
        QTest::keyClick(table, Qt::Key_Return);
        seen = true;
        if (dialog->isVisible()) {
            QTest::mouseClick(dialog->findChild<QPushButton*>(u"journal_open"_s), Qt::LeftButton);
        }
    });
    press(Qt::Key_F3);
    EXPECT_TRUE(seen);
    EXPECT_EQ(model->desk()->jobId(), id);
    EXPECT_NEAR(model->input().typed_changes.rod_big_end, 1 * gram, 1e-12);
}

TEST_F(V8PageTest, UnsavedJobIsAskedAbout) {
    type("engine_number", u"7"_s);
    answer(QMessageBox::Cancel);
    press(Qt::Key_F4);
    EXPECT_EQ(model->input().job.engine_number, "7");
    answer(QMessageBox::Save);
    press(Qt::Key_F4);
    EXPECT_TRUE(model->input().job.engine_number.empty());
    EXPECT_EQ(model->desk()->journal()->search({}).size(), 1);
    type("engine_number", u"8"_s);
    answer(QMessageBox::Discard);
    press(Qt::Key_F4);
    EXPECT_EQ(model->desk()->journal()->search({}).size(), 1);
}

TEST_F(V8PageTest, CrashedDraftIsOffered) {
    JournalDraft draft;
    draft.session = u"crashed"_s;
    draft.scene = u"v8-plugs"_s;
    draft.engineNumber = u"99"_s;
    Input lost;
    lost.preset = "6 l";
    lost.engine = *find_preset("6 l");
    lost.job.engine_number = "99";
    draft.form = QByteArray::fromStdString(write_case({"v8-plugs", "", write_input(lost)}).dump());
    ASSERT_TRUE(model->desk()->journal()->saveDraft(draft));
    V8PlugsPage next(model->desk()->journal()->path(), nullptr);
    test::showAt(next, {1187, 712});
    auto* banner = next.findChild<QLabel*>(u"banner"_s);
    ASSERT_TRUE(banner->isVisible());
    EXPECT_TRUE(banner->text().contains(u"99"_s));
    QTest::mouseClick(next.findChild<QPushButton*>(u"draft_continue"_s), Qt::LeftButton);
    EXPECT_FALSE(banner->isVisible());
    EXPECT_EQ(next.viewModel()->input().job.engine_number, "99");
    EXPECT_EQ(next.viewModel()->input().preset, "6 l");
    // It is not offered twice.
    V8PlugsPage third(model->desk()->journal()->path(), nullptr);
    test::showAt(third, {1187, 712});
    EXPECT_FALSE(third.findChild<QLabel*>(u"banner"_s)->isVisible());
}

TEST_F(V8PageTest, CardIsPrintedOnOnePageAsThePdfIs) {
    type("engine_number", u"card"_s);
    type("rod_big_end", u"1"_s);
    const auto textOf = [](const QString& file) {
        QProcess reader;
        reader.start(QStringLiteral(PDFTOTEXT), {u"-layout"_s, file, u"-"_s});
        EXPECT_TRUE(reader.waitForFinished());
        return QString::fromUtf8(reader.readAllStandardOutput()).simplified();
    };
    const QString exported = QDir(folder.path()).filePath(u"exported.pdf"_s);
    ASSERT_EQ(page.writeCard(exported), QString());
    // A printer that prints into a file.
    const QString printed = QDir(folder.path()).filePath(u"printed.pdf"_s);
    QPrinter printer(QPrinter::HighResolution);
    printer.setOutputFormat(QPrinter::PdfFormat);
    printer.setOutputFileName(printed);
    PlugsCard::setPage(printer);
    ASSERT_TRUE(PlugsCard(model->input(), model->wholeSolution(), model->desk()->cardWords())
                    .print(printer));
    EXPECT_TRUE(textOf(exported).contains(u"card"_s));
    EXPECT_EQ(textOf(exported), textOf(printed));
    model->desk()->setCardLanguage(u"ru"_s);
    ASSERT_EQ(page.writeCard(exported), QString());
    EXPECT_TRUE(textOf(exported).contains(u"Номер двигателя"_s));
}

TEST_F(V8PageTest, TheCardWithholdsWhatThePageWithholds) {
    ASSERT_FALSE(model->input().changes_known());
    ASSERT_FALSE(model->solution().advice);
    model->desk()->setCardLanguage(u"en"_s);
    const QString file = QDir(folder.path()).filePath(u"unknown.pdf"_s);
    const auto card = [&] {
        EXPECT_EQ(page.writeCard(file), QString());
        QProcess reader;
        reader.start(QStringLiteral(PDFTOTEXT), {u"-layout"_s, file, u"-"_s});
        EXPECT_TRUE(reader.waitForFinished());
        return QString::fromUtf8(reader.readAllStandardOutput()).simplified();
    };
    const QString printed = card();
    EXPECT_TRUE(printed.contains(u"The data are not complete; nothing can be advised."_s))
        << qPrintable(printed);
    EXPECT_TRUE(printed.contains(u"Not known without: changes of mass (sheet 1)"_s))
        << qPrintable(printed);
    EXPECT_FALSE(printed.contains(u"Excess on each crankpin"_s)) << qPrintable(printed);
    // Whether a plug does is not known either; the engine has it.
    EXPECT_FALSE(printed.contains(u"works"_s)) << qPrintable(printed);
    EXPECT_FALSE(printed.contains(u"no such plug"_s)) << qPrintable(printed);
    EXPECT_FALSE(printed.contains(u"Neglected by the method"_s)) << qPrintable(printed);
    type("rod_big_end", u"0"_s);
    ASSERT_TRUE(model->solution().advice);
    EXPECT_TRUE(card().contains(u"Excess on each crankpin"_s));
}

TEST_F(V8PageTest, PreviewShowsTheCardOnOnePage) {
    int pages = 0;
    whenModal<QPrintPreviewDialog>([&pages](QPrintPreviewDialog* dialog) {
        if (auto* preview = dialog->findChild<QPrintPreviewWidget*>()) {
            pages = preview->pageCount();
        }
        dialog->reject();
    });
    for (QAction* action : page.sceneActions()) {
        if (action != nullptr && action->objectName() == u"preview_card"_s) {
            action->trigger();
        }
    }
    EXPECT_EQ(pages, 1);
}

TEST_F(V8PageTest, LongJournalSaysThatTheListIsCutAndExportsAll) {
    JournalJob job;
    job.scene = u"v8-plugs"_s;
    job.date = QDate(2024, 5, 31);
    QSqlDatabase database = QSqlDatabase::database(QSqlDatabase::connectionNames().constFirst());
    database.transaction();  // one sync for all
    for (int i = 0; i < 1005; ++i) {
        job.id = 0;
        job.engineNumber = u"many %1"_s.arg(i);
        ASSERT_EQ(model->desk()->journal()->save(job), Journal::Saved::Yes);
    }
    database.commit();
    JournalDialog dialog(model->desk()->journal(), u"v8-plugs"_s,
                         [](const Words&, const JournalJob& job) {
                             return ListedJob{job.engine, job.recommended};
                         });
    EXPECT_EQ(dialog.findChild<QTableWidget*>(u"journal_table"_s)->rowCount(), 1000);
    bool said = false;
    for (const QLabel* each : dialog.findChildren<QLabel*>()) {
        said = said || each->text().contains(u"1000"_s);
    }
    EXPECT_TRUE(said);
    const QString file = QDir(folder.path()).filePath(u"list.csv"_s);
    EXPECT_EQ(dialog.exportTo(file), QString());
    QFile list(file);
    ASSERT_TRUE(list.open(QIODevice::ReadOnly));
    EXPECT_EQ(list.readAll().count('\n'), 1006);  // and the headings
}

TEST_F(V8PageTest, JournalDialogExportsWhatItLists) {
    for (const QString& number : {u"A-1"_s, u"B-2"_s}) {
        model->newJob();
        type("engine_number", number);
        press(Qt::Key_F2);
    }
    JournalDialog dialog(model->desk()->journal(), u"v8-plugs"_s,
                         [](const Words&, const JournalJob& job) {
                             return ListedJob{job.engine, job.recommended};
                         });
    dialog.findChild<QLineEdit*>(u"journal_search"_s)->setText(u"b-"_s);
    const QString file = QDir(folder.path()).filePath(u"list.csv"_s);
    EXPECT_EQ(dialog.exportTo(file), QString());
    QFile csv(file);
    ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
    const QByteArray text = csv.readAll();
    EXPECT_TRUE(text.contains("B-2"));
    EXPECT_FALSE(text.contains("A-1"));
    EXPECT_FALSE(dialog.exportTo(QDir(folder.path()).filePath(u"no/list.csv"_s)).isEmpty());
    // Remove asks first.
    answer(QMessageBox::Yes);
    QTest::mouseClick(dialog.findChild<QPushButton*>(u"journal_remove"_s), Qt::LeftButton);
    EXPECT_EQ(model->desk()->journal()->search({}).size(), 1);
    // Days.
    auto* from = dialog.findChild<CheckedField*>(u"journal_from"_s);
    const auto says = [&](const QString& text) {
        const auto labels = dialog.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* each) { return each->text().contains(text); });
    };
    dialog.findChild<QLineEdit*>(u"journal_search"_s)->clear();
    QTest::keyClicks(from, u"31.02.2024"_s);
    EXPECT_TRUE(says(u"is no date"_s));
    from->selectAll();
    QTest::keyClick(from, Qt::Key_Delete);
    EXPECT_FALSE(says(u"is no date"_s));
    EXPECT_TRUE(says(u"Jobs found: 1"_s)) << "the list is said again";
    EXPECT_EQ(dialog.findChild<QTableWidget*>(u"journal_table"_s)->rowCount(), 1);
    // Reversed, no day lies between them.
    auto* to = dialog.findChild<CheckedField*>(u"journal_to"_s);
    QTest::keyClicks(from, u"31.12.2199"_s);
    QTest::keyClicks(to, u"2024-01-01"_s);
    EXPECT_TRUE(says(u"no day lies between"_s));
    EXPECT_TRUE(from->isDoubtful() && to->isDoubtful());
    for (CheckedField* day : {from, to}) {
        day->selectAll();
        QTest::keyClick(day, Qt::Key_Delete);
    }
    EXPECT_FALSE(says(u"no day lies between"_s));
    EXPECT_FALSE(from->isDoubtful());
    // Enter opens the one that is found.
    QTest::keyClick(dialog.findChild<QLineEdit*>(u"journal_search"_s), Qt::Key_Return);
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    EXPECT_GT(dialog.chosenId(), 0);
    EXPECT_EQ(readDay(u"2024-05-31"_s), QDate(2024, 5, 31));
    EXPECT_EQ(readDay(u" 1.2.24 "_s), QDate(2024, 2, 1));
    EXPECT_EQ(readDay(u"31.05.2024"_s), QDate(2024, 5, 31));
    EXPECT_FALSE(readDay(u"32.05.2024"_s).isValid());
    for (const char* language : {"en", "ru"}) {  // what is shown is read
        const QString shown = Words(QString::fromLatin1(language)).day(u"2024-05-31"_s);
        EXPECT_EQ(readDay(shown), QDate(2024, 5, 31)) << qPrintable(shown);
    }
}

}  // namespace
}  // namespace ravnoves
