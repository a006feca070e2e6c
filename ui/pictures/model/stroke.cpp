#include "pictures/model/stroke.h"

#include <QColor>
#include <QImage>
#include <QLineF>
#include <QMap>
#include <QPainter>
#include <QPainterPath>
#include <QRect>
#include <QtEndian>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "pictures/model/pixel.h"

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

/// What a colour that lets through takes of a pixel that is covered in part; both of 255.
std::uint32_t shareOf(std::uint32_t cover, std::uint32_t alpha) {
    return alpha == 255 ? cover : (cover * alpha + 127) / 255;
}

// For each row and pixel: one instruction each, where a branch would go another way at each edge.
double greater(double a, double b) {
    return a > b ? a : b;
}
double less(double a, double b) {
    return a < b ? a : b;
}

/// A whole number within 0 and `most`, cut off.
int wholeWithin(double value, double maximum) {
    return static_cast<int>(less(greater(value, 0.0), maximum));
}
/// The same of the smallest whole number that is no less.
int wholeUpWithin(double value, double maximum) {
    const double within = less(greater(value, 0.0), maximum);
    const int whole = static_cast<int>(within);
    return whole + static_cast<int>(whole < within);
}

struct Span {
    double from;
    double to;
};
constexpr Span everywhere{-1e9, 1e9};

Span spanOf(double one, double other) {
    return {less(one, other), greater(one, other)};
}

/// How far a line that reaches so far to its sides reaches past an end.
/// @param next  where it continues from there; null: the end is flat
double pastEnd(const QPointF& end, const QPointF* next, const QPointF& along, double reach) {
    if (next == nullptr) {
        return 0.5;
    }
    // Into the wedge between both, no farther than they turn.
    const QPointF way = *next - end;
    const double length = std::sqrt(QPointF::dotProduct(way, way));
    const bool continues = length > tiny && QPointF::dotProduct(way, along) > 0.0;
    const double turn = std::abs(way.x() * along.y() - way.y() * along.x()) / length;
    return continues && turn < 1.0 ? reach * turn : reach;
}

/// Kept from one brush to the next, nothing of it covered: a window's would be cleared each time.
std::vector<std::uint8_t>& coverOf(const QSize& size) {
    static thread_local std::vector<std::uint8_t> cover;
    const auto needed =
        static_cast<std::size_t>(std::max(0, size.width()) * std::max(0, size.height())) +
        sizeof(std::uint64_t);
    cover.resize(std::max(cover.size(), needed));
    return cover;
}

/// Draws lines wider than a pixel into a picture, antialiased, by the distance of each pixel from
/// the line. Qt makes the outline of such a line and fills it: ten times the work, for the same
/// picture but for the last shades of its edges. Ends are flat, bends round; where a line crosses
/// itself it is no darker. All in pixels of the picture.
class LineBrush {
  public:
    /// @param picture  RGB32 or premultiplied ARGB32, written to until the brush is destroyed
    /// @param clip  pixels of the picture that may change
    LineBrush(QImage& picture, const QRect& clip)
        : picture_(picture),
          clip_(clip & picture.rect()),
          cover_(coverOf(clip_.size())),
          touched_(static_cast<std::size_t>(std::max(0, clip_.height())), {clip_.width(), 0}) {}

    /// @param width  at least 1
    /// @param dashes  dash, gap, …; none: a solid line
    void draw(const std::vector<QPolygonF>& lines, const QColor& colour, double width,
              const QList<qreal>& dashes) {
        if (clip_.isEmpty()) {
            return;
        }
        half_ = 0.5 * std::max(1.0, width);
        for (const QPolygonF& each : lines) {
            const QPolygonF line = each.translated(-clip_.topLeft());
            dashes.isEmpty() ? mark(line) : markDashes(line, dashes);
        }
        ink(colour);
    }

