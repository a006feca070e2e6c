// The job card on paper: printer, preview, PDF and the shop's name. Its numbers:
// job_card_test.cpp.

#include <sys/stat.h>

#include <QLineEdit>
#include <QPainter>
#include <QPrintPreviewDialog>
#include <QPrintPreviewWidget>
#include <QPrinter>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>

#include "job_page_test.h"
#include "pictures/file_dialogs.h"
#include "shop/shop_dialog.h"
#include "workshop/workshop_card.h"

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
        WorkshopCard::setPage(printer);
        printer.setPageSize(QPageSize(paper.size));
        printer.setPageOrientation(paper.side);
        ASSERT_TRUE(WorkshopCard(*model, Words()).print(printer));
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

TEST_F(PlugsPageTest, ALogoThatNeverEndsIsSaid) {
    const QString pipe = QDir(folder.path()).filePath(u"logo.png"_s);
    ASSERT_EQ(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
    const Shop shop{.name = {}, .logo = pipe};
    EXPECT_TRUE(shop.trouble().contains(pipe));
}

TEST_F(PlugsPageTest, ShopStandsOnTheCard) {
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
        QTest::keyClick(dialog->focusWidget(), Qt::Key_Return);
        EXPECT_FALSE(dialog->isVisible()) << "Enter is OK";
    });
    act(u"shop"_s);
    QFile::remove(logo);  // the card has its own copy
    const QString file = QDir(folder.path()).filePath(u"shop.pdf"_s);
    ASSERT_EQ(page.writeCard(file), QString());
    EXPECT_TRUE(textOfPdf(file).contains(u"Smith & Sons"_s));
    WorkshopCard card(*model, Words());
    card.setShop(Shop::kept());
    QImage paper(2100, 2970, QImage::Format_RGB32);
    QPainter painter(&paper);
    card.paint(painter, QRectF(0, 0, 2100, 2970));
    EXPECT_EQ(paper.pixelColor(170, 72), QColor(Qt::red));
    const auto* banner = find<QLabel>("banner");
    EXPECT_FALSE(banner->isVisible());
    QFile::remove(Shop::kept().logo);
    model->desk()->setCardLanguage(u"ru"_s);
    ASSERT_EQ(page.writeCard(file), QString());
    EXPECT_TRUE(textOfPdf(file).contains(u"Номер двигателя"_s));
    EXPECT_TRUE(banner->isVisible());
    EXPECT_TRUE(has(banner->text(), Shop::kept().logo));
    fileChoosers() = before;
    QSettings().remove(u"workshop"_s);
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

}  // namespace
}  // namespace ravnoves
