#pragma once

#include <functional>
#include <utility>

#include "case-file/field.h"
#include "widgets/value_slider.h"

namespace ravnoves {

/// What a slider has of its own in place of what follows from its field, in its unit.
struct SliderOwn {
    QString label{};
    QString hint{};
    QString name{};           ///< of its box; the slider's has "_slider" behind it
    Unit unit = units::none;  ///< none: the field's
    std::function<std::pair<double, double>()> ends{};  ///< where it may be moved now
    std::function<bool()> isMovable{};
    std::function<bool()>
        isGiven{};  ///< by the case; else the value shown is dimmed, and can be typed
    // Of a number that is more than the field.
    std::function<double()> read{};
    std::function<void(double)> write{};
};

/// A slider for a number of the input: label with mnemonic, unit, hint, object names and the name
/// of the undo step follow from the field's description in core. It drags the model, follows it and
/// returns where it is rejected. It widens for a case beyond its ends.
class FieldSlider : public ValueSlider {
    Q_OBJECT

  public:
    /// @param pointer  of the field below "input"; a literal
    FieldSlider(SceneModel* model, const char* pointer, const SliderScale& scale, QWidget* parent,
                const SliderOwn& own = {});

    /// Shows the present value. Its ends rest while it is dragged.
    void follow();

  private:
    FieldSlider(SceneModel* model, const char* pointer, const Field& field,
                const SliderScale& scale, QWidget* parent, const SliderOwn& own);

    SliderOwn own_;
};

}  // namespace ravnoves
