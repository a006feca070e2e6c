#include "balance-shaft/change_map_plot.h"

#include <QFontMetricsF>
#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>

#include "pictures/model/stroke.h"
#include "plot/plot_painter.h"
#include "theme/theme.h"

namespace ravnoves {

using painter_parts::veil;

namespace {

/// @param part  from −1, helps most, over 0, no change, to 1, harms most
QColor changeColour(double part) {
    const bool dark = Theme::instance().isDark();
    const QColor neutral = dark ? QColor(0x2b3036) : QColor(0xf7f7f5);
    const std::array help = dark ? std::array{QColor(0x24557f), QColor(0x6cc0ff)}
                                 : std::array{QColor(0x92c5de), QColor(0x15508f)};
    const std::array harm = dark ? std::array{QColor(0x7a4a1c), QColor(0xe09a48)}
                                 : std::array{QColor(0xfccf9c), QColor(0xc2650f)};
    const auto& ends = part < 0.0 ? help : harm;
    const double size = std::min(std::abs(part), 1.0);
    return size <= 0.5 ? mixed(neutral, ends[0], 0.25 + 1.5 * size)
                       : mixed(ends[0], ends[1], 2.0 * size - 1.0);
}

/// Colours of the stretches between the levels.
std::vector<QRgb> bandColours(const std::vector<double>& levels) {
    const auto below = std::count_if(levels.begin(), levels.end(), [](double l) { return l < 0; });
    const auto above = std::ssize(levels) - below;
    std::vector<QRgb> colours;
    for (std::ptrdiff_t i = below + 1; i >= 1; --i) {
        colours.push_back(
            changeColour(-static_cast<double>(i) / static_cast<double>(below + 1)).rgb());
    }
    for (std::ptrdiff_t i = 1; i <= above; ++i) {
        colours.push_back(changeColour(static_cast<double>(i) / static_cast<double>(above)).rgb());
    }
    return colours;
}

double barHeight() {
    return Theme::withText(10);
}

/// A level of change in percent, without its unit: as many digits as that round number has.
QString levelText(double fraction) {
    const double percent = 100.0 * fraction;
    QString text = QLocale().toString(std::abs(percent), 'g', 4);
    if (percent < 0.0) {
        text.prepend(QChar(0x2212));
    } else if (percent > 0.0) {
        text.prepend(QLatin1Char('+'));
    }
    return text;
}

/// The field as bands of colour, each step of the grid drawn several pixels wide.
QImage changeImage(const ChangeContours& field) {
    constexpr int imageScale = 3;  // pixels of the picture to one step of the field
    const std::vector<double>& levels = field.levels;
    const std::vector<QRgb> colours = bandColours(levels);
    const std::size_t rows = field.changes.size() / field.columns;
    const int width = static_cast<int>(field.columns - 1) * imageScale + 1;
    const int height = static_cast<int>(rows - 1) * imageScale + 1;
    QImage image(width, height, QImage::Format_RGB32);
    std::vector<double> row(field.columns);
    for (int y = 0; y < height; ++y) {
        const int up = height - 1 - y;
        const auto lower = std::min(static_cast<std::size_t>(up / imageScale), rows - 2);
        const double t = static_cast<double>(up) / imageScale - static_cast<double>(lower);
        const double* at = field.changes.data() + lower * field.columns;
        for (std::size_t i = 0; i < field.columns; ++i) {
            row[i] = at[i] + t * (at[i + field.columns] - at[i]);
        }
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        std::size_t band = 0;
        for (int x = 0; x < width; ++x) {
            const auto left = std::min(static_cast<std::size_t>(x / imageScale), field.columns - 2);
            const double s = static_cast<double>(x) / imageScale - static_cast<double>(left);
            const double value = row[left] + s * (row[left + 1] - row[left]);
            while (band > 0 && value < levels[band - 1]) {
                --band;
            }
            while (band < levels.size() && value >= levels[band]) {
                ++band;
            }
            line[x] = colours[band];
        }
    }
    return image;
}

}  // namespace

ChangeMapPlot::ChangeMapPlot(SceneModel* model, std::string_view id, double indent, QWidget* parent)
    : PartPlot(model, id, parent), indent_(indent) {
    connect(&Theme::instance(), &Theme::changed, this, &ChangeMapPlot::showField);
}

void ChangeMapPlot::showField() {
    setImage(field().levels.empty() ? QImage() : changeImage(field()), field().where);
}

bool ChangeMapPlot::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (plotArea().contains(help->pos())) {
            QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
            return true;
        }
    }
    return PartPlot::event(event);
}

