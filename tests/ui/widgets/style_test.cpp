// What is drawn by the style: outlines that are seen on light and dark panels, and arrows, handles
// and marks that go with the text.

#include <gtest/gtest.h>
#include <malloc.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QIcon>
#include <QLineEdit>
#include <QPainter>
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
#include <cmath>
#include <initializer_list>

#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/panel.h"

namespace ravnoves {
namespace {

/// Filled where it is whole pixels, it is the rounded rectangle that it was.
TEST(Panel, LooksAlikeHoweverItIsPainted) {
    Theme& theme = Theme::instance();
    for (const Theme::Mode mode : {Theme::Mode::Light, Theme::Mode::Dark}) {
        theme.install(mode);
        for (const double ratio : {1.0, 1.5, 2.0, 3.0}) {
            const auto painted = [&](const auto& draw) {
                QImage image((QSizeF(60.0, 40.0) * ratio).toSize(), QImage::Format_RGB32);
                image.setDevicePixelRatio(ratio);
                image.fill(theme.window());
                QPainter painter(&image);
                painter.setRenderHint(QPainter::Antialiasing);
                draw(painter);
                painter.end();
                return image;
            };
            const QRect panel(3, 2, 50, 33);
            const QImage ours = painted([&](QPainter& painter) { paintPanel(painter, panel); });
            const QImage whole = painted([&](QPainter& painter) {
                painter.setPen(QPen(theme.border(), 1.0));
                painter.setBrush(theme.panel());
                painter.drawRoundedRect(QRectF(panel).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
            });
            int maximum = 0;
            for (int y = 0; y < ours.height(); ++y) {
                for (int x = 0; x < ours.width(); ++x) {
                    maximum = std::max(
                        maximum, std::abs(qGray(ours.pixel(x, y)) - qGray(whole.pixel(x, y))));
                }
            }
            EXPECT_LE(maximum, 2) << ratio;
            EXPECT_NE(ours, painted([](QPainter&) {}));
        }
    }
    theme.install(Theme::Mode::Light);
}

using namespace Qt::StringLiterals;

double luminance(const QColor& colour) {
    const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

/// As WCAG 2.1 defines it.
double contrast(const QColor& a, const QColor& b) {
    const double brighter = std::max(luminance(a), luminance(b));
    const double darker = std::min(luminance(a), luminance(b));
    return (brighter + 0.05) / (darker + 0.05);
}

class Style : public ::testing::Test {
  protected:
    ~Style() override {
        Theme::instance().setMode(Theme::Mode::Light);
        Theme::instance().setTextScale(1.0);
    }
};

TEST_F(Style, OutlinesAndSelectedTextAreSeen) {
    Theme& theme = Theme::instance();
    for (const auto mode : {Theme::Mode::Light, Theme::Mode::Dark}) {
        theme.setMode(mode);
        for (const QColor& ground : {theme.panel(), theme.window()}) {
            EXPECT_GE(contrast(theme.fieldBorder(), ground), 3.0);
            EXPECT_GE(contrast(theme.fieldBorder(false), ground), 2.0);
        }
        const QPalette palette = QApplication::palette();
        EXPECT_GE(
            contrast(palette.color(QPalette::HighlightedText), palette.color(QPalette::Highlight)),
            4.5);
        // As they are drawn: the edge of the box is of that contrast.
        QCheckBox box;
        box.resize(20, 20);
        const QImage drawn = box.grab().toImage();
        double maximum = 1.0;
        for (int x = 0; x < drawn.width(); ++x) {
            maximum = std::max(maximum,
                               contrast(drawn.pixelColor(x, drawn.height() / 2), theme.window()));
        }
        EXPECT_GE(maximum, 2.7);
    }
}

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

/// A program that paints all day: what Fusion keeps of a picture is found, not kept twice.
TEST_F(Style, PaintingAgainKeepsNothing) {
    QSlider slider(Qt::Horizontal);
    QComboBox combo;
    QWidget* const all[] = {&slider, &combo};
    const auto paint = [&](int times) {
        for (int i = 0; i < times; ++i) {
            for (QWidget* each : all) {
                each->grab();
            }
        }
        return static_cast<double>(mallinfo2().uordblks);
    };
    const double before = paint(20);
    const double bytes = paint(300) - before;
    EXPECT_LT(bytes / 300.0, 10.0) << "bytes a time";
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
