#include "inertia-moments/crank_views.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <map>

#include "inertia-moments/model/inertia_moments_model.h"
#include "model/reference_case.h"
#include "numerics/angle.h"
#include "pictures/figure.h"
#include "text/csv_format.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

using inertia_moments::Complex;
using inertia_moments::FiringEvent;

namespace {

QString angleText(double radians) {
    const double value = wrap(radians / degree, 360.0);
    return fixedNumber(value > 359.95 ? 0.0 : value, 1, QLocale()) + QStringLiteral("°");
}

void connectTo(InertiaMomentsModel* model, ComparedFigure* widget) {
    widget->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    QObject::connect(model, &SceneModel::changed, widget, qOverload<>(&QWidget::update));
    widget->followReference(model);
    QObject::connect(&Theme::instance(), &Theme::changed, widget, qOverload<>(&QWidget::update));
}

}  // namespace

CounterweightView::CounterweightView(InertiaMomentsModel* model, QWidget* parent)
    : ComparedFigure(parent), model_(model) {
    setAccessibleName(name());
    makeFigure(this, [this](const CsvFormat& format) { return table(format); });
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

    const double textWidth = std::min<double>(Theme::withText(210), 0.45 * width());
    const QRectF figure(8, 8, width() - textWidth - 16, height() - 16);
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
        if (const InertiaMomentsModel* other = referenceOf(model_)) {
            const auto& was = other->result();
            painter.setPen(ghostPen(theme.text()));
            for (const auto& cylinder : was.engine.cylinders) {
                painter.drawLine(centre, place(cylinder.crankpin_angle, radius));
            }
            const auto ghost = [&](const Complex& v, double scale, const QColor& colour) {
                if (std::abs(v) > inertia_moments::zero_share * scale) {
                    painter.setPen(ghostPen(colour, 7.0));
                    painter.drawLine(centre, place(std::arg(v), 0.8 * radius));
                }
            };
            ghost(was.rotating.force_factor, was.rotating.force_scale,
                  theme.colour(Role::Rotating));
            ghost(was.rotating.moment_factor, was.rotating.moment_scale,
                  theme.colour(Role::RotatingMoment));
            if (was.counterweights) {
                const auto& design = *was.counterweights;
                ghost(design.front.unbalance, design.scale, drawing::weightFill(Role::CrankWeight));
                ghost(design.rear.unbalance, design.scale, drawing::weightFill(Role::RearWeight));
            }
            const double room = Theme::margin;
            sayReference(painter, QRectF(room, room, width() - textWidth - 2.0 * room, 0.0));
        }
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

    // What the colours mean, with the angles.
    painter.setFont(Theme::font(Theme::smallSize));
    double y = 12.0;
    const double x = width() - textWidth;
    const auto line = [&](const QString& text, const QColor& colour, bool swatch) {
        if (swatch) {
            painter.fillRect(QRectF(x, y + 3, 9, 9), colour);
        }
        painter.setPen(theme.text());
        const QRectF box(x + 14, y, textWidth - 20, 200);
        QRectF used;
        painter.drawText(box, Qt::AlignTop | Qt::AlignLeft | Qt::TextWordWrap, text, &used);
        y += used.height() + 5.0;
    };
    const auto& rotating = result.rotating;
    // What vanishes has no angle.
    const auto isThere = [](const Complex& v, double scale) {
        return std::abs(v) > inertia_moments::zero_share * scale;
    };
    const auto withAngles = [&](const QString& value, const Complex& v, double scale) {
        return isThere(v, scale) ? tr("%1 at %2; opposite: %3 against the rotation")
                                       .arg(value, angleText(std::arg(v)), angleText(-std::arg(-v)))
                                 : value;
    };
    const QString force = fixedNumber(std::abs(rotating.force_factor), 3, QLocale());
    line(tr("force Σ exp(iκ) = %1")
             .arg(withAngles(force, rotating.force_factor, rotating.force_scale)),
         theme.colour(Role::Rotating), true);
    const QString moment = shownNumber(std::abs(rotating.moment_factor), units::mm, 1);
    line(tr("moment Σ z exp(iκ) = %1")
             .arg(withAngles(moment, rotating.moment_factor, rotating.moment_scale)),
         theme.colour(Role::RotatingMoment), true);
    if (result.counterweights) {
        const auto& design = *result.counterweights;
        const auto weight = [&](const QString& name, const inertia_moments::Counterweight& w,
                                const QColor& colour) {
            const bool isNeeded = isThere(w.unbalance, design.scale);
            QString text = tr("%1: %2 at ρ %3")
                               .arg(name,
                                    withUnit(isNeeded ? shownFigures(w.mass(), units::gram, 4)
                                                      : QStringLiteral("0"),
                                             shownUnit(units::gram).name),
                                    shownShort(w.radius, units::mm, 4));
            if (isNeeded) {
                text += QStringLiteral(", ") + angleText(std::arg(w.unbalance));
            }
            line(text, colour, true);
        };
        weight(tr("front web"), design.front, drawing::weightFill(Role::CrankWeight));
        weight(tr("rear web"), design.rear, drawing::weightFill(Role::RearWeight));
        if (!model_->input().end_webs->enabled) {
            line(tr("(switched off)"), {}, false);
        }
    } else {
        line(tr("No counterweights: switch them on under Balancing."), {}, false);
    }
}

