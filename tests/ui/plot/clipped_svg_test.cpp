// Drawings as SVG show what the painter's clip lets be seen, and are else what Qt writes.

#include <gtest/gtest.h>

#include <QBuffer>
#include <QPainter>
#include <QPainterPath>
#include <QPicture>
#include <QRegularExpression>
#include <QSvgGenerator>
#include <QSvgRenderer>
#include <cmath>

#include "events.h"
#include "pictures/clipped_svg.h"
#include "pictures/model/clip_shape.h"
#include "plot/plot_view.h"

namespace ravnoves {
namespace {

using namespace Qt::StringLiterals;

const QSize sheet(120, 80);

template <typename Draw>
QByteArray svgOf(Draw&& draw) {
    QBuffer out;
    out.open(QIODevice::WriteOnly);
    ClippedSvg device(out, sheet);
    QPainter painter(&device);
    draw(painter);
    painter.end();
    return out.data();
}

constexpr int finer = 2;  ///< pixels to a unit of the sheet

QImage blank() {
    QImage image(sheet * finer, QImage::Format_RGB32);
    image.fill(Qt::white);
    return image;
}
QImage rendered(const QByteArray& svg) {
    QSvgRenderer renderer(svg);
    EXPECT_TRUE(renderer.isValid()) << svg.constData();
    QImage image = blank();
    QPainter painter(&image);
    renderer.render(&painter);
    return image;
}
template <typename Draw>
QImage painted(Draw&& draw) {
    QImage image = blank();
    QPainter painter(&image);
    painter.scale(finer, finer);
    draw(painter);
    return image;
}

/// Pixels that differ by more than half a shade, but for those beside an edge.
int different(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 2; y + 2 < a.height(); ++y) {
        for (int x = 2; x + 2 < a.width(); ++x) {
            const auto isThere = [&](const QImage& in, int shade) {
                for (int dy = -2; dy <= 2; ++dy) {
                    for (int dx = -2; dx <= 2; ++dx) {
                        if (std::abs(qGray(in.pixel(x + dx, y + dy)) - shade) < 128) {
                            return true;
                        }
                    }
                }
                return false;
            };
            count += isThere(a, qGray(b.pixel(x, y))) && isThere(b, qGray(a.pixel(x, y))) ? 0 : 1;
        }
    }
    return count;
}

/// Lines, areas, curves, pictures, points and a text, each across a sheet and beyond.
void drawMuch(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Qt::black, 0.8, Qt::SolidLine, Qt::FlatCap));
    painter.setBrush(Qt::NoBrush);
    QPolygonF wave;
    for (int x = -10; x <= 130; ++x) {
        wave << QPointF(x, 40.0 + 45.0 * std::sin(0.1 * x));
    }
    painter.drawPolyline(wave);
    painter.setBrush(QColor(0, 0, 0, 200));
    painter.drawEllipse(QPointF(60, 10), 14.0, 20.0);
    painter.drawRect(QRectF(-20, 60, 60, 40));
    painter.drawPolygon(QPolygonF{{80, 30}, {140, 90}, {70, 70}, {90, 55}});
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(5, 5, 110, 70), 30, 30);
    QImage image(20, 10, QImage::Format_RGB32);
    image.fill(Qt::black);
    painter.drawImage(QRectF(5, 12, 33, 25), image);
    painter.save();
    painter.translate(100, 40);
    painter.rotate(-90);
    painter.setPen(QPen(Qt::black, 1.0, Qt::DashLine, Qt::FlatCap));
    painter.drawLine(QPointF(-60, 5), QPointF(60, 5));
    painter.restore();
    painter.drawPoint(QPointF(60, 75));
    QFont font = painter.font();
    font.setPixelSize(24);
    painter.setFont(font);
    painter.drawText(QPointF(45, 50), u"Mf"_s);
}

TEST(ClippedSvg, ShowsWhatThePainterShows) {
    const auto rectangle = [](QPainter& painter) {
        painter.setClipRect(QRectF(20.5, 15.25, 72.0, 50.5));
    };
    const auto both = [](QPainter& painter) {
        painter.setClipRect(QRectF(30, 10, 100, 100));
        painter.setClipRect(QRectF(-10, 20.5, 105, 50), Qt::IntersectClip);
    };
    const auto region = [](QPainter& painter) { painter.setClipRegion(QRect(10, 10, 90, 60)); };
    using Clip = std::function<void(QPainter&)>;
    int number = 0;
    for (const Clip& clip : {Clip(rectangle), Clip(both), Clip(region)}) {
        const auto draw = [&](QPainter& painter) {
            clip(painter);
            drawMuch(painter);
        };
        const QImage expected = painted(draw);
        const QImage svg = rendered(svgOf(draw));
        EXPECT_LE(different(svg, expected), 20) << number;
        EXPECT_GT(different(svg, painted(drawMuch)), 200) << number;
        ++number;
    }
}

TEST(ClippedSvg, GivesBackTheClipOfBefore) {
    const auto draw = [](QPainter& painter) {
        painter.setClipRect(QRect(20, 10, 80, 60));
        painter.save();
        painter.translate(30, 5);
        painter.setClipRect(QRectF(0.5, 10.5, 20.0, 20.0), Qt::IntersectClip);
        painter.fillRect(QRectF(-100, -100, 300, 300), Qt::black);
        painter.restore();
        painter.fillRect(QRectF(0, 60, 300, 8), Qt::black);
        painter.setClipping(false);
        painter.fillRect(QRectF(0, 75, 300, 5), Qt::black);
    };
    EXPECT_EQ(different(rendered(svgOf(draw)), painted(draw)), 0);
    // A picture that was recorded brings its own.
    const auto replay = [&](QPainter& painter) {
        QPicture picture;
        QPainter recorder(&picture);
        draw(recorder);
        recorder.end();
        painter.drawPicture(0, 0, picture);
    };
    EXPECT_EQ(different(rendered(svgOf(replay)), painted(draw)), 0);
}

