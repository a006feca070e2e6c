#include "inertia-moments/engine_forms.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "inertia-moments/fields.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "inertia-moments/shaft_editor.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using inertia_moments::Input;
namespace field = inertia_moments::field;

namespace {

/// The firing order as people write it: "1-2-4-5-3".
class FiringOrderField final : public ValueEntry<std::vector<int>> {
  public:
    FiringOrderField(InertiaMomentsModel* model, QWidget* parent)
        : ValueEntry(parent), model_(model) {}

    /// Room for twelve cylinders.
    QSize sizeHint() const override {
        const QString longest = QStringLiteral("1-12-5-8-3-10-6-7-2-11-4-9");
        return {fontMetrics().horizontalAdvance(longest) + 2 * Theme::space,
                ValueEntry::sizeHint().height()};
    }

  protected:
    Reading read(const QString& typed) const override {
        const auto order = inertia_moments::whole_numbers(typed.toStdString());
        return {order, model_->orderTrouble(order)};
    }
    QString written() const override { return InertiaMomentsModel::orderText(value()); }
    void passOn() override { model_->setFiringOrder(value()); }

  private:
    InertiaMomentsModel* model_;
};

}  // namespace

EngineForm::EngineForm(InertiaMomentsModel* model) : Form(model), model_(model) {
    section(tr("Layout"));
    addLayoutChoice();
    addFiringOrder();
    choice("/strokes");
    FormSection* sizes = section({});
    number("/layout/spacing_mm");
    NumberField* stagger = number("/layout/stagger_mm");
    NumberField* first = number("/layout/first_position_mm");

    section(tr("Crank gear"));
    number("/crank_radius_mm");
    addRodLength();
    QLabel* deadCentre = current()->addResult(
        tr("φ at TDC, cylinder 1"),
        tr("Top dead centre: arcsin(λK/(1 + λ)), from the cylinder's axis on the "
           "side of its offset. Volkswagen VR5: 3°20′."));
    number("/reciprocating_mass_kg");
    addRotatingMass();
    addRod();
    column()->addStretch();
    follow([this, sizes, deadCentre, first, stagger] {
        showLayout();
        first->setPlaceholderText(
            shownFigures(model_->result().engine.cylinders.front().axial_position, units::mm, 6));
        sizes->setVisible(model_->input().layout.has_value());
        const bool isStaggered = model_->canBeStaggered();
        // One that has no effect can still be removed.
        stagger->setEnabled(isStaggered || stagger->value().value_or(0.0) != 0.0);
        stagger->setHint(
            isStaggered ? fieldHint(field::stagger)
                        : tr("No effect: no throw of this layout has cylinders of two banks."));
        const QLocale locale;
        const auto& engine = model_->result().engine;
        deadCentre->setText(fixedNumber(engine.top_dead_centre(0) / degree, 3, locale) +
                            QStringLiteral("°"));
    });
}

/// λ and the length of the rod: what is given is in its field, what follows is pale in its own.
void EngineForm::addRodLength() {
    NumberField* ratio = number(
        field::lambda,
        [this] {
            const auto& input = model_->input();
            return input.given_rod_length ? std::nullopt : std::optional(input.lambda);
        },
        [this](std::optional<double> typed) { model_->setRodRatio(typed); });
    NumberField* length = number(
        field::rod_length, [this] { return model_->input().given_rod_length; },
        [this](std::optional<double> typed) { model_->setRodLength(typed); });
    for (NumberField* each : {ratio, length}) {
        each->setOptional(true);
        constexpr int digits = 6;  // a ratio that was taken from another engine has many
        each->setDigits(digits);
    }
    follow([this, ratio, length] {
        const QLocale locale;
        ratio->setPlaceholderText(formNumber(model_->input().ratio(), locale, 5));
        length->setPlaceholderText(shownFigures(model_->input().rod_length(), units::mm, 6));
    });
}

void EngineForm::addLayoutChoice() {
    layout_ = new QComboBox(this);
    for (const QString& name : InertiaMomentsModel::layoutNames()) {
        layout_->addItem(model_->layoutTitle(name), name);
    }
    layout_->setMaxVisibleItems(27);
    layout_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    layout_->setMinimumContentsLength(14);
    layout_->setObjectName(QStringLiteral("layout"));
    current()->addWidget(tr("Cylinder la&yout"), layout_, {},
                         tr("A layout of the library, the paper's engine, or your own table"));
    connect(layout_, &QComboBox::activated, this, [this](int index) {
        model_->chooseLayout(layout_->itemData(index).toString());
        showLayout();
    });
}

void EngineForm::showLayout() {
    const QString name = model_->layoutName();
    int index = layout_->findData(name);
    if (index < 0) {
        // A VR with another number of cylinders, from a case.
        layout_->addItem(QString(), name);
        index = layout_->count() - 1;
    }
    layout_->setItemText(index, model_->layoutTitle(name));
    layout_->setCurrentIndex(index);
}

void EngineForm::addFiringOrder() {
    auto* order = new FiringOrderField(model_, this);
    order->setObjectName(QStringLiteral("firing_order"));
    order->setHint(fieldHint(field::firing_order));
    current()->addWidget(shownText(field::firing_order.label), order);
    order->setModel(model_);
    QLabel* misfit = copyableCaption("firing_misfit", current());
    current()->addWide(misfit);
    follow([this, order, misfit] {
        order->setValue(model_->firingOrder());
        const Message& why = model_->result().firing_trouble;
        misfit->setText(messageText(why));
        misfit->setVisible(!why.empty());
    });
}

