#include "pictures/model/stroke.h"

#include <gtest/gtest.h>

#include <QPainter>
#include <QScreen>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <functional>

#include "difference.h"
#include "events.h"
#include "pictures/model/shape.h"

namespace ravnoves {
namespace {

QImage paper() {
    QImage image(240, 160, QImage::Format_RGB32);
    image.fill(Qt::white);
    return image;
}

QPolygonF wave() {
    QPolygonF line;
    for (int i = 0; i <= 60; ++i) {
        line << QPointF(10.0 + 3.6 * i, 80.0 + 60.0 * std::sin(0.2 * i) - 0.3 * i);
    }
    return line;
}

/// All darkness of a picture, in whole black pixels.
double inkOf(const QImage& image) {
    double ink = 0.0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            ink += 1.0 - qGray(image.pixel(x, y)) / 255.0;
        }
    }
    return ink;
}

/// By a painter, with so many pixels to a unit of the paper.
template <typename Draw>
QImage onPaper(Draw&& draw, double scale = 1.0) {
    QImage image((QSizeF(paper().size()) * scale).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    image.setDevicePixelRatio(scale);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    draw(painter);
    painter.end();
    return image;
}

/// With a pen and a brush, as Qt does it.
template <typename Draw>
QImage onPaper(const QPen& pen, const QBrush& brush, Draw&& draw, double scale = 1.0) {
    return onPaper(
        [&](QPainter& painter) {
            painter.setPen(pen);
            painter.setBrush(brush);
            draw(painter);
        },
        scale);
}

QImage byBrush(const QPolygonF& line, double width, Qt::PenStyle style) {
    return onPaper(QPen(Qt::black, width, style, Qt::FlatCap), Qt::NoBrush,
                   [&](QPainter& painter) { paintLine(painter, line); });
}

TEST(LineBrush, AClipShowsItsPartOfTheWholeHoweverNarrow) {
    for (const QColor& colour : {QColor(20, 90, 160), QColor(20, 90, 160, 120)}) {
        const auto drawn = [&](const QRect& clip) {
            return onPaper([&](QPainter& painter) {
                QPen dashed(Qt::red, 4.0, Qt::CustomDashLine, Qt::FlatCap);
                dashed.setDashPattern({4.0, 2.0});
                painter.setClipRect(clip);
                painter.setPen(QPen(colour, 2.2, Qt::SolidLine, Qt::FlatCap));
                paintLine(painter, wave());
                painter.setPen(dashed);
                paintLine(painter, wave());
            });
        };
        const QImage whole = drawn(paper().rect());
        for (int width = 1; width < 20; ++width) {
            const QRect clip(101 + width, 0, width, 160);
            EXPECT_EQ(drawn(clip).copy(clip), whole.copy(clip)) << width;
        }
    }
}

TEST(LineBrush, ASharpBendIsRoundAndWhole) {
    // Beyond a bend no pixel is missed, however the line turns there.
    for (const double turn : {0.02, 0.3, 1.2, 1.6, 2.5, 3.1}) {
        const QPointF bend(120, 80);
        const QPointF on = bend + 70.0 * QPointF(std::cos(turn), std::sin(turn));
        const QImage image = byBrush({{50, 80}, bend, on}, 9.0, Qt::SolidLine);
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const double away = std::hypot(x + 0.5 - bend.x(), y + 0.5 - bend.y());
                if (away < 3.9) {
                    EXPECT_EQ(qGray(image.pixel(x, y)), 0) << turn << ": " << x << ' ' << y;
                }
            }
        }
    }
}

