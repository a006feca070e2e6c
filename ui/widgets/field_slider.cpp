#include "widgets/field_slider.h"

#include <QSlider>
#include <algorithm>

#include "model/scene_model.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "widgets/number_field.h"

namespace ravnoves {

namespace {

/// What is the slider's own, and for the rest what follows from the field.
SliderOwn completed(SceneModel* model, const char* pointer, const SliderScale& scale,
                    SliderOwn own) {
    const Field field = model->describedField(pointer).field;
    if (own.label.isEmpty()) {
        own.label = shownText(field.label);
    }
    if (own.hint.isEmpty()) {
        own.hint = fieldHint(field);
    }
    if (own.name.isEmpty()) {
        own.name = QString::fromStdString(std::string(field.key));
    }
    if (own.unit == units::none) {
        own.unit = field.unit;
    }
    const double factor = own.unit.to_si / field.unit.to_si;
    if (!own.ends) {
        own.ends = [ends = std::pair(scale.min, scale.max)] { return ends; };
    }
    if (!own.read) {
        own.read = [=] { return std::get<double>(model->fields(pointer).front().value) / factor; };
    }
    if (!own.write) {
        own.write = [=, step = fieldName(field)](double value) {
            model->dragField(pointer, value * factor, step);
        };
    }
    return own;
}

}  // namespace

FieldSlider::FieldSlider(SceneModel* model, const char* pointer, const SliderScale& scale,
                         QWidget* parent, const SliderOwn& own)
    : FieldSlider(completed(model, pointer, scale, own), scale, parent) {
    slider()->setObjectName(own_.name + QStringLiteral("_slider"));
    box()->setObjectName(own_.name);
    setHint(own_.hint);
    setModel(model);
    connect(this, &ValueSlider::valueEdited, this, own_.write);
    // A drag is a step of its own: what keys moved before it is another.
    connect(this, &ValueSlider::pressed, model, &SceneModel::finishDrag);
    connect(this, &ValueSlider::released, model, &SceneModel::finishDrag);
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

FieldSlider::FieldSlider(const SliderOwn& own, const SliderScale& scale, QWidget* parent)
    : ValueSlider(own.label, scale.min, scale.max, scale.step, scale.page, scale.decimals,
                  unitText(own.unit.name), parent),
      own_(own) {}

void FieldSlider::follow() {
    const double value = own_.read();
    const auto [min, max] = own_.ends();
    setEnabled(!own_.isMovable || own_.isMovable());
    setGiven(!own_.isGiven || own_.isGiven());
    setValue(value);  // before its ends: those would pull the value from before to them
    if (!slider()->isSliderDown()) {
        setRange(std::min(min, value), std::max(max, value));
    }
}

}  // namespace ravnoves
