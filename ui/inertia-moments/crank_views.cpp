#include "inertia-moments/crank_views.h"

#include <QLocale>
#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <map>

#include "inertia-moments/model/inertia_moments_model.h"
#include "pictures/figure.h"
#include "text/csv_format.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/drawing.h"

namespace ravnoves {

using inertia_moments::Balances;
using inertia_moments::Complex;
using inertia_moments::Direction;
using inertia_moments::FiringEvent;
using inertia_moments::ShaftDesign;

namespace {

using Model = InertiaMomentsModel;

class CrankPicture final : public QWidget {
  public:
    using Paint = void (*)(QPainter& painter, Model& model, const QRectF& all);

    CrankPicture(Model* model, const QString& name, Paint paint, QWidget* parent)
        : QWidget(parent), model_(model), paint_(paint) {
        setAccessibleName(name);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
        connect(model, &SceneModel::changed, this, qOverload<>(&QWidget::update));
        connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    }

    QSize sizeHint() const override { return {420, 260}; }
    QSize minimumSizeHint() const override { return {Theme::withText(240), Theme::withText(160)}; }

  protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        painter.fillRect(rect(), Theme::instance().panel());
        painter.setRenderHint(QPainter::Antialiasing);
        paint_(painter, *model_, rect());
    }

