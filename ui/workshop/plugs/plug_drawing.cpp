#include "workshop/plugs/plug_drawing.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <vector>

#include "pictures/figure.h"
#include "pictures/model/stroke.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/panel.h"
#include "workshop/model/workshop_model.h"
#include "workshop/plugs/model/v8_text.h"

namespace ravnoves {

namespace {

using units::mm;

/// A dimension between two edges.
struct Dimension {
    double first;  ///< from the axis or the face, m
    double last;
    QString text;
    bool isCut = false;
};

class Sketch {
  public:
    Sketch(QPainter& painter, const PlugDrawing& drawing, const DrawingStyle& style,
           const Words& words)
        : painter_(painter),
          drawing_(drawing),
          plug_(drawing.plug),
          style_(style),
          metrics_(style.font),
          em_(metrics_.height()),
          thread_(v8_text::thread(words, plug_.thread)) {
        const auto length = [&](double value) {
            // Millimetres go without saying on a drawing.
            return shownAs(mm) == mm ? words.plain(value, mm, 2)
                                     : words.plainWithUnit(value, mm, 2);
        };
        const auto add = [&](double diameter, double depth, bool isCut) {
            // A cutter as wide as the bore shares its dimension.
            if (widths_.empty() || widths_.front().last != diameter / 2.0) {
                widths_.push_back({-diameter / 2.0, diameter / 2.0,
                                   QStringLiteral("⌀") + length(diameter), isCut});
            }
            depths_.push_back({0.0, depth, length(depth), isCut});
        };
        if (plug_.bore_diameter > 0.0 && plug_.bore_depth > 0.0) {
            bore_ = QSizeF(plug_.bore_diameter, plug_.bore_depth);
            add(plug_.bore_diameter, plug_.bore_depth, false);
        }
        if (drawing.cutterDiameter && drawing.cutDepth > 0.0) {
            cut_ = QSizeF(*drawing.cutterDiameter, std::min(drawing.cutDepth, plug_.height));
            add(*drawing.cutterDiameter, drawing.cutDepth, true);
        }
        // The narrower one is nearer: no line crosses the other's number.
        std::ranges::stable_sort(widths_, {}, &Dimension::last);
        height_ = length(plug_.height);
        const double deepest = std::max(bore_.height(), cut_.height());
        if (deepest > 0.0 && deepest < plug_.height) {
            bottom_ = {deepest, plug_.height, length(plug_.height - deepest)};
        }
    }

    void draw(const QRectF& target) {
        painter_.save();
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.setFont(style_.font);
        place(target);
        drawBody();
        drawDimensions();
        painter_.restore();
    }

  private:
    double width(const QString& text) const { return metrics_.horizontalAdvance(text); }

    /// With room for the dimensions around the section.
    void place(const QRectF& target) {
        const double left = width(height_) + 2.4 * em_;
        double right = 1.6 * em_;
        if (!depths_.empty()) {
            right += std::max(width(depths_.back().text), width(bottom_.text)) +
                     (depths_.size() > 1 ? nextLine(depths_.front()) : 0.0);
        }
        const double top = (0.3 + rowAbove * static_cast<double>(widths_.size())) * em_;
        const QRectF room = target.adjusted(left, top, -right, -2.2 * em_);
        scale_ = std::max(
            1e-9, std::min(room.width() / plug_.thread.diameter, room.height() / plug_.height));
        section_ = QRectF(QPointF(), QSizeF(plug_.thread.diameter * scale_, plug_.height * scale_));
        section_.moveCenter(room.center());
    }

    static constexpr double rowAbove = 1.9;  ///< of a dimension above the section, em
    /// From a dimension line right of the section to the next.
    double nextLine(const Dimension& depth) const {
        return std::max(width(depth.text), em_) + 1.1 * em_;
    }
    double x(double radius) const { return section_.center().x() + radius * scale_; }
    double y(double depth) const { return section_.top() + depth * scale_; }

