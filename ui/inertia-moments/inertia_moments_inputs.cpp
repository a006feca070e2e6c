#include "inertia-moments/inertia_moments_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "inertia-moments/cylinder_editor.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "inertia-moments/presets.h"
#include "inertia-moments/shaft_editor.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"
#include "text/number_text.h"
#include "widgets/panel.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using inertia_moments::EndWebs;
using inertia_moments::Input;
using inertia_moments::Layout;
using inertia_moments::RigidRod;
namespace field = inertia_moments::field;

namespace {

using Tabs = InertiaMomentsModel::Tabs;

QVBoxLayout* formColumn(QWidget* form) {
    auto* column = new QVBoxLayout(form);
    column->setContentsMargins(Theme::margin, Theme::margin, Theme::margin, Theme::margin);
    column->setSpacing(Theme::gap);
    return column;
}

}  // namespace

void InertiaMomentsPage::bind(NumberField* numberField, std::function<std::optional<double>()> read,
                              std::function<void(std::optional<double>)> write) {
    connect(numberField, &NumberField::valueEdited, this, std::move(write));
    bindings_.push_back({numberField, std::move(read)});
}

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
        colourText(firingTrouble_, Theme::instance().error());
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

}  // namespace ravnoves
