#include "balance-shaft/shaft_tabs.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedLayout>
#include <cmath>
#include <limits>

#include "balance-shaft/fields.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "page/mechanism_picture.h"
#include "page/part_views.h"
#include "text/message_text.h"
#include "theme/theme.h"
#include "widgets/form.h"
#include "widgets/layouts.h"
#include "widgets/panel.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using balance_shaft::FlywheelTarget;
namespace field = balance_shaft::field;

ShaftTabs::ShaftTabs(BalanceShaftModel* model, QWidget* parent)
    : FittedTabs(parent), model_(model) {
    setDocumentMode(true);
    const auto add = [this](QWidget* view, const char* name, const QString& title) {
        addScrolledTab(this, view, QString::fromLatin1(name), title);
    };
    beginGroup(tr("Design"));
    add(buildMoments(), "moments", tr("Moments"));
    add(buildMap(), "map", tr("Map"));
    add(buildSpeed(), "speed", tr("Speed"));
    add(buildSize(), "envelope", tr("Size"));
    beginGroup(tr("Analysis"));
    add(buildCycle(), "cycle", tr("Cycle"));
    add(buildOrders(), "orders", tr("Orders"));
    add(buildFlywheel(), "flywheel", tr("Flywheel"));
    add(buildForces(), "forces", tr("Forces"));
    beginGroup(tr("Part"));
    add(buildRelief(), "relieved", tr("Relief"));
}

PartPlot* ShaftTabs::addCyclePlot(std::string_view part, QWidget* parent) {
    PartPlot* plot = new PartPlot(model_, part, parent);
    showCrankAngle(plot, model_->crank());
    return plot;
}

PartPlot* ShaftTabs::addAnglePlot(std::string_view part, QWidget* parent) {
    PartPlot* plot = new PartPlot(model_, part, parent);
    plot->setPickable(true);
    connect(plot, &PlotView::picked, model_, &BalanceShaftModel::pickShaftAngleDeg);
    return plot;
}

QWidget* ShaftTabs::addTable(std::string_view part, const QString& name, QWidget* parent) {
    auto* panel = new Panel(parent);
    QVBoxLayout* column = columnIn(panel, -1, tableMargins);
    column->addWidget(new PartTable(model_, part, name, panel));
    return panel;
}

QWidget* ShaftTabs::buildMoments() {
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder, Theme::space, tabMargins);
    column->addWidget(addCyclePlot("moments", holder), 5);
    column->addWidget(addAnglePlot("range", holder), 4);
    return holder;
}

QWidget* ShaftTabs::buildCycle() {
    auto* holder = new QWidget(this);
    auto* stack = new QStackedLayout(holder);
    auto* empty = new QWidget(holder);
    QVBoxLayout* emptyColumn = columnIn(empty, Theme::space);
    auto* hint =
        new QLabel(tr("The torque is a table. A pressure trace or a computed cycle shows gas and "
                      "inertia torque, pressure and indicator diagram."),
                   empty);
    hint->setAlignment(Qt::AlignCenter);
    hint->setWordWrap(true);
    hint->setMargin(Theme::margin * 3);
    auto* compute = new QPushButton(tr("&Compute a cycle of the same load"), empty);
    compute->setObjectName(QStringLiteral("compute_cycle"));
    connect(compute, &QPushButton::clicked, model_,
            [this] { model_->setTorqueKind(balance_shaft::TorqueSource::Kind::cycle); });
    emptyColumn->addStretch();
    emptyColumn->addWidget(hint);
    emptyColumn->addWidget(compute, 0, Qt::AlignCenter);
    emptyColumn->addStretch();
    stack->addWidget(empty);
    auto* plots = new QWidget(holder);
    auto* grid = new QGridLayout(plots);
    grid->setContentsMargins({});
    grid->setSpacing(Theme::space);
    grid->addWidget(addCyclePlot("torque", plots), 0, 0, 1, 2);
    grid->addWidget(addCyclePlot("pressure", plots), 1, 0);
    grid->addWidget(new PartPlot(model_, "indicator", plots), 1, 1);
    grid->addWidget(addTable("cycle", tr("Work, pressures and power of the cycle"), plots), 2, 0, 1,
                    2);
    grid->setRowStretch(0, 3);
    grid->setRowStretch(1, 3);
    stack->addWidget(plots);
    const auto choose = [this, stack] {
        stack->setCurrentIndex(model_->result().indicated ? 1 : 0);
    };
    connect(model_, &SceneModel::changed, holder, choose);
    choose();
    return holder;
}

QWidget* ShaftTabs::buildSize() {
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder, Theme::space, tabMargins);
    PartPlot* sizes = addAnglePlot("sizes", holder);
    column->addWidget(sizes, 2);
    PartPlot* range = new PartPlot(model_, "range-over-size", holder);
    range->setPickable(true);
    connect(range, &PlotView::pickedAt, this, [this, range](double area, double moment) {
        // Of the whole turn: its end is its beginning.
        const std::vector<double>& angles = model_->envelopeStudy().shaft_angle_deg;
        const std::size_t nearest = nearestPoint(*range, "all", area, moment);
        model_->setShaftAngleDeg(angles[nearest % angles.size()]);
    });
    column->addWidget(range, 3);
    for (PartPlot* plot : {sizes, range}) {
        plot->setToolTip(
            tr("Size of the box around cylinder, crank and shaft circles, "
               "gears and wall; click a chart to set α."));
    }
    return holder;
}

