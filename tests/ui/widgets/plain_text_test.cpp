#include "widgets/plain_text.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCursor>
#include <QLabel>
#include <QMessageBox>
#include <QScreen>
#include <QTest>
#include <QToolTip>
#include <algorithm>

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

/// Qt places it by the width of its text in one line.
TEST(PlainText, ALongTipStandsBesideThePointer) {
    keepTextPlain();
    QWidget window;
    test::showAt(window, {400, 300});
    const int screen = window.screen()->geometry().right();
    const int bottom = window.screen()->geometry().bottom();
    for (const auto& [x, y] :
         {std::pair(screen / 2, 100), {screen - 60, 100}, {screen / 2, bottom - 45}, {20, bottom - 30}}) {
        const QPoint at(x, y);
        QCursor::setPos(at);
        QToolTip::showText(
            at, u"A tip of many words, longer than the screen has room for. "_s.repeated(3),
            &window);
        QTest::qWait(50);
        const QWidgetList all = QApplication::topLevelWidgets();
        const auto tip = std::find_if(all.begin(), all.end(), [](QWidget* each) {
            return each->inherits("QTipLabel") && each->isVisible();
        });
        ASSERT_NE(tip, all.end());
        EXPECT_LE((*tip)->geometry().right(), screen);
        EXPECT_LE((*tip)->geometry().bottom(), bottom);
        const bool hasRoom = x + 2 + (*tip)->width() <= screen + 1;
        EXPECT_EQ((*tip)->x(), hasRoom ? x + 2 : x - 2 - (*tip)->width());
        QToolTip::hideText();
        QTest::qWait(400);
    }
}

}  // namespace
}  // namespace ravnoves
