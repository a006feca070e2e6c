#include "balance-shaft/balance_shaft_page.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "balance-shaft/cycle_view.h"
#include "balance-shaft/envelope_view.h"
#include "balance-shaft/forces_view.h"
#include "balance-shaft/mechanism_view.h"
#include "balance-shaft/model/balance_shaft_model.h"
#include "balance-shaft/orders_view.h"
#include "balance-shaft/presets.h"
#include "balance-shaft/relieved_shaft_view.h"
#include "balance-shaft/speed_view.h"
#include "balance-shaft/torque_source_editor.h"
#include "balance-shaft/torque_table_editor.h"
#include "text/number_text.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"
#include "widgets/panel.h"
#include "widgets/result_table.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using balance_shaft::Input;
using balance_shaft::MomentMetrics;
using balance_shaft::Result;
namespace field = balance_shaft::field;

namespace {

constexpr double crankStep = 1.0;

/// The masses of Table 1 that move with the piston, in the paper's order.
struct MassRow {
    const char* name;   ///< in the case file
    const char* label;  ///< with mnemonic
    const char* hint;
};

constexpr std::array<MassRow, 4> massRows{{
    {"piston", QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage", "&Piston"),
     QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage",
                       "Mass of the piston. TMZ-650D: 0.645 kg (0.640). Source: Gots and Klevtsov, "
                       "Table 1.")},
    {"pin", QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage", "Piston p&in"),
     QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage",
                       "Mass of the piston pin. TMZ-650D: 0.241 kg. Source: Table 1.")},
    {"rings", QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage", "Rin&gs"),
     QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage",
                       "Mass of the piston rings. TMZ-650D: 0.1 kg. Source: Table 1.")},
    {"rod_small_end", QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage", "Rod, small-&end share"),
     QT_TRANSLATE_NOOP("ravnoves::BalanceShaftPage",
                       "Part of the rod's mass that moves with the piston. TMZ-650D: 0.33 kg of "
                       "0.950 kg. Source: Table 1.")},
}};

void setMass(Input& input, const std::string& name, double mass) {
    for (balance_shaft::NamedMass& part : input.reciprocating_masses) {
        if (part.name == name) {
            part.mass = mass;
            return;
        }
    }
    // A case that gave only the sum: the sum stays as one part beside the named ones.
    for (balance_shaft::NamedMass& part : input.reciprocating_masses) {
        if (part.name.empty()) {
            part.name = "other";
        }
    }
    input.reciprocating_masses.push_back({name, mass});
}

double otherMasses(const Input& input) {
    double sum = 0.0;
    for (const balance_shaft::NamedMass& part : input.reciprocating_masses) {
        bool listed = false;
        for (const MassRow& row : massRows) {
            listed = listed || part.name == row.name;
        }
        sum += listed ? 0.0 : part.mass;
    }
    return sum;
}

}  // namespace

