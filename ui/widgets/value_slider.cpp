#include "widgets/value_slider.h"

#include <QGridLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "case-file/decimal.h"
#include "case-file/range.h"
#include "model/scene_model.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "text/shown_units.h"
#include "theme/theme.h"
#include "widgets/form_section.h"
#include "widgets/number_field.h"

namespace ravnoves {

namespace {

constexpr int minSlider = 110;  ///< designed pixels with which a slider can be used

int wide(const QWidget* widget) {
    return widget->minimumWidth() > 0 ? widget->minimumWidth() : widget->sizeHint().width();
}

}  // namespace

ValueSlider::ValueSlider(const QString& label, const SliderScale& scale, const QString& unit,
                         QWidget* parent)
    : QWidget(parent), grid_(new QGridLayout(this)), scale_(scale) {
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(Theme::space);
    grid_->setVerticalSpacing(0);
    grid_->setColumnStretch(1, 1);
    label_ = new QLabel(label, this);
    slider_ = new QSlider(Qt::Horizontal, this);
    box_ = new NumberField(this);
    const ShownUnit shown = shownUnit(unit);
    box_->setShownUnit(shown);
    if (scale.decimals >= 0) {
        box_->setPlaces(std::max(0, scale.decimals + shown.decimals));
    }
    box_->setStep(shown.factor == 1.0 ? scale.step
                                      : rounded_to_digits(scale.step * shown.factor, 1));
    unit_ = new QLabel(shown.name, this);
    colourText(unit_, &Theme::mutedText);
    label_->setBuddy(box_);
    QString spoken = label;
    spoken.remove(QLatin1Char('&'));
    slider_->setAccessibleName(spoken);
    box_->setAccessibleName(spoken + QStringLiteral(", ") + shown.name);
    slider_->setSingleStep(1);
    slider_->setPageStep(scale.stepsPerDecade > 0
                             ? scale.stepsPerDecade
                             : std::max(1, static_cast<int>(std::lround(scale.page / scale.step))));
    slider_->setFocusPolicy(Qt::StrongFocus);
    trouble_ = new TroubleLine(this);
    trouble_->watch(box_, false);
    // One row: label, slider, field, unit. Two: the slider below the others.
    grid_->addWidget(label_, 0, 0);
    grid_->addWidget(slider_, 0, 1);
    grid_->addWidget(box_, 0, 2);
    grid_->addWidget(unit_, 0, 3);
    grid_->addWidget(trouble_, 2, 0, 1, 4);
    showRange();
    connect(slider_, &QSlider::valueChanged, this, [this](int tick) { edit(valueAt(tick)); });
    connect(box_, &NumberField::valueEdited, this,
            [this](std::optional<double> value) { edit(value.value_or(value_)); });
}

ValueSlider::~ValueSlider() {
    // A field that loses the focus by that says that its editing ends: nobody is there to hear it.
    slider_->disconnect(this);
    box_->disconnect(this);
}

QString ValueSlider::trouble() const {
    return trouble_->text();
}

void ValueSlider::setModel(SceneModel* model) {
    box_->setModel(model);
    connect(model, &SceneModel::rejected, this, [this](const QString& why) {
        if (isPassing_ && !box_->isEditing()) {
            trouble_->say(why);
        }
    });
    connect(model, &SceneModel::broughtIn, this, [this] { trouble_->say({}); });
}

void ValueSlider::align(const QList<ValueSlider*>& sliders) {
    const auto fix = [&](auto part) {
        int widest = 0;
        for (const ValueSlider* slider : sliders) {
            widest = std::max(widest, wide(slider->*part));
        }
        for (const ValueSlider* slider : sliders) {
            (slider->*part)->setFixedWidth(widest);
        }
    };
    fix(&ValueSlider::label_);
    fix(&ValueSlider::box_);
    fix(&ValueSlider::unit_);
}

int ValueSlider::widthInOneRow() const {
    return wide(label_) + Theme::withText(minSlider) + wide(box_) + wide(unit_) + 3 * Theme::space;
}

QSize ValueSlider::sizeHint() const {
    return {widthInOneRow(), grid_->sizeHint().height()};
}

QSize ValueSlider::minimumSizeHint() const {
    const int inTwo = label_->minimumSizeHint().width() + box_->minimumWidth() +
                      unit_->sizeHint().width() + 2 * Theme::space;
    return {std::max(inTwo, Theme::withText(minSlider)), grid_->minimumSize().height()};
}

void ValueSlider::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool folded = width() < widthInOneRow();
    if (folded == folded_) {
        return;
    }
    folded_ = folded;
    grid_->removeWidget(slider_);
    if (folded) {
        grid_->addWidget(slider_, 1, 0, 1, 4);
    } else {
        grid_->addWidget(slider_, 0, 1);
    }
    updateGeometry();
}

void ValueSlider::setRange(double min, double max) {
    if (min != scale_.min || max != scale_.max) {
        scale_.min = min;
        scale_.max = max;
        showRange();
    }
}