    QPainterPath pocket(const QSizeF& size) const {
        QPainterPath path;
        if (!size.isEmpty()) {
            path.addRect({QPointF(x(-size.width() / 2.0), y(0)),
                          QPointF(x(size.width() / 2.0), y(size.height()))});
        }
        return path;
    }

    QPen pen(const QColor& colour, double width, Qt::PenStyle kind = Qt::SolidLine) const {
        return {colour, width * style_.lineWidth, kind, Qt::FlatCap, Qt::MiterJoin};
    }

    void drawBody() {
        QPainterPath metal;
        metal.addRect(section_);
        metal -= pocket(bore_);
        const QPainterPath removed = pocket(cut_) & metal;
        // Hatching of the section, drawn line by line so that it is the same on every device.
        paintLines(painter_, {{pen(style_.thin, 0.4),
                               hatchLines(metal - removed, section_, 0.45 * em_, -1.0)}});
        if (!removed.isEmpty()) {
            QColor fill = style_.cut;
            fill.setAlphaF(0.25F);
            painter_.fillPath(removed, fill);
            painter_.strokePath(
                removed, pen(style_.cut, 1.0, drawing_.impossible ? Qt::DashLine : Qt::SolidLine));
        }
        painter_.strokePath(metal, pen(style_.line, 1.0));
        // The thread: its root as a thin line on both sides, as drawings have it.
        painter_.setPen(pen(style_.line, 0.5));
        const double root = plug_.thread.root_diameter() / 2.0;
        for (const double side : {-root, root}) {
            painter_.drawLine(QPointF(x(side), section_.top()),
                              QPointF(x(side), section_.bottom()));
        }
        QPen axis = pen(style_.thin, 0.5);
        axis.setDashPattern({14, 4, 3, 4});
        painter_.setPen(axis);
        painter_.drawLine(QPointF(x(0.0), section_.top() - 0.25 * em_),
                          QPointF(x(0.0), section_.bottom() + 0.25 * em_));
    }

    void drawDimensions() {
        const double radius = plug_.thread.diameter / 2.0;
        draw(Qt::Horizontal, {-radius, radius, thread_}, section_.bottom(),
             section_.bottom() + 0.9 * em_);
        draw(Qt::Vertical, {0.0, plug_.height, height_}, section_.left(),
             section_.left() - 0.9 * em_);
        double above = section_.top() - 0.7 * em_;
        for (const Dimension& each : widths_) {
            draw(Qt::Horizontal, each, section_.top(), above);
            above -= rowAbove * em_;
        }
        double beside = section_.right() + 0.9 * em_;
        for (const Dimension& each : depths_) {
            beside += &each == &depths_.front() ? 0.0 : nextLine(depths_.front());
            draw(Qt::Vertical, each, x((each.isCut ? cut_ : bore_).width() / 2.0), beside);
        }
        if (!bottom_.text.isEmpty()) {  // in a chain with the depth on its line
            draw(Qt::Vertical, bottom_, section_.right(), beside);
        }
    }

    /// Extension lines from `from`, its line at `at`: below or above (left or right of) the
    /// section, text beside it.
    void draw(Qt::Orientation way, const Dimension& shown, double from, double at) {
        const bool isWidth = way == Qt::Horizontal;
        const auto point = [&](double along, double across) {
            return isWidth ? QPointF(along, across) : QPointF(across, along);
        };
        const QColor& colour = shown.isCut ? style_.cut : style_.thin;
        painter_.setPen(pen(colour, 0.5));
        const bool isBefore = at < from;
        const double beyond = isBefore ? -0.25 * em_ : 0.25 * em_;
        const double first = isWidth ? x(shown.first) : y(shown.first);
        const double last = isWidth ? x(shown.last) : y(shown.last);
        painter_.drawLine(point(first, at), point(last, at));
        for (const double edge : {first, last}) {
            painter_.drawLine(point(edge, from), point(edge, at + beyond));
            if (last - first > 1.2 * em_) {  // an arrow
                const double back = edge + (edge == first ? 0.5 : -0.5) * em_;
                QPainterPath head(point(edge, at));
                head.lineTo(point(back, at + 0.11 * em_));
                head.lineTo(point(back, at - 0.11 * em_));
                painter_.fillPath(head, colour);
            }
        }
        const double aside = !isWidth ? 1.6 * beyond : isBefore ? -0.62 * em_ : 0.72 * em_;
        const double w = width(shown.text) + 0.2 * em_;
        QRectF room(QPointF(), QSizeF(w, em_));
        room.moveCenter(point((first + last) / 2.0, at + aside));
        if (!isWidth) {
            room.translate(isBefore ? -0.5 * w : 0.5 * w, 0.0);
        }
        painter_.setPen(shown.isCut ? style_.cut : style_.text);
        painter_.drawText(room, Qt::AlignCenter, shown.text);
    }