  private:
    void markDashes(const QPolygonF& line, const QList<qreal>& pattern) {
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
            const double room = half_ + 1.0;
            const QRectF near = QRectF(QPointF(), clip_.size()).adjusted(-room, -room, room, room);
            const auto seen = crossings({line[i - 1], line[i]}, near).value_or(std::pair(0.0, 0.0));
            const double enters = seen.first * length;
            const double leaves = seen.second * length;
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

    void mark(const QPolygonF& line) {
        for (qsizetype i = 1; i < line.size(); ++i) {
            markSegment(line[i - 1], line[i], i > 1 ? &line[i - 2] : nullptr,
                        i + 1 < line.size() ? &line[i + 1] : nullptr);
        }
    }

    /// @param before, after  points that the line comes from and continues to; null at its ends
    void markSegment(const QPointF& from, const QPointF& to, const QPointF* before,
                     const QPointF* after) {
        const QPointF way = to - from;
        const double length = std::sqrt(QPointF::dotProduct(way, way));
        const double reach = half_ + 0.5;
        if (!(length > tiny) || !std::isfinite(length) || std::max(from.x(), to.x()) < -reach ||
            std::min(from.x(), to.x()) > clip_.width() + reach) {
            return;
        }
        const double ux = way.x() / length;
        const double uy = way.y() / length;
        const double beforeStart = pastEnd(from, before, {-ux, -uy}, reach);
        const double beyondEnd = pastEnd(to, after, {ux, uy}, reach);
        const Span rows = spanOf(from.y() - beforeStart * uy, to.y() + beyondEnd * uy);
        const double sideways = reach * std::abs(ux);
        const int first = wholeUpWithin(rows.from - sideways - 0.5, clip_.height());
        const int beyond = wholeWithin(rows.to + sideways + 0.5, clip_.height());
        // Columns within reach of its two sides, between its ends, and where the distance from it
        // is all: nearer to an end than this, the end tells. They move with the rows.
        const bool isUpright = std::abs(ux) <= tiny;
        const bool isLevel = std::abs(uy) <= tiny;
        const double perUx = isUpright ? 0.0 : 1.0 / ux;
        const double perUy = isLevel ? 0.0 : 1.0 / uy;
        const double zero = from.x() - 0.5;  // column of its beginning
        const double sideRoom = tiny + (isLevel ? everywhere.to : std::abs(reach * perUy));
        const double sidePerRow = ux * perUy;
        const double endPerRow = -uy * perUx;
        const double innerStart = before != nullptr ? 0.0 : 0.5;
        const double innerEnd = length - (after != nullptr ? 0.0 : 0.5);
        const auto columns = [&](double start, double end) {
            return isUpright ? everywhere : spanOf(zero + start * perUx, zero + end * perUx);
        };
        const Span ends = columns(-beforeStart, length + beyondEnd);
        const Span inner = columns(innerStart, innerEnd);
        for (int row = first; row < beyond; ++row) {
            const double y = row + 0.5 - from.y();
            const double side = zero + y * sidePerRow;
            const double shift = y * endPerRow;
            const int left =
                wholeUpWithin(greater(side - sideRoom, ends.from + shift - tiny), clip_.width());
            const int right =
                wholeWithin(less(side + sideRoom, ends.to + shift + tiny) + 1.0, clip_.width());
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
            int begin = right;
            int stop = right;
            if (innerEnd > innerStart &&
                (!isUpright || (y * uy > innerStart && y * uy < innerEnd))) {
                begin = std::max(left, wholeUpWithin(inner.from + shift, right));
                stop = std::max(begin, wholeWithin(inner.to + shift + 1.0, right));
            }
            markEnds(left, begin);
            // As pixelStep() has it, but cut off as a whole number, and below by what is there.
            const double maximum = 255.0 * reach + 0.5;
            const double across = 255.0 * (y * ux + zero * uy);
            const double perColumn = 255.0 * uy;
            for (int column = begin; column < stop; ++column) {
                const int step = static_cast<int>(maximum - std::abs(across - column * perColumn));
                cover[column] =
                    static_cast<std::uint8_t>(std::max<int>(cover[column], std::min(step, 255)));
            }
            markEnds(stop, right);
        }
    }

    void ink(const QColor& colour) {
        const auto paint = static_cast<std::uint32_t>(colour.rgb());
        const auto alpha = static_cast<std::uint32_t>(colour.alpha());
        for (int row = 0; row < clip_.height(); ++row) {
            auto& touched = touched_[static_cast<std::size_t>(row)];
            if (touched.first >= touched.second) {
                continue;
            }
            std::uint8_t* cover = cover_.data() + static_cast<std::ptrdiff_t>(row) * clip_.width();
            auto* pixels = reinterpret_cast<std::uint32_t*>(picture_.scanLine(clip_.top() + row)) +
                           clip_.left();
            for (int eight = touched.first; eight < touched.second; eight += 8) {
                // Most are not on any line; of eight only those between the first and the last one.
                const auto covers = qFromLittleEndian<std::uint64_t>(cover + eight);
                const int begin = eight + std::countr_zero(covers) / 8;
                const int end = std::min(eight + 8 - std::countl_zero(covers) / 8, touched.second);
                for (int column = begin; column < end; ++column) {
                    pixels[column] = mixed(paint, pixels[column], shareOf(cover[column], alpha));
                    cover[column] = 0;
                }
            }
            touched = {clip_.width(), 0};
        }
    }

    QImage& picture_;
    QRect clip_;
    double half_ = 0.5;                 ///< of the width
    std::vector<std::uint8_t>& cover_;  ///< of each pixel of the clip, 255 is all; and eight more
    /// Of each row of the clip, the pixels touched: from, to beyond the last.
    std::vector<std::pair<int, int>> touched_;
};

bool canBrush(const QPainter& painter) {
    return paintsPixels(painter) && painter.testRenderHint(QPainter::Antialiasing) &&
           painter.opacity() == 1.0;
}

bool canBrush(const QPen& pen, double scale) {
    return pen.style() != Qt::NoPen && pen.dashOffset() == 0.0 &&
           pen.brush().style() == Qt::SolidPattern && pen.capStyle() != Qt::RoundCap &&
           pen.widthF() * scale >= 1.0;
}

/// A way of this length along a line.
QPointF along(const QPointF& from, const QPointF& to, double length) {
    const QPointF way = to - from;
    const double whole = std::hypot(way.x(), way.y());
    return whole > 0.0 ? way * (length / whole) : QPointF();
}

}  // namespace