  private:
    Model* model_;
    Paint paint_;
};

/// In the place of a picture.
void paintWords(QPainter& painter, const QRectF& all, const QString& text) {
    painter.setPen(Theme::instance().mutedText());
    painter.setFont(Theme::font());
    painter.drawText(all.adjusted(20, 0, -20, 0), Qt::AlignCenter | Qt::TextWordWrap, text);
}

void paintCounterweights(QPainter& painter, Model& model, const QRectF& all) {
    const Theme& theme = Theme::instance();
    const auto& result = model.result();
    const double keyWidth = Theme::withText(110);
    const QRectF figure(8, 8, all.width() - keyWidth - 16, all.height() - 16);
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
            const bool on = model.input().end_webs->enabled;
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
    QRectF key(all.width() - keyWidth, 12.0, keyWidth - 6.0, row);
    const auto say = [&](const QString& text, const QColor& colour) {
        painter.fillRect(QRectF(key.left(), key.center().y() - 4.5, 9.0, 9.0), colour);
        painter.setPen(theme.text());
        painter.drawText(key.adjusted(14.0, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter, text);
        key.translate(0.0, row);
    };
    say(CrankViews::tr("force"), theme.colour(Role::Rotating));
    say(CrankViews::tr("moment"), theme.colour(Role::RotatingMoment));
    if (result.counterweights) {
        say(CrankViews::tr("front web"), drawing::weightFill(Role::CrankWeight));
        say(CrankViews::tr("rear web"), drawing::weightFill(Role::RearWeight));
    }
    painter.setPen(theme.mutedText());
    painter.drawText(QRectF(key.left(), key.top() + 4.0, key.width(), all.height() - key.top()),
                     Qt::AlignTop | Qt::AlignLeft | Qt::TextWordWrap,
                     !result.counterweights
                         ? CrankViews::tr("No counterweights: switch them on under Balancing.")
                     : model.input().end_webs->enabled ? QString()
                                                       : CrankViews::tr("(switched off)"));
}

void paintFiring(QPainter& painter, Model& model, const QRectF& all) {
    const Theme& theme = Theme::instance();
    const auto& result = model.result();
    if (result.firing.empty()) {
        paintWords(painter, all,
                   result.firing_trouble.empty() ? CrankViews::tr("No firing order given.")
                                                 : messageText(result.firing_trouble));
        return;
    }
    const double radius = 0.5 * std::min(all.width(), all.height()) - Theme::withText(34);
    if (radius < 16.0) {
        return;
    }
    const QPointF centre = all.center();
    // A turn of the wheel is a cycle.
    const double perCycle = two_pi / model.input().cycle();
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
    const double now = model.crank()->degrees() * degree - zero;
    painter.setPen(QPen(theme.accent(), 2.0));
    painter.drawLine(centre, place(now, radius - Theme::withText(30)));
    painter.setBrush(theme.accent());
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(centre, 3.5, 3.5);
    painter.setFont(Theme::font(Theme::smallSize));
    painter.setPen(theme.mutedText());
    painter.drawText(
        all.adjusted(8, 6, -8, -6), Qt::AlignTop | Qt::AlignLeft,
        even ? CrankViews::tr("even, every %1°").arg(fixedNumber(minimum / degree, 0, QLocale()))
             : CrankViews::tr("uneven, %1° to %2°")
                   .arg(fixedNumber(minimum / degree, 1, QLocale()),
                        fixedNumber(maximum / degree, 1, QLocale())));
    std::vector<int> order;
    for (const FiringEvent& event : result.firing) {
        order.push_back(event.cylinder);
    }
    painter.drawText(all.adjusted(8, 6, -8, -6), Qt::AlignTop | Qt::AlignRight,
                     InertiaMomentsModel::orderText(order));
}

void paintShaft(QPainter& painter, Model& model, const ShaftDesign& design, const QRectF& area) {
    const Theme& theme = Theme::instance();
    const auto& result = model.result();
    const bool on = design.shaft.enabled;
    const bool moment = design.shaft.balances == Balances::moment;
    const double phi = model.crank()->degrees() * degree;
    const double sign = design.shaft.direction == Direction::forward ? 1.0 : -1.0;
    const double turned = sign * design.shaft.order * phi;

    painter.setPen(QPen(theme.border(), 1.0));
    QColor back = theme.good();
    back.setAlphaF(on ? 0.08F : 0.0F);
    painter.setBrush(back);
    painter.drawRoundedRect(area, 4, 4);

    painter.setFont(Theme::font(Theme::smallSize, true));
    painter.setPen(on ? theme.good() : theme.mutedText());
    const QString state = on ? CrankViews::tr("on") : CrankViews::tr("off");
    const QFontMetricsF small(Theme::font(Theme::smallSize));
    const double room = area.width() - 12.0;
    const auto fitted = [&](const QString& words, double width) {
        return painter.fontMetrics().elidedText(words, Qt::ElideRight, static_cast<int>(width));
    };
    painter.drawText(area.adjusted(6, 3, -6, 0), Qt::AlignTop | Qt::AlignLeft,
                     fitted((on ? QStringLiteral("\u25CF ") : QStringLiteral("\u25CB ")) +
                                model.shaftTitle(design.shaft),
                            room - small.horizontalAdvance(state) - 4.0));
    painter.setFont(Theme::font(Theme::smallSize));
    painter.setPen(theme.mutedText());
    painter.drawText(area.adjusted(6, 3, -6, 0), Qt::AlignTop | Qt::AlignRight, state);

    const Unit& unit = moment ? units::N_m : units::newton;
    QStringList lines;
    if (design.phase) {  // without one there is nothing to cancel but rounding
        lines << CrankViews::tr("mρ %1").arg(shownShort(design.unbalance, units::gram_mm, 4));
        if (design.mass) {
            lines << CrankViews::tr("m %1").arg(shownShort(*design.mass, units::gram, 4));
        }
        lines << CrankViews::tr("recip. %1 → %2")
                     .arg(shownDigits(design.before, unit, 0),
                          shownNumber(design.remaining, unit, 0));
    } else {
        lines << CrankViews::tr("nothing to cancel");
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

void paintShafts(QPainter& painter, Model& model, const QRectF& all) {
    const auto& shafts = model.result().shafts;
    const int count = static_cast<int>(shafts.size());
    if (count == 0) {
        paintWords(painter, all,
                   CrankViews::tr("No balance shafts. Press “Add shaft” under Balancing."));
        return;
    }
    const auto rowsOf = [&](int columns) { return (count + columns - 1) / columns; };
    // The columns that make each picture largest.
    int columns = 1;
    double largest = 0.0;
    for (int tried = 1; tried <= count; ++tried) {
        const double each = std::min(all.width() / tried, all.height() / rowsOf(tried) - 34.0);
        if (each > largest) {
            largest = each;
            columns = tried;
        }
    }
    const QSizeF cell(all.width() / columns, all.height() / rowsOf(columns));
    for (int i = 0; i < count; ++i) {
        const QPointF corner((i % columns) * cell.width(), (i / columns) * cell.height());
        paintShaft(painter, model, shafts[static_cast<std::size_t>(i)],
                   QRectF(corner, cell).adjusted(3, 3, -3, -3));
    }
}

}  // namespace

QWidget* counterweightView(Model* model, QWidget* parent) {
    auto* view = new CrankPicture(model, CrankViews::tr("Rotating masses and counterweights"),
                                  paintCounterweights, parent);
    view->setToolTip(
        CrankViews::tr("The crank from the front with crankpin 1 up; angles from crankpin 1, "
                       "counter-clockwise, lags against the rotation."));
    makeFigure(view);
    return view;
}

QWidget* firingWheel(Model* model, QWidget* parent) {
    auto* view = new CrankPicture(model, CrankViews::tr("Firing order"), paintFiring, parent);
    makeFigure(view, [model](const CsvFormat& format) {
        if (model->result().firing.empty()) {
            return QString();
        }
        QString text = format.line({CrankViews::tr("cylinder"), CrankViews::tr("crank angle, °"),
                                    CrankViews::tr("interval, °")});
        for (const FiringEvent& event : model->result().firing) {
            text += format.line({QString::number(event.cylinder),
                                 format.number(event.crank_angle / degree),
                                 format.number(event.interval / degree)});
        }
        return text;
    });
    const auto tell = [model, view] {
        const QString cycle = withUnit(fixedNumber(model->input().cycle() / degree, 0, QLocale()),
                                       QStringLiteral("°"));
        view->setToolTip(
            CrankViews::tr(
                "One cycle of the crank, %1, counter-clockwise from the top: cylinders in the "
                "order of firing, the intervals between them, the present crank angle.")
                .arg(cycle));
    };
    tell();
    QObject::connect(model, &SceneModel::changed, view, tell);
    QObject::connect(model->crank(), &CrankAngle::changed, view, qOverload<>(&QWidget::update));
    return view;
}

QWidget* shaftView(Model* model, QWidget* parent) {
    auto* view = new CrankPicture(model, CrankViews::tr("Balance shafts: arrangement and phases"),
                                  paintShafts, parent);
    view->setToolTip(CrankViews::tr(
        "Shafts from the front at the present crank angle; red: cancelled part; dashed: axis "
        "and crankpin of cylinder 1."));
    makeFigure(view);
    QObject::connect(model->crank(), &CrankAngle::changed, view, qOverload<>(&QWidget::update));
    return view;
}

}  // namespace ravnoves
