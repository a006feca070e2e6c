// Settings hold once they are accepted: in the window that is open, with what is on its pages.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QSettings>
#include <QTabWidget>

#include "case-file/json.h"
#include "events.h"
#include "page/scene_page.h"
#include "shell/main_window.h"
#include "shell/settings_dialog.h"
#include "studies/tolerance_window.h"
#include "text/language.h"
#include "text/number_text.h"
#include "text/preferences.h"
#include "theme/theme.h"
#include "widgets/number_field.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class Settings : public ::testing::Test {
  protected:
    Settings() { test::showAt(window, {1280, 800}); }
    ~Settings() override {
        QSettings().clear();
        installLanguage(u"en"_s);
        Preferences::instance().load();
        Theme::instance().setTextScale(1.0);
        Theme::instance().setMode(Theme::Mode::Light);
    }

    SettingsDialog* open() {
        if (window.findChild<SettingsDialog*>() == nullptr) {
            window.activateWindow();
            QApplication::processEvents();
            QTest::keyClick(&window, Qt::Key_Comma, Qt::ControlModifier);
            QApplication::processEvents();
        }
        auto* dialog = window.findChild<SettingsDialog*>();
        EXPECT_NE(dialog, nullptr);
        return dialog;
    }
    /// Chooses by the keyboard, as a user does.
    void choose(const char* name, const QVariant& data) {
        SettingsDialog* dialog = open();
        auto* box = test::named<QComboBox>(*dialog, name);
        const int wanted = box->findData(data);
        ASSERT_GE(wanted, 0) << name;
        box->setFocus();
        while (box->currentIndex() != wanted) {
            const int before = box->currentIndex();
            QTest::keyClick(box, before < wanted ? Qt::Key_Down : Qt::Key_Up);
            ASSERT_NE(box->currentIndex(), before) << name;
        }
        QTest::keyClick(dialog, Qt::Key_Return);
        ASSERT_FALSE(dialog->isVisible());
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QApplication::processEvents();
    }
    template <typename Widget>
    Widget* onPage(const char* name) {
        return test::named<Widget>(*window.currentPage(), name);
    }
    bool hasLabel(const QString& text) {
        const auto labels = window.currentPage()->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->text().remove(u'&') == text; });
    }

    MainWindow window;
};

TEST_F(Settings, UnitsChangeAtOnceAndTheCaseStays) {
    window.showScene(u"balance-shaft"_s);
    SceneModel* model = window.currentPage()->model();
    const Json before = model->inputJson();
    EXPECT_TRUE(hasLabel(u"mm"_s));
    choose("length_unit", static_cast<int>(Preferences::Units::Imperial));
    EXPECT_TRUE(hasLabel(u"in"_s));
    EXPECT_FALSE(hasLabel(u"mm"_s));
    EXPECT_EQ(window.currentPage()->model(), model);
    EXPECT_EQ(model->inputJson(), before);
    EXPECT_FALSE(window.isWindowModified());
}

TEST_F(Settings, LanguageChangesAtOnceAndThePageGoesOn) {
    window.showScene(u"elastic-hinge"_s);
    SceneModel* model = window.currentPage()->model();
    auto* tabs = window.currentPage()->findChildren<QTabWidget*>().constLast();
    const int tab = tabs->count() - 1;
    ASSERT_GT(tab, 0);
    tabs->setCurrentIndex(tab);
    model->setByKey(u"lambda"_s, u"0.4"_s);
    const Json before = model->inputJson();
    const QString field =
        test::named<NumberField>(*window.currentPage(), "crank_radius_mm")->accessibleName();

    choose("language", u"ru"_s);
    QApplication::processEvents();

    EXPECT_EQ(currentLanguage(), u"ru"_s);
    EXPECT_EQ(window.menuBar()->actions().constFirst()->text().remove(u'&'), u"Файл"_s);
    EXPECT_TRUE(window.windowTitle().contains(u" (изменено)[*]"_s));
    EXPECT_EQ(window.currentScene(), u"elastic-hinge"_s);
    EXPECT_EQ(window.currentPage()->model(), model);
    EXPECT_EQ(model->inputJson(), before);
    EXPECT_EQ(window.currentPage()->findChildren<QTabWidget*>().constLast()->currentIndex(), tab);
    EXPECT_NE(test::named<NumberField>(*window.currentPage(), "crank_radius_mm")->accessibleName(),
              field);
    EXPECT_TRUE(onPage<QLineEdit>("crank_radius_mm")->isEnabled());
    // The history is the same: one step back is the value of before.
    window.activateWindow();
    QApplication::processEvents();
    ASSERT_TRUE(model->history()->canUndo());
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NE(model->inputJson(), before);
    // For the next start, too.
    installLanguage();
    EXPECT_EQ(currentLanguage(), u"ru"_s);
}

