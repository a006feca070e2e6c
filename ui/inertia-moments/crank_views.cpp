#include "inertia-moments/crank_views.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <map>

#include "inertia-moments/model/inertia_moments_model.h"
#include "pictures/figure.h"
#include "text/csv_format.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

using inertia_moments::Complex;
using inertia_moments::FiringEvent;

namespace {

void connectTo(InertiaMomentsModel* model, QWidget* widget) {
    widget->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    QObject::connect(model, &SceneModel::changed, widget, qOverload<>(&QWidget::update));
    QObject::connect(&Theme::instance(), &Theme::changed, widget, qOverload<>(&QWidget::update));
}

}  // namespace

CounterweightView::CounterweightView(InertiaMomentsModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    setAccessibleName(name());
    makeFigure(this);
    setToolTip(
        tr("The crank from the front with crankpin 1 up; angles from crankpin 1, "
           "counter-clockwise, lags against the rotation."));
    connectTo(model, this);
}

void CounterweightView::paintEvent(QPaintEvent* /*event*/) {
    const Theme& theme = Theme::instance();
    const auto& result = model_->result();
    QPainter painter(this);
    painter.fillRect(rect(), theme.panel());
    painter.setRenderHint(QPainter::Antialiasing);

    const double keyWidth = Theme::withText(110);
    const QRectF figure(8, 8, width() - keyWidth - 16, height() - 16);
    const double radius = 0.5 * std::min(figure.width(), figure.height()) - 22.0;
    const QPointF centre = figure.center();
    // Relative to crankpin 1, which points up.
    const auto place = [&](double angle, double r) {
        return centre + QPointF(-std::sin(angle), -std::cos(angle)) * r;
    };
    if (radius > 16.0) {
        if (result.counterweights) {
            const auto& design = *result.counterweights;
            const double largest =
                std::max({std::abs(design.front.unbalance), std::abs(design.rear.unbalance),
                          1e3 * inertia_moments::zero_share * design.scale, 1e-300});
            const bool on = model_->input().end_webs->enabled;
            const auto weight = [&](const inertia_moments::Counterweight& w, QColor colour) {
                const double share = std::abs(w.unbalance) / largest;
                if (share < 1e-6) {
                    return;
                }
                colour.setAlphaF(on ? 0.9F : 0.35F);
                drawing::drawWeight(painter, centre, std::arg(w.unbalance) + pi / 2.0,
                                    radius * (0.45 + 0.4 * share), colour,
                                    on ? theme.text() : theme.mutedText());
            };
            weight(design.rear, drawing::weightFill(Role::RearWeight));
            weight(design.front, drawing::weightFill(Role::CrankWeight));
        }
        painter.setPen(QPen(theme.grid(), 1.2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(centre, radius, radius);
        // Crankpins; those in one place share a label.
        std::map<int, QStringList> labels;
        for (std::size_t i = 0; i < result.engine.cylinders.size(); ++i) {
            const double angle = result.engine.cylinders[i].crankpin_angle;
            labels[static_cast<int>(std::lround(angle / degree * 10.0))] << QString::number(i + 1);
            painter.setPen(QPen(theme.text(), 2.0));
            painter.drawLine(centre, place(angle, radius));
        }
        painter.setFont(Theme::font(Theme::smallSize, true));
        for (const auto& [tenths, names] : labels) {
            const double angle = tenths * 0.1 * degree;
            painter.setPen(QPen(theme.text(), 1.2));
            painter.setBrush(theme.panel());
            painter.drawEllipse(place(angle, radius), 4.5, 4.5);
            painter.setPen(theme.text());
            const QString text = names.join(QLatin1Char(','));
            const double beside = 0.5 * painter.fontMetrics().horizontalAdvance(text) - 4.0;
            drawing::drawCentred(
                painter, place(angle, radius + 12.0 + beside * std::abs(std::sin(angle))), text);
        }
        const auto vector = [&](const Complex& v, double scale, const QColor& colour) {
            if (std::abs(v) > inertia_moments::zero_share * scale) {
                drawing::drawArrow(painter, centre, place(std::arg(v), 0.8 * radius), colour, 2.4);
            }
        };
        vector(result.rotating.force_factor, result.rotating.force_scale,
               theme.colour(Role::Rotating));
        vector(result.rotating.moment_factor, result.rotating.moment_scale,
               theme.colour(Role::RotatingMoment));
        painter.setPen(QPen(theme.text(), 1.2));
        painter.setBrush(theme.panel());
        painter.drawEllipse(centre, 4.0, 4.0);
    }

    // What the colours mean; sizes and angles are in the table.
    painter.setFont(Theme::font(Theme::smallSize));
    const double row = painter.fontMetrics().height() + 3.0;
    QRectF key(width() - keyWidth, 12.0, keyWidth - 6.0, row);
    const auto say = [&](const QString& text, const QColor& colour) {
        painter.fillRect(QRectF(key.left(), key.center().y() - 4.5, 9.0, 9.0), colour);
        painter.setPen(theme.text());
        painter.drawText(key.adjusted(14.0, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter, text);
        key.translate(0.0, row);
    };
    say(tr("force"), theme.colour(Role::Rotating));
    say(tr("moment"), theme.colour(Role::RotatingMoment));
    if (result.counterweights) {
        say(tr("front web"), drawing::weightFill(Role::CrankWeight));
        say(tr("rear web"), drawing::weightFill(Role::RearWeight));
    }
    painter.setPen(theme.mutedText());
    painter.drawText(QRectF(key.left(), key.top() + 4.0, key.width(), height() - key.top()),
                     Qt::AlignTop | Qt::AlignLeft | Qt::TextWordWrap,
                     !result.counterweights
                         ? tr("No counterweights: switch them on under Balancing.")
                     : model_->input().end_webs->enabled ? QString()
                                                         : tr("(switched off)"));
}

FiringWheel::FiringWheel(InertiaMomentsModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    setAccessibleName(tr("Firing order"));
    makeFigure(this, [this](const CsvFormat& format) {
        if (model_->result().firing.empty()) {
            return QString();
        }
        QString text = format.line({tr("cylinder"), tr("crank angle, °"), tr("interval, °")});
        for (const FiringEvent& event : model_->result().firing) {
            text += format.line({QString::number(event.cylinder),
                                 format.number(event.crank_angle / degree),
                                 format.number(event.interval / degree)});
        }
        return text;
    });
    const auto tell = [this] {
        const QString cycle = withUnit(fixedNumber(model_->input().cycle() / degree, 0, QLocale()),
                                       QStringLiteral("°"));
        setToolTip(
            tr("One cycle of the crank, %1, counter-clockwise from the top: cylinders in the "
               "order of firing, the intervals between them, the present crank angle.")
                .arg(cycle));
    };
    tell();
    connect(model_, &SceneModel::changed, this, tell);
    connectTo(model, this);
    connect(model_->crank(), &CrankAngle::changed, this, qOverload<>(&QWidget::update));
}

void FiringWheel::paintEvent(QPaintEvent* /*event*/) {
    const Theme& theme = Theme::instance();
    const auto& result = model_->result();
    QPainter painter(this);
    painter.fillRect(rect(), theme.panel());
    painter.setRenderHint(QPainter::Antialiasing);
    if (result.firing.empty()) {
        painter.setPen(theme.mutedText());
        painter.setFont(Theme::font());
        painter.drawText(QRectF(rect()).adjusted(20, 0, -20, 0), Qt::AlignCenter | Qt::TextWordWrap,
                         result.firing_trouble.empty() ? tr("No firing order given.")
                                                       : messageText(result.firing_trouble));
        return;
    }
    const double radius = 0.5 * std::min(width(), height()) - Theme::withText(34);
    if (radius < 16.0) {
        return;
    }
    const QPointF centre = QRectF(rect()).center();
    // A turn of the wheel is a cycle.
    const double perCycle = two_pi / model_->input().cycle();
    const auto place = [&](double crankAngle, double r) {
        const double angle = perCycle * crankAngle;
        return centre + QPointF(-std::sin(angle), -std::cos(angle)) * r;
    };
    painter.setPen(QPen(theme.border(), 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(centre, radius, radius);
    double minimum = result.firing.front().interval;
    double maximum = minimum;
    for (const FiringEvent& event : result.firing) {
        minimum = std::min(minimum, event.interval);
        maximum = std::max(maximum, event.interval);
    }
    const bool even = maximum - minimum < 0.05 * degree;
    constexpr double atOnce = 0.05 * degree;
    for (const FiringEvent& event : result.firing) {
        if (event.interval < atOnce) {
            continue;
        }
        painter.setFont(Theme::font(Theme::smallSize));
        painter.setPen(theme.mutedText());
        const QString interval = fixedNumber(event.interval / degree, even ? 0 : 1, QLocale());
        drawing::drawCentred(
            painter, place(event.crank_angle + 0.5 * event.interval, radius - Theme::withText(20)),
            interval + QStringLiteral("°"));
    }
    const double disc = Theme::withText(11);
    double inwards = 0.0;  // those that fire at once stand one below the other
    for (const FiringEvent& event : result.firing) {
        const QPointF at = place(event.crank_angle, std::max(radius - inwards, 0.0));
        inwards = event.interval < atOnce ? inwards + Theme::withText(24) : 0.0;
        painter.setPen(QPen(theme.text(), 1.4));
        painter.setBrush(event.cylinder == 1 ? theme.accent() : theme.panel());
        painter.drawEllipse(at, disc, disc);
        painter.setPen(event.cylinder == 1 ? QColor(Qt::white) : theme.text());
        painter.setFont(Theme::font(Theme::baseSize, true));
        drawing::drawCentred(painter, at, QString::number(event.cylinder));
    }
    // φ counts from crankpin 1 on its cylinder's axis, the wheel from the first one's firing.
    const auto& engine = result.engine;
    const auto first = static_cast<std::size_t>(result.firing.front().cylinder) - 1;
    const double zero = engine.top_dead_centre(first) - engine.crank_phase(engine.cylinders[first]);
    const double now = model_->crank()->degrees() * degree - zero;
    painter.setPen(QPen(theme.accent(), 2.0));
    painter.drawLine(centre, place(now, radius - Theme::withText(30)));
    painter.setBrush(theme.accent());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(centre, 3.5, 3.5);
    painter.setFont(Theme::font(Theme::smallSize));
    painter.setPen(theme.mutedText());
    painter.drawText(QRectF(rect()).adjusted(8, 6, -8, -6), Qt::AlignTop | Qt::AlignLeft,
                     even ? tr("even, every %1°").arg(fixedNumber(minimum / degree, 0, QLocale()))
                          : tr("uneven, %1° to %2°")
                                .arg(fixedNumber(minimum / degree, 1, QLocale()),
                                     fixedNumber(maximum / degree, 1, QLocale())));
    std::vector<int> order;
    for (const FiringEvent& event : result.firing) {
        order.push_back(event.cylinder);
    }
    painter.drawText(QRectF(rect()).adjusted(8, 6, -8, -6), Qt::AlignTop | Qt::AlignRight,
                     InertiaMomentsModel::orderText(order));
}

}  // namespace ravnoves
