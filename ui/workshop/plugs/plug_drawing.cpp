#include "workshop/plugs/plug_drawing.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "pictures/model/stroke.h"
#include "text/shown_units.h"
#include "workshop/plugs/model/v8_text.h"

namespace ravnoves {

namespace {

using units::mm;

/// What is at a dimension: numbers, or letters where the sizes are not known.
struct Labels {
    QString thread;
    QString height;
    QString boreDiameter;
    QString boreDepth;
    QString cutDiameter;
    QString cutDepth;
    QString bottom;
};

class Sketch {
  public:
    Sketch(QPainter& painter, const DrawingStyle& style)
        : painter_(painter), style_(style), metrics_(style.font), em_(metrics_.height()) {}

    void draw(const QRectF& target, const PlugDrawing& drawing, const Labels& labels) {
        painter_.save();
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.setFont(style_.font);
        layout(target, drawing, labels);
        body(drawing);
        dimensions(drawing, labels);
        painter_.restore();
    }

  private:
    QPen pen(const QColor& colour, double width, Qt::PenStyle kind = Qt::SolidLine) const {
        QPen pen(colour, width, kind, Qt::FlatCap, Qt::MiterJoin);
        return pen;
    }

    double width(const QString& text) const { return metrics_.horizontalAdvance(text); }

    static bool cuts(const PlugDrawing& drawing) {
        return drawing.cutterDiameter && drawing.cutDepth > 0.0;
    }

    /// A cutter as wide as the bore shares its dimension.
    static bool cutsAnotherWidth(const PlugDrawing& drawing) {
        return cuts(drawing) && (drawing.plug.bore_depth <= 0.0 ||
                                 *drawing.cutterDiameter != drawing.plug.bore_diameter);
    }

    void layout(const QRectF& target, const PlugDrawing& drawing, const Labels& labels) {
        const v8_plugs::PlugGeometry& plug = drawing.plug;
        // Room for the dimensions around the section.
        const double left = width(labels.height) + 2.4 * em_;
        const bool hasBore = plug.bore_diameter > 0.0 && plug.bore_depth > 0.0;
        const double last = std::max(width(cuts(drawing) ? labels.cutDepth : labels.boreDepth),
                                     width(labels.bottom));
        const double right = firstLine * em_ + 0.7 * em_ + last +
                             (hasBore && cuts(drawing) ? nextLine(labels.boreDepth) : 0.0);
        const double top = ((hasBore ? 1.9 : 0.3) + (cutsAnotherWidth(drawing) ? 1.9 : 0.0)) * em_;
        const double bottom = 2.2 * em_;
        const QRectF room = target.adjusted(left, top, -right, -bottom);
        scale_ = std::max(
            1e-9, std::min(room.width() / plug.thread.diameter, room.height() / plug.height));
        const double w = plug.thread.diameter * scale_;
        const double h = plug.height * scale_;
        section_ = QRectF(room.center().x() - w / 2.0, room.center().y() - h / 2.0, w, h);
    }

    // Dimension lines right of the section.
    static constexpr double firstLine = 0.9;  ///< its distance, em
    double nextLine(const QString& label) const { return std::max(width(label), em_) + 1.1 * em_; }

    double x(double radius) const { return section_.center().x() + radius * scale_; }
    double y(double depth) const { return section_.top() + depth * scale_; }

    QRectF pocket(double diameter, double depth) const {
        return {QPointF(x(-diameter / 2.0), y(0)), QPointF(x(diameter / 2.0), y(depth))};
    }

    void body(const PlugDrawing& drawing) {
        const v8_plugs::PlugGeometry& plug = drawing.plug;
        QPainterPath metal;
        metal.addRect(section_);
        QPainterPath bore;
        if (plug.bore_diameter > 0.0 && plug.bore_depth > 0.0) {
            bore.addRect(pocket(plug.bore_diameter, plug.bore_depth));
            metal = metal.subtracted(bore);
        }
        QPainterPath removed;
        if (cuts(drawing)) {
            const double depth = std::min(drawing.cutDepth, 1.05 * plug.height);
            removed.addRect(pocket(*drawing.cutterDiameter, depth));
            removed = removed.subtracted(bore).intersected(metal);
        }
        // Hatching of the section, drawn line by line so that it is the same on every device.
        paintLines(painter_, {{pen(style_.thin, style_.lineWidth * 0.4),
                               hatchLines(metal.subtracted(removed), section_, 0.45 * em_, -1.0)}});
        if (!removed.isEmpty()) {
            QColor fill = style_.cut;
            fill.setAlphaF(0.25F);
            painter_.fillPath(removed, fill);
            painter_.setPen(pen(style_.cut, style_.lineWidth,
                                drawing.impossible ? Qt::DashLine : Qt::SolidLine));
            painter_.setBrush(Qt::NoBrush);
            painter_.drawPath(removed);
        }
        painter_.setPen(pen(style_.line, style_.lineWidth));
        painter_.setBrush(Qt::NoBrush);
        painter_.drawPath(metal);
        // The thread: its root as a thin line on both sides, as drawings have it.
        painter_.setPen(pen(style_.line, style_.lineWidth * 0.5));
        const double root = plug.thread.root_diameter() / 2.0;
        for (const double side : {-root, root}) {
            painter_.drawLine(QPointF(x(side), section_.top()),
                              QPointF(x(side), section_.bottom()));
        }
        // Axis.
        QPen axis = pen(style_.thin, style_.lineWidth * 0.5);
        axis.setDashPattern({14, 4, 3, 4});
        painter_.setPen(axis);
        painter_.drawLine(QPointF(section_.center().x(), section_.top() - 0.25 * em_),
                          QPointF(section_.center().x(), section_.bottom() + 0.25 * em_));
    }