    QPainter& painter_;
    const PlugDrawing& drawing_;
    const v8_plugs::PlugGeometry& plug_;
    const DrawingStyle& style_;
    QFontMetricsF metrics_;
    double em_;
    QString thread_;
    QString height_;
    QSizeF bore_{0.0, 0.0};  ///< diameter and depth, m
    QSizeF cut_{0.0, 0.0};
    std::vector<Dimension> widths_;  ///< above the section
    std::vector<Dimension> depths_;  ///< right of it
    Dimension bottom_{};             ///< what stays of the height
    double scale_ = 1.0;
    QRectF section_;
};

/// The plug in section with its dimensions and the metal to bore out.
class PlugView final : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::PlugView)

  public:
    PlugView(WorkshopModel* model, QWidget* parent) : QWidget(parent), model_(model) {
        setAccessibleName(tr("Plug in section"));
        makeFigure(this);
        setToolTip(tr(
            "Section of the plug of sheet 4, to scale; sizes without a unit are in millimetres."));
        const auto show = [this] {
            setVisible(plannedPlug(*model_).has_value());
            update();
        };
        connect(model_, &SceneModel::changed, this, show);
        connect(&Theme::instance(), &Theme::changed, this, show);
        show();
    }

    QSize sizeHint() const override { return {300, minimumSizeHint().height()}; }
    QSize minimumSizeHint() const override { return {Theme::withText(200), Theme::withText(160)}; }

  protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        const Theme& theme = Theme::instance();
        const QRect title = paintPanel(painter, rect(), tr("Plug"));
        if (const auto drawing = plannedPlug(*model_)) {
            drawPlug(painter,
                     QRectF(Theme::margin, title.bottom() + Theme::gap, width() - 2 * Theme::margin,
                            height() - title.bottom() - 2 * Theme::gap),
                     *drawing,
                     {theme.text(), theme.mutedText(), theme.text(), theme.warning(), Theme::font(),
                      1.6},
                     Words());
        }
    }

  private:
    WorkshopModel* model_;
};

}  // namespace

std::optional<PlugDrawing> plannedPlug(const WorkshopModel& model) {
    const auto& sheet = model.plugs() != nullptr ? model.plugsInput()->plug : std::nullopt;
    const auto geometry = sheet ? sheet->geometry() : std::nullopt;
    if (!geometry || geometry_fault(*geometry)) {
        return std::nullopt;
    }
    PlugDrawing drawing;
    drawing.plug = *geometry;
    const v8_plugs::Result& solution = *model.plugs();
    const v8_plugs::SolvedOption* chosen = solution.chosen();
    if (chosen != nullptr && chosen->reduction > 0.0) {
        const auto& boring = chosen->boring;
        if (boring && boring->cuts) {
            drawing.cutterDiameter = sheet->cutter_diameter;
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

void drawPlug(QPainter& painter, const QRectF& target, const PlugDrawing& drawing,
              const DrawingStyle& style, const Words& words) {
    Sketch(painter, drawing, style, words).draw(target);
}

QWidget* plugView(WorkshopModel* model, QWidget* parent) {
    return new PlugView(model, parent);
}

}  // namespace ravnoves