std::optional<std::pair<double, double>> crossings(const QLineF& line, const QRectF& box) {
    double from = 0.0;
    double to = 1.0;
    const auto keep = [&](double at, double along, double low, double high) {
        if (along == 0.0) {
            if (at < low || at > high) {
                to = -1.0;
            }
            return;
        }
        const auto [enters, leaves] = std::minmax({(low - at) / along, (high - at) / along});
        from = std::max(from, enters);
        to = std::min(to, leaves);
    };
    keep(line.x1(), line.dx(), box.left(), box.right());
    keep(line.y1(), line.dy(), box.top(), box.bottom());
    return from < to ? std::optional(std::pair(from, to)) : std::nullopt;
}

void paintLine(QPainter& painter, const QPolygonF& line) {
    paintLines(painter, {{painter.pen(), {line}}});
}

void paintLines(QPainter& painter, const std::vector<LinesOfPen>& all) {
    const QTransform& transform = painter.deviceTransform();
    const double scale = transform.m11();
    const bool canBrushAll =
        canBrush(painter) && std::all_of(all.begin(), all.end(), [&](const LinesOfPen& each) {
            return canBrush(each.pen, scale);
        });
    if (!canBrushAll && all.size() > 1) {
        for (const LinesOfPen& each : all) {
            paintLines(painter, {each});
        }
        return;
    }
    if (!canBrushAll) {
        const QPen before = painter.pen();
        for (const LinesOfPen& each : all) {
            painter.setPen(each.pen);
            for (const QPolygonF& line : each.lines) {
                painter.drawPolyline(line);
            }
        }
        painter.setPen(before);
        return;
    }
    std::vector<LinesOfPen> onDevice;
    QRectF seen;
    for (const LinesOfPen& each : all) {
        LinesOfPen& mapped = onDevice.emplace_back(LinesOfPen{each.pen, {}});
        const double room = each.pen.widthF() * scale + 1.0;
        for (const QPolygonF& line : each.lines) {
            if (line.size() > 1) {
                mapped.lines.push_back(transform.map(line));
                seen |= mapped.lines.back().boundingRect().adjusted(-room, -room, room, room);
            }
        }
    }
    PaintedPixels pixels(painter, seen);
    LineBrush brush(pixels.picture(), pixels.seen().translated(-pixels.corner()));
    for (LinesOfPen& each : onDevice) {
        const double width = each.pen.widthF() * scale;
        const double squareEnd = each.pen.capStyle() == Qt::SquareCap ? 0.5 * width : 0.0;
        for (QPolygonF& line : each.lines) {
            line.translate(-pixels.corner());
            const qsizetype last = line.size() - 1;
            const QPointF atStart = along(line[0], line[1], squareEnd);
            const QPointF atEnd = along(line[last - 1], line[last], squareEnd);
            line.front() -= atStart;
            line.back() += atEnd;
        }
        QList<qreal> dashes =
            each.pen.style() == Qt::SolidLine ? QList<qreal>() : each.pen.dashPattern();
        for (qsizetype i = 0; i < dashes.size(); ++i) {
            // Square ends are those of each dash.
            const double more =
                each.pen.capStyle() == Qt::SquareCap ? (i % 2 == 0 ? 1.0 : -1.0) : 0.0;
            dashes[i] = std::max(0.0, dashes[i] + more) * width;
        }
        brush.draw(each.lines, each.pen.color(), width, dashes);
    }
}

