#include "balance-shaft/relieved_shaft_view.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "balance-shaft/fields.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "model/reference_case.h"
#include "page/compared_figure.h"
#include "page/part_views.h"
#include "page/rejected_entries.h"
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

/// A size that is given or found, in the order of what can be found.
struct ReliefSize {
    const Field& field;
    std::optional<double> RelievedShaftSizes::*given;
    double RelievedShaft::*found;
};
constexpr std::array reliefSizes{
    ReliefSize{field::relief_depth, &RelievedShaftSizes::depth, &RelievedShaft::depth},
    ReliefSize{field::relief_length, &RelievedShaftSizes::length, &RelievedShaft::length},
    ReliefSize{field::bar_diameter, &RelievedShaftSizes::diameter, &RelievedShaft::diameter}};

/// Of the whole bar drawn on each side of the relief.
double stubOf(const RelievedShaft& shaft) {
    return shaft.diameter / 2.0;
}

double flatOf(const RelievedShaft& shaft) {
    return shaft.diameter / 2.0 - shaft.depth;
}

/// Degrees from the middle of what was cut off to the flat's corner.
double flatAngle(const RelievedShaft& shaft) {
    return std::atan2(flatOf(shaft), shaft.half_width) / degree;
}

QRectF circleOf(const RelievedShaft& shaft) {
    const double radius = shaft.diameter / 2.0;
    return {-radius, -radius, 2.0 * radius, 2.0 * radius};
}

/// The section about its middle, m, y down.
QPainterPath sectionOf(const RelievedShaft& shaft) {
    const double angle = flatAngle(shaft);
    QPainterPath section;
    section.arcMoveTo(circleOf(shaft), 180.0 - angle);
    section.arcTo(circleOf(shaft), 180.0 - angle, 180.0 + 2.0 * angle);
    section.closeSubpath();
    return section;
}

/// The side view about its middle, likewise.
QPainterPath sideOf(const RelievedShaft& shaft) {
    const double radius = shaft.diameter / 2.0;
    const double flat = flatOf(shaft);
    const double end = shaft.length / 2.0;
    const double outer = end + stubOf(shaft);
    QPainterPath side;
    side.addPolygon(QPolygonF{QPointF(-outer, radius), QPointF(outer, radius),
                              QPointF(outer, -radius), QPointF(end, -radius), QPointF(end, -flat),
                              QPointF(-end, -flat), QPointF(-end, -radius),
                              QPointF(-outer, -radius)});
    side.closeSubpath();
    return side;
}

/// Section and side view of a shaft with a relieved middle, to scale, with its main sizes; dashed,
/// the reference's.
class RelievedShaftDrawing : public ComparedFigure {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::RelievedShaftDrawing)

  public:
    RelievedShaftDrawing(BalanceShaftModel* model, QWidget* parent);

    QSize sizeHint() const override { return {600, 220}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void follow();

    BalanceShaftModel* model_;
};

RelievedShaftDrawing::RelievedShaftDrawing(BalanceShaftModel* model, QWidget* parent)
    : ComparedFigure(parent), model_(model) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Drawing of the shaft with a relieved middle"));
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    connect(model, &SceneModel::changed, this, &RelievedShaftDrawing::follow);
    followReference(model);
    follow();
}

void RelievedShaftDrawing::follow() {
    const RelievedShaft& shaft = model_->result().relieved_shaft;
    const auto mm = [](double metres) { return shownNumber(metres, units::mm, 1); };
    setAccessibleDescription(shaft.half_width > 0.0
                                 ? tr("Bar of %1, its middle cut %2 deep over %3.")
                                       .arg(mm(shaft.diameter), mm(shaft.depth), mm(shaft.length))
                                 : tr("No shaft of these sizes"));
    update();
}

