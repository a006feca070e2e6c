#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTextBrowser>
#include <QWhatsThis>

#include "events.h"
#include "processor_time.h"
#include "shell/help_window.h"
#include "shell/scene_list.h"
#include "text/language.h"
#include "text/preferences.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/number_field.h"
#include "widgets/result_table.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class HelpSearch : public ::testing::Test {
  protected:
    HelpSearch() { test::showAt(help, {980, 680}); }
    QString topicOf(int row) const { return list->item(row)->data(Qt::UserRole).toString(); }

    HelpWindow help{u"keys"_s};
    QLineEdit* field = test::named<QLineEdit>(help, "help-search");
    QLabel* found = test::named<QLabel>(help, "help-found");
    QListWidget* list = test::named<QListWidget>(help, "help-list");
    QTextBrowser* text = help.findChild<QTextBrowser*>();
};

TEST_F(HelpSearch, ListsThePagesAndShowsTheChosenOne) {
    EXPECT_EQ(list->count(), std::ssize(sceneList()) + 4);
    EXPECT_EQ(list->currentItem()->text(), u"Keys and mouse"_s);
    QTest::keyClick(list, Qt::Key_Home);
    EXPECT_EQ(topicOf(list->currentRow()), u"balance-shaft"_s);
    EXPECT_TRUE(text->toPlainText().contains(u"Gots"_s));
}

TEST_F(HelpSearch, GoesRoundThePlacesOfThePage) {
    help.goTo(u"elastic-hinge"_s);
    QTest::keyClick(&help, Qt::Key_F, Qt::ControlModifier);
    EXPECT_TRUE(field->hasFocus());
    QTest::keyClicks(field, u"SPRING"_s);
    EXPECT_EQ(topicOf(list->currentRow()), u"elastic-hinge"_s);
    const auto at = [&] { return text->textCursor().selectionStart(); };
    EXPECT_EQ(text->textCursor().selectedText().toLower(), u"spring"_s);
    EXPECT_TRUE(text->viewport()->rect().intersects(text->cursorRect()));
    const int first = at();
    QTest::keyClick(&help, Qt::Key_F3);
    const int second = at();
    EXPECT_GT(second, first);
    QTest::keyClick(&help, Qt::Key_F3, Qt::ShiftModifier);
    EXPECT_EQ(at(), first);
    QTest::keyClick(&help, Qt::Key_F3, Qt::ShiftModifier);
    EXPECT_GT(at(), second) << "round the page";
    QTest::keyClick(&help, Qt::Key_F3);
    EXPECT_EQ(at(), first);
}

TEST_F(HelpSearch, SaysWhenThereIsNothing) {
    QTest::keyClicks(field, u"carburettor"_s);
    EXPECT_EQ(found->text(), u"nothing found"_s);
    field->clear();
    EXPECT_EQ(found->text(), QString());
    EXPECT_EQ(topicOf(list->currentRow()), u"keys"_s);
}

TEST_F(HelpSearch, IsNotLeftInAnotherLanguage) {
    Preferences::instance().tell();
    EXPECT_FALSE(help.isVisible());
}

// Tables of a shown page must not be laid out at each piece that is put in.
TEST_F(HelpSearch, ShowsEveryPageWithItsPicturesSoon) {
    for (int row = 0; row < list->count(); ++row) {
        const QString topic = topicOf(row);
        const test::ProcessorTime spent;
        help.goTo(topic);
        QApplication::processEvents();
        EXPECT_LT(spent.seconds(), 5.0) << topic.toStdString();
        for (const QTextFormat& format : text->document()->allFormats()) {
            if (format.isImageFormat()) {
                const QString name = format.toImageFormat().name();
                EXPECT_FALSE(text->loadResource(QTextDocument::ImageResource, QUrl(name)).isNull())
                    << name.toStdString();
            }
        }
    }
}

TEST(HelpPages, ShowTheirFigures) {
    for (const char* language : {"en", "ru"}) {
        installLanguage(QString::fromLatin1(language));
        for (const SceneInfo& info : sceneList()) {
            const HelpWindow help(info.name);
            EXPECT_FALSE(help.findChild<QListWidget*>()->currentItem()->text().isEmpty());
            const bool figure = help.findChild<QTextBrowser*>()->toHtml().contains(
                u"\"signs-%1.svg\""_s.arg(info.name));
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

TEST(WhatsThisTest, ShiftF1ExplainsWhatHasTheFocus) {
    QWidget window;
    NumberField field(&window);
    field.setHint(u"Half the stroke. Source: Table 1 <of> the paper."_s);
    test::showAt(window, {300, 200});
    window.activateWindow();
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_F1, Qt::ShiftModifier);
    EXPECT_NE(shownExplanation(), nullptr);
    QWhatsThis::hideText();
}

TEST(WhatsThisTest, AClickExplainsAResult) {
    QWidget window;
    ResultTable table(&window);
    table.setColumns({u"Criterion"_s, u"Value"_s});
    table.setRows({{u"Range"_s, u"1066.7"_s}});
    table.item(0, 1)->setToolTip(u"Largest less least moment."_s);
    table.resize(280, 150);
    test::showAt(window, {300, 200});
    QWhatsThis::enterWhatsThisMode();
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                      table.visualItemRect(table.item(0, 1)).center());
    EXPECT_NE(shownExplanation(), nullptr);
    QWhatsThis::hideText();
    QWhatsThis::leaveWhatsThisMode();
}

}  // namespace
}  // namespace ravnoves