std::vector<QPolygonF> hatchLines(const QPainterPath& area, const QRectF& seen, double apart,
                                  double fall) {
    const auto lineOf = [&](const QPointF& at) { return (at.x() - fall * at.y()) / apart; };
    const auto [first, last] = std::minmax({lineOf(seen.topLeft()), lineOf(seen.topRight()),
                                            lineOf(seen.bottomLeft()), lineOf(seen.bottomRight())});
    QMap<int, std::vector<double>> heights;  // of the points of each line on outlines
    for (const QPolygonF& outline : area.toSubpathPolygons()) {
        for (qsizetype i = 0; i < outline.size(); ++i) {
            QPointF from = outline[i];
            QPointF to = outline[(i + 1) % outline.size()];
            if (lineOf(to) < lineOf(from)) {
                std::swap(from, to);
            }
            const double end = std::min(lineOf(to), last);
            for (double n = std::ceil(std::max(lineOf(from), first)); n < end; ++n) {
                const double part = (n - lineOf(from)) / (lineOf(to) - lineOf(from));
                heights[static_cast<int>(n)].push_back(std::lerp(from.y(), to.y(), part));
            }
        }
    }
    std::vector<QPolygonF> lines;
    for (auto line = heights.begin(); line != heights.end(); ++line) {
        std::vector<double>& y = line.value();
        std::sort(y.begin(), y.end());
        for (std::size_t i = 0; i + 1 < y.size(); i += 2) {
            const double x = line.key() * apart;
            lines.push_back({{x + fall * y[i], y[i]}, {x + fall * y[i + 1], y[i + 1]}});
        }
    }
    return lines;
}

QPolygonF thinPolyline(const std::vector<QPointF>& points, double tolerance) {
    if (points.empty()) {
        return {};
    }
    QPolygonF thinned{points.front()};
    const auto thin = [&](const auto& self, std::size_t first, std::size_t last) -> void {
        const QPointF a = points[first];
        const QPointF way = points[last] - a;
        const double reach = QPointF::dotProduct(way, way);
        // A closed span has no direction: any will do.
        const QPointF d = reach > 0.0 ? way : QPointF(1.0, 0.0);
        // Squares of distances, times that of d's length: nothing is divided.
        double farthest = 0.0;
        std::size_t at = first;
        for (std::size_t i = first + 1; i < last; ++i) {
            const QPointF p = points[i] - a;
            // Beside the span the distance to its end counts: a line that comes back on itself
            // keeps its turning points.
            const double along = QPointF::dotProduct(p, d);
            const double across = d.x() * p.y() - d.y() * p.x();
            const double past = along > reach ? along - reach : std::min(along, 0.0);
            const double distance = across * across + past * past;
            if (distance > farthest) {
                farthest = distance;
                at = i;
            }
        }
        if (farthest > tolerance * tolerance * QPointF::dotProduct(d, d)) {
            self(self, first, at);
            thinned << points[at];
            self(self, at, last);
        }
    };
    // In pieces: halving the whole line would look at each point as often as that takes.
    constexpr std::size_t piece = 48;
    for (std::size_t first = 0; first + 1 < points.size(); first += piece) {
        const std::size_t last = std::min(first + piece, points.size() - 1);
        thin(thin, first, last);
        thinned << points[last];
    }
    return thinned;
}

}  // namespace ravnoves