void ChangeMapPlot::paintGround(QPainter& painter) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (!field().levels.empty()) {
        paintKey(painter);
    }
    painter.setClipRect(plotArea());
    paintOnField(painter);
    const Theme& theme = Theme::instance();
    std::vector<LinesOfPen> all;
    for (const ChangeContours::Contour& contour : field().contours) {
        all.push_back(
            {contour.level == 0.0 ? QPen(theme.text(), 2.4) : QPen(veil(theme.text(), 0.38F), 1.0),
             {}});
        for (const QPolygonF& line : contour.lines) {
            QPolygonF& drawn = all.back().lines.emplace_back();
            drawn.reserve(line.size());
            for (const QPointF& point : line) {
                drawn << toPixel(point.x(), point.y());
            }
        }
    }
    painter.setBrush(Qt::NoBrush);
    paintLines(painter, all);
    painter.restore();
}

double ChangeMapPlot::keyHeight() const {
    return field().levels.empty()
               ? 0.0
               : barHeight() + QFontMetricsF(Theme::font(Theme::smallSize)).height() + 4.0;
}

/// In smaller type where two numbers would meet; what meets another even so has its line alone.
void ChangeMapPlot::paintKey(QPainter& painter) const {
    const std::vector<double>& levels = field().levels;
    const Theme& theme = Theme::instance();
    const std::vector<QRgb> colours = bandColours(levels);
    constexpr int longest = 460;
    const double room = width() - 2.0 * indent_;
    const QRectF bar(indent_, keyTop(), std::min<double>(room, Theme::withText(longest)),
                     barHeight());
    const double each = bar.width() / static_cast<double>(colours.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        painter.fillRect(
            QRectF(bar.left() + each * static_cast<double>(i), bar.top(), each + 0.5, bar.height()),
            QColor(colours[i]));
    }
    painter.setPen(QPen(theme.border(), 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(bar);
    const auto place = [&](std::size_t level) {
        return bar.left() + each * static_cast<double>(level + 1);
    };
    const auto boxOf = [&](std::size_t level, const QFontMetricsF& metrics) {
        const double wide = metrics.horizontalAdvance(levelText(levels[level])) +
                            0.6 * metrics.averageCharWidth() + 2.0;
        return QRectF(place(level) - wide / 2.0, bar.bottom() + 1.0, wide,
                      std::ceil(metrics.height()) + 1.0);
    };
    const auto meet = [&](const QFontMetricsF& metrics) {
        for (std::size_t i = 1; i < levels.size(); ++i) {
            if (boxOf(i - 1, metrics).intersects(boxOf(i, metrics))) {
                return true;
            }
        }
        return false;
    };
    QFont font = Theme::font(Theme::smallSize);
    constexpr int minimum = 8;  // pixels
    while (font.pixelSize() > minimum && meet(QFontMetricsF(font))) {
        font.setPixelSize(font.pixelSize() - 1);
    }
    painter.setFont(font);
    std::vector<QRectF> taken;
    const auto write = [&](std::size_t level) {
        const bool isNoChange = levels[level] == 0.0;
        const double x = place(level);
        painter.setPen(QPen(theme.text(), isNoChange ? 2.4 : 1.0));
        painter.drawLine(QPointF(x, isNoChange ? bar.top() - 1.0 : bar.bottom() - 3.0),
                         QPointF(x, bar.bottom() + (isNoChange ? 2.0 : 1.0)));
        const QRectF box = boxOf(level, QFontMetricsF(font));
        if (std::none_of(taken.begin(), taken.end(),
                         [&](const QRectF& other) { return other.intersects(box); })) {
            taken.push_back(box);
            painter.drawText(box, Qt::AlignCenter, levelText(levels[level]));
        }
    };
    // No change first: its number is in any case.
    const auto zero =
        static_cast<std::size_t>(std::find(levels.begin(), levels.end(), 0.0) - levels.begin());
    write(zero);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        if (i != zero) {
            write(i);
        }
    }
}

}  // namespace ravnoves
