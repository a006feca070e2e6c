#include "inertia-moments/order_bars.h"

#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "inertia-moments/model/inertia_moments_model.h"
#include "model/reference_case.h"
#include "pictures/figure.h"
#include "plot/painter_parts.h"
#include "text/csv_format.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "text/text_width.h"
#include "theme/theme.h"

namespace ravnoves {

using inertia_moments::EngineOrder;
using inertia_moments::Result;

namespace {

constexpr int panels = 3;
constexpr double decades = 6.0;  // of the logarithmic scale

QString valueText(double value) {
    const double size = std::abs(value);
    const int decimals = size >= 100.0 ? 0 : size >= 10.0 ? 1 : size >= 1.0 ? 2 : 3;
    return fixedNumber(value, decimals, QLocale());
}

}  // namespace

OrderBars::OrderBars(InertiaMomentsModel* model, QWidget* parent)
    : ComparedFigure(parent), model_(model) {
    setAccessibleName(tr("Amplitudes by order"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleDescription(sentence());
    makeFigure(this, [this](const CsvFormat& format) { return table(format); });
    connect(model_, &SceneModel::changed, this, [this] {
        setAccessibleDescription(sentence());
        update();
    });
    followReference(model_);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void OrderBars::setLogarithmic(bool logarithmic) {
    logarithmic_ = logarithmic;
    update();
}

std::vector<std::array<OrderBars::Group, 3>> OrderBars::groupsOf(const InertiaMomentsModel& model) {
    const Result& result = model.result();
    std::vector<std::array<Group, 3>> all(result.unbalanced.orders.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const EngineOrder& exact = result.unbalanced.orders[i];
        const EngineOrder& left = result.remaining.orders[i];
        auto& [force, moment, roll] = all[i];
        force.exact = exact.force.max();
        force.left = left.force.max();
        moment.exact = exact.moment.max();
        moment.left = left.moment.max();
        roll.exact = inertia_moments::amplitude(exact.roll());
        roll.left = inertia_moments::amplitude(left.roll());
        if (i < result.two_term_unbalanced.orders.size()) {
            const EngineOrder& two = result.two_term_unbalanced.orders[i];
            force.twoTerm = two.force.max();
            moment.twoTerm = two.moment.max();
            roll.twoTerm = inertia_moments::amplitude(two.roll());
        }
        // Rounding is not an amplitude.
        const std::array scales{exact.force_scale, exact.moment_scale, exact.roll_scale};
        for (std::size_t p = 0; p < scales.size(); ++p) {
            const double shown = shownUnit(p == 0 ? units::newton : units::N_m).factor;
            for (double Group::*member : {&Group::exact, &Group::twoTerm, &Group::left}) {
                double& value = all[i][p].*member;
                value = value <= inertia_moments::zero_share * scales[p] ? 0.0 : shown * value;
            }
        }
    }
    return all;
}

QString OrderBars::sentence() const {
    const auto all = groups();
    QString text =
        tr("Maximum: force %1 in order %2, moment %3 in order %4, roll moment %5 in order %6.");
    for (std::size_t p = 0; p < panels; ++p) {
        const auto most = std::max_element(
            all.begin(), all.end(),
            [p](const auto& one, const auto& other) { return one[p].exact < other[p].exact; });
        const QString unit = shownUnit(p == 0 ? units::newton : units::N_m).name;
        text = text.arg(most != all.end() ? withUnit(valueText((*most)[p].exact), unit) : QString())
                   .arg(most - all.begin() + 1);
    }
    return text;
}

QString OrderBars::table(const CsvFormat& format) const {
    QStringList head{tr("order")};
    const auto all = groups();
    const auto before = ghosts();
    const auto addHeadings = [&](const QString& name) {
        for (const QString& panel : {shownTitle(tr("F, N")).text, shownTitle(tr("M, N·m")).text,
                                     shownTitle(tr("Mz, N·m")).text}) {
            for (const QString& kind : {tr("exact"), tr("two-term"), tr("residual")}) {
                head << name + panel + QStringLiteral(": ") + kind;
            }
        }
    };
    addHeadings({});
    if (!before.empty()) {
        addHeadings(referenceName() + QStringLiteral(": "));
    }
    QString text = format.line(head);
    for (std::size_t i = 0; i < std::max(all.size(), before.size()); ++i) {
        QStringList cells{QString::number(i + 1)};
        const auto addCells = [&](const std::vector<std::array<Group, 3>>& of) {
            for (std::size_t p = 0; p < panels; ++p) {
                for (const double Group::*member : {&Group::exact, &Group::twoTerm, &Group::left}) {
                    cells << (i < of.size() ? format.number(of[i][p].*member) : QString());
                }
            }
        };
        addCells(all);
        if (!before.empty()) {
            addCells(before);
        }
        text += format.line(cells);
    }
    return text;
}

std::vector<std::array<OrderBars::Group, 3>> OrderBars::ghosts() const {
    const InertiaMomentsModel* other = referenceOf(model_);
    return other != nullptr ? groupsOf(*other) : std::vector<std::array<Group, 3>>();
}

QRectF OrderBars::panelRect(int panel) const {
    const double legend = Theme::withText(20);
    const double each = (height() - legend) / panels;
    return {0.0, legend + panel * each, static_cast<double>(width()), each};
}

QRectF OrderBars::barsRect(int panel) const {
    // Names and the highest numbers beside each other: a low panel has no second row.
    const QFont font = Theme::font(Theme::smallSize);
    const double names = textWidth(font, shownTitle(tr("Mz, N·m")).text);
    const double values = textWidth(font, QStringLiteral("00000"));
    return panelRect(panel).adjusted(names + values + 16.0, Theme::withText(14), -8,
                                     -Theme::withText(16));
}

void OrderBars::paintEvent(QPaintEvent* /*event*/) {
    const Theme& theme = Theme::instance();
    QPainter painter(this);
    painter.fillRect(rect(), theme.panel());
    painter.setFont(Theme::font(Theme::smallSize));
    const QFontMetricsF metrics(painter.font());

    constexpr std::array roles{Role::Exact, Role::TwoTerm, Role::Residual};
    const std::array roleNames{tr("exact"), tr("two-term"), tr("residual")};
    const double swatch = Theme::withText(10);
    const double row = metrics.height();
    const double legend = 0.5 * Theme::withText(20) + 1.0;  // its middle
    double x = barsRect(0).left();
    const auto entry = [&](const QString& text, const QPen& pen, const QBrush& brush) {
        painter.setPen(pen);
        painter.setBrush(brush);
        painter.drawRect(QRectF(x, legend - 0.5 * swatch, swatch, swatch));
        painter.setPen(theme.text());
        painter.drawText(QPointF(x + swatch + 4.0, legend + 0.35 * metrics.ascent()), text);
        x += metrics.horizontalAdvance(text) + swatch + 16.0;
    };
    for (std::size_t b = 0; b < roles.size(); ++b) {
        const painter_parts::BarFill fill(roles[b]);
        entry(roleNames[b], fill.edge, fill.inside);
    }
    const auto all = groups();
    const auto before = ghosts();
    if (!before.empty()) {
        const double room = childrenRect().left() - x - swatch - 12.0;
        entry(metrics.elidedText(referenceName(), Qt::ElideRight, room),
              QPen(theme.mutedText(), 1.2, Qt::DashLine), Qt::NoBrush);
    }
    const std::array<QString, panels> names{
        shownTitle(tr("F, N")).text, shownTitle(tr("M, N·m")).text, shownTitle(tr("Mz, N·m")).text};
    for (int panel = 0; panel < panels; ++panel) {
        const auto p = static_cast<std::size_t>(panel);
        const QRectF area = barsRect(panel);
        double most = 0.0;
        for (const auto& group : all) {
            most = std::max({most, group[p].exact, group[p].twoTerm, group[p].left});
        }
        for (const auto& group : before) {
            most = std::max({most, group[p].exact, group[p].twoTerm, group[p].left});
        }
        const auto fraction = [&](double value) {
            if (!(value > 0.0) || !(most > 0.0)) {
                return 0.0;
            }
            return logarithmic_ ? std::max(0.0, 1.0 + std::log10(value / most) / decades)
                                : value / most;
        };
        painter.setPen(theme.text());
        painter.drawText(QRectF(4, area.top() - 0.5 * row, area.left() - 6, row),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, names[p]);
        painter.setPen(theme.mutedText());
        painter.drawText(QRectF(4, area.bottom() - 0.8 * row, area.left() - 8, row),
                         Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip,
                         logarithmic_ ? tr("log") : QStringLiteral("0"));
        if (most > 0.0) {
            painter.drawText(QRectF(4, area.top() - 0.5 * row, area.left() - 8, row),
                             Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, valueText(most));
        }
        if (panel == panels - 1) {
            painter.drawText(QRectF(4, area.bottom() + 1, area.left() - 8, row),
                             Qt::AlignRight | Qt::AlignTop | Qt::TextDontClip, tr("order"));
        }
        painter.setPen(QPen(theme.grid(), 1));
        const int lines = logarithmic_ ? static_cast<int>(decades) : 2;
        for (int i = 1; i <= lines; ++i) {
            const double y = area.bottom() - area.height() * i / lines;
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        }
        const double slot = area.width() / static_cast<double>(all.size());
        const double bar = std::clamp(slot / 4.0, 2.0, 14.0);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Group& group = all[i][p];
            const double middle = area.left() + slot * (static_cast<double>(i) + 0.5);
            const Group ghost = i < before.size() ? before[i][p] : Group();
            const std::array values{group.exact, group.twoTerm, group.left};
            const std::array were{ghost.exact, ghost.twoTerm, ghost.left};
            double tallest = 0.0;
            for (std::size_t b = 0; b < values.size(); ++b) {
                const double h = area.height() * fraction(values[b]);
                const double was = area.height() * fraction(were[b]);
                const double left = middle + (static_cast<double>(b) - 1.5) * bar;
                tallest = std::max({tallest, h, was});
                if (h > 0.0) {
                    const painter_parts::BarFill fill(roles[b]);
                    painter.setPen(fill.edge);
                    painter.setBrush(fill.inside);
                    painter.drawRect(QRectF(left, area.bottom() - h, bar - 1.0, h));
                }
                if (was >= 1.0) {
                    painter.setPen(QPen(theme.text(), 1.0, Qt::DashLine));
                    painter.setBrush(Qt::NoBrush);
                    painter.drawRect(QRectF(left - 0.5, area.bottom() - was, bar, was));
                }
            }
            // Of the highest bar, in its colour: there is no room for three numbers.
            const auto highest = std::max_element(values.begin(), values.end());
            if (*highest > 0.02 * most) {
                const auto of = static_cast<std::size_t>(highest - values.begin());
                painter.setPen(theme.readable(theme.colour(roles[of])));
                const QString text = valueText(*highest);
                const double w = metrics.horizontalAdvance(text) + 2.0;
                if (w < slot * 1.3) {
                    painter.drawText(
                        QRectF(middle - w / 2, area.bottom() - tallest - row - 1.0, w, row),
                        Qt::AlignCenter | Qt::TextDontClip, text);
                }
            }
            painter.setPen(theme.mutedText());
            painter.drawText(QRectF(middle - 12, area.bottom() + 1, 24, row),
                             Qt::AlignHCenter | Qt::AlignTop | Qt::TextDontClip,
                             QString::number(i + 1));
        }
        painter.setPen(QPen(theme.border(), 1));
        painter.drawPolyline(QPolygonF{area.topLeft(), area.bottomLeft(), area.bottomRight()});
        if (!(most > 0.0)) {
            painter.setPen(theme.mutedText());
            painter.drawText(area, Qt::AlignCenter, tr("all orders are 0"));
        }
    }
}

bool OrderBars::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        auto* help = static_cast<QHelpEvent*>(event);
        const auto all = groups();
        for (int panel = 0; panel < panels; ++panel) {
            const QRectF area = barsRect(panel);
            if (!area.adjusted(0, -14, 0, 16).contains(help->pos())) {
                continue;
            }
            const double slot = area.width() / static_cast<double>(all.size());
            const auto i =
                static_cast<std::size_t>(std::clamp((help->pos().x() - area.left()) / slot, 0.0,
                                                    static_cast<double>(all.size()) - 1.0));
            const QString unit = shownUnit(panel == 0 ? units::newton : units::N_m).name;
            const auto inWords = [&](const Group& group) {
                return tr("Order %1: exact %2, two-term %3, residual %4")
                    .arg(QString::number(i + 1), valueText(group.exact), valueText(group.twoTerm),
                         withUnit(valueText(group.left), unit));
            };
            const auto p = static_cast<std::size_t>(panel);
            QString text = inWords(all[i][p]);
            if (const auto before = ghosts(); i < before.size()) {
                text += QLatin1Char('\n') + referenceName() + QStringLiteral(": ") +
                        inWords(before[i][p]);
            }
            QToolTip::showText(help->globalPos(), text, this);
            return true;
        }
        QToolTip::hideText();
        event->ignore();
        return true;
    }
    return QWidget::event(event);
}

}  // namespace ravnoves
