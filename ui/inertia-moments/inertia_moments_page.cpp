#include "inertia-moments/inertia_moments_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSlider>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "inertia-moments/crank_views.h"
#include "inertia-moments/cylinder_editor.h"
#include "inertia-moments/engine_view.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "inertia-moments/order_bars.h"
#include "inertia-moments/presets.h"
#include "inertia-moments/shaft_editor.h"
#include "inertia-moments/shaft_view.h"
#include "text/number_text.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using inertia_moments::EndWebs;
using inertia_moments::EngineOrder;
using inertia_moments::Input;
using inertia_moments::Layout;
using inertia_moments::Result;
using inertia_moments::RigidRod;
using inertia_moments::RotatingPair;
using inertia_moments::WrenchCurves;
namespace field = inertia_moments::field;

namespace {

using Tabs = InertiaMomentsModel::Tabs;

constexpr double crankStep = 1.0;
constexpr int plotStep = 3;        // degrees between the points of one order
constexpr int cycleDegrees = 720;  // the paper's Fig. 6 shows two turns

// Curves of the moment plots, in the order in which they are added.
enum MomentCurve {
    verticalTwoTerm,  // below the exact ones, so that it shows where it differs
    horizontalTwoTerm,
    vertical,
    horizontal,
    verticalLeft,
    horizontalLeft
};

QWidget* scrolled(QWidget* form, QWidget* parent) {
    auto* scroll = new QScrollArea(parent);
    scroll->setWidget(form);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return scroll;
}

QVBoxLayout* formColumn(QWidget* form) {
    auto* column = new QVBoxLayout(form);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column->setSpacing(Theme::gap);
    return column;
}

/// The ellipse that a rotating pair runs round.
void traceOrder(const RotatingPair& pair, std::vector<double>& x, std::vector<double>& y) {
    constexpr int points = 96;
    x.resize(points + 1);
    y.resize(points + 1);
    for (int i = 0; i <= points; ++i) {
        const auto p = pair.at(two_pi * (i % points) / points);
        x[static_cast<std::size_t>(i)] = p.real();
        y[static_cast<std::size_t>(i)] = p.imag();
    }
}

/// Curves of one turn, shown over two.
std::vector<double> twice(const std::vector<double>& turn) {
    std::vector<double> both(turn);
    both.insert(both.end(), turn.begin() + 1, turn.end());
    return both;
}

double reachOf(const std::vector<double>& x, const std::vector<double>& y) {
    double reach = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        reach = std::max({reach, std::abs(x[i]), std::abs(y[i])});
    }
    return reach;
}

/// The next 1, 2, 3, 5 or 6 times a power of ten: reaches that small plots have round ticks for.
double niceReach(double value) {
    if (!(value > 0.0) || !std::isfinite(value)) {
        return 1.0;
    }
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 3.0, 5.0, 6.0}) {
        if (value <= step * power) {
            return step * power;
        }
    }
    return 10.0 * power;
}

}  // namespace

