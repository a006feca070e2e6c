#include <QCoreApplication>
#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <cmath>

#include "balance-shaft/fields.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/shaft_tabs.h"
#include "page/part_views.h"
#include "page/rejected_entries.h"
#include "pictures/figure.h"
#include "pictures/file_dialogs.h"
#include "text/message_text.h"
#include "text/shown_units.h"
#include "text/write_file.h"
#include "theme/theme.h"
#include "widgets/drawing.h"
#include "widgets/form.h"
#include "widgets/layouts.h"
#include "widgets/page_columns.h"
#include "widgets/panel.h"

namespace ravnoves {

using balance_shaft::Input;
using balance_shaft::RelievedShaft;
using balance_shaft::RelievedShaftSizes;
namespace field = balance_shaft::field;

namespace {

/// A size that is given or found.
struct ReliefSize {
    const Field& field;
    std::optional<double> RelievedShaftSizes::*given;
    double RelievedShaft::*found;
};
constexpr std::array reliefSizes{
    ReliefSize{field::bar_diameter, &RelievedShaftSizes::diameter, &RelievedShaft::diameter},
    ReliefSize{field::relief_depth, &RelievedShaftSizes::depth, &RelievedShaft::depth},
    ReliefSize{field::relief_length, &RelievedShaftSizes::length, &RelievedShaft::length}};

/// Section and side view of a shaft with a relieved middle, to scale, with its main sizes.
class RelievedShaftDrawing : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::RelievedShaftDrawing)

  public:
    RelievedShaftDrawing(BalanceShaftModel* model, QWidget* parent)
        : QWidget(parent), model_(model) {
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
        setAccessibleName(tr("Drawing of the shaft with a relieved middle"));
        connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
        connect(model, &SceneModel::changed, this, &RelievedShaftDrawing::follow);
        makeFigure(this);
        follow();
    }

    QSize sizeHint() const override { return {600, 220}; }

  protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const Theme& theme = Theme::instance();
        painter.fillRect(rect(), theme.panel());
        painter.setFont(Theme::font(Theme::smallSize));
        const RelievedShaft& shaft = model_->result().relieved_shaft;
        if (!(shaft.half_width > 0.0)) {
            painter.setPen(theme.mutedText());
            painter.drawText(rect(), Qt::AlignCenter, tr("No shaft of these sizes"));
            return;
        }
        // Section at the left, a gap of one diameter, the side view with half a diameter of whole
        // bar on both sides.
        const double wide = 3.0 * shaft.diameter + shaft.length;
        const double row = painter.fontMetrics().height();
        const double axes = 8.0;  // of the section, beyond it
        const double margin = axes + 12.0 + row;
        const double scale =
            std::min((width() - 2.0 * margin) / wide, (height() - 2.0 * margin) / shaft.diameter);
        if (scale <= 0.0) {
            return;
        }
        const double radius = scale * shaft.diameter / 2.0;
        const double flat = radius - scale * shaft.depth;
        const double end = scale * shaft.length / 2.0;
        const double outer = end + radius;
        const QPointF section((width() - wide * scale) / 2.0 + radius, height() / 2.0);
        const QPointF side(section.x() + 3.0 * radius + outer, section.y());
        // From the middle of what was cut off to the flat's corner.
        const double angle = std::atan2(flat, scale * shaft.half_width) / degree;
        const QRectF circle(section - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
        QPainterPath outline;
        outline.arcMoveTo(circle, 180.0 - angle);
        outline.arcTo(circle, 180.0 - angle, 180.0 + 2.0 * angle);
        outline.closeSubpath();
        outline.addPolygon(QPolygonF{QPointF(-outer, radius), QPointF(outer, radius),
                                     QPointF(outer, -radius), QPointF(end, -radius),
                                     QPointF(end, -flat), QPointF(-end, -flat),
                                     QPointF(-end, -radius), QPointF(-outer, -radius)}
                               .translated(side));
        outline.closeSubpath();
        QColor steel = theme.colour(Role::Neutral);
        steel.setAlpha(60);
        painter.setPen(QPen(theme.text(), 1.6));
        painter.setBrush(steel);
        painter.drawPath(outline);
        const auto line = [&](const QPointF& middle, const QPointF& reach, double up = 0.0) {
            const QPointF at = middle - QPointF(0.0, up);
            painter.drawLine(at - reach, at + reach);
        };
        painter.setPen(QPen(theme.colour(Role::Shaft), 1.2, Qt::DashLine));  // what was cut off
        painter.drawArc(circle, static_cast<int>(16 * angle),
                        static_cast<int>(16 * (180 - 2 * angle)));
        line(side, {end, 0.0}, radius);
        painter.setPen(QPen(theme.mutedText(), 1.0, Qt::DashDotLine));
        line(section, {radius + axes, 0.0});
        line(section, {0.0, radius + axes});
        line(side, {end + 1.2 * radius, 0.0});
        // Centre of mass.
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.accent());
        painter.drawEllipse(section + QPointF(0.0, scale * shaft.centre_of_mass_radius), 3.5, 3.5);

