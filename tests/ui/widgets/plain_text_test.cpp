#include <gtest/gtest.h>

#include <QLabel>
#include <QMessageBox>

#include "events.h"
#include "text/tip_text.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

const QString named = u"<b>E1</b> <img src=\"/no/such/picture\">"_s;

/// Names come from files: a picture in one is never looked for.
TEST(PlainText, WhatLooksLikeHtmlIsWrittenAsItIs) {
    QLabel label(named);
    test::showAt(label, {400, 40});
    EXPECT_EQ(label.textFormat(), Qt::PlainText);
    EXPECT_GT(label.sizeHint().width(), label.fontMetrics().horizontalAdvance(named) - 2);
    QMessageBox box(QMessageBox::Warning, u"Open"_s, named);
    box.setInformativeText(named);
    test::showAt(box, {400, 200});
    for (const QLabel* part : box.findChildren<QLabel*>()) {
        EXPECT_NE(part->textFormat(), Qt::AutoText);
        EXPECT_NE(part->textFormat(), Qt::RichText);
    }
}

TEST(PlainText, WhatSaysThatItIsRichStaysSo) {
    QLabel label(u"<b>E1</b>"_s);
    label.setTextFormat(Qt::RichText);
    test::showAt(label, {400, 40});
    EXPECT_EQ(label.textFormat(), Qt::RichText);
}

TEST(TipText, HasNoLineThatIsLong) {
    EXPECT_EQ(tipText(u"short\nlines"_s), u"short\nlines"_s);
    const QString words = u"a tip of many words "_s.repeated(20).trimmed();
    const QString tip = tipText(words);
    for (const QString& line : tip.split(u'\n')) {
        EXPECT_LE(line.size(), 80);
    }
    EXPECT_EQ(QString(tip).replace(u'\n', u' '), words);
    EXPECT_EQ(tipText(QString(200, u'x')), QString(200, u'x')) << "a word does not come apart";
}

}  // namespace
}  // namespace ravnoves
