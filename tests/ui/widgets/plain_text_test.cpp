#include "widgets/plain_text.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QMessageBox>

#include "events.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

const QString named = u"<b>E1</b> <img src=\"/no/such/picture\">"_s;

/// Names come from files: a picture in one is never looked for.
TEST(PlainText, WhatLooksLikeHtmlIsWrittenAsItIs) {
    keepTextPlain();
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
    keepTextPlain();
    QLabel label(u"<b>E1</b>"_s);
    label.setTextFormat(Qt::RichText);
    test::showAt(label, {400, 40});
    EXPECT_EQ(label.textFormat(), Qt::RichText);
}

}  // namespace
}  // namespace ravnoves