QString CounterweightView::table(const CsvFormat& format) const {
    const auto& result = model_->result();
    QString text = format.line({{}, shownTitle(tr("size, mm")).text, tr("angle, °")});
    const double shown = shownTitle(tr("size, mm")).factor / units::mm.to_si;
    const auto row = [&](const QString& name, const QString& size, const Complex& v, double scale) {
        const bool isThere = std::abs(v) > inertia_moments::zero_share * scale;
        text += format.line(
            {name, size, isThere ? format.number(wrap(std::arg(v) / degree, 360.0)) : QString()});
    };
    for (std::size_t i = 0; i < result.engine.cylinders.size(); ++i) {
        row(tr("crankpin %1").arg(i + 1), {},
            std::polar(1.0, result.engine.cylinders[i].crankpin_angle), 1.0);
    }
    const auto& rotating = result.rotating;
    row(tr("force Σ exp(iκ)"), format.number(std::abs(rotating.force_factor)),
        rotating.force_factor, rotating.force_scale);
    row(tr("moment Σ z exp(iκ)"), format.number(shown * std::abs(rotating.moment_factor)),
        rotating.moment_factor, rotating.moment_scale);
    return text;
}

FiringWheel::FiringWheel(InertiaMomentsModel* model, QWidget* parent)
    : ComparedFigure(parent), model_(model) {
    setAccessibleName(tr("Firing order"));
    makeFigure(this, [this](const CsvFormat& format) {
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
    double least = result.firing.front().interval;
    double most = least;
    for (const FiringEvent& event : result.firing) {
        least = std::min(least, event.interval);
        most = std::max(most, event.interval);
    }
    const bool even = most - least < 0.05 * degree;
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
    if (const InertiaMomentsModel* other = referenceOf(model_)) {
        // Where it fires, inside of the ring.
        const double theirs = two_pi / other->input().cycle();
        painter.setFont(Theme::font(Theme::smallSize));
        for (const FiringEvent& event : other->result().firing) {
            const double angle = theirs * event.crank_angle;
            const QPointF ray(-std::sin(angle), -std::cos(angle));
            painter.setPen(ghostPen(theme.text()));
            painter.drawLine(centre + ray * (radius - 1.9 * disc), centre + ray * radius);
            painter.setPen(theme.mutedText());
            drawing::drawCentred(painter, centre + ray * (radius - 2.5 * disc),
                                 QString::number(event.cylinder));
        }
        const double room = Theme::margin;  // the corners above have texts
        sayReference(painter,
                     QRectF(rect()).adjusted(room, height() - room - painter.fontMetrics().height(),
                                             -room, 0));
    }
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
                     even ? tr("even, every %1°").arg(fixedNumber(least / degree, 0, QLocale()))
                          : tr("uneven, %1° to %2°")
                                .arg(fixedNumber(least / degree, 1, QLocale()),
                                     fixedNumber(most / degree, 1, QLocale())));
    std::vector<int> order;
    for (const FiringEvent& event : result.firing) {
        order.push_back(event.cylinder);
    }
    painter.drawText(QRectF(rect()).adjusted(8, 6, -8, -6), Qt::AlignTop | Qt::AlignRight,
                     InertiaMomentsModel::orderText(order));
}

}  // namespace ravnoves
