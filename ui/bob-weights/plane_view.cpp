#include "bob-weights/plane_view.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "bob-weights/model/bob_text.h"
#include "bob-weights/model/bob_weights_model.h"
#include "model/reference_case.h"
#include "pictures/figure.h"
#include "text/csv_format.h"
#include "widgets/panel.h"

namespace ravnoves {

using namespace bob_weights;

namespace {

/// A point at an angle of the machine: 0 above, clockwise.
QPointF onCircle(double angle, double radius) {
    return {radius * std::sin(angle), -radius * std::cos(angle)};
}

/// Null: there is none yet.
const PlaneResult* resultOf(const BobWeightsModel& model, std::size_t plane) {
    const auto& correction = model.solution().correction;
    return correction ? &(*correction)[plane] : nullptr;
}

std::optional<double> limitOf(const BobWeightsModel& model, std::size_t plane) {
    const auto& permissible = model.solution().permissible;
    return permissible ? std::optional((*permissible)[plane]) : std::nullopt;
}

}  // namespace

PlaneView::PlaneView(BobWeightsModel* model, std::size_t plane, QWidget* parent)
    : ComparedFigure(parent), model_(model), plane_(plane) {
    setObjectName(QStringLiteral("plane_%1").arg(plane + 1));
    setAccessibleName(bob_text::planeName(Words(), plane));
    makeFigure(this, [this](const CsvFormat& format) { return table(format); });
    const auto repaint = [this] {
        setAccessibleDescription(caption());
        update();
    };
    connect(model_, &SceneModel::changed, this, repaint);
    connect(&Theme::instance(), &Theme::changed, this, repaint);
    followReference(model_);
    setToolTip(
        tr("The arrow is the reading, the dashed circle the limit, the dot what remains; holes "
           "in the rim, slugs opposite, paler what is drilled already. 0° is above, angles grow "
           "clockwise."));
    repaint();
}

double PlaneView::longest() const {
    double most = 1e-12;
    for (const BobWeightsModel* model :
         {static_cast<const BobWeightsModel*>(model_), referenceOf(model_)}) {
        if (model != nullptr) {
            const PlaneResult* result = resultOf(*model, plane_);
            most = std::max({most, limitOf(*model, plane_).value_or(0.0),
                             result != nullptr ? result->unbalance : 0.0});
        }
    }
    return most;
}

QString PlaneView::table(const CsvFormat& format) const {
    const Words words;
    const Result& solution = model_->solution();
    if (resultOf(*model_, plane_) == nullptr) {
        return {};
    }
    QString text =
        format.line(bob_text::planeHead(words)) +
        format.line(bob_text::planes(words, solution).at(static_cast<int>(plane_)).texts());
    const auto holes = bob_text::holes(words, solution, plane_);
    text += holes.isEmpty() ? QString() : format.line(bob_text::holeHead(words));
    for (const ResultRow& hole : holes) {
        text += format.line(hole.texts());
    }
    const auto drilled = bob_text::drilled(words, solution, plane_);
    text += drilled.isEmpty() ? QString() : format.line(bob_text::drilledHead(words));
    for (const ResultRow& hole : drilled) {
        text += format.line(hole.texts());
    }
    return text;
}

QString PlaneView::caption() const {
    const auto& correction = model_->solution().correction;
    if (!correction) {
        return tr("no correction yet");
    }
    const Words words;
    return tr("%1 at %2")
        .arg(words.number((*correction)[plane_].unbalance, units::gram_mm, 0),
             words.number((*correction)[plane_].angle, units::degree, 1));
}

void PlaneView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const Theme& theme = Theme::instance();
    const QRect title = paintPanel(painter, rect(), bob_text::planeName(Words(), plane_));
    sayReference(painter, title);
    const QFont small = Theme::font(Theme::smallSize);
    painter.setFont(small);
    const QFontMetrics smallMetrics(small);

    const auto& correction = model_->solution().correction;
    painter.setPen(theme.mutedText());
    painter.drawText(QRect(Theme::margin, height() - Theme::space - smallMetrics.height(),
                           width() - 2 * Theme::margin, smallMetrics.height()),
                     Qt::AlignHCenter | Qt::AlignVCenter, caption());

    const double top = title.bottom() + smallMetrics.height() + Theme::gap;
    const double bottom = height() - Theme::space - 2.0 * smallMetrics.height() - Theme::gap;
    const double side =
        width() - 2.0 * (Theme::margin + smallMetrics.horizontalAdvance(QStringLiteral("270°")));
    const double rim = 0.5 * std::min(bottom - top, side);
    if (rim < 10.0) {
        return;
    }
    painter.translate(0.5 * width(), 0.5 * (top + bottom));
    for (int quarter = 0; quarter < 4; ++quarter) {
        const double angle = quarter * 0.5 * pi;
        const QString text = QStringLiteral("%1°").arg(90 * quarter);
        const QPointF at = onCircle(angle, rim);
        const double w = smallMetrics.horizontalAdvance(text);
        const double h = smallMetrics.height();
        const QPointF corner = quarter == 0   ? QPointF(-0.5 * w, -rim - h)
                               : quarter == 1 ? QPointF(rim + 3.0, -0.5 * h)
                               : quarter == 2 ? QPointF(-0.5 * w, rim)
                                              : QPointF(-rim - w - 3.0, -0.5 * h);
        painter.setPen(QPen(theme.grid(), 1.0));
        painter.drawLine(QPointF(0, 0), at);
        painter.setPen(theme.mutedText());
        painter.drawText(QRectF(corner, QSizeF(w + 1, h)), Qt::AlignCenter, text);
    }
    painter.setPen(QPen(theme.text(), 1.4));
    painter.drawEllipse(QPointF(0, 0), rim, rim);
    constexpr float pale = 0.4F;
    for (const RunResult& run : model_->solution().runs) {
        drawHoles(painter, rim, run.drilled[plane_], pale);
    }
    if (!correction) {
        return;
    }
    if (model_->solution().holds()) {
        drawSector(painter, rim);
        const PlaneResult& result = (*correction)[plane_];
        drawHoles(painter, rim, {result.holes, result.slugs}, 1.0F);
    }
    drawVectors(painter, rim);
}

