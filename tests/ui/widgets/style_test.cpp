// What is drawn by the style: arrows, handles and marks that go with the text.

#include <gtest/gtest.h>
#include <malloc.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QIcon>
#include <QLineEdit>
#include <QPixmapCache>
#include <QPushButton>
#include <QScrollBar>
#include <QSlider>
#include <QStyleOptionComboBox>
#include <QStyleOptionSlider>
#include <QStyleOptionSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <initializer_list>

#include "theme/icons.h"
#include "theme/theme.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

class Style : public ::testing::Test {
  protected:
    ~Style() override {
        Theme::instance().setMode(Theme::Mode::Light);
        Theme::instance().setTextScale(1.0);
    }
};

TEST_F(Style, ArrowsAndHandlesGoWithTheText) {
    QComboBox combo;
    QSlider slider(Qt::Horizontal);
    const auto widths = [&] {
        const auto width = [](const QWidget& of, auto option, QStyle::ComplexControl control,
                              QStyle::SubControl part) {
            option.initFrom(&of);
            option.rect = QRect(0, 0, 200, 40);
            return of.style()->subControlRect(control, &option, part, &of).width();
        };
        return QList<int>{
            width(combo, QStyleOptionComboBox(), QStyle::CC_ComboBox, QStyle::SC_ComboBoxArrow),
            slider.style()->pixelMetric(QStyle::PM_SliderLength, nullptr, &slider),
            slider.style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, &slider)};
    };
    const QList<int> normal = widths();
    Theme::instance().setTextScale(2.0);
    const QList<int> large = widths();
    for (qsizetype i = 0; i < normal.size(); ++i) {
        EXPECT_GE(large[i], 1.8 * normal[i]) << i;
    }
}

TEST_F(Style, AChoiceHasRoomForItsEntryAtEveryTextSize) {
    for (const double scale : {1.0, 1.5, 2.0}) {
        Theme::instance().setTextScale(scale);
        QComboBox combo;
        combo.addItem(u"keeps the energy"_s);
        combo.resize(combo.sizeHint());
        QStyleOptionComboBox option;
        option.initFrom(&combo);
        const QRect room = combo.style()->subControlRect(QStyle::CC_ComboBox, &option,
                                                         QStyle::SC_ComboBoxEditField, &combo);
        EXPECT_GE(room.width() - 2, combo.fontMetrics().horizontalAdvance(combo.itemText(0)))
            << scale;
    }
}

TEST_F(Style, PaintingNewWidgetsKeepsNothing) {
    // As each page that is opened has: with palettes of their own, of the same colours.
    const auto paint = [](int times) {
        for (int i = 0; i < times; ++i) {
            QWidget page;
            page.setFont(QApplication::font());
            QPalette palette = QApplication::palette();
            palette.setColor(QPalette::Text, palette.color(QPalette::Text));
            page.setPalette(palette);
            auto* column = new QVBoxLayout(&page);
            auto* table = new QTableWidget(1, 1, &page);
            table->setHorizontalHeaderItem(0, new QTableWidgetItem(QStringLiteral("M")));
            for (QWidget* each : std::initializer_list<QWidget*>{
                     new QSlider(Qt::Horizontal), new QComboBox, new QLineEdit, new QPushButton,
                     new QCheckBox, new QScrollBar, table}) {
                column->addWidget(each);
            }
            page.grab();
        }
        QPixmapCache::clear();
        return static_cast<double>(mallinfo2().uordblks);
    };
    const double before = paint(20);
    const double bytes = paint(200) - before;
    EXPECT_LT(bytes / 200.0, 500.0) << "bytes a page";
}

/// The colour of the most opaque pixel.
QColor inkOf(const QIcon& icon) {
    const QImage picture = icon.pixmap(24).toImage().convertToFormat(QImage::Format_ARGB32);
    QColor ink(Qt::transparent);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QColor here = picture.pixelColor(x, y);
            ink = here.alpha() > ink.alpha() ? here : ink;
        }
    }
    return ink;
}

// An icon keeps its picture, but not beyond a change of the theme; and what the style adds, as the
// mark of a tool bar without room, is no dark picture on a dark ground.
TEST_F(Style, IconsHaveTheThemesColour) {
    const QIcon own = themedIcon(u"open"_s);
    const QIcon more =
        QApplication::style()->standardIcon(QStyle::SP_ToolBarHorizontalExtensionButton);
    for (const auto mode :
         {Theme::Mode::Light, Theme::Mode::Dark, Theme::Mode::Light, Theme::Mode::Dark}) {
        Theme::instance().setMode(mode);
        EXPECT_EQ(inkOf(own).rgb(), Theme::instance().text().rgb());
        EXPECT_EQ(inkOf(more).rgb(), Theme::instance().text().rgb());
        const QPixmap disabled = own.pixmap(24, QIcon::Disabled);
        EXPECT_EQ(inkOf(disabled).rgb(), Theme::instance().border().rgb());
    }
    EXPECT_EQ(own.pixmap(16).size(), QSize(16, 16));
    EXPECT_EQ(own.pixmap(48).size(), QSize(48, 48));
}

}  // namespace
}  // namespace ravnoves