TEST(LineBrush, PaintedLinesStayInTheirClipAndCrossNoDarker) {
    const std::vector<QPolygonF> lines{{{0, 0}, {240, 160}}, {{0, 160}, {240, 0}}, {{5, 5}}, {}};
    for (const bool clipped : {false, true}) {
        QImage image = paper();
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(QColor(0, 0, 0, 128), 3.0));
        const QRect seen = clipped ? QRect(60, 40, 100, 80) : image.rect();
        if (clipped) {
            painter.setClipRect(seen);
        }
        paintLines(painter, {{painter.pen(), lines}});
        painter.end();
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                EXPECT_GE(qGray(image.pixel(x, y)), 126) << x << ' ' << y;
                EXPECT_TRUE(seen.contains(x, y) || qGray(image.pixel(x, y)) == 255)
                    << x << ' ' << y;
            }
        }
        EXPECT_EQ(qGray(image.pixel(120, 80)), 127);
    }
    QImage none = paper();
    QPainter painter(&none);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(QRect(200, 0, 20, 20));
    paintLine(painter, {{0, 100}, {100, 100}});
    paintLines(painter, {});
    painter.end();
    EXPECT_EQ(none, paper());
}

TEST(LineBrush, LinesOfSeveralPensAreThoseOfEach) {
    const std::vector<LinesOfPen> all{{QPen(QColor(0, 0, 0, 90), 1.0), {wave()}},
                                      {QPen(Qt::red, 2.4), {{{0, 30}, {240, 120}}}},
                                      {QPen(QColor(0, 0, 255, 90), 3.0), {{{0, 120}, {240, 30}}}}};
    const QImage together = onPaper([&](QPainter& painter) { paintLines(painter, all); });
    const QImage apart = onPaper([&](QPainter& painter) {
        for (const LinesOfPen& each : all) {
            paintLines(painter, {each});
        }
    });
    EXPECT_LE(test::differenceOf(together, apart).most, 2);
    EXPECT_GT(together.pixelColor(120, 75).blue(), 60);  // the last one over the red one
    EXPECT_GT(test::differenceOf(together, paper()).mean(), 20.0);
}

/// A shape as it is painted here and by Qt, with how far the two may differ.
struct AsQt {
    const char* name;
    QPen pen;
    QBrush brush;
    std::function<void(QPainter&)> ours;
    std::function<void(QPainter&)> qts;
    double difference;  ///< the mean of the pixels painted, of 255 shades
    double ink;         ///< share
};

