#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace ravnoves {

/// A slider with a spin box for one value: drag, arrow keys (one step), page keys (a larger step),
/// wheel; a double click on the slider goes to the box to type.
class ValueSlider : public QWidget {
    Q_OBJECT

  public:
    /// @param label  with & for the mnemonic
    ValueSlider(const QString& label, double min, double max, double step, double pageStep,
                int decimals, const QString& unit, QWidget* parent = nullptr);

    double value() const { return value_; }
    void setValue(double value);  ///< no signal
    void setRange(double min, double max);
    void setHint(const QString& hint);
    void setTickInterval(double interval);
    /// The slider goes by the value's logarithm: a step is one part of a decade. Values are rounded
    /// to `digits` significant digits when the slider is moved. The range must be positive.
    void setLogarithmic(int stepsPerDecade, int digits);
    QSlider* slider() const { return slider_; }
    QDoubleSpinBox* box() const { return box_; }

  Q_SIGNALS:
    /// The user moved it.
    void valueEdited(double value);
    void pressed();
    void released();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void edit(double value);
    void showRange();
    int tickOf(double value) const;
    double valueAt(int tick) const;

    QLabel* label_;
    QSlider* slider_;
    QDoubleSpinBox* box_;
    double factor_ = 1.0;  ///< numbers in the box per number of the value
    double min_;
    double max_;
    double step_;
    double value_ = 0.0;
    int stepsPerDecade_ = 0;  ///< 0: linear
    int digits_ = 0;
};

}  // namespace ravnoves