    void arrow(const QPointF& tip, const QPointF& direction) {
        const double length = 0.5 * em_;
        const QPointF back = tip - direction * length;
        const QPointF across(-direction.y() * length * 0.22, direction.x() * length * 0.22);
        QPainterPath head;
        head.moveTo(tip);
        head.lineTo(back + across);
        head.lineTo(back - across);
        head.closeSubpath();
        painter_.fillPath(head, painter_.pen().color());
    }

    /// A dimension of a width (of a height) between two edges, extension lines from `from`, its
    /// line at `at`: below or above (left or right of) the section, text beside it.
    void dimension(Qt::Orientation way, std::pair<double, double> edges, double from, double at,
                   const QString& text, const QColor& colour) {
        const bool isWidth = way == Qt::Horizontal;
        const auto point = [&](double along, double across) {
            return isWidth ? QPointF(along, across) : QPointF(across, along);
        };
        painter_.setPen(pen(colour, style_.lineWidth * 0.5));
        const bool isBefore = at < from;
        const double beyond = isBefore ? -0.25 * em_ : 0.25 * em_;
        const auto [first, last] = edges;
        for (const double edge : {first, last}) {
            painter_.drawLine(point(edge, from), point(edge, at + beyond));
        }
        painter_.drawLine(point(first, at), point(last, at));
        if (last - first > 1.2 * em_) {
            arrow(point(first, at), point(-1, 0));
            arrow(point(last, at), point(1, 0));
        }
        const double aside = !isWidth ? 1.6 * beyond : isBefore ? -0.62 * em_ : 0.72 * em_;
        label(point((first + last) / 2.0, at + aside), text,
              isWidth    ? Qt::AlignHCenter
              : isBefore ? Qt::AlignRight
                         : Qt::AlignLeft,
              colour == style_.thin ? style_.text : colour);
    }

    void label(const QPointF& at, const QString& text, Qt::AlignmentFlag side,
               const QColor& colour) {
        const double w = width(text) + 0.2 * em_;
        double left = at.x();
        if (side == Qt::AlignHCenter) {
            left -= w / 2.0;
        } else if (side == Qt::AlignRight) {
            left -= w;
        }
        painter_.setPen(colour);
        painter_.drawText(QRectF(left, at.y() - em_ / 2.0, w, em_), Qt::AlignCenter, text);
    }

    void dimensions(const PlugDrawing& drawing, const Labels& labels) {
        const v8_plugs::PlugGeometry& plug = drawing.plug;
        dimension(Qt::Horizontal, {section_.left(), section_.right()}, section_.bottom(),
                  section_.bottom() + 0.9 * em_, labels.thread, style_.thin);
        dimension(Qt::Vertical, {section_.top(), section_.bottom()}, section_.left(),
                  section_.left() - 0.9 * em_, labels.height, style_.thin);
        double beside = section_.right() + firstLine * em_;
        double deepest = 0.0;
        const bool hasBore = plug.bore_diameter > 0.0 && plug.bore_depth > 0.0;
        // The narrower one stands nearer: no line crosses the other's number.
        const double near = section_.top() - 0.7 * em_;
        const double far = near - 1.9 * em_;
        const bool isCutInside =
            hasBore && cutsAnotherWidth(drawing) && *drawing.cutterDiameter < plug.bore_diameter;
        if (hasBore) {
            dimension(Qt::Horizontal, {x(-plug.bore_diameter / 2.0), x(plug.bore_diameter / 2.0)},
                      y(0), isCutInside ? far : near, labels.boreDiameter, style_.thin);
            deepest = plug.bore_depth;
            dimension(Qt::Vertical, {y(0), y(plug.bore_depth)}, x(plug.bore_diameter / 2.0), beside,
                      labels.boreDepth, style_.thin);
        }
        if (cuts(drawing)) {
            const double half = *drawing.cutterDiameter / 2.0;
            if (cutsAnotherWidth(drawing)) {
                dimension(Qt::Horizontal, {x(-half), x(half)}, y(0),
                          hasBore && !isCutInside ? far : near, labels.cutDiameter, style_.cut);
            }
            const double depth = std::min(drawing.cutDepth, plug.height);
            if (deepest > 0.0) {
                beside += nextLine(labels.boreDepth);
            }
            dimension(Qt::Vertical, {y(0), y(depth)}, x(half), beside, labels.cutDepth, style_.cut);
            deepest = std::max(deepest, depth);
        }
        if (deepest > 0.0 && deepest < plug.height && !labels.bottom.isEmpty()) {
            bottomThatStays(y(deepest), beside, labels.bottom);
        }
    }

