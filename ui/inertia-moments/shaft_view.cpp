#include "inertia-moments/shaft_view.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "inertia-moments/model/inertia_moments_model.h"
#include "pictures/figure.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

using inertia_moments::Balances;
using inertia_moments::Direction;
using inertia_moments::ShaftDesign;

namespace {

QString short4(double si, const Unit& unit) {
    return shownShort(si, unit, 4);
}

}  // namespace

ShaftView::ShaftView(InertiaMomentsModel* model, QWidget* parent) : QWidget(parent), model_(model) {
    setAccessibleName(tr("Balance shafts: arrangement and phases"));
    makeFigure(this);
    setToolTip(
        tr("Shafts from the front at the present crank angle; red: cancelled part; dashed: axis "
           "and crankpin of cylinder 1."));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(model_, &SceneModel::changed, this, qOverload<>(&QWidget::update));
    connect(model_->crank(), &CrankAngle::changed, this, qOverload<>(&QWidget::update));
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

int ShaftView::columns() const {
    const int count = static_cast<int>(model_->result().shafts.size());
    int best = 1;
    double size = 0.0;
    for (int columns = 1; columns <= std::max(count, 1); ++columns) {
        const int rows = (count + columns - 1) / columns;
        const double each = std::min(static_cast<double>(width()) / columns,
                                     (static_cast<double>(height()) / std::max(rows, 1)) - 34.0);
        if (each > size) {
            size = each;
            best = columns;
        }
    }
    return best;
}

QRectF ShaftView::cell(int index) const {
    const int count = std::max(1, static_cast<int>(model_->result().shafts.size()));
    const int across = columns();
    const int rows = (count + across - 1) / across;
    const double w = static_cast<double>(width()) / across;
    const double h = static_cast<double>(height()) / rows;
    const int row = index / across;
    return QRectF((index % across) * w, row * h, w, h).adjusted(3, 3, -3, -3);
}

void ShaftView::paintEvent(QPaintEvent* /*event*/) {
    const Theme& theme = Theme::instance();
    QPainter painter(this);
    painter.fillRect(rect(), theme.panel());
    painter.setRenderHint(QPainter::Antialiasing);
    const int count = static_cast<int>(model_->result().shafts.size());
    if (count == 0) {
        painter.setPen(theme.mutedText());
        painter.setFont(Theme::font());
        painter.drawText(QRectF(rect()).adjusted(20, 0, -20, 0), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("No balance shafts. Press “Add shaft” under Balancing."));
        return;
    }
    for (int i = 0; i < count; ++i) {
        paintShaft(painter, i, cell(i));
    }
}

void ShaftView::paintShaft(QPainter& painter, int index, const QRectF& area) const {
    const Theme& theme = Theme::instance();
    const auto& result = model_->result();
    const ShaftDesign& design = result.shafts[static_cast<std::size_t>(index)];
    const bool on = design.shaft.enabled;
    const bool moment = design.shaft.balances == Balances::moment;
    const double phi = model_->crank()->degrees() * degree;
    const double sign = design.shaft.direction == Direction::forward ? 1.0 : -1.0;
    const double turned = sign * design.shaft.order * phi;

    painter.setPen(QPen(theme.border(), 1.0));
    QColor back = theme.good();
    back.setAlphaF(on ? 0.08F : 0.0F);
    painter.setBrush(back);
    painter.drawRoundedRect(area, 4, 4);

    painter.setFont(Theme::font(Theme::smallSize, true));
    painter.setPen(on ? theme.good() : theme.mutedText());
    const QString state = on ? tr("on") : tr("off");
    const QFontMetricsF small(Theme::font(Theme::smallSize));
    const double room = area.width() - 12.0;
    const auto fitted = [&](const QString& words, double width) {
        return painter.fontMetrics().elidedText(words, Qt::ElideRight, static_cast<int>(width));
    };
    painter.drawText(area.adjusted(6, 3, -6, 0), Qt::AlignTop | Qt::AlignLeft,
                     fitted((on ? QStringLiteral("\u25CF ") : QStringLiteral("\u25CB ")) +
                                model_->shaftTitle(design.shaft),
                            room - small.horizontalAdvance(state) - 4.0));
    painter.setFont(Theme::font(Theme::smallSize));
    painter.setPen(theme.mutedText());
    painter.drawText(area.adjusted(6, 3, -6, 0), Qt::AlignTop | Qt::AlignRight, state);

    const Unit& unit = moment ? units::N_m : units::newton;
    QStringList lines;
    if (design.phase) {  // without one there is nothing to cancel but rounding
        lines << tr("mρ %1").arg(short4(design.unbalance, units::gram_mm));
        if (design.mass) {
            lines << tr("m %1").arg(short4(*design.mass, units::gram));
        }
        lines << tr("recip. %1 → %2")
                     .arg(shownDigits(design.before, unit, 0),
                          shownNumber(design.remaining, unit, 0));
    } else {
        lines << tr("nothing to cancel");
    }
    for (QString& line : lines) {
        line = fitted(line, room + 4.0);
    }
    painter.setPen(design.phase ? theme.text() : theme.mutedText());
    const double row = painter.fontMetrics().height();
    const double text = row * (design.mass ? 3.0 : 2.0) + 5.0;
    painter.drawText(area.adjusted(6, area.height() - text, -2, 0), Qt::AlignTop | Qt::AlignLeft,
                     lines.join(QLatin1Char('\n')));

    const QRectF figure = area.adjusted(6, row + 5.0, -6, -text);
    const double radius = 0.5 * std::min(figure.width(), figure.height()) - 6.0;
    if (radius < 12.0) {
        return;
    }
    const QPointF centre = figure.center();
    painter.setPen(QPen(theme.grid(), 1.0));
    painter.drawLine(centre - QPointF(radius, 0), centre + QPointF(radius, 0));
    painter.drawLine(centre - QPointF(0, radius), centre + QPointF(0, radius));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(centre, radius, radius);
    const auto ray = [&](double angle, Qt::PenStyle pen, const QColor& colour) {
        painter.setPen(QPen(colour, 1.1, pen));
        painter.drawLine(centre, centre + QPointF(std::cos(angle), -std::sin(angle)) * radius);
    };
    const double axis = result.engine.cylinders.front().bank_angle + pi / 2.0;
    ray(axis, Qt::DashDotLine, theme.mutedText());
    ray(axis + phi, Qt::DashLine, theme.accent());

    double largest = 1e-300;
    for (const ShaftDesign& each : result.shafts) {
        if (each.shaft.balances == design.shaft.balances) {
            largest = std::max(largest, std::abs(each.target));
        }
    }
    const double length = radius * std::max(0.2, std::abs(design.target) / largest);
    if (design.phase) {
        const double weight = *design.phase + turned;
        const double size = 0.62 * radius;
        QColor faint = drawing::weightFill(Role::ShaftWeight);
        if (moment) {
            faint.setAlphaF(0.45F);
            drawing::drawWeight(painter, centre, weight + pi, 0.8 * size, faint, theme.mutedText());
        }
        QColor front = drawing::weightFill(Role::ShaftWeight);
        front.setAlphaF(on ? 1.0F : 0.45F);
        drawing::drawWeight(painter, centre, weight, size, front,
                            on ? theme.text() : theme.mutedText());
        const double target = std::arg(design.target) + turned;
        drawing::drawArrow(painter, centre,
                           centre + QPointF(std::cos(target), -std::sin(target)) * length,
                           theme.error(), 2.2);
    }
    painter.setPen(QPen(theme.text(), 1.2));
    painter.setBrush(theme.panel());
    painter.drawEllipse(centre, 3.0, 3.0);
    drawing::drawTurning(painter, centre, radius + 3.0, sign > 0.0 ? 0.15 : pi - 0.15, sign * 0.9,
                         on ? theme.good() : theme.mutedText());
}

}  // namespace ravnoves
