// Every page in Russian: no label, button, tab, heading, list or tooltip is left in English.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractFileIconProvider>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QSet>
#include <QTabWidget>
#include <QTableView>
#include <QTextBrowser>
#include <algorithm>

#include "events.h"
#include "language/catalogue.h"
#include "model/background_job.h"
#include "page/scene_page.h"
#include "scene_tests.h"
#include "scenes/open_example.h"
#include "shell/help_window.h"
#include "shell/main_window.h"
#include "shell/scene_list.h"
#include "text/key_words.h"
#include "text/language.h"
#include "text/message_text.h"
#include "text/preferences.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

QString bare(QString text) {
    return text.remove(u'&').simplified();
}

/// English texts that Russian says otherwise, in every place where they occur.
QSet<QString> englishTexts() {
    QSet<QString> texts;
    QSet<QString> alike;  // "M₁₂", "DXF": the same in both
    for (const test::CatalogueEntry& entry : test::readCatalogue(test::russianFile())) {
        const QString source = bare(entry.source);
        if (entry.translations.isEmpty() || bare(entry.translations.constFirst()) == source) {
            alike.insert(source);
        } else {
            texts.insert(source);
        }
    }
    return texts.subtract(alike);
}

/// Two English words in a row: a sentence that went round the catalogue.
bool readsEnglish(QString text) {
    static const QRegularExpression names(
        u"Volkswagen VR\\d|Ravnoves|GNU General Public License|DejaVu Sans Condensed|"
        u"\\S+\\.(json|csv|dxf|pdf|png)\\S*|<[^>]*>"_s);
    static const QRegularExpression words(u"\\b[A-Za-z][a-z]{2,}[ ,]+[a-z]{3,}\\b"_s);
    return text.remove(names).contains(words);
}

void addModel(const QAbstractItemModel& model, QStringList& texts) {
    for (int column = 0; column < model.columnCount(); ++column) {
        texts << model.headerData(column, Qt::Horizontal).toString()
              << model.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString();
    }
    const int rows = std::min(model.rowCount(), 50);
    for (int row = 0; row < rows; ++row) {
        texts << model.headerData(row, Qt::Vertical).toString();
        for (int column = 0; column < model.columnCount(); ++column) {
            const QModelIndex at = model.index(row, column);
            texts << at.data().toString() << at.data(Qt::ToolTipRole).toString();
        }
    }
}

/// What a person can read on a widget, tooltips and spoken names included.
QStringList textsOf(const QWidget& widget) {
    QStringList texts{widget.toolTip(), widget.accessibleName(), widget.accessibleDescription()};
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
        texts << label->text();
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        texts << button->text();
    } else if (const auto* group = qobject_cast<const QGroupBox*>(&widget)) {
        texts << group->title();
    } else if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) {
        texts << line->placeholderText() << line->text();
    } else if (const auto* menu = qobject_cast<const QMenu*>(&widget)) {
        texts << menu->title();
    } else if (const auto* tabs = qobject_cast<const QTabWidget*>(&widget)) {
        for (int i = 0; i < tabs->count(); ++i) {
            texts << tabs->tabText(i) << tabs->tabToolTip(i);
        }
    } else if (const auto* list = qobject_cast<const QComboBox*>(&widget)) {
        for (int i = 0; i < list->count(); ++i) {
            texts << list->itemText(i);
        }
    } else if (const auto* table = qobject_cast<const QTableView*>(&widget)) {
        addModel(*table->model(), texts);
    }
    return texts;
}

QStringList textsBelow(QWidget& root) {
    QStringList texts = textsOf(root);
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
        texts << textsOf(*widget);
    }
    for (const QAction* action : root.findChildren<QAction*>()) {
        texts << action->text() << action->toolTip() << action->statusTip();
    }
    texts.removeDuplicates();
    return texts;
}

QStringList englishAmong(const QStringList& texts) {
    static const QSet<QString> english = englishTexts();
    QStringList found;
    for (const QString& text : texts) {
        if (english.contains(bare(text)) || readsEnglish(text)) {
            found << text;
        }
    }
    return found;
}

/// The page with every tab shown once, so that what is filled when it is shown is filled.
QStringList textsOfScene(MainWindow& window, const QString& scene) {
    EXPECT_TRUE(window.showScene(scene));
    QApplication::processEvents();
    ScenePage* page = window.currentPage();
    if (page == nullptr) {
        return {};
    }
    QStringList texts;
    test::onEveryTab(*page, [&] { texts << textsBelow(*page); });
    EXPECT_TRUE(test::comes([&] { return !page->isBusy(); }));
    texts << textsBelow(*page);
    texts.removeDuplicates();
    return texts;
}

