#include "pictures/file_dialogs.h"

#include <gtest/gtest.h>

#include <QMessageBox>
#include <QTemporaryDir>

#include "events.h"
#include "files.h"

namespace ravnoves {
namespace {

class FileDialogsTest : public ::testing::Test {
  protected:
    FileDialogsTest() {
        fileChoosers().save = [this](QWidget*, const QString&, const QString& suggestion,
                                     const QString& filters, QString* filter) {
            suggestions << suggestion;
            *filter = filters.section(QStringLiteral(";;"), chosen, chosen);
            return typed.isEmpty() ? QString() : typed.takeFirst();
        };
    }
    ~FileDialogsTest() override { fileChoosers() = before; }
    QString file(const char* name) const { return folder.filePath(QString::fromUtf8(name)); }
    QString make(const char* name) {
        test::writeFile(file(name), {});
        return file(name);
    }
    /// Answers the message boxes that come, in order, and keeps what they say.
    void answer(std::vector<QMessageBox::StandardButton> buttons) {
        test::whenModal<QMessageBox>(&parent, [this, buttons](QMessageBox* box) {
            said << box->text();
            if (buttons.size() > 1) {
                answer({buttons.begin() + 1, buttons.end()});
            }
            QTest::mouseClick(box->button(buttons.front()), Qt::LeftButton);
        });
    }
    QString ask() { return askSavePath(&parent, QStringLiteral("Save"), file("s"), formats); }

    FileChoosers before = fileChoosers();
    QTemporaryDir folder;
    QWidget parent;
    QList<FileFormat> formats{{QStringLiteral("png"), QStringLiteral("Picture")},
                              {QStringLiteral("svg"), QStringLiteral("Drawing")}};
    int chosen = 0;
    QStringList typed;
    QStringList suggestions;
    QStringList said;
};

TEST_F(FileDialogsTest, TheSuffixTypedDecidesElseTheFormatChosen) {
    const auto completed = [&](const char* name, qsizetype format = 0) {
        return completedPath(QString::fromUtf8(name), formats, format);
    };
    EXPECT_EQ(completed("plot"), QStringLiteral("plot.png"));
    EXPECT_EQ(completed("plot", 1), QStringLiteral("plot.svg"));
    EXPECT_EQ(completed("plot.svg"), QStringLiteral("plot.svg"));
    EXPECT_EQ(completed("PLOT.PNG", 1), QStringLiteral("PLOT.PNG"));
    EXPECT_EQ(completed("engine 4.25"), QStringLiteral("engine 4.25.png"));
    EXPECT_EQ(completed("Двигатель.вариант"), QStringLiteral("Двигатель.вариант.png"));
    for (const char* rejected : {"plot.jpg", "plot.pdf", "plot.csv", "x.y.JPEG"}) {
        EXPECT_EQ(completed(rejected), QString()) << rejected;
    }
    const QList<FileFormat> cases{{QStringLiteral("case.json"), QStringLiteral("Case")}};
    const auto named = [&](const char* name) {
        return completedPath(QString::fromUtf8(name), cases, 0);
    };
    EXPECT_EQ(named("honda"), QStringLiteral("honda.case.json"));
    EXPECT_EQ(named("honda.case.json"), QStringLiteral("honda.case.json"));
    EXPECT_EQ(named("honda.json"), QStringLiteral("honda.json"));
}

TEST_F(FileDialogsTest, AsksBeforeItReplacesAlsoWhereTheProgramAddsTheSuffix) {
    make("guide2.png");
    typed = QStringList{file("guide2"), file("guide3")};
    answer({QMessageBox::No});
    EXPECT_EQ(ask(), file("guide3.png"));
    ASSERT_EQ(said.size(), 1);
    EXPECT_TRUE(said[0].contains(QStringLiteral("guide2.png"))) << said[0].toStdString();
    EXPECT_EQ(suggestions, (QStringList{file("s"), file("guide2")}));
    typed = QStringList{file("guide2")};
    answer({QMessageBox::Yes});
    EXPECT_EQ(ask(), file("guide2.png"));
    typed = QStringList{file("guide2")};
    answer({QMessageBox::No});
    EXPECT_EQ(ask(), QString());  // and gives up
}

TEST_F(FileDialogsTest, AFormatThatCannotBeWrittenIsRejectedInWords) {
    typed = QStringList{file("plot.jpg"), file("plot.svg")};
    answer({QMessageBox::Ok});
    EXPECT_EQ(ask(), file("plot.svg"));
    ASSERT_EQ(said.size(), 1);
    EXPECT_TRUE(said[0].contains(QStringLiteral(".png, .svg"))) << said[0].toStdString();
    EXPECT_TRUE(said[0].contains(QStringLiteral("plot.jpg"))) << said[0].toStdString();
}

TEST_F(FileDialogsTest, TheNextNameIsOfferedInTheFolderOfTheLast) {
    typed = QStringList{file("Чертёж")};
    chosen = 1;
    EXPECT_EQ(ask(), file("Чертёж.svg"));
    askSavePath(&parent, QStringLiteral("Save"), QStringLiteral("next.png"), formats);
    EXPECT_EQ(suggestions.last(), file("next"));  // with the suffix of what is chosen
}

}  // namespace
}  // namespace ravnoves