QWidget* ShaftTabs::buildOrders() {
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder, Theme::space, tabMargins);
    column->addWidget(new PartPlot(model_, "orders", holder), 3);
    auto* panel = new Panel(holder);
    QVBoxLayout* inside = columnIn(panel, -1, tableMargins);
    inside->addWidget(captionLabel(tr("A shaft at crank speed changes only order 1; "
                                      "the RMS is minimal where the shaft opposes it."),
                                   panel));
    auto* table = new PartTable(model_, "order-table", tr("Order spectrum"), panel);
    table->setShownRows(5);
    inside->addWidget(table);
    column->addWidget(panel, 2);
    return holder;
}

QWidget* ShaftTabs::buildFlywheel() {
    auto* holder = new QWidget(this);
    QVBoxLayout* column = columnIn(holder, Theme::space, tabMargins);
    column->addWidget(addCyclePlot("energy", holder), 3);
    constexpr int pairWidth = 600;
    auto* lower = new FoldingRow(pairWidth, holder);
    auto* formPanel = new Panel(lower);
    columnIn(formPanel)->addWidget(buildFlywheelForm(formPanel));
    lower->add(formPanel);
    QWidget* answer =
        addTable("flywheel", tr("Excess work, fluctuation and moment of inertia"), lower);
    static_cast<QVBoxLayout*>(answer->layout())->addStretch();
    lower->add(answer);
    column->addWidget(lower, 2);
    return holder;
}

Form* ShaftTabs::buildFlywheelForm(QWidget* parent) {
    auto* form = new Form(model_, parent);
    FormSection* section = form->section(tr("Flywheel"));
    for (const auto& [given, value] :
         {std::pair(&field::flywheel_inertia, &FlywheelTarget::inertia),
          std::pair(&field::fluctuation, &FlywheelTarget::fluctuation)}) {
        NumberField* number = form->number(
            *given,
            [this, value = value] {
                return model_->input().flywheel.value_or(FlywheelTarget{}).*value;
            },
            [this, value = value](std::optional<double> typed) {
                model_->setFlywheel(value, typed);
            });
        number->setOptional(true);
        number->setDigits(6);
        showAssumed(form, number, [this, given = given]() -> std::optional<double> {
            const balance_shaft::Flywheel& wheel = model_->result().flywheel;
            return given == &field::fluctuation ? wheel.fluctuation : wheel.inertia;
        });
    }
    section->addWide(captionLabel(tr("The load equals the mean torque; J excludes piston and "
                                     "rod, whose inertia is part of the torque."),
                                  form));
    form->column()->addStretch();
    return form;
}

QWidget* ShaftTabs::buildForces() {
    auto* holder = new QWidget(this);
    auto* grid = new QGridLayout(holder);
    grid->setContentsMargins(0, Theme::space, 0, 0);
    grid->setSpacing(Theme::space);
    constexpr int tablesWidth = 560;  ///< designed pixels of both beside each other
    auto* tables = new FoldingRow(tablesWidth, holder);
    const auto add = [&](int column, Form* form, std::string_view plot, std::string_view table,
                         const QString& name) {
        auto* panel = new Panel(holder);
        columnIn(panel, -1)->addWidget(form);
        grid->addWidget(panel, 0, column);
        grid->addWidget(new PartPlot(model_, plot, holder), 1, column);
        grid->setColumnStretch(column, 1);
        QWidget* answer = addTable(table, name, tables);
        static_cast<QVBoxLayout*>(answer->layout())->addStretch();
        tables->add(answer);
    };
    auto* crank = new Form(model_, holder);  // without a shaft
    FormSection* balanced = crank->section(tr("Balanced on the crank alone"));
    balanced->addWide(new FieldSlider(model_, "/crank_share", {0.0, 1.0, 0.01, 0.1, 2}, crank));
    crank->column()->addStretch();
    add(0, crank, "force-locus", "forces", tr("Forces with and without a shaft"));
    auto* gears = new Form(model_, holder);
    gears->section(tr("Gears"));
    for (const char* place : {"/gears/teeth", "/gears/shifted_teeth", "/gears/backlash_mm"}) {
        gears->number(place);
    }
    add(1, gears, "gear-moment", "gears", tr("Effect of gear error and play"));
    grid->addWidget(tables, 2, 0, 1, 2);
    grid->setRowStretch(1, 1);
    constexpr int chartHeight = 230;  ///< designed pixels with which their curves are read
    grid->setRowMinimumHeight(1, Theme::withText(chartHeight));
    return holder;
}

void enableWhereFeasible(QPushButton& button, const balance_shaft::BuildableAngles& angles) {
    button.setEnabled(!angles.stretches.empty());
    button.setToolTip(button.isEnabled() ? button.accessibleName() : messageText(angles.reason));
}

std::size_t nearestPoint(const PlotView& plot, std::string_view curve, double x, double y) {
    const PlotCurve& points = plot.data().curves[*plot.data().find(curve)];
    const QPointF place = plot.toPixel(x, y);
    std::size_t nearest = 0;
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.x.size(); ++i) {
        const QPointF away = plot.toPixel(points.x[i], points.y[i]) - place;
        if (const double distance = std::hypot(away.x(), away.y()); distance < minimum) {
            minimum = distance;
            nearest = i;
        }
    }
    return nearest;
}

}  // namespace ravnoves