std::vector<AsQt> shapes() {
    std::vector<AsQt> all;
    for (const Qt::PenCapStyle cap : {Qt::FlatCap, Qt::SquareCap, Qt::RoundCap}) {
        all.push_back({"line", QPen(QColor(0, 60, 0, 200), 2.6, Qt::SolidLine, cap), Qt::NoBrush,
                       [](QPainter& painter) { paintLine(painter, wave()); },
                       [](QPainter& painter) { painter.drawPolyline(wave()); }, 8.0, 0.02});
    }
    // Dashes of one pixel are others to Qt.
    for (const double width : {1.6, 2.2, 4.0}) {
        for (const Qt::PenStyle style : {Qt::SolidLine, Qt::DashLine, Qt::DotLine}) {
            all.push_back({"pen", QPen(Qt::black, width, style, Qt::FlatCap), Qt::NoBrush,
                           [](QPainter& painter) { paintLine(painter, wave()); },
                           [](QPainter& painter) { painter.drawPolyline(wave()); }, 8.0, 0.02});
        }
    }
    all.push_back({"dashes with square ends", QPen(Qt::black, 1.4, Qt::DashDotLine), Qt::NoBrush,
                   [](QPainter& painter) {
                       paintLine(painter, {20, 30}, {210, 120});
                   },
                   [](QPainter& painter) { painter.drawLine(QPointF(20, 30), QPointF(210, 120)); },
                   15.0, 0.02});
    // Qt's narrowest lines are thinner aslant.
    const QPolygonF bar{{40, 20}, {200, 90}, {194, 104}, {34, 34}};
    for (const QPolygonF& same : {bar, QPolygonF(bar.rbegin(), bar.rend())}) {
        all.push_back({"polygon", QPen(Qt::black, 1.0), QColor(200, 120, 0, 220),
                       [same](QPainter& painter) { paintPolygon(painter, same); },
                       [same](QPainter& painter) { painter.drawConvexPolygon(same); }, 4.0, 0.02});
    }
    const QRectF block(QPointF(30.3, 20.6), QPointF(180.2, 110.9));
    for (const double corner : {0.0, 3.0, 20.0, 90.0}) {
        const double round = std::min(corner, 0.5 * block.height());
        all.push_back({"block", QPen(Qt::black, 1.4), Qt::gray,
                       [=](QPainter& painter) {
                           paintBlock(painter, {block.bottomRight(), block.topLeft()}, corner);
                       },
                       [=](QPainter& painter) { painter.drawRoundedRect(block, round, round); },
                       8.0, 0.005});
    }
    const QPointF from(60, 40);
    for (const QPointF& to : {QPointF(190, 120), QPointF(60, 120), QPointF(190, 40), from}) {
        all.push_back(
            {"bar", QPen(Qt::black, 1.0), Qt::gray,
             [=](QPainter& painter) { paintBar(painter, from, to, 5.5); },
             [=](QPainter& painter) {
                 for (const auto& [ink, width] : {std::pair(Qt::black, 12.0), {Qt::gray, 10.0}}) {
                     painter.setPen(QPen(ink, width, Qt::SolidLine, Qt::RoundCap));
                     // Qt draws no line that is a point.
                     to == from ? painter.drawPoint(to) : painter.drawLine(from, to);
                 }
             },
             8.0, 0.02});
    }
    const auto turned = [](auto draw) {
        return [draw](QPainter& painter) {
            painter.translate(60, 10);
            painter.rotate(30);
            draw(painter);
        };
    };
    all.push_back({"turned dashes", QPen(Qt::black, 1.4, Qt::DashLine), Qt::NoBrush,
                   turned([](QPainter& painter) {
                       paintDisc(painter, {70, 20}, 30);
                   }),
                   turned([](QPainter& painter) { painter.drawEllipse(QPointF(70, 20), 30, 30); }),
                   0.01, 0.0});
    // Qt's circles have corners: the smaller, the more it shows.
    const QPointF middle(80.3, 77.7);
    for (const double radius : {3.6, 7.0, 41.3}) {
        for (const QBrush& brush : {QBrush(Qt::NoBrush), QBrush(QColor(90, 120, 30, 200))}) {
            for (const double width : {0.0, 1.2, 2.0}) {
                all.push_back(
                    {"disc", width > 0.0 ? QPen(Qt::black, width) : QPen(Qt::NoPen), brush,
                     [=](QPainter& painter) { paintDisc(painter, middle, radius); },
                     [=](QPainter& painter) { painter.drawEllipse(middle, radius, radius); },
                     radius < 10.0 ? 20.0 : 10.0, 0.07});
            }
        }
    }
    return all;
}

TEST(PaintShapes, LookAsQtsDo) {
    for (const AsQt& each : shapes()) {
        for (const double scale : {1.0, 1.5, 2.0}) {
            const QImage ours = onPaper(each.pen, each.brush, each.ours, scale);
            const QImage qts = onPaper(each.pen, each.brush, each.qts, scale);
            EXPECT_LT(test::differenceOf(qts, ours).mean(), each.difference)
                << each.name << ' ' << scale;
            EXPECT_LE(std::abs(inkOf(ours) - inkOf(qts)), each.ink * inkOf(qts))
                << each.name << ' ' << scale;
        }
    }
}

