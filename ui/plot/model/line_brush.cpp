#include "plot/model/line_brush.h"

#include <QPen>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace ravnoves {

namespace {

constexpr double tiny = 1e-9;

/// A mixture of two colours without alpha, `share` of 255 parts of the first.
std::uint32_t mixed(std::uint32_t colour, std::uint32_t ground, std::uint32_t share) {
    constexpr std::uint32_t outer = 0xff00ff;
    constexpr std::uint32_t middle = 0x00ff00;
    const std::uint32_t rest = 255 - share;
    std::uint32_t redBlue = (colour & outer) * share + (ground & outer) * rest;
    redBlue = ((redBlue + ((redBlue >> 8) & outer) + 0x800080) >> 8) & outer;
    std::uint32_t green = ((colour & middle) >> 8) * share + ((ground & middle) >> 8) * rest;
    green = (green + (green >> 8) + 0x80) & middle;
    return 0xff000000U | redBlue | green;
}

int clamped(double value, int least, int most) {
    return static_cast<int>(
        std::clamp(value, static_cast<double>(least), static_cast<double>(most)));
}

}  // namespace

LineBrush::LineBrush(QImage& picture, const QRect& clip)
    : picture_(picture),
      clip_(clip & picture.rect()),
      cover_(static_cast<std::size_t>(std::max(0, clip_.width()) * std::max(0, clip_.height()))),
      touched_(static_cast<std::size_t>(std::max(0, clip_.height())), {clip_.width(), 0}) {}

void LineBrush::draw(const std::vector<QPolygonF>& lines, double scale, const QColor& colour,
                     double width, Qt::PenStyle style) {
    if (style == Qt::NoPen) {
        return;
    }
    QList<qreal> dashes = QPen(colour, width, style).dashPattern();
    for (qreal& part : dashes) {
        part *= width;
    }
    draw(lines, scale, colour, width, dashes);
}

void LineBrush::draw(const std::vector<QPolygonF>& lines, double scale, const QColor& colour,
                     double width, const QList<qreal>& dashes) {
    if (clip_.isEmpty()) {
        return;
    }
    half_ = 0.5 * std::max(1.0, width);
    QPolygonF line;
    for (const QPolygonF& each : lines) {
        line.resize(each.size());
        std::transform(each.begin(), each.end(), line.begin(), [&](const QPointF& point) {
            return point * scale - QPointF(clip_.topLeft());
        });
        dashes.isEmpty() ? mark(line) : markDashes(line, dashes);
    }
    ink(colour);
}

void LineBrush::markDashes(const QPolygonF& line, const QList<qreal>& pattern) {
    const double period = std::accumulate(pattern.begin(), pattern.end(), 0.0);
    qsizetype part = 0;
    double left = pattern.front();  // of the dash or the gap
    QPolygonF dash;
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF way = line[i] - line[i - 1];
        const double length = std::hypot(way.x(), way.y());
        if (!(length > tiny) || !std::isfinite(length)) {
            continue;
        }
        const auto go = [&](double from, double to, bool seen) {
            while (to - from > tiny) {
                const double next = std::min(to, from + left);
                if (seen && part % 2 == 0) {
                    if (dash.isEmpty()) {
                        dash << line[i - 1] + way * (from / length);
                    }
                    dash << line[i - 1] + way * (next / length);
                }
                left -= next - from;
                from = next;
                if (left <= tiny) {
                    mark(dash);
                    dash.clear();
                    part = (part + 1) % pattern.size();
                    left = pattern[part];
                }
            }
        };
        // Of what lies beyond the clip whole periods are passed over, not counted.
        const auto [enters, leaves] = stretchSeen(line[i - 1], way / length, length);
        go(0.0, std::fmod(enters, period), false);
        go(enters, leaves, true);
        if (leaves < length) {
            mark(dash);
            dash.clear();
            go(0.0, std::fmod(length - leaves, period), false);
        }
    }
    mark(dash);
}

std::pair<double, double> LineBrush::stretchSeen(const QPointF& from, const QPointF& along,
                                                 double length) const {
    double enters = 0.0;
    double leaves = length;
    const auto within = [&](double at, double speed, double most) {
        const double room = half_ + 1.0;
        if (std::abs(speed) < tiny) {
            leaves = at < -room || at > most + room ? 0.0 : leaves;
            return;
        }
        const double one = (-room - at) / speed;
        const double other = (most + room - at) / speed;
        enters = std::max(enters, std::min(one, other));
        leaves = std::min(leaves, std::max(one, other));
    };
    within(from.x(), along.x(), clip_.width());
    within(from.y(), along.y(), clip_.height());
    return enters < leaves ? std::pair(enters, leaves) : std::pair(0.0, 0.0);
}