void RelievedShaftDrawing::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& theme = Theme::instance();
    painter.fillRect(rect(), theme.panel());
    painter.setFont(Theme::font(Theme::smallSize));
    const RelievedShaft own = model_->result().relieved_shaft;
    if (!(own.half_width > 0.0)) {
        painter.setPen(theme.mutedText());
        painter.drawText(rect(), Qt::AlignCenter, tr("No shaft of these sizes"));
        return;
    }
    std::vector<RelievedShaft> shown{own};
    if (const BalanceShaftModel* other = referenceOf(model_)) {
        if (other->result().relieved_shaft.half_width > 0.0) {
            shown.push_back(other->result().relieved_shaft);
        }
    }
    double radius = 0.0;  // the larger
    double half = 0.0;    // of the longer side view
    for (const RelievedShaft& each : shown) {
        radius = std::max(radius, each.diameter / 2.0);
        half = std::max(half, each.length / 2.0 + stubOf(each));
    }
    // Section at the left, a gap of one diameter, the side view.
    const double wide = 4.0 * radius + 2.0 * half;
    const double row = painter.fontMetrics().height();
    const double axes = 8.0;  // of the section, beyond it
    const double margin = axes + 12.0 + row;
    const double scale =
        std::min((width() - 2.0 * margin) / wide, (height() - 2.0 * margin) / (2.0 * radius));
    if (scale <= 0.0) {
        return;
    }
    const QPointF section((width() - wide * scale) / 2.0 + radius * scale, height() / 2.0);
    const QPointF side(section.x() + (3.0 * radius + half) * scale, section.y());
    const auto map = [scale](const QPointF& middle) {
        return QTransform::fromScale(scale, scale) *
               QTransform::fromTranslate(middle.x(), middle.y());
    };
    const auto at = [scale](const QPointF& middle, double x, double y) {
        return middle + QPointF(x * scale, -y * scale);
    };
    const QPen outline(theme.text(), 1.6);
    const QPen axis(theme.mutedText(), 1.0, Qt::DashDotLine);
    const QPen removed(theme.colour(Role::Shaft), 1.2, Qt::DashLine);
    QColor steel = theme.colour(Role::Neutral);
    steel.setAlpha(60);

    painter.setPen(outline);
    painter.setBrush(steel);
    painter.drawPath(map(section).map(sectionOf(own)));
    painter.drawPath(map(side).map(sideOf(own)));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(removed);
    const double angle = flatAngle(own);
    const double bar = own.diameter / 2.0;
    painter.drawArc(map(section).mapRect(circleOf(own)), static_cast<int>(16 * angle),
                    static_cast<int>(16 * (180 - 2 * angle)));
    painter.drawLine(at(side, -own.length / 2.0, bar), at(side, own.length / 2.0, bar));
    painter.setPen(axis);
    const double cross = bar + axes / scale;
    painter.drawLine(at(section, -cross, 0.0), at(section, cross, 0.0));
    painter.drawLine(at(section, 0.0, cross), at(section, 0.0, -cross));
    const double reach = own.length / 2.0 + 1.2 * stubOf(own);
    painter.drawLine(at(side, -reach, 0.0), at(side, reach, 0.0));
    // Centre of mass.
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.accent());
    painter.drawEllipse(at(section, 0.0, -own.centre_of_mass_radius), 3.5, 3.5);

    // The reference, about the same middles.
    if (shown.size() > 1) {
        painter.setPen(QPen(theme.mutedText(), 1.2, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(map(section).map(sectionOf(shown[1])));
        painter.drawPath(map(side).map(sideOf(shown[1])));
        painter.setPen(theme.mutedText());
        painter.drawText(QPointF(8.0, painter.fontMetrics().ascent() + 4.0),
                         QStringLiteral("- - ") + referenceName());
    }

    // Sizes.
    painter.setPen(theme.text());
    const auto mm = [](double metres) { return shownNumber(metres, units::mm, 1); };
    const QPointF below(0.0, axes + 4.0 + row / 2.0);
    const QPointF above = -below;
    drawing::drawCentred(painter, at(section, 0.0, -radius) + below,
                         QStringLiteral("⌀ ") + mm(own.diameter));
    drawing::drawCentred(painter, at(section, 0.0, radius) + above,
                         QStringLiteral("h ") + mm(own.depth));
    drawing::drawCentred(painter, at(side, 0.0, radius) + above,
                         QStringLiteral("b ") + mm(own.length));
}

}  // namespace

