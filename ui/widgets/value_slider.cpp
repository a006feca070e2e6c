#include "widgets/value_slider.h"

#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyleOptionSlider>
#include <algorithm>
#include <cmath>
#include <utility>

#include "case-file/decimal.h"
#include "case-file/range.h"
#include "model/scene_model.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "text/typed_number.h"
#include "theme/theme.h"
#include "widgets/decimal_spin_box.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"

namespace ravnoves {

namespace {

constexpr int leastSlider = 116;  ///< designed pixels with which a slider can be used

class Slider final : public QSlider {
  public:
    using QSlider::QSlider;

    bool isHandle(const QPoint& at) const {
        QStyleOptionSlider option;
        initStyleOption(&option);
        return style()->hitTestComplexControl(QStyle::CC_Slider, &option, at, this) ==
               QStyle::SC_SliderHandle;
    }
};

}  // namespace

ValueSlider::ValueSlider(const QString& label, double min, double max, double step, double pageStep,
                         int decimals, const QString& unit, QWidget* parent)
    : QWidget(parent),
      grid_(new QGridLayout(this)),

      min_(min),
      max_(max),
      step_(step) {
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(Theme::space);
    grid_->setVerticalSpacing(0);
    grid_->setColumnStretch(1, 1);
    label_ = new QLabel(label, this);
    slider_ = new Slider(Qt::Horizontal, this);
    box_ = new DecimalSpinBox(this);
    const ShownUnit shown = shownUnit(unit);
    unit_ = shown.name;
    factor_ = shown.factor;
    decimals_ = std::max(0, decimals + shown.decimals);
    box_->setDecimals(decimals_);
    box_->setSingleStep(factor_ == 1.0 ? step : rounded_to_digits(step * factor_, 1));
    box_->setSuffix(withUnit({}, shown.name));
    label_->setBuddy(box_);
    QString spoken = label;
    spoken.remove(QLatin1Char('&'));
    slider_->setAccessibleName(spoken);
    box_->setAccessibleName(spoken + QStringLiteral(", ") + shown.name);
    slider_->setSingleStep(1);
    slider_->setPageStep(std::max(1, static_cast<int>(std::lround(pageStep / step))));
    slider_->setFocusPolicy(Qt::StrongFocus);
    slider_->installEventFilter(this);
    box_->installEventFilter(this);
    trouble_ = new TroubleLine(this);
    // One row: label, slider, box. Two: the slider below both.
    grid_->addWidget(label_, 0, 0);
    grid_->addWidget(slider_, 0, 1);
    grid_->addWidget(box_, 0, 2);
    grid_->addWidget(trouble_, 2, 0, 1, 3);
    showRange();
    connect(slider_, &QSlider::valueChanged, this, [this](int tick) {
        // Whole steps come out as the decimals they stand for (50.1, not 50.10000000000001); those
        // of a logarithm may be smaller than what the box shows.
        const double value = valueAt(tick);
        const double parts = std::pow(10.0, decimals_);
        edit(factor_ == 1.0 && stepsPerDecade_ == 0 ? std::round(value * parts) / parts : value);
    });
    connect(slider_, &QSlider::sliderPressed, this, &ValueSlider::pressed);
    connect(slider_, &QSlider::sliderReleased, this, &ValueSlider::released);
    connect(box_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this](double shown) { edit(valueOf(shown)); });
    connect(box_, &QDoubleSpinBox::editingFinished, this, &ValueSlider::released);
    connect(box_, &DecimalSpinBox::refused, this, &ValueSlider::sayOutOfRange);
    connect(box_->findChild<QLineEdit*>(), &QLineEdit::textEdited, this, [this] {
        refuse({});
        if (!std::exchange(isTyped_, true)) {
            typedOver_ = value_;
        }
    });
    connect(box_, &QDoubleSpinBox::editingFinished, this, [this] {
        if (!std::exchange(isTyped_, false) || !trouble().isEmpty()) {
            return;
        }
        // Typed as the box shows a number that has no end: that number is meant.
        if (value_ == typedOver_) {
            edit(valueOf(box_->value()));
        }
        if (!isGiven_) {
            const QScopedValueRollback passing(isPassing_, true);
            Q_EMIT valueEdited(value_);
        }
    });
    connect(&Theme::instance(), &Theme::changed, this, &ValueSlider::inkBox);
}

