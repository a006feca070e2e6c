#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QSlider;

namespace ravnoves {

class DecimalSpinBox;
class SceneModel;
class TroubleLine;

/// A slider with a spin box for one value: drag, arrow keys (one step), page keys (a larger step),
/// wheel; a double click on the slider goes to the box to type. Where the row is too narrow for a
/// slider that can be used it stands below label and box. What is refused is said below, until
/// another value is given.
class ValueSlider : public QWidget {
    Q_OBJECT

  public:
    /// @param label  with & for the mnemonic
    ValueSlider(const QString& label, double min, double max, double step, double pageStep,
                int decimals, const QString& unit, QWidget* parent = nullptr);
    ~ValueSlider() override;

    double value() const { return value_; }
    void setValue(double value);  ///< no signal
    void setRange(double min, double max);
    void setHint(const QString& hint);
    void setTickInterval(double interval);
    /// The slider goes by the value's logarithm: a step is one part of a decade. Values are rounded
    /// to `digits` significant digits when the slider is moved. The range must be positive.
    void setLogarithmic(int stepsPerDecade, int digits);
    QSlider* slider() const { return slider_; }
    QDoubleSpinBox* box() const;
    /// Says why the value that the user gave is refused; with nothing, that this is over.
    void refuse(const QString& why);
    QString trouble() const;
    /// The number with all its digits where the box shows fewer; else empty. The tip says it.
    QString wholeText() const;
    /// A value that stands for none of the case is pale; typed as it is shown, it is passed on.
    void setGiven(bool isGiven);
    /// What this model refuses of the values passed on is said below.
    void setModel(SceneModel* model);
    /// Gives the label this width, so that the sliders of a column stand in line.
    void setLabelWidth(int width);
    QSize sizeHint() const override;  ///< in one row
    QSize minimumSizeHint() const override;

  Q_SIGNALS:
    /// The user moved it.
    void valueEdited(double value);
    void pressed();
    void released();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void arrange();
    int widthInOneRow() const;
    void sayOutOfRange(const QString& typed);
    void edit(double value);
    /// Of a number in the box.
    double valueOf(double shown) const;
    /// Decimals with which the box shows a number: more where it was given with more.
    int decimalsOf(double shown) const;
    void showRange();
    void inkBox();
    int tickOf(double value) const;
    double valueAt(int tick) const;

    QGridLayout* grid_;
    QLabel* label_;
    QSlider* slider_;
    bool gripped_ = false;  ///< the last press was on the handle
    DecimalSpinBox* box_;
    TroubleLine* trouble_;
    QString unit_;
    bool folded_ = false;
    bool isPassing_ = false;
    bool isGiven_ = true;
    bool isTyped_ = false;    ///< in the box, since it was finished last
    double typedOver_ = 0.0;  ///< the value before that
    double factor_ = 1.0;     ///< numbers in the box per number of the value
    int decimals_ = 0;        ///< of the box, where the slider moves it
    double min_;
    double max_;
    double step_;
    double value_ = 0.0;
    int stepsPerDecade_ = 0;  ///< 0: linear
    int digits_ = 0;
};

}  // namespace ravnoves