/// What is drawn, without the groups that hold pens and brushes: some of Qt's are empty.
QByteArray elements(const QByteArray& svg) {
    QByteArrayList kept;
    for (const QByteArray& line : svg.split('\n')) {
        if (line.startsWith('<') && !line.startsWith("<g ") && line != "</g>") {
            kept << line;
        }
    }
    return kept.join('\n');
}

TEST(ClippedSvg, WritesWhatIsSeenWholeAsQtDoes) {
    QBuffer out;
    out.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&out);
    generator.setResolution(96);
    generator.setSize(sheet);
    generator.setViewBox(QRect(QPoint(), sheet));
    generator.setTitle({});
    QPainter direct(&generator);
    drawMuch(direct);
    direct.end();
    EXPECT_EQ(elements(svgOf(drawMuch)).toStdString(), elements(out.data()).toStdString());
    // Nothing more for a clip that cuts nothing.
    EXPECT_EQ(elements(svgOf([](QPainter& painter) {
                  painter.setClipRect(QRectF(-50.5, -50, 300, 300));
                  drawMuch(painter);
              })).toStdString(),
              elements(out.data()).toStdString());
}

TEST(ClippedSvg, LeavesOutWhatIsNotSeen) {
    const QByteArray svg = svgOf([](QPainter& painter) {
        painter.setClipRect(QRectF(10, 10, 20, 20));
        painter.drawText(QPointF(50, 50), u"hidden"_s);
        painter.drawLine(QPointF(40, 0), QPointF(80, 80));
        painter.drawEllipse(QPointF(70, 60), 9.0, 9.0);
        painter.drawText(QPointF(12, 25), u"i"_s);
    });
    EXPECT_FALSE(svg.contains("hidden"));
    EXPECT_FALSE(svg.contains("<polyline"));
    EXPECT_FALSE(svg.contains("<circle"));
    EXPECT_TRUE(svg.contains(">i</text>"));
}

TEST(ClippedSvg, DashesGoOnWhereTheyWere) {
    const auto draw = [](QPainter& painter) {
        painter.setClipRect(QRectF(33.3, 0, 60, 80));
        painter.setPen(QPen(Qt::black, 4.0, Qt::DashLine, Qt::FlatCap));
        painter.drawLine(QPointF(0, 40), QPointF(120, 40));
    };
    EXPECT_EQ(different(rendered(svgOf(draw)), painted(draw)), 0);
}

TEST(ClipShape, DoesNotBreakAClosedLineAtItsFirstPoint) {
    const ClipShape clip({0.0, 0.0, 10.0, 10.0});
    const auto seen = clip.cutLine(QPolygonF{{5, 5}, {20, 5}, {20, 8}, {5, 8}, {5, 5}});
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_EQ(seen[0].points.size(), 4);
    EXPECT_NEAR(seen[0].before, 15.0 + 3.0 + 10.0, 0.02);
}

/// A zoom leaves curves that run far beyond the chart.
TEST(ClippedSvg, ACurveOfAZoomedPlotStaysInItsChart) {
    PlotView plot;
    Figure figure{.title = u"Torque"_s,
                  .x = {u"φ, °"_s, 0.0, 720.0, true},
                  .leftRange = std::pair(-50.0, 50.0)};
    figure.add("M", {.name = u"M"_s}, {0.0, 180.0, 360.0, 540.0, 720.0},
               {0.0, 500.0, -500.0, 500.0, 0.0});
    plot.showFigure(figure);
    test::showAt(plot, {300, 200});
    QBuffer out;
    out.open(QIODevice::WriteOnly);
    ClippedSvg device(out, plot.size());
    QPainter painter(&device);
    plot.renderTo(painter, QRectF(plot.rect()));
    painter.end();
    // The generator writes a curve as a polyline: none leaves the chart.
    const QString svg = QString::fromUtf8(out.data());
    static const QRegularExpression curves(u"<polyline [^>]*points=\"([^\"]*)\""_s);
    constexpr double line = 0.6;  // half of an axis
    const QRectF chart = plot.plotArea().adjusted(-line, -line, line, line);
    int inside = 0;
    for (const QRegularExpressionMatch& curve : curves.globalMatch(svg)) {
        const QStringList points = curve.captured(1).split(u' ', Qt::SkipEmptyParts);
        for (const QString& point : points) {
            const QPointF at(point.section(u',', 0, 0).toDouble(),
                             point.section(u',', 1, 1).toDouble());
            const bool isTick = at.x() < chart.left() || at.y() > chart.bottom() + 1.0;
            inside += chart.contains(at) ? 1 : 0;
            EXPECT_TRUE(chart.contains(at) || (isTick && points.size() == 2) || at.y() < 30.0)
                << at.x() << ' ' << at.y();
            EXPECT_TRUE(QRectF(plot.rect()).contains(at)) << at.x() << ' ' << at.y();
        }
    }
    EXPECT_GT(inside, 6);
}

}  // namespace
}  // namespace ravnoves