BalanceShaftPage::BalanceShaftPage(QWidget* parent)
    : ScenePage(parent), model_(new BalanceShaftModel(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    row->setSpacing(Theme::space);
    row->addWidget(buildInputs());
    row->addWidget(buildPlots(), 5);
    row->addWidget(buildAnswer(), 2);

    playAction_ = new QAction(themedIcon(QStringLiteral("play")), tr("&Play"), this);
    playAction_->setToolTip(tr("Turn the crank"));
    connect(playAction_, &QAction::triggered, this,
            [this] { picture_->setPlaying(!picture_->isPlaying()); });
    bestRangeAction_ = new QAction(themedIcon(QStringLiteral("best")),
                                   tr("Go to the α of the least &range"), this);
    connect(bestRangeAction_, &QAction::triggered, model_, &BalanceShaftModel::goToBestRange);
    bestRmsAction_ = new QAction(tr("Go to the α of the least R&MS"), this);
    connect(bestRmsAction_, &QAction::triggered, model_, &BalanceShaftModel::goToBestRms);
    connect(picture_, &MechanismView::playingChanged, this, [this](bool playing) {
        const QIcon icon = themedIcon(playing ? QStringLiteral("pause") : QStringLiteral("play"));
        playAction_->setIcon(icon);
        playAction_->setText(playing ? tr("&Pause") : tr("&Play"));
        playButton_->setIcon(icon);
        playButton_->setToolTip(playing ? tr("Pause (Space)") : tr("Play (Space)"));
    });

    connect(model_, &SceneModel::changed, this, &BalanceShaftPage::showInput);
    connect(model_, &SceneModel::changed, this, &BalanceShaftPage::showSweep);
    connect(model_, &BalanceShaftModel::shaftMoved, this, &BalanceShaftPage::showShaft);
    connect(model_, &BalanceShaftModel::meansChanged, this, &BalanceShaftPage::showMeans);
    connect(model_, &BalanceShaftModel::crankAngleChanged, this, &BalanceShaftPage::showCursor);
    connect(model_, &BalanceShaftModel::refused, this, &ScenePage::status);

    showInput();
    showSweep();
    showShaft();
    showMeans();
    showCursor(model_->crankAngleDeg());
}

TorqueTableEditor* BalanceShaftPage::torqueEditor() const {
    return source_->tableEditor();
}

SceneModel* BalanceShaftPage::model() {
    return model_;
}

QList<QAction*> BalanceShaftPage::sceneActions() {
    return {playAction_, bestRangeAction_, bestRmsAction_};
}

void BalanceShaftPage::bind(NumberField* numberField, const QString& name,
                            std::function<std::optional<double>()> read,
                            std::function<void(std::optional<double>)> write) {
    Q_UNUSED(name)
    connect(numberField, &NumberField::valueEdited, this, std::move(write));
    bindings_.push_back({numberField, std::move(read)});
}

QWidget* BalanceShaftPage::buildInputs() {
    auto* form = new QWidget;
    auto* column = new QVBoxLayout(form);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column->setSpacing(Theme::gap);

    // Binds a field to a number of the input: shown = SI value / unit.
    const auto number = [this](NumberField* target, const QString& name, double unit,
                               double Input::*member) {
        bind(
            target, name, [this, unit, member] { return model_->input().*member / unit; },
            [this, name, unit, member](std::optional<double> value) {
                model_->edit(name, [&](Input& input) { input.*member = *value * unit; });
            });
    };
    const auto optional = [this](NumberField* target, const QString& name, double unit,
                                 auto access) {
        target->setOptional(true);
        bind(
            target, name,
            [this, unit, access]() -> std::optional<double> {
                Input input = model_->input();
                const std::optional<double>& value = access(input);
                return value ? std::optional(*value / unit) : std::nullopt;
            },
            [this, name, unit, access](std::optional<double> value) {
                model_->edit(name, [&](Input& input) {
                    access(input) = value ? std::optional(*value * unit) : std::nullopt;
                });
            });
    };

    auto* engine = new FormSection(tr("Engine"), form);
    preset_ = new QComboBox(form);
    preset_->addItem(tr("Own values"));
    preset_->addItem(tr("TMZ-650D"));
    engine->addWidget(
        tr("P&reset"), preset_, {},
        tr("TMZ-650D: the single-cylinder diesel of Gots and Klevtsov, Tables 1 and 2"));
    connect(preset_, &QComboBox::activated, this, [this](int index) {
        if (index == 1) {
            model_->edit(tr("Preset TMZ-650D"),
                         [](Input& input) { input = balance_shaft::preset_tmz_650d(); });
            model_->setTitle(QStringLiteral("TMZ-650D"));
        }
        showInput();
    });
    auto* speed = engine->addNumber(
        tr("&Speed n"), field::speed,
        tr("Crankshaft speed. TMZ-650D: 3600 min⁻¹ (the paper prints ω = 376.8 rad/s, with "
           "π ≈ 3.14)."));
    speed->setDigits(8);
    bind(
        speed, tr("Speed"), [this] { return model_->input().angular_speed / rpm; },
        [this](std::optional<double> value) {
            model_->edit(tr("Speed"), [&](Input& input) {
                input.angular_speed = *value * rpm;
                input.speed_in_rpm = true;
            });
        });
    angularSpeed_ = engine->addResult(tr("ω"), tr("Angular speed, n π / 30"));
    number(engine->addNumber(tr("&Crank radius r"), field::crank_radius,
                             tr("Half the stroke. TMZ-650D: 46 mm (stroke 92 mm).")),
           tr("Crank radius"), field::millimetre, &Input::crank_radius);
    auto* rod = engine->addNumber(tr("Rod lengt&h L"), field::rod_length,
                                  tr("Between the centres of the rod's eyes; only the picture uses "
                                     "it. Empty: r / 0.3."));
    rod->setPlaceholderText(tr("auto"));
    optional(rod, tr("Rod length"), field::millimetre,
             [](Input& input) -> std::optional<double>& { return input.rod_length; });
    column->addWidget(engine);

    auto* masses = new FormSection(tr("Reciprocating masses"), form);
    for (const MassRow& row : massRows) {
        const std::string name = row.name;
        const QString label = tr(row.label);
        auto* massField = masses->addNumber(label, field::reciprocating_mass_part, tr(row.hint));
        massField->setObjectName(QString::fromStdString("mass_" + name));
        QString step = label;
        step.remove(QLatin1Char('&'));
        bind(
            massField, step, [this, name] { return model_->mass(name); },
            [this, name, step](std::optional<double> value) {
                model_->edit(step, [&](Input& input) { setMass(input, name, *value); });
            });
    }
    auto* rodMass = masses->addNumber(
        tr("Whole rod with she&lls"), field::rod_mass,
        tr("Its small-end share above is a part of it; the rest turns with the crankpin and is "
           "balanced by the crank's own counterweights. TMZ-650D: 0.950 ± 0.015 kg. Source: "
           "Table 1."));
    rodMass->setPlaceholderText(tr("any"));
    optional(rodMass, tr("Rod mass"), 1.0,
             [](Input& input) -> std::optional<double>& { return input.rod_mass; });
    massSum_ = masses->addResult(
        tr("Sum mⱼ"), tr("Reciprocating mass: the sum of the parts. TMZ-650D: 1.316 kg."));
    massNote_ = captionLabel({}, masses);
    masses->addWide(massNote_);
    column->addWidget(masses);

    auto* shaft = new FormSection(tr("Counterweights and shaft"), form);
    number(shaft->addNumber(tr("Coun&terweight radius ρ₁"), field::counterweight_radius,
                            tr("From the axis to the centre of mass of each of the two equal "
                               "counterweights. TMZ-650D: 46 mm.")),
           tr("Counterweight radius"), field::millimetre, &Input::counterweight_radius);
    auto* weight = shaft->addNumber(
        tr("Counterweight &mass m₁"), field::counterweight_mass,
        tr("Empty: by equation (1), m₁ = mⱼ r / (2 ρ₁). A number overrides it. TMZ-650D: "
           "0.658 kg."));
    weight->setPlaceholderText(tr("by (1)"));
    optional(weight, tr("Counterweight mass"), 1.0,
             [](Input& input) -> std::optional<double>& { return input.counterweight_mass; });
    number(shaft->addNumber(tr("Centre &distance l"), field::centre_distance,
                            tr("From the crank axis to the shaft axis. The paper does not print "
                               "it; 100.15 mm follows from the printed amplitude 430.39 N·m.")),
           tr("Centre distance"), field::millimetre, &Input::centre_distance);
    column->addWidget(shaft);

    auto* sizes = new FormSection(tr("Sizes for picture and envelope"), form);
    const QString automatic = tr("auto");
    const auto envelope = [&](const QString& label, const FieldSpec& spec, const QString& hint,
                              std::optional<double> balance_shaft::EnvelopeSizes::*member) {
        auto* target = sizes->addNumber(label, spec, hint);
        target->setPlaceholderText(automatic);
        QString step = label;
        step.remove(QLatin1Char('&'));
        optional(target, step, field::millimetre, [member](Input& input) -> std::optional<double>& {
            return input.envelope.*member;
        });
    };
    envelope(tr("Cylinder &bore"), field::cylinder_bore, tr("Empty: the stroke, 2 r."),
             &balance_shaft::EnvelopeSizes::cylinder_bore);
    envelope(tr("Crank swing radi&us"), field::crank_swing_radius,
             tr("Circle swept by crank and counterweight. Empty: 1.3 times the larger of r and "
                "ρ₁."),
             &balance_shaft::EnvelopeSizes::crank_swing_radius);
    envelope(tr("Shaft swin&g radius"), field::shaft_swing_radius,
             tr("Circle swept by the balance shaft. Empty: 1.3 ρ₁."),
             &balance_shaft::EnvelopeSizes::shaft_swing_radius);
    envelope(tr("Gear tip r&adius"), field::gear_tip_radius,
             tr("Tip circle of each of the two gears. Empty: l/2, the pitch circle."),
             &balance_shaft::EnvelopeSizes::gear_tip_radius);
    auto* wall = sizes->addNumber(tr("Housing &wall and gap"), field::wall,
                                  tr("Added around every circle."));
    bind(
        wall, tr("Wall"), [this] { return model_->input().envelope.wall / field::millimetre; },
        [this](std::optional<double> value) {
            model_->edit(tr("Wall"),
                         [&](Input& input) { input.envelope.wall = *value * field::millimetre; });
        });
    column->addWidget(sizes);
    interpolation_ = new QComboBox(form);
    interpolation_->addItems({tr("straight lines"), tr("periodic cubic spline")});
    auto* reading = new FormSection(tr("Torque between the rows of its table"), form);
    reading->addWidget(tr("I&nterpolation"), interpolation_, {},
                       tr("The paper's table has a row every 15°; criteria are those of the curve "
                          "between the rows, not of the rows alone."));
    connect(interpolation_, &QComboBox::activated, this, [this](int index) {
        model_->edit(tr("Interpolation"), [&](Input& input) {
            input.interpolation = index == 0 ? balance_shaft::Interpolation::linear
                                             : balance_shaft::Interpolation::periodic_cubic;
        });
    });
    column->addWidget(reading);
    column->addStretch();

    auto* tabs = new QTabWidget(this);
    tabs->setDocumentMode(true);
    tabs->setFixedWidth(300);
    auto* scroll = new QScrollArea(tabs);
    scroll->setWidget(form);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    tabs->addTab(scroll, tr("Inputs"));
    source_ = new TorqueSourceEditor(model_, tabs);
    source_->setObjectName(QStringLiteral("torque"));
    tabs->addTab(source_, tr("Torque"));
    return tabs;
}

QWidget* BalanceShaftPage::buildPlots() {
    auto* holder = new QWidget(this);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(Theme::space);

    auto* bar = new Panel(holder);
    auto* barRow = new QHBoxLayout(bar);
    barRow->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    barRow->setSpacing(Theme::margin);
    angle_ =
        new ValueSlider(tr("Shaft angle &α"), 0.0, 360.0, 0.1, 10.0, 1, QStringLiteral("°"), bar);
    angle_->setHint(
        tr("Angle from the cylinder axis to the line of centres, in the direction of "
           "rotation; 90° is beside the crank. 0 to 360°, steps of 0.1°."));
    angle_->slider()->setObjectName(QStringLiteral("shaft_angle_slider"));
    angle_->box()->setObjectName(QStringLiteral("shaft_angle_deg"));
    connect(angle_, &ValueSlider::valueEdited, model_, &BalanceShaftModel::setShaftAngleDeg);
    connect(angle_, &ValueSlider::released, model_, &BalanceShaftModel::finishDrag);
    barRow->addWidget(angle_, 1);
    auto* meansLabel = new QLabel(tr("Mea&ns"), bar);
    meansChoice_ = new QComboBox(bar);
    meansChoice_->addItems({tr("both"), tr("cycle integral"), tr("paper's nodes")});
    meansChoice_->setAccessibleName(tr("Which means the plots show"));
    meansChoice_->setToolTip(
        tr("The mean of Mₛ over a cycle is 0 at every α. The paper averages 25 nodes and counts "
           "the end of the cycle twice; that alone makes its mean differ from 0."));
    meansLabel->setBuddy(meansChoice_);
    barRow->addWidget(meansLabel);
    barRow->addWidget(meansChoice_);
    connect(meansChoice_, &QComboBox::activated, this,
            [this](int index) { model_->setMeans(static_cast<BalanceShaftModel::Means>(index)); });
    column->addWidget(bar);

    views_ = new QTabWidget(holder);
    views_->setDocumentMode(true);
    column->addWidget(views_, 1);
    cycle_ = new CycleView(model_, views_);
    const auto addView = [this](QWidget* view, const char* name, const QString& title) {
        view->setObjectName(QString::fromLatin1(name));
        views_->addTab(view, title);
    };
    addView(buildMoments(), "moments", tr("Moments"));
    addView(cycle_, "cycle", tr("Cycle"));
    addView(new SpeedView(model_, views_), "speed", tr("Speed"));
    addView(new EnvelopeView(model_, views_), "envelope", tr("Size"));
    addView(new OrdersView(model_, views_), "orders", tr("Orders"));
    addView(new ForcesView(model_, views_), "forces", tr("Forces"));
    addView(new RelievedShaftView(model_, views_), "relieved", tr("Relief"));
    return holder;
}

QWidget* BalanceShaftPage::buildMoments() {
    auto* holder = new QWidget(this);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, Theme::space, 0, 0);
    column->setSpacing(Theme::space);
    const QString crankAxis = tr("φ, °");
    const QString angleAxis = tr("α, °");
    const QString newtonMetre = tr("N·m");

    moments_ = new PlotView(tr("Moments over the cycle"), holder);
    moments_->setXAxis({crankAxis, 0.0, 720.0, true});
    moments_->setYAxis(PlotView::Side::Left, {newtonMetre});
    up_ = moments_->addCurve({.name = QStringLiteral("Mᵤₚ"),
                              .colour = 0,
                              .width = 1.4,
                              .toolTip = tr("Tipping moment, −M_id")});
    s_ = moments_->addCurve({.name = QStringLiteral("Mₛ"),
                             .colour = 1,
                             .width = 1.4,
                             .toolTip = tr("Moment of the balance shaft, P₁ l sin(α + φ), (4)")});
    ups_ = moments_->addCurve({.name = QStringLiteral("Mᵤₚₛ"),
                               .colour = 2,
                               .width = 2.0,
                               .toolTip = tr("Moment on the mounts, Mᵤₚ + Mₛ, (5)")});
    connect(moments_, &PlotView::cursorMoved, model_, &BalanceShaftModel::setCrankAngleDeg);
    connect(moments_, &PlotView::curveToggled, this, &BalanceShaftPage::showShaft);
    column->addWidget(moments_, 5);

    auto* lower = new QHBoxLayout;
    lower->setSpacing(Theme::space);
    range_ = new PlotView(tr("Range and RMS over α"), holder);
    range_->setXAxis({angleAxis, 0.0, 360.0, true});
    range_->setYAxis(PlotView::Side::Left, {newtonMetre});
    range_->setYAxis(PlotView::Side::Right, {tr("mean Mₛ, N·m")});
    range_->setPickable(true);
    rangeCurve_ = range_->addCurve({.name = QStringLiteral("ΔMᵤₚₛ"),
                                    .colour = 2,
                                    .width = 1.8,
                                    .toolTip = tr("Range of Mᵤₚₛ, max − min")});
    rmsCurve_ = range_->addCurve(
        {.name = tr("RMS"), .colour = 3, .toolTip = tr("RMS of Mᵤₚₛ about its mean")});
    meanSTrue_ = range_->addCurve({.name = tr("Mₛ mean"),
                                   .colour = 1,
                                   .side = PlotView::Side::Right,
                                   .toolTip = tr("Cycle mean of Mₛ: 0 at every α")});
    meanSPrinted_ = range_->addCurve({.name = tr("Mₛ mean (paper)"),
                                      .colour = 4,
                                      .side = PlotView::Side::Right,
                                      .pen = Qt::DashLine,
                                      .toolTip = tr("Mean of 25 nodes, the end counted twice")});
    means_ = new PlotView(tr("Means over α"), holder);
    means_->setXAxis({angleAxis, 0.0, 360.0, true});
    means_->setYAxis(PlotView::Side::Left, {newtonMetre});
    means_->setPickable(true);
    mSTrue_ = means_->addCurve(
        {.name = tr("Mₛₘ"), .colour = 1, .width = 1.8, .toolTip = tr("Cycle mean of Mₛ")});
    mUpsTrue_ = means_->addCurve(
        {.name = tr("Mᵤₚₛₘ"), .colour = 2, .width = 1.8, .toolTip = tr("Cycle mean of Mᵤₚₛ")});
    mSPrinted_ = means_->addCurve({.name = tr("Mₛₘ (paper)"),
                                   .colour = 4,
                                   .pen = Qt::DashLine,
                                   .toolTip = tr("Mean of 25 nodes, the end counted twice")});
    mUpsPrinted_ = means_->addCurve({.name = tr("Mᵤₚₛₘ (paper)"),
                                     .colour = 5,
                                     .pen = Qt::DashLine,
                                     .toolTip = tr("Node mean of Mᵤₚ plus that of Mₛ")});
    for (PlotView* plot : {range_, means_}) {
        lower->addWidget(plot, 1);
        connect(plot, &PlotView::picked, this,
                [this](double x) { model_->setShaftAngleDeg(std::round(x * 10.0) / 10.0); });
    }
    column->addLayout(lower, 4);
    return holder;
}

