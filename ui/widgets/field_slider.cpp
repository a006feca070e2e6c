#include "widgets/field_slider.h"

#include <QSlider>
#include <algorithm>

#include "model/scene_model.h"
#include "text/message_text.h"
#include "text/number_text.h"
#include "widgets/number_field.h"

namespace ravnoves {

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
    setGiven(!own_.isGiven || own_.isGiven());
    setValue(value);  // before its ends: those would pull the value from before to them
    if (!slider()->isSliderDown()) {
        setRange(std::min(min, value), std::max(max, value));
    }
}

}  // namespace ravnoves