TEST_F(Settings, TabsAreKeptAlsoAfterTheWindowWasNarrow) {
    window.resize(1280, 800);
    window.showScene(u"inertia-moments"_s);
    QApplication::processEvents();
    QStringList chosen;
    for (QTabWidget* tabs : window.currentPage()->findChildren<QTabWidget*>()) {
        tabs->setCurrentIndex(1);
        chosen << tabs->tabToolTip(1) + tabs->tabText(1);
    }
    for (const QSize& size : {QSize(920, 620), QSize(1280, 800)}) {
        window.resize(size);
        for (int i = 0; i < 5; ++i) {
            QApplication::processEvents();
        }
    }
    chosen.sort();
    const auto now = [this] {
        QStringList all;
        for (const QTabWidget* tabs : window.currentPage()->findChildren<QTabWidget*>()) {
            all << tabs->tabToolTip(tabs->currentIndex()) + tabs->tabText(tabs->currentIndex());
        }
        all.sort();
        return all;
    };
    ASSERT_EQ(now(), chosen);
    choose("language", u"ru"_s);
    choose("language", u"en"_s);
    QApplication::processEvents();
    EXPECT_EQ(now(), chosen);
}

TEST_F(Settings, TheLanguageInUseIsShown) {
    installLanguage(u"ru"_s);  // as by --language
    EXPECT_EQ(test::named<QComboBox>(*open(), "language")->currentData(), u"ru"_s);
}

TEST_F(Settings, AnEditingEndsWithItsValueWhenThePageIsMadeAgain) {
    window.showScene(u"balance-shaft"_s);
    auto* field = onPage<NumberField>("crank_radius_mm");
    test::typeOver(field, u"50"_s);
    Preferences::instance().setLanguage(u"ru"_s);
    QApplication::processEvents();
    SceneModel* model = window.currentPage()->model();
    EXPECT_FALSE(model->isEditing());
    EXPECT_TRUE(model->history()->canUndo());
    EXPECT_EQ(onPage<NumberField>("crank_radius_mm")->value(), 50.0);
    EXPECT_NE(onPage<NumberField>("crank_radius_mm"), field);
}

TEST_F(Settings, WhatWasChosenBesideTheCaseSurvivesANewPage) {
    const auto choose = [this](const char* name, Qt::Key key) {
        auto* box = onPage<QComboBox>(name);
        box->setFocus();
        QTest::keyClick(box, key);
    };
    window.showScene(u"elastic-hinge"_s);
    choose("export_hinge", Qt::Key_End);
    const int branch = 1 - onPage<QComboBox>("export_branch")->currentIndex();
    choose("export_branch", branch == 0 ? Qt::Key_Up : Qt::Key_Down);
    choose("export_turns", Qt::Key_Down);
    test::type(onPage<NumberField>("chord_tolerance_mm"), u"0.01"_s);
    test::type(onPage<NumberField>("step_deg"), u"2"_s);
    window.showScene(u"balance-shaft"_s);
    choose("map_criterion", Qt::Key_End);
    const auto speedCriterion = [this] {
        return window.currentPage()->findChild<QWidget*>(u"speed"_s)->findChild<QComboBox*>();
    };
    speedCriterion()->setFocus();
    QTest::keyClick(speedCriterion(), Qt::Key_End);

    Preferences::instance().setLanguage(u"ru"_s);
    QApplication::processEvents();
    EXPECT_EQ(onPage<QComboBox>("map_criterion")->currentIndex(), 1);
    EXPECT_EQ(speedCriterion()->currentIndex(), 1);
    window.showScene(u"elastic-hinge"_s);
    EXPECT_EQ(onPage<QComboBox>("export_hinge")->currentIndex(), 2);
    EXPECT_EQ(onPage<QComboBox>("export_branch")->currentIndex(), branch);
    EXPECT_EQ(onPage<QComboBox>("export_turns")->currentIndex(), 1);
    EXPECT_EQ(onPage<NumberField>("chord_tolerance_mm")->value(), 0.01);
    EXPECT_EQ(onPage<NumberField>("step_deg")->value(), 2.0);
}