void LineBrush::mark(const QPolygonF& line) {
    for (qsizetype i = 1; i < line.size(); ++i) {
        markSegment(line[i - 1], line[i], i > 1 ? &line[i - 2] : nullptr,
                    i + 1 < line.size() ? &line[i + 1] : nullptr);
    }
}

void LineBrush::markSegment(const QPointF& from, const QPointF& to, const QPointF* before,
                            const QPointF* after) {
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    const double reach = half_ + 0.5;
    if (!(length > tiny) || !std::isfinite(length) || std::max(from.x(), to.x()) < -reach ||
        std::min(from.x(), to.x()) > clip_.width() + reach) {
        return;
    }
    const double ux = way.x() / length;
    const double uy = way.y() / length;
    const int first = clamped(std::min(from.y(), to.y()) - reach, 0, clip_.height());
    const int beyond = clamped(std::max(from.y(), to.y()) + reach + 1.0, 0, clip_.height());
    for (int row = first; row < beyond; ++row) {
        // Pixels within reach of the line's two sides and two ends, from its beginning.
        const double y = row + 0.5 - from.y();
        double low = -1e9;
        double high = 1e9;
        if (std::abs(uy) > tiny) {
            low = (y * ux - reach) / uy;
            high = (y * ux + reach) / uy;
            if (low > high) {
                std::swap(low, high);
            }
        } else if (std::abs(y * ux) > reach) {
            continue;
        }
        if (std::abs(ux) > tiny) {
            double start = (-reach - y * uy) / ux;
            double end = (length + reach - y * uy) / ux;
            if (start > end) {
                std::swap(start, end);
            }
            low = std::max(low, start);
            high = std::min(high, end);
        } else if (y * uy < -reach || y * uy > length + reach) {
            continue;
        }
        const int left = clamped(low + from.x() - 0.5, 0, clip_.width());
        const int right = clamped(high + from.x() + 1.5, 0, clip_.width());
        if (left >= right) {
            continue;
        }
        auto& touched = touched_[static_cast<std::size_t>(row)];
        touched = {std::min(touched.first, left), std::max(touched.second, right)};
        std::uint8_t* cover = cover_.data() + static_cast<std::ptrdiff_t>(row) * clip_.width();
        for (int column = left; column < right; ++column) {
            const double x = column + 0.5 - from.x();
            const double along = x * ux + y * uy;
            double away = std::abs(y * ux - x * uy);
            double part = 1.0;
            const double over = std::max(-along, along - length);
            if (over > -0.5) {
                const bool atStart = along < 0.5 * length;
                const QPointF* const next = atStart ? before : after;
                if (next == nullptr) {
                    part = std::clamp(0.5 - over, 0.0, 1.0);
                } else if (over > 0.0) {
                    // Round in the wedge between both; beyond it is the neighbour's.
                    const QPointF& joint = atStart ? from : to;
                    const QPointF there = QPointF(column, row) + QPointF(0.5, 0.5) - joint;
                    if (QPointF::dotProduct(there, *next - joint) > 0.0) {
                        continue;
                    }
                    away = std::sqrt(away * away + over * over);
                }
            }
            const double covered = part * std::clamp(reach - away, 0.0, 1.0);
            cover[column] =
                std::max(cover[column], static_cast<std::uint8_t>(covered * 255.0 + 0.5));
        }
    }
}

void LineBrush::ink(const QColor& colour) {
    const auto paint = static_cast<std::uint32_t>(colour.rgb());
    const auto alpha = static_cast<std::uint32_t>(colour.alpha());
    for (int row = 0; row < clip_.height(); ++row) {
        auto& touched = touched_[static_cast<std::size_t>(row)];
        std::uint8_t* cover = cover_.data() + static_cast<std::ptrdiff_t>(row) * clip_.width();
        auto* pixels =
            reinterpret_cast<std::uint32_t*>(picture_.scanLine(clip_.top() + row)) + clip_.left();
        int column = touched.first;
        while (column < touched.second) {
            std::uint64_t eight = 0;
            if (column + 8 <= touched.second) {
                std::memcpy(&eight, cover + column, sizeof eight);
                if (eight == 0) {
                    column += 8;
                    continue;
                }
            }
            const int stop = std::min(column + 8, touched.second);
            for (; column < stop; ++column) {
                if (cover[column] != 0) {
                    const std::uint32_t share =
                        alpha == 255 ? cover[column] : (cover[column] * alpha + 127) / 255;
                    pixels[column] = mixed(paint, pixels[column], share);
                    cover[column] = 0;
                }
            }
        }
        touched = {clip_.width(), 0};
    }
}

}  // namespace ravnoves
