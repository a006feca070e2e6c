// The job card on paper: printer, preview, PDF, the paper and the shop's name. Its numbers:
// plugs_job_card_test.cpp.

#include <QBuffer>
#include <QInputDialog>
#include <QLocale>
#include <QPdfWriter>
#include <QPrintPreviewDialog>
#include <QPrintPreviewWidget>
#include <QPrinter>
#include <QRegularExpression>
#include <QSettings>

#include "core/workshop/support.h"
#include "job_page_test.h"
#include "text/usual_paper.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;
using namespace v8_plugs;

TEST_F(PlugsPageTest, CardIsWholeOnLetterAndOnItsSide) {
    type("engine_number", u"card"_s);
    type("rod_big_end", u"1"_s);
    model->edit(u"notes"_s, [](auto& input) {
        for (int i = 0; i < 500; ++i) {
            input.job.notes += "note" + std::to_string(i) + ' ';
        }
    });
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
        setPaper(printer, cardPaper());
        printer.setPageSize(QPageSize(paper.size));
        printer.setPageOrientation(paper.side);
        ASSERT_TRUE(printPaper(jobCard(*model, Words()), printer));
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
        EXPECT_GT(count, 600);
        EXPECT_TRUE(words.contains(u">note499<"_s));
        EXPECT_EQ(words.count(u"<page "_s), 2);
    }
}

TEST_F(PlugsPageTest, ShopStandsOnTheCard) {
    whenModal<QInputDialog>([](QInputDialog* dialog) {
        QTest::keyClicks(dialog->focusWidget(), u"Smith & Sons"_s);
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Return);
    });
    act(u"shop"_s);
    const QString file = QDir(folder.path()).filePath(u"shop.pdf"_s);
    ASSERT_EQ(page.writeCard(file), QString());
    EXPECT_TRUE(textOfPdf(file).contains(u"Smith & Sons"_s));
    model->desk()->setCardLanguage(u"ru"_s);
    ASSERT_EQ(page.writeCard(file), QString());
    EXPECT_TRUE(textOfPdf(file).contains(u"Номер двигателя"_s));
    QSettings().remove(u"workshop"_s);
}

TEST_F(PlugsPageTest, ARejectedEntryIsOnTheCardInItsLanguageAndLeavesNoPlugWork) {
    model->loadInput(workshop::test::plugs_card(), {});
    const QString file = QDir(folder.path()).filePath(u"rejected.pdf"_s);
    ASSERT_EQ(page.writeCard(file), QString());
    EXPECT_TRUE(has(textOfPdf(file).simplified(), u"off each of the 8"_s));
    type("steel_plug_mass_g", u"28x"_s);
    type("mass_piston_3", u"58x"_s);
    type("angle_1", u"7x"_s);
    const QString trouble = field("steel_plug_mass_g")->trouble();
    ASSERT_FALSE(trouble.isEmpty());
    ASSERT_EQ(page.writeCard(file), QString());
    EXPECT_TRUE(has(textOfPdf(file).simplified(), trouble));
    EXPECT_FALSE(has(textOfPdf(file).simplified(), u"off each of the 8"_s));
    model->desk()->setCardLanguage(u"ru"_s);
    ASSERT_EQ(page.writeCard(file), QString());
    const QString russian = textOfPdf(file).simplified();
    EXPECT_FALSE(has(russian, trouble));
    EXPECT_TRUE(hasAll(russian, {u"«28x»"_s, u", цилиндр 3: «58x»"_s, u"Тяжёлое место: «7x»"_s,
                                 u"не печатаются, пока не исправлены"_s}));
}

TEST_F(PlugsPageTest, TheCardWithholdsWhatThePageWithholds) {
    ASSERT_FALSE(model->plugsInput()->changes_known());
    const QString printed = card().simplified();
    EXPECT_TRUE(has(printed, u"Missing for the bob weight: "_s));
    EXPECT_TRUE(has(printed, u"changes of mass (sheet 2)"_s));
    EXPECT_FALSE(printed.contains(u"nan"_s));
    // Whether a plug does is not known either; the engine has it.
    for (const QString& each : {u"works"_s, u"The method neglects"_s, u"off each of the 8"_s}) {
        EXPECT_FALSE(has(printed, each));
    }
    type("rod_big_end", u"0"_s);
    ASSERT_TRUE(model->plugs()->advice);
    EXPECT_TRUE(card().contains(u"works"_s));
}

TEST_F(PlugsPageTest, PreviewShowsTheCard) {
    int pages = 0;
    whenModal<QPrintPreviewDialog>([&pages](QPrintPreviewDialog* dialog) {
        if (auto* preview = dialog->findChild<QPrintPreviewWidget*>()) {
            pages = preview->pageCount();
        }
        dialog->reject();
    });
    act(u"preview_card"_s);
    EXPECT_GE(pages, 1);
}

class CardPaperTest : public ::testing::Test {
  protected:
    CardPaperTest() { forget(); }
    ~CardPaperTest() override { forget(); }
    static void forget() { QSettings().remove(u"workshop/paper"_s); }

    static void choose(const QPageSize& size) {
        QBuffer buffer;
        QPdfWriter writer(&buffer);
        setPaper(writer, cardPaper());
        writer.setPageSize(size);
        keepCardPaper(writer);
    }
    static QByteArray written() {
        return paperAsPdf(jobCard(WorkshopModel(QString()), Words()), cardPaper());
    }
};

TEST_F(CardPaperTest, IsThatOfTheCountryAtFirst) {
    EXPECT_EQ(cardPaper(), QPageSize(usualPaper()));
}

TEST_F(CardPaperTest, IsRememberedForPrinterAndFile) {
    choose(QPageSize(QPageSize::Letter));
    EXPECT_EQ(cardPaper().id(), QPageSize::Letter);
    EXPECT_TRUE(written().contains("/MediaBox [0 0 612.0"));
    choose(QPageSize(QPageSize::A4));
    EXPECT_EQ(cardPaper().id(), QPageSize::A4);
    EXPECT_TRUE(written().contains("/MediaBox [0 0 595."));
    // Of a roll, too.
    const QPageSize roll(QSizeF(120, 300), QPageSize::Millimeter);
    choose(roll);
    EXPECT_EQ(cardPaper().sizePoints(), roll.sizePoints());
    // What is no paper is none.
    QSettings().setValue(u"workshop/paper"_s, u"large"_s);
    EXPECT_EQ(cardPaper(), QPageSize(usualPaper()));
}

}  // namespace
}  // namespace ravnoves
