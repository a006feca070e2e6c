#include "balance-shaft/speed_map_plot.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "balance-shaft/change_colours.h"
#include "plot/model/contour_lines.h"
#include "text/csv_format.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"

namespace ravnoves {

SpeedMapPlot::SpeedMapPlot(BalanceShaftModel* model, QWidget* parent)
    : PartPlot(model, "speed-map", parent), study_(model->speedStudy()) {
    setPickable(true);
    connect(this, &PlotView::pickedAt, study_, &SpeedStudyModel::pick);
    connect(study_, &SpeedStudyModel::mapChanged, this, &SpeedMapPlot::showMap);
    connect(&Theme::instance(), &Theme::changed, this, &SpeedMapPlot::showMap);
    showMap();
}

void SpeedMapPlot::showMap() {
    borders_.clear();
    setToolTip(map() == nullptr
                   ? QString()
                   : SpeedWords::tr("Criterion with the shaft over criterion without: blue "
                                    "smaller, orange larger, thick line 1.0, dimmed does not fit. "
                                    "Click to set α and, with a computed torque, the speed."));
    if (map() == nullptr) {
        setImage({}, {});
        return;
    }
    // 360° is 0° again, so that the lines reach both ends of the axis.
    const SpeedStudyModel::Map& map = study_->map();
    const auto columns = static_cast<std::size_t>(map.angles) + 1;
    const auto rows = static_cast<std::size_t>(map.speeds);
    std::vector<double> values;
    values.reserve(columns * rows);
    QImage image(map.angles + 1, map.speeds, QImage::Format_RGB32);
    const QColor pale = Theme::instance().panel();
    for (int s = 0; s < map.speeds; ++s) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(map.speeds - 1 - s));
        for (int a = 0; a <= map.angles; ++a) {
            const int angle = a % map.angles;
            values.push_back(map.value(s, angle));
            const QColor colour = changeColour(map.part(s, angle));
            line[a] = map.canBuild[static_cast<std::size_t>(angle)]
                          ? colour.rgb()
                          : mixedColour(colour, pale, 0.4).rgb();
        }
    }
    const double stepX = 360.0 / map.angles;
    const double stepY = map.speedStep();
    for (const QPolygonF& line : contourLines({values, columns, rows}, 1.0)) {
        QPolygonF border;
        for (const QPointF& point : line) {
            border << QPointF(point.x() * stepX, map.lowest + point.y() * stepY);
        }
        borders_.push_back(border);
    }
    // A pixel's middle is its value's place.
    setImage(image, QRectF(-0.5 * stepX, map.lowest - 0.5 * stepY, 360.0 + stepX,
                           map.highest - map.lowest + stepY));
}

// The bar: what helps to the left of 1, what harms to its right, each side on its own scale.

std::pair<double, double> SpeedMapPlot::barEnds() const {
    const double first = map()->least < 1.0 ? -1.0 : 0.0;
    return {first, map()->most > 1.0 ? 1.0 : std::max(0.0, first + 0.5)};
}

std::vector<BarNumber> SpeedMapPlot::barNumbers() const {
    std::vector<BarNumber> numbers;
    if (map() == nullptr) {
        return numbers;
    }
    const auto [first, last] = barEnds();
    const auto add = [&, first = first, last = last](double part, double value) {
        numbers.push_back(
            {(part - first) / (last - first), fixedNumber(value, 2, QLocale()), part == 0.0});
    };
    // What is no change first, then the ends: what has no room beside them is left out.
    add(0.0, 1.0);
    for (const double size : {1.0, 0.5}) {
        if (map()->least < 1.0) {
            add(-size, std::lerp(1.0, map()->least, size));
        }
        if (map()->most > 1.0) {
            add(size, std::lerp(1.0, map()->most, size));
        }
    }
    return numbers;
}

double SpeedMapPlot::keyHeight() const {
    return map() != nullptr
               ? colourBarHeight() + QFontMetricsF(Theme::font(Theme::smallSize)).height() + 6.0
               : 0.0;
}

