// Drawings as SVG, as another program shows them: what the painter's clip lets be seen.

#include <gtest/gtest.h>

#include <QBuffer>
#include <QPainter>
#include <QPainterPath>
#include <QPicture>
#include <QProcess>
#include <QXmlStreamReader>
#include <cmath>

#include "events.h"
#include "pictures/clipped_svg.h"
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
    QProcess program;
    program.start(QStringLiteral(RAVNOVES_RSVG_CONVERT),
                  {u"-z"_s, QString::number(finer), u"-b"_s, u"white"_s});
    program.write(svg);
    program.closeWriteChannel();
    EXPECT_TRUE(program.waitForFinished()) << program.errorString().toStdString();
    const QImage image = QImage::fromData(program.readAllStandardOutput());
    EXPECT_EQ(image.size(), sheet * finer) << program.readAllStandardError().constData();
    return image.convertToFormat(QImage::Format_RGB32);
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

/// Lines, areas, curves, pictures and points, each across a sheet and beyond.
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
    EXPECT_FALSE(svg.contains("<path"));
    EXPECT_TRUE(svg.contains(">i</text>"));
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
    QXmlStreamReader svg(
        svgOf([&](QPainter& painter) { plot.renderTo(painter, QRectF(plot.rect())); }));
    QString clip;  // of the group
    QMap<QString, QString> boxes;
    int curves = 0;
    while (!svg.atEnd()) {
        svg.readNext();
        const QXmlStreamAttributes attributes = svg.attributes();
        if (svg.name() == u"clipPath"_s && svg.isStartElement()) {
            const QString id = attributes.value(u"id"_s).toString();
            svg.readNextStartElement();
            boxes[u"url(#%1)"_s.arg(id)] = svg.attributes().value(u"width"_s).toString();
        } else if (svg.name() == u"g"_s && svg.isStartElement()) {
            clip = attributes.value(u"clip-path"_s).toString();
        } else if (svg.name() == u"polyline"_s && svg.isStartElement() &&
                   attributes.value(u"points"_s).count(u' ') > 1) {
            ++curves;
            EXPECT_NEAR(boxes.value(clip).toDouble(), plot.plotArea().width(), 1e-3);
        }
    }
    EXPECT_EQ(curves, 1);
    EXPECT_FALSE(svg.hasError()) << svg.errorString().toStdString();
}

}  // namespace
}  // namespace ravnoves
