// The paper of the job card.

#include <gtest/gtest.h>

#include <QBuffer>
#include <QLocale>
#include <QPagedPaintDevice>
#include <QPdfWriter>
#include <QSettings>

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
    EXPECT_EQ(usualPaper(QLocale(u"en_US"_s)), QPageSize::Letter);
    EXPECT_EQ(usualPaper(QLocale(u"fr_CA"_s)), QPageSize::Letter);
    EXPECT_EQ(usualPaper(QLocale(u"es_MX"_s)), QPageSize::Letter);
    EXPECT_EQ(usualPaper(QLocale(u"en_GB"_s)), QPageSize::A4);
    EXPECT_EQ(usualPaper(QLocale(u"es_ES"_s)), QPageSize::A4);
    EXPECT_EQ(usualPaper(QLocale(u"ru_RU"_s)), QPageSize::A4);
    EXPECT_EQ(usualPaper(QLocale::c()), QPageSize::A4);
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
