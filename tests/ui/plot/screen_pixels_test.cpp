#include "plot/screen_pixels.h"

#include <gtest/gtest.h>

#include <QGuiApplication>
#include <QPaintEvent>
#include <QPainter>
#include <QPicture>
#include <QScreen>
#include <QTest>
#include <cmath>

#include "plot/plot_view.h"

namespace ravnoves {
namespace {

/// Paints into the screen's pixels, where it gets them.
class Painted : public QWidget {
  public:
    using QWidget::QWidget;
    bool got = false;
    QRect part;

  protected:
    void paintEvent(QPaintEvent* event) override {
        QPainter painter(this);
        QImage* screen = screen_.of(painter, *this, part.isNull() ? rect() : part, event->region());
        got = screen != nullptr;
        if (got) {
            QPainter(screen).fillRect(part.isNull() ? rect() : part, Qt::blue);
        } else {
            painter.fillRect(rect(), Qt::blue);
        }
    }

  private:
    ScreenPixels screen_;
};

QImage onScreen(const QWidget& window) {
    return QGuiApplication::primaryScreen()
        ->grabWindow(window.winId())
        .toImage()
        .convertToFormat(QImage::Format_RGB32);
}

class ScreenPixelsTest : public testing::Test {
  protected:
    ScreenPixelsTest() {
        window_.resize(300, 200);
        painted_.setGeometry(20, 30, 200, 100);
        painted_.setAttribute(Qt::WA_OpaquePaintEvent);
        cover_.setAutoFillBackground(true);
        cover_.setPalette(Qt::red);
        cover_.hide();
        window_.show();
        QTest::qWait(20);
    }

    QWidget window_;
    Painted painted_{&window_};
    QWidget cover_{&window_};
};

TEST_F(ScreenPixelsTest, AreThoseOfTheWidgetInItsWindow) {
    painted_.update();
    QTest::qWait(20);
    EXPECT_TRUE(painted_.got);
    const QImage screen = onScreen(window_);
    for (int y = 0; y < screen.height(); ++y) {
        for (int x = 0; x < screen.width(); ++x) {
            EXPECT_EQ(screen.pixelColor(x, y) == QColor(Qt::blue),
                      painted_.geometry().contains(x, y))
                << x << ' ' << y;
        }
    }
}

TEST_F(ScreenPixelsTest, WhatLiesOverThemStays) {
    cover_.setGeometry(100, 60, 30, 20);
    cover_.show();
    cover_.raise();
    QTest::qWait(20);
    painted_.update();
    QTest::qWait(20);
    EXPECT_FALSE(painted_.got);
    EXPECT_EQ(onScreen(window_).pixelColor(110, 70), QColor(Qt::red));
    EXPECT_EQ(onScreen(window_).pixelColor(90, 70), QColor(Qt::blue));
    // It lies beside the part that is painted.
    painted_.part = QRect(0, 60, 200, 40);
    painted_.update(painted_.part);
    QTest::qWait(20);
    EXPECT_TRUE(painted_.got);
    EXPECT_EQ(onScreen(window_).pixelColor(110, 70), QColor(Qt::red));
    EXPECT_EQ(onScreen(window_).pixelColor(110, 95), QColor(Qt::blue));
}

TEST_F(ScreenPixelsTest, APartOfTheWidgetIsNotAllOfIt) {
    painted_.got = true;
    painted_.update(10, 10, 50, 50);
    QTest::qWait(20);
    EXPECT_FALSE(painted_.got);
}

TEST_F(ScreenPixelsTest, FollowAWindowOfAnotherSize) {
    for (const QSize& size : {QSize(500, 400), QSize(260, 150), QSize(400, 300)}) {
        window_.resize(size);
        painted_.setGeometry(size.width() / 10, 10, size.width() / 2, size.height() / 2);
        QTest::qWait(20);
        EXPECT_TRUE(painted_.got);
        EXPECT_EQ(onScreen(window_).pixelColor(painted_.geometry().bottomRight()),
                  QColor(Qt::blue));
    }
}

TEST_F(ScreenPixelsTest, ThereAreNoneInAFile) {
    QPicture file;
    painted_.render(&file);
    EXPECT_FALSE(painted_.got);
}

TEST_F(ScreenPixelsTest, ThereAreNoneOfAnotherSize) {
    for (const double scale : {0.5, 1.5, 2.0}) {
        QImage picture(500, 400, QImage::Format_RGB32);
        QPainter painter(&picture);
        painter.scale(scale, scale);
        painted_.got = true;
        painted_.render(&painter);
        EXPECT_FALSE(painted_.got) << scale;
    }
}

TEST(PlotOnScreen, IsThatOfAPicture) {
    QWidget window;
    window.resize(500, 400);
    PlotView plot(QStringLiteral("A plot"), &window);
    plot.setGeometry(30, 40, 420, 300);
    plot.setXAxis({QStringLiteral("x"), 0.0, 10.0});
    plot.addCurve({QStringLiteral("a wave"), 0});
    plot.addCurve({QStringLiteral("another"), 1});
    window.show();
    QTest::qWait(20);
    const auto show = [&](double phase) {
        std::vector<double> x;
        std::vector<double> y;
        std::vector<double> z;
        for (int i = 0; i <= 100; ++i) {
            x.push_back(0.1 * i);
            y.push_back(std::sin(x.back() + phase));
            z.push_back(std::cos(3.0 * x.back() + phase));
        }
        plot.setCurve(0, x, y);
        plot.setCurve(1, x, z);
    };
    for (int step = 0; step < 5; ++step) {
        show(0.3 * step);
        if (step > 2) {
            plot.setPresentX(5.0 + step);
        }
        QTest::qWait(20);
        EXPECT_EQ(onScreen(window), window.grab().toImage().convertToFormat(QImage::Format_RGB32))
            << "moving " << step;
        plot.setPresentX(2.0 + step);
        QTest::qWait(20);
        EXPECT_EQ(onScreen(window), window.grab().toImage().convertToFormat(QImage::Format_RGB32))
            << "at rest " << step;
    }
    window.resize(450, 380);
    plot.setGeometry(10, 10, 400, 333);
    QTest::qWait(20);
    EXPECT_EQ(onScreen(window), window.grab().toImage().convertToFormat(QImage::Format_RGB32));
}

}  // namespace
}  // namespace ravnoves