QWidget* BalanceShaftPage::buildAnswer() {
    auto* holder = new QWidget(this);
    holder->setMinimumWidth(312);
    holder->setMaximumWidth(440);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(Theme::space);

    auto* picturePanel = new Panel(holder);
    auto* pictureColumn = new QVBoxLayout(picturePanel);
    pictureColumn->setContentsMargins(1, 1, 1, Theme::gap);
    pictureColumn->setSpacing(0);
    picture_ = new MechanismView(model_, picturePanel);
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
    crank_ = new ValueSlider(tr("&φ"), 0.0, 720.0, crankStep, 15.0, 0, QStringLiteral("°"),
                             picturePanel);
    crank_->setHint(tr("Crank angle of the picture; 0 is top dead centre"));
    connect(crank_, &ValueSlider::valueEdited, model_, &BalanceShaftModel::setCrankAngleDeg);
    controls->addWidget(crank_, 1);
    pictureColumn->addLayout(controls);
    column->addWidget(picturePanel, 1);

    auto* answer = new Panel(holder);
    auto* answerColumn = new QVBoxLayout(answer);
    answerColumn->setContentsMargins(Theme::space, Theme::space, Theme::space, Theme::space);
    answerColumn->setSpacing(Theme::gap);
    criteria_ = new ResultTable(answer);
    criteria_->setAccessibleName(tr("Criteria of the three moments"));
    criteria_->setColumns(model_->criteriaColumns());
    answerColumn->addWidget(criteria_);

    auto* best = new QGridLayout;
    best->setHorizontalSpacing(Theme::space);
    best->setVerticalSpacing(2);
    bestRange_ = new QLabel(answer);
    bestRms_ = new QLabel(answer);
    goRange_ = new QPushButton(tr("Go"), answer);
    goRms_ = new QPushButton(tr("Go"), answer);
    const auto addBest = [&](int row, QLabel* label, QPushButton* button, const QString& name) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        button->setMaximumWidth(52);
        button->setAccessibleName(name);
        button->setToolTip(name);
        best->addWidget(label, row, 0);
        best->addWidget(button, row, 1);
    };
    addBest(1, bestRange_, goRange_, tr("Go to the α of the least range"));
    addBest(2, bestRms_, goRms_, tr("Go to the α of the least RMS"));
    best->setColumnStretch(0, 1);
    goRange_->setObjectName(QStringLiteral("go_best_range"));
    goRms_->setObjectName(QStringLiteral("go_best_rms"));
    connect(goRange_, &QPushButton::clicked, model_, &BalanceShaftModel::goToBestRange);
    connect(goRms_, &QPushButton::clicked, model_, &BalanceShaftModel::goToBestRms);
    answerColumn->addLayout(best);

    quantities_ = new ResultTable(answer);
    quantities_->setAccessibleName(tr("Forces, masses and sizes"));
    quantities_->setColumns(model_->quantityColumns());
    quantities_->horizontalHeader()->hide();
    answerColumn->addWidget(quantities_);
    notes_ = captionLabel({}, answer);
    answerColumn->addWidget(notes_);
    column->addWidget(answer);
    return holder;
}

