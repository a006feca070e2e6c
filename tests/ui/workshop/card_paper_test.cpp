// The paper of the job card.

#include <gtest/gtest.h>

#include <QFile>
#include <QLocale>
#include <QPagedPaintDevice>
#include <QPdfWriter>
#include <QSettings>
#include <QTemporaryDir>

#include "text/usual_paper.h"
#include "workshop/workshop_card.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class CardPaperTest : public ::testing::Test {
  protected:
    CardPaperTest() { forget(); }
    ~CardPaperTest() override { forget(); }
    static void forget() { QSettings().remove(u"workshop/paper"_s); }

    QPageSize paperOfNext() const {
        QPdfWriter writer(folder.filePath(u"next.pdf"_s));
        WorkshopCard::setPage(writer);
        return writer.pageLayout().pageSize();
    }
    void choose(const QPageSize& size) const {
        QPdfWriter writer(folder.filePath(u"chosen.pdf"_s));
        WorkshopCard::setPage(writer);
        writer.setPageSize(size);
        WorkshopCard::keepPaper(writer);
    }
    QByteArray written() const {
        const QString path = folder.filePath(u"card.pdf"_s);
        EXPECT_EQ(WorkshopCard(WorkshopModel(QString()), Words()).writePdf(path), QString());
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }

    QTemporaryDir folder;
};

TEST_F(CardPaperTest, IsThatOfTheCountryAtFirst) {
    EXPECT_EQ(usualPaper(QLocale(u"en_US"_s)), QPageSize::Letter);
    EXPECT_EQ(usualPaper(QLocale(u"fr_CA"_s)), QPageSize::Letter);
    EXPECT_EQ(usualPaper(QLocale(u"es_MX"_s)), QPageSize::Letter);
    EXPECT_EQ(usualPaper(QLocale(u"en_GB"_s)), QPageSize::A4);
    EXPECT_EQ(usualPaper(QLocale(u"es_ES"_s)), QPageSize::A4);
    EXPECT_EQ(usualPaper(QLocale(u"ru_RU"_s)), QPageSize::A4);
    EXPECT_EQ(usualPaper(QLocale::c()), QPageSize::A4);
    EXPECT_EQ(paperOfNext(), QPageSize(usualPaper()));
}

TEST_F(CardPaperTest, IsRememberedForPrinterAndFile) {
    choose(QPageSize(QPageSize::Letter));
    EXPECT_EQ(paperOfNext().id(), QPageSize::Letter);
    EXPECT_TRUE(written().contains("/MediaBox [0 0 612.0"));
    choose(QPageSize(QPageSize::A4));
    EXPECT_EQ(paperOfNext().id(), QPageSize::A4);
    EXPECT_TRUE(written().contains("/MediaBox [0 0 595."));
    // Of a roll, too.
    const QPageSize roll(QSizeF(120, 300), QPageSize::Millimeter);
    choose(roll);
    EXPECT_EQ(paperOfNext().sizePoints(), roll.sizePoints());
    // What is no paper is none.
    QSettings().setValue(u"workshop/paper"_s, u"large"_s);
    EXPECT_EQ(paperOfNext(), QPageSize(usualPaper()));
}

}  // namespace
}  // namespace ravnoves
