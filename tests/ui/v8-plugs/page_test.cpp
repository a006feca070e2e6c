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
#include <QPrintPreviewDialog>
#include <QPrintPreviewWidget>
#include <QPrinter>
#include <QProcess>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QSqlDatabase>
#include <QTabBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTimer>

#include "case-file/case_file.h"
#include "case-file/json.h"
#include "events.h"
#include "plot/plot_view.h"
#include "theme/theme.h"
#include "v8-plugs/model/v8_plugs_model.h"
#include "v8-plugs/plugs_card.h"
#include "v8-plugs/presets.h"
#include "v8-plugs/scene.h"
#include "widgets/number_field.h"
#include "widgets/result_table.h"
#include "workshop/checked_field.h"
#include "workshop/journal_dialog.h"

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
    QString label(const char* name) { return find<QLabel>(name)->text(); }

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

    /// A key that is an action's, wherever the focus is.
    void press(Qt::Key key) {
        page.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
        QTest::keyClick(&page, key);
    }

    /// Answers the next message box with a button.
    static void answer(QMessageBox::StandardButton button) {
        whenModal<QMessageBox>(
            [button](QMessageBox* box) { QTest::mouseClick(box->button(button), Qt::LeftButton); });
    }

    /// Acts on the next modal dialog as soon as it is there.
    template <typename Dialog, typename Act>
    static void whenModal(Act act) {
        QTimer::singleShot(10, qApp, [act] {
            if (auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget())) {
                act(dialog);
            } else {
                whenModal<Dialog>(act);
            }
        });
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
    EXPECT_TRUE(model->optionRows().at(0).constFirst().startsWith(u"! "_s));
    EXPECT_EQ(find<QLabel>("check")->palette().color(QPalette::WindowText),
              Theme::instance().warning());
    EXPECT_TRUE(model->optionToolTip(0).contains(u"By the method alone"_s));
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

TEST_F(V8PageTest, EveryFieldIsLargeNamedAndExplained) {
    for (int sheet = 0; sheet < page.sheets()->count(); ++sheet) {
        for (QWidget* each : page.fieldsOf(sheet)) {
            const QString name = each->objectName();
            EXPECT_FALSE(name.isEmpty());
            EXPECT_GE(each->minimumHeight(), qobject_cast<QCheckBox*>(each) != nullptr ? 0
                                             : sheet == 2                              ? 30
                                                                                       : 34)
                << qPrintable(name);
            if (qobject_cast<QCheckBox*>(each) == nullptr) {
                EXPECT_FALSE(each->accessibleName().isEmpty()) << qPrintable(name);
                EXPECT_FALSE(each->toolTip().isEmpty()) << qPrintable(name);
            }
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
    EXPECT_TRUE(thread->trouble().contains(u"M22x1.5"_s));
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
    EXPECT_TRUE(status.at(0).at(0).toString().contains(u"saved in the journal. Still needed:"_s));
    const auto job = model->desk()->journal()->job(model->desk()->jobId());
    ASSERT_TRUE(job);
    EXPECT_FALSE(job->unbalancedMass);
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
    EXPECT_TRUE(model->adviceText().startsWith(u"Still needed: New plug radius"_s));
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
    ASSERT_TRUE(PlugsCard(model->input(), model->desk()->cardWords()).print(printer));
    EXPECT_TRUE(textOf(exported).contains(u"card"_s));
    EXPECT_EQ(textOf(exported), textOf(printed));
    model->desk()->setCardLanguage(u"ru"_s);
    ASSERT_EQ(page.writeCard(exported), QString());
    EXPECT_TRUE(textOf(exported).contains(u"Номер двигателя"_s));
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
    EXPECT_EQ(readDay(u"2024-05-31"_s), QDate(2024, 5, 31));
    EXPECT_EQ(readDay(u" 1.2.24 "_s), QDate(2024, 2, 1));
    EXPECT_EQ(readDay(u"31.05.2024"_s), QDate(2024, 5, 31));
    EXPECT_FALSE(readDay(u"32.05.2024"_s).isValid());
}

}  // namespace
}  // namespace ravnoves