void SpeedMapPlot::paintBar(QPainter& painter) const {
    const auto [first, last] = barEnds();
    const double top = keyTop();
    const double width = std::min(this->width() - 4.0 * Theme::margin, longestColourBar());
    const QRectF bar(2.0 * Theme::margin, top, width, colourBarHeight());
    for (int pixel = 0; pixel < static_cast<int>(bar.width()); ++pixel) {
        const double part = first + (last - first) * (pixel + 0.5) / bar.width();
        painter.fillRect(QRectF(bar.left() + pixel, top, 1.5, colourBarHeight()),
                         changeColour(part));
    }
    painter.setFont(Theme::font(Theme::smallSize));
    paintBarNumbers(painter, bar, barNumbers());
}

void SpeedMapPlot::paintGround(QPainter& painter) {
    if (map() == nullptr) {
        return;
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintBar(painter);
    painter.setClipRect(plotArea());
    painter.setBrush(Qt::NoBrush);
    const Theme& theme = Theme::instance();
    const QString text = fixedNumber(1.0, 1, QLocale());
    painter.setFont(Theme::font(Theme::smallSize, true));
    const QFontMetricsF metrics(painter.font());
    for (const QPolygonF& border : borders_) {
        QPolygonF line;
        for (const QPointF& point : border) {
            line << toPixel(point.x(), point.y());
        }
        painter.setPen(QPen(theme.text(), 2.4));
        painter.drawPolyline(line);
        if (line.size() < 12) {
            continue;
        }
        const QPointF middle = line[line.size() / 2];
        const QRectF box(middle.x() - metrics.horizontalAdvance(text) / 2.0 - 3.0,
                         middle.y() - metrics.height() / 2.0, metrics.horizontalAdvance(text) + 6.0,
                         metrics.height());
        painter.fillRect(box, theme.panel());
        painter.drawText(box, Qt::AlignCenter, text);
    }
    painter.restore();
}

QString SpeedMapPlot::wordsAt(double angleDeg, double speed) const {
    if (map() == nullptr) {
        return {};
    }
    const double value = map()->valueAt(angleDeg, speed);
    const QLocale locale;
    const double change = 100.0 * (value - 1.0);
    return tr("α %1°, n %2: %3 of the value without a shaft, %4")
        .arg(fixedNumber(angleDeg, 1, locale), shownNumber(speed * units::rpm, units::rpm, 0),
             fixedNumber(value, 3, locale),
             (change > 0.0 ? tr("%1 % worse") : tr("%1 % better"))
                 .arg(fixedNumber(std::abs(change), 1, locale)));
}

bool SpeedMapPlot::event(QEvent* event) {
    // Over the chart what is under the pointer stays; elsewhere stands how to read the map.
    if (event->type() == QEvent::ToolTip && map() != nullptr &&
        plotArea().contains(static_cast<QHelpEvent*>(event)->pos())) {
        return true;
    }
    return PlotView::event(event);
}

void SpeedMapPlot::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    const QString words = plotArea().contains(at) ? wordsAt(xAt(at.x()), yAt(at.y())) : QString();
    QToolTip::showText(event->globalPosition().toPoint(), words, this);
    Q_EMIT hovered(words);
    if (event->buttons() != Qt::NoButton) {
        PlotView::mouseMoveEvent(event);
    }
}

void SpeedMapPlot::stopReading() {
    Q_EMIT hovered({});
    PlotView::stopReading();
}

QString SpeedMapPlot::csv(const CsvFormat& format) const {
    if (map() == nullptr) {
        return {};
    }
    const auto number = [&format](double value) { return format.number(value); };
    const ShownTitle speed = shownTitle(tr("n, min⁻¹"));
    QString text = format.field(speed.text) + format.separator + format.field(tr("α, °")) +
                   format.separator + format.field(title()) + QLatin1Char('\n');
    const SpeedStudyModel::Map& map = study_->map();
    for (int s = 0; s < map.speeds; ++s) {
        for (int a = 0; a < map.angles; ++a) {
            text += number(speed.factor * (map.lowest + s * map.speedStep())) + format.separator +
                    number(360.0 * a / map.angles) + format.separator + number(map.value(s, a)) +
                    QLatin1Char('\n');
        }
    }
    return text;
}

}  // namespace ravnoves