void BalanceShaftPage::showInput() {
    for (const Binding& binding : bindings_) {
        binding.field->setValue(binding.read());
    }
    const QLocale locale;
    massSum_->setText(fixedNumber(model_->input().reciprocating_mass(), 3, locale) + tr(" kg"));
    const double other = otherMasses(model_->input());
    massNote_->setText(tr("%1 kg of it are not listed above.").arg(formNumber(other, locale, 6)));
    massNote_->setVisible(other > 0.0);
    angularSpeed_->setText(fixedNumber(model_->input().angular_speed, 2, locale) + tr(" rad/s"));
    Input preset = balance_shaft::preset_tmz_650d();
    preset.shaft_angle = model_->input().shaft_angle;
    preset_->setCurrentIndex(preset == model_->input() ? 1 : 0);
    interpolation_->setCurrentIndex(
        model_->input().interpolation == balance_shaft::Interpolation::linear ? 0 : 1);
}

void BalanceShaftPage::showSweep() {
    const Result& result = model_->result();
    const balance_shaft::AngleSweep& sweep = result.sweep;
    moments_->setCurve(up_, result.curves.crank_angle_deg, result.curves.M_up);
    // Room for every α, so that the axis rests while the shaft moves.
    const double reach = result.moment_amplitude;
    moments_->setYRange(PlotView::Side::Left, result.M_up.min - reach, result.M_up.max + reach);
    range_->setCurve(rangeCurve_, sweep.shaft_angle_deg, sweep.range);
    range_->setCurve(rmsCurve_, sweep.shaft_angle_deg, sweep.rms);
    range_->setCurve(meanSTrue_, sweep.shaft_angle_deg, sweep.mean_M_s);
    range_->setCurve(meanSPrinted_, sweep.shaft_angle_deg, sweep.printed_mean_M_s);
    means_->setCurve(mSTrue_, sweep.shaft_angle_deg, sweep.mean_M_s);
    means_->setCurve(mSPrinted_, sweep.shaft_angle_deg, sweep.printed_mean_M_s);
    means_->setCurve(mUpsTrue_, sweep.shaft_angle_deg, sweep.mean_M_ups);
    means_->setCurve(mUpsPrinted_, sweep.shaft_angle_deg, sweep.printed_mean_M_ups);

    std::vector<PlotView::Mark> marks;
    const QLocale locale;
    const auto add = [&](const balance_shaft::Optimum& best, int colour) {
        if (best.shaft_angle) {
            const double at = *best.shaft_angle / degree;
            marks.push_back({at, best.value, fixedNumber(at, 2, locale) + QStringLiteral("°"),
                             colour, PlotView::Side::Left, true});
        }
    };
    add(result.best_range, 2);
    add(result.best_rms, 3);
    range_->setMarks(marks);
    bestRange_->setText(model_->bestRangeText());
    bestRms_->setText(model_->bestRmsText());
    goRange_->setEnabled(result.best_range.shaft_angle.has_value());
    goRms_->setEnabled(result.best_rms.shaft_angle.has_value());
    bestRangeAction_->setEnabled(goRange_->isEnabled());
    bestRmsAction_->setEnabled(goRms_->isEnabled());
    notes_->setText(model_->notesText());
    notes_->setVisible(!notes_->text().isEmpty());
}

