#include "inertia-moments/engine_forms.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <vector>

#include "inertia-moments/fields.h"
#include "inertia-moments/model/inertia_moments_model.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/value_slider.h"

namespace ravnoves {

using inertia_moments::Balances;
using inertia_moments::Input;
using inertia_moments::Shaft;
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

/// One balance shaft of the list: switch, order, direction, task, sizes, error of phase.
class ShaftRow : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(ravnoves::ShaftRow)

  public:
    ShaftRow(InertiaMomentsModel* model, int index, Form* form, QWidget* parent)
        : QWidget(parent), form_(form), index_(index) {
        QVBoxLayout* column = columnIn(this, Theme::gap, {0, Theme::gap, 0, Theme::gap});
        auto* first = addLine(column);
        enabled_ = new QCheckBox(this);
        name(enabled_, field::shaft_enabled, "shaft_enabled_%1");
        connect(enabled_, &QCheckBox::clicked, this,
                [=](bool on) { model->setShaftEnabled(index, on); });
        first->addWidget(enabled_);

        trouble_ = new TroubleLine(this);
        addNumber(first, field::shaft_order, "shaft_order_%1", orderWidth);
        addChoice(first, field::shaft_direction);
        addChoice(first, field::shaft_task);

        auto* remove = new QToolButton(this);
        remove->setIcon(themedIcon(QStringLiteral("minus")));
        remove->setAutoRaise(true);
        remove->setObjectName(QStringLiteral("remove_shaft_%1").arg(index));
        remove->setToolTip(tr("Remove this shaft"));
        remove->setAccessibleName(tr("Remove %1").arg(tr("Shaft %1").arg(index + 1)));
        connect(remove, &QToolButton::clicked, this, [=] { model->removeShaft(index); });
        first->addWidget(remove);

        auto* second = addLine(column);
        column->addWidget(trouble_);
        length_ = addNumber(second, field::weight_distance, "shaft_length_%1");
        position_ = addNumber(second, field::shaft_position, "shaft_position_%1");
        addNumber(second, field::weight_radius, "shaft_radius_%1");
        addNumber(second, field::phase_error, "shaft_error_%1")->setOptional(false);
        second->addWidget(new QLabel(unitText(field::phase_error.unit.name), this));
    }

    void show(const Shaft& shaft) {
        enabled_->setChecked(shaft.enabled);
        const bool moment = shaft.balances == Balances::moment;
        length_->parentWidget()->setVisible(moment);
        position_->parentWidget()->setVisible(!moment);
    }

  private:
    static QHBoxLayout* addLine(QVBoxLayout* column) {
        auto* line = new QHBoxLayout;
        line->setSpacing(Theme::gap);
        column->addLayout(line);
        return line;
    }

    /// "Shaft 2: Order of the shaft", with the field's explanation.
    void name(QWidget* widget, const Field& field, const char* objectName) const {
        makeCell(widget);
        widget->setObjectName(QString::fromLatin1(objectName).arg(index_));
        widget->setAccessibleName(
            tr("Shaft %1: %2").arg(QString::number(index_ + 1), fieldName(field)));
        widget->setToolTip(fieldHint(field));
    }

    std::string pointer(const Field& field) const {
        return "/balance_shafts/" + std::to_string(index_) + "/" + std::string(field.key);
    }

    void addChoice(QHBoxLayout* line, const Field& field) {
        auto* box = new QComboBox(this);
        for (const Word& word : field.words) {
            box->addItem(shownText(word.label), box->count());
        }
        name(box, field, "shaft_choice_%1");
        form_->bind(box, pointer(field));
        // The form is narrow: a list takes what room there is.
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(2);
        line->addWidget(box, 1);
    }

    /// @param width  of the field, in pixels; 0: it shares what room there is
    NumberField* addNumber(QHBoxLayout* line, const Field& field, const char* objectName,
                           int width = 0) {
        auto* holder = new QWidget(this);
        QHBoxLayout* pair = rowIn(holder, Theme::gap);
        auto* target = new NumberField(field, holder);
        name(target, field, objectName);
        target->setHint(fieldHint(field));
        if (width > 0) {
            target->setFixedWidth(Theme::withText(width));
        } else {
            target->setMinimumWidth(Theme::withText(46));
        }
        auto* label = new QLabel(
            QStringLiteral("&") + QString::fromStdString(std::string(field.symbol)), holder);
        label->setBuddy(target);
        pair->addWidget(label);
        pair->addWidget(target, 1);
        line->addWidget(holder, width > 0 ? 0 : 1);
        form_->bind(target, pointer(field));
        trouble_->watch(target);
        return target;
    }

    static constexpr int orderWidth = 30;  ///< pixels, for two digits

    Form* form_;
    int index_;
    QCheckBox* enabled_;
    NumberField* length_;    ///< of a shaft against a moment
    NumberField* position_;  ///< of one against a force
    TroubleLine* trouble_;
};

/// The list of balance shafts.
class ShaftList final : public QWidget {
  public:
    /// @param form  its rows are bound to the input there
    ShaftList(InertiaMomentsModel* model, Form* form) : QWidget(form), model_(model), form_(form) {
        columnIn(this, 0);
        connect(model_, &SceneModel::changed, this, [this] { follow(); });
        follow();
    }

  private:
    void follow() {
        const auto& shafts = model_->input().shafts;
        while (rows_.size() > shafts.size()) {
            // Its own button may be what removed it: it goes when that is done.
            layout()->removeWidget(rows_.back());
            rows_.back()->hide();
            rows_.back()->deleteLater();
            rows_.pop_back();
        }
        while (rows_.size() < shafts.size()) {
            rows_.push_back(new ShaftRow(model_, static_cast<int>(rows_.size()), form_, this));
            layout()->addWidget(rows_.back());
        }
        for (std::size_t i = 0; i < shafts.size(); ++i) {
            rows_[i]->show(shafts[i]);
        }
    }

    InertiaMomentsModel* model_;
    Form* form_;
    std::vector<ShaftRow*> rows_;
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
    current()->addWide(new ShaftList(model, this));
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
