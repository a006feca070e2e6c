// Forms and tabs share their room out: no choice is cut beside a name, no page scrolls in a page.

#include <gtest/gtest.h>

#include <QComboBox>
#include <QHelpEvent>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <memory>
#include <utility>

#include "comes.h"
#include "events.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"
#include "widgets/page_columns.h"
#include "widgets/verdict_line.h"

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
    // Beside their names they end in one line; what has no room there stands below.
    EXPECT_EQ(shorter->geometry().right(), longer->geometry().right());
    EXPECT_GT(longer->x(), 0);
    EXPECT_GT(shorter->x(), 0);
    EXPECT_EQ(longest->x(), 0);
    test::showAt(form, {640, 240});
    EXPECT_GT(longest->x(), 0);
}

TEST(NamedRows, AUnitStaysBesideAFieldWhateverStandsInIt) {
    FormSection section({});
    auto* field = new NumberField(&section);
    field->setPlaceholderText(u"0.4 ℓ₀"_s);
    section.addWidget(u"Shortest spring"_s, field, u"mm"_s);
    const auto labels = section.findChildren<QLabel*>();
    const auto unit = std::find_if(labels.begin(), labels.end(),
                                   [](const QLabel* each) { return each->text() == u"mm"_s; });
    ASSERT_NE(unit, labels.end());
    test::showAt(section, {300, 120});
    EXPECT_TRUE((*unit)->isVisible());
    EXPECT_GT((*unit)->x(), field->geometry().right());
    field->setText(u"12"_s);
    EXPECT_TRUE((*unit)->isVisible());
}

/// Above a page that takes the rest, as on every page.
TEST(VerdictLine, ShowsAllOfItsTextAndKeepsTwoLinesForAShortOne) {
    QWidget page;
    auto* column = new QVBoxLayout(&page);
    auto* verdict = new VerdictLine(&page);
    column->addWidget(verdict);
    column->addWidget(new QWidget(&page), 1);
    const auto* label = test::named<QLabel>(*verdict, "verdict");
    const std::string sentence = "Reject: 610 g·mm in the left plane, 95 g·mm in the right one. ";
    std::string text = sentence;
    for (int i = 0; i < 8; ++i, text += sentence) {
        verdict->show({Severity::warning, Text{text.c_str()}},
                      i % 2 == 0 ? QString() : u"Correct the drilled holes"_s);
        for (const int width : {1400, 700, 420, 320}) {
            test::showAt(page, {width, 900});
            EXPECT_TRUE(test::comes([&] {
                return label->height() >= label->heightForWidth(label->width());
            })) << i
                << ", " << width;
            EXPECT_TRUE(
                verdict->rect().contains(QRect(label->mapTo(verdict, QPoint()), label->size())))
                << i << ", " << width;
            // Nothing moves where one line becomes two.
            const bool isShort = i == 0 && width == 1400;
            EXPECT_TRUE(!isShort || verdict->height() == verdict->minimumHeight());
            EXPECT_GE(verdict->height(), verdict->minimumHeight());
        }
    }
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

TEST(Scrolled, HasNoBarThatIsNeededOnlyForItsOwnRoom) {
    const QString words = QStringLiteral("some words of a text that wraps ").repeated(12);
    const auto text = [&] {
        auto* label = new QLabel(words);
        label->setWordWrap(true);
        return label;
    };
    const auto form = [&]() -> QWidget* {
        auto* holder = new QWidget;
        auto* column = new QVBoxLayout(holder);
        column->addWidget(text());
        column->addWidget(text());
        return holder;
    };
    for (const bool hasLayout : {false, true}) {
        int withBar = 0;
        int without = 0;
        for (int height = 60; height < 560; height += 3) {
            const auto shown = [&](const QList<QSize>& sizes) {
                const std::unique_ptr<QScrollArea> area(
                    scrolled(hasLayout ? form() : text(), nullptr));
                for (const QSize& size : sizes) {
                    test::showAt(*area, size);
                }
                return std::pair(area->verticalScrollBar()->isVisible(), area->viewport()->width());
            };
            const auto fresh = shown({{220, height}});
            EXPECT_EQ(shown({{220, height}, {220, 60}, {220, height}}), fresh) << height;
            (fresh.first ? withBar : without) += 1;
        }
        EXPECT_GT(withBar, 10);
        EXPECT_GT(without, 10);
    }
}

/// As tables with differences below their numbers do: they want more than they need.
class Wants300 final : public QWidget {
  public:
    using QWidget::QWidget;
    QSize sizeHint() const override { return {100, 300}; }
    QSize minimumSizeHint() const override { return {100, 100}; }
};

TEST(Scrolled, HasABarWhereWhatItHoldsIsHigher) {
    for (int height = 80; height < 460; height += 7) {
        auto* holder = new QWidget;
        auto* column = new QVBoxLayout(holder);
        auto* note = new QLabel(QStringLiteral("words that wrap ").repeated(6));
        note->setWordWrap(true);
        column->addWidget(note);
        column->addWidget(new Wants300);
        const std::unique_ptr<QScrollArea> area(scrolled(holder, nullptr));
        test::showAt(*area, {240, height});
        const auto check = [&](const char* when) {
            EXPECT_EQ(area->verticalScrollBar()->isVisible(),
                      holder->height() > area->viewport()->height())
                << when << ' ' << height;
        };
        check("shown");
        note->hide();  // nothing wraps any more
        test::showAt(*area, {240, height});
        check("without a note");
        test::showAt(*area, {240, height - 20});
        check("lower");
    }
}

TEST(TipOfAField, SaysWhatItHasNoRoomToHint) {
    NumberField field;
    field.setPlaceholderText(u"engine or crankshaft number, customer, technician"_s);
    test::showAt(field, {120, 30});
    const auto tip = [&] {
        QHelpEvent help(QEvent::ToolTip, {10, 10}, field.mapToGlobal(QPoint(10, 10)));
        QApplication::sendEvent(&field, &help);
        return QToolTip::text();
    };
    field.setText(u"7"_s);
    EXPECT_FALSE(tip().contains(field.placeholderText()));
    field.clear();
    EXPECT_TRUE(tip().startsWith(field.placeholderText()));
    QToolTip::hideText();
}

}  // namespace
}  // namespace ravnoves