void EngineForm::addRotatingMass() {
    FormSection* ofCylinder = section({});
    number("/rotating_mass_kg")->setOptional(false);
    FormSection* ofThrow = section({});
    number("/rotating_mass_per_throw_kg")->setOptional(false);
    section({});
    QComboBox* given = choice(
        QStringLiteral("rotating_mass_given"), tr("Mass given"),
        {tr("of one cylinder"), tr("of one throw")},
        tr("Enter the mass of one cylinder or of one throw; a throw with two rods carries the mass "
           "of one cylinder twice."),
        [this] { return model_->input().rotating_mass_of_throw ? 1 : 0; },
        [this](int index) { model_->setRotatingMassOfThrow(index == 1); });
    QLabel* onThrow = current()->addResult(tr("On each throw"),
                                           tr("At the crank radius, with the share of rigid rods"));
    onThrow->setObjectName(QStringLiteral("mass_on_throw"));
    follow([this, ofCylinder, ofThrow, given, onThrow] {
        const bool throws = model_->input().rotating_mass_of_throw;
        ofCylinder->setVisible(!throws);
        ofThrow->setVisible(throws);
        given->setEnabled(throws || model_->hasSharedPins());
        onThrow->setText(model_->throwMassText());
    });
}

void EngineForm::addRod() {
    section({});
    QCheckBox* rigid = box(
        QStringLiteral("rigid_rod"), tr("&Rod as a rigid body"),
        tr("Off: the rod's shares are in the masses above. On: enter its mass, centre and inertia; "
           "they act on roll moment and torque too."),
        [this] { return model_->input().rod.has_value(); },
        [this](bool on) {
            model_->edit(tr("Rigid rod"), [on](Input& input) {
                input.rod.reset();
                if (on) {
                    input.rod = inertia_moments::usual_rod(input);
                }
            });
        });
    FormSection* rod = section({});
    for (const char* pointer :
         {"/rod/mass_kg", "/rod/centre_from_big_end_mm", "/rod/inertia_kg_m2"}) {
        NumberField* target = number(pointer);
        target->setObjectName(QStringLiteral("rod_") + target->objectName());
        target->setDigits(6);
    }
    follow([rigid, rod] { rod->setVisible(rigid->isChecked()); });
}

BalancingForm::BalancingForm(InertiaMomentsModel* model) : Form(model) {
    section(tr("Balance shafts"));
    choice("/balance_shaft_basis");
    current()->addWide(captionLabel(
        tr("k order, L distance of the weights (%1), ρ their radius (%1), δ phase error (°)")
            .arg(shownUnit(units::mm).name),
        this));
    current()->addWide(new ShaftEditor(model, this));
    auto* add = new QPushButton(tr("&Add shaft"), this);
    add->setObjectName(QStringLiteral("add_shaft"));
    connect(add, &QPushButton::clicked, model, &InertiaMomentsModel::addShaft);
    current()->addWide(add);

    section({});
    QCheckBox* weights = box(
        QStringLiteral("counterweights"), tr("&Counterweights on the end webs"),
        tr("Two weights that cancel force and moment of the rotating masses, and a share of the "
           "forward part of the first order"),
        [model] { return model->input().end_webs && model->input().end_webs->enabled; },
        [model](bool on) {
            model->edit(tr("Counterweights"), [&](Input& input) {
                if (!input.end_webs) {
                    input.end_webs = inertia_moments::usual_end_webs(
                        model->result().engine.cylinders, input.crank_radius);
                }
                input.end_webs->enabled = on;
            });
        });
    FormSection* webs = section({});
    for (const char* pointer :
         {"/counterweights/front_position_mm", "/counterweights/front_radius_mm",
          "/counterweights/rear_position_mm", "/counterweights/rear_radius_mm",
          "/counterweights/first_order_share"}) {
        NumberField* target = number(pointer);
        target->setDigits(7);
        target->setOptional(false);
    }
    column()->addStretch();
    follow([weights, webs] { webs->setVisible(weights->isChecked()); });
}

EngineSliders::EngineSliders(InertiaMomentsModel* model, QWidget* parent) : Panel(parent) {
    using Model = InertiaMomentsModel;
    const auto of = [model](auto member) { return std::bind_front(member, model); };
    auto* bank = new FieldSlider(
        model, "/layout/bank_angle_deg", {0.0, 180.0, 0.1, 5.0, 1}, this,
        {.isMovable = of(&Model::canChangeBankAngle), .read = of(&Model::bankAngleDeg)});
    auto* offset =
        new FieldSlider(model, "/layout/offset_mm", {-50.0, 50.0, 0.01, 1.0, 2}, this,
                        {.ends = of(&Model::offsetLimitsMm),
                         .isMovable = [model] { return model->input().layout.has_value(); },
                         .read = of(&Model::offsetMm)});
    auto* speed = new FieldSlider(model, "/speed_rpm", {100.0, 10000.0, 10.0, 500.0, 0}, this);
    auto* reference =
        new FieldSlider(model, "/reference_position_mm", {-500.0, 500.0, 0.1, 10.0, 1}, this,
                        {.ends = of(&Model::referenceLimitsMm)});
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(Theme::margin, Theme::gap, Theme::margin, Theme::gap);
    grid->setHorizontalSpacing(2 * Theme::margin);
    grid->setVerticalSpacing(Theme::gap);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    grid->addWidget(bank, 0, 0);
    grid->addWidget(offset, 0, 1);
    grid->addWidget(speed, 1, 0);
    grid->addWidget(reference, 1, 1);
}

}  // namespace ravnoves