InertiaMomentsPage::InertiaMomentsPage(QWidget* parent)
    : ScenePage(parent), model_(new InertiaMomentsModel(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    row->setSpacing(Theme::space);
    row->addWidget(buildInputs());
    // The sliders over plots and picture: they need length.
    auto* right = new QVBoxLayout;
    right->setSpacing(Theme::space);
    right->addWidget(buildSliders());
    auto* lower = new QHBoxLayout;
    lower->setSpacing(Theme::space);
    lower->addWidget(buildPlots(), 5);
    lower->addWidget(buildAnswer(), 3);
    right->addLayout(lower, 1);
    row->addLayout(right, 1);

    playAction_ = new QAction(themedIcon(QStringLiteral("play")), tr("&Play"), this);
    playAction_->setToolTip(tr("Turn the crank"));
    connect(playAction_, &QAction::triggered, this,
            [this] { picture_->setPlaying(!picture_->isPlaying()); });
    shaftsAction_ = new QAction(themedIcon(QStringLiteral("best")), tr("&Shafts on or off"), this);
    shaftsAction_->setToolTip(tr("Switch all balance shafts on, or off when all are on"));
    connect(shaftsAction_, &QAction::triggered, this, [this] {
        const auto& shafts = model_->input().shafts;
        const bool all = std::all_of(shafts.begin(), shafts.end(),
                                     [](const auto& shaft) { return shaft.enabled; });
        model_->edit(all ? tr("All shafts off") : tr("All shafts on"), [all](Input& input) {
            for (auto& shaft : input.shafts) {
                shaft.enabled = !all;
            }
        });
        model_->finishDrag();
    });
    connect(picture_, &EngineView::playingChanged, this, [this](bool playing) {
        const QIcon icon = themedIcon(playing ? QStringLiteral("pause") : QStringLiteral("play"));
        playAction_->setIcon(icon);
        playAction_->setText(playing ? tr("&Pause") : tr("&Play"));
        playButton_->setIcon(icon);
        playButton_->setToolTip(playing ? tr("Pause (Space)") : tr("Play (Space)"));
    });

    connect(model_, &SceneModel::changed, this, &InertiaMomentsPage::showInput);
    connect(model_, &SceneModel::changed, this, &InertiaMomentsPage::showResult);
    connect(model_, &InertiaMomentsModel::crankAngleChanged, this, &InertiaMomentsPage::showCursor);
    connect(model_, &InertiaMomentsModel::refused, this, [this](const QString& why) {
        Q_EMIT status(why);
        showSliders();  // a slider that went too far comes back
    });
    connect(model_, &InertiaMomentsModel::tabChanged, this, [this](Tabs group, int index) {
        QTabWidget* tabs = group == Tabs::Inputs   ? inputs_
                           : group == Tabs::Charts ? charts_
                                                   : answer_;
        tabs->setCurrentIndex(index);
        showCharts();
        showAnswer();
    });

    showInput();
    showResult();
    showCursor(model_->crankAngleDeg());
}

SceneModel* InertiaMomentsPage::model() {
    return model_;
}

QList<QAction*> InertiaMomentsPage::sceneActions() {
    return {playAction_, shaftsAction_};
}

void InertiaMomentsPage::bind(NumberField* numberField, std::function<std::optional<double>()> read,
                              std::function<void(std::optional<double>)> write) {
    connect(numberField, &NumberField::valueEdited, this, std::move(write));
    bindings_.push_back({numberField, std::move(read)});
}

// -------------------------------------------------------------------------------------- inputs

QWidget* InertiaMomentsPage::buildInputs() {
    inputs_ = new QTabWidget(this);
    inputs_->setDocumentMode(true);
    inputs_->setFixedWidth(300);
    inputs_->addTab(scrolled(buildEngineForm(), inputs_), tr("Engine"));
    cylinders_ = new CylinderEditor(model_, inputs_);
    inputs_->addTab(cylinders_, tr("Cylinders"));
    inputs_->addTab(scrolled(buildBalancingForm(), inputs_), tr("Balancing"));
    connect(inputs_, &QTabWidget::currentChanged, this,
            [this](int index) { model_->setTab(Tabs::Inputs, index); });
    return inputs_;
}

QWidget* InertiaMomentsPage::buildEngineForm() {
    auto* form = new QWidget;
    QVBoxLayout* column = formColumn(form);
    const auto number = [this](NumberField* target, const QString& name, const FieldSpec& spec,
                               double Input::*member) {
        bind(
            target, [this, &spec, member] { return from_si(spec, model_->input().*member); },
            [this, name, &spec, member](std::optional<double> value) {
                model_->edit(name, [&](Input& input) { input.*member = *value * spec.to_si; });
            });
    };

    auto* layout = new FormSection(tr("Layout"), form);
    layout_ = new QComboBox(form);
    for (const QString& name : InertiaMomentsModel::layoutNames()) {
        layout_->addItem(model_->layoutTitle(name), name);
    }
    layout_->setMaxVisibleItems(24);
    layout_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    layout_->setMinimumContentsLength(14);
    layout_->setObjectName(QStringLiteral("layout"));
    layout->addWidget(tr("Cylinder la&yout"), layout_, {},
                      tr("A layout of the library, the paper's engine, or your own table"));
    connect(layout_, &QComboBox::activated, this, [this](int index) {
        model_->chooseLayout(layout_->itemData(index).toString());
        showInput();
    });
    firingOrder_ = new QLineEdit(form);
    firingOrder_->setObjectName(QStringLiteral("firing_order"));
    layout->addWidget(tr("&Firing order"), firingOrder_, {},
                      tr("Numbers of the cylinders, for example 1-2-4-5-3. Layouts with crankpins "
                         "for even firing follow it."));
    firingTrouble_ = captionLabel({}, form);
    firingTrouble_->hide();
    layout->addWide(firingTrouble_);
    connect(firingOrder_, &QLineEdit::textEdited, this, [this](const QString& text) {
        const QString trouble = model_->setFiringOrderText(text);
        QPalette palette = firingTrouble_->palette();
        palette.setColor(QPalette::WindowText, Theme::instance().error());
        firingTrouble_->setPalette(palette);
        firingTrouble_->setText(trouble);
        firingTrouble_->setVisible(!trouble.isEmpty());
    });
    connect(firingOrder_, &QLineEdit::editingFinished, this, [this] {
        model_->finishDrag();
        if (firingTrouble_->text().isEmpty()) {
            firingOrder_->setText(model_->firingOrderText());
        }
    });
    column->addWidget(layout);

    sizes_ = new FormSection({}, form);
    const auto size = [this](const QString& label, const FieldSpec& spec, const QString& hint,
                             const QString& name, double Layout::*member) {
        auto* target = sizes_->addNumber(label, spec, hint);
        bind(
            target,
            [this, &spec, member]() -> std::optional<double> {
                const auto& layout = model_->input().layout;
                return layout ? std::optional(from_si(spec, (*layout).*member)) : std::nullopt;
            },
            [this, name, &spec, member](std::optional<double> value) {
                model_->edit(name, [&](Input& input) {
                    if (input.layout) {
                        (*input.layout).*member = *value * spec.to_si;
                    }
                });
            });
    };
    size(tr("&Spacing a"), field::spacing,
         tr("Between neighbouring crankpins (in V engines: throws) along the crank. Volkswagen "
            "VR5: 63 mm."),
         tr("Spacing"), &Layout::spacing);
    size(tr("Sta&gger"), field::stagger,
         tr("From bank 1's cylinder to bank 2's at the same throw, along the crank. 0 where the "
            "rods are forked."),
         tr("Stagger"), &Layout::stagger);
    size(tr("&Position of cylinder 1"), field::first_position,
         tr("Axial position z of cylinder 1. Volkswagen VR5: 3 a + l_cm = 204.8 mm, with the "
            "centre of mass at z = 0."),
         tr("Position of cylinder 1"), &Layout::first_position);
    column->addWidget(sizes_);

    auto* engine = new FormSection(tr("Crank gear"), form);
    number(engine->addNumber(tr("&Crank radius R"), field::crank_radius,
                             tr("Half the stroke (a little less with offset). Volkswagen VR5: "
                                "45 mm.")),
           tr("Crank radius"), field::crank_radius, &Input::crank_radius);
    number(engine->addNumber(tr("&λ = R / L"), field::lambda,
                             tr("Crank radius over rod length. Volkswagen VR5: 0.265. The crank "
                                "turns where λ (1 + |e|/R) < 1.")),
           tr("λ"), field::lambda, &Input::lambda);
    rodLength_ = engine->addResult(tr("Rod length L"), tr("R / λ"));
    deadCentre_ = engine->addResult(tr("φ at TDC"),
                                    tr("Top dead centre: arcsin(λK/(1 + λ)), from the cylinder's "
                                       "axis on the side of its offset. Volkswagen "
                                       "VR5: 3°20′."));
    number(engine->addNumber(tr("Re&ciprocating mass"), field::reciprocating_mass,
                             tr("Of one cylinder: piston with pin and rings, and the rod's share "
                                "unless the rod is a rigid body below. Volkswagen VR5: 0.622 kg.")),
           tr("Reciprocating mass"), field::reciprocating_mass, &Input::reciprocating_mass);
    number(engine->addNumber(tr("R&otating mass"), field::rotating_mass,
                             tr("Of one throw, reduced to the crank radius: unbalanced part of "
                                "the throw and the rod's share unless the rod is a rigid body.")),
           tr("Rotating mass"), field::rotating_mass, &Input::rotating_mass);
    column->addWidget(engine);

    rigidRod_ = new QCheckBox(tr("&Rod as a rigid body"), form);
    rigidRod_->setObjectName(QStringLiteral("rigid_rod"));
    rigidRod_->setToolTip(
        tr("Off: the rod's two shares are in the masses above. On: mass, centre and inertia are "
           "given; its shares are added, and what its inertia differs from two masses acts on "
           "roll moment and torque."));
    connect(rigidRod_, &QCheckBox::clicked, this, [this](bool on) {
        model_->edit(tr("Rigid rod"), [on](Input& input) {
            if (on) {
                // As two masses would be: a third of the length from the big end.
                const double length = input.rod_length();
                const double mass = 0.8 * input.reciprocating_mass;
                input.rod = RigidRod{mass, length / 3.0, mass * length * length * 2.0 / 9.0};
            } else {
                input.rod.reset();
            }
        });
        model_->finishDrag();
    });
    column->addWidget(rigidRod_);
    rod_ = new FormSection({}, form);
    const auto rodNumber = [this](const QString& label, const FieldSpec& spec, const QString& hint,
                                  double RigidRod::*member) {
        auto* target = rod_->addNumber(label, spec, hint);
        target->setObjectName(QStringLiteral("rod_") + target->objectName());
        target->setDigits(6);
        bind(
            target,
            [this, &spec, member]() -> std::optional<double> {
                const auto& rod = model_->input().rod;
                return rod ? std::optional(from_si(spec, (*rod).*member)) : std::nullopt;
            },
            [this, &spec, member](std::optional<double> value) {
                model_->edit(tr("Rod"), [&](Input& input) {
                    if (input.rod) {
                        (*input.rod).*member = *value * spec.to_si;
                    }
                });
            });
    };
    rodNumber(tr("Rod &mass"), field::rod_mass, tr("Whole rod"), &RigidRod::mass);
    rodNumber(tr("Centre from &big end"), field::rod_centre,
              tr("Centre of mass, from the big end towards the small end"),
              &RigidRod::centre_from_big_end);
    rodNumber(tr("&Inertia"), field::rod_inertia, tr("About its centre of mass"),
              &RigidRod::inertia);
    column->addWidget(rod_);
    column->addStretch();
    return form;
}

QWidget* InertiaMomentsPage::buildBalancingForm() {
    auto* form = new QWidget;
    QVBoxLayout* column = formColumn(form);

    auto* shafts = new FormSection(tr("Balance shafts"), form);
    basis_ = new QComboBox(form);
    basis_->setObjectName(QStringLiteral("shaft_basis"));
    basis_->addItems({tr("exact orders"), tr("two-term form")});
    shafts->addWidget(tr("&Designed for"), basis_, {},
                      tr("The paper designs its shafts for the two-term form; what they leave of "
                         "the exact order is then what the two-term form leaves out."));
    connect(basis_, &QComboBox::activated, this, [this](int index) {
        model_->edit(tr("Design of the shafts"), [index](Input& input) {
            input.shaft_basis = index == 0 ? inertia_moments::DesignBasis::exact
                                           : inertia_moments::DesignBasis::two_term;
        });
        model_->finishDrag();
    });
    shafts_ = new ShaftEditor(model_, form);
    shafts->addWide(captionLabel(
        tr("k order, L distance of the weights (mm), ρ their radius (mm), δ error of phase (°)"),
        form));
    shafts->addWide(shafts_);
    auto* add = new QPushButton(tr("&Add shaft"), form);
    add->setObjectName(QStringLiteral("add_shaft"));
    connect(add, &QPushButton::clicked, model_, &InertiaMomentsModel::addShaft);
    shafts->addWide(add);
    column->addWidget(shafts);

    counterweights_ = new QCheckBox(tr("&Counterweights on the end webs"), form);
    counterweights_->setObjectName(QStringLiteral("counterweights"));
    counterweights_->setToolTip(
        tr("Two weights that cancel force and moment of the rotating masses, and a share of the "
           "forward part of the first order"));
    connect(counterweights_, &QCheckBox::clicked, this, [this](bool on) {
        model_->edit(tr("Counterweights"), [&](Input& input) {
            if (!input.end_webs) {
                input.end_webs = inertia_moments::usual_end_webs(model_->result().engine.cylinders,
                                                                 input.crank_radius);
            }
            input.end_webs->enabled = on;
        });
        model_->finishDrag();
    });
    column->addWidget(counterweights_);
    webs_ = new FormSection({}, form);
    const auto web = [this](const QString& label, const FieldSpec& spec, const QString& hint,
                            double EndWebs::*member) {
        auto* target = webs_->addNumber(label, spec, hint);
        target->setDigits(7);
        const QString name = tr("Counterweights");
        bind(
            target,
            [this, &spec, member]() -> std::optional<double> {
                const auto& webs = model_->input().end_webs;
                return webs ? std::optional(from_si(spec, (*webs).*member)) : std::nullopt;
            },
            [this, name, &spec, member](std::optional<double> value) {
                model_->edit(name, [&](Input& input) {
                    if (input.end_webs) {
                        (*input.end_webs).*member = *value * spec.to_si;
                    }
                });
            });
    };
    web(tr("&Front web at z"), field::front_position, tr("Axial position of the front weight"),
        &EndWebs::front_position);
    web(tr("Front &radius ρ"), field::front_radius, tr("Of the front weight's centre of mass"),
        &EndWebs::front_radius);
    web(tr("R&ear web at z"), field::rear_position, tr("Axial position of the rear weight"),
        &EndWebs::rear_position);
    web(tr("Rear ra&dius ρ"), field::rear_radius, tr("Of the rear weight's centre of mass"),
        &EndWebs::rear_radius);
    web(tr("&Share of order 1"), field::first_order_share,
        tr("Of the forward part of the reciprocating first order; 1 in a cross-plane V8 cancels "
           "it wholly, in a single it is the balance for half the reciprocating mass."),
        &EndWebs::first_order_share);
    column->addWidget(webs_);
    column->addStretch();
    return form;
}

// --------------------------------------------------------------------------------------- plots

QWidget* InertiaMomentsPage::buildSliders() {
    auto* bar = new Panel(this);
    auto* grid = new QGridLayout(bar);
    grid->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    grid->setHorizontalSpacing(2 * Theme::margin);
    grid->setVerticalSpacing(Theme::gap);

    const auto add = [&](ValueSlider* slider, const QString& name, const QString& hint, int row,
                         int column, auto set) {
        slider->slider()->setObjectName(name + QStringLiteral("_slider"));
        slider->box()->setObjectName(name);
        slider->setHint(hint);
        connect(slider, &ValueSlider::valueEdited, model_, set);
        connect(slider, &ValueSlider::released, model_, &InertiaMomentsModel::finishDrag);
        grid->addWidget(slider, row, column);
    };
    bank_ = new ValueSlider(tr("Bank an&gle γ"), 0.0, 180.0, 0.1, 5.0, 1, QStringLiteral("°"), bar);
    add(bank_, QStringLiteral("bank_angle_deg"),
        tr("Between the banks, 0 to 180°. Crankpins for even firing follow it; those of a table "
           "stay, and its bank angles are scaled."),
        0, 0, &InertiaMomentsModel::setBankAngleDeg);
    offset_ = new ValueSlider(tr("O&ffset e"), -50.0, 50.0, 0.01, 1.0, 2, tr("mm"), bar);
    add(offset_, QStringLiteral("offset_mm"),
        tr("Distance of the cylinder axes from the crank axis, as far as the mechanism does not "
           "lock. Of a table: the largest; the others are scaled with it."),
        0, 1, &InertiaMomentsModel::setOffsetMm);
    speed_ = new ValueSlider(tr("Speed &n"), 100.0, 10000.0, 10.0, 500.0, 0, tr("min⁻¹"), bar);
    add(speed_, QStringLiteral("speed_rpm"),
        tr("Crankshaft speed; forces and moments grow with its square."), 1, 0,
        &InertiaMomentsModel::setSpeedRpm);
    reference_ =
        new ValueSlider(tr("Centre of mass &z"), -500.0, 500.0, 0.1, 10.0, 1, tr("mm"), bar);
    add(reference_, QStringLiteral("reference_position_mm"),
        tr("Axial position of the point that moments refer to, in the coordinates of the "
           "cylinders; positive towards cylinder 1."),
        1, 1, &InertiaMomentsModel::setReferenceMm);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    return bar;
}

QWidget* InertiaMomentsPage::buildPlots() {
    auto* holder = new QWidget(this);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(Theme::space);

    for (std::size_t i = 0; i < moments_.size(); ++i) {
        auto* plot = new PlotView(i == 0 ? tr("Order 1") : tr("Order 2"), holder);
        // One below the other: the lower one's axis title serves both.
        plot->setXAxis({i == 0 ? QString() : tr("φ, °"), 0.0, cycleDegrees, true});
        plot->setYAxis(PlotView::Side::Left, {tr("M, N·m")});
        plot->addCurve({.name = tr("My 2-term"),
                        .colour = 6,
                        .width = 1.0,
                        .toolTip = tr("Vertical plane, the paper's formulas (1) and (2), Fig. 6")});
        plot->addCurve(
            {.name = tr("Mx 2-term"),
             .colour = 5,
             .width = 1.0,
             .toolTip = tr("Horizontal plane, the paper's formulas (3) and (4), Fig. 6")});
        plot->addCurve({.name = tr("My"),
                        .colour = 2,
                        .width = 1.8,
                        .toolTip = tr("In the vertical plane, exact")});
        plot->addCurve({.name = tr("Mx"),
                        .colour = 1,
                        .width = 1.8,
                        .toolTip = tr("In the horizontal plane, exact")});
        plot->addCurve({.name = tr("My left"),
                        .colour = 3,
                        .width = 2.2,
                        .toolTip = tr("Vertical plane, with rotating masses and with the "
                                      "counterweights and shafts that are on")});
        plot->addCurve({.name = tr("Mx left"),
                        .colour = 4,
                        .width = 2.2,
                        .toolTip = tr("Horizontal plane, likewise")});
        connect(plot, &PlotView::cursorMoved, model_, &InertiaMomentsModel::setCrankAngleDeg);
        moments_[i] = plot;
        column->addWidget(plot, 4);
    }
    column->addWidget(buildCharts(), 6);
    return holder;
}

QWidget* InertiaMomentsPage::buildCharts() {
    charts_ = new QTabWidget(this);
    charts_->setDocumentMode(true);

    auto* pair = new QWidget(charts_);
    auto* row = new QHBoxLayout(pair);
    row->setContentsMargins(0, Theme::gap, 0, 0);
    row->setSpacing(Theme::space);
    for (std::size_t i = 0; i < hodographs_.size(); ++i) {
        Hodograph& hodograph = hodographs_[i];
        auto* plot = new PlotView(i == 0 ? tr("Forces") : tr("Moments"), pair);
        plot->setEqualScale(true);
        plot->setXAxis({i == 0 ? tr("Fx, N") : tr("Mx, N·m"), -1.0, 1.0});
        plot->setYAxis(PlotView::Side::Left, {i == 0 ? tr("Fy, N") : tr("My, N·m")});
        hodograph.plot = plot;
        hodograph.order1 = plot->addCurve(
            {.name = tr("1st"), .colour = 2, .toolTip = tr("Exact first order (Fig. 5)")});
        hodograph.order2 = plot->addCurve({.name = tr("2nd"),
                                           .colour = 1,
                                           .pen = Qt::DashLine,
                                           .toolTip = tr("Exact second order (Fig. 5)")});
        hodograph.whole = plot->addCurve({.name = tr("all"),
                                          .colour = 0,
                                          .width = 1.2,
                                          .toolTip = tr("All orders of the reciprocating parts")});
        hodograph.left =
            plot->addCurve({.name = tr("left"),
                            .colour = 3,
                            .toolTip = tr("All orders with rotating masses, and with the "
                                          "counterweights and shafts that are on")});
        row->addWidget(plot, 1);
    }
    charts_->addTab(pair, tr("Hodographs"));

    auto* orders = new QWidget(charts_);
    auto* ordersColumn = new QVBoxLayout(orders);
    ordersColumn->setContentsMargins(0, Theme::gap, 0, 0);
    ordersColumn->setSpacing(0);
    bars_ = new OrderBars(model_, orders);
    auto* logarithmic = new QCheckBox(tr("&logarithmic"), bars_);
    logarithmic->setObjectName(QStringLiteral("logarithmic"));
    logarithmic->setToolTip(tr("Six decades, so that the high orders can be seen"));
    connect(logarithmic, &QCheckBox::toggled, bars_, &OrderBars::setLogarithmic);
    auto* corner = new QHBoxLayout(bars_);
    corner->setContentsMargins(0, 1, Theme::space, 0);
    corner->addStretch();
    corner->addWidget(logarithmic, 0, Qt::AlignTop);
    ordersColumn->addWidget(bars_);
    charts_->addTab(orders, tr("Orders"));

    roll_ = new PlotView(tr("Roll moment on the engine"), charts_);
    roll_->setXAxis({tr("φ, °"), 0.0, cycleDegrees, true});
    roll_->setYAxis(PlotView::Side::Left, {tr("N·m")});
    roll_->addCurve({.name = tr("Mz"),
                     .colour = 2,
                     .width = 2.0,
                     .toolTip = tr("Roll moment on the engine: the sum of the two")});
    roll_->addCurve({.name = tr("of offsets and rods"),
                     .colour = 1,
                     .toolTip = tr("Moment of the inertia forces about the crank axis: −Σ e F and "
                                   "the couples of rigid rods")});
    roll_->addCurve({.name = tr("reaction torque"),
                     .colour = 3,
                     .toolTip = tr("Reaction of the inertia torque on the crank, −Σ F ds/dφ")});
    connect(roll_, &PlotView::cursorMoved, model_, &InertiaMomentsModel::setCrankAngleDeg);
    charts_->addTab(roll_, tr("Roll"));
    shaftView_ = new ShaftView(model_, charts_);
    charts_->addTab(shaftView_, tr("Shafts"));
    weightView_ = new CounterweightView(model_, charts_);
    charts_->addTab(weightView_, tr("Weights"));
    firing_ = new FiringWheel(model_, charts_);
    charts_->addTab(firing_, tr("Firing"));
    connect(charts_, &QTabWidget::currentChanged, this, [this](int index) {
        model_->setTab(Tabs::Charts, index);
        showCharts();
    });
    return charts_;
}

// -------------------------------------------------------------------------------------- answer

ResultTable* InertiaMomentsPage::addAnswerTable(const QString& title, const QString& name,
                                                const QStringList& columns) {
    auto* table = new ResultTable(answer_);
    table->setAccessibleName(name);
    table->setColumns(columns);
    table->setMinimumHeight(100);  // long tables scroll
    answer_->addTab(table, title);
    answer_->setTabToolTip(answer_->count() - 1, name);
    tables_.push_back(table);
    return table;
}

QWidget* InertiaMomentsPage::buildAnswer() {
    auto* holder = new QWidget(this);
    holder->setMinimumWidth(332);
    holder->setMaximumWidth(480);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(Theme::space);

    auto* picturePanel = new Panel(holder);
    auto* pictureColumn = new QVBoxLayout(picturePanel);
    pictureColumn->setContentsMargins(1, 1, 1, Theme::gap);
    pictureColumn->setSpacing(0);
    picture_ = new EngineView(model_, picturePanel);
    pictureColumn->addWidget(picture_, 1);
    auto* controls = new QHBoxLayout;
    controls->setContentsMargins(Theme::space, 0, Theme::space, 0);
    playButton_ = new QToolButton(picturePanel);
    playButton_->setIcon(themedIcon(QStringLiteral("play")));
    playButton_->setAutoRaise(true);
    playButton_->setToolTip(tr("Play (Space)"));
    playButton_->setAccessibleName(tr("Play or pause the picture"));
    connect(playButton_, &QToolButton::clicked, this,
            [this] { picture_->setPlaying(!picture_->isPlaying()); });
    controls->addWidget(playButton_);
    crank_ = new ValueSlider(tr("&φ"), 0.0, cycleDegrees, crankStep, 15.0, 0, QStringLiteral("°"),
                             picturePanel);
    crank_->setHint(tr("Crank angle of the picture, from cylinder 1's axis"));
    connect(crank_, &ValueSlider::valueEdited, model_, &InertiaMomentsModel::setCrankAngleDeg);
    controls->addWidget(crank_, 1);
    pictureColumn->addLayout(controls);
    column->addWidget(picturePanel, 5);

    auto* panel = new Panel(holder);
    auto* answerColumn = new QVBoxLayout(panel);
    answerColumn->setContentsMargins(Theme::gap, Theme::gap, Theme::gap, Theme::space);
    answerColumn->setSpacing(Theme::gap);
    answer_ = new QTabWidget(panel);
    answer_->setDocumentMode(true);
    answer_->setUsesScrollButtons(false);
    // Its long tables scroll: the picture has the same share of the height.
    answer_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    addAnswerTable(tr("Orders"), tr("Amplitudes and phases by order and plane"),
                   model_->orderColumns());
    addAnswerTable(tr("±kω"), tr("Forward and backward rotating parts by order"),
                   model_->rotatingColumns());
    addAnswerTable(tr("Shafts"), tr("Balance shafts"), model_->shaftColumns());
    addAnswerTable(tr("Weights"), tr("Rotating masses and counterweights"),
                   model_->weightColumns());
    addAnswerTable(tr("Left"), tr("What is left over, by order"), model_->remainingColumns());
    connect(answer_, &QTabWidget::currentChanged, this, [this](int index) {
        model_->setTab(Tabs::Answer, index);
        showAnswer();
    });
    answerColumn->addWidget(answer_, 1);
    warning_ = captionLabel({}, panel);
    warning_->setContentsMargins(Theme::gap, 0, Theme::gap, 0);
    warning_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    const auto paintWarning = [this] {
        QPalette palette = warning_->palette();
        palette.setColor(QPalette::WindowText, Theme::instance().warning());
        warning_->setPalette(palette);
    };
    paintWarning();
    connect(&Theme::instance(), &Theme::changed, warning_, paintWarning);
    answerColumn->addWidget(warning_);
    column->addWidget(panel, 5);
    return holder;
}

// ---------------------------------------------------------------------------------------- show

void InertiaMomentsPage::showInput() {
    const Input& input = model_->input();
    for (const Binding& binding : bindings_) {
        binding.field->setValue(binding.read());
    }
    const QString name = model_->layoutName();
    int index = layout_->findData(name);
    if (index < 0) {
        // A VR with another number of cylinders, from a case.
        layout_->addItem(model_->layoutTitle(name), name);
        index = layout_->count() - 1;
    }
    layout_->setItemText(index, model_->layoutTitle(name));
    layout_->setCurrentIndex(index);
    sizes_->setVisible(input.layout.has_value());
    if (!firingOrder_->hasFocus()) {
        firingOrder_->setText(model_->firingOrderText());
        firingTrouble_->hide();
        firingTrouble_->clear();
    }
    const QLocale locale;
    rodLength_->setText(fixedNumber(input.rod_length() / field::millimetre, 2, locale) + tr(" mm"));
    deadCentre_->setText(
        fixedNumber(model_->result()
                            .engine.mechanism(model_->result().engine.cylinders.front())
                            .top_dead_centre() /
                        degree,
                    3, locale) +
        QStringLiteral("°"));
    rigidRod_->setChecked(input.rod.has_value());
    rod_->setVisible(input.rod.has_value());
    basis_->setCurrentIndex(input.shaft_basis == inertia_moments::DesignBasis::exact ? 0 : 1);
    counterweights_->setChecked(input.end_webs && input.end_webs->enabled);
    webs_->setVisible(input.end_webs && input.end_webs->enabled);
    showSliders();
}

void InertiaMomentsPage::showSliders() {
    const auto show = [](ValueSlider* slider, double value, double low, double high) {
        if (slider->slider()->isSliderDown()) {
            // Its range rests while it is dragged.
            slider->setValue(value);
            return;
        }
        slider->setRange(std::min(low, value), std::max(high, value));
        slider->setValue(value);
    };
    show(bank_, model_->bankAngleDeg(), model_->input().layout ? 0.0 : 0.1,
         model_->input().layout ? 180.0 : 360.0);
    bank_->setEnabled(model_->canChangeBankAngle());
    const auto [least, most] = model_->offsetLimitsMm();
    show(offset_, model_->offsetMm(), least, most);
    offset_->setEnabled(model_->canChangeOffset());
    show(speed_, model_->speedRpm(), 100.0, 10000.0);
    const auto [rear, front] = model_->referenceLimitsMm();
    show(reference_, model_->referenceMm(), rear, front);
}

void InertiaMomentsPage::showResult() {
    const Result& result = model_->result();
    constexpr auto points = static_cast<std::size_t>(cycleDegrees / plotStep) + 1;
    std::vector<double> angle(points);
    for (std::size_t i = 0; i < points; ++i) {
        angle[i] = static_cast<double>(i) * plotStep;
    }
    // What is nothing but rounding is drawn as nothing.
    const auto set = [&](PlotView* plot, int curveY, int curveX, const RotatingPair& pair,
                         const EngineOrder& order) {
        std::vector<double> x(points, 0.0);
        std::vector<double> y(points, 0.0);
        const bool something = pair.max() > inertia_moments::zero_share * order.moment_scale;
        for (std::size_t i = 0; i < points && something; ++i) {
            const auto vector = pair.at(angle[i] * degree * order.order);
            x[i] = vector.real();
            y[i] = vector.imag();
        }
        plot->setCurve(curveY, angle, std::move(y));
        plot->setCurve(curveX, angle, std::move(x));
        return something;
    };
    for (int k = 1; k <= 2; ++k) {
        PlotView* plot = momentPlot(k);
        const EngineOrder& exact = result.exact.order(k);
        bool something = set(plot, vertical, horizontal, exact.moment, exact);
        set(plot, verticalTwoTerm, horizontalTwoTerm, result.two_term.order(k).moment, exact);
        // Only where something acts on this order.
        const RotatingPair& left = result.remaining.order(k).moment;
        if ((left - exact.moment).max() > inertia_moments::zero_share * exact.moment_scale) {
            something = set(plot, verticalLeft, horizontalLeft, left, exact) || something;
        } else {
            plot->setCurve(verticalLeft, {}, {});
            plot->setCurve(horizontalLeft, {}, {});
        }
        if (something) {
            plot->followData(PlotView::Side::Left);
        } else {
            plot->setYRange(PlotView::Side::Left, -1.0, 1.0);
        }
    }
    showCharts();
    showAnswer();
    warning_->setText(model_->warningText());
    warning_->setVisible(!warning_->text().isEmpty());
}

void InertiaMomentsPage::showCharts() {
    // Only the tab in front; the others follow when they come to the front.
    QWidget* front = charts_->currentWidget();
    if (front == roll_) {
        const WrenchCurves& curves = model_->result().curves;
        std::vector<double> angle(2 * curves.crank_angle.size() - 1);
        for (std::size_t i = 0; i < angle.size(); ++i) {
            angle[i] =
                static_cast<double>(i) * cycleDegrees / static_cast<double>(angle.size() - 1);
        }
        roll_->setCurve(0, angle, twice(curves.roll));
        roll_->setCurve(1, angle, twice(curves.inertia_roll));
        roll_->setCurve(2, angle, twice(curves.reaction_torque));
    } else if (charts_->currentIndex() == 0) {
        showHodograph(hodographs_[0], true);
        showHodograph(hodographs_[1], false);
    }
}

void InertiaMomentsPage::showHodograph(Hodograph& hodograph, bool force) {
    const Result& result = model_->result();
    const auto member = [&](const EngineOrder& order) -> const RotatingPair& {
        return force ? order.force : order.moment;
    };
    std::vector<double> x;
    std::vector<double> y;
    double reach = 0.0;
    const auto order = [&](int curve, int k) {
        traceOrder(member(result.exact.order(k)), x, y);
        reach = std::max(reach, reachOf(x, y));
        hodograph.plot->setCurve(curve, x, y);
    };
    order(hodograph.order1, 1);
    order(hodograph.order2, 2);
    const auto curve = [&](int number, const WrenchCurves& curves) {
        const auto& cx = force ? curves.force_x : curves.moment_x;
        const auto& cy = force ? curves.force_y : curves.moment_y;
        reach = std::max(reach, reachOf(cx, cy));
        hodograph.plot->setCurve(number, cx, cy);
    };
    curve(hodograph.whole, result.curves);
    bool acts = false;
    for (std::size_t i = 0; i < result.exact.orders.size(); ++i) {
        const EngineOrder& before = result.exact.orders[i];
        const double scale = force ? before.force_scale : before.moment_scale;
        acts = acts || (member(result.remaining.orders[i]) - member(before)).max() > 1e-9 * scale;
    }
    if (acts) {
        curve(hodograph.left, result.remaining_curves);
    } else {
        hodograph.plot->setCurve(hodograph.left, {}, {});
    }
    // Rounding of a balanced engine is not a picture.
    const EngineOrder& first = result.exact.order(1);
    const double floor =
        inertia_moments::zero_share * (force ? first.force_scale : first.moment_scale);
    reach = std::max(reach, std::max(floor * 1e3, 1e-12));
    // With hysteresis, so that the axes rest while a slider moves.
    if (reach > hodograph.reach || reach < 0.45 * hodograph.reach) {
        hodograph.reach = niceReach(1.08 * reach);
        hodograph.plot->setXAxis(
            {force ? tr("Fx, N") : tr("Mx, N·m"), -hodograph.reach, hodograph.reach});
        hodograph.plot->setYRange(PlotView::Side::Left, -hodograph.reach, hodograph.reach);
    }
}

void InertiaMomentsPage::showAnswer() {
    switch (answer_->currentIndex()) {
        case 0:
            tables_[0]->setRows(model_->orderRows());
            break;
        case 1:
            tables_[1]->setRows(model_->rotatingRows());
            break;
        case 2:
            tables_[2]->setRows(model_->shaftRows());
            break;
        case 3:
            tables_[3]->setRows(model_->weightRows());
            break;
        default:
            tables_[4]->setRows(model_->remainingRows());
            break;
    }
}

void InertiaMomentsPage::showCursor(double crankAngle) {
    crank_->setValue(std::round(crankAngle));
    for (PlotView* plot : moments_) {
        plot->setPresentX(crankAngle);
    }
    roll_->setPresentX(crankAngle);
    // Where the vectors stand now, on their hodographs.
    const double phi = crankAngle * degree;
    const Result& result = model_->result();
    for (std::size_t i = 0; i < hodographs_.size(); ++i) {
        const auto member = [&](int k) {
            const EngineOrder& order = result.exact.order(k);
            return (i == 0 ? order.force : order.moment).at(k * phi);
        };
        const auto first = member(1);
        const auto second = member(2);
        hodographs_[i].plot->setMarks(
            {{first.real(), first.imag(), {}, 2}, {second.real(), second.imag(), {}, 1}});
    }
}

QString InertiaMomentsPage::resultsAsText() const {
    QString text;
    const std::vector<QVector<QStringList>> rows{model_->orderRows(), model_->rotatingRows(),
                                                 model_->shaftRows(), model_->weightRows(),
                                                 model_->remainingRows()};
    const std::vector<QStringList> columns{model_->orderColumns(), model_->rotatingColumns(),
                                           model_->shaftColumns(), model_->weightColumns(),
                                           model_->remainingColumns()};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        tables_[i]->setRows(rows[i]);
        text += tables_[i]->asText() + QLatin1Char('\n');
    }
    return text + model_->warningText() + QLatin1Char('\n');
}

QString InertiaMomentsPage::resultsAsCsv() const {
    resultsAsText();  // fills the tables that are not in front
    QString text;
    for (const ResultTable* table : tables_) {
        text += table->asCsv() + QLatin1Char('\n');
    }
    return text;
}

void InertiaMomentsPage::setActive(bool active) {
    if (!active) {
        picture_->setPlaying(false);
    }
}

void InertiaMomentsPage::resetZoom() {
    for (PlotView* plot : moments_) {
        plot->resetZoom();
    }
    for (const Hodograph& hodograph : hodographs_) {
        hodograph.plot->resetZoom();
    }
    roll_->resetZoom();
}

}  // namespace ravnoves