void ValueSlider::showRange() {
    const QSignalBlocker quiet(slider_);
    slider_->setRange(0, tickOf(scale_.max));
    box_->setRange(Range::between(scale_.min, scale_.max), unit_->text());
    const QFontMetrics metrics = box_->fontMetrics();
    constexpr int frame = 14;
    const int widest = std::max({metrics.horizontalAdvance(box_->textOf(scale_.min)),
                                 metrics.horizontalAdvance(box_->textOf(scale_.max)),
                                 metrics.horizontalAdvance(QStringLiteral("000.00"))});
    box_->setFixedWidth(widest + frame);
    setValue(std::clamp(value_, scale_.min, scale_.max));
}

int ValueSlider::tickOf(double value) const {
    const auto [min, max, step, page, decimals, perDecade, digits] = scale_;
    const double ticks = perDecade > 0 ? perDecade * std::log10(std::clamp(value, min, max) / min)
                                       : (value - min) / step;
    return static_cast<int>(std::lround(ticks));
}

double ValueSlider::valueAt(int tick) const {
    const auto [min, max, step, page, decimals, perDecade, digits] = scale_;
    if (perDecade > 0) {
        const double value = min * std::pow(10.0, static_cast<double>(tick) / perDecade);
        return std::clamp(rounded_to_digits(value, digits), min, max);
    }
    // Whole steps come out as the decimals they stand for (50.1, not 50.10000000000001).
    const double parts = std::pow(10.0, decimals);
    return std::round(std::min(max, min + tick * step) * parts) / parts;
}

void ValueSlider::setHint(const QString& hint) {
    explain(label_, hint);
    explain(slider_, hint);
    box_->setHint(hint);
}

void ValueSlider::setValue(double value) {
    if (value != value_ && !isPassing_ && !box_->isEditing()) {
        trouble_->say({});
    }
    setBesideTyped(value);
    box_->setValue(value);
}

void ValueSlider::setBesideTyped(double value) {
    value_ = value;
    const QSignalBlocker quiet(slider_);
    slider_->setValue(tickOf(value));
}

void ValueSlider::edit(double value) {
    value = rounded_to_digits(value, 12);
    if (value == value_) {
        return;
    }
    if (!box_->isEditing()) {
        trouble_->say({});
    }
    const QScopedValueRollback passing(isPassing_, true);
    setValue(value);
    Q_EMIT valueEdited(value);
}

FieldSlider::FieldSlider(SceneModel* model, const char* pointer, const SliderScale& scale,
                         QWidget* parent, const SliderOwn& own)
    : FieldSlider(model, pointer, model->describedField(pointer).field, scale, parent, own) {}

FieldSlider::FieldSlider(SceneModel* model, const char* pointer, const Field& field,
                         const SliderScale& scale, QWidget* parent, const SliderOwn& own)
    : ValueSlider(own.label.isEmpty() ? shownText(field.label) : own.label, scale,
                  unitText((own.unit == units::none ? field.unit : own.unit).name), parent),
      own_(own) {
    const double factor = own.unit == units::none ? 1.0 : own.unit.to_si / field.unit.to_si;
    if (!own_.ends) {
        own_.ends = [ends = std::pair(scale.min, scale.max)] { return ends; };
    }
    if (!own_.read) {
        own_.read = [=] { return std::get<double>(model->fields(pointer).front().value) / factor; };
    }
    if (!own_.write) {
        own_.write = [=, step = fieldName(field)](double value) {
            model->dragField(pointer, value * factor, step);
        };
    }
    const QString name =
        own.name.isEmpty() ? QString::fromStdString(std::string(field.key)) : own.name;
    slider()->setObjectName(name + QStringLiteral("_slider"));
    box()->setObjectName(name);
    setHint(own.hint.isEmpty() ? fieldHint(field) : own.hint);
    setModel(model);
    connect(this, &ValueSlider::valueEdited, this, own_.write);
    if (own_.isGiven) {
        connect(&Theme::instance(), &Theme::changed, this, &FieldSlider::follow);
        connect(box(), &QLineEdit::returnPressed, this, [this] {
            if (!own_.isGiven() && box()->trouble().isEmpty()) {
                Q_EMIT valueEdited(value());
            }
        });
    }
    // A drag is a step of its own: what keys moved before it is another.
    connect(slider(), &QSlider::sliderPressed, model, &SceneModel::finishDrag);
    connect(slider(), &QSlider::sliderReleased, model, &SceneModel::finishDrag);
    connect(slider(), &QSlider::sliderReleased, this, &FieldSlider::follow);
    connect(model, &SceneModel::changed, this, &FieldSlider::follow);
    connect(model, &SceneModel::rejected, this, [this](const QString& why) {
        if (box()->isEditing()) {
            setBesideTyped(own_.read());
        } else if (!why.isEmpty() && value() != own_.read()) {
            follow();
        }
    });
    follow();
}

void FieldSlider::follow() {
    const double value = own_.read();
    const auto [min, max] = own_.ends();
    setEnabled(!own_.isMovable || own_.isMovable());
    if (own_.isGiven) {
        QPalette palette;
        if (!own_.isGiven()) {
            palette.setColor(QPalette::Text, Theme::instance().mutedText());
        }
        box()->setPalette(palette);
    }
    setValue(value);  // before its ends: those would pull the value from before to them
    if (!slider()->isSliderDown()) {
        setRange(std::min(min, value), std::max(max, value));
    }
}

}  // namespace ravnoves