    /// In a chain with the depth on its line. A bottom too thin for its number has that at the end
    /// of a leader below.
    void bottomThatStays(double top, double at, const QString& text) {
        const double end = section_.bottom();
        if (end - top > 1.2 * em_) {
            dimension(Qt::Vertical, {top, end}, section_.right(), at, text, style_.thin);
            return;
        }
        painter_.setPen(pen(style_.thin, style_.lineWidth * 0.5));
        for (const double edge : {top, end}) {
            painter_.drawLine(QPointF(section_.right(), edge), QPointF(at + 0.25 * em_, edge));
        }
        const double shoulder = end + 1.1 * em_;
        painter_.drawLine(QPointF(at, top), QPointF(at, shoulder));
        painter_.drawLine(QPointF(at, shoulder), QPointF(at + 0.4 * em_, shoulder));
        arrow(QPointF(at, end), QPointF(0, -1));
        label(QPointF(at + 0.4 * em_, shoulder), text, Qt::AlignLeft, style_.text);
    }

    QPainter& painter_;
    const DrawingStyle& style_;
    QFontMetricsF metrics_;
    double em_;
    double scale_ = 1.0;
    QRectF section_;
};

}  // namespace

std::optional<PlugDrawing> plannedPlug(const v8_plugs::Input& input,
                                       const v8_plugs::Result& solution) {
    const auto geometry = input.plug ? input.plug->geometry() : std::nullopt;
    if (!geometry || geometry_fault(*geometry)) {
        return std::nullopt;
    }
    PlugDrawing drawing;
    drawing.plug = *geometry;
    const v8_plugs::SolvedOption* chosen = solution.chosen();
    if (chosen != nullptr && chosen->reduction > 0.0) {
        const auto& boring = chosen->boring;
        if (boring && boring->cuts) {
            drawing.cutterDiameter = input.plug->cutter_diameter;
            drawing.cutDepth = boring->depth;
            drawing.impossible = boring->limit != v8_plugs::Boring::Limit::none;
            // What is drawn is what is to be done.
            if (const auto* shift = solution.shift_that_matters(); shift && shift->depth) {
                drawing.cutDepth = *shift->depth;
            }
        }
    }
    return drawing;
}

void drawPlug(QPainter& painter, const QRectF& target, const std::optional<PlugDrawing>& known,
              const DrawingStyle& style, const Words& words) {
    // Without sizes the proportions of the cup M30×1.5 of the 6 and 7 l engines, with letters.
    const PlugDrawing drawing = known.value_or(
        PlugDrawing{{{30 * mm, 1.5 * mm}, 14 * mm, 20 * mm, 7 * mm}, 16 * mm, 9.5 * mm});
    const v8_plugs::PlugGeometry& plug = drawing.plug;
    const auto shown = [&](const QString& sign, double length, const QString& letter) {
        // Millimetres go without saying on a drawing.
        return sign + (!known              ? letter
                       : shownAs(mm) == mm ? words.plain(length, mm, 2)
                                           : words.plainWithUnit(length, mm, 2));
    };
    const QString diameter = known ? QStringLiteral("⌀") : QStringLiteral("⌀ ");
    Sketch(painter, style)
        .draw(target, drawing,
              {.thread = known ? v8_text::thread(words, plug.thread)
                               : words.translate("V8", "thread", "drawing"),
               .height = shown({}, plug.height, QStringLiteral("h")),
               .boreDiameter = shown(diameter, plug.bore_diameter, QStringLiteral("b")),
               .boreDepth = shown({}, plug.bore_depth, QStringLiteral("t")),
               .cutDiameter =
                   shown(diameter, drawing.cutterDiameter.value_or(0.0), QStringLiteral("c")),
               .cutDepth = shown({}, drawing.cutDepth, QStringLiteral("t′")),
               .bottom = shown({}, plug.height - std::max(plug.bore_depth, drawing.cutDepth), {})});
}

}  // namespace ravnoves