/// One of each, some of them cut by the paper's edge.
void paintEach(QPainter& painter, const QColor& ink, int alpha) {
    const auto pen = [&](double width, Qt::PenStyle style) {
        return QPen(QColor(ink.red(), ink.green(), ink.blue(), alpha), width, style);
    };
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(pen(1.6, Qt::SolidLine));
    painter.setBrush(QColor(200, 120, 0, alpha));
    painter.translate(3.3, 1.7);
    paintPolygon(painter, {{-20, 20}, {70, 60}, {60, 90}, {-40, 50}});
    paintDisc(painter, {120, 60}, 31.4);
    paintBar(painter, {150, 100}, {260, 140}, 9.0);
    paintBlock(painter, {20, 110, 60, 60}, 8.0);
    paintLine(painter, {10, 100}, {90, 145});
    painter.setPen(pen(1.2, Qt::DashLine));
    paintLine(painter, {150, 20}, {225, 35});
}

/// Onto the pixels of a picture directly, onto all else by a layer: that is the same.
TEST(PaintShapes, AreAlikeOnAPictureAndOnALayer) {
    for (const double scale : {1.0, 2.0}) {
        for (const int alpha : {255, 120}) {
            const auto painted = [&](bool hasLayer) {
                QImage image(paper().size() * scale, QImage::Format_RGB32);
                image.fill(QColor(230, 200, 90));
                image.setDevicePixelRatio(scale);
                QPainter painter(&image);
                if (hasLayer) {
                    painter.setClipRect(QRectF(QPointF(), paper().size()));
                }
                paintEach(painter, QColor(10, 40, 60), alpha);
                painter.end();
                return image;
            };
            const QImage onto = painted(false);
            const QImage layer = painted(true);
            EXPECT_LE(test::differenceOf(onto, layer).most, 2) << scale << ' ' << alpha;
        }
    }
}

class Sheet final : public QWidget {
  public:
    using QWidget::QWidget;
    QColor ink = Qt::blue;

    QImage alone() const {
        QImage image = paper();
        QPainter painter(&image);
        paintEach(painter, ink, 200);
        return image;
    }

  protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        painter.fillRect(rect(), Qt::white);
        paintEach(painter, ink, 200);
    }
};

TEST(PaintShapes, OfAWidgetStayWhereItIsPaintedAgain) {
    QWidget window;
    Sheet sheet(&window);
    sheet.setGeometry(QRect(QPoint(31, 17), paper().size()));
    test::showAt(window, {300, 200});
    const auto shown = [&] {
        return window.screen()
            ->grabWindow(window.winId())
            .toImage()
            .convertToFormat(QImage::Format_RGB32);
    };
    QImage before = shown();
    EXPECT_LE(test::differenceOf(before.copy(sheet.geometry()), sheet.alone()).most, 2);
    for (const QRegion& part :
         {QRegion(40, 30, 100, 70), QRegion(10, 90, 60, 50) + QRegion(150, 10, 60, 90)}) {
        sheet.ink = sheet.ink == Qt::blue ? Qt::red : Qt::darkGreen;
        sheet.repaint(part);
        QPainter painter(&before);
        painter.translate(sheet.pos());
        painter.setClipRegion(part);
        painter.drawImage(0, 0, sheet.alone());
        painter.end();
        EXPECT_LE(test::differenceOf(shown(), before).most, 2);
    }
}

TEST(LineBrush, FarBeyondThePictureTheDashesGoOn) {
    // The same dashes in sight, whether the line begins 6 or 6·10⁶ pixels before it.
    const double far = 6e6;
    const QImage near = byBrush({{-6, 60}, {300, 60}}, 1.0, Qt::DashLine);
    EXPECT_LT(test::differenceOf(byBrush({{-far, 60}, {far, 60}}, 1.0, Qt::DashLine), near).mean(),
              1.0);
    EXPECT_NEAR(inkOf(near), 240.0 * 4 / 6, 4.0);
    EXPECT_EQ(byBrush({{1e300, 1e300}, {3e300, 1e300}}, 1.6, Qt::DashLine), paper());
    EXPECT_EQ(byBrush({{-20, -20}, {-20, 300}}, 1.6, Qt::DashLine), paper());
}

}  // namespace
}  // namespace ravnoves
