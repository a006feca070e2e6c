#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>
#include <QWhatsThis>

#include "events.h"
#include "shell/help_pages.h"
#include "shell/help_window.h"
#include "shell/scene_list.h"
#include "shell/scene_page.h"
#include "shell/whats_this.h"
#include "text/language.h"
#include "text/preferences.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/result_table.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class HelpSearch : public ::testing::Test {
  protected:
    HelpSearch() { test::showAt(help, {980, 680}); }

    /// The marked word that the list stands at, as the page shows it.
    QString present() const {
        for (const auto& mark : text->extraSelections()) {
            if (mark.format.background().color() == Theme::instance().accent()) {
                return mark.cursor.selectedText();
            }
        }
        return {};
    }

    HelpWindow help{u"keys"_s};
    QLineEdit* field = test::named<QLineEdit>(help, "help-search");
    QLabel* count = test::named<QLabel>(help, "help-count");
    QListWidget* list = test::named<QListWidget>(help, "help-list");
    QTextBrowser* text = help.findChild<QTextBrowser*>();
};

TEST_F(HelpSearch, WithoutWordsListsThePages) {
    EXPECT_EQ(list->count(), helpTopics().size());
    EXPECT_EQ(list->currentItem()->text(), u"Keys and mouse"_s);
    QTest::keyClick(list, Qt::Key_Home);
    EXPECT_EQ(help.topic(), u"balance-shaft"_s);
    EXPECT_TRUE(text->toPlainText().contains(u"Gots"_s));
}

TEST_F(HelpSearch, FindsInAllPagesWithContext) {
    QTest::keyClick(&help, Qt::Key_F, Qt::ControlModifier);
    EXPECT_TRUE(field->hasFocus());
    QTest::keyClicks(field, u"PRELOAD"_s);
    EXPECT_EQ(help.topic(), u"elastic-hinge"_s);
    const int found = count->text().toInt();
    EXPECT_GE(found, 2);
    ASSERT_NE(list->currentItem(), nullptr);
    EXPECT_TRUE(list->currentItem()->text().contains(u"preload"_s, Qt::CaseInsensitive));
    EXPECT_EQ(present().toLower(), u"preload"_s);
    EXPECT_TRUE(text->viewport()->rect().intersects(text->cursorRect()));

    // Round through all of them and back to the first, forwards and backwards.
    const int first = list->currentRow();
    QSet<int> rows;
    for (int i = 0; i < found; ++i) {
        rows << list->currentRow();
        EXPECT_EQ(present().toLower(), u"preload"_s);
        QTest::keyClick(&help, Qt::Key_F3);
    }
    EXPECT_EQ(rows.size(), found);
    EXPECT_EQ(list->currentRow(), first);
    test::named<QToolButton>(help, "help-previous")->click();
    const int last = list->currentRow();
    EXPECT_NE(last, first);
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(list->currentRow(), first);
    QTest::keyClick(field, Qt::Key_Return, Qt::ShiftModifier);
    EXPECT_EQ(list->currentRow(), last);

    QTest::keyClick(field, Qt::Key_Escape);
    EXPECT_TRUE(help.isVisible());
    EXPECT_TRUE(field->text().isEmpty());
    EXPECT_EQ(list->count(), helpTopics().size());
    EXPECT_TRUE(text->extraSelections().isEmpty());
    QTest::keyClick(field, Qt::Key_Escape);
    EXPECT_FALSE(help.isVisible());
}

TEST_F(HelpSearch, ALetterThatStandsEverywhereIsNotListedThousandsOfTimes) {
    field->setText(u"e"_s);
    EXPECT_TRUE(count->text().endsWith(u'+'));
    EXPECT_LT(list->count(), 100 * helpTopics().size());
    field->setText(u"eccentricity of nothing"_s);
    EXPECT_FALSE(count->text().endsWith(u'+'));
}

TEST_F(HelpSearch, FindsWordsThatStandApart) {
    field->setText(u"cutting planes"_s);
    EXPECT_GE(count->text().toInt(), 1);
    field->setText(u"planes cutting"_s);
    EXPECT_GE(count->text().toInt(), 1);
    EXPECT_TRUE(text->toPlainText().contains(u"cutting planes"_s));
}

TEST_F(HelpSearch, SaysWhenThereIsNothing) {
    field->setText(u"carburettor"_s);
    EXPECT_EQ(count->text(), u"nothing found"_s);
    EXPECT_EQ(list->count(), 0);
    EXPECT_FALSE(test::named<QToolButton>(help, "help-next")->isEnabled());
    QTest::keyClick(&help, Qt::Key_F3);
    EXPECT_EQ(help.topic(), u"keys"_s);
}

TEST_F(HelpSearch, FollowsLanguageAndTheme) {
    installLanguage(u"ru"_s);
    Preferences::instance().tell();
    QApplication::processEvents();
    EXPECT_EQ(help.windowTitle(), u"Справка"_s);
    EXPECT_EQ(list->currentItem()->text(), u"Клавиши и мышь"_s);
    EXPECT_TRUE(field->placeholderText().contains(u"Ctrl+F"_s));
    EXPECT_FALSE(field->placeholderText().contains(u"Search"_s));
    EXPECT_EQ(help.topic(), u"keys"_s);
    EXPECT_FALSE(text->toPlainText().contains(u"Keys and mouse"_s));
    installLanguage(u"en"_s);
    Preferences::instance().tell();
    QApplication::processEvents();
    EXPECT_EQ(list->currentItem()->text(), u"Keys and mouse"_s);
    field->setText(u"wheel"_s);
    Theme::instance().setMode(Theme::Mode::Dark);
    EXPECT_EQ(present().toLower(), u"wheel"_s);
    Theme::instance().setMode(Theme::Mode::Light);
}

