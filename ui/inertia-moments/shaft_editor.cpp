#include "inertia-moments/shaft_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "inertia-moments/model/inertia_moments_model.h"
#include "text/number_text.h"
#include "theme/icons.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"

namespace ravnoves {

using inertia_moments::Balances;
using inertia_moments::Direction;
using inertia_moments::Shaft;
namespace field = inertia_moments::field;

class ShaftRow : public QWidget {
    Q_OBJECT

  public:
    ShaftRow(InertiaMomentsModel* model, int index, QWidget* parent)
        : QWidget(parent), model_(model), index_(index) {
        auto* column = new QVBoxLayout(this);
        column->setContentsMargins(0, Theme::gap, 0, Theme::gap);
        column->setSpacing(Theme::gap);
        auto* first = new QHBoxLayout;
        first->setSpacing(Theme::gap);
        column->addLayout(first);
        const QString shaft = tr("Shaft %1").arg(index + 1);

        enabled_ = new QCheckBox(this);
        enabled_->setObjectName(QStringLiteral("shaft_enabled_%1").arg(index));
        enabled_->setAccessibleName(tr("%1 is on").arg(shaft));
        enabled_->setToolTip(tr("Switched on, the shaft counts in what is left over."));
        connect(enabled_, &QCheckBox::clicked, this,
                [this](bool on) { model_->setShaftEnabled(index_, on); });
        first->addWidget(enabled_);

        order_ = new QSpinBox(this);
        order_->setRange(1, inertia_moments::highest_order);
        order_->setPrefix(tr("k "));
        order_->setMaximumWidth(52);
        order_->setKeyboardTracking(false);
        order_->setObjectName(QStringLiteral("shaft_order_%1").arg(index));
        order_->setAccessibleName(tr("Order of %1").arg(shaft));
        order_->setToolTip(tr("Order that the shaft cancels; it turns k times as fast as the "
                              "crank. 1 to %1.")
                               .arg(inertia_moments::highest_order));
        connect(order_, qOverload<int>(&QSpinBox::valueChanged), this, [this](int order) {
            model_->editShaft(index_, tr("Order of the shaft"),
                              [order](Shaft& s) { s.order = order; });
        });
        first->addWidget(order_);

        direction_ = new QComboBox(this);
        direction_->addItems({tr("+kω"), tr("−kω")});
        direction_->setAccessibleName(tr("Direction of %1").arg(shaft));
        direction_->setToolTip(tr("With the crank (+kω) or against it (−kω)"));
        connect(direction_, &QComboBox::activated, this, [this](int which) {
            model_->editShaft(index_, tr("Direction of the shaft"), [which](Shaft& s) {
                s.direction = which == 0 ? Direction::forward : Direction::backward;
            });
        });
        narrow(direction_);
        first->addWidget(direction_, 1);

        task_ = new QComboBox(this);
        task_->addItems({tr("moment"), tr("force")});
        task_->setAccessibleName(tr("Task of %1").arg(shaft));
        task_->setToolTip(tr("Two opposite weights against a moment, one against a force"));
        connect(task_, &QComboBox::activated, this, [this](int which) {
            model_->editShaft(index_, tr("Task of the shaft"), [which](Shaft& s) {
                s.balances = which == 0 ? Balances::moment : Balances::force;
            });
        });
        narrow(task_);
        first->addWidget(task_, 1);

        auto* remove = new QToolButton(this);
        remove->setIcon(themedIcon(QStringLiteral("minus")));
        remove->setAutoRaise(true);
        remove->setObjectName(QStringLiteral("remove_shaft_%1").arg(index));
        remove->setToolTip(tr("Remove this shaft"));
        remove->setAccessibleName(tr("Remove %1").arg(shaft));
        connect(remove, &QToolButton::clicked, this, [this] { model_->removeShaft(index_); });
        first->addWidget(remove);

        auto* second = new QHBoxLayout;
        second->setSpacing(Theme::gap);
        column->addLayout(second);
        const auto number = [&](QLabel*& label, const QString& text, const FieldSpec& spec,
                                const QString& name, const QString& hint) {
            auto* target = new NumberField(spec, this);
            target->setRange(spec.range, unitText(spec.unit));
            target->setHint(hint);
            target->setAccessibleName(name + QStringLiteral(", ") + unitText(spec.unit));
            target->setMinimumWidth(36);
            label = new QLabel(text, this);
            label->setBuddy(target);
            second->addWidget(label);
            second->addWidget(target, 1);
            return target;
        };
        QLabel* unused = nullptr;
        length_ = number(lengthLabel_, tr("&L"), field::weight_distance,
                         tr("Distance of the weights of %1").arg(shaft), {});
        length_->setObjectName(QStringLiteral("shaft_length_%1").arg(index));
        radius_ = number(unused, tr("&ρ"), field::weight_radius,
                         tr("Radius of the weights of %1").arg(shaft),
                         tr("Radius of the weights' centres of mass; gives their mass. Empty: only "
                            "mρ is given."));
        radius_->setOptional(true);
        error_ = number(unused, tr("&δ"), field::phase_error, tr("Error of phase of %1").arg(shaft),
                        tr("Error of the shaft's phase, ahead in its own direction: 0 when it is "
                           "timed right."));
        error_->setObjectName(QStringLiteral("shaft_error_%1").arg(index));
        auto* degreeLabel = new QLabel(QStringLiteral("°"), this);
        second->addWidget(degreeLabel);
        connect(length_, &NumberField::valueEdited, this, [this](std::optional<double> value) {
            model_->editShaft(index_, tr("Place of the shaft"), [&](Shaft& s) {
                if (s.balances == Balances::moment) {
                    s.weight_distance = *value * field::millimetre;
                } else {
                    s.axial_position =
                        value ? std::optional(*value * field::millimetre) : std::nullopt;
                }
            });
        });
        connect(radius_, &NumberField::valueEdited, this, [this](std::optional<double> value) {
            model_->editShaft(index_, tr("Radius of the shaft's weights"), [&](Shaft& s) {
                s.weight_radius = value ? std::optional(*value * field::millimetre) : std::nullopt;
            });
        });
        connect(error_, &NumberField::valueEdited, this, [this](std::optional<double> value) {
            model_->editShaft(index_, tr("Phase of the shaft"),
                              [&](Shaft& s) { s.phase_error = *value * degree; });
        });
    }