void ValueSlider::setGiven(bool isGiven) {
    if (isGiven != isGiven_) {
        isGiven_ = isGiven;
        inkBox();
    }
}

void ValueSlider::inkBox() {
    QPalette palette;
    if (!isGiven_) {
        palette.setColor(QPalette::Text, Theme::instance().mutedText());
    }
    box_->setPalette(palette);
}

ValueSlider::~ValueSlider() {
    // A box that loses the focus by that says that its editing ends: nobody is there to hear it.
    slider_->disconnect(this);
    box_->disconnect(this);
}

QDoubleSpinBox* ValueSlider::box() const {
    return box_;
}

void ValueSlider::refuse(const QString& why) {
    if (why != trouble_->text()) {
        trouble_->say(why);
        box_->setAccessibleDescription(why);
    }
}

QString ValueSlider::trouble() const {
    return trouble_->text();
}

void ValueSlider::setModel(SceneModel* model) {
    connect(model, &SceneModel::refused, this, [this](const QString& why) {
        if (isPassing_) {
            refuse(why);
        }
    });
    connect(model, &SceneModel::broughtIn, this, [this] { refuse({}); });
}

void ValueSlider::sayOutOfRange(const QString& typed) {
    const auto [number, trouble] = readTypedNumber(typed, unit_);
    const auto thousands = readWithThousands(typed, unit_);
    const Range range = Range::between(box_->minimum(), box_->maximum());
    if (number && thousands && range.contains(*thousands)) {
        refuse(eitherNumberText(typed, *thousands, *number));
        return;
    }
    if (!number && trouble.isEmpty()) {
        refuse(notANumberText(typed));
        return;
    }
    const QString rule =
        number ? NumberField::tr("The value %1.").arg(rangeText(range, unit_)) : trouble;
    refuse(tr("“%1” is refused. %2").arg(typed, rule));
}

void ValueSlider::setLabelWidth(int width) {
    label_->setFixedWidth(width);
}

int ValueSlider::widthInOneRow() const {
    const auto wide = [](const QWidget* widget) {
        return widget->minimumWidth() > 0 ? widget->minimumWidth() : widget->sizeHint().width();
    };
    return wide(label_) + Theme::withText(leastSlider) + wide(box_) + 2 * Theme::space;
}

QSize ValueSlider::sizeHint() const {
    return {widthInOneRow(), grid_->sizeHint().height()};
}

QSize ValueSlider::minimumSizeHint() const {
    const int inTwo =
        std::max(label_->minimumSizeHint().width() + Theme::space + box_->minimumSizeHint().width(),
                 Theme::withText(leastSlider));
    return {inTwo, grid_->minimumSize().height()};
}

void ValueSlider::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void ValueSlider::arrange() {
    const bool folded = width() < widthInOneRow();
    if (folded == folded_) {
        return;
    }
    folded_ = folded;
    grid_->removeWidget(slider_);
    if (folded) {
        grid_->addWidget(slider_, 1, 0, 1, 3);
    } else {
        grid_->addWidget(slider_, 0, 1);
    }
    updateGeometry();
}

void ValueSlider::setRange(double min, double max) {
    if (min != min_ || max != max_) {  // the box has the whole page laid out anew
        min_ = min;
        max_ = max;
        showRange();
    }
}

void ValueSlider::showRange() {
    const QSignalBlocker quietSlider(slider_);
    const QSignalBlocker quietBox(box_);
    slider_->setRange(0, tickOf(max_));
    box_->setRange(min_ * factor_, max_ * factor_);
    setValue(std::clamp(value_, min_, max_));
}

