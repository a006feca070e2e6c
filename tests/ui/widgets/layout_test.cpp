// Forms and tabs share their room out: no choice is cut beside a name, no page scrolls in a page.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

#include "events.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/page_columns.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

QComboBox* addChoice(FormSection& section, const QString& name, const QString& longest) {
    auto* box = new QComboBox(&section);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->addItems({u"no"_s, longest});
    section.addWidget(name, box);
    return box;
}

TEST(NamedRows, AChoiceShowsItsLongestEntry) {
    QWidget form;
    auto* column = new QVBoxLayout(&form);
    auto* section = new FormSection({}, &form);
    column->addWidget(section);
    const QComboBox* shorter = addChoice(*section, u"&Strokes"_s, u"four"_s);
    const QComboBox* longer = addChoice(*section, u"Signs"_s, u"of the guide keeps"_s);
    const QComboBox* longest =
        addChoice(*section, u"Balanced for"_s, u"the moments of orders one and two"_s);
    test::showAt(form, {300, 240});
    for (const QComboBox* box : {shorter, longer, longest}) {
        EXPECT_GE(box->width(), widthFor(box)) << qPrintable(box->itemText(1));
    }
    // Beside their names as wide as one another; what has no room there stands below.
    EXPECT_EQ(shorter->width(), longer->width());
    EXPECT_GT(shorter->x(), 0);
    EXPECT_EQ(longest->x(), 0);
    test::showAt(form, {640, 240});
    EXPECT_GT(longest->x(), 0);
}

TEST(FittedTabs, NeedTheHeightOfWhatIsInFront) {
    FittedTabs tabs;
    auto* low = new QWidget;
    low->setMinimumHeight(60);
    auto* high = new QWidget;
    high->setMinimumHeight(600);
    tabs.addTab(low, u"Low"_s);
    tabs.addTab(high, u"High"_s);
    EXPECT_LT(tabs.minimumSizeHint().height(), 200);
    tabs.setCurrentIndex(1);
    EXPECT_GT(tabs.minimumSizeHint().height(), 600);
}

}  // namespace
}  // namespace ravnoves