    void show(const Shaft& shaft) {
        enabled_->setChecked(shaft.enabled);
        {
            const QSignalBlocker quiet(order_);
            order_->setValue(shaft.order);
        }
        direction_->setCurrentIndex(shaft.direction == Direction::forward ? 0 : 1);
        const bool moment = shaft.balances == Balances::moment;
        task_->setCurrentIndex(moment ? 0 : 1);
        lengthLabel_->setText(moment ? tr("&L") : tr("&z"));
        const FieldSpec& place = moment ? field::weight_distance : field::shaft_position;
        if (moment_ != moment) {
            moment_ = moment;
            length_->setRange(place.range, unitText(place.unit));
            length_->setOptional(!moment);
            length_->setPlaceholderText(moment ? QString() : tr("c. m."));
            length_->setHint(moment ? tr("Distance between the two weights along the shaft")
                                    : tr("Axial position of the weight; empty: at the point that "
                                         "moments refer to"));
        }
        length_->setValue(moment ? std::optional(from_si(place, shaft.weight_distance))
                          : shaft.axial_position
                              ? std::optional(from_si(place, *shaft.axial_position))
                              : std::nullopt);
        radius_->setValue(shaft.weight_radius
                              ? std::optional(from_si(field::weight_radius, *shaft.weight_radius))
                              : std::nullopt);
        error_->setValue(from_si(field::phase_error, shaft.phase_error));
    }

  private:
    /// The form is narrow: a list takes what room there is.
    static void narrow(QComboBox* box) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(2);
    }

    InertiaMomentsModel* model_;
    int index_;
    std::optional<bool> moment_;  ///< task that the place's field is set up for
    QCheckBox* enabled_;
    QSpinBox* order_;
    QComboBox* direction_;
    QComboBox* task_;
    QLabel* lengthLabel_ = nullptr;
    NumberField* length_;
    NumberField* radius_;
    NumberField* error_;
};

ShaftEditor::ShaftEditor(InertiaMomentsModel* model, QWidget* parent)
    : QWidget(parent), model_(model) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    list_ = new QVBoxLayout;
    list_->setSpacing(0);
    column->addLayout(list_);
    connect(model_, &SceneModel::changed, this, &ShaftEditor::refresh);
    refresh();
}

void ShaftEditor::refresh() {
    const auto& shafts = model_->input().shafts;
    while (rows_.size() > shafts.size()) {
        // Its own button may be what removed it: it goes when that is done.
        list_->removeWidget(rows_.back());
        rows_.back()->hide();
        rows_.back()->deleteLater();
        rows_.pop_back();
    }
    while (rows_.size() < shafts.size()) {
        auto* row = new ShaftRow(model_, static_cast<int>(rows_.size()), this);
        list_->addWidget(row);
        rows_.push_back(row);
    }
    for (std::size_t i = 0; i < shafts.size(); ++i) {
        rows_[i]->show(shafts[i]);
    }
}

}  // namespace ravnoves

#include "shaft_editor.moc"