TEST_F(Settings, TheToleranceWindowIsOpenAgainInAnotherLanguage) {
    window.showScene(u"balance-shaft"_s);
    QTest::keyClick(&window, Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
    QApplication::processEvents();
    const auto shown = [this] {
        QList<ToleranceWindow*> open = window.findChildren<ToleranceWindow*>();
        open.removeIf([](const ToleranceWindow* each) { return !each->isVisible(); });
        return open;
    };
    ASSERT_EQ(shown().size(), 1);
    const QString title = shown().front()->windowTitle();
    Preferences::instance().setLanguage(u"ru"_s);
    QApplication::processEvents();
    ASSERT_EQ(shown().size(), 1);
    EXPECT_EQ(shown().front()->page(), window.currentPage());
    EXPECT_NE(shown().front()->windowTitle(), title);
}

TEST_F(Settings, TextGrowsAtOnce) {
    window.showScene(u"balance-shaft"_s);
    const int before = onPage<NumberField>("crank_radius_mm")->font().pixelSize();
    choose("text", 150);
    QApplication::processEvents();
    EXPECT_EQ(onPage<NumberField>("crank_radius_mm")->font().pixelSize(), qRound(1.5 * before));
    EXPECT_EQ(QSettings().value(u"view/text"_s).toInt(), 150);
}

TEST_F(Settings, ThemeOfTheMenuAndOfTheSettingsIsOne) {
    choose("theme", static_cast<int>(Theme::Mode::Dark));
    EXPECT_TRUE(Theme::instance().isDark());
    EXPECT_EQ(QSettings().value(u"view/theme"_s).toInt(), static_cast<int>(Theme::Mode::Dark));
}

TEST_F(Settings, DigitsOfResults) {
    const auto shown = [](double value, int decimals) {
        return fixedNumber(value, decimals, QLocale(QLocale::English));
    };
    EXPECT_EQ(shown(1234.5678, 1), u"1234.6"_s);
    choose("digits", 6);
    QApplication::processEvents();
    EXPECT_EQ(shown(1234.5678, 1), u"1234.57"_s);
    EXPECT_EQ(shown(-2.5, 0), u"−2.50000"_s);
    EXPECT_EQ(shown(12.0, 0), u"12"_s);
    EXPECT_EQ(shown(0.0, 2), u"0.00"_s);
}

TEST_F(Settings, EveryRowOfTheDialogIsSpokenAndHasAKey) {
    SettingsDialog* dialog = open();
    const auto boxes = dialog->findChildren<QComboBox*>();
    EXPECT_GE(boxes.size(), 4);
    for (const QComboBox* box : boxes) {
        EXPECT_FALSE(box->accessibleName().isEmpty());
        // Without a description a screen reader has the tip.
        EXPECT_FALSE(box->accessibleDescription().isEmpty() && box->toolTip().isEmpty());
        EXPECT_GE(box->currentIndex(), 0);
    }
    QTest::keyClick(dialog, Qt::Key_Escape);
    EXPECT_FALSE(dialog->isVisible());
}

}  // namespace
}  // namespace ravnoves