void ValueSlider::setLogarithmic(int stepsPerDecade, int digits) {
    stepsPerDecade_ = stepsPerDecade;
    digits_ = digits;
    slider_->setPageStep(stepsPerDecade);
    box_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    showRange();
}

int ValueSlider::tickOf(double value) const {
    if (stepsPerDecade_ > 0) {
        return static_cast<int>(
            std::lround(stepsPerDecade_ * std::log10(std::clamp(value, min_, max_) / min_)));
    }
    return static_cast<int>(std::lround((value - min_) / step_));
}

double ValueSlider::valueAt(int tick) const {
    if (stepsPerDecade_ > 0) {
        const double value = min_ * std::pow(10.0, static_cast<double>(tick) / stepsPerDecade_);
        return std::clamp(rounded_to_digits(value, digits_), min_, max_);
    }
    return std::min(max_, min_ + tick * step_);
}

void ValueSlider::setHint(const QString& hint) {
    label_->setToolTip(hint);
    slider_->setToolTip(hint);
    box_->setToolTip(hint);
}

void ValueSlider::setTickInterval(double interval) {
    slider_->setTickPosition(QSlider::TicksBelow);
    slider_->setTickInterval(std::max(1, static_cast<int>(std::lround(interval / step_))));
}

void ValueSlider::setValue(double value) {
    if (value != value_ && !isPassing_) {
        refuse({});
    }
    value_ = value;
    const QSignalBlocker quietSlider(slider_);
    const QSignalBlocker quietBox(box_);
    slider_->setValue(tickOf(value));
    if (const int decimals = decimalsOf(value * factor_); decimals != box_->decimals()) {
        box_->setDecimals(decimals);
    }
    // A box paints itself anew also where it shows that already.
    const double shown =
        QString::number(value * factor_, 'f', box_->decimals()).toDouble();  // as the box rounds
    if (shown != box_->value() || box_->cleanText() != box_->textFromValue(shown)) {
        box_->setValue(value * factor_);
    }
}

double ValueSlider::valueOf(double shown) const {
    // The ends of the box are rounded, those of the value are not.
    return factor_ == 1.0             ? shown
           : shown == box_->minimum() ? min_
           : shown == box_->maximum() ? max_
                                      : shown / factor_;
}

QString ValueSlider::wholeText() const {
    constexpr int digits = 12;
    return isTyped_ ? QString()
                    : wholeNumber(rounded_to_digits(value_ * factor_, digits), box_->cleanText());
}

int ValueSlider::decimalsOf(double shown) const {
    constexpr int more = 5;
    // Values have 12 digits.
    const double rounding = 6e-12 * std::max(std::abs(shown), 1e-3);
    double parts = std::pow(10.0, decimals_);
    for (int decimals = decimals_; decimals <= decimals_ + more; ++decimals, parts *= 10.0) {
        if (std::abs(std::round(shown * parts) / parts - shown) <= rounding) {
            return decimals;
        }
    }
    return decimals_;  // what was computed has no end
}

void ValueSlider::edit(double value) {
    value = rounded_to_digits(value, 12);
    refuse({});
    if (value == value_) {
        return;
    }
    setValue(value);
    const QScopedValueRollback passing(isPassing_, true);
    Q_EMIT valueEdited(value);
}

bool ValueSlider::eventFilter(QObject* watched, QEvent* event) {
    if (watched == slider_ && event->type() == QEvent::MouseButtonPress) {
        const auto* press = static_cast<QMouseEvent*>(event);
        gripped_ = static_cast<Slider*>(slider_)->isHandle(press->position().toPoint());
    }
    // Two clicks beside the handle are two steps towards them.
    if (watched == slider_ && event->type() == QEvent::MouseButtonDblClick && gripped_) {
        box_->setFocus(Qt::MouseFocusReason);
        box_->selectAll();
        return true;
    }
    if (watched == box_ && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
        (!trouble().isEmpty() || box_->cleanText() != box_->textFromValue(box_->value()))) {
        box_->setValue(box_->value());
        box_->selectAll();
        refuse({});
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace ravnoves
