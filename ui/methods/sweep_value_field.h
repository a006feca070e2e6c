#pragma once

#include <QWidget>

#include "methods/kernel.h"

class QLabel;
class QSlider;

namespace ravnoves {

class NumberField;

/// Slider and field for the value of a hard parameter. The slider goes by the sweep's own scale
/// (decades, or ever closer to a limit), the field takes any value of the sweep.
class SweepValueField : public QWidget {
    Q_OBJECT

  public:
    explicit SweepValueField(QWidget* parent = nullptr);

    /// Another hard parameter; its title is read out.
    void setSweep(const methods::SweepInfo& sweep, const QString& title);
    void setValue(double value);  ///< no signal
    QSlider* slider() const { return slider_; }
    NumberField* field() const { return field_; }

  Q_SIGNALS:
    /// The user moved or typed it.
    void valueEdited(double value);

  private:
    double valueAt(int tick) const;

    methods::SweepInfo sweep_;
    double factor_ = 1.0;  ///< numbers in the field per number of the value
    QSlider* slider_;
    NumberField* field_;
    QLabel* unit_;
};

/// Rounded as a person would set it: three digits of the value or, near a limit that values crowd
/// towards, of the distance from it.
double roundedForHand(const methods::SweepInfo& sweep, double value);

}  // namespace ravnoves