void PlaneView::drawSector(QPainter& painter, double rim) const {
    const Plane& plane = model_->input().correction->planes.at(plane_);
    if (plane.from_angle && plane.to_angle) {
        const double span = turn_of(*plane.to_angle - *plane.from_angle);
        painter.setPen(QPen(Theme::instance().mutedText(), 4.0, Qt::SolidLine, Qt::FlatCap));
        // Qt counts from the right, anticlockwise, in sixteenths of a degree.
        painter.drawArc(QRectF(-rim - 3.0, -rim - 3.0, 2.0 * rim + 6.0, 2.0 * rim + 6.0),
                        static_cast<int>(16.0 * (90.0 - *plane.from_angle / degree)),
                        static_cast<int>(-16.0 * span / degree));
    }
}

void PlaneView::drawHoles(QPainter& painter, double rim, const Metal& metal, float alpha) const {
    const Correction& input = *model_->input().correction;
    const std::optional<double> radius = input.planes.at(plane_).radius;
    if (!radius) {
        return;
    }
    const double scale = rim / *radius;
    const auto draw = [&](const Hole& hole, bool isSlug, QColor colour) {
        const double cone = Cut{*radius, 1.0, input.drill.point_angle}.cone(hole.diameter);
        const double half = 0.5 * hole.diameter * scale;
        const double depth = hole.depth * scale;
        QPainterPath path(QPointF(-half, -rim));
        path.lineTo(half, -rim);
        path.lineTo(half, -rim + depth);
        path.lineTo(0.0, -rim + depth + cone * scale);
        path.lineTo(-half, -rim + depth);
        path.closeSubpath();
        QPainterPath slug;  // the cone beneath it stays empty
        slug.addRect(-half, -rim, 2.0 * half, depth);
        painter.save();
        painter.rotate(hole.angle / degree);
        colour.setAlphaF(alpha);
        QColor inside = colour;
        constexpr float fill = 70.0F / 255.0F;
        inside.setAlphaF(fill * alpha);
        painter.fillPath(isSlug ? slug : path, inside);
        painter.setPen(QPen(colour, 1.2));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(path);
        painter.restore();
    };
    const Theme& theme = Theme::instance();
    for (const Hole& hole : metal.holes) {
        draw(hole, false, theme.warning());
    }
    for (const Hole& slug : metal.slugs) {
        draw(slug, true, theme.curve(4));
    }
}

void PlaneView::drawVectors(QPainter& painter, double rim) const {
    const Theme& theme = Theme::instance();
    const PlaneResult& result = (*model_->solution().correction)[plane_];
    const double scale = 0.86 * rim / longest();
    painter.setBrush(Qt::NoBrush);
    const BobWeightsModel* other = referenceOf(model_);
    if (const PlaneResult* before = other != nullptr ? resultOf(*other, plane_) : nullptr) {
        painter.setPen(ghostPen(theme.accent()));
        painter.drawLine(QPointF(0, 0), onCircle(before->angle, before->unbalance * scale));
        painter.setPen(ghostPen(theme.good(), 4.0));
        const double was = limitOf(*other, plane_).value_or(0.0) * scale;
        painter.drawEllipse(QPointF(0, 0), was, was);
    }
    if (const auto limit = limitOf(*model_, plane_)) {
        painter.setPen(QPen(theme.good(), 1.6, Qt::DashLine));
        painter.drawEllipse(QPointF(0, 0), *limit * scale, *limit * scale);
    }
    const QPointF tip = onCircle(result.angle, result.unbalance * scale);
    painter.setPen(QPen(theme.accent(), 2.2));
    painter.drawLine(QPointF(0, 0), tip);
    painter.save();
    painter.translate(tip);
    painter.rotate(result.angle / degree);
    painter.setBrush(theme.accent());
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(QPolygonF({{0.0, -2.0}, {4.5, 8.0}, {-4.5, 8.0}}));
    painter.restore();
    if (!model_->solution().holds()) {
        return;  // what remains is not known
    }
    painter.setPen(QPen(theme.panel(), 1.0));
    painter.setBrush(result.within_tolerance == false ? theme.error() : theme.good());
    painter.drawEllipse(onCircle(result.remaining_angle, result.remaining * scale), 4.0, 4.0);
}

}  // namespace ravnoves