// The list measures a title as it draws it: none is cut where it wraps.
TEST_F(HelpSearch, TitlesOfPagesAreReadWhole) {
    for (int i = 0; i < list->count(); ++i) {
        const QRect row = list->visualItemRect(list->item(i));
        constexpr int beside = 12;
        const QRect needed = list->fontMetrics().boundingRect(
            QRect(0, 0, row.width() - beside, 1000), Qt::TextWordWrap, list->item(i)->text());
        EXPECT_GE(row.height(), needed.height()) << list->item(i)->text().toStdString();
    }
}

TEST(HelpPages, LeaveRoomBetweenParagraphsAndShowTheirFigures) {
    for (const char* language : {"en", "ru"}) {
        installLanguage(QString::fromLatin1(language));
        for (const SceneInfo& info : sceneList()) {
            QTextDocument page;
            ASSERT_TRUE(loadHelp(info.name, &page));
            EXPECT_FALSE(helpTitle(page).isEmpty());
            bool figure = false;
            for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
                if (QTextCursor(block).currentTable() == nullptr && block.textList() == nullptr &&
                    !block.text().isEmpty()) {
                    EXPECT_GE(block.blockFormat().bottomMargin(), 8.0)
                        << block.text().toStdString();
                }
                for (auto part = block.begin(); !part.atEnd(); ++part) {
                    const QTextCharFormat format = part.fragment().charFormat();
                    figure = figure ||
                             (format.isImageFormat() &&
                              format.toImageFormat().name() == u"signs-%1.svg"_s.arg(info.name));
                }
            }
            EXPECT_EQ(figure, info.name != u"methods") << info.name.toStdString() << language;
            if (figure) {
                const QByteArray svg = themedSvg(u":/help/signs-%1.svg"_s.arg(info.name));
                EXPECT_FALSE(svg.isEmpty());
                EXPECT_FALSE(svg.contains("var(--"));
            }
        }
    }
    installLanguage(u"en"_s);
}

QWidget* shownExplanation() {
    for (QWidget* each : QApplication::topLevelWidgets()) {
        if (each->isVisible() && each->inherits("QWhatsThat")) {
            return each;
        }
    }
    return nullptr;
}

// Every field and every result of every page says what it is, where it says so at all: by its tip.
TEST(WhatsThisTest, ExplainsEveryFieldOfEveryPage) {
    for (const SceneInfo& info : sceneList()) {
        QWidget place;
        ScenePage* page = info.make(&place);
        test::showAt(place, {1280, 800});
        int explained = 0;
        for (QLineEdit* field : place.findChildren<QLineEdit*>()) {
            if (field->inherits("ravnoves::EntryField")) {
                EXPECT_FALSE(WhatsThis::explanation(field, {}).isEmpty())
                    << info.name.toStdString() << ": " << field->accessibleName().toStdString();
                ++explained;
            }
        }
        if (info.name != u"methods") {
            EXPECT_GT(explained, 3) << info.name.toStdString();
        }
        delete page;
    }
}

TEST(WhatsThisTest, ShiftF1ExplainsWhatHasTheFocus) {
    QWidget window;
    QLineEdit field(&window);
    field.setAccessibleName(u"Crank radius r"_s);
    field.setToolTip(u"Half the stroke. Source: Table 1 <of> the paper."_s);
    WhatsThis whatsThis(&window);
    test::showAt(window, {300, 200});
    window.activateWindow();
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_F1, Qt::ShiftModifier);
    QWidget* shown = shownExplanation();
    ASSERT_NE(shown, nullptr);
    EXPECT_EQ(WhatsThis::explanation(&field, {}),
              u"<p><b>Crank radius r</b></p><p>Half the stroke. Source: Table 1 &lt;of&gt; the "
              "paper.</p>"_s);
    QWhatsThis::hideText();
}

TEST(WhatsThisTest, AClickExplainsAResult) {
    QWidget window;
    ResultTable table(&window);
    table.setColumns({u"Criterion"_s, u"Value"_s});
    table.setRows({{u"Range"_s, u"1066.7"_s}});
    table.setCellToolTip(0, 1, u"Largest less least moment."_s);
    table.resize(280, 150);
    WhatsThis whatsThis(&window);
    test::showAt(window, {300, 200});
    whatsThis.action()->trigger();
    EXPECT_TRUE(QWhatsThis::inWhatsThisMode());
    const QPoint at = table.visualItemRect(table.item(0, 1)).center();
    EXPECT_TRUE(WhatsThis::explanation(table.viewport(), at).contains(u"<b>Range</b>"_s));
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, at);
    EXPECT_NE(shownExplanation(), nullptr);
    QWhatsThis::hideText();
    QWhatsThis::leaveWhatsThisMode();
}

}  // namespace
}  // namespace ravnoves