void BalanceShaftPage::showShaft() {
    const Result& result = model_->result();
    const double alpha = model_->shaftAngleDeg();
    angle_->setValue(alpha);
    moments_->setCurve(s_, result.curves.crank_angle_deg, result.curves.M_s);
    moments_->setCurve(ups_, result.curves.crank_angle_deg, result.curves.M_ups);
    const QLocale locale;
    std::vector<PlotView::Mark> marks;
    const auto mark = [&](int curve, const MomentMetrics& metrics, int colour) {
        if (!moments_->isCurveShown(curve)) {
            return;
        }
        marks.push_back(
            {metrics.max_angle / degree, metrics.max, fixedNumber(metrics.max, 0, locale), colour});
        marks.push_back(
            {metrics.min_angle / degree, metrics.min, fixedNumber(metrics.min, 0, locale), colour});
    };
    mark(ups_, result.M_ups, 2);
    mark(up_, result.M_up, 0);
    mark(s_, result.M_s, 1);
    moments_->setMarks(std::move(marks));
    range_->setPresentX(alpha);
    means_->setPresentX(alpha);
    criteria_->setRows(model_->criteriaRows());
    quantities_->setRows(model_->quantityRows());
}

void BalanceShaftPage::showMeans() {
    using Means = BalanceShaftModel::Means;
    const Means shown = model_->means();
    meansChoice_->setCurrentIndex(static_cast<int>(shown));
    const bool truth = shown != Means::PrintedNodes;
    const bool printed = shown != Means::CycleIntegral;
    range_->setCurveShown(meanSTrue_, truth);
    means_->setCurveShown(mSTrue_, truth);
    means_->setCurveShown(mUpsTrue_, truth);
    range_->setCurveShown(meanSPrinted_, printed);
    means_->setCurveShown(mSPrinted_, printed);
    means_->setCurveShown(mUpsPrinted_, printed);
}

void BalanceShaftPage::showCursor(double crankAngle) {
    crank_->setValue(std::round(crankAngle));
    moments_->setPresentX(crankAngle);
}

QString BalanceShaftPage::resultsAsText() const {
    return criteria_->asText() + QLatin1Char('\n') + quantities_->asText() + QLatin1Char('\n') +
           bestRange_->text() + QLatin1Char('\n') + bestRms_->text() + QLatin1Char('\n');
}

QString BalanceShaftPage::resultsAsCsv() const {
    return criteria_->asCsv() + QLatin1Char('\n') + quantities_->asCsv();
}

void BalanceShaftPage::setActive(bool active) {
    if (!active) {
        picture_->setPlaying(false);
    }
}

void BalanceShaftPage::resetZoom() {
    for (PlotView* plot : {moments_, range_, means_}) {
        plot->resetZoom();
    }
    cycle_->resetZoom();
}

}  // namespace ravnoves
