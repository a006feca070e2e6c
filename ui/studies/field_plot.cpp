#include "studies/field_plot.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "plot/model/contour_lines.h"
#include "plot/model/ticks.h"
#include "text/csv_format.h"
#include "text/number_text.h"
#include "theme/theme.h"

namespace ravnoves {

namespace {

constexpr int wantedLevels = 8;

QColor depthColour(double part) {
    const bool dark = Theme::instance().isDark();
    const QColor pale = dark ? QColor(0x24, 0x2a, 0x31) : QColor(0xf4, 0xf7, 0xfb);
    const QColor deep = dark ? QColor(0x4f, 0x9b, 0xd9) : QColor(0x5b, 0x92, 0xc8);
    const auto channel = [&](int from, int to) {
        return static_cast<int>(std::lround(from + (to - from) * part));
    };
    return {channel(pale.red(), deep.red()), channel(pale.green(), deep.green()),
            channel(pale.blue(), deep.blue())};
}

}  // namespace

FieldPlot::FieldPlot(QWidget* parent) : PlotView({}, parent) {
    connect(&Theme::instance(), &Theme::changed, this, &FieldPlot::showImage);
}

void FieldPlot::setField(Field field) {
    field_ = std::move(field);
    low_ = std::numeric_limits<double>::infinity();
    high_ = -low_;
    for (const double value : field_.values) {
        if (std::isfinite(value)) {
            low_ = std::min(low_, value);
            high_ = std::max(high_, value);
        }
    }
    levels_.clear();
    if (high_ > low_) {
        step_ = niceStep(high_ - low_, wantedLevels);
        const double first = std::ceil(low_ / step_);
        for (int i = 0; i <= 4 * wantedLevels && (first + i) * step_ < high_; ++i) {
            levels_.push_back((first + i) * step_);
        }
    }
    showImage();
}

void FieldPlot::showImage() {
    const auto columns = static_cast<int>(field_.x.size());
    const auto rows = static_cast<int>(field_.y.size());
    if (columns < 2 || rows < 2 || !std::isfinite(low_)) {
        setImage({}, {});
        return;
    }
    QImage image(columns, rows, QImage::Format_ARGB32);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double value = field_.values[static_cast<std::size_t>(row) * field_.x.size() +
                                               static_cast<std::size_t>(column)];
            const double part = high_ > low_ ? (value - low_) / (high_ - low_) : 0.0;
            image.setPixelColor(column, rows - 1 - row,
                                std::isfinite(value) ? depthColour(part) : QColor(Qt::transparent));
        }
    }
    const double stepX = field_.x[1] - field_.x[0];
    const double stepY = field_.y[1] - field_.y[0];
    setImage(image, QRectF(field_.x.front() - 0.5 * stepX, field_.y.front() - 0.5 * stepY,
                           stepX * columns, stepY * rows));
}

void FieldPlot::paintGround(QPainter& painter) {
    if (levels_.empty()) {
        return;
    }
    const Theme& theme = Theme::instance();
    painter.save();
    painter.setClipRect(plotArea());
    painter.setFont(Theme::font(Theme::smallSize));
    const QFontMetricsF metrics(painter.font());
    std::vector<QRectF> taken;
    for (const double level : levels_) {
        const QString text =
            shownFormNumber(std::abs(level) < 1e-9 * step_ ? 0.0 : level, locale(), 6);
        QPolygonF longest;
        for (const QPolygonF& line :
             contourLines({field_.values, field_.x.size(), field_.y.size()}, level)) {
            QPolygonF pixels;
            for (const QPointF& at : line) {
                pixels << toPixel(field_.x.front() + at.x() * (field_.x[1] - field_.x[0]),
                                  field_.y.front() + at.y() * (field_.y[1] - field_.y[0]));
            }
            painter.setPen(QPen(theme.text(), 1.0));
            painter.drawPolyline(pixels);
            if (pixels.size() > longest.size()) {
                longest = pixels;
            }
        }
        // Its number where there is room along the longest line, from the middle on.
        QRectF box(0.0, 0.0, metrics.horizontalAdvance(text) + 6.0, metrics.height());
        for (const double part : {0.5, 0.35, 0.65, 0.2, 0.8}) {
            if (longest.isEmpty()) {
                break;
            }
            box.moveCenter(
                longest.at(static_cast<qsizetype>(part * static_cast<double>(longest.size() - 1))));
            if (plotArea().contains(box) &&
                std::none_of(taken.begin(), taken.end(),
                             [&](const QRectF& other) { return other.intersects(box); })) {
                taken.push_back(box);
                QColor veil = theme.panel();
                veil.setAlphaF(0.8F);
                painter.fillRect(box, veil);
                painter.drawText(box, Qt::AlignCenter, text);
                break;
            }
        }
    }
    painter.restore();
}

QString FieldPlot::csv(const CsvFormat& format) const {
    if (field_.values.empty()) {
        return {};
    }
    QStringList line{
        format.field(data().left.spec.title + QStringLiteral(" \\ ") + data().x.spec.title)};
    for (const double x : field_.x) {
        line << format.number(data().x.spec.factor * x);
    }
    QString table = line.join(format.separator) + QLatin1Char('\n');
    for (std::size_t row = 0; row < field_.y.size(); ++row) {
        line = QStringList{format.number(data().left.spec.factor * field_.y[row])};
        for (std::size_t column = 0; column < field_.x.size(); ++column) {
            const double value = field_.values[row * field_.x.size() + column];
            line << (std::isfinite(value) ? format.number(value) : QString());
        }
        table += line.join(format.separator) + QLatin1Char('\n');
    }
    return table;
}

QString FieldPlot::sentence() const {
    if (!std::isfinite(low_)) {
        return PlotView::sentence();
    }
    return tr("%1: from %2 to %3 over %4 and %5.")
        .arg(title(), shownFormNumber(low_, locale(), 5), shownFormNumber(high_, locale(), 5),
             data().x.spec.title, data().left.spec.title);
}

}  // namespace ravnoves
