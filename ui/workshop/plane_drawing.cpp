#include "workshop/plane_drawing.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "pictures/figure.h"
#include "theme/theme.h"
#include "widgets/panel.h"
#include "workshop/model/workshop_model.h"

namespace ravnoves {

using namespace bob_weights;

namespace {

const PlaneResult* resultOf(const Result& solution, std::size_t plane) {
    return solution.correction ? &(*solution.correction)[plane] : nullptr;
}

double limitOf(const Result& solution, std::size_t plane) {
    return solution.permissible ? (*solution.permissible)[plane] : 0.0;
}

class PlaneDrawing {
  public:
    PlaneDrawing(QPainter& painter, double rim, const PlaneShown& shown, const PlaneStyle& style)
        : painter_(painter),
          rim_(rim),
          shown_(shown),
          style_(style),
          sign_(shown.input.machine.counts == workshop::Machine::Counts::clockwise ? 1.0 : -1.0) {}

    void draw() {
        drawDial();
        constexpr float pale = 0.4F;
        for (const RunResult& run : shown_.solution.runs) {
            drawHoles(run.drilled[shown_.plane], pale);
        }
        const PlaneResult* result = resultOf(shown_.solution, shown_.plane);
        if (result == nullptr) {
            return;
        }
        if (shown_.solution.holds()) {
            drawSector();
            drawHoles({result->holes, result->slugs}, 1.0F);
        }
        drawVectors(*result);
    }

  private:
    QPointF onCircle(double angle, double radius) const {
        return {sign_ * radius * std::sin(angle), -radius * std::cos(angle)};
    }

    void drawDial() {
        const QFontMetricsF metrics(style_.font, painter_.device());
        for (int quarter = 0; quarter < 4; ++quarter) {
            const double angle = quarter * 0.5 * pi;
            const QString text = QStringLiteral("%1°").arg(90 * quarter);
            const QPointF at = onCircle(angle, rim_);
            const double w = metrics.horizontalAdvance(text) + 1.0;
            const double h = metrics.height();
            const double gap = 0.2 * h + 3.0 * style_.lineWidth;
            const QPointF corner = quarter == 0   ? QPointF(-0.5 * w, -rim_ - gap - h)
                                   : quarter == 2 ? QPointF(-0.5 * w, rim_ + gap)
                                   : at.x() > 0.0 ? QPointF(rim_ + gap, -0.5 * h)
                                                  : QPointF(-rim_ - w - gap, -0.5 * h);
            painter_.setPen(QPen(style_.thin, 0.7 * style_.lineWidth));
            painter_.drawLine(QPointF(0, 0), at);
            painter_.setPen(style_.text);
            painter_.drawText(QRectF(corner, QSizeF(w, h)), Qt::AlignCenter, text);
        }
        painter_.setPen(QPen(style_.line, style_.lineWidth));
        painter_.setBrush(Qt::NoBrush);
        painter_.drawEllipse(QPointF(0, 0), rim_, rim_);
    }

    void drawSector() {
        const Plane& plane = shown_.input.correction->planes.at(shown_.plane);
        if (!plane.from_angle || !plane.to_angle) {
            return;
        }
        const double span = turn_of(*plane.to_angle - *plane.from_angle);
        const double out = rim_ + 2.0 * style_.lineWidth;
        painter_.setPen(QPen(style_.text, 3.0 * style_.lineWidth, Qt::SolidLine, Qt::FlatCap));
        // Qt counts from the right, anticlockwise, in sixteenths of a degree.
        painter_.drawArc(QRectF(-out, -out, 2.0 * out, 2.0 * out),
                         static_cast<int>(16.0 * (90.0 - sign_ * *plane.from_angle / degree)),
                         static_cast<int>(-16.0 * sign_ * span / degree));
    }

    void drawHoles(const Metal& metal, float alpha) {
        const auto& correction = shown_.input.correction;
        const std::optional<double> radius = correction && shown_.plane < correction->planes.size()
                                                 ? correction->planes[shown_.plane].radius
                                                 : std::nullopt;
        if (!radius) {
            return;
        }
        const double scale = rim_ / *radius;
        const auto draw = [&](const Hole& hole, bool isSlug, QColor colour) {
            QColor inside = colour;
            constexpr float fill = 70.0F / 255.0F;
            colour.setAlphaF(alpha);
            inside.setAlphaF(fill * alpha);
            painter_.save();
            painter_.rotate(sign_ * hole.angle / degree);
            painter_.setPen(QPen(colour, 0.85 * style_.lineWidth));
            const double half = 0.5 * hole.diameter * scale;
            if (hole.is_axial) {
                painter_.setBrush(inside);
                painter_.drawEllipse(QPointF(0.0, -hole.slug_radius * scale), half, half);
                painter_.restore();
                return;
            }
            const double cone =
                Cut{*radius, 1.0, correction->drill.point_angle}.cone(hole.diameter) * scale;
            const double depth = hole.depth * scale;
            const double from = hole.deepens ? hole.from_depth * scale : 0.0;
            QPainterPath path(QPointF(-half, -rim_ + from));
            path.lineTo(half, -rim_ + from);
            path.lineTo(half, -rim_ + depth);
            path.lineTo(0.0, -rim_ + depth + cone);
            path.lineTo(-half, -rim_ + depth);
            path.closeSubpath();
            QPainterPath slug;  // the cone beneath it stays empty
            slug.addRect(-half, -rim_, 2.0 * half, depth);
            painter_.fillPath(isSlug ? slug : path, inside);
            painter_.setBrush(Qt::NoBrush);
            painter_.drawPath(path);
            painter_.restore();
        };
        for (const Hole& hole : metal.holes) {
            draw(hole, false, style_.hole);
        }
        for (const Hole& slug : metal.slugs) {
            draw(slug, true, style_.slug);
        }
    }

