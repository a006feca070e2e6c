#include "plot/model/line_brush.h"

#include <QPen>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

#include "plot/model/pixel.h"

namespace ravnoves {

namespace {

constexpr double tiny = 1e-9;

/// A mixture of two premultiplied colours, `share` of 255 parts of the first.
std::uint32_t mixed(std::uint32_t colour, std::uint32_t ground, std::uint32_t share) {
    constexpr std::uint32_t pair = 0xff00ff;
    const std::uint32_t rest = 255 - share;
    const auto ofPair = [&](std::uint32_t one, std::uint32_t other) {
        const std::uint32_t sum = one * share + other * rest;
        return ((sum + ((sum >> 8) & pair) + 0x800080) >> 8) & pair;
    };
    return ofPair(colour & pair, ground & pair) | ofPair((colour >> 8) & pair, (ground >> 8) & pair)
                                                      << 8;
}

int clamped(double value, int least, int most) {
    return static_cast<int>(
        std::clamp(value, static_cast<double>(least), static_cast<double>(most)));
}

/// How far a line that reaches so far to its sides reaches past an end.
/// @param next  where it goes on from there; null: the end is flat
double pastEnd(const QPointF& end, const QPointF* next, const QPointF& along, double reach) {
    if (next == nullptr) {
        return 0.5;
    }
    // Into the wedge between both, no farther than they turn.
    const QPointF way = *next - end;
    const double length = std::sqrt(QPointF::dotProduct(way, way));
    const bool goesOn = length > tiny && QPointF::dotProduct(way, along) > 0.0;
    const double turn = std::abs(way.x() * along.y() - way.y() * along.x()) / length;
    return goesOn && turn < 1.0 ? reach * turn : reach;
}

/// The least whole number that is no less, within bounds of which the lower is no less than 0.
int clampedUp(double value, int least, int most) {
    const int whole = clamped(value, least, most);
    return whole + (whole < most && whole < value ? 1 : 0);
}

/// Whether 32 pixels have nothing on them.
bool isClear(const std::uint8_t* cover) {
    std::array<std::uint64_t, 4> parts{};
    std::memcpy(parts.data(), cover, sizeof parts);
    return (parts[0] | parts[1] | parts[2] | parts[3]) == 0;
}

}  // namespace

LineBrush::LineBrush(QImage& picture, const QRect& clip)
    : picture_(picture),
      clip_(clip & picture.rect()),
      cover_(static_cast<std::size_t>(std::max(0, clip_.width()) * std::max(0, clip_.height()))),
      touched_(static_cast<std::size_t>(std::max(0, clip_.height())), {clip_.width(), 0}),
      inked_(touched_) {}

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
    const double beforeStart = pastEnd(from, before, {-ux, -uy}, reach);
    const double beyondEnd = pastEnd(to, after, {ux, uy}, reach);
    const double upper = std::min(from.y() - beforeStart * uy, to.y() + beyondEnd * uy);
    const double lower = std::max(from.y() - beforeStart * uy, to.y() + beyondEnd * uy);
    const double sideways = reach * std::abs(ux);
    const int first = clampedUp(upper - sideways - 0.5, 0, clip_.height());
    const int beyond = clamped(lower + sideways + 0.5, 0, clip_.height());
    const bool isSlanted = std::abs(uy) > tiny;
    const bool isUpright = std::abs(ux) <= tiny;
    const double perUx = isUpright ? 0.0 : 1.0 / ux;
    const double perUy = isSlanted ? 1.0 / uy : 0.0;
    const double sideRoom = std::abs(reach * perUy);
    const double start = std::min(-beforeStart * perUx, (length + beyondEnd) * perUx);
    const double end = std::max(-beforeStart * perUx, (length + beyondEnd) * perUx);
    // Nearer to an end than this, the end tells.
    const double innerStart = before != nullptr ? 0.0 : 0.5;
    const double innerEnd = length - (after != nullptr ? 0.0 : 0.5);
    const bool hasInner = innerEnd > innerStart;
    const double inner = std::min(innerStart * perUx, innerEnd * perUx);
    const double outer = std::max(innerStart * perUx, innerEnd * perUx);
    for (int row = first; row < beyond; ++row) {
        // Pixels within reach of the line's two sides and two ends, from its beginning.
        const double y = row + 0.5 - from.y();
        double low = -1e9;
        double high = 1e9;
        if (isSlanted) {
            low = y * ux * perUy - sideRoom;
            high = y * ux * perUy + sideRoom;
        } else if (std::abs(y * ux) > reach) {
            continue;
        }
        const double shift = y * uy * perUx;
        if (!isUpright) {
            low = std::max(low, start - shift);
            high = std::min(high, end - shift);
        } else if (y * uy < -beforeStart || y * uy > length + beyondEnd) {
            continue;
        }
        const double zero = from.x() - 0.5;  // column of its beginning
        const int left = clampedUp(low + zero - tiny, 0, clip_.width());
        const int right = clamped(high + zero + tiny + 1.0, 0, clip_.width());
        if (left >= right) {
            continue;
        }
        auto& touched = touched_[static_cast<std::size_t>(row)];
        touched = {std::min(touched.first, left), std::max(touched.second, right)};
        std::uint8_t* cover = cover_.data() + static_cast<std::ptrdiff_t>(row) * clip_.width();
        const auto markEnds = [&](int begin, int stop) {
            for (int column = begin; column < stop; ++column) {
                const double x = column - zero;
                const double at = x * ux + y * uy;
                double away = std::abs(y * ux - x * uy);
                double part = 1.0;
                const double over = std::max(-at, at - length);
                if (over > -0.5) {
                    const bool atStart = at < 0.5 * length;
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
                    std::max(cover[column], static_cast<std::uint8_t>(pixelStep(covered)));
            }
        };
        // Between the ends the distance from the line is all.
        int begin = right;
        int stop = right;
        if (hasInner && !isUpright) {
            begin = clampedUp(inner - shift + zero, left, right);
            stop = clamped(outer - shift + zero + 1.0, begin, right);
        } else if (hasInner && y * uy > innerStart && y * uy < innerEnd) {
            begin = left;
        }
        markEnds(left, begin);
        const double across = y * ux + zero * uy;
        for (int column = begin; column < stop; ++column) {
            const double away = std::abs(across - column * uy);
            const double covered = std::min(std::max(reach - away, 0.0), 1.0);
            cover[column] =
                std::max(cover[column], static_cast<std::uint8_t>(pixelStep(covered)));
        }
        markEnds(stop, right);
    }
}

void LineBrush::ink(const QColor& colour) {
    const auto paint = static_cast<std::uint32_t>(colour.rgb());
    const auto alpha = static_cast<std::uint32_t>(colour.alpha());
    for (int row = 0; row < clip_.height(); ++row) {
        auto& touched = touched_[static_cast<std::size_t>(row)];
        if (touched.first >= touched.second) {
            continue;
        }
        auto& inked = inked_[static_cast<std::size_t>(row)];
        inked = {std::min(inked.first, touched.first), std::max(inked.second, touched.second)};
        std::uint8_t* cover = cover_.data() + static_cast<std::ptrdiff_t>(row) * clip_.width();
        auto* pixels =
            reinterpret_cast<std::uint32_t*>(picture_.scanLine(clip_.top() + row)) + clip_.left();
        int column = touched.first;
        while (column < touched.second) {
            std::uint64_t eight = 0;
            if (column + 8 <= touched.second) {
                constexpr int most = 32;
                if (column + most <= touched.second && isClear(cover + column)) {
                    column += most;
                    continue;
                }
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