        painter.setPen(theme.text());
        const auto size = [&](const QPointF& at, const QString& sign, double metres) {
            drawing::drawCentred(painter, at, sign + shownNumber(metres, units::mm, 1));
        };
        const QPointF below(0.0, radius + axes + 4.0 + row / 2.0);
        size(section + below, QStringLiteral("⌀ "), shaft.diameter);
        size(section - below, QStringLiteral("h "), shaft.depth);
        size(side - below, QStringLiteral("b "), shaft.length);
    }

  private:
    void follow() {
        const RelievedShaft& shaft = model_->result().relieved_shaft;
        const auto mm = [](double metres) { return shownNumber(metres, units::mm, 1); };
        setAccessibleDescription(
            shaft.half_width > 0.0 ? tr("Bar of %1, its middle cut %2 deep over %3.")
                                         .arg(mm(shaft.diameter), mm(shaft.depth), mm(shaft.length))
                                   : tr("No shaft of these sizes"));
        update();
    }

    BalanceShaftModel* model_;
};

}  // namespace

/// The balance shaft as a round bar with a segment milled away (the paper's Fig. 5) for the
/// unbalance m₁ ρ₁ of the page: its sizes, of which one is found, the answer and the drawing.
QWidget* ShaftTabs::buildRelief() {
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder, Theme::space, tabMargins);
    constexpr int pairWidth = 540;
    auto* upper = new FoldingRow(pairWidth, holder);
    column->addWidget(upper, 1);

    auto* panel = new Panel(holder);
    QVBoxLayout* inputs = columnIn(panel, -1, {0, 0, 0, Theme::space});
    auto* form = new Form(model_, panel);
    form->section(tr("Shaft with a relieved middle"));
    addReliefSizes(form);
    form->column()->addStretch();
    inputs->addWidget(form, 1);
    auto* write = new QPushButton(tr("E&xport drawing (DXF)…"), panel);
    write->setToolTip(tr("Section and side view, real size, for the machine shop"));
    connect(write, &QPushButton::clicked, this, [this, panel] {
        if (continueWithoutRejected(panel, tr("Export drawing"))) {
            saveFile(this, tr("Export drawing"), QStringLiteral("balance-shaft.dxf"), {dxfFormat()},
                     [this](const QString& path) {
                         return writeFile(path, [this] {
                             return relieved_shaft_dxf(model_->result().relieved_shaft);
                         });
                     });
        }
    });
    auto* row = new QHBoxLayout;
    row->setContentsMargins(Theme::margin, 0, Theme::margin, 0);
    row->addWidget(write);
    inputs->addLayout(row);
    upper->add(panel, 4);

    auto* answerPanel = new Panel(holder);
    QVBoxLayout* answerColumn = columnIn(answerPanel, -1, tableMargins);
    auto* verdict = new PartText(model_, "relief-verdict", answerPanel);
    answerColumn->addWidget(verdict);
    answerColumn->addWidget(
        new PartTable(model_, "relief", tr("Sizes and masses of the shaft"), answerPanel), 1);
    upper->add(answerPanel, 5);  // whole names beside the numbers

    auto* drawing = new RelievedShaftDrawing(model_, holder);
    constexpr int minDrawing = 150;
    drawing->setMinimumHeight(Theme::withText(minDrawing));
    column->addWidget(drawing, 1);

    const auto showFeasible = [this, verdict, write] {
        const bool isFeasible = model_->result().relieved_shaft.feasible;
        colourText(verdict, isFeasible ? &Theme::text : &Theme::warning);
        write->setEnabled(isFeasible);
    };
    connect(model_, &SceneModel::changed, holder, showFeasible);
    showFeasible();
    return holder;
}

void ShaftTabs::addReliefSizes(Form* form) {
    const auto given = [this] { return balance_shaft::relieved_shaft_sizes(model_->input()); };
    const auto set = [this](const Field& field, const auto& change) {
        model_->edit(fieldName(field), [&](Input& input) {
            input.relieved_shaft = balance_shaft::relieved_shaft_sizes(input);
            change(*input.relieved_shaft);
        });
    };
    const int wide = Theme::withText(116);  // "auto 29.3344"
    for (const ReliefSize& size : reliefSizes) {
        NumberField* number = form->number(
            size.field, [given, &size] { return given().*size.given; },
            [set, &size](std::optional<double> value) {
                set(size.field, [&](RelievedShaftSizes& next) { next.*size.given = value; });
            });
        number->setDigits(6);  // a size that was found has more than fit
        number->setFixedWidth(wide);
        // Two of the three are given: none of the two can be left blank.
        form->follow([given, number, &size] {
            const RelievedShaftSizes sizes = given();
            number->setOptional(!(sizes.*size.given) ||
                                (sizes.diameter && sizes.depth && sizes.length));
        });
        const auto found = [this, &size] {
            const double metres = model_->result().relieved_shaft.*size.found;
            return metres > 0.0 ? std::optional(metres / units::mm) : std::nullopt;
        };
        showAssumed(form, number, found, 6);
    }
    NumberField* density = form->number(
        field::density, [given] { return given().density; },
        [set](std::optional<double> value) {
            set(field::density, [&](RelievedShaftSizes& next) { next.density = *value; });
        });
    density->setFixedWidth(wide);
    form->current()->addWide(
        captionLabel(tr("Enter two sizes; the third follows from the unbalance m₁ ρ₁."), form));
}

}  // namespace ravnoves