    void drawVectors(const PlaneResult& result) {
        const double limit = limitOf(shown_.solution, shown_.plane);
        const double longest = std::max({1e-12, limit, result.unbalance});
        const double scale = 0.86 * rim_ / longest;
        painter_.setBrush(Qt::NoBrush);
        if (limit > 0.0) {
            painter_.setPen(QPen(style_.limit, 1.15 * style_.lineWidth, Qt::DashLine));
            painter_.drawEllipse(QPointF(0, 0), limit * scale, limit * scale);
        }
        const QPointF tip = onCircle(result.angle, result.unbalance * scale);
        const double thick = 1.6 * style_.lineWidth;
        painter_.setPen(QPen(style_.reading, thick));
        painter_.drawLine(QPointF(0, 0), tip);
        painter_.save();
        painter_.translate(tip);
        painter_.rotate(sign_ * result.angle / degree);
        painter_.setBrush(style_.reading);
        painter_.setPen(Qt::NoPen);
        painter_.drawPolygon(QPolygonF(
            {{0.0, -0.9 * thick}, {2.0 * thick, 3.6 * thick}, {-2.0 * thick, 3.6 * thick}}));
        painter_.restore();
        if (shown_.solution.holds()) {  // else what remains is not known
            painter_.setPen(Qt::NoPen);
            painter_.setBrush(result.within_tolerance == false ? style_.exceeds : style_.fits);
            painter_.drawEllipse(onCircle(result.remaining_angle, result.remaining * scale),
                                 1.8 * thick, 1.8 * thick);
        }
    }

    QPainter& painter_;
    double rim_;
    const PlaneShown& shown_;
    const PlaneStyle& style_;
    double sign_;  ///< of clockwise
};

/// A plane as the machine sees it.
class PlaneView final : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::PlaneView)

  public:
    PlaneView(WorkshopModel* model, std::size_t plane, QWidget* parent)
        : QWidget(parent), model_(model), plane_(plane) {
        makeFigure(this);
        setObjectName(QStringLiteral("plane_%1").arg(plane + 1));
        const auto repaint = [this] {
            setAccessibleName(model_->planeName(plane_));
            setAccessibleDescription(caption());
            update();
        };
        for (const auto signal : {&SceneModel::changed, &SceneModel::shownChanged}) {
            connect(model_, signal, this, repaint);
        }
        connect(&Theme::instance(), &Theme::changed, this, repaint);
        setToolTip(
            tr("Arrow: reading; dashed circle: limit; dot: residual; rim: holes and slugs, "
               "existing holes dimmed. Front view, angles as on the machine."));
        repaint();
    }

    QSize sizeHint() const override { return {Theme::withText(240), Theme::withText(250)}; }
    QSize minimumSizeHint() const override { return {Theme::withText(170), Theme::withText(190)}; }

  protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        const Theme& theme = Theme::instance();
        const QRect title = paintPanel(painter, rect(), model_->planeName(plane_));
        const QFont small = Theme::font(Theme::smallSize);
        painter.setFont(small);
        painter.setPen(theme.mutedText());
        const QRect foot(Theme::margin, 0, width() - 2 * Theme::margin, height() - Theme::space);
        QRect said;
        painter.drawText(foot, Qt::AlignHCenter | Qt::AlignBottom, caption(), &said);
        const WorkshopModel& shown = model_->shown();
        const QRectF target(QPointF(foot.left(), title.bottom() + Theme::gap),
                            QPointF(foot.right() + 1, said.top()));
        drawPlane(painter, target, {shown.input(), shown.solution(), plane_},
                  {.line = theme.text(),
                   .thin = theme.grid(),
                   .text = theme.mutedText(),
                   .hole = theme.warning(),
                   .slug = theme.colour(Role::CrankWeight),
                   .reading = theme.accent(),
                   .limit = theme.good(),
                   .fits = theme.good(),
                   .exceeds = theme.error(),
                   .font = small,
                   .lineWidth = 1.4});
    }

  private:
    /// "2885 g·mm at 73.1°"
    QString caption() const {
        const auto& correction = model_->shown().solution().correction;
        if (!correction) {
            return tr("no correction yet");
        }
        const Words words;
        return tr("%1 at %2")
            .arg(words.number((*correction)[plane_].unbalance, units::gram_mm, 0),
                 words.number((*correction)[plane_].angle, units::degree, 1));
    }

    WorkshopModel* model_;
    std::size_t plane_;
};

}  // namespace

void drawPlane(QPainter& painter, const QRectF& target, const PlaneShown& shown,
               const PlaneStyle& style) {
    painter.save();
    painter.setFont(style.font);
    const QFontMetricsF metrics(style.font, painter.device());
    const double beside = 2.0 * (0.4 * metrics.height() + 3.0 * style.lineWidth);
    const double side =
        target.width() - 2.0 * metrics.horizontalAdvance(QStringLiteral("270°")) - beside;
    const double rim = 0.5 * std::min(target.height() - 2.0 * metrics.height() - beside, side);
    if (rim > metrics.height()) {
        painter.translate(target.center());
        PlaneDrawing(painter, rim, shown, style).draw();
    }
    painter.restore();
}

QWidget* planeView(WorkshopModel* model, std::size_t plane, QWidget* parent) {
    return new PlaneView(model, plane, parent);
}

}  // namespace ravnoves