RelievedShaftView::RelievedShaftView(BalanceShaftModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    QVBoxLayout* column = columnIn(this, Theme::space, tabMargins);
    constexpr int pairWidth = 540;
    auto* upper = new FoldingRow(pairWidth, this);
    column->addWidget(upper, 1);
    upper->add(buildForm(), 4);

    auto* answerPanel = new Panel(this);
    QVBoxLayout* answerColumn = columnIn(answerPanel, -1, tableMargins);
    verdict_ = new PartText(model, "relief-verdict", answerPanel);
    answerColumn->addWidget(verdict_);
    answerColumn->addWidget(
        new PartTable(model, "relief", tr("Sizes and masses of the shaft"), answerPanel), 1);
    upper->add(answerPanel, 5);  // whole names beside the numbers

    auto* drawing = new RelievedShaftDrawing(model, this);
    constexpr int minDrawing = 150;
    drawing->setMinimumHeight(Theme::withText(minDrawing));
    column->addWidget(drawing, 1);

    connect(model, &SceneModel::changed, this, &RelievedShaftView::showFeasible);
    showFeasible();
}

QWidget* RelievedShaftView::buildForm() {
    auto* panel = new Panel(this);
    QVBoxLayout* column = columnIn(panel, -1, {0, 0, 0, Theme::space});
    auto* form = new Form(model_, panel);
    form->section(tr("Shaft with a relieved middle"));
    addSizes(form);
    form->column()->addStretch();
    column->addWidget(form, 1);
    export_ = new QPushButton(tr("E&xport drawing (DXF)…"), panel);
    export_->setToolTip(tr("Section and side view, real size, for the machine shop"));
    connect(export_, &QPushButton::clicked, this, [this] {
        if (continueWithoutRejected(this, tr("Export drawing"))) {
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
    row->addWidget(export_);
    column->addLayout(row);
    return panel;
}

void RelievedShaftView::addSizes(Form* form) {
    const auto given = [this] { return balance_shaft::relieved_shaft_sizes(model_->input()); };
    const auto set = [this](const QString& step, const auto& change) {
        model_->edit(step, [&](Input& input) {
            input.relieved_shaft = balance_shaft::relieved_shaft_sizes(input);
            change(*input.relieved_shaft);
        });
    };
    const auto find = [this, set](int sought) {
        set(tr("Size to find"), [this, sought](RelievedShaftSizes& next) {
            RelievedShaft found = model_->result().relieved_shaft;
            found.depth = found.depth > 0.0 ? found.depth : found.diameter / 4.0;
            for (int i = 0; const ReliefSize& size : reliefSizes) {
                auto& kept = next.*size.given;
                kept = i++ == sought                      ? std::nullopt
                       : !kept && found.*size.found > 0.0 ? std::optional(found.*size.found)
                                                          : kept;
            }
        });
    };
    form->choice(
            {}, tr("&Find"),
            {tr("depth h"), tr("length b"), tr("diameter D"), tr("none, check only")},
            tr("Enter two sizes; the third follows from the unbalance m₁ ρ₁."),
            [given] {
                return static_cast<int>(std::ranges::find_if(reliefSizes,
                                                             [&](const ReliefSize& size) {
                                                                 return !(given().*size.given);
                                                             }) -
                                        reliefSizes.begin());
            },
            find)
        ->setAccessibleName(tr("Computed size"));
    for (const std::size_t i : {2U, 0U, 1U}) {
        const ReliefSize& size = reliefSizes[i];
        NumberField* number = form->number(
            size.field,
            [this, given, &size] {
                const double metres =
                    (given().*size.given).value_or(model_->result().relieved_shaft.*size.found);
                return metres > 0.0 ? std::optional(metres) : std::nullopt;
            },
            [set, &size](std::optional<double> value) {
                set(fieldName(size.field),
                    [&](RelievedShaftSizes& next) { next.*size.given = value; });
            });
        form->follow(
            [given, number, &size] { number->setEnabled((given().*size.given).has_value()); });
        number->setDigits(6);  // a size that was found has more than fit
    }
    form->number(
        field::density, [given] { return given().density; },
        [set](std::optional<double> value) {
            set(fieldName(field::density),
                [&](RelievedShaftSizes& next) { next.density = *value; });
        });
}

void RelievedShaftView::showFeasible() {
    const bool isFeasible = model_->result().relieved_shaft.feasible;
    colourText(verdict_, isFeasible ? &Theme::text : &Theme::warning);
    export_->setEnabled(isFeasible);
}

}  // namespace ravnoves