class RussianPage : public ::testing::TestWithParam<std::string> {
  protected:
    ~RussianPage() override { installLanguage(u"en"_s); }
};

/// Pages are made again in another language, as they are made there at first.
TEST_P(RussianPage, LeavesNoTextInEnglishThoughItsWindowWasOpenBefore) {
    installLanguage(u"en"_s);
    MainWindow window;
    test::showAt(window, {1280, 800});
    const QString scene = QString::fromStdString(GetParam());
    // The search finds English where it stands …
    EXPECT_GT(englishAmong(textsOfScene(window, scene)).size(), 20);
    // … and there is none.
    Preferences::instance().setLanguage(u"ru"_s);
    QApplication::processEvents();
    EXPECT_EQ(window.currentScene(), scene);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    for (const QString& text : englishAmong(textsOfScene(window, scene) + textsBelow(window))) {
        ADD_FAILURE() << "in English: " << text.toStdString();
    }
    Preferences::instance().setLanguage({});
}

TEST_P(RussianPage, SaysBehindItsHintWhatAnEmptyFieldStandsFor) {
    for (const auto& [language, empty] :
         {std::pair(u"en"_s, u"Empty: "_s), std::pair(u"ru"_s, u"Пусто: "_s)}) {
        installLanguage(language);
        const auto page = test::makePage(GetParam());
        test::openExample(*page->model());
        const QString texts = textsBelow(*page).join(u'\n');
        for (const FieldEntry& entry : page->model()->describedFields()) {
            // How a file is read is no field of a form.
            const std::string_view key = entry.field.key;
            const bool isOfFile = key == "unit" || key == "gauge" || key == "columns";
            if (!entry.field.if_empty.empty() && !isOfFile) {
                const QString hint = shownText(entry.field.hint);
                const QString wanted = (hint.isEmpty() ? hint : hint + u' ') + empty +
                                       shownText(entry.field.if_empty) + u'.';
                EXPECT_TRUE(texts.contains(wanted))
                    << entry.pointer << ": " << wanted.toStdString();
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, RussianPage, ::testing::ValuesIn(test::sceneNames()),
                         test::sceneOf<::testing::TestParamInfo<std::string>>);

/// What a report calls an object or a field that no form names.
TEST(KeysInWords, AreThereToTranslate) {
    QStringList words;
    for (const test::CatalogueEntry& entry : test::readCatalogue(
             QStringLiteral(RAVNOVES_SOURCE "/resources/translations/extra_ru.ts"))) {
        words << entry.source;
    }
    for (const std::string& scene : test::sceneNamesWithCases()) {
        const auto page = test::makePage(scene);
        for (const FieldEntry& entry : page->model()->describedFields()) {
            QStringList keys =
                QString::fromStdString(entry.pointer).split(u'/', Qt::SkipEmptyParts);
            if (!entry.field.label.empty()) {
                keys.removeLast();
            }
            for (const QString& key : keys) {
                bool isPlace = false;
                key.toInt(&isPlace);
                const QString shown = keyInWords(key.toStdString());
                EXPECT_TRUE(isPlace || words.contains(shown)) << scene << entry.pointer;
            }
        }
    }
}

class RussianWindow : public ::testing::Test {
  protected:
    RussianWindow() { installLanguage(u"ru"_s); }
    ~RussianWindow() override { installLanguage(u"en"_s); }
};

TEST_F(RussianWindow, HasNoEnglishFolderInItsFileDialogs) {
    EXPECT_EQ(QAbstractFileIconProvider().type(QFileInfo(QDir::homePath())), u"Папка"_s);
}

TEST_F(RussianWindow, HasHelpInRussianOnEveryTopic) {
    QStringList topics{u"keys"_s, u"case-files"_s};
    for (const std::string& scene : test::sceneNames()) {
        topics << QString::fromStdString(scene);
    }
    static const QRegularExpression letters(u"[А-Яа-яЁё]"_s);
    for (const QString& topic : topics) {
        HelpWindow help(topic, nullptr);
        const QString text = help.findChild<QTextBrowser*>()->toPlainText();
        EXPECT_FALSE(text.contains(QChar(0x307)) || text.contains(QChar(0x308)))
            << topic.toStdString() << ": combining dots, which stand over the line above";
        EXPECT_GT(text.count(letters), 400) << topic.toStdString();
    }
}

}  // namespace
}  // namespace ravnoves
