#include "methods/sweep_value_field.h"

#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "case-file/decimal.h"
#include "case-file/range.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/layouts.h"
#include "widgets/number_field.h"

namespace ravnoves {

namespace {

constexpr int sliderSteps = 1000;
constexpr int fieldWidth = 96;  ///< pixels, for ten digits

}  // namespace

double roundedForHand(const methods::SweepInfo& sweep, double value) {
    constexpr int digits = 3;
    const double span = sweep.to - sweep.from;
    double rounded = rounded_to_digits(value, digits);
    if (sweep.spacing == methods::Spacing::towards_end && sweep.to - value < 0.1 * span) {
        rounded = sweep.to - rounded_to_digits(sweep.to - value, digits);
    }
    return std::clamp(rounded, sweep.at(0.0), sweep.at(1.0));
}

SweepValueField::SweepValueField(QWidget* parent) : QWidget(parent) {
    QHBoxLayout* row = rowIn(this);
    slider_ = new QSlider(Qt::Horizontal, this);
    slider_->setObjectName(QStringLiteral("value_slider"));
    slider_->setRange(0, sliderSteps);
    slider_->setPageStep(sliderSteps / 20);
    slider_->setFocusPolicy(Qt::StrongFocus);
    field_ = new NumberField(this);
    field_->setObjectName(QStringLiteral("value"));
    field_->setFixedWidth(Theme::withText(fieldWidth));
    unit_ = new QLabel(this);
    setFocusProxy(field_);
    row->addWidget(slider_, 1);
    row->addWidget(field_);
    row->addWidget(unit_);
    connect(slider_, &QSlider::valueChanged, this, [this](int tick) {
        const double value = valueAt(tick);
        field_->setValue(factor_ * value);
        Q_EMIT valueEdited(value);
    });
    connect(field_, &NumberField::valueEdited, this, [this](std::optional<double> value) {
        if (value) {
            const double own = std::clamp(*value / factor_, sweep_.from, sweep_.to);
            setValue(own);
            Q_EMIT valueEdited(own);
        }
    });
}

void SweepValueField::setSweep(const methods::SweepInfo& sweep, const QString& title) {
    sweep_ = sweep;
    const ShownUnit unit = shownUnit(sweep.unit);
    factor_ = unit.factor;
    field_->setRange(Range::between(factor_ * sweep.from, factor_ * sweep.to), unit.name);
    field_->setHint(title);
    field_->setAccessibleName(title);
    slider_->setAccessibleName(title);
    slider_->setToolTip(title);
    unit_->setText(unit.name);
    unit_->setVisible(!unit.name.isEmpty());
}

void SweepValueField::setValue(double value) {
    // The handle stays where the hand has put it, though the value was rounded.
    if (valueAt(slider_->value()) != value) {
        const QSignalBlocker quiet(slider_);
        slider_->setValue(static_cast<int>(std::lround(sweep_.place(value) * sliderSteps)));
    }
    field_->setValue(factor_ * value);
}

double SweepValueField::valueAt(int tick) const {
    return roundedForHand(sweep_, sweep_.at(static_cast<double>(tick) / sliderSteps));
}

}  // namespace ravnoves
